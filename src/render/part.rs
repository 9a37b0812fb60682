//! A part of a picture, drawn by itself: large pictures are drawn band by band, so that memory does not grow with them.

use glam::Vec2;

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
    use super::Part;
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
}
