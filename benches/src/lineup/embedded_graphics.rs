//! embedded-graphics' primitives and styles.

use embedded_graphics::{
    prelude::*,
    primitives::{Circle, Line, PrimitiveStyle, Triangle},
};

use crate::{
    drawing::{Drawing, On},
    lineup::{COLOUR, draw, point, some},
    scenes::{Frame, PixelPoint, Scene, circles, lines, triangles},
};

/// It has no polygons.
pub(super) fn drawing(scene: Scene) -> Option<Box<dyn Drawing>> {
    let frame = Box::new(Frame::new());
    let filled = PrimitiveStyle::with_fill(COLOUR);
    let thin = PrimitiveStyle::with_stroke(COLOUR, 1);
    Some(match scene {
        Scene::Triangles(box_px) => On::boxed(
            frame,
            some(scene, triangles(box_px)),
            move |vertices: &[PixelPoint; 3], frame: &mut Box<Frame>| {
                let [a, b, c] = vertices.map(point);
                draw(&Triangle::new(a, b, c).into_styled(filled), &mut **frame);
            },
        ),
        Scene::Circles(radius_px) => {
            On::boxed(frame, some(scene, circles(radius_px)), move |[x, y]: &PixelPoint, frame: &mut Box<Frame>| {
                let top_left = Point::new(x - radius_px, y - radius_px);
                draw(&Circle::new(top_left, 2 * radius_px.unsigned_abs()).into_styled(filled), &mut **frame);
            })
        }
        Scene::Lines(box_px) => {
            On::boxed(frame, some(scene, lines(box_px)), move |ends: &[PixelPoint; 2], frame: &mut Box<Frame>| {
                let [start, end] = ends.map(point);
                draw(&Line::new(start, end).into_styled(thin), &mut **frame);
            })
        }
        Scene::Stars(_) | Scene::Concave64(_) => return None,
    })
}
