//! A circle as a polygon of n vertices on it: how much of it is lost depends on n alone.
//!
//! ```text
//!       .-'''-.         sagitta   s = r (1 - cos(pi / n)) ~ r pi^2 / (2 n^2)
//!      /-------\        a chord lies up to s inside; s < 1/2 needs n > pi sqrt(r):
//!     |    +    |       20 for r = 40, 44 for r = 200
//! ```
//!
//! Filled, the vertices lie at `r + 1/2`, and the crate fills the polygon, exactly; as an outline, at `r` in the nearest
//! pixels, joined by Bresenham's lines.

use core::f64::consts::TAU;

use crate::{
    FragmentSink, PixelRect, Polygon, Span, SpanSink, Vertex,
    methods::{
        circle::octant::Style,
        line::{
            directly::{self, Ties},
            display::display_pixel,
        },
    },
    shape::Shape,
};

/// Hands spans on as fragments.
#[derive(Debug)]
struct Pixels<'a, S> {
    clip: &'a PixelRect,
    sink: &'a mut S,
}

impl<S: FragmentSink> SpanSink for Pixels<'_, S> {
    type Error = S::Error;

    fn span(&mut self, span: Span) -> Result<(), S::Error> {
        for column in span.columns {
            display_pixel(column, span.row, self.clip, self.sink)?;
        }
        Ok(())
    }
}

/// Draws a circle [xc, yc, r] with `N` vertices; of a negative radius, nothing.
///
/// # Errors
///
/// The sink's.
pub fn circle<const N: usize, S: FragmentSink>(
    [xc, yc, r]: [i32; 3],
    style: Style,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    if r < 0 {
        return Ok(());
    }
    let vertices = |radius: f64, center: [f64; 2]| {
        core::array::from_fn::<[f64; 2], N, _>(|i| {
            let (sin, cos) = libm::sincos(TAU * i as f64 / N as f64);
            [center[0] + radius * cos, center[1] + radius * sin]
        })
    };
    let center = [f64::from(xc), f64::from(yc)];
    match style {
        Style::Filled => {
            let vertices = vertices(f64::from(r) + 0.5, center.map(|coordinate| coordinate + 0.5));
            let vertices = vertices.map(|[x, y]| Vertex::new(x, y));
            // Convex but for what the rounding to 1/256 does to very small edges: room for more than two edges.
            match Polygon::new(&vertices).with_capacity::<8>() {
                Ok(polygon) => polygon.spans(clip, &mut Pixels { clip, sink }),
                Err(_) => Ok(()),
            }
        }
        Style::Outline => {
            let pixels = vertices(f64::from(r), center).map(|vertex| vertex.map(|at| libm::floor(at + 0.5) as i32));
            let following = pixels.iter().skip(1).chain(pixels.first());
            for (start, end) in pixels.iter().zip(following) {
                directly::line([*start, *end], Ties::Diagonal, clip, sink)?;
            }
            Ok(())
        }
    }
}
