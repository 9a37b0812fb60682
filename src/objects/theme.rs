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
    /// The border between the two kinds of motion.
    pub separatrix: Color,
    /// The body's shadow.
    pub shadow: Color,
}

impl Palette {
    /// The colours of a theme.
    #[must_use]
    pub fn new(theme: Theme) -> Self {
        let hex = Color::hex;
        match theme {
            Theme::Dark => Self {
                background: hex(0x001b_1f26),
                ink: hex(0x00e6_e8eb),
                momentum: hex(0x00f0_e442),
                omega: hex(0x00e0_88b8),
                axes: [hex(0x0056_b4e9), hex(0x00f0_a030), hex(0x0020_c097)],
                faces: [
                    [hex(0x0074_bfe8), hex(0x00ee_ac57), hex(0x007f_cfb4)],
                    [hex(0x0033_7fb3), hex(0x00a8_5a1c), hex(0x0030_8069)],
                ],
                sphere: hex(0x0096_b4f0).alpha(0.11),
                ellipsoid: hex(0x00f0_8f6a).alpha(0.15),
                polhode: hex(0x00ff_f3a0),
                separatrix: hex(0x00e6_e8eb),
                shadow: hex(0x0000_0000).alpha(0.4),
            },
            Theme::Light => Self {
                background: hex(0x00fb_faf7),
                ink: hex(0x0020_242a),
                momentum: hex(0x0020_242a),
                omega: hex(0x00b0_3a78),
                axes: [hex(0x0000_72b2), hex(0x00c4_6200), hex(0x0000_7f5f)],
                faces: [
                    [hex(0x0086_cbf0), hex(0x00f4_b766), hex(0x0093_d8c0)],
                    [hex(0x0045_8fc0), hex(0x00b9_6720), hex(0x003a_8f78)],
                ],
                sphere: hex(0x005f_86c8).alpha(0.09),
                ellipsoid: hex(0x00dd_6a48).alpha(0.11),
                polhode: hex(0x0020_242a),
                separatrix: hex(0x0045_4b55),
                shadow: hex(0x0020_242a).alpha(0.2),
            },
        }
    }
}
