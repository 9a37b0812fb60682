//! Colours, one set a theme, all from the Okabe–Ito palette or near it: they stay apart for every kind of colour
//! vision, and in grey by their lightness.

use crate::frame::Color;
use crate::scene::Theme;

/// What has which colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Palette {
    /// Behind everything.
    pub background: Color,
    /// Text and quiet lines.
    pub ink: Color,
    /// The angular momentum, fixed in the world (L) and moving in the body (M).
    pub momentum: Color,
    /// The angular velocity.
    pub omega: Color,
    /// The principal axes 1, 2, 3.
    pub axes: [Color; 3],
    /// The faces of the body towards +1, +2, +3 and −1, −2, −3.
    pub faces: [[Color; 3]; 2],
    /// The momentum sphere.
    pub sphere: Color,
    /// The energy ellipsoid.
    pub ellipsoid: Color,
    /// The path of M.
    pub polhode: Color,
}

impl Palette {
    /// The colours of a theme.
    #[must_use]
    pub fn new(theme: Theme) -> Self {
        let hex = Color::hex;
        match theme {
            Theme::Dark => Self {
                background: hex(0x0014_171c),
                ink: hex(0x00e6_e8eb),
                momentum: hex(0x00f0_e442),
                omega: hex(0x00cc_79a7),
                axes: [hex(0x0056_b4e9), hex(0x00e6_9f00), hex(0x0000_b386)],
                faces: [
                    [hex(0x0056_b4e9), hex(0x00e8_9a3c), hex(0x00c9_d3d8)],
                    [hex(0x001f_5f8f), hex(0x009a_5214), hex(0x005c_6a74)],
                ],
                sphere: hex(0x0056_b4e9).alpha(0.16),
                ellipsoid: hex(0x00e0_6a2c).alpha(0.24),
                polhode: hex(0x00ff_f3a0),
            },
            Theme::Light => Self {
                background: hex(0x00fb_faf7),
                ink: hex(0x0020_242a),
                momentum: hex(0x0020_242a),
                omega: hex(0x00b0_3a78),
                axes: [hex(0x0000_72b2), hex(0x00d5_5e00), hex(0x0000_7f5f)],
                faces: [
                    [hex(0x006f_c1ee), hex(0x00f0_a850), hex(0x00e4_e9ec)],
                    [hex(0x002a_6fa3), hex(0x00b0_6018), hex(0x008a_979f)],
                ],
                sphere: hex(0x003a_9bd9).alpha(0.14),
                ellipsoid: hex(0x00e0_6a2c).alpha(0.22),
                polhode: hex(0x0020_242a),
            },
        }
    }
}
