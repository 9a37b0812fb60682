//! Films that an installed `ffmpeg` writes: each ending, and what is encoded into it.

/// A kind of file that holds a film.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Container {
    Mp4,
    WebM,
    QuickTime,
    Matroska,
}

/// All of them.
pub(super) const CONTAINERS: [Container; 4] =
    [Container::Mp4, Container::WebM, Container::QuickTime, Container::Matroska];

/// A codec, and what encodes it.
#[derive(Debug)]
pub(super) struct Codec {
    /// What it is called.
    pub(super) name: &'static str,
    /// Encoders, the best first: each with what makes a film that looks as it was drawn, where it has a setting for that; the
    /// others are given plenty of bits.
    pub(super) encoders: &'static [(&'static str, &'static [&'static str])],
    /// How its pixels are laid out, in ffmpeg's word.
    pub(super) pixels: &'static str,
    /// Whether both sides of the picture must be even.
    pub(super) is_even: bool,
}

const H264: Codec = Codec {
    name: "H.264",
    encoders: &[
        ("libx264", &["-preset", "veryfast", "-crf", "16"]),
        ("libopenh264", &[]),
        ("h264_videotoolbox", &[]),
        ("h264_nvenc", &["-rc", "vbr", "-cq", "16"]),
        ("h264_mf", &[]),
        ("h264_v4l2m2m", &[]),
    ],
    pixels: "yuv420p",
    is_even: true,
};
const VP9: Codec = Codec {
    name: "VP9",
    encoders: &[
        ("libvpx-vp9", &["-crf", "18", "-b:v", "0", "-deadline", "good", "-cpu-used", "5", "-row-mt", "1"]),
        ("libsvtav1", &["-crf", "22", "-preset", "8"]),
        ("libaom-av1", &["-crf", "20", "-b:v", "0", "-cpu-used", "6", "-row-mt", "1"]),
    ],
    pixels: "yuv420p",
    is_even: false,
};
const VP9_CLEAR: Codec = Codec {
    name: "VP9 with transparency",
    // Frames that are never shown are not for pictures with opacity.
    encoders: &[(
        "libvpx-vp9",
        &["-crf", "18", "-b:v", "0", "-deadline", "good", "-cpu-used", "5", "-row-mt", "1", "-auto-alt-ref", "0"],
    )],
    pixels: "yuva420p",
    is_even: false,
};
const PRORES: Codec = Codec {
    name: "ProRes 4444",
    encoders: &[("prores_ks", &["-profile:v", "4444", "-vendor", "apl0"])],
    pixels: "yuv444p10le",
    is_even: false,
};
const PRORES_CLEAR: Codec = Codec { pixels: "yuva444p10le", ..PRORES };
const FFV1_CLEAR: Codec = Codec {
    name: "FFV1",
    encoders: &[("ffv1", &["-level", "3", "-g", "1", "-slices", "4"])],
    pixels: "bgra",
    is_even: false,
};

impl Container {
    /// The one whose ending a file has.
    pub(super) fn of(ending: &str) -> Option<Self> {
        CONTAINERS.into_iter().find(|container| container.ending() == ending)
    }

    /// Of its files, without the point.
    pub(super) fn ending(self) -> &'static str {
        match self {
            Self::Mp4 => "mp4",
            Self::WebM => "webm",
            Self::QuickTime => "mov",
            Self::Matroska => "mkv",
        }
    }

    /// What is encoded into it; none where it cannot hold transparency and that is wanted.
    pub(super) fn codec(self, is_transparent: bool) -> Option<&'static Codec> {
        Some(match (self, is_transparent) {
            (Self::Mp4, true) => return None,
            (Self::Mp4 | Self::Matroska, false) => &H264,
            (Self::WebM, false) => &VP9,
            (Self::WebM, true) => &VP9_CLEAR,
            (Self::QuickTime, false) => &PRORES,
            (Self::QuickTime, true) => &PRORES_CLEAR,
            (Self::Matroska, true) => &FFV1_CLEAR,
        })
    }

    /// What ffmpeg is told of the file itself.
    pub(super) fn muxer(self) -> &'static [&'static str] {
        match self {
            Self::Mp4 => &["-movflags", "+faststart", "-f", "mp4"],
            Self::QuickTime => &["-movflags", "+faststart", "-f", "mov"],
            Self::WebM => &["-f", "webm"],
            Self::Matroska => &["-f", "matroska"],
        }
    }
}

/// These endings as words, `.mp4, .webm and .mov`.
pub(super) fn list(endings: &[&str], and: &str) -> String {
    let dotted: Vec<String> = endings.iter().map(|ending| format!(".{ending}")).collect();
    match &*dotted {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} {and} {last}", first.join(", ")),
    }
}
