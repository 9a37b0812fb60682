# Print an optspec for argparse to handle cmd's options that are independent of any subcommand.
function __fish_dzhanibekov_global_optspecs
    string join \n box= mass= moments= inertia= omega= axis= tilt= rate= method= step= compare= set= view= show= hide= theme= labels= font-scale= azimuth= elevation= distance= world-camera= body-camera= size= adapter= quiet h/help V/version
end

function __fish_dzhanibekov_needs_command
    # Figure out if the current invocation already has a command.
    set -l cmd (commandline -opc)
    set -e cmd[1]
    argparse -s (__fish_dzhanibekov_global_optspecs) -- $cmd 2>/dev/null
    or return
    if set -q argv[1]
        # Also print the command, so this can be used to figure out what it is.
        echo $argv[1]
        return 1
    end
    return 0
end

function __fish_dzhanibekov_using_subcommand
    set -l cmd (__fish_dzhanibekov_needs_command)
    test -z "$cmd"
    and return 1
    contains -- $cmd[1] $argv
end

complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l box -d 'Edges of a solid box along the body\'s axes (m)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l mass -d 'Mass of the box (kg)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l moments -d 'Principal moments in the order of the body\'s axes (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l inertia -d 'Inertia tensor in the body frame (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l omega -d 'Angular velocity at the start in the body frame (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l axis -d 'Principal axis to spin about: 1 has the smallest moment, 3 the largest' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l tilt -d 'Tilt of the spin from that axis towards the next (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l rate -d 'Speed of the spin (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l method -d 'Method that follows the motion (`dzhanibekov methods` lists them)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l step -d 'Step of the method (s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l compare -d 'Methods run beside it from the same start; \'\' for none' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l set -d 'Any key of a scene file (`dzhanibekov keys` lists them), the value as in TOML: spin.attitude=[1,0,0,0]' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l view -d 'Which spaces to show' -r -f -a "both\t''
world\t''
body\t''"
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l show -d 'Objects to show besides the default ones (`dzhanibekov objects` lists them)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l hide -d 'Objects to hide' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l theme -d 'Colours for a dark hall, or for bright rooms and print' -r -f -a "dark\t''
light\t''"
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l labels -d 'Names beside things' -r -f -a "on\t''
off\t''"
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l font-scale -d 'Factor on the size of text and the width of lines' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l azimuth -d 'Camera\'s direction round the vertical (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l elevation -d 'Camera\'s height above the horizon (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l distance -d 'Camera\'s distance, a factor on the one that frames everything' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l world-camera -d 'Camera of the world alone: azimuth, elevation, distance, and the point looked at' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l body-camera -d 'Camera of momentum space alone, likewise' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l size -d 'Size of the window in pixels' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l adapter -d 'Name (or a part of it) of the graphics adapter to draw with' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -l quiet -d 'Say nothing but errors'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -s h -l help -d 'Print help (see more with \'--help\')'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -s V -l version -d 'Print version'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "shot" -d 'Draw one picture to a file, with no window and no display'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "record" -d 'Record moving pictures: numbered PNG files, GIF, animated PNG, MP4, WebM, QuickTime, Matroska, or a stream'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "trace" -d 'Write the motion as numbers (CSV)'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "report" -d 'Measure every method here: speed against error, as a page, tables and plots'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "scenes" -d 'List the scenes built in'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "methods" -d 'List the methods'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "keys" -d 'List the keys of a scene file, which --set takes'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "objects" -d 'List the things that can be drawn, which --show and --hide take'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "adapters" -d 'List the graphics adapters'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "man" -d 'Write the man page to standard output: dzhanibekov man | man -l -'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "completions" -d 'Write completions for a shell to standard output'
complete -c dzhanibekov -n "__fish_dzhanibekov_needs_command" -a "help" -d 'Print this message or the help of the given subcommand(s)'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l box -d 'Edges of a solid box along the body\'s axes (m)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l mass -d 'Mass of the box (kg)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l moments -d 'Principal moments in the order of the body\'s axes (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l inertia -d 'Inertia tensor in the body frame (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l omega -d 'Angular velocity at the start in the body frame (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l axis -d 'Principal axis to spin about: 1 has the smallest moment, 3 the largest' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l tilt -d 'Tilt of the spin from that axis towards the next (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l rate -d 'Speed of the spin (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l method -d 'Method that follows the motion (`dzhanibekov methods` lists them)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l step -d 'Step of the method (s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l compare -d 'Methods run beside it from the same start; \'\' for none' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l set -d 'Any key of a scene file (`dzhanibekov keys` lists them), the value as in TOML: spin.attitude=[1,0,0,0]' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l view -d 'Which spaces to show' -r -f -a "both\t''
world\t''
body\t''"
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l show -d 'Objects to show besides the default ones (`dzhanibekov objects` lists them)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l hide -d 'Objects to hide' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l theme -d 'Colours for a dark hall, or for bright rooms and print' -r -f -a "dark\t''
light\t''"
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l labels -d 'Names beside things' -r -f -a "on\t''
off\t''"
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l font-scale -d 'Factor on the size of text and the width of lines' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l azimuth -d 'Camera\'s direction round the vertical (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l elevation -d 'Camera\'s height above the horizon (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l distance -d 'Camera\'s distance, a factor on the one that frames everything' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l world-camera -d 'Camera of the world alone: azimuth, elevation, distance, and the point looked at' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l body-camera -d 'Camera of momentum space alone, likewise' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l time -d 'Simulated time shown (s), 0 where left out; of a recording, its first frame\'s' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l size -d 'Size in pixels (1280x720 where nothing is said); with --width or --height its aspect alone counts' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l width -d 'Width on paper (mm, cm, in, pt), which sets type in points of paper: 8 pt for captions; or in pixels (px)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l height -d 'Height likewise, where the aspect of --size is not the one wanted' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l dpi -d 'Pixels an inch of paper (300 where only a width is said), with which PNG files are marked' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l adapter -d 'Name (or a part of it) of the graphics adapter to draw with' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -s o -l output -d 'File to write, or - for standard output' -r -F
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l transparent -d 'No background: transparent where nothing is drawn'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l quiet -d 'Say nothing but errors'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -l panel -d 'With the window\'s panel in the picture'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand shot" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l box -d 'Edges of a solid box along the body\'s axes (m)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l mass -d 'Mass of the box (kg)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l moments -d 'Principal moments in the order of the body\'s axes (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l inertia -d 'Inertia tensor in the body frame (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l omega -d 'Angular velocity at the start in the body frame (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l axis -d 'Principal axis to spin about: 1 has the smallest moment, 3 the largest' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l tilt -d 'Tilt of the spin from that axis towards the next (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l rate -d 'Speed of the spin (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l method -d 'Method that follows the motion (`dzhanibekov methods` lists them)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l step -d 'Step of the method (s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l compare -d 'Methods run beside it from the same start; \'\' for none' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l set -d 'Any key of a scene file (`dzhanibekov keys` lists them), the value as in TOML: spin.attitude=[1,0,0,0]' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l view -d 'Which spaces to show' -r -f -a "both\t''
world\t''
body\t''"
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l show -d 'Objects to show besides the default ones (`dzhanibekov objects` lists them)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l hide -d 'Objects to hide' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l theme -d 'Colours for a dark hall, or for bright rooms and print' -r -f -a "dark\t''
light\t''"
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l labels -d 'Names beside things' -r -f -a "on\t''
off\t''"
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l font-scale -d 'Factor on the size of text and the width of lines' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l azimuth -d 'Camera\'s direction round the vertical (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l elevation -d 'Camera\'s height above the horizon (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l distance -d 'Camera\'s distance, a factor on the one that frames everything' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l world-camera -d 'Camera of the world alone: azimuth, elevation, distance, and the point looked at' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l body-camera -d 'Camera of momentum space alone, likewise' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l time -d 'Simulated time shown (s), 0 where left out; of a recording, its first frame\'s' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l size -d 'Size in pixels (1280x720 where nothing is said); with --width or --height its aspect alone counts' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l width -d 'Width on paper (mm, cm, in, pt), which sets type in points of paper: 8 pt for captions; or in pixels (px)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l height -d 'Height likewise, where the aspect of --size is not the one wanted' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l dpi -d 'Pixels an inch of paper (300 where only a width is said), with which PNG files are marked' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l adapter -d 'Name (or a part of it) of the graphics adapter to draw with' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -s o -l output -d 'frame-{:05}.png (numbered), FILE.gif, FILE.apng, through ffmpeg FILE.mp4, .webm, .mov or .mkv, or - for YUV4MPEG2 on standard output' -r -F
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l fps -d 'Frames a second, whole, decimal or a ratio such as 30000/1001' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l duration -d 'Length (s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l frames -d 'Only frames A to B − 1 of the recording, for several machines' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l transparent -d 'No background: transparent where nothing is drawn'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l quiet -d 'Say nothing but errors'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l keep -d 'Leave numbered frames alone that are already whole on disk'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -l panel -d 'Known only to be refused in words of its own'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand record" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l box -d 'Edges of a solid box along the body\'s axes (m)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l mass -d 'Mass of the box (kg)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l moments -d 'Principal moments in the order of the body\'s axes (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l inertia -d 'Inertia tensor in the body frame (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l omega -d 'Angular velocity at the start in the body frame (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l axis -d 'Principal axis to spin about: 1 has the smallest moment, 3 the largest' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l tilt -d 'Tilt of the spin from that axis towards the next (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l rate -d 'Speed of the spin (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l method -d 'Method that follows the motion (`dzhanibekov methods` lists them)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l step -d 'Step of the method (s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l compare -d 'Methods run beside it from the same start; \'\' for none' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l set -d 'Any key of a scene file (`dzhanibekov keys` lists them), the value as in TOML: spin.attitude=[1,0,0,0]' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -s o -l output -d 'File to write, or - for standard output' -r -F
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l at -d 'Times wanted (s), in any order; or a file of them, or - for standard input' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l every -d 'Time between rows (s); 0.01 where left out' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l duration -d 'Time of the last row (s); 10 where left out' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -l quiet -d 'Say nothing but errors'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand trace" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l box -d 'Edges of a solid box along the body\'s axes (m)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l mass -d 'Mass of the box (kg)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l moments -d 'Principal moments in the order of the body\'s axes (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l inertia -d 'Inertia tensor in the body frame (kg m²)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l omega -d 'Angular velocity at the start in the body frame (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l axis -d 'Principal axis to spin about: 1 has the smallest moment, 3 the largest' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l tilt -d 'Tilt of the spin from that axis towards the next (degrees)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l rate -d 'Speed of the spin (rad/s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l method -d 'Method that follows the motion (`dzhanibekov methods` lists them)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l step -d 'Step of the method (s)' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l compare -d 'Methods run beside it from the same start; \'\' for none' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l set -d 'Any key of a scene file (`dzhanibekov keys` lists them), the value as in TOML: spin.attitude=[1,0,0,0]' -r
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -s o -l output -d 'Folder for report.html, report.json, report.csv and the plots; `report` where neither it nor --json is given' -r -F
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l json -d 'Write the numbers alone to a file, or - for standard output' -r -F
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l peers -d 'Points measured with other programs (JSON), drawn in the same plots' -r -F
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l quick -d 'Two cases and less of everything, in under twenty seconds'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -l quiet -d 'Say nothing but errors'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand report" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand scenes" -l json -d 'Write JSON'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand scenes" -l quiet -d 'Say nothing but errors: nothing else is said besides the list'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand scenes" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand methods" -l json -d 'Write JSON'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand methods" -l quiet -d 'Say nothing but errors: nothing else is said besides the list'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand methods" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand keys" -l json -d 'Write JSON'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand keys" -l quiet -d 'Say nothing but errors: nothing else is said besides the list'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand keys" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand objects" -l json -d 'Write JSON'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand objects" -l quiet -d 'Say nothing but errors: nothing else is said besides the list'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand objects" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand adapters" -l json -d 'Write JSON'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand adapters" -l quiet -d 'Say nothing but errors: nothing else is said besides the list'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand adapters" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand man" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand completions" -s h -l help -d 'Print help'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "shot" -d 'Draw one picture to a file, with no window and no display'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "record" -d 'Record moving pictures: numbered PNG files, GIF, animated PNG, MP4, WebM, QuickTime, Matroska, or a stream'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "trace" -d 'Write the motion as numbers (CSV)'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "report" -d 'Measure every method here: speed against error, as a page, tables and plots'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "scenes" -d 'List the scenes built in'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "methods" -d 'List the methods'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "keys" -d 'List the keys of a scene file, which --set takes'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "objects" -d 'List the things that can be drawn, which --show and --hide take'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "adapters" -d 'List the graphics adapters'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "man" -d 'Write the man page to standard output: dzhanibekov man | man -l -'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "completions" -d 'Write completions for a shell to standard output'
complete -c dzhanibekov -n "__fish_dzhanibekov_using_subcommand help; and not __fish_seen_subcommand_from shot record trace report scenes methods keys objects adapters man completions help" -f -a "help" -d 'Print this message or the help of the given subcommand(s)'
