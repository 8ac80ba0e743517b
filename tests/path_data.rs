//! SVG path data: the elements that `svgtypes` reads, with arcs as `kurbo` has them, from thousands of strings.

use kurbo::{Arc, ParamCurve, Point, SvgArc, Vec2};
use spanfill::{Angle, Curve, Curves, Element, FinePoint, Outline, OutlineSink, Path, SvgElements, Transform, path};
use svgtypes::{PathParser, PathSegment};

/// A small generator, so that a failure can be repeated.
struct Rng(u64);

impl Rng {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, end: u64) -> u64 {
        (self.next() >> 11) % end
    }

    fn pick<'a>(&mut self, choices: &[&'a str]) -> &'a str {
        choices[usize::try_from(self.below(choices.len() as u64)).unwrap()]
    }
}

fn push_number(text: &mut String, rng: &mut Rng, is_positive: bool) {
    let whole = rng.below(40);
    let fraction = rng.below(1000);
    let number = match rng.below(6) {
        0 => format!("{whole}"),
        1 => format!(".{fraction:03}"),
        2 => format!("{whole}.{fraction:03}"),
        3 => format!("{whole}{fraction:03}e-2"),
        4 => format!(".{whole:02}E+1"),
        _ => format!("0{whole}.5"),
    };
    let sign = if is_positive { "" } else { rng.pick(&["", "", "-", "+"]) };
    // Nothing is needed between numbers where the next cannot be taken for part of the last.
    let needs_space = text.ends_with(|last: char| last.is_ascii_digit() || last == '.') && sign.is_empty();
    let may_follow = number.starts_with('.')
        && text.rsplit(|c: char| !(c.is_ascii_digit() || c == '.')).next().is_some_and(|last| last.contains('.'));
    let separators: &[&str] = match (needs_space, may_follow) {
        (true, false) => &[" ", ",", " , ", "\n"],
        _ => &["", " ", ","],
    };
    let has_number = text.ends_with(|last: char| last.is_ascii_digit() || last == '.');
    let separator = if has_number { rng.pick(separators) } else { rng.pick(&["", " "]) };
    text.push_str(separator);
    text.push_str(sign);
    text.push_str(&number);
}

fn push_numbers(text: &mut String, rng: &mut Rng, count: usize) {
    (0..count).for_each(|_| push_number(text, rng, false));
}

fn random_data(rng: &mut Rng) -> String {
    let mut text = String::from(rng.pick(&["M", "m", " M ", "\tm"]));
    push_numbers(&mut text, rng, 2);
    for _ in 0..rng.below(12) {
        let command = rng.pick(&[
            "M", "m", "L", "l", "H", "h", "V", "v", "C", "c", "S", "s", "Q", "q", "T", "t", "A", "a", "Z", "z",
        ]);
        text.push_str(rng.pick(&["", " "]));
        text.push_str(command);
        let count = match command {
            "H" | "h" | "V" | "v" => 1,
            "M" | "m" | "L" | "l" | "T" | "t" => 2,
            "S" | "s" | "Q" | "q" => 4,
            "C" | "c" => 6,
            "A" | "a" => {
                for _ in 0..=rng.below(2) {
                    push_number(&mut text, rng, true);
                    push_number(&mut text, rng, true);
                    push_number(&mut text, rng, false);
                    text.push_str(rng.pick(&[" ", ",", " , "]));
                    text.push_str(rng.pick(&["0", "1"]));
                    text.push_str(rng.pick(&["", " ", ","]));
                    text.push_str(rng.pick(&["0", "1"]));
                    // A flag is one digit: a number may follow at once.
                    let mut pair = String::new();
                    push_numbers(&mut pair, rng, 2);
                    text.push_str(&pair);
                }
                continue;
            }
            _ => continue,
        };
        for _ in 0..=rng.below(2) {
            push_numbers(&mut text, rng, count);
        }
    }
    text
}

fn is_of_a_number(first: char) -> bool {
    first.is_ascii_digit() || "+-.".contains(first)
}

fn near(found: FinePoint, expected: Point) -> bool {
    let close = |found: i32, expected: f64| {
        // What lies beyond the range is at its end.
        let expected = (expected * 4096.0).clamp(i32::MIN.into(), i32::MAX.into());
        (f64::from(found) - expected).abs() <= 0.51
    };
    close(found.x, expected.x) && close(found.y, expected.y)
}

/// What `svgtypes` reads, in absolute coordinates, held against the crate's elements.
fn check(data: &str) -> Result<(), String> {
    let found: Vec<_> = SvgElements::new(data, 1, 1).collect();
    let expected: Vec<_> = PathParser::from(data).collect();
    // `svgtypes` lets a comma stand before a command and at the end, which the grammar does not, and has an end of
    // numbers.
    let has_stray_comma = data.split(',').skip(1).any(|after| !after.trim_start().starts_with(is_of_a_number));
    let has_huge_number = expected.iter().any(|segment| matches!(segment, Err(svgtypes::Error::InvalidNumber(_))));
    let is_alike = found.iter().any(Result::is_err) == expected.iter().any(Result::is_err);
    // It also does not let a flag end with a space before its comma.
    let has_spaced_comma = data.contains(" ,");
    if !is_alike && !has_stray_comma && !has_huge_number && !has_spaced_comma {
        return Err(format!("{data:?}: {found:?}, not {expected:?}"));
    }
    let (mut start, mut at) = (Point::ZERO, Point::ZERO);
    let mut smooth: Option<(bool, Point)> = None;
    let pairs = found.iter().zip(&expected).map_while(|(found, expected)| Some((found.ok()?, expected.as_ref().ok()?)));
    for (index, (found, &expected)) in pairs.enumerate() {
        let from = if expected.is_abs() { Vec2::ZERO } else { at.to_vec2() };
        let place = |x: f64, y: f64| Point::new(x, y) + from;
        let reflected = |is_cubic: bool| match smooth {
            Some((kind, control)) if kind == is_cubic => at + (at - control),
            _ => at,
        };
        let mut next_smooth = None;
        let (is_right, to) = match (expected, found) {
            (PathSegment::MoveTo { x, y, .. }, Element::Move(to)) => {
                start = place(x, y);
                (near(to, start), start)
            }
            (PathSegment::LineTo { x, y, .. }, Element::Line(to)) => (near(to, place(x, y)), place(x, y)),
            (PathSegment::HorizontalLineTo { x, .. }, Element::Line(to)) => {
                let end = Point::new(from.x + x, at.y);
                (near(to, end), end)
            }
            (PathSegment::VerticalLineTo { y, .. }, Element::Line(to)) => {
                let end = Point::new(at.x, from.y + y);
                (near(to, end), end)
            }
            (PathSegment::CurveTo { x1, y1, x2, y2, x, y, .. }, Element::Cubic(a, b, to)) => {
                next_smooth = Some((true, place(x2, y2)));
                (near(a, place(x1, y1)) && near(b, place(x2, y2)) && near(to, place(x, y)), place(x, y))
            }
            (PathSegment::SmoothCurveTo { x2, y2, x, y, .. }, Element::Cubic(a, b, to)) => {
                next_smooth = Some((true, place(x2, y2)));
                (near(a, reflected(true)) && near(b, place(x2, y2)) && near(to, place(x, y)), place(x, y))
            }
            (PathSegment::Quadratic { x1, y1, x, y, .. }, Element::Quadratic(a, to)) => {
                next_smooth = Some((false, place(x1, y1)));
                (near(a, place(x1, y1)) && near(to, place(x, y)), place(x, y))
            }
            (PathSegment::SmoothQuadratic { x, y, .. }, Element::Quadratic(a, to)) => {
                next_smooth = Some((false, reflected(false)));
                (near(a, reflected(false)) && near(to, place(x, y)), place(x, y))
            }
            (PathSegment::EllipticalArc { rx, ry, x_axis_rotation, large_arc, sweep, x, y, .. }, element) => {
                let to = place(x, y);
                let svg = SvgArc {
                    from: at,
                    to,
                    radii: Vec2::new(rx, ry),
                    x_rotation: x_axis_rotation.to_radians(),
                    large_arc,
                    sweep,
                };
                (is_arc(element, &svg), to)
            }
            (PathSegment::ClosePath { .. }, Element::Close) => (true, start),
            _ => (false, at),
        };
        if !is_right {
            return Err(format!("{data:?}, element {index}: {found:?}, not {expected:?}"));
        }
        smooth = next_smooth;
        at = to;
    }
    Ok(())
}

/// The points of the arc lie where kurbo's do.
fn is_arc(element: Element, svg: &SvgArc) -> bool {
    let (Element::Arc(arc), Some(expected)) = (element, Arc::from_svg_arc(svg)) else {
        let Element::Line(to) = element else { return false };
        return near(to, svg.to) && (svg.from == svg.to || svg.radii.x.min(svg.radii.y) < 1e-5);
    };
    if !near(arc.to, svg.to) {
        return false;
    }
    let ends = svg.from.to_vec2().hypot().max(svg.to.to_vec2().hypot());
    let farthest = expected.radii.x.max(expected.radii.y).max(expected.center.to_vec2().hypot()).max(ends);
    // Radii are known to 2^-32 pixel, so needles that have to grow are known to as much less.
    let needle = farthest * 2f64.powi(-29) / svg.radii.x.min(svg.radii.y);
    if farthest > 500_000.0 || svg.x_rotation.abs() > 1e6 {
        // Beyond the range; what is left of it is an arc all the same.
        return true;
    }
    let sweep = f64::from(arc.sweep.to_bits()) / 2f64.powi(32) * std::f64::consts::TAU;
    let sweep = if arc.is_clockwise { sweep } else { -sweep };
    let start = f64::from(arc.start.to_bits()) / 2f64.powi(32) * std::f64::consts::TAU;
    let rotation = f64::from(arc.rotation.to_bits()) / 2f64.powi(32) * std::f64::consts::TAU;
    let pixels = |point: FinePoint| Vec2::new(f64::from(point.x), f64::from(point.y)) / 4096.0;
    let found = Arc {
        center: pixels(arc.center).to_point(),
        radii: pixels(arc.radii),
        start_angle: start,
        sweep_angle: sweep,
        x_rotation: rotation,
    };
    // A half circle's centre is as uncertain as the root of what its ends are off by.
    [0.0, 0.25, 0.5, 0.75, 1.0].into_iter().all(|t| {
        let at = |arc: &Arc| {
            let angle = arc.start_angle + t * arc.sweep_angle;
            let point = Vec2::new(arc.radii.x * angle.cos(), arc.radii.y * angle.sin());
            arc.center + (kurbo::Affine::rotate(arc.x_rotation) * point.to_point()).to_vec2()
        };
        (at(&found) - at(&expected)).hypot() < 2.0 / 4096.0 + farthest / 2f64.powi(25) + needle
    })
}

#[test]
fn twenty_thousand_strings_are_read_as_svgtypes_reads_them() {
    let mut rng = Rng(0x9e37_79b9_7f4a_7c15);
    let mut wrong = Vec::new();
    for _ in 0..20_000 {
        wrong.extend(check(&random_data(&mut rng)).err());
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong[..wrong.len().min(5)].join("\n"));
}

#[test]
fn broken_strings_are_errors_where_svgtypes_finds_them() {
    let mut rng = Rng(0x1234_5678_9abc_def1);
    let mut wrong = Vec::new();
    for _ in 0..20_000 {
        let mut data: Vec<u8> = random_data(&mut rng).into_bytes();
        for _ in 0..=rng.below(2) {
            let at = usize::try_from(rng.below(data.len() as u64)).unwrap();
            match rng.below(3) {
                0 => drop(data.remove(at)),
                1 => data.insert(at, rng.pick(&[",", "x", "-", ".", "e", "Z", "M", " ", "1"]).as_bytes()[0]),
                _ => data.truncate(at + 1),
            }
            if data.is_empty() {
                data.push(b'M');
            }
        }
        wrong.extend(check(std::str::from_utf8(&data).unwrap()).err());
    }
    assert!(wrong.is_empty(), "{} wrong:\n{}", wrong.len(), wrong[..wrong.len().min(8)].join("\n"));
}

#[test]
fn the_issues_examples() {
    const ICON: Path = path!("M12 2a10 10 0 1 0 0 20 10 10 0 100-20z");
    assert_eq!(ICON.elements().len(), 4);
    let Element::Arc(arc) = ICON.elements()[1] else { panic!("{:?}", ICON.elements()[1]) };
    assert_eq!((arc.center, arc.radii), (FinePoint::whole(12, 12), FinePoint::whole(10, 10)));
    assert_eq!((arc.start, arc.sweep, arc.is_clockwise), (Angle::fraction(3, 4), Angle::HALF, false));
    for data in ["", "M", "L1 1", "M1 1L", "M1 1z2 2", "M1 1,", "M1 1 a1 1 0 2 0 1 1", "M1 1x"] {
        let is_fine = data.is_empty();
        assert_eq!(Path::count_svg(data).is_ok(), is_fine, "{data}");
    }
    assert_eq!(Path::count_svg("M1 1a1 1 0 20 1 1").unwrap_err().position, 11);
    assert!(Path::parse_svg::<3>("M1 1L2 2", 1, 1).is_err());
}

#[test]
fn numbers_of_any_size_are_numbers() {
    let at = |text: &str| match SvgElements::new(text, 1, 1).next() {
        Some(Ok(Element::Move(point))) => point,
        other => panic!("{text}: {other:?}"),
    };
    assert_eq!(at("M1e99-1e99"), FinePoint::from_bits(i32::MAX, i32::MIN));
    assert_eq!(at("M1e-99-1e-999999999999"), FinePoint::default());
    assert_eq!(
        at("M0000000000000000000000000000000000001 .00000000000000000000000000000001e32"),
        FinePoint::whole(1, 1)
    );
    assert_eq!(at("M123456789012345678901234567890e-25 0e999"), FinePoint::new(12_345.678_901_234_5, 0));
    assert_eq!(at("M.000122070312500000000000001 .0001220703125"), FinePoint::from_bits(1, 1));
}

/// Every point, and every close as none.
#[derive(Default, PartialEq, Debug)]
struct Points(Vec<Option<(i64, i64)>>);

impl OutlineSink for Points {
    fn point(&mut self, x: i64, y: i64) {
        self.0.push(Some((x, y)));
    }

    fn close(&mut self) {
        self.0.push(None);
    }
}

fn points(outline: &impl Outline) -> Vec<Option<(i64, i64)>> {
    let mut points = Points::default();
    outline.emit(&mut points);
    points.0
}

#[test]
fn subpaths_are_those_of_svg() {
    let contours = |data: &str| {
        let elements: Vec<_> = SvgElements::new(data, 1, 1).map(Result::unwrap).collect();
        points(&Path::new(&elements)).iter().map(|point| point.map(|(x, y)| (x / 4096, y / 4096))).collect::<Vec<_>>()
    };
    assert_eq!(contours("M1 1M2 2"), []);
    assert_eq!(contours("M1 1L5 1zL1 7"), [Some((1, 1)), Some((5, 1)), None, Some((1, 1)), Some((1, 7)), None]);
    // A point has no inside.
    assert_eq!(contours("M1 1l1 1M5 5z"), [Some((1, 1)), Some((2, 2)), None]);
    let headless = [Element::Line(FinePoint::whole(1, 1)), Element::Close];
    assert_eq!(points(&Path::new(&headless)), []);
}

#[test]
fn curves_are_within_a_thousandth_of_a_pixel_and_the_same_from_either_end() {
    let mut rng = Rng(77);
    for size in [10.0, 100.0, 1000.0_f64] {
        for case in 0..300 {
            let mut point = || {
                (Vec2::new(rng.below(1 << 20) as f64, rng.below(1 << 20) as f64) * size / f64::from(1 << 20)).to_point()
            };
            let controls: [Point; 4] = std::array::from_fn(|_| point());
            let fine = controls.map(|p| FinePoint::new(p.x, p.y));
            let back = |p: FinePoint| (Vec2::new(f64::from(p.x), f64::from(p.y)) / 4096.0).to_point();
            let c = fine.map(back);
            let (curve, at): (_, Box<dyn Fn(f64) -> Point>) = if case % 2 == 0 {
                (
                    Curve::quadratic(fine[0], fine[1], fine[3]),
                    Box::new(move |t| kurbo::QuadBez::new(c[0], c[1], c[3]).eval(t)),
                )
            } else {
                (
                    Curve::cubic(fine[0], fine[1], fine[2], fine[3]),
                    Box::new(move |t| kurbo::CubicBez::new(c[0], c[1], c[2], c[3]).eval(t)),
                )
            };
            let mut chain: Vec<_> = std::iter::once(curve.from()).chain(curve.points()).collect();
            assert_eq!(chain.len(), curve.chords() as usize + 1);
            let hull = curve.hull();
            let holds =
                |p: &FinePoint| (hull.low.x..=hull.high.x).contains(&p.x) && (hull.low.y..=hull.high.y).contains(&p.y);
            assert!(chain.iter().all(holds));
            let steps = f64::from(curve.chords());
            for (index, pair) in chain.windows(2).enumerate() {
                for part in [0.0, 0.25, 0.5, 0.75, 1.0] {
                    let chord = back(pair[0]).lerp(back(pair[1]), part);
                    let distance = (chord - at((index as f64 + part) / steps)).hypot();
                    assert!(distance < 1.6 / 1024.0, "{size} {case} {index} {distance}");
                }
            }
            chain.reverse();
            let backwards: Vec<_> = std::iter::once(curve.to()).chain(curve.reversed().points()).collect();
            assert_eq!(chain, backwards);
        }
    }
}

/// Twice the area in square pixels.
fn doubled_area(points: &[Option<(i64, i64)>]) -> f64 {
    let mut area = 0.0;
    for contour in points.split(Option::is_none) {
        let at = |index: usize| contour[index % contour.len()].unwrap();
        for index in 0..contour.len() {
            let ((x0, y0), (x1, y1)) = (at(index), at(index + 1));
            area += (x0 * y1 - x1 * y0) as f64;
        }
    }
    area / (4096.0 * 4096.0)
}

#[test]
fn circles_keep_their_area() {
    for radius in [1, 5, 20, 100, 500] {
        let data = format!("M{radius} 0A{radius} {radius} 0 0 1-{radius} 0A{radius} {radius} 0 0 1 {radius} 0z");
        let elements: Vec<_> = SvgElements::new(&data, 1, 1).map(Result::unwrap).collect();
        let area = doubled_area(&points(&Path::new(&elements))) / 2.0;
        let exact = std::f64::consts::PI * f64::from(radius).powi(2);
        let width = (area - exact) / (2.0 * std::f64::consts::PI * f64::from(radius));
        // As if the outline were moved by less than a 1/8192 of a pixel on average.
        assert!(width.abs() < 1.0 / 8192.0, "{radius}: {width}");
    }
}

#[test]
fn transforms_move_curves_and_arcs_alike() {
    const SHAPE: Path = path!("M2 3c4-1 8 2 9 7a5 3 30 0 1-6 4q-6 1-3-11z");
    let angle = Angle::degrees(37);
    let moved = SHAPE
        .transformed(Transform::turned(angle))
        .transformed(Transform::scaled(3 << 16, 1 << 15))
        .moved(FinePoint::whole(100, -7));
    let area = doubled_area(&points(&SHAPE));
    let moved_area = doubled_area(&points(&moved));
    assert!((moved_area / area - 1.5).abs() < 2e-4, "{area} {moved_area}");
    // Once more around: every point comes back.
    let there = SHAPE.transformed(Transform::turned_about(FinePoint::whole(5, 5), angle));
    let back = there.transformed(Transform::turned_about(FinePoint::whole(5, 5), -angle));
    for (there, back) in points(&SHAPE).iter().zip(points(&back)) {
        if let (Some((x0, y0)), Some((x1, y1))) = (*there, back) {
            assert!((x0 - x1).abs() <= 3 && (y0 - y1).abs() <= 3, "{there:?} {back:?}");
        }
    }
}

#[test]
fn no_coordinate_is_too_far() {
    let ends = [i32::MIN, -1, 0, i32::MAX];
    for a in ends {
        for b in ends {
            let [p, q] = [FinePoint::from_bits(a, b), FinePoint::from_bits(b, a)];
            for turn in [0, 3, 4] {
                let elements = [
                    Element::Move(p),
                    Element::Cubic(q, p, q),
                    Element::Quadratic(p, q),
                    Element::arc(q, p, Angle::fraction(turn, 7), true, a > b, p),
                    Element::Close,
                ];
                let transform = Transform::new([[a, b], [b, a]], q);
                for path in [Path::new(&elements), Path::new(&elements).transformed(transform)] {
                    assert_eq!(path.outline().count().contours, 1);
                    let bounds = path.extent();
                    assert!(bounds.low.x <= bounds.high.x);
                }
            }
        }
    }
}
