//! Tells cargo what it cannot know: the folder of scenes is read while compiling, and a file that is new there counts. On Windows
//! the program is linked with its manifest.

use std::path::Path;
use std::process::Command;

/// What Windows reads of the program before it runs.
const MANIFEST: &str = "assets/desktop/dzhanibekov.exe.manifest";

fn main() {
    println!("cargo:rerun-if-changed=assets/scenes");
    let target = |key: &str| std::env::var(format!("CARGO_CFG_TARGET_{key}")).unwrap_or_default();
    if target("OS") != "windows" {
        return;
    }
    println!("cargo:rerun-if-changed={MANIFEST}");
    // Where the linker cannot be given it, the program is the same but for a console beside its window.
    let linked = match target("ENV").as_str() {
        "msvc" => with_msvc(),
        _ => with_gnu(&target("ARCH")),
    };
    match linked {
        Ok(arguments) => {
            for argument in arguments {
                println!("cargo:rustc-link-arg-bin=dzhanibekov={argument}");
            }
        }
        Err(why) => println!("cargo:warning=without a manifest: {why}"),
    }
}

fn with_msvc() -> Result<Vec<String>, String> {
    let path = Path::new(MANIFEST).canonicalize().map_err(|error| format!("{MANIFEST}: {error}"))?;
    Ok(vec!["/MANIFEST:EMBED".to_owned(), format!("/MANIFESTINPUT:{}", path.display())])
}

/// By windres, which stands beside this linker.
fn with_gnu(architecture: &str) -> Result<Vec<String>, String> {
    let folder = std::env::var("OUT_DIR").map_err(|error| format!("OUT_DIR: {error}"))?;
    let (script, object) = (format!("{folder}/manifest.rc"), format!("{folder}/manifest.o"));
    // A program's first resource of type 24 is its manifest.
    std::fs::write(&script, format!("1 24 \"{MANIFEST}\"\n")).map_err(|error| format!("{script}: {error}"))?;
    let mut why = String::new();
    for windres in [format!("{architecture}-w64-mingw32-windres"), "windres".to_owned()] {
        match Command::new(&windres).args([&script, "-o", &object]).status() {
            Ok(status) if status.success() => return Ok(vec![object]),
            Ok(status) => why = format!("{windres}: {status}"),
            Err(error) => why = format!("{windres}: {error}"),
        }
    }
    Err(why)
}
