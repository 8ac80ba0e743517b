//! Scenes to be drawn smooth: [`Scene`].

use core::convert::Infallible;

use spanfill::{
    Cell, Cover, CoverageEdge, FillRule, FragmentSink, Line, PixelRect, Polygon, SampleCell, SampleEdge, Samples,
    Triangle, Vertex,
    methods::{
        antialias::{
            Error, Outline, Side, accumulated, exact, grid, line_met, line_rectangle,
            minified::{self, Sampling, Texture},
            none, ramp, rotated,
            sampled::SampleColumn,
            scene, weighted,
        },
        line::gupta_sproull::Root,
    },
};

use crate::variants;
use crate::variants::{
    Outcome, WIDTH,
    line::{Fragments, drawn},
};

/// What is drawn; vertices in 1/256 pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Scene {
    Triangle([Vertex; 3]),
    /// One pixel wide, square at its ends.
    Line([Vertex; 2]),
    Polygon(&'static [&'static [Vertex]], FillRule),
    /// Grey texels, width and height, drawn in `pixels` columns and rows from `corner` on.
    Texture {
        texels: &'static [u8],
        size: [u16; 2],
        corner: [i32; 2],
        pixels: [u16; 2],
    },
}

/// A column of scratch for each column of the screen, and one around it.
const COLUMNS: usize = WIDTH as usize + 2;
/// The shipped polygon's scratch.
const EDGES: usize = 4096;

const NO_OUTLINE: &str = "draws outlines only";
const NO_LINE: &str = "draws lines only";
const NO_TEXTURE: &str = "draws textures only";
const NO_SCRATCH: &str = "too little scratch";

/// The rectangle one pixel wide around a line, its corners rounded to 1/256 pixel; of no length, it is empty.
pub fn rectangle([start, end]: [Vertex; 2]) -> [Vertex; 4] {
    let at = |vertex: Vertex| [vertex.x, vertex.y].map(|at| f64::from(at.to_bits()));
    let ([ax, ay], [bx, by]) = (at(start), at(end));
    let (dx, dy) = (bx - ax, by - ay);
    let length = root(dx * dx + dy * dy);
    let (nx, ny) = (128.0 * -dy / length, 128.0 * dx / length);
    let vertex = |x: f64, y: f64| {
        let nearest = |at: f64| (at + if at < 0.0 { -0.5 } else { 0.5 }) as i32;
        Vertex::from_bits(nearest(x), nearest(y))
    };
    [vertex(ax + nx, ay + ny), vertex(bx + nx, by + ny), vertex(bx - nx, by - ny), vertex(ax - nx, ay - ny)]
}

/// A square root of 1 or more without `std`: Newton's, from above, until it no longer falls.
fn root(square: f64) -> f64 {
    let square = square.max(1.0);
    let mut root = square;
    loop {
        let next = (root + square / root) / 2.0;
        if next >= root {
            return root;
        }
        root = next;
    }
}

/// Hands a scene's outline to a method.
fn outlined(scene: &Scene, draw: impl FnOnce(&Outline<'_>) -> Result<(), Error<Infallible>>) -> Outcome {
    let result = match scene {
        Scene::Triangle(vertices) => draw(&Outline { contours: &[vertices], fill_rule: FillRule::NonZero }),
        Scene::Line(ends) => draw(&Outline { contours: &[&rectangle(*ends)], fill_rule: FillRule::NonZero }),
        Scene::Polygon(contours, fill_rule) => draw(&Outline { contours, fill_rule: *fill_rule }),
        Scene::Texture { .. } => return Err(NO_OUTLINE),
    };
    result.map_err(|_| NO_SCRATCH)
}

fn line_of(scene: &Scene) -> Result<[Vertex; 2], &'static str> {
    if let Scene::Line(ends) = scene { Ok(*ends) } else { Err(NO_LINE) }
}

fn grid<S: FragmentSink<Error = Infallible>>(scene: &Scene, side: Side, clip: &PixelRect, sink: &mut S) -> Outcome {
    outlined(scene, |outline| grid::draw(outline, side, &mut [SampleColumn::EMPTY; COLUMNS], clip, sink))
}

fn ramp<S: FragmentSink<Error = Infallible>>(scene: &Scene, root: Root, clip: &PixelRect, sink: &mut S) -> Outcome {
    outlined(scene, |outline| ramp::draw(outline, root, &mut [ramp::RampColumn::EMPTY; COLUMNS], clip, sink))
}

fn accumulated<S: FragmentSink<Error = Infallible>>(
    scene: &Scene,
    numbers: accumulated::Numbers,
    clip: &PixelRect,
    sink: &mut S,
) -> Outcome {
    outlined(scene, |outline| {
        accumulated::draw(outline, numbers, &mut [accumulated::AreaColumn::EMPTY; COLUMNS], clip, sink)
    })
}

fn exact<S: FragmentSink<Error = Infallible>>(
    scene: &Scene,
    numbers: exact::Numbers,
    clip: &PixelRect,
    sink: &mut S,
) -> Outcome {
    outlined(scene, |outline| exact::draw(outline, numbers, &mut [exact::ExactColumn::EMPTY; COLUMNS], clip, sink))
}

/// In bands of lines of samples, so that the larger picture fits a firmware's memory.
fn enlarged<const N: usize, S: FragmentSink<Error = Infallible>>(
    scene: &Scene,
    side: Side,
    clip: &PixelRect,
    sink: &mut S,
) -> Outcome {
    /// Lines of samples.
    const BAND: i32 = 64;
    const BYTES: usize = BAND as usize * 16 * WIDTH as usize / 8;
    outlined(scene, |outline| {
        let (mut bits, mut changes) = ([0; BYTES], [0; 16 * WIDTH as usize]);
        let band = BAND / N as i32;
        let mut start = clip.rows.start;
        while start < clip.rows.end {
            let rows = start..start.saturating_add(band).min(clip.rows.end);
            start = rows.end;
            let clip = PixelRect { rows, columns: clip.columns.clone() };
            let mut larger = scene::Scene::new(side, &clip, &mut bits, &mut changes)?;
            larger.draw(outline);
            larger.average(sink).map_err(Error::Sink)?;
        }
        Ok(())
    })
}

fn minified<S: FragmentSink<Error = Infallible>>(
    scene: &Scene,
    sampling: Sampling,
    clip: &PixelRect,
    sink: &mut S,
) -> Outcome {
    let Scene::Texture { texels, size: [width, height], corner, pixels } = scene else { return Err(NO_TEXTURE) };
    let texture = Texture::new(texels, *width, *height).map_err(|_| "too few texels")?;
    drawn(minified::draw(&texture, *corner, *pixels, sampling, clip, sink))
}

/// The crate's own, exact: triangles and lines as what they are.
fn shipped<S: FragmentSink<Error = Infallible>>(scene: &Scene, clip: &PixelRect, sink: &mut S) -> Outcome {
    match scene {
        Scene::Triangle(vertices) => drawn(Triangle::from_vertices(*vertices).coverage(clip, &mut Fragments(sink))),
        Scene::Line([start, end]) => drawn(Line::new(*start, *end).coverage(clip, &mut Fragments(sink))),
        Scene::Polygon(contours, fill_rule) => {
            let (mut edges, mut cells) = ([CoverageEdge::EMPTY; EDGES], [Cell::EMPTY; COLUMNS]);
            let polygon = Polygon::with_contours(contours).fill_rule(*fill_rule);
            let polygon = polygon.coverage_in(&mut edges, &mut cells).map_err(|_| NO_SCRATCH)?;
            drawn(polygon.coverage(clip, &mut Fragments(sink)))
        }
        Scene::Texture { .. } => Err(NO_OUTLINE),
    }
}

/// The crate's own, sampled.
fn sampled<S: FragmentSink<Error = Infallible>>(
    scene: &Scene,
    samples: Samples,
    clip: &PixelRect,
    sink: &mut S,
) -> Outcome {
    let mut cells = [SampleCell::EMPTY; COLUMNS];
    if let Scene::Triangle(vertices) = scene {
        let triangle = Triangle::from_vertices(*vertices).supersampled_in(samples, &mut cells);
        return drawn(triangle.map_err(|_| NO_SCRATCH)?.coverage(clip, &mut Fragments(sink)));
    }
    let mut draw = |contours: &[&[Vertex]], fill_rule, sink: &mut S| {
        let mut edges = [SampleEdge::EMPTY; EDGES];
        let polygon = Polygon::with_contours(contours).fill_rule(fill_rule);
        let polygon = polygon.supersampled_in(samples, &mut edges, &mut cells).map_err(|_| NO_SCRATCH)?;
        drawn(polygon.coverage(clip, &mut Fragments(sink)))
    };
    match scene {
        Scene::Line(ends) => draw(&[&rectangle(*ends)], FillRule::NonZero, sink),
        Scene::Polygon(contours, fill_rule) => draw(contours, *fill_rule, sink),
        Scene::Triangle(_) | Scene::Texture { .. } => Err(NO_OUTLINE),
    }
}

variants! {
    ANTIALIAS: Scene;
    "anti-aliasing", "none", "" => |scene, clip, sink|
        outlined(scene, |outline| none::draw(outline, &mut [SampleColumn::EMPTY; COLUMNS], clip, sink));
    "anti-aliasing", "n x n samples", "n = 2" => |scene, clip, sink| grid(scene, Side::Two, clip, sink);
    "anti-aliasing", "n x n samples", "n = 4" => |scene, clip, sink| grid(scene, Side::Four, clip, sink);
    "anti-aliasing", "n x n samples", "n = 8" => |scene, clip, sink| grid(scene, Side::Eight, clip, sink);
    "anti-aliasing", "n x n samples", "n = 16" => |scene, clip, sink| grid(scene, Side::Sixteen, clip, sink);
    "anti-aliasing", "rotated grid", "" => |scene, clip, sink|
        outlined(scene, |outline| rotated::draw(outline, &mut [SampleColumn::EMPTY; COLUMNS], clip, sink));
    "anti-aliasing", "weighted 4 x 4", "" => |scene, clip, sink|
        outlined(scene, |outline| weighted::draw(outline, &mut [SampleColumn::EMPTY; COLUMNS], clip, sink));
    "anti-aliasing", "distance ramp", "libm's root" => |scene, clip, sink| ramp(scene, Root::Libm, clip, sink);
    "anti-aliasing", "distance ramp", "micromath's root" => |scene, clip, sink| ramp(scene, Root::Micromath, clip, sink);
    "anti-aliasing", "accumulated signed area", "f32" => |scene, clip, sink|
        accumulated(scene, accumulated::Numbers::F32, clip, sink);
    "anti-aliasing", "accumulated signed area", "integers" => |scene, clip, sink|
        accumulated(scene, accumulated::Numbers::Integers, clip, sink);
    "anti-aliasing", "exact area", "f32" => |scene, clip, sink| exact(scene, exact::Numbers::F32, clip, sink);
    "anti-aliasing", "exact area", "f64" => |scene, clip, sink| exact(scene, exact::Numbers::F64, clip, sink);
    "anti-aliasing", "line's samples, met by the line", "n = 2" => |scene, clip, sink|
        drawn(line_met::line(line_of(scene)?, Side::Two, clip, sink));
    "anti-aliasing", "line's samples, met by the line", "n = 4" => |scene, clip, sink|
        drawn(line_met::line(line_of(scene)?, Side::Four, clip, sink));
    "anti-aliasing", "line's samples, met by the line", "n = 8" => |scene, clip, sink|
        drawn(line_met::line(line_of(scene)?, Side::Eight, clip, sink));
    "anti-aliasing", "line's samples, met by the line", "n = 16" => |scene, clip, sink|
        drawn(line_met::line(line_of(scene)?, Side::Sixteen, clip, sink));
    "anti-aliasing", "line's samples, in the rectangle", "n = 2" => |scene, clip, sink|
        drawn(line_rectangle::line(line_of(scene)?, Side::Two, clip, sink));
    "anti-aliasing", "line's samples, in the rectangle", "n = 4" => |scene, clip, sink|
        drawn(line_rectangle::line(line_of(scene)?, Side::Four, clip, sink));
    "anti-aliasing", "line's samples, in the rectangle", "n = 8" => |scene, clip, sink|
        drawn(line_rectangle::line(line_of(scene)?, Side::Eight, clip, sink));
    "anti-aliasing", "line's samples, in the rectangle", "n = 16" => |scene, clip, sink|
        drawn(line_rectangle::line(line_of(scene)?, Side::Sixteen, clip, sink));
    "anti-aliasing", "scene n times larger, averaged", "n = 2" => |scene, clip, sink|
        enlarged::<2, _>(scene, Side::Two, clip, sink);
    "anti-aliasing", "scene n times larger, averaged", "n = 4" => |scene, clip, sink|
        enlarged::<4, _>(scene, Side::Four, clip, sink);
    "anti-aliasing", "scene n times larger, averaged", "n = 8" => |scene, clip, sink|
        enlarged::<8, _>(scene, Side::Eight, clip, sink);
    "anti-aliasing", "scene n times larger, averaged", "n = 16" => |scene, clip, sink|
        enlarged::<16, _>(scene, Side::Sixteen, clip, sink);
    "anti-aliasing", "minified texture", "point-sampled" => |scene, clip, sink|
        minified(scene, Sampling::Point, clip, sink);
    "anti-aliasing", "minified texture", "averaged" => |scene, clip, sink|
        minified(scene, Sampling::Averaged, clip, sink);
    "anti-aliasing", "spanfill", "n = 4" => |scene, clip, sink| sampled(scene, Samples::grid(4), clip, sink);
    "anti-aliasing", "spanfill", "weighted" => |scene, clip, sink| sampled(scene, Samples::WEIGHTED, clip, sink);
    "anti-aliasing", "spanfill", "exact" => |scene, clip, sink| shipped(scene, clip, sink);
}
