//! Shapes of curves without anti-aliasing, pixel by pixel against what each says of itself; and their outlines against
//! their areas.

mod oracle;

use std::f64::consts::TAU;

use embedded_graphics::{Pixel, pixelcolor::BinaryColor, prelude::*};
use oracle::{Grid, Rng, block_pixels, rect, span_pixels};
use spanfill::{
    Angle, AntiAlias as _, Arc, Circle, CircleOutline, CoverOutline as _, Dither, Element, Ellipse, FinePoint, I24F8,
    Line, Outline, OutlineSink, Path, PixelRect, Rectangle, Ring, RoundedRectangle, Sector, Shape, Stroke, StrokeStyle,
    SvgElements, TaperedLine, Transform, Vertex,
};

const WINDOW: i32 = 24;

fn window() -> PixelRect {
    rect(-2..WINDOW, -2..WINDOW)
}

/// Every pixel of the window, in spans, in blocks and in four tiles, is what `belongs` says of its centre; where that
/// has no opinion, either.
fn check(shape: &impl Shape, what: &str, belongs: impl Fn(i64, i64) -> Option<bool>) {
    let window = window();
    let drawn = span_pixels(shape, &window);
    assert_eq!(drawn, block_pixels(shape, &window), "{what}: blocks");
    let bounds = shape.bounds();
    for row in window.rows.clone() {
        for column in window.columns.clone() {
            let found = drawn.count(column, row) > 0;
            let (x, y) = (256 * i64::from(column) + 128, 256 * i64::from(row) + 128);
            if let Some(expected) = belongs(x, y) {
                assert_eq!(found, expected, "{what}: column {column}, row {row}\n{drawn}");
            }
            assert!(
                !found || (bounds.rows.contains(&row) && bounds.columns.contains(&column)),
                "{what}: bounds {bounds:?}"
            );
        }
    }
    let mut tiles = Grid::new(window.clone());
    for rows in [-2..7, 7..WINDOW] {
        for columns in [-2..11, 11..WINDOW] {
            let tile = span_pixels(shape, &rect(columns.clone(), rows.clone()));
            for row in rows.clone() {
                for column in columns.clone() {
                    if tile.count(column, row) > 0 {
                        tiles.add(row, &(column..column + 1));
                    }
                }
            }
        }
    }
    assert_eq!(tiles, drawn, "{what}: tiles");
}

fn random(rng: &mut Rng, low: i32, high: i32) -> i32 {
    i32::try_from(rng.int(i64::from(low)..=i64::from(high) - 1)).unwrap()
}

fn bits(value: i32) -> I24F8 {
    I24F8::from_bits(value)
}

#[test]
fn rectangles_have_the_centres_between_their_sides() {
    let mut rng = Rng::new(16, 1);
    for _ in 0..2000 {
        let mut corner = || Vertex::from_bits(random(&mut rng, -600, 6000) & !63, random(&mut rng, -600, 6000) & !63);
        let shape = Rectangle::new(corner(), corner());
        let inside =
            |low: I24F8, high: I24F8, at: i64| (i64::from(low.to_bits())..i64::from(high.to_bits())).contains(&at);
        check(&shape, &format!("{shape:?}"), |x, y| {
            Some(inside(shape.low.x, shape.high.x, x) && inside(shape.low.y, shape.high.y, y))
        });
    }
}

#[test]
fn rounded_rectangles_lose_what_lies_outside_their_corners() {
    let mut rng = Rng::new(16, 2);
    for case in 0..2000 {
        let mut corner = || Vertex::from_bits(random(&mut rng, -600, 6000) & !31, random(&mut rng, -600, 6000) & !31);
        let rectangle = Rectangle::new(corner(), corner());
        let mut radius = || random(&mut rng, -100, 1200);
        let radii = std::array::from_fn(|_| {
            let x = radius();
            Vertex::from_bits(x, if case % 2 == 0 { x } else { radius() })
        });
        let shape = RoundedRectangle { rectangle, radii };
        let [left, top, right, bottom] = [rectangle.low.x, rectangle.low.y, rectangle.high.x, rectangle.high.y]
            .map(|side| i64::from(side.to_bits()));
        let r = radii.map(|radii| [i64::from(radii.x.to_bits()).max(0), i64::from(radii.y.to_bits()).max(0)]);
        let sides = [
            (right - left, r[0][0] + r[1][0]),
            (bottom - top, r[1][1] + r[2][1]),
            (right - left, r[2][0] + r[3][0]),
            (bottom - top, r[3][1] + r[0][1]),
        ];
        if sides.iter().any(|(side, together)| together > side) {
            // Radii that do not fit are reduced: to what is not an integer, so only the simplest is looked at.
            let drawn = span_pixels(&shape, &window());
            let whole = span_pixels(&rectangle, &window());
            assert!(drawn.covered() <= whole.covered());
            continue;
        }
        check(&shape, &format!("{shape:?}"), |x, y| {
            let inside = (left..right).contains(&x) && (top..bottom).contains(&y);
            let corners = [
                (left + r[0][0], top + r[0][1], x < left + r[0][0], y < top + r[0][1]),
                (right - r[1][0], top + r[1][1], x > right - r[1][0], y < top + r[1][1]),
                (right - r[2][0], bottom - r[2][1], x > right - r[2][0], y > bottom - r[2][1]),
                (left + r[3][0], bottom - r[3][1], x < left + r[3][0], y > bottom - r[3][1]),
            ];
            let cut = corners.iter().zip(r).any(|(&(cx, cy, is_beside, is_beyond), [rx, ry])| {
                let [a, b, rx, ry] = [x - cx, y - cy, rx, ry].map(i128::from);
                is_beside && is_beyond && a * a * ry * ry + b * b * rx * rx >= rx * rx * ry * ry
            });
            Some(inside && !cut)
        });
    }
}

#[test]
fn ellipses_have_the_centres_inside() {
    let mut rng = Rng::new(16, 3);
    for case in 0..2000 {
        let center = Vertex::from_bits(random(&mut rng, 0, 5000), random(&mut rng, 0, 5000));
        let radii = Vertex::from_bits(random(&mut rng, -20, 3000), random(&mut rng, -20, 3000));
        let angle = if case % 2 == 0 {
            Angle::ZERO
        } else {
            Angle::from_bits(u32::try_from(case).unwrap().wrapping_mul(0x9e37_79b9))
        };
        let shape = Ellipse::new(center, radii).turned(angle);
        let (rx, ry) = (i64::from(radii.x.to_bits()), i64::from(radii.y.to_bits()));
        check(&shape, &format!("{shape:?}"), |x, y| {
            if rx <= 0 || ry <= 0 {
                return Some(false);
            }
            let (dx, dy) = (x - i64::from(center.x.to_bits()), y - i64::from(center.y.to_bits()));
            if angle == Angle::ZERO {
                let [a, b, c, d] = [dx, dy, rx, ry].map(i128::from);
                return Some(a * a * d * d + b * b * c * c < c * c * d * d);
            }
            let (sin, cos) = (f64::from(angle.to_bits()) / 2f64.powi(32) * TAU).sin_cos();
            let (along, across) = (dx as f64 * cos + dy as f64 * sin, dy as f64 * cos - dx as f64 * sin);
            let far = (along / rx as f64).hypot(across / ry as f64) - 1.0;
            // Axes are known to 1/32 of these units.
            (far.abs() * rx.min(ry) as f64 > 0.1).then_some(far < 0.0)
        });
    }
    let round = Ellipse::new(Vertex::pixel(9, 9), Vertex::from_bits(1800, 1800));
    let circle = Circle::from_bits(Vertex::pixel(9, 9), 1800);
    assert_eq!(span_pixels(&round, &window()), span_pixels(&circle, &window()));
}

#[test]
fn rings_and_sectors_divide_a_disc() {
    let mut rng = Rng::new(16, 4);
    for case in 0..1500 {
        let center = if case % 3 == 0 {
            Vertex::pixel(random(&mut rng, 4, 18), random(&mut rng, 4, 18))
        } else {
            Vertex::from_bits(random(&mut rng, 0, 5000), random(&mut rng, 0, 5000))
        };
        let (outer, inner) = (random(&mut rng, 0, 3000), random(&mut rng, -200, 2000));
        let ring = Ring::new(center, bits(outer), bits(inner));
        let (cx, cy) = (i64::from(center.x.to_bits()), i64::from(center.y.to_bits()));
        let square = |x: i64, y: i64| (x - cx) * (x - cx) + (y - cy) * (y - cy);
        let in_ring = |x: i64, y: i64| {
            square(x, y) < i64::from(outer).pow(2) && square(x, y) >= i64::from(inner.max(0)).pow(2) && inner < outer
        };
        check(&ring, &format!("{ring:?}"), |x, y| Some(in_ring(x, y)));
        let start = if case % 2 == 0 {
            Angle::fraction(random(&mut rng, 0, 24), 24)
        } else {
            Angle::from_bits(u32::try_from(case).unwrap().wrapping_mul(0x9e37_79b9))
        };
        let sweep = if case % 2 == 0 {
            Angle::fraction(random(&mut rng, 0, 24), 24)
        } else {
            Angle::from_bits(u32::try_from(case).unwrap().wrapping_mul(0x85eb_ca6b))
        };
        let arc = Arc::new(center, bits(outer), bits(inner), start, sweep);
        check(&arc, &format!("{arc:?}"), |x, y| {
            if !in_ring(x, y) {
                return Some(false);
            }
            let angle = ((y - cy) as f64).atan2((x - cx) as f64) - f64::from(start.to_bits()) / 2f64.powi(32) * TAU;
            let (angle, sweep) = (angle.rem_euclid(TAU), f64::from(sweep.to_bits()) / 2f64.powi(32) * TAU);
            let is_clear = angle.min(TAU - angle).min((angle - sweep).abs()) > 1e-7 && (x, y) != (cx, cy);
            is_clear.then_some(angle < sweep)
        });
        // Any number of sectors, each pixel once.
        let parts = u32::try_from(random(&mut rng, 2, 9)).unwrap();
        let mut sum = Grid::new(window());
        let mut drawn = Angle::ZERO;
        for part in 1..=parts {
            let end = if part == parts { Angle::ZERO } else { Angle::fraction(i32::try_from(part).unwrap(), parts) };
            let sector = Sector::new(center, bits(outer), start + drawn, end - drawn);
            sum.add_all(&span_pixels(&sector, &window()));
            drawn = end;
        }
        let disc = span_pixels(&Circle::from_bits(center, outer), &window());
        assert_eq!(sum, disc, "{parts} sectors of {center:?} {outer} from {start:?}");
    }
    let nothing = Sector::new(Vertex::pixel(9, 9), bits(2000), Angle::degrees(200), Angle::ZERO);
    assert_eq!(span_pixels(&nothing, &window()).covered(), 0);
}

/// The pixels that have one of a set's around them can be reached from the first of it.
fn is_connected(grid: &Grid) -> bool {
    let mut left: std::collections::BTreeSet<(i32, i32)> = window()
        .rows
        .flat_map(|row| window().columns.map(move |column| (column, row)))
        .filter(|&(column, row)| grid.count(column, row) > 0)
        .collect();
    let Some(first) = left.pop_first() else { return true };
    let mut reached = vec![first];
    while let Some((column, row)) = reached.pop() {
        for dy in -1..=1 {
            for dx in -1..=1 {
                if left.remove(&(column + dx, row + dy)) {
                    reached.push((column + dx, row + dy));
                }
            }
        }
    }
    left.is_empty()
}

#[test]
fn circle_outlines_are_one_pixel_wide_and_closed() {
    let mut rng = Rng::new(16, 5);
    for case in 0..4000 {
        let (center, radius) = match case % 3 {
            0 => (Vertex::pixel(10, 10), 256 * random(&mut rng, 1, 11)),
            1 => (Vertex::from_bits(11 * 256, 11 * 256), random(&mut rng, 1, 2800)),
            _ => (
                Vertex::from_bits(random(&mut rng, 2400, 3200), random(&mut rng, 2400, 3200)),
                random(&mut rng, 1, 2300),
            ),
        };
        let shape = CircleOutline::new(center, bits(radius));
        let (cx, cy, r) = (i64::from(center.x.to_bits()), i64::from(center.y.to_bits()), i64::from(radius));
        // |s - t| <= 128 along one axis, in squares: the circle passes within half a pixel.
        let crosses = |far: i64, near: i64| {
            let below = (far - 128).max(0);
            let rest = r * r - near * near;
            rest >= 0 && rest <= (far + 128) * (far + 128) && (far < 128 || rest > below * below)
        };
        check(&shape, &format!("{shape:?}"), |x, y| {
            let (dx, dy) = ((x - cx).abs(), (y - cy).abs());
            Some((dx <= dy && crosses(dy, dx)) || (dy <= dx && crosses(dx, dy)))
        });
        let drawn = span_pixels(&shape, &window());
        assert!(is_connected(&drawn), "{shape:?}\n{drawn}");
        // What is inside cannot be left, from corner to corner either, but through a side of a pixel of the outline.
        if radius > 600 {
            let middle = span_pixels(
                &CircleOutline::new(center, bits(radius)),
                &rect((center.x.to_bits() >> 8)..(center.x.to_bits() >> 8) + 1, -2..WINDOW),
            );
            assert!(middle.covered() >= 2, "{shape:?}\n{drawn}");
        }
    }
    // Bresenham's circle, by its own recurrence.
    for radius in 1..11_i32 {
        let mut expected = Grid::new(window());
        let (mut x, mut y, mut d) = (0, radius, 1 - radius);
        let mut pixels = std::collections::BTreeSet::new();
        while x <= y {
            for (a, b) in [(x, y), (y, x)] {
                for (a, b) in [(a, b), (-a, b), (a, -b), (-a, -b)] {
                    pixels.insert((10 + b, 10 + a));
                }
            }
            if d < 0 {
                d += 2 * x + 3;
            } else {
                d += 2 * (x - y) + 5;
                y -= 1;
            }
            x += 1;
        }
        for (row, column) in pixels {
            expected.add(row, &(column..column + 1));
        }
        let drawn = span_pixels(&CircleOutline::new(Vertex::pixel(10, 10), I24F8::from_num(radius)), &window());
        assert_eq!(drawn, expected, "radius {radius}\n{drawn}\n{expected}");
    }
}

#[test]
fn needles_are_in_one_piece_at_every_angle() {
    let mut in_pieces = 0;
    for degrees in 0..360 {
        let center = Vertex::pixel(11, 11);
        let tip = |radius: i64| {
            let (sin, cos) = Angle::degrees(degrees).sin_cos();
            let part = |sine: i32| i32::try_from((i64::from(sine) * radius) >> 30).unwrap();
            Vertex::from_bits(center.x.to_bits() + part(cos), center.y.to_bits() + part(sin))
        };
        let needle = TaperedLine::new(tip(-500), tip(2700), [384, 128]);
        let thin = span_pixels(&needle, &window());
        in_pieces += i32::from(!is_connected(&thin));
        let connected = needle.connected();
        let drawn = span_pixels(&connected, &window());
        assert!(is_connected(&drawn), "{degrees}\n{drawn}");
        assert_eq!(drawn, block_pixels(&connected, &window()));
        let line = span_pixels(&Line { start: needle.from, end: needle.to }, &window());
        for row in window().rows {
            for column in window().columns {
                let expected = thin.count(column, row) > 0 || line.count(column, row) > 0;
                assert_eq!(drawn.count(column, row) > 0, expected, "{degrees}: {column} {row}");
            }
        }
    }
    // The option is worth having.
    assert!(in_pieces > 100, "{in_pieces}");
}

#[test]
fn tapered_lines_have_their_centres() {
    let mut rng = Rng::new(16, 6);
    for _ in 0..1500 {
        let mut end = || Vertex::from_bits(random(&mut rng, 0, 5000), random(&mut rng, 0, 5000));
        let (from, to) = (end(), end());
        let widths = [random(&mut rng, 0, 2000), random(&mut rng, 0, 2000)].map(|width| u32::try_from(width).unwrap());
        let shape = TaperedLine::new(from, to, widths);
        let at = |vertex: Vertex| (f64::from(vertex.x.to_bits()), f64::from(vertex.y.to_bits()));
        let ((x0, y0), (x1, y1)) = (at(from), at(to));
        let length = (x1 - x0).hypot(y1 - y0);
        check(&shape, &format!("{shape:?}"), |x, y| {
            if length < 1.0 {
                return None;
            }
            let (dx, dy) = (x as f64 - x0, y as f64 - y0);
            let along = (dx * (x1 - x0) + dy * (y1 - y0)) / length;
            let across = ((x1 - x0) * dy - (y1 - y0) * dx).abs() / length;
            let half = (f64::from(widths[0]) + (f64::from(widths[1]) - f64::from(widths[0])) * along / length) / 2.0;
            let slope = (f64::from(widths[1]) - f64::from(widths[0])) / 2.0 / length;
            let inside = along.min(length - along).min((half - across) / slope.hypot(1.0));
            // Corners are rounded to these units.
            (inside.abs() > 1.5).then_some(inside > 0.0)
        });
    }
}

#[derive(Default)]
struct DoubledArea {
    first: Option<(i64, i64)>,
    last: Option<(i64, i64)>,
    sum: i128,
}

impl OutlineSink for DoubledArea {
    fn point(&mut self, x: i64, y: i64) {
        let (x0, y0) = self.last.replace((x, y)).unwrap_or((x, y));
        self.sum += i128::from(x0) * i128::from(y) - i128::from(x) * i128::from(y0);
        self.first.get_or_insert((x, y));
    }

    fn close(&mut self) {
        if let Some((x, y)) = self.first.take() {
            self.point(x, y);
        }
        (self.first, self.last) = (None, None);
    }
}

fn area(outline: &impl Outline) -> f64 {
    let mut area = DoubledArea::default();
    outline.emit(&mut area);
    area.sum as f64 / 2.0 / 4096.0 / 4096.0
}

#[test]
fn outlines_have_the_areas_of_their_shapes() {
    let pi = TAU / 2.0;
    let close = |outline: f64, exact: f64, perimeter: f64| {
        assert!((outline - exact).abs() < perimeter / 6000.0, "{outline} {exact}")
    };
    let center = Vertex::new(100.25, 80.5);
    for radius in [3, 20, 77] {
        let r = f64::from(radius);
        let (outer, inner) = (I24F8::from_num(radius), I24F8::from_num(radius / 2));
        let hole = f64::from(radius / 2);
        close(area(&Ring::new(center, outer, inner)), pi * (r * r - hole * hole), TAU * (r + hole));
        let ellipse = Ellipse::new(center, Vertex::new(radius, 2)).turned(Angle::degrees(77));
        close(area(&ellipse), pi * r * 2.0, TAU * r);
        for degrees in [1, 45, 90, 180, 300] {
            let (start, sweep) = (Angle::degrees(200), Angle::degrees(degrees));
            let part = f64::from(degrees) / 360.0;
            close(area(&Sector::new(center, outer, start, sweep)), part * pi * r * r, r + TAU * r * part);
            close(
                area(&Arc::new(center, outer, inner, start, sweep)),
                part * pi * (r * r - hole * hole),
                r + TAU * r * part,
            );
        }
        let rectangle = Rectangle::new(Vertex::new(-r, -r), Vertex::new(r, r));
        let corner = r / 3.0;
        let rounded = RoundedRectangle::new(rectangle, I24F8::from_num(corner));
        let corner: f64 = I24F8::from_num(corner).to_num();
        close(area(&rounded), 4.0 * r * r - (4.0 - pi) * corner * corner, 8.0 * r);
        close(area(&RoundedRectangle::new(rectangle, I24F8::from_num(9 * radius))), pi * r * r, TAU * r);
        close(area(&RoundedRectangle::new(rectangle, I24F8::ZERO)), 4.0 * r * r, 8.0 * r);
    }
}

#[test]
fn the_ends_of_the_range_are_drawn_or_not_but_do_not_fail() {
    let ends = [i32::MIN, -1 << 25, -1, 0, 1, 1 << 25, i32::MAX];
    let clip = rect(-3..3, -3..3);
    for a in ends {
        for b in ends {
            for c in ends {
                let (v, w) = (Vertex::from_bits(a, b), Vertex::from_bits(b, c));
                let rectangle = Rectangle::new(v, w);
                span_pixels(&rectangle, &clip);
                span_pixels(&RoundedRectangle { rectangle, radii: [w, v, v, w] }, &clip);
                span_pixels(&Ring::new(v, bits(c), bits(b)), &clip);
                span_pixels(&CircleOutline::new(v, bits(c)), &clip);
                span_pixels(&TaperedLine::new(v, w, [a.unsigned_abs(), c.unsigned_abs()]).connected(), &clip);
                for turn in [0, 1, 4, 5] {
                    let angle = Angle::fraction(turn, 8);
                    let arc = Arc::new(v, bits(c), bits(a), angle, angle);
                    span_pixels(&arc, &clip);
                    arc.bounds();
                    span_pixels(&Ellipse::new(v, w).turned(angle), &clip);
                    arc.extent();
                }
            }
        }
    }
}

/// A screen of pixels that are set.
struct Panel(Grid);

impl Dimensions for Panel {
    fn bounding_box(&self) -> embedded_graphics::primitives::Rectangle {
        window().into()
    }
}

impl DrawTarget for Panel {
    type Color = BinaryColor;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(point, _) in pixels {
            if window().columns.contains(&point.x) && window().rows.contains(&point.y) {
                self.0.add(point.y, &(point.x..point.x + 1));
            }
        }
        Ok(())
    }
}

/// Dithered on a panel of one bit, strokes of less than a pixel are dots; their middle lines keep them in one piece,
/// and add no pixel that the line does not pass through or beside.
#[test]
fn thin_strokes_are_in_one_piece_at_every_angle() {
    let elements: Vec<Element> =
        SvgElements::new("M-7 -6l11 2q4 5 -1 9t-9 0l2 -3.4", 1, 1).map(Result::unwrap).collect();
    let mut in_pieces = 0;
    for degrees in 0..360 {
        let about = Transform::turned(Angle::degrees(degrees)).then(Transform::moved(FinePoint::new(11.3, 10.6)));
        let path = Path::new(&elements).transformed(about);
        for width in [100, 200, 380] {
            let stroke = Stroke::new(path, StrokeStyle::new(width));
            let mut panel = Panel(Grid::new(window()));
            let Ok(()) = stroke.coverage_with::<128>().unwrap().antialiased(BinaryColor::On, Dither).draw(&mut panel);
            in_pieces += i32::from(!is_connected(&panel.0));
            let Ok(()) = stroke.connect(BinaryColor::On, &mut panel);
            assert!(is_connected(&panel.0), "{degrees} {width}\n{}", panel.0);
        }
    }
    assert!(in_pieces > 500, "{in_pieces}");
}
