//! A style as the primitives need it: what there is to draw, and where the stroke lies.

use embedded_graphics::primitives::StrokeAlignment;

use super::{Blended, Style};

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

    /// One pixel, which alignment does not move.
    pub(super) const fn thin() -> Self {
        Self { width: 1, alignment: StrokeAlignment::Center }
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

    /// The sides of an outline through the centres of pixels, in half pixels: the side to the left of its direction,
    /// or outside, and the other one.
    ///
    /// The pixels that the outline runs through are part of the stroke whatever the alignment. An even width has no
    /// pixel in the middle, and has one more on the left, as in embedded-graphics.
    pub(super) fn halves(&self) -> (i64, i64) {
        if self.width == 0 {
            return (0, 0);
        }
        let left = match self.alignment {
            StrokeAlignment::Inside => 1,
            StrokeAlignment::Center => self.width + i64::from(self.width % 2 == 0),
            StrokeAlignment::Outside => 2 * self.width - 1,
        };
        (left, 2 * self.width - left)
    }

    /// How far it reaches to the outside and to the inside of an outline that has no need of whole pixels, in half
    /// pixels.
    pub(super) fn exact_halves(&self) -> (i64, i64) {
        match self.alignment {
            StrokeAlignment::Inside => (0, 2 * self.width),
            StrokeAlignment::Center => (self.width, self.width),
            StrokeAlignment::Outside => (2 * self.width, 0),
        }
    }

    /// Whether it lies in the middle of the outline.
    pub(super) fn is_centered(&self) -> bool {
        self.alignment == StrokeAlignment::Center
    }

    /// The same for an outline that is not closed, which has no inside.
    pub(super) fn open(&self) -> Self {
        Self { alignment: StrokeAlignment::Center, ..*self }
    }
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
    pub(super) fn new<E>(style: &Style<C, E>) -> Self {
        Self {
            fill: style.fill_color,
            stroke: style.stroke_color.filter(|_| style.stroke_width > 0),
            sides: Stroke::new(style),
        }
    }

    /// Nothing, also where opacity leaves nothing.
    pub(super) fn is_transparent<B>(&self, blended: &Blended<B>) -> bool {
        blended.opacity == 0 || (self.fill.is_none() && self.stroke.is_none())
    }
}
