//! Strokes become outlines to fill or, when they are hairlines, thin lines.

use kurbo::{Affine, BezPath, PathEl, Point};
use spanfill::{
    Cap, Element, FinePoint, Join, Outline, OutlineSink, Path, Stroke, StrokeStyle, Transform, Transformed, Vertex,
};
use usvg::{
    LineCap, LineJoin,
    tiny_skia_path::{self, PathBuilder, PathSegment, StrokeDash},
};

use super::{flatten, transform::stretches};

/// What to draw for a stroke, in pixels.
#[derive(Debug)]
pub(crate) enum Stroked {
    Lines(Vec<[Vertex; 2]>),
    /// To be filled by the non-zero rule: the crate's own stroke.
    Contours(Vec<Vec<Vertex>>),
}

/// What becomes of a stroke that is thinner than a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Hairlines {
    /// It is drawn one pixel wide: where a pixel is filled when its centre is inside, a thinner outline would have gaps where
    /// it passes between centres.
    OnePixel,
    /// It is outlined as any other: where edges are blended, it is paler.
    AsWideAsTheyAre,
}

/// Dashes are cut from curves to within 1/(4 * scale) pixel.
const RESOLUTION_SCALE: f32 = 8.0;

/// Strokes `path`, given in user units.
///
/// A straight line of one pixel is the thin line of the crate, which without anti-aliasing has a pixel in each column (or
/// row). So may be whatever is thinner than a pixel. The ends of such hairlines have no caps, they would be half a pixel at
/// most.
pub(crate) fn stroke(path: &BezPath, style: &usvg::Stroke, to_device: Affine, hairlines: Hairlines) -> Option<Stroked> {
    // Stroked at the display's resolution, and only turned or squeezed afterwards: a drawing may be in units of miles or
    // microns.
    let (resolution, least) = stretches(to_device);
    if !(resolution.is_finite() && resolution > 0.0) {
        return None;
    }
    let pixels = scaled(path, resolution)?;
    let to_device = to_device * Affine::scale(1.0 / resolution);

    let mut stroke = style.to_tiny_skia();
    stroke.width = (f64::from(stroke.width) * resolution) as f32;
    let in_pixels = |length: f32| f64::from(length) * resolution;
    let lengths: Option<Vec<f64>> =
        style.dasharray().map(|lengths| lengths.iter().map(|&length| in_pixels(length)).collect());
    let offset = in_pixels(style.dashoffset());
    // Of thin lines; the crate dashes what it strokes.
    let dashed = || match &lengths {
        None => Some(pixels.clone()),
        Some(lengths) => {
            let lengths = lengths.iter().map(|&length| length as f32);
            pixels.dash(&StrokeDash::new(lengths.collect(), offset as f32)?, RESOLUTION_SCALE)
        }
    };

    // In 1/256 pixel, as coordinates are: a width of one pixel times a scale in single precision may exceed it a little.
    let width = (stroke.width * 256.0).round();
    let straight = matches!(path.elements(), [PathEl::MoveTo(_), PathEl::LineTo(_)]);
    let is_squeezed = least < resolution * (1.0 - 1.0 / 512.0);
    let is_line = match hairlines {
        Hairlines::OnePixel => width < 256.0 || (straight && width == 256.0),
        // As wide everywhere, and without caps.
        Hairlines::AsWideAsTheyAre => straight && width == 256.0 && style.linecap() == LineCap::Butt && !is_squeezed,
    };
    if is_line {
        let mut chain = to_device * bez_path(&dashed()?);
        if style.linecap() == LineCap::Butt {
            chain = without_dots(&chain);
        }
        return Some(Stroked::Lines(flatten::edges(&chain)));
    }
    // What is not squeezed goes where it will be. All else is stroked about the origin, for the crate's factors to be as good
    // as they can.
    let plane = bez_path(&pixels);
    let (plane, transform) = if is_squeezed {
        let center = plane.control_box().center().to_vec2();
        (Affine::translate(-center) * plane, in_fixed_point(to_device * Affine::translate(center)))
    } else {
        (to_device * plane, Transform::IDENTITY)
    };
    let elements = elements(&plane);
    // The casts saturate, and the crate has an end of widths of its own.
    let bits = |length: f64| (length * 256.0).round();
    let dashes: Vec<u32> = lengths.unwrap_or_default().iter().map(|&length| bits(length) as u32).collect();
    let style = crates_style(style, width as u32).dashes(&dashes).phase(bits(offset) as i32);
    let outline = Transformed::new(Stroke::new(Path::new(&elements), style), transform);
    Some(Stroked::Contours(contours(&outline)))
}

/// A transform in pixels as the crate's.
fn in_fixed_point(transform: Affine) -> Transform {
    let [xx, yx, xy, yy, x, y] = transform.as_coeffs();
    // The cast saturates.
    let factor = |factor: f64| (factor * 65536.0).round() as i32;
    Transform::new([[xx, xy], [yx, yy]].map(|row| row.map(factor)), FinePoint::new(x, y))
}

/// A path in pixels as the crate's.
fn elements(path: &BezPath) -> Vec<Element> {
    let fine = |point: Point| FinePoint::new(point.x, point.y);
    let element = |element: &PathEl| match *element {
        PathEl::MoveTo(to) => Element::Move(fine(to)),
        PathEl::LineTo(to) => Element::Line(fine(to)),
        PathEl::QuadTo(control, to) => Element::Quadratic(fine(control), fine(to)),
        PathEl::CurveTo(control1, control2, to) => Element::Cubic(fine(control1), fine(control2), fine(to)),
        PathEl::ClosePath => Element::Close,
    };
    path.elements().iter().map(element).collect()
}

fn crates_style(style: &usvg::Stroke, width: u32) -> StrokeStyle<'static> {
    let cap = match style.linecap() {
        LineCap::Butt => Cap::Butt,
        LineCap::Round => Cap::Round,
        LineCap::Square => Cap::Square,
    };
    let join = match style.linejoin() {
        // Clipped miters are those of a bevel for the crate.
        LineJoin::Miter | LineJoin::MiterClip => {
            Join::Miter { limit: (style.miterlimit().get() * 256.0).round() as u32 }
        }
        LineJoin::Round => Join::Round,
        LineJoin::Bevel => Join::Bevel,
    };
    StrokeStyle::new(width).cap(cap).join(join)
}

/// An outline's contours, in vertices.
fn contours(outline: &impl Outline) -> Vec<Vec<Vertex>> {
    #[derive(Default)]
    struct Contours {
        closed: Vec<Vec<Vertex>>,
        open: Vec<Vertex>,
    }

    impl OutlineSink for Contours {
        fn point(&mut self, x: i64, y: i64) {
            // Within what the crate makes: the casts keep it.
            self.open.push(FinePoint::from_bits(x as i32, y as i32).to_vertex());
        }

        fn close(&mut self) {
            self.closed.push(std::mem::take(&mut self.open));
        }
    }

    let mut contours = Contours::default();
    outline.emit(&mut contours);
    contours.closed
}

/// A sub-path without length shows its caps and nothing else: without caps it is not drawn.
fn without_dots(path: &BezPath) -> BezPath {
    let mut kept = BezPath::new();
    for sub_path in sub_paths(path) {
        let bounds = sub_path.control_box();
        if bounds.width() > 0.0 || bounds.height() > 0.0 {
            kept.extend(sub_path);
        }
    }
    kept
}

fn sub_paths(path: &BezPath) -> Vec<BezPath> {
    let mut all: Vec<BezPath> = Vec::new();
    for &element in path.elements() {
        match (element, all.last_mut()) {
            (PathEl::MoveTo(_), _) | (_, None) => all.push(BezPath::from_vec(vec![element])),
            (_, Some(current)) => current.push(element),
        }
    }
    all
}

/// The path of usvg's crate as one of kurbo's, in double precision.
pub(crate) fn bez_path(path: &tiny_skia_path::Path) -> BezPath {
    let point = |p: tiny_skia_path::Point| Point::new(f64::from(p.x), f64::from(p.y));
    path.segments()
        .map(|segment| match segment {
            PathSegment::MoveTo(to) => PathEl::MoveTo(point(to)),
            PathSegment::LineTo(to) => PathEl::LineTo(point(to)),
            PathSegment::QuadTo(control, to) => PathEl::QuadTo(point(control), point(to)),
            PathSegment::CubicTo(c1, c2, to) => PathEl::CurveTo(point(c1), point(c2), point(to)),
            PathSegment::Close => PathEl::ClosePath,
        })
        .collect()
}

/// The other way, multiplied by a factor. None when that leaves no path that could be stroked.
fn scaled(path: &BezPath, factor: f64) -> Option<tiny_skia_path::Path> {
    let single = |p: Point| ((p.x * factor) as f32, (p.y * factor) as f32);
    let mut builder = PathBuilder::new();
    for element in path.elements() {
        match *element {
            PathEl::MoveTo(to) => {
                let (x, y) = single(to);
                builder.move_to(x, y);
            }
            PathEl::LineTo(to) => {
                let (x, y) = single(to);
                builder.line_to(x, y);
            }
            PathEl::QuadTo(control, to) => {
                let ((x1, y1), (x, y)) = (single(control), single(to));
                builder.quad_to(x1, y1, x, y);
            }
            PathEl::CurveTo(control1, control2, to) => {
                let ((x1, y1), (x2, y2), (x, y)) = (single(control1), single(control2), single(to));
                builder.cubic_to(x1, y1, x2, y2, x, y);
            }
            PathEl::ClosePath => builder.close(),
        }
    }
    builder.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::Shape;

    fn stroked(element: &str, to_device: Affine) -> Option<Stroked> {
        stroked_as(element, to_device, Hairlines::OnePixel)
    }

    fn stroked_as(element: &str, to_device: Affine, hairlines: Hairlines) -> Option<Stroked> {
        let source = format!(r#"<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">{element}</svg>"#);
        let tree = usvg::Tree::from_str(&source, &usvg::Options::default()).expect("valid");
        let [usvg::Node::Path(path)] = tree.root().children() else { panic!("one path in {element}") };
        stroke(&bez_path(path.data()), path.stroke().expect("a stroke"), to_device, hairlines)
    }

    fn lines(element: &str, to_device: Affine) -> Vec<[Vertex; 2]> {
        match stroked(element, to_device) {
            Some(Stroked::Lines(lines)) => lines,
            other => panic!("lines, not {other:?}"),
        }
    }

    fn outline(element: &str, to_device: Affine) -> BezPath {
        outline_of(stroked(element, to_device))
    }

    fn outline_of(stroked: Option<Stroked>) -> BezPath {
        match stroked {
            Some(Stroked::Contours(contours)) => {
                let mut path = BezPath::new();
                for contour in contours {
                    let mut points = contour.iter().map(|vertex| Point::new(vertex.x.to_num(), vertex.y.to_num()));
                    path.move_to(points.next().expect("a contour has points"));
                    points.for_each(|point| path.line_to(point));
                    path.close_path();
                }
                path
            }
            other => panic!("an outline, not {other:?}"),
        }
    }

    const LINE: &str = r#"<line x1="1" y1="2" x2="5" y2="4" stroke="red" stroke-width="1"/>"#;

    #[test]
    fn a_line_of_up_to_one_pixel_is_a_hairline() {
        assert_eq!(lines(LINE, Affine::IDENTITY), [[Vertex::new(1, 2), Vertex::new(5, 4)]]);
        assert_eq!(lines(LINE, Affine::scale(0.5)), [[Vertex::new(0.5, 1), Vertex::new(2.5, 2)]]);
        let area = outline(LINE, Affine::scale(2.0)).area().abs();
        assert!((area - 2.0 * 80f64.sqrt()).abs() < 2e-2, "{area}");
    }

    #[test]
    fn blended_hairlines_are_as_wide_as_they_are() {
        let blended = |element: &str, to_device| stroked_as(element, to_device, Hairlines::AsWideAsTheyAre);
        let is_line = |stroked| matches!(stroked, Some(Stroked::Lines(lines)) if lines.len() == 1);
        assert!(is_line(blended(LINE, Affine::IDENTITY)));
        assert!(is_line(blended(LINE, Affine::rotate(0.5))));
        let thin = outline_of(blended(LINE, Affine::scale(0.5)));
        assert!((thin.area().abs() - 0.5 * 5f64.sqrt()).abs() < 1e-2, "{}", thin.area());
        assert!(!is_line(blended(LINE, Affine::scale_non_uniform(1.0, 0.5))));
        assert!(!is_line(blended(&LINE.replace("/>", r#" stroke-linecap="square"/>"#), Affine::IDENTITY)));
    }

    #[test]
    fn other_outlines_are_hairlines_only_below_one_pixel() {
        let square = |width| format!(r#"<path d="M1 1H5V5H1Z" fill="none" stroke="red" stroke-width="{width}"/>"#);
        assert_eq!(lines(&square(0.75), Affine::IDENTITY).len(), 4);
        let frame = outline(&square(1.0), Affine::IDENTITY);
        let covered = |x, y| frame.winding(Point::new(x, y)) != 0;
        assert!(covered(0.6, 0.6) && covered(3.0, 1.4) && covered(5.4, 5.4));
        assert!(!covered(0.4, 3.0) && !covered(3.0, 1.6) && !covered(5.6, 5.6));
    }

    #[test]
    fn a_squeezed_stroke_is_squeezed_after_stroking() {
        let area = outline(LINE, Affine::scale_non_uniform(8.0, 2.0)).area().abs();
        assert!((area - 16.0 * 20f64.sqrt()).abs() < 1e-2, "{area}");
    }

    #[test]
    fn a_squeezed_ring_lies_between_two_ellipses() {
        let circle = r#"<circle cx="100" cy="60" r="40" fill="none" stroke="red" stroke-width="10"/>"#;
        for (to_device, is_mirrored) in [
            (Affine::translate((30.0, -7.0)) * Affine::scale_non_uniform(3.0, 0.5), false),
            (Affine::scale_non_uniform(0.75, -4.0), true),
            (Affine::skew(0.8, 0.0) * Affine::rotate(0.3), false),
        ] {
            let ring = outline(circle, to_device);
            let [a, b, c, d, ..] = to_device.as_coeffs();
            let exact = std::f64::consts::PI * (45.0 * 45.0 - 35.0 * 35.0) * (a * d - b * c);
            assert_eq!(exact < 0.0, is_mirrored);
            assert!((ring.area().abs() - exact.abs()).abs() < 1e-3 * exact.abs(), "{} not {exact}", ring.area());
            for degrees in 0..360 {
                let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
                let at = |radius: f64| to_device * Point::new(100.0 + radius * cos, 60.0 + radius * sin);
                let is_inside = |radius: f64| ring.winding(at(radius)) != 0;
                assert!(is_inside(35.2) && is_inside(44.8), "{degrees}");
                assert!(!is_inside(34.8) && !is_inside(45.2), "{degrees}");
            }
        }
    }

    #[test]
    fn dashes_are_as_long_as_before_they_are_squeezed() {
        let dashed = r#"<path d="M10 10H50V50" fill="none" stroke="red" stroke-width="4" stroke-dasharray="15 5"/>"#;
        let outline = outline(dashed, Affine::scale_non_uniform(2.0, 8.0));
        // 15 of each 20, of 80 units in all, 4 wide; and the corner belongs to both of its lines, as to none.
        let area = outline.area().abs();
        assert!((area - 16.0 * 60.0 * 4.0).abs() < 1.0, "{area}");
        let covered = |x: f64, y: f64| outline.winding(Point::new(2.0 * x, 8.0 * y)) != 0;
        assert!(covered(11.0, 10.0) && covered(24.0, 10.0) && !covered(26.0, 10.0) && covered(31.0, 10.0));
        assert!(covered(50.0, 11.0) && covered(50.0, 24.0) && !covered(50.0, 26.0) && covered(50.0, 31.0));
    }

    #[test]
    fn tiny_units_are_stroked_like_large_ones() {
        let tiny = r#"<path d="M1e-5 2e-5 L5e-5 4e-5" stroke="red" stroke-width="1e-5"/>"#;
        let area = outline(tiny, Affine::scale(1e6)).area().abs();
        assert!((area - 200.0 * 5f64.sqrt()).abs() < 1e-1, "{area}");
    }

    #[test]
    fn dashes_are_separate_lines() {
        let dashed = r#"<line x1="0" y1="1" x2="9" y2="1" stroke="red" stroke-dasharray="2 1"/>"#;
        let expected = [(0, 2), (3, 5), (6, 8)].map(|(from, to)| [Vertex::new(from, 1), Vertex::new(to, 1)]);
        assert_eq!(lines(dashed, Affine::IDENTITY), expected);
    }

    #[test]
    fn dots_have_caps_or_are_not_drawn() {
        let dot = |cap| format!(r#"<path d="M1 1H1M2 2H4" stroke="red" stroke-width=".5" stroke-linecap="{cap}"/>"#);
        assert_eq!(lines(&dot("butt"), Affine::IDENTITY).len(), 1);
        assert_eq!(lines(&dot("round"), Affine::IDENTITY).len(), 2);
    }
}
