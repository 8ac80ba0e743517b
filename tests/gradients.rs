//! Gradients against exact rationals. On which side of the border of a level the place of a pixel lies is decided by the
//! signs of whole numbers, of any size: nothing is rounded, and no line is shared with `src/`. Angles alone are no
//! rationals: they lie between two that are known to enclose them, 2^-51 of a turn apart.

mod memory;
mod oracle;

use std::cmp::Ordering;

use embedded_graphics::{image::GetPixel as _, pixelcolor::Gray8, prelude::*, primitives::Rectangle};
use memory::Memory;
use num_bigint::BigInt;
use oracle::{Rng, cases, for_each_case};
use spanfill::{
    ConicalGradient, I24F8, LinearGradient, Paint, Painting as _, RadialGradient, Spread, Stop, Stops, Triangle, Vertex,
};

const SIDE: i32 = 32;

/// Where a pixel centre is in a gradient, a real number.
trait Place {
    /// Compares it with `n / d`.
    fn against(&self, n: i64, d: i64) -> Ordering;

    /// Nearly it: which period of a repeated gradient to look at.
    fn nearly(&self) -> f64;

    /// Nothing is lost on the way there: not even on a hard edge may the other colour be seen.
    fn is_exact(&self) -> bool {
        false
    }

    /// It turns: the end of the gradient meets its start.
    const TURNS: bool = false;
}

/// Stops of one channel: offsets in 1/65536, levels.
type Levels = [(i64, i64)];

/// A part of a gradient between two offsets, the first of which belongs to it; and the levels there.
struct Part {
    start: i64,
    end: i64,
    levels: (i64, i64),
}

/// Beyond all gradients.
const FAR: i64 = 1 << 40;

/// The parts around a place.
fn parts(stops: &Levels, spread: Spread, nearly: f64) -> Vec<Part> {
    let ((first, low), (last, high)) = (stops[0], stops[stops.len() - 1]);
    let inner = || stops.windows(2).filter(|pair| pair[0].0 < pair[1].0);
    let mut parts = Vec::new();
    if spread == Spread::Pad {
        parts.push(Part { start: -FAR, end: first, levels: (low, low) });
        parts.extend(inner().map(|two| Part { start: two[0].0, end: two[1].0, levels: (two[0].1, two[1].1) }));
        parts.push(Part { start: last, end: FAR, levels: (high, high) });
        return parts;
    }
    for period in nearly.floor() as i64 - 1..=nearly.floor() as i64 + 1 {
        let mut add = |start: i64, end: i64, levels: (i64, i64)| {
            if start < end && (spread == Spread::Repeat || period % 2 == 0) {
                parts.push(Part { start: (period << 16) + start, end: (period << 16) + end, levels });
            } else if start < end {
                let at = (period + 1) << 16;
                parts.push(Part { start: at - end, end: at - start, levels: (levels.1, levels.0) });
            }
        };
        add(0, first, (low, low));
        inner().for_each(|two| add(two[0].0, two[1].0, (two[0].1, two[1].1)));
        add(last, 1 << 16, (high, high));
    }
    parts.sort_by_key(|part| part.start);
    parts
}

/// How far the place of a pixel may be off where the gradient jumps: a unit of offsets.
const SLACK_BITS: u32 = 16;

/// Whether a level is less than one from the exact one; next to a jump, from that on either side of it.
fn is_right<P: Place>(place: &P, level: i64, stops: &Levels, spread: Spread) -> bool {
    let parts = parts(stops, spread, place.nearly());
    let part = parts.iter().find(|part| {
        place.against(part.start, 1 << 16) != Ordering::Less && place.against(part.end, 1 << 16) == Ordering::Less
    });
    let Some(part) = part else { panic!("a place is in no part") };
    let (from, to) = part.levels;
    let rise = (to - from).abs();
    let fits = if rise == 0 {
        level == from
    } else {
        // The level is met `up / rise` of the way from the start to the end.
        let (up, width) = ((level - from) * (to - from).signum(), part.end - part.start);
        place.against(part.start * rise + width * (up - 1), rise << 16) == Ordering::Greater
            && place.against(part.start * rise + width * (up + 1), rise << 16) == Ordering::Less
    };
    if fits || place.is_exact() {
        return fits;
    }
    let near = |at: i64| {
        let at = at << (SLACK_BITS - 16);
        place.against(at - 1, 1 << SLACK_BITS) != Ordering::Less
            && place.against(at + 1, 1 << SLACK_BITS) != Ordering::Greater
    };
    let one_of = |a: i64, b: i64| a != b && (level.abs_diff(a) <= 1 || level.abs_diff(b) <= 1);
    let mut borders: Vec<_> = parts.windows(2).map(|two| (two[0].end, two[0].levels.1, two[1].levels.0)).collect();
    if P::TURNS {
        let (start, end) = (stops[0].1, stops[stops.len() - 1].1);
        borders.extend([(0, start, end), (1 << 16, start, end)]);
    }
    borders.into_iter().any(|(at, before, after)| near(at) && one_of(before, after))
}

/// Draws a paint and looks at every pixel.
fn check<P: Place>(
    paint: impl Paint<Gray8>,
    stops: &Levels,
    spread: Spread,
    place: impl Fn([i64; 2]) -> P,
) -> Result<(), String> {
    let whole = Triangle::new(Vertex::new(-10, -10), Vertex::new(200, -10), Vertex::new(-10, 200));
    let area = Rectangle::new(Point::zero(), Size::new_equal(SIDE as u32));
    let mut target = Memory::new(area, |_| Gray8::BLACK);
    let Ok(()) = whole.painted(paint).draw(&mut target);
    for point in area.points() {
        let (Point { x, y }, level) = (point, target.pixel(point).expect("inside").luma());
        let place = place([x, y].map(|at| i64::from(at) * 256 + 128));
        // Far out, repeated gradients lose their phase.
        if spread != Spread::Pad && place.nearly().abs() > 64.0 {
            continue;
        }
        if !is_right(&place, i64::from(level), stops, spread) {
            return Err(format!("{level} at {x} {y}, near {}: {stops:?} {spread:?}", place.nearly()));
        }
    }
    Ok(())
}

/// A fraction whose denominator is positive; its square root, where it says so.
struct Fraction {
    numerator: BigInt,
    denominator: BigInt,
    root: bool,
}

fn float(of: &BigInt) -> f64 {
    of.to_string().parse().expect("digits")
}

impl Place for Fraction {
    fn against(&self, n: i64, d: i64) -> Ordering {
        if !self.root {
            return (&self.numerator * d).cmp(&(n * &self.denominator));
        }
        if n < 0 {
            return Ordering::Greater;
        }
        let square = |part: i64| BigInt::from(part) * part;
        (&self.numerator * square(d)).cmp(&(square(n) * &self.denominator))
    }

    fn nearly(&self) -> f64 {
        let fraction = float(&self.numerator) / float(&self.denominator);
        if self.root { fraction.sqrt() } else { fraction }
    }
}

fn big(values: [i64; 2]) -> [BigInt; 2] {
    values.map(BigInt::from)
}

fn from_to(from: [i64; 2], to: [i64; 2]) -> [i64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn square(of: &[BigInt; 2]) -> BigInt {
    &of[0] * &of[0] + &of[1] * &of[1]
}

/// An ellipse by the ends of two half axes, from its centre; and a focus.
struct Ellipse {
    axes: [[BigInt; 2]; 2],
    /// Twice the area between the axes, positive.
    area: BigInt,
    sign: i64,
}

impl Ellipse {
    fn new(axes: [[i64; 2]; 2]) -> Self {
        let axes = axes.map(big);
        let area = &axes[0][0] * &axes[1][1] - &axes[0][1] * &axes[1][0];
        let sign = if area < BigInt::ZERO { -1 } else { 1 };
        Self { axes, area: area * sign, sign }
    }

    /// A point in units of the axes, times the area.
    fn within(&self, point: [i64; 2]) -> [BigInt; 2] {
        let ([x, y], [a, b]) = (big(point), &self.axes);
        [(&x * &b[1] - &y * &b[0]) * self.sign, (&a[0] * &y - &a[1] * &x) * self.sign]
    }
}

/// The place is the `t` of the smallest circle around `focus (1 - t)`, of radius `r + t (1 - r)`, that holds the point; all in
/// units of the axes.
struct Focal {
    /// Times the area.
    point: [BigInt; 2],
    area: BigInt,
    focus: [BigInt; 2],
    /// Of the focus.
    denominator: BigInt,
    /// `r`, in 1/65536.
    inner: i64,
    nearly: f64,
}

impl Place for Focal {
    fn against(&self, n: i64, d: i64) -> Ordering {
        let [x, y] =
            [0, 1].map(|axis| &self.point[axis] * d * &self.denominator - &self.focus[axis] * &self.area * (d - n));
        let radius = BigInt::from(self.inner) * d + BigInt::from(n) * (65536 - self.inner);
        if radius < BigInt::ZERO {
            return Ordering::Greater;
        }
        let radius = radius * &self.area * &self.denominator;
        (square(&[x, y]) * (1_i64 << 32)).cmp(&(&radius * &radius))
    }

    fn nearly(&self) -> f64 {
        self.nearly
    }
}

/// The focus as a fraction, no farther out than 255/256 of the way to where its circle touches; none where that is no fraction.
fn focus(of: &Ellipse, at: [i64; 2], inner: i64) -> Option<([BigInt; 2], BigInt)> {
    let at = of.within(at);
    let far = square(&at);
    // Of the way: `rest / 2^24`.
    let rest = BigInt::from((65536 - inner) * 255);
    let limit = &rest * &of.area;
    if &far * (1_i64 << 48) <= &limit * &limit {
        return Some((at, of.area.clone()));
    }
    let root = far.sqrt();
    (&root * &root == far).then(|| (at.map(|part| part * &rest), root * (1_i64 << 24)))
}

/// What a float says, to know which period to look at.
fn nearly_focal(of: &Ellipse, point: &[BigInt; 2], focus: &([BigInt; 2], BigInt), inner: i64) -> f64 {
    let [u, v] = [0, 1].map(|axis| float(&point[axis]) / float(&of.area));
    let [fu, fv] = [0, 1].map(|axis| float(&focus.0[axis]) / float(&focus.1));
    let (r, du, dv) = (inner as f64 / 65536.0, u - fu, v - fv);
    let a = (1.0 - r) * (1.0 - r) - fu * fu - fv * fv;
    let b = du * fu + dv * fv - r * (1.0 - r);
    (b + (b * b - a * (r * r - du * du - dv * dv)).max(0.0).sqrt()) / a
}

mod angle {
    //! Angles between two rationals.

    /// Fraction bits.
    pub(super) const BITS: u32 = 62;
    /// What the sums below may be off: each of their terms, at most 40 and of five series, is off by 3 at most.
    pub(super) const ERROR: i128 = 1 << 10;

    /// `atan(n / d)` for at most 1/2, by its series: a term is less than a quarter of the one before.
    fn series(n: i128, d: i128) -> i128 {
        let x = (n << BITS) / d;
        let square = (x * x) >> BITS;
        let (mut power, mut sum, mut k) = (x, 0, 0);
        while power != 0 && k < 40 {
            let term = power / (2 * k + 1);
            sum += if k % 2 == 0 { term } else { -term };
            power = (power * square) >> BITS;
            k += 1;
        }
        sum
    }

    /// `atan(n / d) / 2 pi` for `0 <= n <= d`, to `ERROR`.
    pub(super) fn turn(n: i64, d: i64) -> i128 {
        let (n, d) = (i128::from(n), i128::from(d));
        // Machin's formula, and atan a = atan 1/2 + atan (a - 1/2) / (1 + a/2).
        let two_pi = 32 * series(1, 5) - 8 * series(1, 239);
        let angle = if 4 * n < d { series(n, d) } else { series(1, 2) + series(2 * n - d, 2 * d + n) };
        (angle << BITS) / two_pi
    }
}

/// The angle of a point, clockwise from the right, less a start, in 2^-62 of a turn: from the first to the second.
struct Angle(i128, i128);

impl Angle {
    fn new([x, y]: [i64; 2], start: i64) -> Self {
        let whole = 1_i128 << angle::BITS;
        let (less, more) = (x.abs().min(y.abs()), x.abs().max(y.abs()));
        // Along the axes and diagonals, and nowhere else, an angle is a rational part of a turn (I. Niven, 1956).
        let (octant, error) = match less {
            0 => (0, 0),
            _ if less == more => (whole / 8, 0),
            _ => (angle::turn(less, more), angle::ERROR),
        };
        let quadrant = if y.abs() > x.abs() { whole / 4 - octant } else { octant };
        let turn = match (x < 0, y < 0) {
            (false, false) => quadrant,
            (true, false) => whole / 2 - quadrant,
            (true, true) => whole / 2 + quadrant,
            (false, true) => whole - quadrant,
        };
        let place = (turn - (i128::from(start) << (angle::BITS - 16))).rem_euclid(whole);
        let place = if x == 0 && y == 0 { 0 } else { place };
        let within = error..=whole - error;
        assert!(within.contains(&place), "the enclosure is too wide for {x} {y} from {start} on");
        Self(place - error, place + error)
    }
}

impl Place for Angle {
    fn against(&self, n: i64, d: i64) -> Ordering {
        let (low, high, n) = (self.0 * i128::from(d), self.1 * i128::from(d), i128::from(n) << angle::BITS);
        match (low.cmp(&n), high.cmp(&n)) {
            (one, other) if one == other => one,
            _ => panic!("the enclosure is too wide"),
        }
    }

    fn nearly(&self) -> f64 {
        // Never one that is rounded up to the next period.
        (self.0 as f64 / (1_u64 << angle::BITS) as f64).clamp(0.0, 0.999)
    }

    fn is_exact(&self) -> bool {
        self.0 == self.1
    }

    const TURNS: bool = true;
}

#[test]
fn the_enclosures_hold_what_floats_say() {
    for_each_case(0x6AD1, cases(20_000), |rng| {
        let [x, y] = [(); 2].map(|()| rng.magnitude(33));
        if x == 0 && y == 0 {
            return Ok(0);
        }
        let turn = ((y as f64).atan2(x as f64) / std::f64::consts::TAU).rem_euclid(1.0);
        let Angle(low, high) = Angle::new([x, y], 0);
        let whole = (1_u64 << angle::BITS) as f64;
        let off = (low as f64 / whole - turn).abs().max((high as f64 / whole - turn).abs());
        // Next to the whole turn, one may be on its other side.
        if (1e-15..1.0 - 1e-15).contains(&off) { Err(format!("{x} {y}: {off}")) } else { Ok(1) }
    });
}

/// Up to five stops, some at one place, and a spread.
fn some_stops(rng: &mut Rng) -> (Vec<(i64, i64)>, Spread) {
    let mut offsets: Vec<i64> = (0..rng.int(1..=5)).map(|_| rng.int(0..=64) * 1024).collect();
    offsets.sort_unstable();
    let stops = offsets.into_iter().map(|offset| (offset, rng.int(0..=255))).collect();
    (stops, rng.pick(&[Spread::Pad, Spread::Repeat, Spread::Reflect]))
}

fn vertex([x, y]: [i64; 2]) -> Vertex {
    Vertex::from_bits(x as i32, y as i32)
}

/// Near the picture; in the middle of a pixel or on a corner.
fn near_point(rng: &mut Rng) -> [i64; 2] {
    match rng.int(0..=6) {
        0..=3 => [(); 2].map(|()| rng.int(-2000..=10_000)),
        4 | 5 => [(); 2].map(|()| rng.int(-8..=40) * 256 + 128),
        _ => [(); 2].map(|()| rng.int(-8..=40) * 256),
    }
}

/// The same, and now and then anywhere at all.
fn point(rng: &mut Rng) -> [i64; 2] {
    if rng.one_in(8) {
        let (low, high) = (i64::from(i32::MIN), i64::from(i32::MAX));
        return [(); 2].map(|()| rng.pick(&[low, high, 0, rng.clone().int(low..=high)]));
    }
    near_point(rng)
}

/// A case of each kind: which pixels have a level that is one off the exact one, or more?
fn each_is_right(rng: &mut Rng, kind: Kind) -> Result<u64, String> {
    let (levels, spread) = some_stops(rng);
    let stops: Vec<_> =
        levels.iter().map(|(offset, level)| Stop::new(*offset as u32, Gray8::new(*level as u8))).collect();
    let stops = Stops::new(&stops, spread).expect("sorted");
    // A focus near the rim makes much of little: by 2^15 at worst, which far places have no bits for.
    let point = |rng: &mut Rng| if kind == Kind::Focal { near_point(rng) } else { point(rng) };
    let centre = point(rng);
    match kind {
        Kind::Linear => {
            let end = point(rng);
            let way = from_to(centre, end);
            let length = square(&big(way));
            // A pixel, at least: shorter ones run through more than a gradient a pixel.
            if length < BigInt::from(1 << 16) {
                return Ok(0);
            }
            let gradient = LinearGradient::new(vertex(centre), vertex(end), stops);
            check(gradient, &levels, spread, |at| {
                let ([x, y], [dx, dy]) = (big(from_to(centre, at)), big(way));
                Fraction { numerator: x * dx + y * dy, denominator: length.clone(), root: false }
            })
            .map_err(|error| format!("{centre:?} {end:?}: {error}"))
        }
        Kind::Radial => {
            let radius = (rng.int(256..=i64::from(i32::MAX)) >> rng.int(0..=20)).max(256);
            let gradient = RadialGradient::new(vertex(centre), I24F8::from_bits(radius as i32), stops);
            check(gradient, &levels, spread, |at| Fraction {
                numerator: square(&big(from_to(centre, at))),
                denominator: BigInt::from(radius) * radius,
                root: true,
            })
            .map_err(|error| format!("{centre:?} {radius}: {error}"))
        }
        Kind::Elliptical | Kind::Focal => {
            let ends = if rng.one_in(3) {
                let radius = rng.int(1..=40) * 256;
                [[centre[0] + radius, centre[1]], [centre[0], centre[1] + radius]]
            } else {
                [point(rng), point(rng)]
            };
            let axes = ends.map(|end| from_to(centre, end));
            let ellipse = Ellipse::new(axes);
            let longest = square(&big(axes[0])).max(square(&big(axes[1])));
            let in_range = ends.iter().flatten().all(|part| i32::try_from(*part).is_ok());
            // No thinner than a pixel.
            if !in_range || &ellipse.area * &ellipse.area < longest * (1 << 16) {
                return Ok(0);
            }
            let gradient = RadialGradient::elliptical(vertex(centre), ends.map(vertex), stops);
            if kind == Kind::Elliptical {
                return check(gradient, &levels, spread, |at| Fraction {
                    numerator: square(&ellipse.within(from_to(centre, at))),
                    denominator: &ellipse.area * &ellipse.area,
                    root: true,
                })
                .map_err(|error| format!("{centre:?} {ends:?}: {error}"))
                .map(|()| 1);
            }
            let inner = rng.pick(&[0, 61440, rng.clone().int(0..=61440)]);
            let seen = match rng.int(0..=3) {
                0 => point(rng),
                // Along an axis, also far beyond it; by 3 and 4 of each.
                1 => [0, 1].map(|part| centre[part] + axes[0][part] * rng.clone().int(-20..=20) / 8),
                2 => [0, 1].map(|part| centre[part] + (3 * axes[0][part] + 4 * axes[1][part]) / 5),
                _ => [0, 1].map(|part| centre[part] + axes[1][part] / rng.clone().int(2..=40)),
            };
            let Some(at) = focus(&ellipse, from_to(centre, seen), inner) else { return Ok(0) };
            if seen.iter().any(|part| i32::try_from(*part).is_err()) {
                return Ok(0);
            }
            let gradient = gradient.with_focus(vertex(seen), inner as u32);
            check(gradient, &levels, spread, |to| {
                let point = ellipse.within(from_to(centre, to));
                let nearly = nearly_focal(&ellipse, &point, &at, inner);
                let (focus, denominator) = at.clone();
                Focal { point, area: ellipse.area.clone(), focus, denominator, inner, nearly }
            })
            .map_err(|error| format!("{centre:?} {ends:?} {seen:?} {inner}: {error}"))
        }
        Kind::Conical => {
            let start = rng.pick(&[0, 8192, 16384, 40960, rng.clone().int(0..=65535)]);
            let gradient = ConicalGradient::new(vertex(centre), start as u16, stops);
            check(gradient, &levels, spread, |at| Angle::new(from_to(centre, at), start))
                .map_err(|error| format!("{centre:?} {start}: {error}"))
        }
    }
    .map(|()| 1)
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Linear,
    Radial,
    Elliptical,
    Focal,
    Conical,
}

fn all_are_right(seed: u64, count: u64, kind: Kind) {
    let looked_at = for_each_case(seed, cases(count), |rng| each_is_right(rng, kind));
    assert!(looked_at > count / 8, "{looked_at} of {count} are not enough to tell");
}

#[test]
fn linear_gradients_are_exact_to_a_level() {
    all_are_right(0x6AD2, 1_500, Kind::Linear);
}

#[test]
fn radial_gradients_are_exact_to_a_level() {
    all_are_right(0x6AD3, 1_500, Kind::Radial);
}

#[test]
fn elliptical_gradients_are_exact_to_a_level() {
    all_are_right(0x6AD4, 1_500, Kind::Elliptical);
}

#[test]
fn focal_gradients_are_exact_to_a_level() {
    all_are_right(0x6AD5, 800, Kind::Focal);
}

#[test]
fn conical_gradients_are_exact_to_a_level() {
    all_are_right(0x6AD6, 1_500, Kind::Conical);
}
