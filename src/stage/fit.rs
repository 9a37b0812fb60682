//! How large panels and picture are on a screen.

use crate::render::point_size;

/// Smallest size of a window (points): it still holds the panels.
pub const SMALLEST: [f32; 2] = [640.0, 400.0];

/// Smaller side of a page (points) that still holds what is used most.
const SMALLEST_PAGE: f32 = 320.0;

/// How much larger than usual the panels are in a window of this size (points): they grow with the window, as what is
/// projected does, by the user's own factor too, and never past what leaves room for them. A presenter's words are as large a
/// part of any window.
#[must_use]
pub fn zoom(width: f32, height: f32, own: f32, presenting: bool) -> f32 {
    let power = if presenting { 1.0 } else { 0.7 };
    let grown = (width / 1280.0).min(height / 720.0).max(1.0).powf(power) * own;
    grown.min(width / SMALLEST[0]).min(height / SMALLEST[1]).max(0.4)
}

/// Pixels a point in a picture of this size (pixels), where the panels have `panels` of them: in a small picture the names
/// are smaller than the panels' text, so that they do not cover it.
pub(super) fn picture_point(panels: f32, (width, height): (u32, u32)) -> f32 {
    const MOST: f32 = 2.0;
    const LEAST: f32 = 0.6;
    panels.min(MOST * point_size([width, height])).max(LEAST * panels)
}

/// Where the picture lies in a window of this size (pixels), from what the panels left of it (points): its corner and
/// its size, which is 0 where there is no room.
pub(super) fn place(picture: egui::Rect, pixels_per_point: f32, window: (u32, u32)) -> ((u32, u32), (u32, u32)) {
    let pixel = |points: f32, most: u32| ((points * pixels_per_point).round().max(0.0) as u32).min(most);
    let corner = (pixel(picture.min.x, window.0), pixel(picture.min.y, window.1));
    let far = (pixel(picture.max.x, window.0), pixel(picture.max.y, window.1));
    (corner, (far.0.saturating_sub(corner.0), far.1.saturating_sub(corner.1)))
}

/// The same on a page, which may be smaller than any window: a screen in the hand has points as large as its own.
#[must_use]
pub fn zoom_on_page(width: f32, height: f32, own: f32, presenting: bool) -> f32 {
    if width >= SMALLEST[0] && height >= SMALLEST[1] {
        return zoom(width, height, own, presenting);
    }
    own.min(width.min(height) / SMALLEST_PAGE).max(0.4)
}
