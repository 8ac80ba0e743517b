//! tiny-skia with anti-aliasing, on an RGBA picture.

use tiny_skia::{FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, Transform};

use crate::{
    drawing::{Drawing, On},
    lineup::{
        outline::{Outline, OutlineVisitor, Pen, Position, with_outlines},
        tiny_skia::{paint, pixmap},
    },
    scenes::Scene,
};

pub(super) fn drawing(scene: Scene) -> Box<dyn Drawing> {
    let stroke =
        Stroke { width: 1.0, line_cap: LineCap::Butt, miter_limit: 4.0, line_join: LineJoin::Miter, dash: None };
    with_outlines(scene, Fill { stroke: matches!(scene, Scene::Lines(_)).then_some(stroke) })
}

struct Fill {
    /// For lines: tiny-skia has a quick way for those of one pixel.
    stroke: Option<Stroke>,
}

impl OutlineVisitor for Fill {
    type Output = Box<dyn Drawing>;

    fn visit<O: Outline>(self, outlines: Vec<O>) -> Box<dyn Drawing> {
        let paint = Paint { anti_alias: true, ..paint() };
        let mut kept = Some(PathBuilder::new());
        On::boxed(pixmap(), outlines, move |outline: &O, pixmap: &mut Pixmap| {
            let mut pen = PathPen(kept.take().unwrap_or_default());
            outline.trace(&mut pen);
            let Some(path) = pen.0.finish() else { return };
            draw(pixmap, &paint, &path, self.stroke.as_ref());
            kept = Some(path.clear());
        })
    }
}

fn draw(pixmap: &mut Pixmap, paint: &Paint<'_>, path: &Path, stroke: Option<&Stroke>) {
    match stroke {
        Some(stroke) => pixmap.stroke_path(path, paint, stroke, Transform::identity(), None),
        None => pixmap.fill_path(path, paint, FillRule::Winding, Transform::identity(), None),
    }
}

struct PathPen(PathBuilder);

impl Pen for PathPen {
    fn polygon(&mut self, vertices: &[Position]) {
        let Some(((x, y), rest)) = vertices.split_first() else { return };
        self.0.move_to(*x as f32, *y as f32);
        rest.iter().for_each(|&(x, y)| self.0.line_to(x as f32, y as f32));
        self.0.close();
    }

    fn circle(&mut self, (x, y): Position, radius: f64) {
        self.0.push_circle(x as f32, y as f32, radius as f32);
    }

    fn line(&mut self, start: Position, end: Position) {
        self.0.move_to(start.0 as f32, start.1 as f32);
        self.0.line_to(end.0 as f32, end.1 as f32);
    }
}
