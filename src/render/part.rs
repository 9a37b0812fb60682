//! A part of a picture, drawn by itself: large pictures are drawn band by band, so that memory does not grow with them.

use glam::Vec2;

/// Up to so many pixels of a picture are drawn at once: memory does not grow with the picture, and fresh memory costs time; but so does
/// each band, in which all lines are placed anew.
const BAND: u64 = 1280 * 720;

/// How many rows of a picture of this size are drawn at once. The same for all that is no window: where a pixel lies in what is
/// drawn at once may turn the last bit of its colour, and a frame of a film is to be the picture of its moment.
pub(super) fn rows_of_band([width, height]: [u32; 2]) -> u32 {
    let bands = (u64::from(width) * u64::from(height)).div_ceil(BAND);
    height.div_ceil(bands.clamp(1, u64::from(height.max(1))) as u32)
}

/// A rectangle of whole pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Part {
    /// Its upper left corner.
    pub(super) low: [u32; 2],
    /// Its width and height.
    pub(super) size: [u32; 2],
}

impl Part {
    /// The upper left corner.
    pub(super) fn corner(&self) -> Vec2 {
        Vec2::new(self.low[0] as f32, self.low[1] as f32)
    }

    /// Width and height.
    pub(super) fn extent(&self) -> Vec2 {
        Vec2::new(self.size[0] as f32, self.size[1] as f32)
    }

    /// Whether it has no pixels.
    pub(super) fn is_empty(&self) -> bool {
        self.size.contains(&0)
    }

    /// The pixels of this part whose middles lie between two corners.
    pub(super) fn within(&self, low: Vec2, high: Vec2) -> Self {
        let side = |axis: usize| {
            let from = self.low[axis];
            let to = from + self.size[axis];
            let pixel = |at: f32| ((at - 0.5).ceil().max(0.0) as u32).clamp(from, to);
            (pixel(low[axis]), pixel(high[axis]))
        };
        let [(left, right), (top, bottom)] = [side(0), side(1)];
        Self { low: [left, top], size: [right.saturating_sub(left), bottom.saturating_sub(top)] }
    }
}

#[cfg(test)]
mod tests {
    use super::{Part, rows_of_band};
    use glam::Vec2;

    #[test]
    fn neighbours_share_no_pixel_and_leave_none_out() {
        let band = Part { low: [0, 10], size: [7, 5] };
        // Two panes side by side in an odd width: the middle pixel's middle lies on the border.
        let left = band.within(Vec2::ZERO, Vec2::new(3.5, 20.0));
        let right = band.within(Vec2::new(3.5, 0.0), Vec2::new(7.0, 20.0));
        assert_eq!(left, Part { low: [0, 10], size: [3, 5] });
        assert_eq!(right, Part { low: [3, 10], size: [4, 5] });
        assert!(band.within(Vec2::ZERO, Vec2::new(7.0, 9.0)).is_empty());
        assert_eq!(band.within(Vec2::splat(-9.0), Vec2::splat(99.0)), band);
    }
    #[test]
    fn bands_are_of_about_one_size_and_hold_the_whole_picture() {
        assert_eq!(rows_of_band([640, 360]), 360);
        assert_eq!(rows_of_band([1280, 720]), 720);
        // Two and three, the least number that is enough.
        assert_eq!(rows_of_band([1280, 721]), 361);
        assert_eq!(rows_of_band([1920, 1080]), 360);
        // Never less than a row, however wide.
        assert_eq!(rows_of_band([8192, 1]), 1);
        assert_eq!(rows_of_band([1 << 23, 3]), 1);
    }
}
