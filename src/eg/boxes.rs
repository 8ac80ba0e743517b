//! A box of whole pixels with a stroke: one `fill_solid` for the inside and one for each side.

use embedded_graphics_core::draw_target::DrawTarget;

use super::{
    paint::{Paint, Stroke},
    pixel_box::PixelBox,
};

/// The box that a stroke ends at, and the one that is filled.
#[derive(Debug, Clone, Copy)]
pub(super) struct Boxes {
    pub(super) outer: PixelBox,
    pub(super) inner: PixelBox,
}

impl Boxes {
    pub(super) fn new(pixels: PixelBox, stroke: &Stroke) -> Self {
        Self { outer: pixels.offset(stroke.outside()), inner: pixels.offset(-stroke.inside()) }
    }

    /// Draws what of them lies in `within`, and on the target.
    pub(super) fn draw<D: DrawTarget>(
        &self,
        within: &PixelBox,
        paint: &Paint<D::Color>,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let Self { outer, inner } = *self;
        let clip = within.visible(&target.bounding_box().into());
        let mut draw = |pixels: PixelBox, colour: Option<D::Color>| {
            let Some(colour) = colour else { return Ok(()) };
            let pixels = pixels.visible(&clip);
            if pixels.rows.is_empty() || pixels.columns.is_empty() {
                return Ok(());
            }
            target.fill_solid(&pixels.into(), colour)
        };
        if inner.is_empty() {
            return draw(outer, paint.stroke);
        }
        draw(inner, paint.fill)?;
        let (columns, rows) = (outer.columns(), inner.rows());
        draw(PixelBox::between(columns.clone(), outer.top..rows.start), paint.stroke)?;
        draw(PixelBox::between(columns.start..inner.left, rows.clone()), paint.stroke)?;
        draw(PixelBox::between(inner.columns().end..columns.end, rows.clone()), paint.stroke)?;
        draw(PixelBox::between(columns, rows.end..outer.rows().end), paint.stroke)
    }
}
