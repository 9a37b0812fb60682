//! Curves drawn with no more points than the eye needs.

use glam::Vec3;

/// Leaves out points as long as the straight lines between those that are kept pass every one within `tolerance`. The
/// ends are kept, so a closed curve stays closed.
pub(super) fn simplified(points: &[Vec3], tolerance: f32) -> Vec<Vec3> {
    let Some((&first, &last)) = points.first().zip(points.last()) else { return vec![] };
    let mut kept = vec![first];
    let mut start = 0;
    for end in 2..points.len() {
        if points[start + 1..end].iter().any(|&between| away(between, points[start], points[end]) > tolerance) {
            start = end - 1;
            kept.push(points[start]);
        }
    }
    kept.push(last);
    kept
}

/// Distance of a point from the straight line through two others (from their common place where they coincide).
fn away(point: Vec3, from: Vec3, to: Vec3) -> f32 {
    let along = (to - from).normalize_or_zero();
    (point - from).reject_from_normalized(along).length()
}
