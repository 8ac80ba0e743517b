//! How much of a pixel a shape covers, without a line of code in common with `src/`.
//!
//! Outlines are cut into slabs between all the heights at which anything can change: vertices, crossings of two edges,
//! crossings of an edge and a side of the pixel. Within a slab the edges keep their order, so that the middle of the
//! slab gives its area. Everything is an integer: the heights are exact quotients rounded down to 2^-48 sub-pixels, and
//! what the rounding can cost is added up. Triangles and lines are the pixel cut by half-planes, circles the pixel's
//! part of a disc in closed form, both in `f64` from exact integers.

use std::{cmp::Ordering, ops::Range};

use spanfill::{Circle, FillRule, Line, Triangle, Vertex};

use super::rule::{At, Outline, cross, edges, product};

/// The share of a pixel, 0 to 1: the truth is at most `error` away from `value`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Area {
    pub(crate) value: f64,
    pub(crate) error: f64,
    /// How many edges lead through the pixel; with none it is exactly empty or full.
    pub(crate) edges: usize,
}

impl Area {
    pub(crate) fn whole(inside: bool) -> Self {
        Self { value: f64::from(u8::from(inside)), error: 0.0, edges: 0 }
    }
}

/// A shape whose areas are known.
pub(crate) trait HasArea {
    /// One for each pixel of a row.
    fn areas_in_row(&self, row: i32, columns: &Range<i32>) -> Vec<Area>;
}

/// Sub-pixels to the pixel.
const ONE: i64 = 256;

/// Bits of a sub-pixel in the heights of slabs. Their middles, and the columns there, have one more.
const HEIGHT_BITS: u32 = 48;
const MIDDLE_BITS: u32 = HEIGHT_BITS + 1;

/// The height of a row.
const ROW: i128 = (ONE as i128) << HEIGHT_BITS;
/// The width of a pixel.
const WIDTH: i128 = (ONE as i128) << MIDDLE_BITS;

/// An edge, relative to the top of a row. A horizontal one changes nothing but what is to the left of it, at its height.
#[derive(Debug, Clone, Copy)]
struct Edge {
    top: At,
    bottom: At,
    /// 1 if the contour goes down here, -1 if up.
    winding: i64,
    /// Whole sub-pixels between which it lies within the row.
    reach: (i64, i64),
}

impl Edge {
    /// The edge from `a` to `b`, if it leads through the row.
    fn within_row(a: At, b: At, row: i32) -> Option<Self> {
        let lowered = |p: At| At { x: p.x, y: p.y - ONE * i64::from(row) };
        let (top, bottom) = if a.y < b.y { (lowered(a), lowered(b)) } else { (lowered(b), lowered(a)) };
        if bottom.y <= 0 || top.y >= ONE {
            return None;
        }
        if top.y == bottom.y {
            return Some(Self { top, bottom, winding: 0, reach: (a.x.min(b.x), a.x.max(b.x)) });
        }
        let (dx, dy) = (i128::from(bottom.x - top.x), i128::from(bottom.y - top.y));
        // The numerator of the column at a height, and its quotient rounded down and up.
        let ends = [top.y.max(0), bottom.y.min(ONE)].map(|y| i128::from(top.x) * dy + i128::from(y - top.y) * dx);
        let least = ends[0].min(ends[1]).div_euclid(dy);
        let most = -(-ends[0].max(ends[1])).div_euclid(dy);
        Some(Self { top, bottom, winding: if a.y < b.y { 1 } else { -1 }, reach: (least as i64, most as i64) })
    }

    fn dx(&self) -> i128 {
        i128::from(self.bottom.x - self.top.x)
    }

    fn dy(&self) -> i128 {
        i128::from(self.bottom.y - self.top.y)
    }

    fn spans(&self, middle: i128) -> bool {
        i128::from(self.top.y) << MIDDLE_BITS <= middle && middle < i128::from(self.bottom.y) << MIDDLE_BITS
    }

    /// The height at which the edge's line is at `x`, unless that is outside the row.
    fn height_at(&self, x: i64) -> Option<i128> {
        let (dx, run) = (self.dx(), i128::from(x - self.top.x));
        if dx == 0 || run.signum() != dx.signum() || run.abs() >= dx.abs() {
            return None;
        }
        // |run dy| < 2^66.
        let below = ((run * self.dy() * dx.signum()) << HEIGHT_BITS).div_euclid(dx.abs());
        Some((i128::from(self.top.y) << HEIGHT_BITS) + below)
    }

    /// The height at which two edges cross, unless that is outside the row or they never do.
    fn height_of_crossing(&self, other: &Self) -> Option<i128> {
        if self.reach.1 <= other.reach.0 || other.reach.1 <= self.reach.0 {
            return None;
        }
        let mut turn = self.dx() * other.dy() - other.dx() * self.dy();
        if turn == 0 {
            return None;
        }
        let apart =
            i128::from(other.top.x - self.top.x) * other.dy() - i128::from(other.top.y - self.top.y) * other.dx();
        // |apart| < 2^67 and |turn| < 2^66, so that this stays below 2^101.
        let mut height = apart * self.dy() + i128::from(self.top.y) * turn;
        if turn < 0 {
            (turn, height) = (-turn, -height);
        }
        let top = self.top.y.max(other.top.y).max(0);
        let bottom = self.bottom.y.min(other.bottom.y).min(ONE);
        if height <= i128::from(top) * turn || i128::from(bottom) * turn <= height {
            return None;
        }
        // In the row, |height| < 2^8 |turn|.
        Some((height << HEIGHT_BITS) / turn)
    }

    /// The column at the middle of a slab, relative to `left`: rounded down, and the rest of the division by `dy`.
    fn column_at(&self, middle: i128, left: i64) -> (i128, i128) {
        let down = middle - (i128::from(self.top.y) << MIDDLE_BITS);
        // |down| < 2^(33 + 49) and |dx| < 2^33.
        let column = down * self.dx() + ((i128::from(self.top.x - left) * self.dy()) << MIDDLE_BITS);
        (column.div_euclid(self.dy()), column.rem_euclid(self.dy()))
    }
}

/// The integral of a function of the winding number over each pixel of a row.
pub(crate) fn weighted_areas(
    contours: &[Vec<Vertex>],
    row: i32,
    columns: &Range<i32>,
    weight: impl Fn(i64) -> i64,
) -> Vec<Area> {
    let in_row: Vec<Edge> =
        contours.iter().flat_map(|contour| edges(contour)).filter_map(|(a, b)| Edge::within_row(a, b, row)).collect();
    columns
        .clone()
        .map(|column| {
            let left = ONE * i64::from(column);
            let to_the_left = in_row.iter().filter(|edge| edge.reach.1 <= left);
            let within = in_row.iter().filter(|edge| edge.reach.1 > left && edge.reach.0 < left + ONE);
            let to_the_left: Vec<Edge> = to_the_left.copied().collect();
            let within: Vec<Edge> = within.copied().collect();
            pixel_area(&to_the_left, &within, left, &weight)
        })
        .collect()
}

/// Edges to the right of the pixel do not matter: the winding number is counted from the left.
fn pixel_area(to_the_left: &[Edge], within: &[Edge], left: i64, weight: &impl Fn(i64) -> i64) -> Area {
    let mut heights = vec![0, ROW];
    for (index, edge) in within.iter().enumerate() {
        heights.extend([edge.top.y, edge.bottom.y].map(|y| i128::from(y) << HEIGHT_BITS));
        heights.extend([left, left + ONE].into_iter().filter_map(|x| edge.height_at(x)));
        heights.extend(within[..index].iter().filter_map(|other| edge.height_of_crossing(other)));
    }
    heights.retain(|height| (0..=ROW).contains(height));
    heights.sort_unstable();
    heights.dedup();
    let (mut sum, mut order) = (0, Vec::new());
    for slab in heights.windows(2) {
        let (height, middle) = (slab[1] - slab[0], slab[0] + slab[1]);
        order.clear();
        order.extend(within.iter().filter(|edge| edge.spans(middle)).map(|edge| (edge.column_at(middle, left), edge)));
        order.sort_unstable_by(|((a, a_rest), a_edge), ((b, b_rest), b_edge)| {
            a.cmp(b).then_with(|| (a_rest * b_edge.dy()).cmp(&(b_rest * a_edge.dy())))
        });
        let mut winding = to_the_left.iter().filter(|edge| edge.spans(middle)).map(|edge| edge.winding).sum();
        let mut from = 0;
        for ((column, _), edge) in &order {
            let to = (*column).clamp(0, WIDTH);
            sum += i128::from(weight(winding)) * (to - from) * height;
            from = to;
            winding += edge.winding;
        }
        sum += i128::from(weight(winding)) * (WIDTH - from) * height;
    }
    // A slab is wrong at most where its ends were rounded, by the width of the pixel; a column by its own last bit.
    let error = ((2 * heights.len() + within.len()) as f64) / ROW as f64;
    let error = if within.is_empty() { 0.0 } else { error + f64::EPSILON };
    Area { value: sum as f64 / (ROW * WIDTH) as f64, error, edges: within.len() }
}

impl HasArea for Outline {
    fn areas_in_row(&self, row: i32, columns: &Range<i32>) -> Vec<Area> {
        match self.fill_rule {
            FillRule::NonZero => weighted_areas(&self.contours, row, columns, |winding| i64::from(winding != 0)),
            FillRule::EvenOdd => weighted_areas(&self.contours, row, columns, |winding| winding & 1),
        }
    }
}

/// Where `corner + (x along_x + y along_y)` is not negative; x and y in pixels from the pixel's upper left corner.
#[derive(Debug, Clone, Copy)]
struct HalfPlane {
    corner: f64,
    along_x: f64,
    along_y: f64,
}

impl HalfPlane {
    /// From what can be large and has to be exact: the value at the corner, and its growth per sub-pixel.
    fn new(corner: i128, along_x: i64, along_y: i64) -> Self {
        let per_pixel = |growth: i64| (i128::from(ONE) * i128::from(growth)) as f64;
        Self { corner: corner as f64, along_x: per_pixel(along_x), along_y: per_pixel(along_y) }
    }

    fn at(&self, (x, y): (f64, f64)) -> f64 {
        self.corner + (x * self.along_x + y * self.along_y)
    }
}

const CORNERS: [(f64, f64); 4] = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)];

/// What half-planes leave of the pixel.
///
/// A half-plane whose border leads through the pixel is off by some 2^-50 of its growth over the pixel: 2^-50 pixels.
fn area_within(planes: &[HalfPlane]) -> Area {
    let is_cut = |plane: &HalfPlane| {
        let inside = CORNERS.map(|corner| plane.at(corner) >= 0.0);
        inside != [true; 4] && inside != [false; 4]
    };
    let mut rim = CORNERS.to_vec();
    for plane in planes {
        let mut kept = Vec::with_capacity(rim.len() + 1);
        for (index, from) in rim.iter().enumerate() {
            let to = rim[(index + 1) % rim.len()];
            let (here, there) = (plane.at(*from), plane.at(to));
            if here >= 0.0 {
                kept.push(*from);
            }
            if (here >= 0.0) != (there >= 0.0) {
                let share = here / (here - there);
                kept.push((from.0 + share * (to.0 - from.0), from.1 + share * (to.1 - from.1)));
            }
        }
        rim = kept;
    }
    let edges = if rim.is_empty() { 0 } else { planes.iter().filter(|plane| is_cut(plane)).count() };
    Area { value: enclosed(&rim), error: if edges == 0 { 0.0 } else { 1e-12 }, edges }
}

/// The area within a closed contour.
fn enclosed(rim: &[(f64, f64)]) -> f64 {
    let following = rim.iter().skip(1).chain(rim.first());
    rim.iter().zip(following).map(|(from, to)| from.0 * to.1 - to.0 * from.1).sum::<f64>() / 2.0
}

fn corner_of(column: i32, row: i32) -> At {
    At { x: ONE * i64::from(column), y: ONE * i64::from(row) }
}

impl HasArea for Triangle {
    fn areas_in_row(&self, row: i32, columns: &Range<i32>) -> Vec<Area> {
        let [a, b, c] = self.vertices.map(At::from);
        let corners = match cross(a, b, c).cmp(&0) {
            Ordering::Greater => [a, b, c],
            Ordering::Less => [a, c, b],
            Ordering::Equal => return vec![Area::whole(false); columns.len()],
        };
        let planes = |column| {
            [0, 1, 2].map(|index| {
                let (from, to) = (corners[index], corners[(index + 1) % 3]);
                HalfPlane::new(cross(from, to, corner_of(column, row)), from.y - to.y, to.x - from.x)
            })
        };
        columns.clone().map(|column| area_within(&planes(column))).collect()
    }
}

/// The rectangle of width 1 around the segment, which ends where the segment does.
impl HasArea for Line {
    fn areas_in_row(&self, row: i32, columns: &Range<i32>) -> Vec<Area> {
        let (a, b) = (At::from(self.start), At::from(self.end));
        let (dx, dy) = (b.x - a.x, b.y - a.y);
        if (dx, dy) == (0, 0) {
            return vec![Area::whole(false); columns.len()];
        }
        // Half a pixel in units of the cross product, which is the distance times the length.
        let half = 128.0 * ((product(dx, dx) + product(dy, dy)) as f64).sqrt();
        let planes = |column| {
            let p = corner_of(column, row);
            let along = |from: At| product(dx, p.x - from.x) + product(dy, p.y - from.y);
            let across = HalfPlane::new(cross(a, b, p), -dy, dx);
            let (start, end) = (HalfPlane::new(along(a), dx, dy), HalfPlane::new(-along(b), -dx, -dy));
            let left = HalfPlane { corner: half + across.corner, ..across };
            let right = HalfPlane { corner: half - across.corner, along_x: -across.along_x, along_y: -across.along_y };
            [start, end, left, right]
        };
        columns.clone().map(|column| area_within(&planes(column))).collect()
    }
}

/// Bits of a sub-pixel in the ends of chords.
const CHORD_BITS: u32 = 30;

/// A stretch of a pixel's rim that lies within a disc: where it starts and ends, and how far along the rim that is.
struct Stretch {
    from: (f64, f64),
    to: (f64, f64),
    start: f64,
    end: f64,
}

impl HasArea for Circle {
    fn areas_in_row(&self, row: i32, columns: &Range<i32>) -> Vec<Area> {
        let (center, radius) = (At::from(self.center), i64::from(self.radius.to_bits()));
        let area = |column| {
            let corner = corner_of(column, row);
            if radius <= 0 { Area::whole(false) } else { disc_area(corner.x - center.x, corner.y - center.y, radius) }
        };
        columns.clone().map(area).collect()
    }
}

/// The area of a disc around (0, 0) within the pixel whose upper left corner is given: a polygon, whose vertices lie
/// where the circle crosses the rim and at the corners within, and what the circle bulges out over its sides.
fn disc_area(left: i64, top: i64, radius: i64) -> Area {
    let stretches = stretches_within(left, top, radius);
    let in_pixels = radius as f64 / ONE as f64;
    let center = (-left as f64 / ONE as f64, -top as f64 / ONE as f64);
    if stretches.is_empty() {
        let has_center = is_within_pixel(center);
        let value = if has_center { std::f64::consts::PI * in_pixels * in_pixels } else { 0.0 };
        return Area { value, error: 1e-15, edges: usize::from(has_center) };
    }
    if stretches.len() == 4 && stretches.iter().all(|stretch| stretch.end - stretch.start == 1.0) {
        return Area::whole(true);
    }
    let (mut rim, mut bulges) = (Vec::new(), 0.0);
    for (index, stretch) in stretches.iter().enumerate() {
        let next = &stretches[(index + 1) % stretches.len()];
        rim.extend([stretch.from, stretch.to]);
        let forward = (next.start - stretch.end).rem_euclid(4.0);
        if forward > 0.0 {
            bulges += bulge(in_pixels, center, stretch.to, next.from, forward);
        }
    }
    Area { value: enclosed(&rim) + bulges, error: 1e-10, edges: 1 }
}

fn is_within_pixel((x, y): (f64, f64)) -> bool {
    0.0 < x && x < 1.0 && 0.0 < y && y < 1.0
}

/// Clockwise from the upper left corner.
fn stretches_within(left: i64, top: i64, radius: i64) -> Vec<Stretch> {
    let (right, bottom) = (left + ONE, top + ONE);
    // Each side by its distance from the centre and by its ends, in the direction of the walk.
    let sides = [(top, left, right), (right, top, bottom), (bottom, right, left), (left, bottom, top)];
    let mut stretches = Vec::new();
    for (side, (distance, first, last)) in (0_u8..).zip(sides) {
        let square = product(radius, radius) - product(distance, distance);
        if square <= 0 {
            continue;
        }
        // The square is below 2^62.
        let half_chord = (square << (2 * CHORD_BITS)).isqrt();
        let ends = [first, last].map(|end| (i128::from(end) << CHORD_BITS).clamp(-half_chord, half_chord));
        if ends[0] == ends[1] {
            continue;
        }
        let share = |end: i128| ((end - (i128::from(first) << CHORD_BITS)).abs() as f64) / ((ONE << CHORD_BITS) as f64);
        let [start, end] = ends.map(share);
        let (corner, next) = (CORNERS[usize::from(side)], CORNERS[usize::from(side + 1) % 4]);
        let point = |share: f64| (corner.0 + share * (next.0 - corner.0), corner.1 + share * (next.1 - corner.1));
        let side = f64::from(side);
        stretches.push(Stretch { from: point(start), to: point(end), start: side + start, end: side + end });
    }
    stretches
}

/// The area between an arc, clockwise around `center`, and its chord.
fn bulge(radius: f64, center: (f64, f64), from: (f64, f64), to: (f64, f64), forward: f64) -> f64 {
    let chord = (to.0 - from.0).hypot(to.1 - from.1);
    let angle = if radius > 100.0 {
        2.0 * (chord / (2.0 * radius)).asin()
    } else {
        let (a, b) = ((from.0 - center.0, from.1 - center.1), (to.0 - center.0, to.1 - center.1));
        let angle = (a.0 * b.1 - a.1 * b.0).atan2(a.0 * b.0 + a.1 * b.1);
        // No arc at all or all of the circle, which then lies within the pixel and leads most of the way around its rim.
        match angle.abs() < 1e-6 {
            true if forward > 2.0 && is_within_pixel(center) => std::f64::consts::TAU,
            true => angle.max(0.0),
            false => angle.rem_euclid(std::f64::consts::TAU),
        }
    };
    let square = angle * angle;
    let excess = if angle < 0.1 {
        angle * square / 6.0 * (1.0 - square / 20.0 * (1.0 - square / 42.0 * (1.0 - square / 72.0)))
    } else {
        angle - angle.sin()
    };
    radius * radius * excess / 2.0
}
