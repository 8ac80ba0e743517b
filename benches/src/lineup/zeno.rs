//! zeno, into a mask: what it is made for. Blending the mask would come on top.

use zeno::{Command, PathBuilder, Scratch};

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
        let mut scratch = Scratch::new();
        let mut path = PathPen(Vec::new());
        On::boxed(Mask::new(), outlines, move |outline: &O, mask: &mut Mask| {
            path.0.clear();
            outline.trace(&mut path);
            // Told beforehand, so that it need not look over the path for them.
            let bounds = outline.bounds();
            let Bounds { left, top, width, height } = bounds;
            zeno::Mask::with_scratch(&path.0, &mut scratch)
                .size(width.unsigned_abs(), height.unsigned_abs())
                .offset((-left as f32, -top as f32))
                .render_into(mask.start(bounds), None);
        })
    }
}

struct PathPen(Vec<Command>);

impl Pen for PathPen {
    fn polygon(&mut self, vertices: &[Position]) {
        let Some(((x, y), rest)) = vertices.split_first() else { return };
        self.0.move_to((*x as f32, *y as f32));
        for &(x, y) in rest {
            self.0.line_to((x as f32, y as f32));
        }
        self.0.close();
    }

    fn circle(&mut self, (x, y): Position, radius: f64) {
        self.0.add_circle((x as f32, y as f32), radius as f32);
    }
}
