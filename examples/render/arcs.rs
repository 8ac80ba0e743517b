//! Splits the elliptical arcs of path data before usvg turns them into cubics.
//!
//! usvg replaces an arc by cubics that are within a tenth of a user unit of it, whatever a unit becomes on the display. Of
//! arcs as short as those made here, its cubics are within 1e-7 of the radius. (Circles and ellipses are recognised
//! afterwards, see `ellipse`. What remains are the corners of rounded rectangles: 1/8 pixel is reached at a radius
//! of 330 pixels.)

use std::{collections::BTreeMap, fmt::Write as _};

use kurbo::{Arc, Point, SvgArc, Vec2};
use svgtypes::{PathParser, PathSegment};
use usvg::roxmltree::Document;

/// Sixteen to a full turn.
const LONGEST_PIECE: f64 = std::f64::consts::TAU / 16.0;

/// The same file with shorter arcs, or none when it has no arcs.
pub(crate) fn split_arcs(document: &Document<'_>) -> Option<String> {
    let source = document.input_text();
    // By position: an element that comes from an entity is found wherever the entity is used.
    let mut replacements = BTreeMap::new();
    let paths = document.descendants().filter(|node| node.tag_name().name() == "path");
    for data in paths.filter_map(|path| path.attribute_node("d")).filter(|data| data.value().contains(['A', 'a'])) {
        let range = data.range_value();
        replacements.insert(range.start, (range.end, split_in(data.value())));
    }
    if replacements.is_empty() {
        return None;
    }
    let mut result = String::with_capacity(source.len() * 2);
    let mut copied = 0;
    for (start, (end, data)) in replacements {
        result.push_str(&source[copied..start]);
        result.push_str(&data);
        copied = end;
    }
    result.push_str(&source[copied..]);
    Some(result)
}

/// Path data up to its first error: viewers draw no more either.
fn split_in(data: &str) -> String {
    let mut text = String::new();
    let mut start = Point::ZERO;
    let mut from = Point::ZERO;
    for segment in PathParser::from(data).map_while(Result::ok) {
        let origin = if segment.is_abs() { Point::ZERO } else { from };
        let to = match segment {
            PathSegment::HorizontalLineTo { x, .. } => Point::new(origin.x + x, from.y),
            PathSegment::VerticalLineTo { y, .. } => Point::new(from.x, origin.y + y),
            PathSegment::ClosePath { .. } => start,
            PathSegment::MoveTo { x, y, .. }
            | PathSegment::LineTo { x, y, .. }
            | PathSegment::CurveTo { x, y, .. }
            | PathSegment::SmoothCurveTo { x, y, .. }
            | PathSegment::Quadratic { x, y, .. }
            | PathSegment::SmoothQuadratic { x, y, .. }
            | PathSegment::EllipticalArc { x, y, .. } => origin + Vec2::new(x, y),
        };
        match segment {
            PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, .. } => {
                let arc = SvgArc {
                    from,
                    to,
                    radii: Vec2::new(rx, ry),
                    x_rotation: x_axis_rotation.to_radians(),
                    large_arc,
                    sweep,
                };
                write_arc(&mut text, &arc, x_axis_rotation);
            }
            _ => write_segment(&mut text, &segment),
        }
        if let PathSegment::MoveTo { .. } = segment {
            start = to;
        }
        from = to;
    }
    text
}

fn write_arc(text: &mut String, svg_arc: &SvgArc, degrees: f64) {
    let SvgArc { to, sweep, .. } = *svg_arc;
    let Some(arc) = Arc::from_svg_arc(svg_arc) else {
        return write_command(text, 'L', &[to.x, to.y]);
    };
    // At most a full turn; the cast keeps the whole number that it is given.
    let pieces = (arc.sweep_angle.abs() / LONGEST_PIECE).ceil().clamp(1.0, 16.0) as u32;
    for piece in 1..=pieces {
        let angle = arc.start_angle + arc.sweep_angle * f64::from(piece) / f64::from(pieces);
        let on_circle = Vec2::from_angle(angle);
        let turn = kurbo::Affine::rotate(arc.x_rotation);
        let joint = arc.center + (turn * Point::new(arc.radii.x * on_circle.x, arc.radii.y * on_circle.y)).to_vec2();
        // The last piece ends exactly where the arc did.
        let end = if piece == pieces { to } else { joint };
        let sweep = f64::from(u8::from(sweep));
        write_command(text, 'A', &[arc.radii.x, arc.radii.y, degrees, 0.0, sweep, end.x, end.y]);
    }
}

/// The segment as it was.
fn write_segment(text: &mut String, segment: &PathSegment) {
    let command = char::from(segment.command());
    match *segment {
        PathSegment::MoveTo { x, y, .. }
        | PathSegment::LineTo { x, y, .. }
        | PathSegment::SmoothQuadratic { x, y, .. } => {
            write_command(text, command, &[x, y]);
        }
        PathSegment::HorizontalLineTo { x, .. } => write_command(text, command, &[x]),
        PathSegment::VerticalLineTo { y, .. } => write_command(text, command, &[y]),
        PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. } => write_command(text, command, &[x1, y1, x2, y2, x, y]),
        PathSegment::SmoothCurveTo { x2: x1, y2: y1, x, y, .. } | PathSegment::Quadratic { x1, y1, x, y, .. } => {
            write_command(text, command, &[x1, y1, x, y]);
        }
        PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. } => {
            let flags = [large_arc, sweep].map(|flag| f64::from(u8::from(flag)));
            write_command(text, command, &[rx, ry, x_axis_rotation, flags[0], flags[1], x, y]);
        }
        PathSegment::ClosePath { .. } => write_command(text, command, &[]),
    }
}

/// Numbers as the shortest text that reads back as the same number.
fn write_command(text: &mut String, command: char, numbers: &[f64]) {
    text.push(command);
    for number in numbers {
        write!(text, " {number}").expect("a String takes any text");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn other_segments_stay() {
        let data = "M1 2m3 4H5v-6L7 8c1 2 3 4 5 6S1 2 3 4Q1 2 3 4t5 6z";
        assert_eq!(split_in(data), "M 1 2m 3 4H 5v -6L 7 8c 1 2 3 4 5 6S 1 2 3 4Q 1 2 3 4t 5 6z");
        assert_eq!(split_in("M1 2L3 4L5x"), "M 1 2L 3 4");
    }

    #[test]
    fn a_straight_arc_is_a_line() {
        assert_eq!(split_in("M1 2a0 5 0 0 1 3 4z"), "M 1 2L 4 6z");
    }

    #[test]
    fn pieces_of_an_arc_lie_on_it_and_end_where_it_ended() {
        let data = split_in("M10 0 A10 10 0 0 1 0 10 L1 1 z m1 1 a5 5 0 1 0 0 .5");
        let points: Vec<_> = PathParser::from(data.as_str())
            .map(|segment| segment.expect("valid path data"))
            .filter_map(|segment| match segment {
                PathSegment::EllipticalArc { abs, x, y, .. } => Some((abs, Point::new(x, y))),
                _ => None,
            })
            .collect();
        assert_eq!(points.len(), 4 + 16);
        assert_eq!(points[3], (true, Point::new(0.0, 10.0)));
        assert_eq!(points[19], (true, Point::new(11.0, 1.5)));
        for &(_, point) in &points[..4] {
            assert!((point.distance(Point::ZERO) - 10.0).abs() < 1e-12, "{point}");
        }
    }

    #[test]
    fn only_path_data_is_rewritten() {
        let source = "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0A1 1 0 0 1 0 0z'/>é<a d='A'/><path id='A' d='M1 1&#10;a0 0 0 0 0 2 2'/></svg>";
        let document = Document::parse(source).expect("well-formed");
        let expected = "<svg xmlns='http://www.w3.org/2000/svg'><path d='M 0 0L 0 0z'/>é<a d='A'/><path id='A' d='M 1 1L 3 3'/></svg>";
        assert_eq!(split_arcs(&document).as_deref(), Some(expected));
        assert_eq!(split_arcs(&Document::parse("<svg><path d='M1 1L2 2'/></svg>").expect("well-formed")), None);
    }
}
