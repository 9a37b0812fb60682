//! How names are set: one style for each kind of thing that is named.

use crate::frame::LabelStyle;

/// A vector of the world, at its tip: it moves.
pub(super) const VECTOR: LabelStyle = LabelStyle { size: 26.0, gap: 10.0, priority: 10, moves: true, ..FLOOR };
/// One that stays.
pub(super) const FIXED_VECTOR: LabelStyle = LabelStyle { priority: 11, moves: false, ..VECTOR };
/// M, beside the ball at its tip.
pub(super) const TIP: LabelStyle = LabelStyle { gap: 14.0, priority: 9, ..VECTOR };
/// The number of an axis, as it turns with the body.
pub(super) const NUMBER: LabelStyle = LabelStyle { size: 24.0, gap: 5.0, priority: 4, moves: true, ..FLOOR };
/// An end of it that has a name, off the arrow that may stand there.
pub(super) const END: LabelStyle = LabelStyle { size: 22.0, gap: 12.0, ..NUMBER };
/// The number of an axis that stands still.
pub(super) const AXIS: LabelStyle = LabelStyle { moves: false, ..NUMBER };
/// The moment of an axis that stands still.
pub(super) const MOMENT: LabelStyle = LabelStyle { priority: 5, ..FLOOR };
/// A path on the sphere.
pub(super) const PATH: LabelStyle = LabelStyle { gap: 12.0, priority: 4, leads: true, ..FLOOR };
/// A border on the sphere.
pub(super) const BORDER: LabelStyle = LabelStyle { gap: 8.0, priority: 3, leads: true, is_anywhere: true, ..FLOOR };
/// A round surface, at its outline.
pub(super) const SURFACE: LabelStyle = LabelStyle { gap: 14.0, priority: 2, ..FLOOR };
/// What lies on the floor.
pub(super) const FLOOR: LabelStyle =
    LabelStyle { size: 19.0, gap: 6.0, priority: 1, moves: false, leads: false, is_anywhere: false };
/// A magnifying glass, below it.
pub(super) const GLASS: LabelStyle = LabelStyle { gap: 11.0, priority: 6, ..FLOOR };
/// What rolls over it.
pub(super) const ROLLING: LabelStyle = LabelStyle { moves: true, ..FLOOR };
