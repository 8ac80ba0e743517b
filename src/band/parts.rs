//! Which parts a frame consists of.

use embedded_graphics_core::{geometry::Point, primitives::Rectangle};

/// The bands of an area, downwards: all of the same height but the last, which may have fewer rows.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Parts {
    /// What is left.
    area: Rectangle,
    rows: u32,
}

impl Parts {
    pub(super) fn new(area: Rectangle, rows: u32) -> Self {
        Self { area, rows }
    }
}

impl Iterator for Parts {
    type Item = Rectangle;

    fn next(&mut self) -> Option<Rectangle> {
        let Rectangle { top_left, size } = &mut self.area;
        let mut part = *size;
        part.height = part.height.min(self.rows);
        if part.width == 0 || part.height == 0 {
            return None;
        }
        let start = *top_left;
        size.height -= part.height;
        *top_left = Point::new(start.x, start.y.saturating_add_unsigned(part.height));
        Some(Rectangle::new(start, part))
    }
}
