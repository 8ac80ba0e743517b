//! Curves become chains of straight edges, and positions the crate's vertices.

use kurbo::{BezPath, PathEl, Point, Vec2};
use spanfill::Vertex;

/// How far, in pixels, a chain of edges may be from the curve that it stands for.
///
/// Rounding to 1/256 pixel may add 0.003 to it.
const TOLERANCE: f64 = 1.0 / 32.0;

/// More edges than any curve needs whose control points are valid vertices.
///
/// Second differences of such points are below 4 * 2^23 along each axis, hence below 2^25.5 pixels:
/// sqrt(6/8 * 2^25.5 / TOLERANCE) < 2^16.
const MOST_EDGES: f64 = 65_536.0;

/// One contour for each sub-path, in the order of the path. Points on straight stretches are neither added nor left
/// out. `path` is in pixels.
pub(crate) fn flatten(path: &BezPath) -> Vec<Vec<Vertex>> {
    sub_paths(path).into_iter().map(|sub_path| sub_path.points.into_iter().map(vertex).collect()).collect()
}

/// The straight edges of a path, those that close a sub-path included.
pub(crate) fn edges(path: &BezPath) -> Vec<[Vertex; 2]> {
    let mut edges = Vec::new();
    for SubPath { points, closed } in sub_paths(path) {
        edges.extend(points.windows(2).map(|pair| [vertex(pair[0]), vertex(pair[1])]));
        if let ([first, .., last], true) = (points.as_slice(), closed) {
            edges.push([vertex(*last), vertex(*first)]);
        }
    }
    edges
}

/// Nearest 1/256; what lies beyond the crate's range saturates.
pub(crate) fn vertex(point: Point) -> Vertex {
    Vertex::new(point.x, point.y)
}

#[derive(Default)]
struct SubPath {
    points: Vec<Point>,
    closed: bool,
}

fn sub_paths(path: &BezPath) -> Vec<SubPath> {
    let mut done = Vec::new();
    let mut current = SubPath::default();
    for element in path.elements() {
        let from = current.points.last().copied().unwrap_or_default();
        match *element {
            PathEl::MoveTo(to) => {
                done.push(std::mem::take(&mut current));
                current.points.push(to);
            }
            PathEl::LineTo(to) => current.points.push(to),
            PathEl::QuadTo(control, to) => quadratic(from, control, to, &mut current.points),
            PathEl::CurveTo(control1, control2, to) => cubic(from, control1, control2, to, &mut current.points),
            PathEl::ClosePath => {
                current.closed = true;
                // A segment after this one, without a move of its own, starts where this sub-path did.
                let start = current.points.first().copied().unwrap_or_default();
                done.push(std::mem::take(&mut current));
                current.points.push(start);
            }
        }
    }
    done.push(current);
    // A move that nothing follows draws nothing.
    done.retain(|sub_path| sub_path.points.len() > 1 || sub_path.closed);
    done
}

/// The number of equal steps of the parameter that keep the chords of a curve of degree n within the tolerance.
///
/// Wang's bound: a chord over a step of 1/k is at most n(n-1)/8 * M / k^2 away, M being the greatest second difference
/// of the control points (Wang 1984; Goldman, "Pyramid Algorithms", section 5.6.3).
fn steps(degree: f64, greatest_second_difference: f64) -> u32 {
    let squared = degree * (degree - 1.0) / 8.0 * greatest_second_difference / TOLERANCE;
    // The cast saturates; the value is between 1 and MOST_EDGES.
    squared.sqrt().ceil().clamp(1.0, MOST_EDGES) as u32
}

fn quadratic(p0: Point, p1: Point, p2: Point, points: &mut Vec<Point>) {
    let second = second_difference(p0, p1, p2).hypot();
    append(steps(2.0, second), p2, points, |t| {
        let s = 1.0 - t;
        (p0.to_vec2() * (s * s) + p1.to_vec2() * (2.0 * s * t) + p2.to_vec2() * (t * t)).to_point()
    });
}

fn cubic(p0: Point, p1: Point, p2: Point, p3: Point, points: &mut Vec<Point>) {
    let second = second_difference(p0, p1, p2).hypot().max(second_difference(p1, p2, p3).hypot());
    append(steps(3.0, second), p3, points, |t| {
        let s = 1.0 - t;
        (p0.to_vec2() * (s * s * s)
            + p1.to_vec2() * (3.0 * s * s * t)
            + p2.to_vec2() * (3.0 * s * t * t)
            + p3.to_vec2() * (t * t * t))
            .to_point()
    });
}

fn second_difference(a: Point, b: Point, c: Point) -> Vec2 {
    a.to_vec2() - b.to_vec2() * 2.0 + c.to_vec2()
}

fn append(steps: u32, end: Point, points: &mut Vec<Point>, at: impl Fn(f64) -> Point) {
    points.extend((1..steps).map(|step| at(f64::from(step) / f64::from(steps))));
    // Not `at(1.0)`: neighbours meet in the same point, whatever the arithmetic above rounds to.
    points.push(end);
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{CubicBez, ParamCurve, ParamCurveNearest, QuadBez, Shape};

    #[test]
    fn straight_outlines_are_not_altered() {
        let path = BezPath::from_svg("M1 2 L3 2 L3 2 L5 2 L5 9 Z M0 0 L4 0 L0 0 Z").expect("valid path data");
        let expected: [&[(i32, i32)]; 2] = [&[(1, 2), (3, 2), (3, 2), (5, 2), (5, 9)], &[(0, 0), (4, 0), (0, 0)]];
        let expected = expected.map(|contour| contour.iter().map(|&(x, y)| Vertex::new(x, y)).collect::<Vec<_>>());
        assert_eq!(flatten(&path), expected);
    }

    #[test]
    fn a_segment_after_a_close_starts_where_the_sub_path_did() {
        let path = BezPath::from_vec(vec![
            PathEl::MoveTo(Point::new(1.0, 1.0)),
            PathEl::LineTo(Point::new(5.0, 1.0)),
            PathEl::ClosePath,
            PathEl::LineTo(Point::new(1.0, 7.0)),
        ]);
        let expected = [[(1, 1), (5, 1)], [(1, 1), (1, 7)]].map(|pair| pair.map(|(x, y)| Vertex::new(x, y)).to_vec());
        assert_eq!(flatten(&path), expected);
        let [a, b, c] = [(1, 1), (5, 1), (1, 7)].map(|(x, y)| Vertex::new(x, y));
        assert_eq!(edges(&path), [[a, b], [b, a], [a, c]]);
    }

    #[test]
    fn coordinates_go_to_the_nearest_256th() {
        assert_eq!(vertex(Point::new(1.499 / 256.0, -1.501 / 256.0)), Vertex::from_bits(1, -2));
        assert_eq!(vertex(Point::new(1e30, -1e30)), Vertex::from_bits(i32::MAX, i32::MIN));
    }

    /// The greatest distance from points of the curve to the chain, looked for at 1000 places.
    fn distance(chain: &[Point], at: impl Fn(f64) -> Point) -> f64 {
        let segments: Vec<_> = chain.windows(2).map(|pair| kurbo::Line::new(pair[0], pair[1])).collect();
        (0..=1000)
            .map(|i| at(f64::from(i) / 1000.0))
            .map(|point| {
                let nearest = segments.iter().map(|segment| segment.nearest(point, 1e-9).distance_sq);
                nearest.fold(f64::INFINITY, f64::min).sqrt()
            })
            .fold(0.0, f64::max)
    }

    #[test]
    fn curves_stay_within_the_tolerance() {
        for size in [0.5, 7.0, 100.0, 3000.0] {
            let [a, b, c, d] =
                [(0.1, 0.2), (0.9, -0.4), (-0.3, 1.7), (1.0, 0.6)].map(|(x, y)| Point::new(x * size, y * size));
            let mut chain = vec![a];
            cubic(a, b, c, d, &mut chain);
            let curve = CubicBez::new(a, b, c, d);
            assert!(distance(&chain, |t| curve.eval(t)) <= TOLERANCE, "cubic of {size}");

            let mut chain = vec![a];
            quadratic(a, b, c, &mut chain);
            let curve = QuadBez::new(a, b, c);
            assert!(distance(&chain, |t| curve.eval(t)) <= TOLERANCE, "quadratic of {size}");
        }
    }

    #[test]
    fn an_absurd_curve_ends() {
        let far = 1e300;
        let mut points = vec![Point::ZERO];
        cubic(Point::ZERO, Point::new(far, -far), Point::new(-far, far), Point::new(1.0, 1.0), &mut points);
        assert_eq!(points.len(), 65_537);
    }

    #[test]
    fn a_flattened_disc_has_the_area_of_the_disc() {
        let radius = 50.0;
        let path = kurbo::Circle::new((60.0, 60.0), radius).to_path(1e-3);
        let contours = flatten(&path);
        let [contour] = contours.as_slice() else { panic!("one contour, not {}", contours.len()) };
        let corners: Vec<_> = contour.iter().map(|v| Point::new(v.x.to_num(), v.y.to_num())).collect();
        let mut polygon = BezPath::new();
        polygon.move_to(corners[0]);
        corners[1..].iter().for_each(|&corner| polygon.line_to(corner));
        polygon.close_path();
        let disc = std::f64::consts::PI * radius * radius;
        let band = 2.0 * std::f64::consts::PI * radius * TOLERANCE;
        assert!((polygon.area() - disc).abs() < band);
    }
}
