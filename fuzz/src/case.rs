//! What is drawn, and where: made of bytes, or smaller than what has failed.

use spanfill::{
    Circle, Cover, CoverageEdge, CoverageSink, FillRule, Line, PixelRect, Polygon, TooManyEdges, Triangle, Vertex,
};

use crate::{
    oracle::{Belongs, Outline},
    outlines::{self, At, Extent},
    source::Source,
};

/// A shape of the crate's.
#[derive(Debug, Clone)]
pub(crate) enum Figure {
    Outline(Outline),
    Triangle(Triangle),
    Line(Line),
    Circle(Circle),
}

/// A shape, what is seen of it, and how that is cut.
#[derive(Debug, Clone)]
pub(crate) struct Case {
    pub(crate) figure: Figure,
    pub(crate) window: PixelRect,
    /// Where the window is cut in two, each way.
    pub(crate) column: i32,
    pub(crate) row: i32,
    /// Slots of scratch beyond what is asked for.
    pub(crate) more: usize,
    pub(crate) opacity: u8,
}

/// How large what is drawn may be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Size {
    /// A few pixels are seen, of a few edges.
    Small,
    /// Up to a few thousand pixels are seen, of up to two hundred edges.
    Any,
}

/// The nearest coordinate there is.
fn vertex((x, y): At) -> Vertex {
    let saturated = |bits: i64| bits.clamp(i32::MIN.into(), i32::MAX.into()) as i32;
    Vertex::from_bits(saturated(x), saturated(y))
}

/// Most of them near the origin, the others at both ends of the range, where arithmetic changes its width, and anywhere.
fn place(source: &mut Source<'_>) -> At {
    let coordinate = |source: &mut Source<'_>| match source.int(0..=7) {
        0 | 1 => source.int(0..=4096),
        2 | 3 => source.pick(&[i64::from(i32::MIN), i64::from(i32::MAX)]) + source.int(-1024..=1024),
        4 | 5 => source.pick(&[-1, 1]) * (1 << source.int(12..=30)) + source.int(-1024..=1024),
        6 => 256 * source.int(-16..=16),
        _ => source.int(i32::MIN.into()..=i32::MAX.into()),
    };
    match source.int(0..=15) {
        0 => (coordinate(source), coordinate(source)),
        1..=5 => (0, 0),
        _ => (source.int(0..=4096), source.int(0..=4096)),
    }
}

impl Case {
    pub(crate) fn decode(bytes: &[u8], size: Size) -> Self {
        let source = &mut Source::new(bytes);
        let (bits, extent) = match size {
            Size::Small => {
                let bits = source.pick(&[5, 6, 7, 7, 8, 8, 8, 9, 9, 10]);
                (bits, Extent { reach: 0, vertices: source.pick(&[4, 5, 6, 9]), contours: 3 })
            }
            Size::Any => {
                let vertices = source.pick(&[6, 12, 30, 200]);
                (source.int(6..=14), Extent { reach: 0, vertices, contours: 12 })
            }
        };
        let reach = (1 << bits) - source.int(0..=(1 << (bits - 1)) - 1);
        let middle = place(source);
        let placed = |at: At| vertex((middle.0 + at.0, middle.1 + at.1));
        let near = |source: &mut Source<'_>| placed((source.int(-reach..=reach), source.int(-reach..=reach)));
        let any = |source: &mut Source<'_>| {
            if source.one_in(16) { placed((source.magnitude(32), source.magnitude(32))) } else { near(source) }
        };
        let figure = match source.int(0..=11) {
            0 => Figure::Line(Line::new(any(source), any(source))),
            1 => Figure::Triangle(Triangle::from_vertices([any(source), any(source), any(source)])),
            2 => {
                let radius = if source.one_in(4) { source.magnitude(31) } else { source.int(0..=reach) };
                // A large one has its rim where the window is.
                let from = if radius > 2 * reach { source.pick(&[(1, 0), (0, 1), (-1, 0), (0, -1)]) } else { (0, 0) };
                let by = (source.int(-reach..=reach) + from.0 * radius, source.int(-reach..=reach) + from.1 * radius);
                Figure::Circle(Circle::from_bits(placed(by), radius.min(i32::MAX.into()) as i32))
            }
            _ => {
                let contours = outlines::contours(source, Extent { reach, ..extent });
                let contours = contours.into_iter().map(|contour| contour.into_iter().map(placed).collect()).collect();
                let rule = source.pick(&[FillRule::NonZero, FillRule::EvenOdd]);
                Figure::Outline(Outline::new(contours, rule))
            }
        };
        let (width, height) = if size == Size::Small { (10, 8) } else { (80, 60) };
        let side = |source: &mut Source<'_>, middle: i64, most: i64| {
            let around = (2 * reach / 256 + 3).min(most);
            let length = if source.one_in(4) { source.int(1..=around) } else { around };
            let start = (middle >> 8) - length / 2 + source.int(-1..=1);
            let start = start.clamp((i32::MIN >> 8).into(), i64::from(i32::MAX >> 8) + 1 - length) as i32;
            start..start + length as i32
        };
        let window = PixelRect { columns: side(source, middle.0, width), rows: side(source, middle.1, height) };
        let column = source.int(window.columns.start.into()..=window.columns.end.into()) as i32;
        let row = source.int(window.rows.start.into()..=window.rows.end.into()) as i32;
        let more = source.count(0..=9);
        let opacity = if source.one_in(3) { source.int(1..=255) as u8 } else { 255 };
        Self { figure, window, column, row, more, opacity }
    }

    /// The window's parts; some may be empty.
    pub(crate) fn parts(&self) -> [PixelRect; 4] {
        let PixelRect { rows, columns } = &self.window;
        let (above, below) = (rows.start..self.row, self.row..rows.end);
        let (left, right) = (columns.start..self.column, self.column..columns.end);
        [
            PixelRect { rows: above.clone(), columns: left.clone() },
            PixelRect { rows: above, columns: right.clone() },
            PixelRect { rows: below.clone(), columns: left },
            PixelRect { rows: below, columns: right },
        ]
    }

    /// As Rust code, to the last bit.
    pub(crate) fn code(&self) -> String {
        let shape = match &self.figure {
            Figure::Outline(outline) => outline.code(),
            Figure::Triangle(triangle) => triangle.code(),
            Figure::Line(line) => line.code(),
            Figure::Circle(circle) => circle.code(),
        };
        let PixelRect { rows, columns } = &self.window;
        format!(
            "let shape = {shape};\nlet window = PixelRect {{ rows: {rows:?}, columns: {columns:?} }};\n\
             // cut at column {}, row {}; {} more slots than needed; opacity {}",
            self.column, self.row, self.more, self.opacity
        )
    }
}

impl Figure {
    /// Anti-aliased, with `more` slots of scratch than it asks for.
    pub(crate) fn cover<S: CoverageSink>(&self, more: usize, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        match self {
            Self::Outline(outline) => outline.with_polygon(|polygon| {
                let mut edges = vec![CoverageEdge::EMPTY; polygon.coverage_edges() + more];
                polygon.coverage_in(&mut edges).expect("as much as it asks for").coverage(clip, sink)
            }),
            Self::Triangle(triangle) => triangle.coverage(clip, sink),
            Self::Line(line) => line.coverage(clip, sink),
            Self::Circle(circle) => circle.coverage(clip, sink),
        }
    }

    /// With too little scratch there is an error that says so, and nothing to draw.
    pub(crate) fn check_refusals(&self) -> Result<(), String> {
        let Self::Outline(outline) = self else { return Ok(()) };
        outline.with_polygon(|polygon: Polygon<'_>| {
            let needed = polygon.coverage_edges();
            let at_most = polygon.coverage_edges_at_most();
            let sorted = polygon.coverage_edges_in(&mut vec![0; at_most]);
            if sorted != needed || at_most < needed {
                return Err(format!("{needed} edges are needed; by sorting {sorted}, at most {at_most}"));
            }
            let Some(available) = needed.checked_sub(1) else { return Ok(()) };
            let mut edges = vec![CoverageEdge::EMPTY; available];
            match polygon.coverage_in(&mut edges) {
                Err(TooManyEdges { needed: n, available: a }) if (n, a) == (needed, available) => Ok(()),
                other => Err(format!("{available} slots where {needed} are needed gave {other:?}")),
            }
        })
    }
}
