//! How figures tell one method from another: the window, pictures and the report read it from the method's row.

/// A colour, as `0xRRGGBB`, on either ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hue {
    /// On a dark ground.
    pub on_dark: u32,
    /// The same hue on a light one, darker.
    pub on_light: u32,
}

/// The pattern of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// Unbroken.
    Solid,
    /// Short dashes.
    Short,
    /// Long dashes.
    Long,
    /// Dots.
    Dotted,
}

/// The form of a mark. None is the disc, which is the scene's own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// A circle.
    Ring,
    /// A square on its corner.
    Diamond,
    /// A square.
    Square,
    /// A triangle.
    Triangle,
    /// A triangle on its tip.
    TriangleDown,
    /// An empty square.
    OpenSquare,
    /// An empty square on its corner.
    OpenDiamond,
    /// An empty triangle.
    OpenTriangle,
    /// An empty triangle on its tip.
    OpenTriangleDown,
    /// A star of four points.
    Star,
    /// Two triangles tip to tip, one above the other.
    Hourglass,
    /// Two triangles tip to tip, side by side.
    Bow,
    /// Two bars side by side.
    Bars,
}
