//! tiny-skia, without anti-aliasing, on an RGBA picture: four bytes a pixel where the others write two.

use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Shader, Stroke, Transform};

use crate::{
    drawing::{Drawing, On},
    lineup::some,
    scenes::{
        FRAME_HEIGHT, FRAME_WIDTH, PixelPoint, Scene, SubpixelPoint, circles, concave_polygons, lines, stars, triangles,
    },
};

/// The path is built, then drawn.
pub(super) fn drawing(scene: Scene) -> Box<dyn Drawing> {
    let pixmap = pixmap();
    let paint = paint();
    match scene {
        Scene::Triangles(box_px) => {
            On::boxed(pixmap, some(scene, triangles(box_px)), move |vertices: &[PixelPoint; 3], pixmap: &mut Pixmap| {
                fill(pixmap, &paint, triangle_path(vertices));
            })
        }
        Scene::Circles(radius_px) => {
            On::boxed(pixmap, some(scene, circles(radius_px)), move |centre: &PixelPoint, pixmap: &mut Pixmap| {
                fill(pixmap, &paint, circle_path(*centre, radius_px));
            })
        }
        Scene::Lines(box_px) => {
            On::boxed(pixmap, some(scene, lines(box_px)), move |ends: &[PixelPoint; 2], pixmap: &mut Pixmap| {
                stroke(pixmap, &paint, line_path(ends));
            })
        }
        Scene::Stars(radius_px) => {
            On::boxed(pixmap, some(scene, stars(radius_px)), move |outline: &[_; 5], pixmap: &mut Pixmap| {
                fill(pixmap, &paint, outline_path(outline));
            })
        }
        Scene::Concave64(radius_px) => On::boxed(
            pixmap,
            some(scene, concave_polygons(radius_px)),
            move |outline: &[_; 64], pixmap: &mut Pixmap| {
                fill(pixmap, &paint, outline_path(outline));
            },
        ),
    }
}

/// The paths are built beforehand.
pub(super) fn drawing_kept_paths(scene: Scene) -> Box<dyn Drawing> {
    let is_line = matches!(scene, Scene::Lines(_));
    let paths: Vec<Option<Path>> = match scene {
        Scene::Triangles(box_px) => some(scene, triangles(box_px).map(|vertices| triangle_path(&vertices))),
        Scene::Circles(radius_px) => some(scene, circles(radius_px).map(|centre| circle_path(centre, radius_px))),
        Scene::Lines(box_px) => some(scene, lines(box_px).map(|ends| line_path(&ends))),
        Scene::Stars(radius_px) => some(scene, stars(radius_px).map(|outline| outline_path(&outline))),
        Scene::Concave64(radius_px) => some(scene, concave_polygons(radius_px).map(|outline| outline_path(&outline))),
    };
    let paint = paint();
    On::boxed(pixmap(), paths, move |path: &Option<Path>, pixmap: &mut Pixmap| match path {
        Some(path) if is_line => pixmap.stroke_path(path, &paint, &HAIRLINE, Transform::identity(), None),
        Some(path) => pixmap.fill_path(path, &paint, FillRule::Winding, Transform::identity(), None),
        None => {}
    })
}

pub(crate) fn pixmap() -> Pixmap {
    Pixmap::new(FRAME_WIDTH.unsigned_abs(), FRAME_HEIGHT.unsigned_abs()).expect("the frame has a size")
}

pub(super) fn paint() -> Paint<'static> {
    let colour = Color::from_rgba8(255, 165, 0, 255);
    Paint { shader: Shader::SolidColor(colour), anti_alias: false, ..Paint::default() }
}

/// Without anti-aliasing, tiny-skia draws a width of 0 (and no other) as a line of single pixels. The cap lets it have
/// the pixels of both ends.
const HAIRLINE: Stroke =
    Stroke { width: 0.0, line_cap: LineCap::Square, miter_limit: 4.0, line_join: LineJoin::Miter, dash: None };

fn fill(pixmap: &mut Pixmap, paint: &Paint<'_>, path: Option<Path>) {
    if let Some(path) = path {
        pixmap.fill_path(&path, paint, FillRule::Winding, Transform::identity(), None);
    }
}

fn stroke(pixmap: &mut Pixmap, paint: &Paint<'_>, path: Option<Path>) {
    if let Some(path) = path {
        pixmap.stroke_path(&path, paint, &HAIRLINE, Transform::identity(), None);
    }
}

/// A pixel stands for its centre.
fn centre([x, y]: PixelPoint) -> (f32, f32) {
    (x as f32 + 0.5, y as f32 + 0.5)
}

fn triangle_path(vertices: &[PixelPoint; 3]) -> Option<Path> {
    closed_path(vertices.iter().copied().map(centre))
}

fn outline_path(outline: &[SubpixelPoint]) -> Option<Path> {
    closed_path(outline.iter().map(|&[x, y]| (x as f32 / 256.0, y as f32 / 256.0)))
}

fn closed_path(mut vertices: impl Iterator<Item = (f32, f32)>) -> Option<Path> {
    let mut path = PathBuilder::new();
    let (x, y) = vertices.next()?;
    path.move_to(x, y);
    vertices.for_each(|(x, y)| path.line_to(x, y));
    path.close();
    path.finish()
}

fn circle_path([x, y]: PixelPoint, radius_px: i32) -> Option<Path> {
    PathBuilder::from_circle(x as f32, y as f32, radius_px as f32)
}

fn line_path(ends: &[PixelPoint; 2]) -> Option<Path> {
    let [start, end] = ends.map(centre);
    let mut path = PathBuilder::new();
    path.move_to(start.0, start.1);
    path.line_to(end.0, end.1);
    path.finish()
}
