//! How each library draws each scene, as its users would: from plain coordinates to pixels.
//!
//! What is measured starts from the coordinates of [`scenes`](crate::scenes) for everybody: constructing a primitive,
//! giving it its style, building a path. Only [`Variant::TinySkiaKeptPath`], [`Variant::Floor`] and
//! [`Variant::BlendFloor`] get their work prepared. Memory that a library can be given again is kept.

mod ab_glyph;
mod embedded_graphics;
pub(crate) mod outline;
mod spanfill;
mod spanfill_aa;
mod spanfill_samples;
mod tiny_skia;
mod tiny_skia_aa;
mod vello_cpu;
mod zeno;

pub(crate) use tiny_skia::pixmap;
pub(crate) use vello_cpu::renderer_at;

use std::convert::Infallible;

use ::embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use ::spanfill::Samples;

use crate::{
    drawing::Drawing,
    scenes::{PixelPoint, Scene},
    variant::Variant,
};

/// The scene drawn by the variant; `None` for what the library has not got.
pub(crate) fn drawing(scene: Scene, variant: Variant) -> Option<Box<dyn Drawing>> {
    match variant {
        Variant::Spanfill | Variant::Aliased => Some(spanfill::drawing(scene)),
        Variant::EmbeddedGraphics => embedded_graphics::drawing(scene),
        Variant::TinySkia => Some(tiny_skia::drawing(scene)),
        Variant::TinySkiaKeptPath => Some(tiny_skia::drawing_kept_paths(scene)),
        Variant::Floor => Some(spanfill::floor(scene)),
        Variant::AntiAliased => Some(spanfill_aa::drawing(scene)),
        Variant::AntiAliasedOver => Some(spanfill_aa::drawing_over(scene)),
        Variant::Mask => Some(spanfill_aa::mask(scene)),
        Variant::BlendFloor => Some(spanfill_aa::blend_floor(scene)),
        Variant::Samples4 | Variant::SamplesWeighted | Variant::Samples16 => {
            spanfill_samples::drawing(scene, samples(variant)?)
        }
        Variant::TinySkiaAntiAliased => Some(tiny_skia_aa::drawing(scene)),
        Variant::Vello => Some(vello_cpu::drawing(scene)),
        Variant::VelloBaseline => Some(vello_cpu::drawing_at_baseline(scene)),
        Variant::VelloAlone => Some(vello_cpu::drawing_alone(scene)),
        Variant::Zeno => Some(zeno::drawing(scene)),
        Variant::AbGlyph => Some(ab_glyph::drawing(scene)),
    }
}

/// The points of each pixel that the variant looks at, of those that do.
fn samples(variant: Variant) -> Option<Samples> {
    match variant {
        Variant::Samples4 => Some(Samples::grid(4)),
        Variant::SamplesWeighted => Some(Samples::WEIGHTED),
        Variant::Samples16 => Some(Samples::grid(16)),
        _ => None,
    }
}

/// What the variant's accuracy is judged by: itself, or, where the picture has too few bits, the mask that it blends.
pub(crate) fn judged(scene: Scene, variant: Variant) -> Option<Box<dyn Drawing>> {
    blended_mask(scene, variant).or_else(|| drawing(scene, variant))
}

fn blended_mask(scene: Scene, variant: Variant) -> Option<Box<dyn Drawing>> {
    match variant {
        Variant::AntiAliased | Variant::AntiAliasedOver | Variant::BlendFloor => Some(spanfill_aa::mask(scene)),
        _ => spanfill_samples::mask(scene, samples(variant)?),
    }
}

/// Fails unless the variant's frames show the mask that its accuracy is judged by.
pub(crate) fn check_frames(scene: Scene, variant: Variant, shapes: usize) -> Result<(), String> {
    let Some(mut mask) = blended_mask(scene, variant) else { return Ok(()) };
    let mut frames = drawing(scene, variant).expect("it has a mask of the scene");
    match spanfill_aa::disagreement(&mut *mask, &mut *frames, shapes) {
        None => Ok(()),
        Some((shape, pixel)) => Err(format!("{variant}: shape {shape} is not its mask, blended, at {pixel:?}")),
    }
}

/// How many shapes of a random scene are drawn.
///
/// A processor learns the branches of a few thousand rows by heart when it meets them again and again, and then fills
/// small triangles in half the time: so there are more rows than that. There are not so many that the floor's list of
/// rectangles leaves the second-level cache.
fn shapes(scene: Scene) -> usize {
    let rows_a_shape = usize::try_from(scene.size_px()).unwrap_or(usize::MAX);
    (80_000 / rows_a_shape).clamp(1000, 8000)
}

const COLOUR: Rgb565 = Rgb565::CSS_ORANGE;

/// As many of the scene's endless shapes as are drawn.
fn some<T>(scene: Scene, endless: impl Iterator<Item = T>) -> Vec<T> {
    endless.take(shapes(scene)).collect()
}

fn point([x, y]: PixelPoint) -> Point {
    Point::new(x, y)
}

fn draw<D: DrawTarget<Error = Infallible>>(shape: &impl Drawable<Color = D::Color>, target: &mut D) {
    let Ok(_) = shape.draw(target);
}
