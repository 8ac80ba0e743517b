//! Strokes against what a pen covers: the distance to the path, with the ends and corners of SVG 2, worked out in
//! floating point with nothing in common with `src/`.

use std::{
    convert::Infallible,
    f64::consts::{PI, TAU},
};

use spanfill::{
    ActiveEdge, Align, Angle, Cap, Curves, Element, FillRule, FinePoint, Join, Outline, OutlineSink, Path, Shape, Span,
    SpanSink, Stroke, StrokeStyle, SvgElements, Transform, Transformed, Vertex, collect, path,
};

type Point = (f64, f64);

#[derive(Default)]
struct Contours(Vec<Vec<(i64, i64)>>, Vec<(i64, i64)>);

impl OutlineSink for Contours {
    fn point(&mut self, x: i64, y: i64) {
        self.1.push((x, y));
    }

    fn close(&mut self) {
        self.0.push(std::mem::take(&mut self.1));
    }
}

fn contours(outline: &impl Outline) -> Vec<Vec<(i64, i64)>> {
    let mut contours = Contours::default();
    outline.emit(&mut contours);
    assert!(contours.1.is_empty(), "a contour is not closed");
    contours.0
}

/// How often contours wind around a point that is on none of them.
fn winding(contours: &[Vec<(i64, i64)>], (x, y): Point) -> i32 {
    let (x, y) = (x * 4096.0, y * 4096.0);
    let mut winding = 0;
    for contour in contours {
        for index in 0..contour.len() {
            let ((x0, y0), (x1, y1)) = (contour[index], contour[(index + 1) % contour.len()]);
            let [x0, y0, x1, y1] = [x0, y0, x1, y1].map(|part| part as f64);
            if (y0 <= y) != (y1 <= y) && (x1 - x0) * (y - y0) / (y1 - y0) + x0 > x {
                winding += if y1 > y0 { 1 } else { -1 };
            }
        }
    }
    winding
}

fn sub(a: Point, b: Point) -> Point {
    (a.0 - b.0, a.1 - b.1)
}

fn dot(a: Point, b: Point) -> f64 {
    a.0 * b.0 + a.1 * b.1
}

fn cross(a: Point, b: Point) -> f64 {
    a.0 * b.1 - a.1 * b.0
}

fn unit(a: Point) -> Point {
    let length = a.0.hypot(a.1);
    (a.0 / length, a.1 / length)
}

/// The signed distance from the boundary of the pen's trace, negative inside; the largest of what a union's parts
/// allow.
struct Trace {
    points: Vec<Point>,
    is_closed: bool,
    radius: f64,
    cap: Cap,
    join: Join,
}

/// Of a convex polygon, clockwise where y grows downwards: below zero inside.
fn convex(corners: &[Point], p: Point) -> f64 {
    let mut area = 0.0;
    for index in 0..corners.len() {
        area += cross(corners[index], corners[(index + 1) % corners.len()]);
    }
    if area.abs() < 1e-6 {
        return f64::INFINITY;
    }
    let sign = area.signum();
    let mut worst = f64::NEG_INFINITY;
    for index in 0..corners.len() {
        let (a, b) = (corners[index], corners[(index + 1) % corners.len()]);
        if a != b {
            let along = unit(sub(b, a));
            worst = worst.max(-sign * cross(along, sub(p, a)));
        }
    }
    worst
}

impl Trace {
    /// Negative by as much as the point is inside one of the parts, positive by as much as it is outside all.
    fn distance(&self, p: Point) -> f64 {
        let mut points = self.points.clone();
        points.dedup();
        if self.is_closed && points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        let r = self.radius;
        let disc = |center: Point| {
            let d = sub(p, center);
            d.0.hypot(d.1) - r
        };
        if points.len() == 1 {
            let (x, y) = points[0];
            return match self.cap {
                Cap::Butt => f64::INFINITY,
                Cap::Round => disc(points[0]),
                Cap::Square => (p.0 - x).abs().max((p.1 - y).abs()) - r,
            };
        }
        let count = points.len();
        let sides = if self.is_closed { count } else { count - 1 };
        let mut nearest = f64::INFINITY;
        for index in 0..sides {
            let (mut a, mut b) = (points[index], points[(index + 1) % count]);
            let d = unit(sub(b, a));
            if self.cap == Cap::Square && !self.is_closed {
                if index == 0 {
                    a = (a.0 - r * d.0, a.1 - r * d.1);
                }
                if index + 1 == sides {
                    b = (b.0 + r * d.0, b.1 + r * d.1);
                }
            }
            let along = dot(sub(p, a), d);
            let length = dot(sub(b, a), d);
            let across = cross(d, sub(p, a)).abs();
            nearest = nearest.min((-along).max(along - length).max(across - r));
        }
        if !self.is_closed && self.cap == Cap::Round {
            // Half a disc each: a short line's end may lie within the other half.
            let (first, last) = (sub(points[1], points[0]), sub(points[count - 1], points[count - 2]));
            nearest = nearest.min(disc(points[0]).max(dot(sub(p, points[0]), unit(first))));
            nearest = nearest.min(disc(points[count - 1]).max(-dot(sub(p, points[count - 1]), unit(last))));
        }
        let corners = if self.is_closed { 0..count } else { 1..count - 1 };
        for index in corners {
            let at = points[index];
            let before = unit(sub(at, points[(index + count - 1) % count]));
            let after = unit(sub(points[(index + 1) % count], at));
            let turn = cross(before, after);
            let (limit, is_sharp) = match self.join {
                Join::Round => {
                    nearest = nearest.min(disc(at));
                    continue;
                }
                Join::Bevel => (0.0, true),
                Join::Miter { limit } => (f64::from(limit) / 256.0, false),
            };
            let side = if turn > 0.0 { -1.0 } else { 1.0 };
            let normal = |d: Point| (at.0 - side * r * d.1, at.1 + side * r * d.0);
            let (n0, n1) = (normal(before), normal(after));
            let half = ((1.0 + dot(before, after)) / 2.0).max(0.0).sqrt();
            let mut part = vec![at, n0];
            if !is_sharp && half > 0.0 && 1.0 / half <= limit {
                let middle = unit(sub((n0.0 + n1.0, n0.1 + n1.1), (2.0 * at.0, 2.0 * at.1)));
                part.push((at.0 + middle.0 * r / half, at.1 + middle.1 * r / half));
            }
            part.push(n1);
            nearest = nearest.min(convex(&part, p));
        }
        nearest
    }
}

struct Rng(u64);

impl Rng {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (self.0 >> 33) % end
    }

    fn pixels(&mut self, end: u32) -> f64 {
        self.below(u64::from(end) * 256) as f64 / 256.0
    }
}

fn polyline(points: &[Point], is_closed: bool) -> Vec<Element> {
    let fine = |&(x, y): &Point| FinePoint::new(x, y);
    let mut elements = vec![Element::Move(fine(&points[0]))];
    elements.extend(points[1..].iter().map(|point| Element::Line(fine(point))));
    if points.len() == 1 && !is_closed {
        elements.push(Element::Line(fine(&points[0])));
    }
    if is_closed {
        elements.push(Element::Close);
    }
    elements
}

/// Every sample that is further from the boundary than this is on the side it should be.
const MARGIN: f64 = 1.5 / 1024.0;

fn check_samples(
    stroke: &impl Outline,
    distance: impl Fn(Point) -> f64,
    samples: impl Iterator<Item = Point>,
    what: &str,
) {
    let contours = contours(stroke);
    for sample in samples {
        // Off the lattice of points.
        let sample = (sample.0 + 1e-5, sample.1 + 1.3e-5);
        let distance = distance(sample);
        let wound = winding(&contours, sample);
        assert!(wound <= 0, "{what}: wound {wound} at {sample:?}: all pieces are wound alike");
        if distance.abs() > MARGIN {
            assert_eq!(wound != 0, distance < 0.0, "{what}: {sample:?} is {distance} away");
        }
    }
}

fn styles() -> Vec<(Cap, Join)> {
    let joins = [
        Join::Round,
        Join::Bevel,
        Join::Miter { limit: 1024 },
        Join::Miter { limit: 256 * 11 },
        Join::Miter { limit: 300 },
    ];
    let caps = [Cap::Butt, Cap::Round, Cap::Square];
    joins.iter().flat_map(|join| caps.iter().map(|cap| (*cap, *join))).collect()
}

#[test]
fn polylines_are_what_a_pen_covers() {
    let mut rng = Rng(1);
    for case in 0..3000_u64 {
        let styles = styles();
        let (cap, join) = styles[usize::try_from(case).unwrap() % styles.len()];
        let count = 1 + rng.below(5);
        let mut points: Vec<Point> = (0..count).map(|_| (rng.pixels(20), rng.pixels(20))).collect();
        match rng.below(6) {
            // There and back again, straight on, and not at all.
            0 if count > 2 => points[2] = points[0],
            1 if count > 2 => points[2] = (2.0 * points[1].0 - points[0].0, 2.0 * points[1].1 - points[0].1),
            2 if count > 1 => points[1] = points[0],
            3 => points.iter_mut().for_each(|point| point.0 = point.0.round()),
            _ => {}
        }
        let is_closed = rng.below(2) == 1;
        let width = [1, 100, 256, 700, 2000][usize::try_from(rng.below(5)).unwrap()];
        let elements = polyline(&points, is_closed);
        let stroke = Stroke::new(Path::new(&elements), StrokeStyle::new(width).cap(cap).join(join));
        let trace = Trace { points, is_closed, radius: f64::from(width) / 512.0, cap, join };
        let near = |rng: &mut Rng| {
            // Half of the samples lie near a corner.
            let at = trace.points[usize::try_from(rng.below(trace.points.len() as u64)).unwrap()];
            if rng.below(2) == 0 {
                (rng.pixels(24) - 2.0, rng.pixels(24) - 2.0)
            } else {
                (at.0 + rng.pixels(8) - 4.0, at.1 + rng.pixels(8) - 4.0)
            }
        };
        let samples: Vec<Point> = (0..200).map(|_| near(&mut rng)).collect();
        let what = format!("case {case}: {:?}, closed {is_closed}, width {width}, {cap:?}, {join:?}", trace.points);
        check_samples(&stroke, |p| trace.distance(p), samples.into_iter(), &what);
    }
}

/// A cubic in floating point: its point and its derivative.
fn cubic(c: [Point; 4], t: f64) -> (Point, Point) {
    let s = 1.0 - t;
    let mix = |a: f64, b: f64, c: f64, d: f64| {
        (
            s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d,
            3.0 * (s * s * (b - a) + 2.0 * s * t * (c - b) + t * t * (d - c)),
        )
    };
    let (x, dx) = mix(c[0].0, c[1].0, c[2].0, c[3].0);
    let (y, dy) = mix(c[0].1, c[1].1, c[2].1, c[3].1);
    ((x, y), (dx, dy))
}

/// The signed distance from what a segment of twice the radius covers that sweeps along a curve, finely sampled: a
/// point is covered where it lies on the normal of some point of the curve, at most the radius away. Between two
/// samples its place along the direction changes its sign.
fn swept(at: &impl Fn(f64) -> (Point, Point), steps: usize, radius: f64, p: Point) -> bool {
    let mut last: Option<(f64, Point, f64)> = None;
    for step in 0..=steps {
        let t = step as f64 / steps as f64;
        let (point, tangent) = at(t);
        let ahead = dot(sub(p, point), unit(tangent));
        if let Some((before, from, t0)) = last
            && (before <= 0.0) != (ahead <= 0.0)
        {
            // Bisected to where it is on the normal.
            let (mut low, mut high) = (t0, t);
            for _ in 0..40 {
                let middle = f64::midpoint(low, high);
                let (point, tangent) = at(middle);
                if (dot(sub(p, point), unit(tangent)) <= 0.0) == (before <= 0.0) { low = middle } else { high = middle }
            }
            let (point, tangent) = at(low);
            let across = cross(unit(tangent), sub(p, point)).abs();
            let _ = from;
            if across <= radius {
                return true;
            }
        }
        last = Some((ahead, point, t));
    }
    false
}

#[test]
fn curves_are_what_a_segment_sweeps_over() {
    let mut rng = Rng(5);
    for case in 0..400 {
        let c: [Point; 4] = std::array::from_fn(|_| (rng.pixels(20), rng.pixels(20)));
        let width = [200, 700, 2000][case % 3];
        let radius = f64::from(width) / 512.0;
        let elements = [
            Element::Move(FinePoint::new(c[0].0, c[0].1)),
            Element::Cubic(
                FinePoint::new(c[1].0, c[1].1),
                FinePoint::new(c[2].0, c[2].1),
                FinePoint::new(c[3].0, c[3].1),
            ),
        ];
        let stroke = Stroke::new(Path::new(&elements), StrokeStyle::new(width));
        let found = contours(&stroke);
        let at = |t: f64| cubic(c, t);
        for _ in 0..100 {
            let sample = (rng.pixels(24) - 2.0 + 1e-5, rng.pixels(24) - 2.0 + 1.3e-5);
            let is_covered = swept(&at, 400, radius, sample);
            if (winding(&found, sample) != 0) == is_covered {
                continue;
            }
            // Right, unless the answer is the same all around within the margin.
            let margin = 2.0 / 1024.0;
            let around = (0..16).map(|step| f64::from(step) * TAU / 16.0);
            let is_clear = around.into_iter().all(|angle| {
                swept(&at, 2000, radius, (sample.0 + margin * angle.cos(), sample.1 + margin * angle.sin()))
                    == is_covered
            });
            assert!(!is_clear, "case {case}: {c:?} width {width}: {sample:?} should be covered: {is_covered}");
        }
    }
}

#[test]
fn circles_stroked_are_rings() {
    for (radius, width) in [(5.0, 512), (20.0, 700), (3.0, 2560), (60.0, 300)] {
        for join in [Join::Round, Join::Bevel, Join::Miter { limit: 1024 }] {
            let data = format!(
                "M{} 100a{radius} {radius} 0 1 0 {} 0a{radius} {radius} 0 0 0 -{} 0z",
                100.0 - radius,
                2.0 * radius,
                2.0 * radius
            );
            let elements: Vec<_> = SvgElements::new(&data, 1, 1).map(Result::unwrap).collect();
            let stroke = Stroke::new(Path::new(&elements), StrokeStyle::new(width).join(join));
            let half = f64::from(width) / 512.0;
            let mut rng = Rng(9);
            let samples = (0..3000).map(|_| {
                let angle = rng.pixels(1) * TAU;
                let away = radius + half * (rng.pixels(2) * 2.0 - 2.0) * 1.2;
                (100.0 + away * angle.cos(), 100.0 + away * angle.sin())
            });
            let distance = |p: Point| ((p.0 - 100.0).hypot(p.1 - 100.0) - radius).abs() - half;
            check_samples(&stroke, distance, samples, &format!("{data} {width} {join:?}"));
        }
    }
}

/// The pieces of a polyline that dashes leave, by arithmetic on its length alone.
fn dashed(points: &[Point], dashes: &[f64], phase: f64) -> Vec<Vec<Point>> {
    let cycle: f64 = dashes.iter().sum::<f64>() * if dashes.len() % 2 == 1 { 2.0 } else { 1.0 };
    let is_on = |position: f64| {
        let mut left = (position + phase).rem_euclid(cycle);
        let mut index = 0;
        while left >= dashes[index % dashes.len()] {
            left -= dashes[index % dashes.len()];
            index += 1;
        }
        index % 2 == 0
    };
    // Where it changes.
    let mut changes = vec![];
    let total: f64 = points
        .windows(2)
        .map(|pair| {
            let d = sub(pair[1], pair[0]);
            d.0.hypot(d.1)
        })
        .sum();
    let mut position = -phase.rem_euclid(cycle) - cycle;
    let mut index = 0;
    while position < total {
        position += dashes[index % dashes.len()];
        index += 1;
        if position > 0.0 && position < total {
            changes.push(position);
        }
    }
    let at = |position: f64| {
        let mut rest = position;
        for pair in points.windows(2) {
            let d = sub(pair[1], pair[0]);
            let length = d.0.hypot(d.1);
            if rest <= length {
                return (pair[0].0 + d.0 * rest / length, pair[0].1 + d.1 * rest / length);
            }
            rest -= length;
        }
        points[points.len() - 1]
    };
    let mut bounds = vec![0.0];
    bounds.extend(changes);
    bounds.push(total);
    let mut pieces = vec![];
    for pair in bounds.windows(2) {
        if is_on(f64::midpoint(pair[0], pair[1])) {
            let mut piece = vec![at(pair[0])];
            let mut passed = 0.0;
            for side in points.windows(2) {
                let d = sub(side[1], side[0]);
                passed += d.0.hypot(d.1);
                if passed > pair[0] + 1e-9 && passed < pair[1] - 1e-9 {
                    piece.push(side[1]);
                }
            }
            piece.push(at(pair[1]));
            pieces.push(piece);
        }
    }
    pieces
}

#[test]
fn dashes_are_strokes_of_their_own() {
    let mut rng = Rng(11);
    let patterns: [&[u32]; 5] = [&[1024, 512], &[700, 300, 100, 450], &[1000], &[300, 200, 500], &[3000, 20]];
    for case in 0..600_usize {
        let styles = styles();
        let (cap, join) = styles[case % styles.len()];
        let mut points: Vec<Point> = (0..2 + rng.below(3)).map(|_| (rng.pixels(20), rng.pixels(20))).collect();
        let is_closed = case % 3 == 0;
        let pattern = patterns[case % 5];
        let phase = i32::try_from(rng.below(4000)).unwrap() - 2000;
        let width = [100, 256, 900][case % 3];
        let elements = polyline(&points, is_closed);
        let style = StrokeStyle::new(width).cap(cap).join(join).dashes(pattern).phase(phase);
        let stroke = Stroke::new(Path::new(&elements), style);
        if is_closed {
            points.push(points[0]);
        }
        let lengths: Vec<f64> = pattern.iter().map(|length| f64::from(*length) / 256.0).collect();
        let radius = f64::from(width) / 512.0;
        let traces: Vec<Trace> = dashed(&points, &lengths, f64::from(phase) / 256.0)
            .into_iter()
            .map(|points| Trace { points, is_closed: false, radius, cap, join })
            .collect();
        let samples: Vec<Point> = (0..150).map(|_| (rng.pixels(24) - 2.0, rng.pixels(24) - 2.0)).collect();
        let distance = |p: Point| traces.iter().map(|trace| trace.distance(p)).fold(f64::INFINITY, f64::min);
        check_samples(
            &stroke,
            distance,
            samples.into_iter(),
            &format!("case {case}: {points:?} {pattern:?} {phase} {cap:?} {join:?}"),
        );
    }
}

#[test]
fn dashes_of_a_circle_end_across_it() {
    // Twelve dashes of 20 degrees, ten of gap.
    let radius = 30.0_f64;
    let data = format!("M{} 50a30 30 0 0 1-60 0a30 30 0 0 1 60 0", 50.0 + radius);
    let elements: Vec<_> = SvgElements::new(&data, 1, 1).map(Result::unwrap).collect();
    let degree = PI / 180.0 * radius * 256.0;
    let dashes = [(20.0 * degree).round() as u32, (10.0 * degree).round() as u32];
    for width in [512, 2048] {
        let stroke = Stroke::new(Path::new(&elements), StrokeStyle::new(width).dashes(&dashes));
        let half = f64::from(width) / 512.0;
        let mut rng = Rng(3);
        let samples = (0..6000).map(|_| {
            let angle = rng.pixels(1) * TAU;
            let away = radius + half * (rng.pixels(2) - 1.0) * 1.2;
            (50.0 + away * angle.cos(), 50.0 + away * angle.sin())
        });
        let distance = |p: Point| {
            let away = (p.0 - 50.0).hypot(p.1 - 50.0);
            let angle = (p.1 - 50.0).atan2(p.0 - 50.0).rem_euclid(TAU);
            let along = (angle * radius * 256.0).rem_euclid(f64::from(dashes[0] + dashes[1]));
            let inside = along.min(f64::from(dashes[0]) - along) / 256.0 / radius * away;
            // The closing gap is what rounding leaves.
            if angle > TAU - 0.01 {
                return 0.0;
            }
            ((away - radius).abs() - half).max(-inside)
        };
        check_samples(&stroke, distance, samples, &format!("width {width}"));
    }
}

/// The area that contours cover by the non-zero rule, on so many scan lines a pixel, exact along each.
fn area(contours: &[Vec<(i64, i64)>], lines: u32) -> f64 {
    let ys = || contours.iter().flatten().map(|point| point.1);
    let (Some(low), Some(high)) = (ys().min(), ys().max()) else { return 0.0 };
    let step = 4096.0 / f64::from(lines);
    let mut sum = 0.0;
    let mut y = low as f64 + step / 2.0;
    while y < high as f64 {
        let mut crossings: Vec<(f64, i32)> = vec![];
        for contour in contours {
            for index in 0..contour.len() {
                let ((x0, y0), (x1, y1)) = (contour[index], contour[(index + 1) % contour.len()]);
                let [x0, y0, x1, y1] = [x0, y0, x1, y1].map(|part| part as f64);
                if (y0 <= y) != (y1 <= y) {
                    crossings.push(((x1 - x0) * (y - y0) / (y1 - y0) + x0, if y1 > y0 { 1 } else { -1 }));
                }
            }
        }
        crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut wound = 0;
        for pair in crossings.windows(2) {
            wound += pair[0].1;
            if wound != 0 {
                sum += pair[1].0 - pair[0].0;
            }
        }
        y += step;
    }
    sum * step / (4096.0 * 4096.0)
}

#[test]
fn areas_of_rings_and_discs_are_right() {
    for (radius, width) in [(5.0_f64, 512_u32), (20.0, 700), (3.0, 1400), (60.0, 300)] {
        let data = format!(
            "M{} 100a{radius} {radius} 0 1 0 {} 0a{radius} {radius} 0 0 0 -{} 0z",
            100.0 - radius,
            2.0 * radius,
            2.0 * radius
        );
        let elements: Vec<_> = SvgElements::new(&data, 1, 1).map(Result::unwrap).collect();
        let stroke = Stroke::new(Path::new(&elements), StrokeStyle::new(width));
        let half = f64::from(width) / 512.0;
        let exact = PI * ((radius + half).powi(2) - (radius - half).powi(2));
        let found = area(&contours(&stroke), 512);
        let moved = (found - exact) / (4.0 * PI * radius);
        // Both outlines, on average, within a 1/6000 pixel: a sixteenth of a level.
        assert!(moved.abs() < 1.0 / 6000.0, "{radius} {width}: {found} {exact}: {moved}");
    }
    let dot = polyline(&[(9.0, 9.0)], false);
    for width in [100, 512, 4000] {
        let stroke = Stroke::new(Path::new(&dot), StrokeStyle::new(width).cap(Cap::Round));
        let radius = f64::from(width) / 512.0;
        let found = area(&contours(&stroke), 512);
        let moved = (found - PI * radius * radius) / (TAU * radius);
        assert!(moved.abs() < 1.0 / 4000.0, "{width}: {moved}");
    }
}

/// The same area everywhere: the same non-zero winding at many samples.
fn same(a: &[Vec<(i64, i64)>], b: &[Vec<(i64, i64)>], rng: &mut Rng) -> bool {
    (0..400).all(|_| {
        let sample = (rng.pixels(24) - 2.0 + 1e-5, rng.pixels(24) - 2.0 + 1.3e-5);
        (winding(a, sample) != 0) == (winding(b, sample) != 0)
    })
}

fn sorted(mut contours: Vec<Vec<(i64, i64)>>) -> Vec<Vec<(i64, i64)>> {
    for contour in &mut contours {
        contour.dedup();
        contour.sort_unstable();
        contour.dedup();
    }
    contours.sort();
    contours
}

#[test]
fn direction_mirrors_and_shifts_change_nothing() {
    let mut rng = Rng(21);
    for case in 0..300_usize {
        let styles = styles();
        let (cap, join) = styles[case % styles.len()];
        let points: Vec<Point> = (0..2 + rng.below(4)).map(|_| (rng.pixels(20), rng.pixels(20))).collect();
        let is_closed = case % 4 == 0;
        let style = StrokeStyle::new(300 + 77 * u32::try_from(case % 9).unwrap()).cap(cap).join(join);
        let draw = |points: &[Point]| contours(&Stroke::new(Path::new(&polyline(points, is_closed)), style));
        let found = draw(&points);
        let mut backwards = points.clone();
        backwards.reverse();
        assert!(same(&found, &draw(&backwards), &mut rng), "{points:?} backwards");
        // To the last bit: every vertex of the one is a vertex of the other.
        let vertices = |contours: &[Vec<(i64, i64)>]| {
            let mut all: Vec<_> = contours.iter().flatten().copied().collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        assert_eq!(vertices(&found), vertices(&draw(&backwards)), "{points:?} {cap:?} {join:?}");
        let mirrored: Vec<Point> = points.iter().map(|point| (-point.0, point.1)).collect();
        let flipped: Vec<Vec<_>> =
            draw(&mirrored).iter().map(|contour| contour.iter().map(|point| (-point.0, point.1)).collect()).collect();
        assert_eq!(vertices(&found), vertices(&flipped), "{points:?} mirrored");
        let shifted: Vec<Point> = points.iter().map(|point| (point.0 + 7.25, point.1 - 3.5)).collect();
        let back: Vec<Vec<_>> = draw(&shifted)
            .iter()
            .map(|contour| contour.iter().map(|point| (point.0 - 29_696, point.1 + 14_336)).collect())
            .collect();
        assert_eq!(sorted(found.clone()), sorted(back), "{points:?} moved");
        // Another vertex half way, where it can be exactly.
        let even: Vec<Point> = points.iter().map(|point| (point.0 * 2.0, point.1 * 2.0)).collect();
        let mut split = vec![];
        for pair in even.windows(2) {
            split.push(pair[0]);
            split.push((f64::midpoint(pair[0].0, pair[1].0), f64::midpoint(pair[0].1, pair[1].1)));
        }
        split.push(even[even.len() - 1]);
        assert!(same(&draw(&even), &draw(&split), &mut rng), "{even:?} split");
    }
}

#[test]
fn what_makes_no_sense_draws_what_svg_says() {
    let line = polyline(&[(1.0, 1.0), (9.0, 5.0), (3.0, 9.0)], false);
    let path = Path::new(&line);
    let count = |style: StrokeStyle| Stroke::new(path, style).count().contours;
    assert_eq!(count(StrokeStyle::new(0)), 0);
    let solid = StrokeStyle::new(256);
    assert_eq!(count(solid), 1);
    assert_eq!(count(solid.dashes(&[0, 0])), 1);
    assert_eq!(count(solid.dashes(&[])), 1);
    let bevel = contours(&Stroke::new(path, solid.join(Join::Bevel)));
    assert_eq!(contours(&Stroke::new(path, solid.join(Join::Miter { limit: 0 }))), bevel);
    assert_eq!(contours(&Stroke::new(path, solid.join(Join::Miter { limit: 255 }))), bevel);
    let headless = [Element::Line(FinePoint::whole(9, 9))];
    assert_eq!(Stroke::new(Path::new(&headless), solid).count().contours, 0);
    // Of no length: closed or not, a dot, a square, nothing.
    for is_closed in [false, true] {
        let dot = polyline(&[(5.0, 5.0)], is_closed);
        let draw = |cap| contours(&Stroke::new(Path::new(&dot), solid.cap(cap)));
        assert_eq!(draw(Cap::Butt).len(), 0);
        assert!((area(&draw(Cap::Square), 64) - 1.0).abs() < 1e-9);
        assert!((area(&draw(Cap::Round), 512) - PI / 4.0).abs() < 1e-3);
    }
    // Dots: dashes without length.
    let dots = contours(&Stroke::new(path, solid.cap(Cap::Round).dashes(&[0, 512])));
    assert!((area(&dots, 512) / (PI / 4.0) - 9.0).abs() < 0.01, "{}", area(&dots, 512));
}

#[test]
fn no_stroke_is_too_wide_or_too_far() {
    let ends = [i32::MIN, -1, 0, i32::MAX];
    std::thread::scope(|scope| {
        for a in ends {
            scope.spawn(move || ends.map(|b| stroke_far(a, b)));
        }
    });
    let _ = Path::new(&[]).outline();
}

/// Any style, as wide as can be, between two coordinates.
fn stroke_far(a: i32, b: i32) {
    let [p, q] = [FinePoint::from_bits(a, b), FinePoint::from_bits(b, a)];
    let elements = [
        Element::Move(p),
        Element::Cubic(q, p, q),
        Element::Quadratic(p, q),
        Element::arc(q, p, Angle::fraction(1, 7), true, a > b, p),
        Element::Line(q),
        Element::Close,
    ];
    for (cap, join) in styles() {
        let style = StrokeStyle::new(u32::MAX).cap(cap).join(join);
        let path = Path::new(&elements).transformed(Transform::scaled(b, a));
        assert!(Stroke::new(path, style).count().contours < 1000);
        let dashes = [u32::MAX, 1 << 30];
        assert!(Stroke::new(Path::new(&elements), style.dashes(&dashes).phase(i32::MIN)).count().contours < 10_000);
    }
}

#[test]
fn what_is_transformed_goes_around_what_it_did() {
    let path = path!("M10 10H40V30L25 50Z");
    let squeeze = Transform::new([[1 << 15, 1 << 14], [0, 1 << 17]], FinePoint::whole(3, -5));
    let mirror = Transform::new([[-(1 << 16), 0], [0, 1 << 16]], FinePoint::whole(60, 0));
    for align in [Align::Center, Align::Inside, Align::Outside] {
        let stroke = Stroke::new(path, StrokeStyle::pixels(4).align(align));
        let plain = contours(&stroke);
        assert_eq!(contours(&Transformed::new(stroke, Transform::IDENTITY)), plain);
        for transform in [squeeze, mirror, mirror.then(squeeze)] {
            let transformed = Transformed::new(stroke, transform);
            let found = contours(&transformed);
            let extent = transformed.extent();
            for (contour, before) in found.iter().zip(&plain) {
                assert_eq!(contour.len(), before.len());
                for &(x, y) in before {
                    let FinePoint { x, y } = transform.apply(FinePoint::from_bits(x as i32, y as i32));
                    assert!(contour.contains(&(x.into(), y.into())));
                    assert!(extent.low.x <= x && x <= extent.high.x && extent.low.y <= y && y <= extent.high.y);
                }
            }
            for (x, y) in [(11.5, 12.5), (8.7, 9.0), (25.5, 20.5), (39.3, 15.5), (43.5, 10.5), (50.5, 50.5)] {
                let at = transform.apply(FinePoint::new(x, y));
                let at = (f64::from(at.x) / 4096.0 + 1e-5, f64::from(at.y) / 4096.0 + 1e-5);
                assert_eq!(winding(&found, at), winding(&plain, (x + 1e-5, y + 1e-5)), "{align:?} ({x}, {y})");
            }
        }
    }
}

/// How many pixels a polygon has that is collected from an outline.
fn collected_pixels(outline: &impl Outline) -> usize {
    struct Pixels(usize);

    impl SpanSink for Pixels {
        type Error = Infallible;

        fn span(&mut self, span: Span) -> Result<(), Infallible> {
            self.0 += span.columns.len();
            Ok(())
        }
    }

    let mut vertices = [Vertex::default(); 64];
    let mut edges = [ActiveEdge::EMPTY; 64];
    let polygon = collect(outline, &mut vertices).unwrap();
    let mut pixels = Pixels(0);
    let shape = polygon.in_scratch(&mut edges).unwrap();
    let Ok(()) = shape.spans(&shape.bounds(), &mut pixels);
    pixels.0
}

#[test]
fn what_is_collected_keeps_its_rule() {
    // 40 x 40 pixels, either way around; 32 x 32 are left within, 48 x 48 are without, with mitred corners.
    for path in [path!("M10 10h40v40h-40z"), path!("M10 10v40h40v-40z")] {
        let pixels = |align| collected_pixels(&Stroke::new(path, StrokeStyle::pixels(4).align(align)));
        assert_eq!(pixels(Align::Inside), 1600 - 1024);
        assert_eq!(pixels(Align::Outside), 2304 - 1600);
        assert_eq!(pixels(Align::Center), 44 * 44 - 36 * 36);
    }
    let nested = path!("M10 10h40v40h-40z M20 20h20v20h-20z").outline();
    assert_eq!(collected_pixels(&nested), 1600);
    assert_eq!(collected_pixels(&nested.fill_rule(FillRule::EvenOdd)), 1200);
}
