//! How each library draws each scene, as its users would: from plain coordinates to pixels.
//!
//! What is measured starts from the coordinates of [`scenes`](crate::scenes) for everybody: constructing a primitive,
//! giving it its style, building a path. Only [`Variant::TinySkiaKeptPath`] and [`Variant::Floor`] get their work
//! prepared.

mod embedded_graphics;
mod spanfill;
mod tiny_skia;

use std::convert::Infallible;

use ::embedded_graphics::{pixelcolor::Rgb565, prelude::*};

use crate::{
    drawing::Drawing,
    scenes::{PixelPoint, Scene},
    variant::Variant,
};

/// The scene drawn by the variant; `None` for what the library has not got.
pub(crate) fn drawing(scene: Scene, variant: Variant) -> Option<Box<dyn Drawing>> {
    match variant {
        Variant::Spanfill => Some(spanfill::drawing(scene)),
        Variant::EmbeddedGraphics => embedded_graphics::drawing(scene),
        Variant::TinySkia => Some(tiny_skia::drawing(scene)),
        Variant::TinySkiaKeptPath => Some(tiny_skia::drawing_kept_paths(scene)),
        Variant::Floor => Some(spanfill::floor(scene)),
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
