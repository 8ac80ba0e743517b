//! Strokes as they are, not outlined beforehand, against resvg: the bundled map, blended, and traces of many samples.
//!
//! Files are parsed, and paths made, before the clock starts. What is measured is stroking and drawing.

use std::{convert::Infallible, error::Error, hint::black_box, process::ExitCode, time::Duration};

use embedded_graphics::{image::GetPixel, pixelcolor::Rgb888, prelude::*};
use resvg::{
    tiny_skia::{self, Pixmap},
    usvg::{self, Node, Paint, Tree},
};
use spanfill::{
    AntiAlias, Cap, CoverOutline, CoverageEdge, Curves, Element, FillRule, FinePoint, Framebuffer, InPlace, Join,
    Outline, OutlineSink, Path, Polygon, Stroke, StrokeStyle, Values, Vertex,
};

use crate::timing::timed;

const MAP: &str = include_str!("../../examples/assets/world.svg");

/// Rounds in which everybody has a turn.
const ROUNDS: u32 = 3;

/// The least time of a picture by each of both, one after the other in each round.
fn compare(name: &str, svg: &str) -> Result<(), Box<dyn Error>> {
    let tree = Tree::from_str(svg, &usvg::Options::default())?;
    let size = tree.size().to_int_size();
    let mut pixmap = Pixmap::new(size.width(), size.height()).ok_or("no pixels")?;
    let mut ours = Ours::new(&tree)?;
    let mut stored = Stored::new(&ours, false);
    let mut pieces = Stored::new(&ours, true);
    let mut best = [Duration::MAX; 4];
    for _ in 0..ROUNDS {
        let theirs = timed(|| resvg::render(&tree, tiny_skia::Transform::identity(), &mut pixmap.as_mut()));
        let mine = timed(|| ours.paint());
        let outlined = timed(|| stored.paint());
        let in_pieces = timed(|| pieces.paint());
        for (best, time) in best.iter_mut().zip([theirs, mine, outlined, in_pieces]) {
            *best = (*best).min(time);
        }
    }
    black_box(&pixmap);
    let [theirs, mine, outlined, in_pieces] = best.map(|time| time.as_secs_f64() * 1e3);
    let most = ours.difference(&pixmap);
    let [ratio, outlined_ratio, pieces_ratio] = [mine, outlined, in_pieces].map(|time| time / theirs);
    println!(
        "| {name} | {theirs:.2} ms | {mine:.2} ms | {ratio:.2} | {outlined:.2} ms | {outlined_ratio:.2} | {in_pieces:.2} ms | {pieces_ratio:.2} | {most} | {} | {} |",
        ours.edges.len(),
        stored.vertices
    );
    Ok(())
}

pub(crate) fn measure() -> Result<ExitCode, Box<dyn Error>> {
    println!(
        "| drawing | resvg | spanfill | ratio | outlined before | ratio | as convex pieces | ratio | pixels that differ by more than 24 of 255 | chains in a row | vertices |"
    );
    println!("|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|");
    compare("the bundled map", MAP)?;
    for samples in [500, 2_000] {
        compare(&format!("a signal of {samples} samples"), &trace(samples, 4.0))?;
    }
    compare("noise of 500 samples", &trace(500, 160.0))?;
    Ok(ExitCode::SUCCESS)
}

/// A slow wave with noise on it, 240 pixels wide.
fn trace(samples: u32, noise: f64) -> String {
    let mut state = 0x5EED_u64;
    let mut points = String::new();
    for sample in 0..samples {
        state = state.wrapping_mul(0x5851_F42D_4C95_7F2D).wrapping_add(99);
        let random = (state >> 40) as f64 / f64::from(1 << 24) - 0.5;
        let x = 40.0 + 240.0 * f64::from(sample) / f64::from(samples - 1);
        let wave = if noise < 100.0 { 60.0 * (x / 11.0).sin() } else { 0.0 };
        points += &format!("{x:.4},{:.4} ", 120.0 + wave + noise * random);
    }
    format!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" width="320" height="240"><polyline points="{points}" fill="none" stroke="#2b7bba" stroke-width="1.5" stroke-linejoin="round"/></svg>"##
    )
}

/// What is drawn, one over the other.
enum Item {
    Fill { elements: Vec<Element>, rule: FillRule, colour: Rgb888, opacity: u8 },
    Stroke { elements: Vec<Element>, style: StrokeStyle<'static>, width: f64, join: Join, colour: Rgb888, opacity: u8 },
}

struct Ours {
    items: Vec<Item>,
    edges: Vec<CoverageEdge>,
    frame: Framebuffer<Rgb888, Values, Vec<Rgb888>>,
}

impl Ours {
    fn new(tree: &Tree) -> Result<Self, Box<dyn Error>> {
        let size = tree.size().to_int_size();
        let (width, height) = (size.width(), size.height());
        let memory = vec![Rgb888::BLACK; (width * height) as usize];
        let mut items = vec![];
        add(tree.root(), &mut items)?;
        let chains = |item: &Item| match item {
            Item::Fill { elements, .. } => Path::new(elements).coverage_edges(),
            Item::Stroke { elements, style, .. } => {
                let stroke = Stroke::new(Path::new(elements), *style);
                stroke.coverage_edges().max(stroke.chains())
            }
        };
        let edges = items.iter().map(chains).max().unwrap_or(0);
        let frame = Framebuffer::new(memory, Size::new(width, height))?;
        Ok(Self { items, edges: vec![CoverageEdge::EMPTY; edges], frame })
    }

    fn paint(&mut self) {
        let Self { items, edges, frame } = self;
        for item in items {
            let Ok(()) = match item {
                Item::Fill { elements, rule, colour, opacity } => {
                    draw(Path::new(elements).outline().fill_rule(*rule), edges, (*colour, *opacity), frame)
                }
                Item::Stroke { elements, style, colour, opacity, .. } => {
                    draw(Stroke::new(Path::new(elements), *style), edges, (*colour, *opacity), frame)
                }
            };
        }
        black_box(&self.frame);
    }

    /// In how many pixels both pictures differ by more than anti-aliasing does.
    fn difference(&self, theirs: &Pixmap) -> usize {
        let width = theirs.width();
        let differs = |(index, pixel): (u32, &tiny_skia::PremultipliedColorU8)| {
            let ours = self.frame.pixel(Point::new((index % width) as i32, (index / width) as i32)).unwrap_or_default();
            let pairs = [(ours.r(), pixel.red()), (ours.g(), pixel.green()), (ours.b(), pixel.blue())];
            pairs.iter().any(|(a, b)| a.abs_diff(*b) > 24)
        };
        (0..).zip(theirs.pixels()).filter(|pixel| differs(*pixel)).count()
    }
}

/// The same with all outlines made before the clock starts: what drawing alone takes.
struct Stored {
    polygons: Vec<(Polygon<'static>, Rgb888, u8)>,
    vertices: usize,
    edges: Vec<CoverageEdge>,
    frame: Framebuffer<Rgb888, Values, Vec<Rgb888>>,
}

impl Stored {
    fn new(ours: &Ours, is_in_pieces: bool) -> Self {
        let polygon = |item: &Item| match item {
            Item::Fill { elements, rule, colour, opacity } => {
                (outlined(&Path::new(elements)).fill_rule(*rule), *colour, *opacity)
            }
            Item::Stroke { elements, width, join, colour, opacity, .. } if is_in_pieces => {
                (pieces(elements, *width, *join), *colour, *opacity)
            }
            Item::Stroke { elements, style, colour, opacity, .. } => {
                (outlined(&Stroke::new(Path::new(elements), *style)), *colour, *opacity)
            }
        };
        let polygons: Vec<_> = ours.items.iter().map(polygon).collect();
        let vertices = ours.items.iter().map(|item| match item {
            Item::Fill { elements, .. } => Path::new(elements).count().points,
            Item::Stroke { elements, style, .. } => Stroke::new(Path::new(elements), *style).count().points,
        });
        let size = ours.frame.size();
        let memory = vec![Rgb888::BLACK; (size.width * size.height) as usize];
        Self {
            vertices: vertices.sum(),
            edges: vec![
                CoverageEdge::EMPTY;
                polygons.iter().map(|item| item.0.coverage_edges_at_most()).max().unwrap_or(0)
            ],
            polygons,
            frame: Framebuffer::new(memory, size).expect("as large as the other"),
        }
    }

    fn paint(&mut self) {
        for (polygon, colour, opacity) in &self.polygons {
            let shape = polygon.coverage_in(&mut self.edges).expect("there is enough");
            let Ok(()) = shape.antialiased(*colour, InPlace).opacity(*opacity).draw_on(&mut self.frame);
        }
        black_box(&self.frame);
    }
}

/// A stroke of straight lines as a union of convex pieces: a rectangle for each line, a triangle or more for each corner;
/// without dashes and caps.
fn pieces(elements: &[Element], width: f64, join: Join) -> Polygon<'static> {
    type Vector = (f64, f64);
    let position = |point: FinePoint| (f64::from(point.x) / 4096.0, f64::from(point.y) / 4096.0);
    let mut contours: Vec<&'static [Vertex]> = vec![];
    let mut push = |points: &[Vector]| {
        contours.push(points.iter().map(|&(x, y)| Vertex::new(x, y)).collect::<Vec<_>>().leak());
    };
    let half = width / 2.0;
    let (mut start, mut at) = ((0.0, 0.0), (0.0, 0.0));
    let (mut first, mut before): (Option<Vector>, Option<Vector>) = (None, None);
    let corner = |push: &mut dyn FnMut(&[Vector]), (x, y): Vector, from: Vector, to: Vector| {
        let cross = from.0 * to.1 - from.1 * to.0;
        // The normals of the outer side, anticlockwise.
        let (a, b) = if cross < 0.0 { (from, to) } else { ((-to.0, -to.1), (-from.0, -from.1)) };
        let (sum, cosine) = ((a.0 + b.0, a.1 + b.1), a.0 * b.0 + a.1 * b.1);
        let mut points = vec![(x, y), (x + half * a.0, y + half * a.1)];
        match join {
            Join::Round => {
                let angle = cosine.clamp(-1.0, 1.0).acos();
                let parts = (angle / 0.2).ceil().max(1.0) as u32;
                for part in 1..parts {
                    let (sin, cos) = (-angle * f64::from(part) / f64::from(parts)).sin_cos();
                    points.push((x + half * (a.0 * cos - a.1 * sin), y + half * (a.0 * sin + a.1 * cos)));
                }
            }
            Join::Miter { .. } if cosine > -0.875 => {
                let scale = half / (1.0 + cosine);
                points.push((x + sum.0 * scale, y + sum.1 * scale));
            }
            _ => {}
        }
        points.push((x + half * b.0, y + half * b.1));
        push(&points);
    };
    for element in elements {
        let to = match *element {
            Element::Move(to) => {
                (start, at, first, before) = (position(to), position(to), None, None);
                continue;
            }
            Element::Close => start,
            Element::Line(to) | Element::Quadratic(_, to) | Element::Cubic(_, _, to) => position(to),
            Element::Arc(arc) => position(arc.to),
        };
        let (dx, dy) = (to.0 - at.0, to.1 - at.1);
        let length = dx.hypot(dy);
        if length > 0.0 {
            let n = (-dy / length, dx / length);
            let (x, y) = (half * n.0, half * n.1);
            push(&[(at.0 + x, at.1 + y), (to.0 + x, to.1 + y), (to.0 - x, to.1 - y), (at.0 - x, at.1 - y)]);
            if let Some(before) = before {
                corner(&mut push, at, before, n);
            }
            first = first.or(Some(n));
            (before, at) = (Some(n), to);
        }
        if let (Element::Close, Some(before), Some(first)) = (element, before, first) {
            corner(&mut push, start, before, first);
        }
    }
    Polygon::with_contours(contours.leak())
}

fn outlined(outline: &impl Outline) -> Polygon<'static> {
    #[derive(Default)]
    struct Contours(Vec<&'static [Vertex]>, Vec<Vertex>);

    impl OutlineSink for Contours {
        fn point(&mut self, x: i64, y: i64) {
            self.1.push(FinePoint::from_bits(x as i32, y as i32).to_vertex());
        }

        fn close(&mut self) {
            self.0.push(std::mem::take(&mut self.1).leak());
        }
    }

    // Kept until the program ends, as constants are.
    let mut contours = Contours::default();
    outline.emit(&mut contours);
    Polygon::with_contours(contours.0.leak())
}

fn draw<O: Outline>(
    outline: O,
    edges: &mut [CoverageEdge],
    (colour, opacity): (Rgb888, u8),
    frame: &mut Framebuffer<Rgb888, Values, Vec<Rgb888>>,
) -> Result<(), Infallible> {
    let shape = outline.coverage_in(edges).expect("there is enough");
    shape.antialiased(colour, InPlace).opacity(opacity).draw_on(frame)
}

/// What a group shows, in colours without gradients.
fn add(group: &usvg::Group, items: &mut Vec<Item>) -> Result<(), Box<dyn Error>> {
    for node in group.children() {
        let path = match node {
            Node::Group(group) => {
                add(group, items)?;
                continue;
            }
            Node::Path(path) if path.is_visible() => path,
            _ => continue,
        };
        let transform = path.abs_transform();
        let elements = elements(path.data(), transform);
        let colour = |paint: &Paint| match paint {
            Paint::Color(color) => Ok(Rgb888::new(color.red, color.green, color.blue)),
            _ => Err("only colours"),
        };
        if let Some(fill) = path.fill() {
            let rule = match fill.rule() {
                usvg::FillRule::NonZero => FillRule::NonZero,
                usvg::FillRule::EvenOdd => FillRule::EvenOdd,
            };
            let (colour, opacity) = (colour(fill.paint())?, fill.opacity().to_u8());
            items.push(Item::Fill { elements: elements.clone(), rule, colour, opacity });
        }
        if let Some(stroke) = path.stroke() {
            let (colour, opacity) = (colour(stroke.paint())?, stroke.opacity().to_u8());
            let width = f64::from(stroke.width().get() * transform.get_scale().0);
            let (style, join) = style(stroke, transform.get_scale().0);
            items.push(Item::Stroke { elements, style, width, join, colour, opacity });
        }
    }
    Ok(())
}

fn style(stroke: &usvg::Stroke, scale: f32) -> (StrokeStyle<'static>, Join) {
    let cap = match stroke.linecap() {
        usvg::LineCap::Butt => Cap::Butt,
        usvg::LineCap::Round => Cap::Round,
        usvg::LineCap::Square => Cap::Square,
    };
    let join = match stroke.linejoin() {
        usvg::LineJoin::Round => Join::Round,
        usvg::LineJoin::Bevel => Join::Bevel,
        _ => Join::Miter { limit: (stroke.miterlimit().get() * 256.0).round() as u32 },
    };
    let bits = |length: f32| (length * scale * 256.0).round();
    let dashes: Vec<u32> = stroke.dasharray().unwrap_or_default().iter().map(|&length| bits(length) as u32).collect();
    let style = StrokeStyle::new(bits(stroke.width().get()) as u32).cap(cap).join(join);
    (style.dashes(dashes.leak()).phase(bits(stroke.dashoffset()) as i32), join)
}

fn elements(path: &tiny_skia::Path, transform: tiny_skia::Transform) -> Vec<Element> {
    use tiny_skia::PathSegment;
    let fine = |mut point: tiny_skia::Point| {
        transform.map_point(&mut point);
        FinePoint::new(point.x, point.y)
    };
    let element = |segment| match segment {
        PathSegment::MoveTo(to) => Element::Move(fine(to)),
        PathSegment::LineTo(to) => Element::Line(fine(to)),
        PathSegment::QuadTo(control, to) => Element::Quadratic(fine(control), fine(to)),
        PathSegment::CubicTo(a, b, to) => Element::Cubic(fine(a), fine(b), fine(to)),
        PathSegment::Close => Element::Close,
    };
    path.segments().map(element).collect()
}
