//! Finds circles and ellipses again after usvg has turned them into curves.

use kurbo::{Affine, Point, Vec2};
use spanfill::{I24F8, Vertex};
use usvg::tiny_skia_path::{Path, PathSegment};

use super::{flatten::vertex, transform::stretches};

/// An ellipse with upright axes, in the coordinates of its element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Ellipse {
    pub(crate) center: Point,
    pub(crate) radii: Vec2,
}

/// A cubic that stands for a quarter of a circle is at most 2.73e-4 of the radius away from it; the rest is for
/// single-precision coordinates far from the origin.
const QUARTER_ARC_ERROR: f64 = 3.0e-4;

/// Where the quarters of the unit circle begin and end.
const EXTREMES: [Vec2; 5] =
    [Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0), Vec2::new(-1.0, 0.0), Vec2::new(0.0, -1.0), Vec2::new(1.0, 0.0)];

impl Ellipse {
    /// The ellipse that a path stands for, if it does.
    ///
    /// usvg writes `circle` and `ellipse` as a move to the rightmost point and one or, for large radii or far from the
    /// origin, more cubics to the lowest, the leftmost, the highest and again the rightmost point, closed. Its tree has no other trace of the
    /// element: only some paths have an `id`, and a path may come from `use`, a marker, or a style that alters the
    /// radius, so the XML source cannot tell either. The geometry can: a path that has this structure, and at every
    /// joint and between them stays within a cubic's own error of the ellipse, *is* that ellipse for any viewer.
    pub(crate) fn recognise(path: &Path) -> Option<Self> {
        let mut segments = path.segments();
        let PathSegment::MoveTo(start) = segments.next()? else { return None };
        let start = point(start);
        let mut cubics = Vec::new();
        let mut from = start;
        loop {
            match segments.next()? {
                PathSegment::CubicTo(control1, control2, to) => {
                    cubics.push([from, point(control1), point(control2), point(to)]);
                    from = point(to);
                }
                PathSegment::Close => break,
                PathSegment::MoveTo(_) | PathSegment::LineTo(_) | PathSegment::QuadTo(..) => return None,
            }
        }
        if segments.next().is_some() {
            return None;
        }

        // Exact where usvg added nothing to the centre.
        let ends = || cubics.iter().map(|cubic| cubic[3]);
        let lowest = ends().max_by(|p, q| p.y.total_cmp(&q.y))?;
        let leftmost = ends().min_by(|p, q| p.x.total_cmp(&q.x))?;
        let center = Point::new(lowest.x, start.y);
        let radii = Vec2::new((start.x - leftmost.x) / 2.0, lowest.y - center.y);
        if !(radii.x > 0.0 && radii.y > 0.0) {
            return None;
        }

        // In units of the radii, so that the ellipse is the unit circle.
        let unit = |p: Point| Vec2::new((p.x - center.x) / radii.x, (p.y - center.y) / radii.y);
        let magnitude = center.x.abs().max(center.y.abs()) / radii.x.min(radii.y);
        let tolerance = QUARTER_ARC_ERROR + 4.0 * f64::from(f32::EPSILON) * (1.0 + magnitude);
        if (unit(start) - EXTREMES[0]).hypot() > tolerance {
            return None;
        }
        // Each quarter is the way from one extreme to the next.
        let mut quarter = 0;
        for cubic in cubics {
            let [from, to] = [EXTREMES.get(quarter)?, EXTREMES.get(quarter + 1)?];
            let [p0, p1, p2, p3] = cubic.map(unit);
            for eighth in 0..=8 {
                let t = f64::from(eighth) / 8.0;
                let s = 1.0 - t;
                let on_curve = p0 * (s * s * s) + p1 * (3.0 * s * s * t) + p2 * (3.0 * s * t * t) + p3 * (t * t * t);
                let in_quarter = on_curve.dot(*from) >= -tolerance && on_curve.dot(*to) >= -tolerance;
                if !in_quarter || (on_curve.hypot() - 1.0).abs() > tolerance {
                    return None;
                }
            }
            if (p3 - *to).hypot() <= tolerance {
                quarter += 1;
            }
        }
        if quarter != 4 {
            return None;
        }
        Some(Self { center, radii })
    }

    /// Centre and radius on the display, if it is a circle there to within 1/256 pixel.
    pub(crate) fn circle(&self, to_device: Affine) -> Option<(Vertex, I24F8)> {
        let unit_circle = to_device
            * Affine::translate(self.center.to_vec2())
            * Affine::scale_non_uniform(self.radii.x, self.radii.y);
        let (long, short) = stretches(unit_circle);
        let center = vertex(to_device * self.center);
        let radius = I24F8::saturating_from_num(long.midpoint(short));
        (long - short < 1.0 / 256.0).then_some((center, radius))
    }
}

fn point(p: usvg::tiny_skia_path::Point) -> Point {
    Point::new(f64::from(p.x), f64::from(p.y))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What usvg makes of one element.
    fn path_of(element: &str) -> Path {
        let source = format!(r#"<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">{element}</svg>"#);
        let tree = usvg::Tree::from_str(&source, &usvg::Options::default()).expect("valid");
        match tree.root().children() {
            [usvg::Node::Path(path)] => path.data().clone(),
            other => panic!("one path, not {other:?}"),
        }
    }

    fn recognised(element: &str) -> Option<Ellipse> {
        Ellipse::recognise(&path_of(element))
    }

    #[test]
    fn circles_of_every_size_are_recognised() {
        for radius in [0.01, 0.5, 1.0, 3.25, 10.3, 99.9, 366.0, 400.0, 5_000.0, 50_000.0] {
            for (x, y) in [(0.0, 0.0), (123.45, -7.7), (-2000.125, 801.0)] {
                let found = recognised(&format!(r#"<circle cx="{x}" cy="{y}" r="{radius}"/>"#));
                let found = found.unwrap_or_else(|| panic!("circle {x} {y} {radius}"));
                let single = 2e-7 * (radius + 2000.0);
                assert!(found.center.distance(Point::new(x, y)) < single, "{found:?} {x} {y} {radius}");
                assert!((found.radii - Vec2::new(radius, radius)).hypot() < single, "{found:?} {radius}");
            }
        }
    }

    #[test]
    fn ellipses_are_recognised() {
        let found = recognised(r#"<ellipse cx="5" cy="6" rx="40" ry="1.5"/>"#);
        assert_eq!(found, Some(Ellipse { center: Point::new(5.0, 6.0), radii: Vec2::new(40.0, 1.5) }));
    }

    #[test]
    fn look_alikes_are_not() {
        for element in [
            // Straight, open, half, squared, flattened, twice around, another start, a rounded rectangle.
            r#"<path d="M4 0 L0 4 L-4 0 L0 -4 Z"/>"#,
            r#"<path d="M4 0 A4 4 0 0 1 0 4 A4 4 0 0 1 -4 0 A4 4 0 0 1 0 -4 A4 4 0 0 1 4 0"/>"#,
            r#"<path d="M4 0 A4 4 0 0 1 -4 0 Z"/>"#,
            r#"<path d="M4 0 C4 3 3 4 0 4 C-3 4 -4 3 -4 0 C-4 -3 -3 -4 0 -4 C3 -4 4 -3 4 0 Z"/>"#,
            r#"<path d="M4 0 C4 2 2 4 0 4 C-2 4 -4 2 -4 0 C-4 -2 -2 -4 0 -4 C2 -4 4 -2 4 0 Z"/>"#,
            r#"<path d="M4 0 A4 4 0 1 1 -4 0 A4 4 0 1 1 4 0 A4 4 0 1 1 -4 0 A4 4 0 1 1 4 0 Z"/>"#,
            r#"<path d="M0 4 A4 4 0 0 1 -4 0 A4 4 0 0 1 0 -4 A4 4 0 0 1 4 0 A4 4 0 0 1 0 4 Z"/>"#,
            r#"<rect width="9" height="9" rx="3"/>"#,
        ] {
            assert_eq!(recognised(element), None, "{element}");
        }
    }

    #[test]
    fn only_a_uniform_scale_keeps_a_circle() {
        let circle = Ellipse { center: Point::new(10.0, 20.0), radii: Vec2::new(4.0, 4.0) };
        let expected = Some((Vertex::new(25, 50), I24F8::from_num(10)));
        assert_eq!(circle.circle(Affine::scale(2.5)), expected);
        let turned = Affine::translate((25.0, 50.0)) * Affine::rotate(1.0) * Affine::scale(2.5);
        assert_eq!(circle.circle(turned * Affine::translate((-10.0, -20.0))), expected);
        assert_eq!(circle.circle(Affine::scale_non_uniform(2.5, -2.5)).map(|(_, r)| r), Some(I24F8::from_num(10)));
        assert_eq!(circle.circle(Affine::scale_non_uniform(2.5, 2.4)), None);
        assert_eq!(circle.circle(Affine::skew(0.01, 0.0)), None);
    }
}
