//! What holds for every styled primitive: it stays in its bounding box and on the target, blended pixels come once,
//! what has no size draws nothing, and there is no size or place that panics or takes long.

mod oracle;

use std::time::{Duration, Instant};

use embedded_graphics::{
    Pixel,
    geometry::Angle,
    mock_display::MockDisplay,
    pixelcolor::{BinaryColor, Rgb565, raw::RawU16},
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, Rectangle, RoundedRectangle, Sector, StrokeAlignment,
        Styled, StyledDimensions, StyledDrawable, Triangle,
    },
};
use oracle::{Rng, cases, for_each_case};
use spanfill::{
    Blend, Over, PixelRect,
    eg::{Blended, DrawOn, Style, StyleBuilder},
};

/// Counts what is drawn on each pixel, remembers the last colour, and refuses what lies outside.
struct Counted {
    area: Rectangle,
    counts: Vec<u32>,
    colours: Vec<Rgb565>,
}

impl Counted {
    fn new(area: Rectangle) -> Self {
        let pixels = (area.size.width * area.size.height) as usize;
        Self { area, counts: vec![0; pixels], colours: vec![Rgb565::BLACK; pixels] }
    }

    fn index(&self, point: Point) -> usize {
        assert!(self.area.contains(point), "{point:?} lies outside of {:?}", self.area);
        let place = point - self.area.top_left;
        place.y as usize * self.area.size.width as usize + place.x as usize
    }

    fn drawn(&self) -> impl Iterator<Item = (Point, u32, Rgb565)> {
        let pixels = self.area.points().zip(&self.counts).zip(&self.colours);
        pixels.filter(|((_, count), _)| **count > 0).map(|((point, count), colour)| (point, *count, *colour))
    }
}

impl Dimensions for Counted {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl DrawTarget for Counted {
    type Color = Rgb565;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(point, colour) in pixels {
            let index = self.index(point);
            self.counts[index] += 1;
            self.colours[index] = colour;
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Self::Error> {
        assert!(!area.is_zero_sized());
        self.draw_iter(area.points().map(|point| Pixel(point, colour)))
    }
}

/// Shows coverage itself: the alpha as the raw colour.
#[derive(Debug, Clone, Copy)]
struct Alpha;

impl<D: DrawTarget<Color = Rgb565>> Blend<D> for Alpha {
    fn run(&self, target: &mut D, start: Point, _: Rgb565, alphas: &[u8]) -> Result<(), D::Error> {
        let places = (start.x..).map(|x| Point::new(x, start.y));
        target
            .draw_iter(places.zip(alphas).map(|(point, &alpha)| Pixel(point, Rgb565::from(RawU16::new(alpha.into())))))
    }
}

/// Pixels that the blending was not asked for are covered wholly.
fn alpha(colour: Rgb565) -> i32 {
    if colour == Rgb565::RED { 255 } else { RawU16::from(colour).into_inner().into() }
}

/// Every kind of primitive, from numbers.
trait Visit {
    fn visit<P>(&mut self, primitive: P)
    where
        P: StyledDrawable<Style<Rgb565>, Color = Rgb565, Output = ()>
            + StyledDimensions<Style<Rgb565>>
            + StyledDrawable<Style<Rgb565, Blended<Over<Rgb565>>>, Color = Rgb565, Output = ()>
            + StyledDimensions<Style<Rgb565, Blended<Over<Rgb565>>>>
            + Copy
            + std::fmt::Debug;
}

fn visit_all(points: [Point; 4], size: Size, radii: Size, angles: [Angle; 2], visit: &mut impl Visit) {
    let [a, b, c, d] = points;
    let [start, sweep] = angles;
    visit.visit(Rectangle::new(a, size));
    visit.visit(Circle::new(a, size.width));
    visit.visit(Ellipse::new(a, size));
    visit.visit(RoundedRectangle::with_equal_corners(Rectangle::new(a, size), radii));
    let corners = CornerRadii { top_left: radii, bottom_right: size, ..CornerRadii::new(Size::zero()) };
    visit.visit(RoundedRectangle::new(Rectangle::new(a, size), corners));
    visit.visit(Triangle::new(a, b, c));
    visit.visit(Triangle::new(a, b, a));
    visit.visit(Line::new(a, b));
    visit.visit(Line::new(a, a));
    visit.visit(Polyline::new(&[a, b, c, d]));
    visit.visit(Polyline::new(&[a, b, b, a, c, c]));
    visit.visit(Polyline::new(&[a, a]));
    visit.visit(Polyline::new(&[a]));
    visit.visit(Arc::new(a, size.width, start, sweep));
    visit.visit(Sector::new(a, size.width, start, sweep));
}

fn styles() -> Vec<Style<Rgb565>> {
    let mut styles = vec![Style::with_fill(Rgb565::RED)];
    for width in [0, 1, 2, 5, 300] {
        for alignment in [StrokeAlignment::Inside, StrokeAlignment::Center, StrokeAlignment::Outside] {
            let sized = StyleBuilder::new().stroke_width(width).stroke_alignment(alignment);
            styles.push(sized.fill_color(Rgb565::RED).build());
            styles.push(sized.stroke_color(Rgb565::BLUE).build());
            styles.push(sized.fill_color(Rgb565::RED).stroke_color(Rgb565::BLUE).build());
        }
    }
    styles
}

/// `Rectangle::contains`, for every size.
fn holds(rectangle: &Rectangle, point: Point) -> bool {
    let PixelRect { rows, columns } = PixelRect::from(*rectangle);
    rows.contains(&point.y) && columns.contains(&point.x)
}

/// Draws each primitive in one style, aliased and blended.
struct Check {
    style: Style<Rgb565>,
    target: Rectangle,
    drawn: u64,
}

impl Visit for Check {
    fn visit<P>(&mut self, primitive: P)
    where
        P: StyledDrawable<Style<Rgb565>, Color = Rgb565, Output = ()>
            + StyledDimensions<Style<Rgb565>>
            + StyledDrawable<Style<Rgb565, Blended<Over<Rgb565>>>, Color = Rgb565, Output = ()>
            + StyledDimensions<Style<Rgb565, Blended<Over<Rgb565>>>>
            + Copy
            + std::fmt::Debug,
    {
        let start = Instant::now();
        let mut target = Counted::new(self.target);
        let styled = Styled::new(primitive, self.style);
        let Ok(()) = styled.draw(&mut target);
        let bounds = styled.bounding_box();
        for (point, ..) in target.drawn() {
            assert!(holds(&bounds, point), "{point:?} outside of {bounds:?}: {styled:?}");
            self.drawn += 1;
        }
        for opacity in [255, 77] {
            let mut target = Counted::new(self.target);
            let styled = Styled::new(primitive, self.style.antialiased(Over(Rgb565::WHITE)).opacity(opacity));
            let Ok(()) = styled.draw(&mut target);
            let bounds = styled.bounding_box();
            for (point, count, _) in target.drawn() {
                assert!(holds(&bounds, point), "{point:?} outside of {bounds:?}: {styled:?}");
                assert_eq!(count, 1, "{point:?} was drawn more than once: {styled:?}");
                self.drawn += 1;
            }
        }
        assert!(start.elapsed() < Duration::from_secs(1), "{:?}: {styled:?}", start.elapsed());
    }
}

#[test]
fn all_stay_in_their_bounds_and_blended_pixels_come_once() {
    let styles = styles();
    let target = Rectangle::new(Point::new(-7, -11), Size::new(75, 67));
    let drawn = for_each_case(220, cases(1500), |rng| {
        let reach = rng.pick(&[4, 30, 90]);
        let points = [(); 4].map(|()| Point::new(rng.int(-reach..=reach) as i32, rng.int(-reach..=reach) as i32));
        let mut sizes = [(); 2].map(|()| Size::new(rng.int(0..=reach) as u32, rng.int(0..=reach) as u32));
        if rng.one_in(5) {
            sizes[0].width = 0;
        }
        let angles = [(); 2].map(|()| match rng.index(2) {
            0 => (90.0 * rng.int(-4..=4) as f32).deg(),
            _ => (rng.int(-400..=400) as f32).deg(),
        });
        let mut check = Check { style: rng.pick(&styles), target, drawn: 0 };
        visit_all(points, sizes[0], sizes[1], angles, &mut check);
        Ok(check.drawn)
    });
    assert!(drawn > 1_000_000, "{drawn}");
}

#[test]
fn the_ends_of_the_range_take_no_time() {
    let styles = styles();
    let target = Rectangle::new(Point::new(-7, -11), Size::new(75, 67));
    for_each_case(221, cases(3000), |rng| {
        let coordinate = |rng: &mut Rng| match rng.index(4) {
            0 => rng.pick(&[i32::MIN, i32::MIN + 1, i32::MAX - 1, i32::MAX, -(1 << 23), 1 << 23]),
            1 => rng.int(-50..=50) as i32,
            _ => rng.magnitude(31).clamp(i32::MIN.into(), i32::MAX.into()) as i32,
        };
        let length = |rng: &mut Rng| match rng.index(4) {
            0 => rng.pick(&[0, 1, u32::MAX - 1, u32::MAX, 1 << 15, 1 << 16, 1 << 31]),
            1 => rng.int(0..=60) as u32,
            _ => rng.magnitude(32).unsigned_abs().min(u32::MAX.into()) as u32,
        };
        let points = [(); 4].map(|()| Point::new(coordinate(rng), coordinate(rng)));
        let [size, radii] = [(); 2].map(|()| Size::new(length(rng), length(rng)));
        let angles = [(); 2].map(|()| match rng.index(3) {
            0 => Angle::from_radians(rng.pick(&[f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, 1e-30])),
            _ => (rng.int(-800..=800) as f32).deg(),
        });
        let mut style = rng.pick(&styles);
        if rng.one_in(3) {
            style.stroke_width = length(rng);
        }
        let mut check = Check { style, target, drawn: 0 };
        visit_all(points, size, radii, angles, &mut check);
        Ok(check.drawn)
    });
}

/// A mock display refuses pixels that come twice.
#[test]
fn thin_polylines_draw_their_joints_once() {
    let points = [(2, 3), (9, 3), (9, 9), (9, 9), (4, 12), (1, 9), (6, 7)].map(|(x, y)| Point::new(x, y));
    let mut display = MockDisplay::new();
    let Ok(()) = Polyline::new(&points).into_styled(Style::with_stroke(BinaryColor::On, 1)).draw(&mut display);
    assert_eq!(display.get_pixel(points[2]), Some(BinaryColor::On));
    assert_eq!(display.affected_area(), Rectangle::new(Point::new(1, 3), Size::new(9, 10)));
}

#[test]
fn nothing_is_drawn_of_what_has_no_size() {
    let mut target = Counted::new(Rectangle::new(Point::new(-9, -9), Size::new(20, 20)));
    let point = Point::new(1, 2);
    for style in [Style::with_fill(Rgb565::RED), Style::with_stroke(Rgb565::RED, 0), Style::new()] {
        let blended = style.antialiased(Over(Rgb565::WHITE));
        macro_rules! draw {
            ($($primitive:expr),+) => {$(
                let Ok(()) = $primitive.into_styled(style).draw(&mut target);
                let Ok(()) = $primitive.into_styled(blended).draw(&mut target);
            )+};
        }
        draw!(
            Rectangle::new(point, Size::new(0, 5)),
            Circle::new(point, 0),
            Ellipse::new(point, Size::new(4, 0)),
            RoundedRectangle::with_equal_corners(Rectangle::new(point, Size::new(0, 5)), Size::new(2, 2)),
            Triangle::new(point, point, point),
            Line::new(point, Point::new(5, 5)),
            Polyline::new(&[point, Point::new(5, 5)]),
            Arc::new(point, 0, 0.0.deg(), 90.0.deg()),
            Sector::new(point, 0, 0.0.deg(), 90.0.deg())
        );
    }
    assert_eq!(target.drawn().count(), 0);
    let transparent = Style::with_fill(Rgb565::RED).antialiased(Over(Rgb565::WHITE)).opacity(0);
    let Ok(()) = Circle::new(point, 5).into_styled(transparent).draw(&mut target);
    assert_eq!(target.drawn().count(), 0);
}

/// Coverage against what `is_inside` says of 32 x 32 places in each pixel: the most it is off, in 255ths.
fn most_off<P>(styled: Styled<P, Style<Rgb565, Blended<Alpha>>>, is_inside: impl Fn(f64, f64) -> bool) -> i32
where
    Styled<P, Style<Rgb565, Blended<Alpha>>>: DrawOn<Rgb565, Alpha>,
{
    const PLACES: i32 = 32;
    let mut target = Counted::new(Rectangle::new(Point::zero(), Size::new(110, 110)));
    let Ok(()) = styled.draw_on(&mut target);
    let off = target.area.points().map(|point| {
        let place = |pixel: i32, index: i32| f64::from(pixel) + (f64::from(index) + 0.5) / f64::from(PLACES);
        let inside = (0..PLACES * PLACES)
            .filter(|index| is_inside(place(point.x, index % PLACES), place(point.y, index / PLACES)))
            .count() as i32;
        let expected = (inside * 255 + PLACES * PLACES / 2) / (PLACES * PLACES);
        let index = target.index(point);
        (alpha(target.colours[index]) - expected).abs()
    });
    off.max().unwrap_or(0)
}

fn ellipse(center: (f64, f64), radii: (f64, f64)) -> impl Fn(f64, f64) -> bool {
    move |x, y| ((x - center.0) / radii.0).powi(2) + ((y - center.1) / radii.1).powi(2) < 1.0
}

#[test]
fn coverage_is_that_of_the_true_outlines() {
    let fill = Style::with_fill(Rgb565::RED).antialiased(Alpha);
    let stroke = |width| Style::with_stroke(Rgb565::RED, width).antialiased(Alpha);
    let top_left = Point::new(4, 6);
    for (width, height) in [(100, 30), (31, 90), (7, 9), (2, 1), (64, 64), (90, 3)] {
        let size = Size::new(width, height);
        let (a, b) = (f64::from(width) / 2.0, f64::from(height) / 2.0);
        let center = (4.0 + a, 6.0 + b);
        let filled = most_off(Ellipse::new(top_left, size).into_styled(fill), ellipse(center, (a, b)));
        assert!(filled <= 5, "{size:?}: {filled}");
        let (outer, inner) = (ellipse(center, (a + 1.0, b + 1.0)), ellipse(center, (a - 2.0, b - 2.0)));
        let inner = |x, y| a > 2.0 && b > 2.0 && inner(x, y);
        let ring = most_off(Ellipse::new(top_left, size).into_styled(stroke(3)), |x, y| outer(x, y) && !inner(x, y));
        assert!(ring <= 8, "{size:?}: {ring}");
        let circle = most_off(Circle::new(top_left, width).into_styled(fill), ellipse((4.0 + a, 6.0 + a), (a, a)));
        assert!(circle <= 5, "{width}: {circle}");
        let rounded = RoundedRectangle::with_equal_corners(Rectangle::new(top_left, Size::new(100, 100)), size / 3);
        let (a, b) = (f64::from(width / 3), f64::from(height / 3));
        let rounded = most_off(rounded.into_styled(fill), |x, y| {
            let (x, y) = ((x - 54.0).abs() - 50.0, (y - 56.0).abs() - 50.0);
            let corner = ellipse((-a, -b), (a, b));
            x < 0.0 && y < 0.0 && (x < -a || y < -b || corner(x, y))
        });
        assert!(rounded <= 5, "{size:?}: {rounded}");
    }
    for width in [1, 2, 3, 8] {
        for end in [Point::new(80, 20), Point::new(20, 90), Point::new(70, 70), Point::new(90, 14), Point::new(24, 14)]
        {
            let start = Point::new(20, 14);
            let line = Line::new(start, end);
            let (dx, dy) = (f64::from(end.x - start.x), f64::from(end.y - start.y));
            let (length, major) = (dx.hypot(dy), dx.abs().max(dy.abs()));
            let left = f64::from(width) / 2.0;
            let off = most_off(line.into_styled(stroke(width)), |x, y| {
                let (x, y) = (x - 20.5, y - 14.5);
                let (along, right) = ((x * dx + y * dy) / length, (y * dx - x * dy) / length);
                let cap = 0.5 * length / major;
                along > -cap && along < length + cap && right > -left && right < f64::from(width) - left
            });
            assert!(off <= 9, "{width}, {line:?}: {off}");
        }
    }
    for (start, sweep) in [(0.0, 90.0), (30.0, 200.0), (100.0, -45.0), (10.0, 340.0), (0.0, 180.0), (270.0, 4.0)] {
        let (from, to) = if sweep < 0.0 { (start + sweep, start) } else { (start, start + sweep) };
        let (from, to) = (f64::from(from).to_radians(), f64::from(to).to_radians());
        let turn = (to - from).rem_euclid(std::f64::consts::TAU);
        let is_between = |x: f64, y: f64| (y.atan2(x) - from).rem_euclid(std::f64::consts::TAU) < turn;
        let arc = Arc::new(top_left, 80, start.deg(), sweep.deg()).into_styled(stroke(8));
        let off = most_off(arc, |x, y| {
            let (x, y) = (x - 44.0, y - 46.0);
            x.hypot(y) < 44.0 && x.hypot(y) > 36.0 && is_between(x, y)
        });
        assert!(off <= 8, "{start} {sweep}: {off}");
    }
}

#[test]
fn sectors_are_covered_as_their_half_planes_say() {
    let center = (44.0, 46.0);
    for (start, sweep) in [(0.0, 90.0), (20.0, 60.0), (30.0, 200.0), (0.0, 180.0), (200.0, -120.0), (10.0, 300.0)] {
        let sector = Sector::new(Point::new(4, 6), 80, start.deg(), sweep.deg());
        let (from, to) = if sweep < 0.0 { (start + sweep, start) } else { (start, start + sweep) };
        let normal = |degrees: f32| {
            let (y, x) = f64::from(degrees).to_radians().sin_cos();
            (-y, x)
        };
        let (first, last) = (normal(from), normal(to));
        // As far inside as the radius and both sides say.
        let pie = |radius: f64, margin: f64| {
            move |x: f64, y: f64| {
                let (x, y) = (x - center.0, y - center.1);
                let after = x * first.0 + y * first.1 > margin;
                let before = x * last.0 + y * last.1 < -margin;
                let holds = if f32::abs(sweep) < 180.0 { after && before } else { after || before };
                x.hypot(y) < radius && holds
            }
        };
        let filled = most_off(sector.into_styled(Style::with_fill(Rgb565::RED).antialiased(Alpha)), pie(40.0, 0.0));
        assert!(filled <= 6, "{start} {sweep}: {filled}");
        // The circles have their strokes in whole pixels, the straight sides have them where the alignment says.
        for (width, alignment, radii, sides) in [
            (5, StrokeAlignment::Center, (42.0, 37.0), (2.5, 2.5)),
            (4, StrokeAlignment::Center, (42.0, 38.0), (2.0, 2.0)),
            (1, StrokeAlignment::Center, (40.0, 39.0), (0.5, 0.5)),
            (4, StrokeAlignment::Inside, (40.0, 36.0), (0.0, 4.0)),
            (3, StrokeAlignment::Outside, (43.0, 40.0), (3.0, 0.0)),
        ] {
            let (outer, inner) = (pie(radii.0, -sides.0), pie(radii.1, sides.1));
            let style = StyleBuilder::new().stroke_color(Rgb565::RED).stroke_width(width).stroke_alignment(alignment);
            let ring =
                most_off(sector.into_styled(style.build().antialiased(Alpha)), |x, y| outer(x, y) && !inner(x, y));
            assert!(ring <= 10, "{start} {sweep} {width} {alignment:?}: {ring}");
        }
    }
}

/// Tiles that a segment passes by are left out: none may be missing.
#[test]
fn polylines_are_the_same_in_any_window() {
    let mixed = for_each_case(222, cases(300), |rng| {
        let reach = rng.pick(&[20, 200, 3000]);
        let points = [(); 5].map(|()| Point::new(rng.int(-reach..=reach) as i32, rng.int(-reach..=reach) as i32));
        let style = Style::with_stroke(Rgb565::RED, rng.int(1..=9) as u32).antialiased(Alpha);
        let styled = Polyline::new(&points).into_styled(style);
        let mut whole = Counted::new(Rectangle::new(Point::new(-90, -70), Size::new(150, 130)));
        let Ok(()) = styled.draw_on(&mut whole);
        // A window of one pixel has one tile, around that pixel alone.
        for _ in 0..200 {
            let pixel = Point::new(rng.int(-90..=59) as i32, rng.int(-70..=59) as i32);
            let mut window = Counted::new(Rectangle::new(pixel, Size::new_equal(1)));
            let Ok(()) = styled.draw_on(&mut window);
            assert_eq!(window.colours[0], whole.colours[whole.index(pixel)], "{pixel:?}: {styled:?}");
        }
        Ok(whole.drawn().count() as u64)
    });
    assert!(mixed > 0);
}

#[test]
fn joints_are_covered_once() {
    // A closed square: its sides meet in mitres, but for the first and the last, which have their own ends.
    let corners = [Point::new(10, 10), Point::new(60, 10), Point::new(60, 50), Point::new(10, 50), Point::new(10, 10)];
    let style = Style::with_stroke(Rgb565::RED, 5).antialiased(Alpha);
    let off = most_off(Polyline::new(&corners).into_styled(style), |x, y| {
        let inside = |margin: f64| x > 10.5 - margin && x < 60.5 + margin && y > 10.5 - margin && y < 50.5 + margin;
        let notch = x < 10.0 && y < 10.0;
        inside(2.5) && !inside(-2.5) && !notch
    });
    assert_eq!(off, 0);
    // What a stroke leaves of a triangle to fill, of a sharp one too.
    for tip in [Point::new(10, 10), Point::new(80, 22), Point::new(2, 40)] {
        let triangle = Triangle::new(tip, Point::new(100, 30), Point::new(98, 44));
        let left = StyleBuilder::new().fill_color(Rgb565::RED).stroke_width(5).build();
        let off = most_off(triangle.into_styled(left.antialiased(Alpha)), |x, y| {
            let [a, b, c] = triangle.vertices.map(|corner| (f64::from(corner.x) + 0.5, f64::from(corner.y) + 0.5));
            [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
                let (dx, dy) = (to.0 - from.0, to.1 - from.1);
                ((y - from.1) * dx - (x - from.0) * dy) / dx.hypot(dy) > 2.5
            })
        });
        assert!(off <= 6, "{triangle:?}: {off}");
    }
    // A triangle with a stroke is its outer outline less its inner one.
    let triangle = Triangle::new(Point::new(10, 10), Point::new(90, 20), Point::new(30, 80));
    let both = StyleBuilder::new().stroke_color(Rgb565::RED).fill_color(Rgb565::RED).stroke_width(7).build();
    let off = most_off(triangle.into_styled(both.antialiased(Alpha)), |x, y| {
        let [a, b, c] = triangle.vertices.map(|corner| (f64::from(corner.x) + 0.5, f64::from(corner.y) + 0.5));
        [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
            let (dx, dy) = (to.0 - from.0, to.1 - from.1);
            ((y - from.1) * dx - (x - from.0) * dy) / dx.hypot(dy) > -3.5
        })
    });
    assert!(off <= 6, "{off}");
}
