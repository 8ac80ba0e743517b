//! Outlines blended: coverage against the true area of strokes, rings, ellipses and curves.

mod oracle;

use oracle::{CoverageGrid, coverage, rect};
use spanfill::{
    Align, Angle, Arc, Cap, CoverOutline as _, CoverageEdge, Ellipse, FinePoint, I24F8, Outline, OutlineSink, Path,
    Ring, RoundedRectangle, Sector, Stroke, StrokeStyle, SvgElements, TooFewVertices, Vertex, collect,
};

const SIZE: i32 = 64;

/// What it covers of each pixel of a square.
fn covered(outline: &impl Outline) -> CoverageGrid {
    let mut edges = vec![CoverageEdge::EMPTY; outline.chains()];
    coverage(&outline.coverage_in(&mut edges).unwrap(), &rect(0..SIZE, 0..SIZE))
}

fn svg(data: &str) -> Vec<spanfill::Element> {
    SvgElements::new(data, 1, 1).map(Result::unwrap).collect()
}

/// The areas of the pixels of a square, in 255ths, from what each scan line has inside: so many lines a pixel, exact
/// along each.
fn areas(lines: u32, mut intervals: impl FnMut(f64) -> Vec<(f64, f64)>) -> Vec<f64> {
    let mut areas = vec![0.0; (SIZE * SIZE) as usize];
    for line in 0..SIZE.unsigned_abs() * lines {
        let y = (f64::from(line) + 0.5) / f64::from(lines);
        let row = &mut areas[(line / lines * SIZE.unsigned_abs()) as usize..][..SIZE as usize];
        for (from, to) in intervals(y) {
            let (from, to) = (from.clamp(0.0, f64::from(SIZE)), to.clamp(0.0, f64::from(SIZE)));
            let touched = from.floor() as usize..to.ceil() as usize;
            for (column, area) in touched.clone().zip(&mut row[touched]) {
                let (left, right) = (column as f64, column as f64 + 1.0);
                *area += (to.min(right) - from.max(left)).max(0.0) * 255.0 / f64::from(lines);
            }
        }
    }
    areas
}

#[derive(Default)]
struct Contours(Vec<Vec<(f64, f64)>>, Vec<(f64, f64)>);

impl OutlineSink for Contours {
    fn point(&mut self, x: i64, y: i64) {
        self.1.push((x as f64 / 4096.0, y as f64 / 4096.0));
    }

    fn close(&mut self) {
        self.0.push(std::mem::take(&mut self.1));
    }
}

/// What a scan line has inside of an outline, non-zero.
fn inside(contours: &[Vec<(f64, f64)>], y: f64) -> Vec<(f64, f64)> {
    let mut crossings: Vec<(f64, i32)> = vec![];
    for contour in contours {
        for index in 0..contour.len() {
            let ((x0, y0), (x1, y1)) = (contour[index], contour[(index + 1) % contour.len()]);
            if (y0 <= y) != (y1 <= y) {
                crossings.push(((x1 - x0) * (y - y0) / (y1 - y0) + x0, if y1 > y0 { 1 } else { -1 }));
            }
        }
    }
    crossings.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut wound = 0;
    let mut inside = vec![];
    for pair in crossings.windows(2) {
        wound += pair[0].1;
        if wound != 0 {
            inside.push((pair[0].0, pair[1].0));
        }
    }
    inside
}

/// The outline's own part of what coverage may be off by is less than an eighth of a level; coverage is rounded to one.
fn check(outline: &impl Outline, what: &str, truth: impl Fn(f64) -> Vec<(f64, f64)>) {
    let mut contours = Contours::default();
    outline.emit(&mut contours);
    let exact = areas(256, truth);
    let made = areas(256, |y| inside(&contours.0, y));
    let worst = exact.iter().zip(&made).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst < 0.125, "{what}: off by {worst}");
    check_drawn(outline, what, &exact);
}

fn check_drawn(outline: &impl Outline, what: &str, exact: &[f64]) {
    let drawn = covered(outline);
    for row in 0..SIZE {
        for column in 0..SIZE {
            let (found, expected) = (f64::from(drawn.at(column, row)), exact[(row * SIZE + column) as usize]);
            assert!((found - expected).abs() < 0.6, "{what}: {column}, {row}: {found}, not {expected}");
        }
    }
}

/// A disc on a scan line.
fn disc((x, y): (f64, f64), radius: f64, line: f64) -> Vec<(f64, f64)> {
    let square = radius * radius - (line - y) * (line - y);
    if square > 0.0 { vec![(x - square.sqrt(), x + square.sqrt())] } else { vec![] }
}

/// What is left of intervals, in order, without others.
fn without(from: Vec<(f64, f64)>, out: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut left = from;
    for &(a, b) in out {
        left = left
            .into_iter()
            .flat_map(|(x0, x1)| [(x0, x1.min(a)), (x0.max(b), x1)])
            .filter(|(x0, x1)| x0 < x1)
            .collect();
    }
    left
}

#[test]
fn rings_and_strokes_of_circles_are_within_a_tenth() {
    for (radius, width) in [(20.0, 4.0), (5.0, 2.0), (27.5, 1.0), (1.5, 0.5), (12.0, 13.0), (3.0, 5.5)] {
        let at = (31.7, 30.4);
        let ring = Ring::new(
            Vertex::new(at.0, at.1),
            I24F8::from_num(radius + width / 2.0),
            I24F8::from_num(radius - width / 2.0),
        );
        let center: (f64, f64) = (ring.center.x.to_num(), ring.center.y.to_num());
        let truth = |y: f64| without(disc(center, radius + width / 2.0, y), &disc(center, radius - width / 2.0, y));
        check(&ring, &format!("ring {radius} {width}"), truth);
        let (x, y) = center;
        let elements = svg(&format!(
            "M{} {y}a{radius} {radius} 0 1 0 {} 0a{radius} {radius} 0 1 0 {} 0z",
            x - radius,
            2.0 * radius,
            -2.0 * radius
        ));
        let stroke = Stroke::new(Path::new(&elements), StrokeStyle::new((width * 256.0) as u32));
        check(&stroke, &format!("circle {radius} stroked {width}"), truth);
        if width < radius {
            let arc = Arc::new(ring.center, ring.outer, ring.inner, Angle::ZERO, Angle::HALF);
            check(&arc, &format!("half a ring {radius} {width}"), |line| if line > y { truth(line) } else { vec![] });
        }
    }
}

#[test]
fn ellipses_and_corners_are_within_a_tenth() {
    for (rx, ry, degrees) in [(28.0, 11.0, 0), (20.0, 2.5, 33), (6.0, 5.0, 77), (30.0, 30.0, 10), (25.0, 0.75, 135)] {
        let ellipse = Ellipse::new(Vertex::new(31.25, 32.5), Vertex::new(rx, ry)).turned(Angle::degrees(degrees));
        let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
        // H x^2 - 2 B x y + A y^2 = D^2.
        let (h, b, a) = (
            (rx * sin).powi(2) + (ry * cos).powi(2),
            (rx * rx - ry * ry) * sin * cos,
            (rx * cos).powi(2) + (ry * sin).powi(2),
        );
        check(&ellipse, &format!("ellipse {rx} {ry} {degrees}"), |line| {
            let y = line - 32.5;
            let square = b * b * y * y - h * (a * y * y - rx * rx * ry * ry);
            if square > 0.0 {
                vec![(31.25 + (b * y - square.sqrt()) / h, 31.25 + (b * y + square.sqrt()) / h)]
            } else {
                vec![]
            }
        });
    }
    let rectangle = spanfill::Rectangle::new(Vertex::new(3.25, 5.5), Vertex::new(60.5, 50.125));
    let rounded = RoundedRectangle::new(rectangle, I24F8::from_num(9.5));
    check(&rounded, "rounded rectangle", |y| {
        if !(5.5..50.125).contains(&y) {
            return vec![];
        }
        let depth = (y - 5.5).min(50.125 - y);
        let cut = if depth < 9.5 { 9.5 - (9.5_f64.powi(2) - (9.5 - depth).powi(2)).sqrt() } else { 0.0 };
        vec![(3.25 + cut, 60.5 - cut)]
    });
}

#[test]
fn lines_with_caps_are_within_a_tenth() {
    for (from, to, width, cap) in [
        ((10.25, 12.5), (50.5, 40.75), 4.0, Cap::Round),
        ((10.25, 12.5), (50.5, 13.75), 0.5, Cap::Butt),
        ((30.0, 8.0), (31.0, 55.5), 17.0, Cap::Square),
        ((20.0, 50.0), (50.0, 20.0), 3.0, Cap::Round),
        ((32.0, 32.0), (32.0, 33.0), 40.0, Cap::Round),
    ] {
        let elements = svg(&format!("M{} {}L{} {}", from.0, from.1, to.0, to.1));
        let stroke = Stroke::new(Path::new(&elements), StrokeStyle::new((width * 256.0) as u32).cap(cap));
        let (dx, dy): (f64, f64) = (to.0 - from.0, to.1 - from.1);
        let (ex, ey) = (dx / dx.hypot(dy), dy / dx.hypot(dy));
        let more = if cap == Cap::Square { width / 2.0 } else { 0.0 };
        check(&stroke, &format!("{from:?} {to:?} {width} {cap:?}"), |y| {
            // Half planes n . p <= d.
            let along = |p: (f64, f64)| ex * p.0 + ey * p.1;
            let across = ex * from.1 - ey * from.0;
            let planes = [
                ((ex, ey), along(to) + more),
                ((-ex, -ey), more - along(from)),
                ((-ey, ex), across + width / 2.0),
                ((ey, -ex), width / 2.0 - across),
            ];
            let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
            for ((nx, ny), d) in planes {
                let rest = d - ny * y;
                if nx > 1e-12 {
                    high = high.min(rest / nx);
                } else if nx < -1e-12 {
                    low = low.max(rest / nx);
                } else if rest < 0.0 {
                    high = f64::NEG_INFINITY;
                }
            }
            let mut parts = if low < high { vec![(low, high)] } else { vec![] };
            if cap == Cap::Round {
                parts.extend(disc(from, width / 2.0, y));
                parts.extend(disc(to, width / 2.0, y));
            }
            // All are parts of one convex shape.
            let hull = parts.into_iter().reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)));
            hull.into_iter().collect()
        });
    }
}

#[test]
fn curves_are_within_a_tenth() {
    // The area under a parabola and beside one, and between cubics: by their own roots.
    let elements = svg("M4 60Q32 -40 60 60z");
    check(&Path::new(&elements), "parabola", |y| {
        // y = 60 - 200 t (1 - t), x = 4 + 56 t.
        let square = 1.0 - 4.0 * (60.0 - y) / 200.0;
        if y < 60.0 && square > 0.0 { vec![(32.0 - 28.0 * square.sqrt(), 32.0 + 28.0 * square.sqrt())] } else { vec![] }
    });
    let elements = svg("M10.5 5C70 5 -20 60 50.25 60L60 60L60 5z");
    check(&Path::new(&elements), "cubic", |y| {
        if !(5.0..60.0).contains(&y) {
            return vec![];
        }
        let at = |a: f64, b: f64, c: f64, d: f64, t: f64| {
            let s = 1.0 - t;
            s * s * s * a + 3.0 * s * s * t * b + 3.0 * s * t * t * c + t * t * t * d
        };
        let (mut low, mut high) = (0.0, 1.0);
        for _ in 0..60 {
            let middle = f64::midpoint(low, high);
            if at(5.0, 5.0, 60.0, 60.0, middle) < y { low = middle } else { high = middle }
        }
        vec![(at(10.5, 70.0, -20.0, 50.25, low), 60.0)]
    });
}

#[test]
fn a_wide_line_lies_evenly_about_its_middle_whichever_way() {
    for (from, to) in [((10, 20), (40, 20)), ((40, 20), (10, 20))] {
        let middle = |(x, y): (i32, i32)| format!("{}.5 {}.5", x, y);
        let elements = svg(&format!("M{}L{}", middle(from), middle(to)));
        let drawn = covered(&Stroke::new(Path::new(&elements), StrokeStyle::pixels(4)));
        let column: Vec<u8> = (16..25).map(|row| drawn.at(25, row)).collect();
        assert_eq!(column, [0, 0, 128, 255, 255, 255, 128, 0, 0], "{from:?}");
    }
}

#[test]
fn eight_sectors_are_a_disc() {
    let center = Vertex::new(30.5, 30.5);
    let mut sum = vec![0_i32; (SIZE * SIZE) as usize];
    for part in 0..8 {
        let sector = Sector::new(center, I24F8::from_num(30), Angle::fraction(part, 8), Angle::fraction(1, 8));
        let drawn = covered(&sector);
        for row in 0..SIZE {
            for column in 0..SIZE {
                sum[(row * SIZE + column) as usize] += i32::from(drawn.at(column, row));
            }
        }
    }
    let disc = covered(&Ellipse::new(center, Vertex::new(30, 30)));
    for row in 0..SIZE {
        for column in 0..SIZE {
            let (parts, whole) = (sum[(row * SIZE + column) as usize], i32::from(disc.at(column, row)));
            // Rounded once each: few of them share a pixel but in the middle.
            assert!((parts - whole).abs() <= 4, "{column} {row}: {parts} {whole}");
        }
    }
}

#[test]
fn too_little_room_is_named() {
    let elements = svg("M1 1h9v9z");
    let stroke = Stroke::new(Path::new(&elements), StrokeStyle::pixels(1));
    let count = stroke.count();
    let needed = count.points + 2 * count.contours;
    let mut vertices = vec![Vertex::default(); needed];
    assert!(collect(&stroke, &mut vertices).is_ok());
    vertices.pop();
    let Err(error) = collect(&stroke, &mut vertices) else { panic!("there is one too few") };
    assert_eq!(error, TooFewVertices { needed, available: needed - 1 });
}

/// The chains of a row, as the constant has them, are no fewer than there are.
#[test]
fn constants_have_room_for_every_row() {
    let shapes = [
        "M2 2h40v30z",
        "M2 2L50 3L4 8L50 9L4 20L30 60z",
        "M10 10a20 12 30 1 0 20 3zM20 20q5 40 9 1t9 -2",
        "M5 5c60 60 0 60 50 3M9 9l1 1m3 3l9 0 0 9",
        "M30 30m-20 0a20 20 0 1 0 40 0a20 20 0 1 0 -40 0",
        "M30 30c1 0 1 1 0 1s-1 -1 0 -1z",
    ];
    for data in shapes {
        let elements = svg(data);
        for turn in 0..12 {
            let about = spanfill::Transform::turned_about(FinePoint::whole(32, 32), Angle::fraction(turn, 12));
            let path = Path::new(&elements).transformed(about);
            assert!(path.chains() <= path.coverage_edges(), "{data} {turn}");
            for width in [100, 700, 2560, 9000] {
                for cap in [Cap::Butt, Cap::Round, Cap::Square] {
                    for join in [spanfill::Join::Bevel, spanfill::Join::Round, spanfill::Join::default()] {
                        for align in [Align::Center, Align::Inside] {
                            let style = StrokeStyle::new(width).cap(cap).join(join).align(align);
                            let stroke = Stroke::new(path, style);
                            let (found, room) = (stroke.chains(), stroke.coverage_edges());
                            assert!(found <= room, "{data} {turn} {width} {cap:?} {join:?}: {found} {room}");
                            if turn % 4 > 0 || cap == Cap::Square {
                                continue;
                            }
                            let dashed = Stroke::new(path, style.dashes(&[700, 300, 0, 900]));
                            let (found, room) = (dashed.chains(), dashed.coverage_edges());
                            assert!(found <= room, "{data} {turn} {width} {cap:?}, dashed: {found} {room}");
                        }
                    }
                }
            }
        }
    }
}

/// Of a square and of a ring, whichever way they go around: to either side, and both together what is in the middle.
#[test]
fn strokes_lie_inside_or_outside() {
    for data in ["M10 10h30v30h-30z", "M10 10v30h30v-30z"] {
        let elements = svg(data);
        let drawn = |align| covered(&Stroke::new(Path::new(&elements), StrokeStyle::pixels(3).align(align)));
        let (inside, outside) = (drawn(Align::Inside), drawn(Align::Outside));
        for y in 0..SIZE {
            for x in 0..SIZE {
                let within = |low: i32, high: i32| (low..high).contains(&x) && (low..high).contains(&y);
                let full = |is_in: bool| if is_in { 255 } else { 0 };
                assert_eq!(inside.at(x, y), full(within(10, 40) && !within(13, 37)), "{data} inside {x} {y}");
                assert_eq!(outside.at(x, y), full(within(7, 43) && !within(10, 40)), "{data} outside {x} {y}");
            }
        }
    }
    // A sharp corner: what the stroke's pieces have beyond the other side is cut off.
    for data in ["M5 10L60 20L5 30z", "M5 10L5 30L60 20z", "M5 10L60 20L5 30L22 20z"] {
        let elements = svg(data);
        let path = Path::new(&elements);
        let style = StrokeStyle::pixels(4).join(spanfill::Join::Round);
        let [inside, outside] =
            [Align::Inside, Align::Outside].map(|align| covered(&Stroke::new(path, style.align(align))));
        let (whole, area) =
            (covered(&path), covered(&Stroke::new(path, StrokeStyle::pixels(8).join(spanfill::Join::Round))));
        for y in 0..SIZE {
            for x in 0..SIZE {
                let [inside, outside, whole, both] =
                    [&inside, &outside, &whole, &area].map(|grid| i32::from(grid.at(x, y)));
                assert!(inside <= whole + 1, "{data} {x} {y}: {inside} of {whole}");
                assert!(outside + whole <= 256, "{data} {x} {y}: {outside} and {whole}");
                assert!((inside + outside - both).abs() <= 2, "{data} {x} {y}: {inside} and {outside} of {both}");
            }
        }
    }
    let ring = Ring::new(Vertex::new(30, 30), I24F8::from_num(25), I24F8::from_num(10));
    let inside = areas(256, |y| {
        let mut rings = without(disc((30.0, 30.0), 25.0, y), &disc((30.0, 30.0), 23.0, y));
        rings.extend(without(disc((30.0, 30.0), 12.0, y), &disc((30.0, 30.0), 10.0, y)));
        rings
    });
    check_drawn(&Stroke::new(ring, StrokeStyle::pixels(2).align(Align::Inside)), "ring inside", &inside);
    let outside = areas(256, |y| {
        let mut rings = without(disc((30.0, 30.0), 27.0, y), &disc((30.0, 30.0), 25.0, y));
        rings.extend(without(disc((30.0, 30.0), 10.0, y), &disc((30.0, 30.0), 8.0, y)));
        rings
    });
    check_drawn(&Stroke::new(ring, StrokeStyle::pixels(2).align(Align::Outside)), "ring outside", &outside);
}

/// As parts of a screen, and far away.
#[test]
fn clips_and_distance_change_nothing() {
    let elements = svg("M5 5c60 60 0 60 50 3M9 40a9 9 0 1 0 30 5z");
    let style = StrokeStyle::new(900).cap(Cap::Round);
    let whole = covered(&Stroke::new(Path::new(&elements), style));
    let mut far = elements.clone();
    // Out to where tiles are drawn one by one, and back.
    far.extend([
        spanfill::Element::Move(FinePoint::whole(70, -40_000)),
        spanfill::Element::Line(FinePoint::whole(40_000, 9)),
        spanfill::Element::Line(FinePoint::whole(70, 40_000)),
    ]);
    let stroke = Stroke::new(Path::new(&far), style);
    let mut edges = vec![CoverageEdge::EMPTY; stroke.chains()];
    let shape = stroke.coverage_in(&mut edges).unwrap();
    for y in 0..8 {
        for x in 0..8 {
            let clip = rect(8 * y..8 * y + 8, 8 * x..8 * x + 8);
            let part = coverage(&shape, &clip);
            for row in clip.rows.clone() {
                for column in clip.columns.clone() {
                    assert_eq!(part.at(column, row), whole.at(column, row), "{column} {row}");
                }
            }
        }
    }
    // The middle of a diagonal from corner to corner of everything.
    let across = svg("M-400000 -400000L400000 400000");
    let stroke = Stroke::new(Path::new(&across), StrokeStyle::pixels(2));
    let near = svg("M-1000 -1000L1000 1000");
    let expected = covered(&Stroke::new(Path::new(&near), StrokeStyle::pixels(2)));
    let found = covered(&stroke);
    for row in 0..SIZE {
        for column in 0..SIZE {
            assert_eq!(found.at(column, row), expected.at(column, row), "{column} {row}");
        }
    }
}

#[test]
fn too_few_edges_are_named() {
    let elements = svg("M1 1h9v9z");
    let stroke = Stroke::new(Path::new(&elements), StrokeStyle::pixels(1));
    let needed = stroke.chains();
    let mut edges = vec![CoverageEdge::EMPTY; needed];
    assert!(stroke.coverage_in(&mut edges).is_ok());
    edges.pop();
    let Err(error) = stroke.coverage_in(&mut edges) else { panic!("there is one too few") };
    assert_eq!(error, spanfill::TooManyEdges { needed, available: needed - 1 });
}
