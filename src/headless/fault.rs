//! A fault that no machine has on demand, for the scripts that try what a lost device does.

use crate::render::Gpu;

/// How many frames are drawn before the device is destroyed; 0 is as soon as it is open. Unset but in those scripts.
const VARIABLE: &str = "DZHANIBEKOV_LOSE_DEVICE_AFTER";

/// Destroys the device where the environment wants it lost after this many frames.
pub(super) fn after(frames: u64, gpu: &Gpu) {
    if std::env::var(VARIABLE).is_ok_and(|wanted| wanted.parse() == Ok(frames)) {
        gpu.device.destroy();
    }
}
