//! Tells cargo what it cannot know: the folder of scenes is read while compiling, and a file that is new there counts.

fn main() {
    println!("cargo:rerun-if-changed=assets/scenes");
}
