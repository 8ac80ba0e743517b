//! Paints against formulas in `f64`, and mosaics against areas.

mod oracle;

use std::convert::Infallible;

use embedded_graphics::{
    image::ImageRaw,
    pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888},
    prelude::*,
};
use oracle::{cases, for_each_case};
use spanfill::{
    BadStops, Circle, ConicalGradient, CoverageSink, Fill as _, Gouraud, Hatch, InPlace, LinearGradient, Mosaic,
    MosaicCell, MosaicError, Over, Paint, Painting as _, Pattern, PixelRect, PixelRows, RadialGradient, Solid, Span,
    Spread, Stop, Stops, Tile, Triangle, Vertex,
};

const SIDE: usize = 48;

/// Pixels in memory, around which nothing may be sent.
#[derive(Clone, PartialEq)]
struct Memory<C>(Vec<C>);

impl<C: PixelColor> Memory<C> {
    fn new(colour: C) -> Self {
        Self(vec![colour; SIDE * SIDE])
    }

    fn at(&self, x: i32, y: i32) -> C {
        self.0[y as usize * SIDE + x as usize]
    }
}

impl<C> OriginDimensions for Memory<C> {
    fn size(&self) -> Size {
        Size::new_equal(SIDE as u32)
    }
}

impl<C: PixelColor> PixelRows for Memory<C> {
    fn row_from(&mut self, start: Point) -> Option<&mut [C]> {
        let (x, y) = (usize::try_from(start.x).ok()?, usize::try_from(start.y).ok()?);
        self.0.chunks_mut(SIDE).nth(y)?.get_mut(x..).filter(|row| !row.is_empty())
    }
}

impl<C: PixelColor> DrawTarget for Memory<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            self.row_from(point).expect("nothing is sent outside")[0] = colour;
        }
        Ok(())
    }
}

fn whole() -> Triangle {
    Triangle::new(Vertex::new(-10, -10), Vertex::new(200, -10), Vertex::new(-10, 200))
}

/// What stops make of a place, before it is rounded.
fn exact(stops: &[(f64, f64)], spread: Spread, place: f64) -> f64 {
    let place = match spread {
        Spread::Pad => place.clamp(0.0, 1.0),
        Spread::Repeat => place.rem_euclid(1.0),
        Spread::Reflect => 1.0 - (place.rem_euclid(2.0) - 1.0).abs(),
    };
    let after = stops.iter().position(|(offset, _)| *offset > place);
    match after {
        Some(0) => stops[0].1,
        None => stops[stops.len() - 1].1,
        Some(after) => {
            let ((o0, c0), (o1, c1)) = (stops[after - 1], stops[after]);
            c0 + (c1 - c0) * (place - o0) / (o1 - o0)
        }
    }
}

/// Compares a paint with the places that it should have, away from where the gradient jumps.
fn check(
    paint: &impl Paint<Gray8>,
    stops: &[(f64, f64)],
    spread: Spread,
    place: impl Fn(f64, f64) -> f64,
) -> Result<f64, String> {
    let mut target = Memory::new(Gray8::BLACK);
    whole().painted(paint).draw(&mut target).expect("infallible");
    let mut rows = Memory::new(Gray8::BLACK);
    whole().painted(paint).draw_on(&mut rows);
    if target != rows {
        return Err("rows differ".into());
    }
    let mut worst: f64 = 0.0;
    for y in 0..SIDE as i32 {
        for x in 0..SIDE as i32 {
            let at = place(f64::from(x) + 0.5, f64::from(y) + 0.5);
            // Far out, repeated gradients lose their phase. What is not a number is not looked at.
            if at.is_nan() || at.abs() > 64.0 && spread != Spread::Pad {
                continue;
            }
            // Whatever the place would be if it were off by 2^-15, or by 2^-17 of itself.
            let off = 1_f64.max(at.abs() / 4.0) / 32768.0;
            let near = (-8..=8).map(|part| exact(stops, spread, at + f64::from(part) / 8.0 * off));
            let (low, high) = near.fold((f64::MAX, f64::MIN), |(low, high), at| (low.min(at), high.max(at)));
            let found = f64::from(target.at(x, y).luma());
            let error = (low - found).max(found - high).max(0.0);
            worst = worst.max(error);
            if error > 1.0 {
                return Err(format!("{found} at {x} {y}, {low} to {high} expected at {at}"));
            }
        }
    }
    Ok(worst)
}

#[test]
fn gradients_are_exact_to_a_level() {
    for_each_case(0x9A17, cases(1_500), |rng| {
        let count = rng.int(1..=5);
        let mut offsets: Vec<i64> = (0..count).map(|_| rng.int(0..=64) * 1024).collect();
        offsets.sort_unstable();
        let stops: Vec<_> =
            offsets.iter().map(|offset| Stop::new(*offset as u32, Gray8::new(rng.int(0..=255) as u8))).collect();
        let plain: Vec<_> =
            stops.iter().map(|stop| (f64::from(stop.offset) / 65536.0, f64::from(stop.colour.luma()))).collect();
        let spread = rng.pick(&[Spread::Pad, Spread::Repeat, Spread::Reflect]);
        let stops = Stops::new(&stops, spread).expect("sorted");
        let mut point = || Vertex::from_bits(rng.int(-2000..=14000) as i32, rng.int(-2000..=14000) as i32);
        let (start, end) = (point(), point());
        let (x0, y0) = (start.x.to_num::<f64>(), start.y.to_num::<f64>());
        let (dx, dy) = (end.x.to_num::<f64>() - x0, end.y.to_num::<f64>() - y0);
        let square = dx * dx + dy * dy;
        if square > 1.0 {
            let linear = |x: f64, y: f64| ((x - x0) * dx + (y - y0) * dy) / square;
            check(&LinearGradient::new(start, end, stops), &plain, spread, linear)?;
            let radius = Vertex::new(square.sqrt(), 0).x;
            let radial = |x: f64, y: f64| (x - x0).hypot(y - y0) / radius.to_num::<f64>();
            check(&RadialGradient::new(start, radius, stops), &plain, spread, radial)?;
        }
        let ends = [point(), point()];
        let [[ax, ay], [bx, by]] = ends.map(|end| [end.x.to_num::<f64>() - x0, end.y.to_num::<f64>() - y0]);
        let area = ax * by - ay * bx;
        // No thinner than a tenth of a pixel.
        if area.abs() > ax.hypot(ay).max(bx.hypot(by)) / 10.0 {
            let axes = |x: f64, y: f64| {
                let (x, y) = (x - x0, y - y0);
                ((x * by - y * bx) / area, (ax * y - ay * x) / area)
            };
            let ellipse = RadialGradient::elliptical(start, ends, stops);
            check(&ellipse, &plain, spread, |x, y| {
                let (u, v) = axes(x, y);
                u.hypot(v)
            })?;
            let focus = point();
            let inner = rng.int(0..=60000);
            let r = inner as f64 / 65536.0;
            let (fu, fv) = axes(focus.x.to_num(), focus.y.to_num());
            let (far, furthest) = (fu.hypot(fv), (1.0 - r) * 255.0 / 256.0);
            let shrink = if far > furthest { furthest / far } else { 1.0 };
            let (fu, fv) = (fu * shrink, fv * shrink);
            // The larger root of |p - f + t f| = r + t (1 - r).
            let focal = |x: f64, y: f64| {
                let (u, v) = axes(x, y);
                let (du, dv) = (u - fu, v - fv);
                let a = (1.0 - r) * (1.0 - r) - fu * fu - fv * fv;
                let b = du * fu + dv * fv - r * (1.0 - r);
                let c = r * r - du * du - dv * dv;
                (b + (b * b - a * c).sqrt()) / a
            };
            check(&ellipse.with_focus(focus, inner as u32), &plain, spread, focal)?;
        }
        let angle = rng.int(0..=65535);
        let conical = |x: f64, y: f64| {
            if x == x0 && y == y0 {
                0.0
            } else {
                let turn = ((y - y0).atan2(x - x0) / std::f64::consts::TAU - angle as f64 / 65536.0).rem_euclid(1.0);
                // Where it begins and ends, either is right.
                if (1.0 / 32768.0..32767.0 / 32768.0).contains(&turn) { turn } else { f64::NAN }
            }
        };
        check(&ConicalGradient::new(start, angle as u16, stops), &plain, spread, conical)?;
        Ok(1)
    });
}

/// A ramp along a line and around a point against rationals, from one end of the coordinates to the other: the nearest
/// level, or the next to it.
#[test]
fn ramps_are_exact_rationals() {
    let ends = |rng: &mut oracle::Rng| -> [i32; 2] {
        if rng.one_in(4) {
            [rng.pick(&[i32::MIN, i32::MAX, 0, -1]), rng.pick(&[i32::MIN, i32::MAX, 0, 1])]
        } else {
            [rng.int(-20_000..=30_000) as i32, rng.int(-20_000..=30_000) as i32]
        }
    };
    for_each_case(0x9A1D, cases(1_500), |rng| {
        let (start, end) = (ends(rng), ends(rng));
        let [first, last] = [(); 2].map(|()| rng.int(0..=255));
        let stops = [Stop::new(0, Gray8::new(first as u8)), Stop::new(65536, Gray8::new(last as u8))];
        let stops = Stops::new(&stops, Spread::Pad).expect("sorted");
        let difference = |a: [i32; 2], b: [i32; 2]| [0, 1].map(|axis| i128::from(b[axis]) - i128::from(a[axis]));
        let d = difference(start, end);
        let square = d[0] * d[0] + d[1] * d[1];
        if square == 0 {
            return Ok(0);
        }
        let [from, to] = [start, end].map(|[x, y]| Vertex::from_bits(x, y));
        let radius = (rng.int(1..=i64::from(i32::MAX)) >> rng.int(0..=24)).max(1);
        let (mut line, mut disc) = (Memory::new(Gray8::BLACK), Memory::new(Gray8::BLACK));
        whole().painted(LinearGradient::new(from, to, stops)).draw(&mut line).expect("infallible");
        let around = RadialGradient::new(from, spanfill::I24F8::from_bits(radius as i32), stops);
        whole().painted(around).draw(&mut disc).expect("infallible");
        let (first, last) = (i128::from(first), i128::from(last));
        for y in 0..SIDE as i32 {
            for x in 0..SIDE as i32 {
                let p = difference(start, [256 * x + 128, 256 * y + 128]);
                // The place is `along / square`.
                let along = (p[0] * d[0] + p[1] * d[1]).clamp(0, square);
                let found = i128::from(line.at(x, y).luma());
                if ((found - first) * square - (last - first) * along).abs() >= square {
                    return Err(format!("line: {found} at {x} {y}, {start:?} {end:?}, {first} to {last}"));
                }
                // The place is the root of `distance / radius^2`; the level before and after is on the other side of it.
                let radius = i128::from(radius);
                let distance = (p[0] * p[0] + p[1] * p[1]).min(radius * radius);
                let found = i128::from(disc.at(x, y).luma());
                let (rise, level) = ((last - first).abs(), (found - first) * (last - first).signum());
                // `level - 1 < rise * root(distance) / radius < level + 1`.
                let below = |level: i128| level <= 0 || level * level * radius * radius < rise * rise * distance;
                let above = |level: i128| level * level * radius * radius > rise * rise * distance;
                if !(below(level - 1) && above(level + 1)) && rise > 0 || rise == 0 && found != first {
                    return Err(format!("disc: {found} at {x} {y}, {start:?} {radius}, {first} to {last}"));
                }
            }
        }
        Ok(1)
    });
}

/// The same in the three channels of a colour of few steps.
#[test]
fn dithers_of_colours_have_the_mean_of_each_channel() {
    let ends = [Rgb565::new(3, 60, 9), Rgb565::new(4, 10, 9)];
    let stops = [Stop::new(0, ends[0]), Stop::new(65536, ends[1])];
    let stops = Stops::new(&stops, Spread::Pad).unwrap().dithered();
    let mut target = Memory::new(Rgb565::BLACK);
    whole().painted(LinearGradient::new(Vertex::new(0, 0), Vertex::new(0, 48), stops)).draw(&mut target).unwrap();
    // Over all 48 rows and columns, each 8 x 8 of them once: half way between the ends, to 1/64 of a step.
    let mean = |channel: fn(&Rgb565) -> u8| {
        target.0.iter().map(|colour| f64::from(channel(colour))).sum::<f64>() / (SIDE * SIDE) as f64
    };
    for (found, expected) in [(mean(Rgb565::r), 3.5), (mean(Rgb565::g), 35.0), (mean(Rgb565::b), 9.0)] {
        assert!((found - expected).abs() <= 1.0 / 32.0, "{found} in place of {expected}");
    }
    // A step is never more than one off.
    for y in 0..48 {
        let green = 60.0 - 50.0 * (f64::from(y) + 0.5) / 48.0;
        for x in 0..48 {
            assert!((f64::from(target.at(x, y).g()) - green).abs() < 1.02);
        }
    }
}

#[test]
fn gradients_of_no_length_have_the_last_colour() {
    let stops = [Stop::new(0, Gray8::new(10)), Stop::new(65536, Gray8::new(200))];
    for spread in [Spread::Pad, Spread::Repeat, Spread::Reflect] {
        let stops = Stops::new(&stops, spread).unwrap();
        let at = Vertex::new(20, 20);
        let mut target = Memory::new(Gray8::BLACK);
        whole().painted(LinearGradient::new(at, at, stops)).draw(&mut target).unwrap();
        assert_eq!(target.0, Memory::new(Gray8::new(200)).0);
        for radius in [0, -5] {
            let mut target = Memory::new(Gray8::BLACK);
            whole().painted(RadialGradient::new(at, radius, stops)).draw(&mut target).unwrap();
            assert_eq!(target.0, Memory::new(Gray8::new(200)).0);
        }
        let flat = RadialGradient::elliptical(at, [Vertex::new(30, 20), Vertex::new(40, 20)], stops);
        for paint in [flat, flat.with_focus(Vertex::new(25, 20), 9)] {
            let mut target = Memory::new(Gray8::BLACK);
            whole().painted(paint).draw(&mut target).unwrap();
            assert_eq!(target.0, Memory::new(Gray8::new(200)).0);
        }
    }
}

#[test]
fn bad_stops_are_refused() {
    let stop = |offset| Stop::new(offset, Gray8::BLACK);
    let new = |stops: &[Stop<Gray8>]| Stops::new(stops, Spread::Pad).map(|_| ());
    assert_eq!(new(&[]), Err(BadStops::None));
    assert_eq!(new(&[stop(0), stop(7), stop(6)]), Err(BadStops::Unsorted { index: 2 }));
    assert_eq!(new(&[stop(0), stop(65537)]), Err(BadStops::TooFar { index: 1 }));
    assert_eq!(new(&[stop(9), stop(9)]), Ok(()));
    assert!(Pattern::new(ImageRaw::<Gray8>::new(&[], 0), Point::zero()).is_err());
}

#[test]
fn equal_stops_are_a_hard_edge() {
    let stops = [(0, 10), (32768, 10), (32768, 200), (65536, 200)].map(|(at, luma)| Stop::new(at, Gray8::new(luma)));
    let stops = Stops::new(&stops, Spread::Pad).unwrap();
    let mut target = Memory::new(Gray8::BLACK);
    whole().painted(LinearGradient::new(Vertex::new(0, 0), Vertex::new(48, 0), stops)).draw(&mut target).unwrap();
    for x in 0..48 {
        assert_eq!(target.at(x, 5).luma(), if x < 24 { 10 } else { 200 });
    }
}

/// In every aligned tile of a place alike, as many pixels are on as the place says.
#[test]
fn dithers_have_the_exact_mean() {
    for step in 0..=64_u32 {
        // Across, all alike.
        let stops = [Stop::new(step * 1024, BinaryColor::Off), Stop::new(step * 1024, BinaryColor::On)];
        let _ = stops;
        let ends = [Stop::new(0, Gray4::new(3)), Stop::new(65536, Gray4::new(4))];
        let stops = Stops::new(&ends, Spread::Pad).unwrap().dithered();
        // A line far below its start, so that the whole of a screen lies at one place.
        let far = Vertex::new(0, -(1 << 20));
        let length = if step == 0 { continue } else { (64 << 20) / step as i32 };
        let end = Vertex::new(0, -(1 << 20) + length.min((1 << 23) - 1));
        if length > (1 << 22) {
            continue;
        }
        let mut target = Memory::new(Gray4::BLACK);
        whole().painted(LinearGradient::new(far, end, stops)).draw(&mut target).unwrap();
        let brighter = (0..8).flat_map(|y| (0..8).map(move |x| (x, y))).filter(|(x, y)| target.at(*x, *y).luma() == 4);
        let expected = ((f64::from(1 << 20) + 4.0) / f64::from(length.min((1 << 23) - 1)) * 64.0).round();
        assert!((brighter.count() as f64 - expected).abs() <= 1.0, "{step}");
    }
    let ends = [Stop::new(0, BinaryColor::Off), Stop::new(65536, BinaryColor::On)];
    let stops = Stops::new(&ends, Spread::Pad).unwrap().dithered();
    let mut target = Memory::new(BinaryColor::Off);
    whole().painted(LinearGradient::new(Vertex::new(0, 0), Vertex::new(48, 0), stops)).draw(&mut target).unwrap();
    let on = |columns: std::ops::Range<i32>| {
        columns.flat_map(|x| (0..48).map(move |y| (x, y))).filter(|(x, y)| target.at(*x, *y).is_on()).count()
    };
    assert!(on(0..24).abs_diff(24 * 48 / 4) < 24, "{}", on(0..24));
    assert!(on(24..48).abs_diff(24 * 48 * 3 / 4) < 24, "{}", on(24..48));
}

#[test]
fn patterns_belong_to_the_screen() {
    let picture = ImageRaw::<Gray8>::new(&[1, 2, 3, 4, 5, 6], 3);
    let pattern = Pattern::new(picture, Point::new(-100, 7)).unwrap();
    let hatch = Hatch::new(Hatch::CROSS, Gray8::WHITE, Gray8::new(1));
    let (mut tiled, mut hatched) = (Memory::new(Gray8::BLACK), Memory::new(Gray8::BLACK));
    Circle::new(Vertex::new(24, 24), 21).painted(pattern).draw(&mut tiled).unwrap();
    Circle::new(Vertex::new(24, 24), 21).painted(hatch).draw(&mut hatched).unwrap();
    let mut disc = Memory::new(Gray8::BLACK);
    Circle::new(Vertex::new(24, 24), 21).filled(Gray8::WHITE).draw(&mut disc).unwrap();
    for y in 0..48 {
        for x in 0..48 {
            let inside = disc.at(x, y) == Gray8::WHITE;
            let texel = 1 + (x + 100) % 3 + 3 * (y - 7_i32).rem_euclid(2);
            assert_eq!(i32::from(tiled.at(x, y).luma()), if inside { texel } else { 0 });
            let set = Hatch::CROSS[y as usize % 8] >> (7 - x % 8) & 1 == 1;
            assert_eq!(
                hatched.at(x, y).luma(),
                if !inside {
                    0
                } else if set {
                    255
                } else {
                    1
                }
            );
        }
    }
}

/// One colour painted with blended edges is what `antialiased` draws in that colour.
#[test]
fn a_solid_paint_is_the_colour() {
    use spanfill::AntiAlias as _;
    for_each_case(0x9A18, cases(500), |rng| {
        let (triangle, _) = oracle::random::triangle(rng);
        let (mut one, mut other) = (Memory::new(Rgb565::new(3, 5, 7)), Memory::new(Rgb565::new(3, 5, 7)));
        triangle.antialiased(Rgb565::YELLOW, InPlace).draw_on(&mut one).unwrap();
        triangle.painted(Solid(Rgb565::YELLOW)).antialiased(InPlace).draw_on(&mut other).unwrap();
        if one == other { Ok(1) } else { Err(format!("{triangle:?}")) }
    });
}

/// Shapes that know their coverage alone are painted, too; a mask of one level is an opacity.
#[test]
fn polygons_are_painted_and_masked() {
    use spanfill::{AntiAlias as _, Masked, Painted, Polygon};
    for_each_case(0x9A1A, cases(300), |rng| {
        let vertices: Vec<_> = (0..rng.int(3..=7))
            .map(|_| Vertex::from_bits(rng.int(-2000..=14000) as i32, rng.int(-2000..=14000) as i32))
            .collect();
        let polygon = Polygon::new(&vertices).coverage_with::<8>().expect("enough");
        let opacity = rng.int(0..=255) as u8;
        let background = Memory::new(Rgb565::new(3, 5, 7));
        let mut targets = [(); 4].map(|()| background.clone());
        let [one, painted, through, masked] = &mut targets;
        polygon.antialiased(Rgb565::YELLOW, InPlace).draw_on(one).unwrap();
        Painted::new(polygon, Solid(Rgb565::YELLOW)).antialiased(InPlace).draw_on(painted).unwrap();
        polygon.antialiased(Rgb565::YELLOW, InPlace).opacity(opacity).draw_on(through).unwrap();
        let mask = Masked::new(polygon, Solid(Gray8::new(opacity)));
        Painted::new(mask, Solid(Rgb565::YELLOW)).antialiased(InPlace).draw_on(masked).unwrap();
        if one != painted || through != masked {
            return Err(format!("{opacity} {vertices:?}"));
        }
        // A mask that changes from pixel to pixel, and a sink that is told no pixel twice and none that is not covered.
        let across = Pattern::new(ImageRaw::<Gray8>::new(&[0, 90, 255, 255, 1, 0, 0], 7), Point::zero()).unwrap();
        let (plain, faded) = (mosaic::coverage(&polygon), mosaic::coverage(&Masked::new(polygon, across)));
        for (index, (plain, faded)) in plain.iter().zip(&faded).enumerate() {
            let opacity = [0, 90, 255, 255, 1, 0, 0][index % SIDE % 7];
            let expected = (u32::from(*plain) * opacity * 2 + 255) / 510;
            if u32::from(*faded) != expected {
                return Err(format!("{faded} of {plain}, {opacity}: {vertices:?}"));
            }
        }
        Ok(1)
    });
}

mod mosaic {
    use super::*;

    /// The coverage that one shape says.
    pub(super) fn coverage(shape: &impl spanfill::Cover) -> Vec<u8> {
        struct Record(Vec<u8>);
        impl CoverageSink for Record {
            type Error = Infallible;
            fn span(&mut self, span: Span, coverage: u8) -> Result<(), Infallible> {
                for column in span.columns {
                    self.0[span.row as usize * SIDE + column as usize] = coverage;
                }
                Ok(())
            }
            fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Infallible> {
                self.0[row as usize * SIDE + column as usize..][..coverage.len()].copy_from_slice(coverage);
                Ok(())
            }
        }
        let mut record = Record(vec![0; SIDE * SIDE]);
        let clip = PixelRect { rows: 0..SIDE as i32, columns: 0..SIDE as i32 };
        let Ok(()) = shape.coverage(&clip, &mut record);
        record.0
    }

    /// Slices of a pie, each white: no pixel inside shows the black behind.
    #[test]
    fn a_pie_of_eight_slices_has_no_seam() {
        let centre = Vertex::new(23.77, 24.31);
        let rim: Vec<_> = (0..8)
            .map(|i| {
                let angle = f64::from(i) * std::f64::consts::TAU / 8.0 + 0.3;
                Vertex::new(23.77 + 20.0 * angle.cos(), 24.31 + 20.0 * angle.sin())
            })
            .collect();
        let slices: Vec<_> = (0..8).map(|i| Triangle::from_vertices([centre, rim[i], rim[(i + 1) % 8]])).collect();
        let tiles: Vec<_> = slices.iter().map(|slice| Tile::new(*slice, Solid(Gray8::WHITE))).collect();
        let union = spanfill::Polygon::new(&rim).coverage_with::<16>().unwrap();
        let expected = coverage(&union);
        for cells in [SIDE, 3 * SIDE + 5, SIDE * SIDE] {
            let mut target = Memory::new(Gray8::BLACK);
            Mosaic::new(&tiles[..]).draw_on(&mut target, InPlace, &mut vec![MosaicCell::EMPTY; cells]).unwrap();
            for (index, (found, expected)) in target.0.iter().zip(&expected).enumerate() {
                let found = found.luma();
                assert!(*expected < 255 || found == 255, "a seam at {} {}: {found}", index % SIDE, index / SIDE);
                // Two roundings of what is nearly the same.
                assert!(found.abs_diff(*expected) <= 1, "{found} in place of {expected}");
            }
        }
        // One after the other, it shows.
        let mut target = Memory::new(Gray8::BLACK);
        for slice in &slices {
            slice.painted(Solid(Gray8::WHITE)).antialiased(InPlace).draw_on(&mut target).unwrap();
        }
        assert!(target.0.iter().zip(&expected).any(|(found, expected)| *expected == 255 && found.luma() < 220));
    }

    /// Random triangulations of the whole screen, in any order, in colours of their own.
    #[test]
    fn meshes_have_no_seam() {
        for_each_case(0x9A19, cases(300), |rng| {
            let mut grid = [[Vertex::new(0, 0); 5]; 5];
            for (j, row) in grid.iter_mut().enumerate() {
                for (i, vertex) in row.iter_mut().enumerate() {
                    let mut shake = |at: usize| if at == 0 || at == 4 { 0 } else { rng.int(-1500..=1500) };
                    let (dx, dy) = (shake(i), shake(j));
                    let at = |index: usize| -256 + index as i64 * 3200;
                    *vertex = Vertex::from_bits((at(i) + dx) as i32, (at(j) + dy) as i32);
                }
            }
            let mut tiles = Vec::new();
            for j in 0..4 {
                for i in 0..4 {
                    let [a, b, c, d] = [grid[j][i], grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]];
                    for corners in [[a, b, c], [a, c, d]] {
                        let triangle = Triangle::from_vertices(corners);
                        let mut colour = || Rgb888::new(rng.int(100..=200) as u8, 150, rng.int(0..=255) as u8);
                        let gouraud = Gouraud::new(triangle, [colour(), colour(), colour()]);
                        tiles.push(Tile::new(triangle, gouraud.paint()));
                    }
                }
            }
            rng.shuffle(&mut tiles);
            let mut target = Memory::new(Rgb888::new(0, 0, 0));
            let mut cells = vec![MosaicCell::EMPTY; 4 * SIDE];
            Mosaic::new(&tiles[..]).draw_on(&mut target, InPlace, &mut cells).expect("enough");
            for (index, found) in target.0.iter().enumerate() {
                if found.r() < 100 || found.r() > 200 || found.g() != 150 {
                    return Err(format!("{found:?} at {} {}", index % SIDE, index / SIDE));
                }
            }
            Ok(1)
        });
    }

    /// Countries: polygons whose borders are jagged lines that two of them share, in any order, on a background that
    /// must not be seen; their outer rim is that of all of them as one polygon.
    #[test]
    fn a_map_of_polygons_has_no_seam() {
        for_each_case(0x9A1B, cases(200), |rng| {
            // Borders from left to right, one below the other, the first and the last being the rim.
            let borders: Vec<Vec<Vertex>> = (0..5)
                .map(|border| {
                    (0..7)
                        .map(|step| {
                            let shake = [rng.int(-200..=200), rng.int(-300..=300)].map(|part| part as i32);
                            Vertex::from_bits(900 + 1700 * step + shake[0], 900 + 2500 * border + shake[1])
                        })
                        .collect()
                })
                .collect();
            let countries: Vec<Vec<Vertex>> =
                borders.windows(2).map(|pair| pair[0].iter().chain(pair[1].iter().rev()).copied().collect()).collect();
            let all = [&borders[..1], &borders[1..]].concat();
            let left = all.iter().rev().map(|border| border[0]).skip(1).take(3);
            let right = all.iter().map(|border| border[6]).skip(1).take(3);
            let (top, bottom) = (all[0].iter(), all[4].iter().rev());
            let rim: Vec<Vertex> = top.copied().chain(right).chain(bottom.copied()).chain(left).collect();
            let expected = coverage(&spanfill::Polygon::new(&rim).coverage_with::<32>().unwrap());
            let mut tiles: Vec<_> = countries
                .iter()
                .map(|country| {
                    let polygon = spanfill::Polygon::new(country).coverage_with::<32>().unwrap();
                    Tile::new(polygon, Solid(Gray8::WHITE))
                })
                .collect();
            rng.shuffle(&mut tiles);
            let mut target = Memory::new(Gray8::BLACK);
            Mosaic::new(&tiles[..]).draw_on(&mut target, InPlace, &mut vec![MosaicCell::EMPTY; 2 * SIDE]).unwrap();
            for (index, (found, expected)) in target.0.iter().zip(&expected).enumerate() {
                if found.luma() != *expected {
                    return Err(format!("{found:?}, not {expected}, at {} {}", index % SIDE, index / SIDE));
                }
            }
            Ok(1)
        });
    }

    /// What overlaps is covered by what comes later, never by more than everything.
    #[test]
    fn later_tiles_cover_earlier_ones() {
        let below = Tile::new(Circle::new(Vertex::new(20, 20), 15), Solid(Gray8::new(40)));
        let above = Tile::new(Circle::new(Vertex::new(28, 22), 12), Solid(Gray8::new(240)));
        let mut target = Memory::new(Gray8::BLACK);
        let mut cells = [MosaicCell::EMPTY; SIDE];
        Mosaic::new(below).with(above).draw_on(&mut target, Over(Gray8::BLACK), &mut cells).unwrap();
        assert_eq!(target.at(28, 22).luma(), 240);
        assert_eq!(target.at(10, 20).luma(), 40);
        // The upper one's edge within the lower one: a mix of both, nothing of the black.
        let expected = coverage(&Circle::new(Vertex::new(28, 22), 12));
        let inside = coverage(&Circle::new(Vertex::new(20, 20), 15));
        for index in 0..SIDE * SIDE {
            if inside[index] == 255 {
                let mix = 40.0 + 200.0 * f64::from(expected[index]) / 255.0;
                assert!((f64::from(target.0[index].luma()) - mix).abs() <= 1.0);
            }
        }
    }

    #[test]
    fn too_little_scratch_draws_nothing() {
        let tile = Tile::new(Circle::new(Vertex::new(20, 20), 10), Solid(Gray8::WHITE));
        let mut target = Memory::new(Gray8::BLACK);
        let error = Mosaic::new(tile).draw_on(&mut target, InPlace, &mut [MosaicCell::EMPTY; 19]).unwrap_err();
        let MosaicError::Scratch(error) = error;
        assert_eq!((error.needed, error.available), (20, 19));
        assert!(target == Memory::new(Gray8::BLACK));
        assert!(Mosaic::new(tile).draw_on(&mut target, InPlace, &mut [MosaicCell::EMPTY; 20]).is_ok());
    }
}
