//! Which pixels belong to a shape: `docs/NUMERICS.md`, "The pixel rule", one pixel at a time.
//!
//! Everything is in sub-pixels, 256 to the pixel: coordinates have 32 bits, pixel centres 40 (a pixel's number is any
//! `i32`), their differences 41, all in an `i64`; products go to an `i128`. Nothing is divided and nothing is rounded.

use std::cmp::Ordering;

use spanfill::{ActiveEdge, BlockSink, Circle, FillRule, Line, PixelRect, Polygon, Shape, SpanSink, Triangle, Vertex};

/// A point in sub-pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct At {
    pub(crate) x: i64,
    pub(crate) y: i64,
}

impl From<Vertex> for At {
    fn from(vertex: Vertex) -> Self {
        Self { x: vertex.x.to_bits().into(), y: vertex.y.to_bits().into() }
    }
}

/// The centre of a pixel.
pub(crate) fn centre(column: i32, row: i32) -> At {
    At { x: 256 * i64::from(column) + 128, y: 256 * i64::from(row) + 128 }
}

/// A product of coordinates, with all of its bits.
pub(crate) fn product(a: i64, b: i64) -> i128 {
    i128::from(a) * i128::from(b)
}

/// Which side of the line a -> b `p` lies on, by sign, and how far, in units that depend on the line; 0 is on it.
pub(crate) fn cross(a: At, b: At, p: At) -> i128 {
    product(b.x - a.x, p.y - a.y) - product(b.y - a.y, p.x - a.x)
}

/// The side of the directed line a -> b on which `p` lies once it is moved by (+e, +e^2): 1 or -1, 0 only if a == b.
///
/// The cross product of the moved point is `cross - dy * e + dx * e^2`. With e infinitesimal, the first of the three
/// terms that is not zero decides.
pub(crate) fn side(a: At, b: At, p: At) -> i64 {
    match cross(a, b, p).cmp(&0) {
        Ordering::Greater => 1,
        Ordering::Less => -1,
        Ordering::Equal if a.y == b.y => (b.x - a.x).signum(),
        Ordering::Equal => (a.y - b.y).signum(),
    }
}

/// The edges that cross the row of centres at `y` once that is moved down by e^2: the row lies below every vertex whose
/// y is its own.
fn crossing_edges(contours: &[Vec<Vertex>], y: i64) -> impl Iterator<Item = (At, At)> {
    contours.iter().flat_map(|contour| edges(contour)).filter(move |(a, b)| (a.y <= y) != (b.y <= y))
}

/// What an edge that crosses the row of `p` adds to the winding number: the ray from `p` to the right meets it going
/// down or up, or does not meet it.
fn crossing((a, b): (At, At), p: At) -> i64 {
    let direction = if a.y < b.y { 1 } else { -1 };
    if side(a, b, p) == direction { direction } else { 0 }
}

/// The winding number of closed contours around `p` moved by (+e, +e^2): the signed crossings of the ray from there
/// to the right.
pub(crate) fn winding(contours: &[Vec<Vertex>], p: At) -> i64 {
    crossing_edges(contours, p.y).map(|edge| crossing(edge, p)).sum()
}

/// The same number from the ray downwards: another set of comparisons, to hold [`winding`] against.
pub(crate) fn winding_by_vertical_ray(contours: &[Vec<Vertex>], p: At) -> i64 {
    let mut winding = 0;
    for (a, b) in contours.iter().flat_map(|contour| edges(contour)) {
        let rightwards = a.x <= p.x && p.x < b.x;
        let leftwards = b.x <= p.x && p.x < a.x;
        // The edge is below the point when the point is above the edge.
        if rightwards && side(a, b, p) < 0 {
            winding -= 1;
        }
        if leftwards && side(a, b, p) > 0 {
            winding += 1;
        }
    }
    winding
}

/// The edges of a closed contour.
pub(crate) fn edges(contour: &[Vertex]) -> impl Iterator<Item = (At, At)> {
    let following = contour.iter().skip(1).chain(contour.first());
    contour.iter().zip(following).map(|(a, b)| (At::from(*a), At::from(*b)))
}

/// The rule of one shape.
pub(crate) trait Belongs {
    /// Whether the pixel is one of the shape's.
    fn has(&self, column: i32, row: i32) -> bool;

    /// The same for all the pixels of a row; for rules where a row decides something for all of them.
    fn has_in_row(&self, row: i32) -> impl Fn(i32) -> bool {
        move |column| self.has(column, row)
    }

    /// The shape as Rust code, to the last bit.
    fn code(&self) -> String;
}

impl Belongs for Triangle {
    /// Inside is the same side of all three edges. No point is on the same side of all three when they are collinear.
    fn has(&self, column: i32, row: i32) -> bool {
        let [a, b, c] = self.vertices.map(At::from);
        let p = centre(column, row);
        let first = side(a, b, p);
        first != 0 && side(b, c, p) == first && side(c, a, p) == first
    }

    fn code(&self) -> String {
        format!("Triangle::from_vertices({})", vertices_code(&self.vertices))
    }
}

impl Belongs for Circle {
    fn has(&self, column: i32, row: i32) -> bool {
        let (center, radius) = (At::from(self.center), i64::from(self.radius.to_bits()));
        let p = centre(column, row);
        let (dx, dy) = (p.x - center.x, p.y - center.y);
        radius > 0 && product(dx, dx) + product(dy, dy) < product(radius, radius)
    }

    fn code(&self) -> String {
        format!("Circle::from_bits({}, {})", vertex_code(self.center), self.radius.to_bits())
    }
}

impl Belongs for Line {
    fn has(&self, column: i32, row: i32) -> bool {
        let (a, b) = (At::from(self.start), At::from(self.end));
        if (b.x - a.x).abs() >= (b.y - a.y).abs() {
            steps_have((a.x, a.y), (b.x, b.y), column.into(), row.into())
        } else {
            steps_have((a.y, a.x), (b.y, b.x), row.into(), column.into())
        }
    }

    fn code(&self) -> String {
        format!("Line::new({}, {})", vertex_code(self.start), vertex_code(self.end))
    }
}

/// A line's rule, points as (major, minor): whether the pixel `step` along the major axis and `across` it is drawn.
fn steps_have(start: (i64, i64), end: (i64, i64), step: i64, across: i64) -> bool {
    let holds = |pixel: i64, at: i64| 256 * pixel <= at && at < 256 * (pixel + 1);
    if start == end {
        return holds(step, start.0) && holds(across, start.1);
    }
    let ((major, minor), (last_major, last_minor)) = if start.0 < end.0 { (start, end) } else { (end, start) };
    // From the step that holds one end to the step that holds the other, both included.
    if 256 * (step + 1) <= major || last_major < 256 * step {
        return false;
    }
    // 256 across <= minor + (centre - major) * slope < 256 (across + 1), times the length, which is positive.
    let (length, rise) = (last_major - major, last_minor - minor);
    let minor_at_centre = product(minor, length) + product(256 * step + 128 - major, rise);
    product(256 * across, length) <= minor_at_centre && minor_at_centre < product(256 * (across + 1), length)
}

/// A polygon that owns its contours: the rule of a polygon, and the crate's polygon in a scratch of exactly the size
/// it asks for.
#[derive(Debug, Clone)]
pub(crate) struct Outline {
    pub(crate) contours: Vec<Vec<Vertex>>,
    pub(crate) fill_rule: FillRule,
}

impl Outline {
    pub(crate) fn new(contours: Vec<Vec<Vertex>>, fill_rule: FillRule) -> Self {
        Self { contours, fill_rule }
    }

    pub(crate) fn of(contour: &[Vertex], fill_rule: FillRule) -> Self {
        Self::new(vec![contour.to_vec()], fill_rule)
    }

    /// Hands the crate's polygon to `look`.
    pub(crate) fn with_polygon<R>(&self, look: impl FnOnce(Polygon<'_>) -> R) -> R {
        let contours: Vec<&[Vertex]> = self.contours.iter().map(Vec::as_slice).collect();
        look(Polygon::with_contours(&contours).fill_rule(self.fill_rule))
    }

    /// What `active_edges` has to answer: the most edges that cross one row of centres.
    ///
    /// The number can only grow at the first row of an edge, so that those rows are all there is to try.
    pub(crate) fn most_edges_on_a_row(&self) -> usize {
        let edges: Vec<(At, At)> = self.contours.iter().flat_map(|contour| edges(contour)).collect();
        let crossings = |y: i64| edges.iter().filter(|(a, b)| a.y.min(b.y) <= y && y < a.y.max(b.y)).count();
        // `>> 8` rounds down: the first centre at or below y.
        let first_centre = |y: i64| (((y + 127) >> 8) << 8) + 128;
        edges.iter().map(|(a, b)| crossings(first_centre(a.y.min(b.y)))).max().unwrap_or(0)
    }
}

impl Belongs for Outline {
    fn has(&self, column: i32, row: i32) -> bool {
        self.has_in_row(row)(column)
    }

    fn has_in_row(&self, row: i32) -> impl Fn(i32) -> bool {
        let edges: Vec<(At, At)> = crossing_edges(&self.contours, centre(0, row).y).collect();
        move |column| {
            let p = centre(column, row);
            let winding: i64 = edges.iter().map(|edge| crossing(*edge, p)).sum();
            match self.fill_rule {
                FillRule::NonZero => winding != 0,
                FillRule::EvenOdd => winding & 1 == 1,
            }
        }
    }

    fn code(&self) -> String {
        let contours: Vec<String> =
            self.contours.iter().map(|contour| format!("&{}", vertices_code(contour))).collect();
        format!("Polygon::with_contours(&[{}]).fill_rule(FillRule::{:?})", contours.join(", "), self.fill_rule)
    }
}

impl Shape for Outline {
    fn bounds(&self) -> PixelRect {
        self.with_polygon(|polygon| {
            let mut scratch = vec![ActiveEdge::EMPTY; polygon.active_edges()];
            polygon.in_scratch(&mut scratch).expect("a scratch of the size asked for").bounds()
        })
    }

    fn spans<S: SpanSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.with_polygon(|polygon| {
            let mut scratch = vec![ActiveEdge::EMPTY; polygon.active_edges()];
            polygon.in_scratch(&mut scratch).expect("a scratch of the size asked for").spans(clip, sink)
        })
    }

    fn blocks<S: BlockSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.with_polygon(|polygon| {
            let mut scratch = vec![ActiveEdge::EMPTY; polygon.active_edges()];
            polygon.in_scratch(&mut scratch).expect("a scratch of the size asked for").blocks(clip, sink)
        })
    }
}

pub(crate) fn vertex_code(vertex: Vertex) -> String {
    format!("Vertex::from_bits({}, {})", vertex.x.to_bits(), vertex.y.to_bits())
}

fn vertices_code(vertices: &[Vertex]) -> String {
    let vertices: Vec<String> = vertices.iter().map(|vertex| vertex_code(*vertex)).collect();
    format!("[{}]", vertices.join(", "))
}
