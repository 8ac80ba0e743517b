//! A style as the primitives need it: what there is to draw, and where the stroke lies.

use embedded_graphics::primitives::StrokeAlignment;

use super::Style;

/// Wider strokes count as this wide: they cover every display, and no product of theirs leaves 64 bits.
pub(super) const MAX_STROKE_WIDTH: u32 = 0xffff;

/// The width of a stroke and its sides, in whole pixels.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    pub(super) width: i64,
    alignment: StrokeAlignment,
}

impl Stroke {
    pub(super) fn new<C, E>(style: &Style<C, E>) -> Self {
        Self { width: style.stroke_width.min(MAX_STROKE_WIDTH).into(), alignment: style.stroke_alignment }
    }

    /// How far it reaches out of a primitive whose outline runs between pixels.
    pub(super) fn outside(&self) -> i64 {
        match self.alignment {
            StrokeAlignment::Inside => 0,
            StrokeAlignment::Center => self.width / 2,
            StrokeAlignment::Outside => self.width,
        }
    }

    /// How far it reaches into such a primitive.
    pub(super) fn inside(&self) -> i64 {
        self.width - self.outside()
    }

    /// The sides of an outline through the centres of pixels, outside being the left one of its direction.
    ///
    /// The pixels that the outline runs through are part of the stroke whatever the alignment. An even width has no
    /// pixel in the middle, and has one more on the left, as in embedded-graphics; but blended it has no need of whole
    /// pixels, and its sides are as far from the line as each other, whichever way that goes.
    pub(super) fn sides(&self, is_blended: bool) -> Sides {
        let left = match self.alignment {
            _ if self.width == 0 => 0,
            StrokeAlignment::Inside => 128,
            StrokeAlignment::Center if is_blended => 128 * self.width,
            StrokeAlignment::Center => 128 * (self.width | 1),
            StrokeAlignment::Outside => 256 * self.width - 128,
        };
        Sides { left, right: 256 * self.width - left, limit: 512 * self.width }
    }

    /// How far it reaches to the outside and to the inside of an outline that has no need of whole pixels, in 1/256.
    pub(super) fn exact_sides(&self) -> (i64, i64) {
        let outside = match self.alignment {
            StrokeAlignment::Inside => 0,
            StrokeAlignment::Center => 128 * self.width,
            StrokeAlignment::Outside => 256 * self.width,
        };
        (outside, 256 * self.width - outside)
    }

    /// The same, one pixel wide.
    pub(super) fn thin(&self) -> Self {
        Self { width: 1, ..*self }
    }

    /// The same for an outline that is not closed, which has no inside.
    pub(super) fn open(&self) -> Self {
        Self { alignment: StrokeAlignment::Center, ..*self }
    }
}

/// Where a stroke ends, in 1/256 pixel from its line: to its left, to its right, and a mitre at most.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sides {
    pub(super) left: i64,
    pub(super) right: i64,
    pub(super) limit: i64,
}

/// What to draw in which colour.
#[derive(Debug, Clone, Copy)]
pub(super) struct Paint<C> {
    pub(super) fill: Option<C>,
    /// None where the width is zero, too.
    pub(super) stroke: Option<C>,
    pub(super) sides: Stroke,
}

impl<C: Copy> Paint<C> {
    pub(super) fn new<E>(style: &Style<C, E>, has_inside: bool) -> Self {
        let stroke = style.stroke_color.filter(|_| style.stroke_width > 0);
        Self { fill: style.fill_color.filter(|_| has_inside), stroke, sides: Stroke::new(style) }
    }
}
