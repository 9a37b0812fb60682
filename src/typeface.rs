//! The typeface of pictures and panels: of medium weight, so that it is read from the last row.

/// Roboto Medium (Apache License 2.0, Google).
pub static SANS: &[u8] = include_bytes!("../assets/fonts/Roboto-Medium.ttf");

/// Hack Regular (MIT License, and that of Bitstream Vera): all digits are alike in width, and it has the arrows that Roboto has not.
pub static MONO: &[u8] = include_bytes!("../assets/fonts/Hack-Regular.ttf");
