//! The typeface of pictures and panels: of medium weight, so that it is read from the last row.

/// Roboto Medium (Apache License 2.0, Google).
pub static SANS: &[u8] = include_bytes!("../assets/fonts/Roboto-Medium.ttf");
