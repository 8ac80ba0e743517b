//! ab_glyph_rasterizer, into a mask: what it is made for. Blending the mask would come on top.

use ab_glyph_rasterizer::{Point, Rasterizer, point};

use crate::{
    drawing::{Drawing, On},
    lineup::outline::{Outline, OutlineVisitor, Pen, Position, with_outlines},
    picture::{Bounds, Mask},
    scenes::Scene,
};

pub(super) fn drawing(scene: Scene) -> Box<dyn Drawing> {
    with_outlines(scene, Fill)
}

struct Fill;

impl OutlineVisitor for Fill {
    type Output = Box<dyn Drawing>;

    fn visit<O: Outline>(self, outlines: Vec<O>) -> Box<dyn Drawing> {
        let mut pen = RasterizerPen { rasterizer: Rasterizer::new(1, 1), left: 0.0, top: 0.0 };
        On::boxed(Mask::new(), outlines, move |outline: &O, mask: &mut Mask| {
            let bounds = outline.bounds();
            let Bounds { left, top, width, height } = bounds;
            pen.rasterizer.reset(width.unsigned_abs() as usize, height.unsigned_abs() as usize);
            (pen.left, pen.top) = (f64::from(left), f64::from(top));
            outline.trace(&mut pen);
            let bytes = mask.start_with_any(bounds);
            pen.rasterizer.for_each_pixel(|index, coverage| {
                if let Some(byte) = bytes.get_mut(index) {
                    // Rounded; a little more than 1 is 255.
                    *byte = (coverage * 255.0 + 0.5) as u8;
                }
            });
        })
    }
}

struct RasterizerPen {
    rasterizer: Rasterizer,
    left: f64,
    top: f64,
}

impl RasterizerPen {
    fn point(&self, (x, y): Position) -> Point {
        point((x - self.left) as f32, (y - self.top) as f32)
    }
}

impl Pen for RasterizerPen {
    fn polygon(&mut self, vertices: &[Position]) {
        let Some(&last) = vertices.last() else { return };
        let mut start = self.point(last);
        for &vertex in vertices {
            let end = self.point(vertex);
            self.rasterizer.draw_line(start, end);
            start = end;
        }
    }

    /// By four curves, as a font has it.
    fn circle(&mut self, (x, y): Position, radius: f64) {
        // The curve is nowhere further from the circle than 0.0003 of its radius.
        let (r, k) = (radius, 0.551_915 * radius);
        let quarters = [
            [(r, 0.0), (r, k), (k, r), (0.0, r)],
            [(0.0, r), (-k, r), (-r, k), (-r, 0.0)],
            [(-r, 0.0), (-r, -k), (-k, -r), (0.0, -r)],
            [(0.0, -r), (k, -r), (r, -k), (r, 0.0)],
        ];
        for quarter in quarters {
            let [start, control_1, control_2, end] = quarter.map(|(dx, dy)| self.point((x + dx, y + dy)));
            self.rasterizer.draw_cubic(start, control_1, control_2, end);
        }
    }
}
