//! What framebuffers and bands cost: solid fills beside `slice::fill`, clears beside embedded-graphics', and scenes in bands
//! beside the same scenes drawn at once.

use std::{fmt::Write as _, hint::black_box, time::Duration};

use embedded_graphics::{
    framebuffer::{Framebuffer as EgFramebuffer, buffer_size as eg_buffer_size},
    pixelcolor::{
        Rgb565, Rgb888,
        raw::{BigEndian, RawU16},
    },
    prelude::*,
    primitives::Rectangle,
};
use spanfill::{
    AntiAlias, AntiAliased, Band, Bands, Blend, BlockSink, Bounded, Canvas, Circle, Fill, FillRule, Filled,
    Framebuffer, InPlace, Line, MsbFirst, Polygon, PolygonCoverageWith, PolygonWithCapacity, Rows, Triangle, Values,
    Vertex, buffer_size,
};

use crate::{
    drawings::{self, Drawing},
    scenes::{self, FRAME_HEIGHT, FRAME_WIDTH},
    timing::timed,
};

type Packed = Rows<MsbFirst>;
type OfEg = EgFramebuffer<Rgb565, RawU16, BigEndian, 320, 240, { eg_buffer_size::<Rgb565>(320, 240) }>;

const SCREEN: Size = Size::new(FRAME_WIDTH.unsigned_abs(), FRAME_HEIGHT.unsigned_abs());
const BYTES: usize = buffer_size::<Rgb565, Packed>(SCREEN.width, SCREEN.height);
/// Of two different bytes.
const COLOUR: Rgb565 = Rgb565::CSS_ORANGE;

/// All tables.
pub(crate) fn report(rounds: u32) -> String {
    [spans(rounds), clears(rounds), bands(rounds)].join("\n")
}

/// The best time of each, in nanoseconds, everybody having a turn in each round.
fn best<const N: usize>(rounds: u32, mut works: [&mut dyn FnMut(); N]) -> [f64; N] {
    let repeats = works.each_mut().map(|work| {
        work();
        (100e-6 / timed(&mut *work).as_secs_f64().max(1e-9)).ceil() as u32
    });
    let mut best = [Duration::MAX; N];
    for _ in 0..rounds {
        for ((work, repeats), best) in works.iter_mut().zip(repeats).zip(&mut best) {
            *best = (*best).min(timed(|| (0..repeats).for_each(|_| work())));
        }
    }
    let mut repeats = repeats.into_iter();
    best.map(|best| best.as_secs_f64() * 1e9 / f64::from(repeats.next().unwrap_or(1)))
}

fn packed() -> Framebuffer<Rgb565, Packed, Vec<u8>> {
    Framebuffer::new(vec![0; BYTES], SCREEN).expect("as large as is needed")
}

fn values() -> Framebuffer<Rgb565, Values, Vec<Rgb565>> {
    Framebuffer::new(vec![Rgb565::BLACK; BYTES / 2], SCREEN).expect("as large as is needed")
}

/// Spans of one row at every column in turn: by `fill_solid`, and as a shape sends them, which are clipped already.
fn spans(rounds: u32) -> String {
    let mut table =
        "| span, RGB565 | `slice::fill` | it / `fill_solid`, bytes | values | it / a shape's span, bytes | values |\n\
                     |--:|--:|--:|--:|--:|--:|\n"
            .to_owned();
    for width in [8, 16, 32, 64, 96, 128, 200] {
        let starts = || (0..200_u32).map(|row| (row * 7 % (SCREEN.width - width + 1), row));
        let mut plain = vec![0_u16; BYTES / 2];
        let (mut packed, mut values) = (packed(), values());
        let (mut packed_again, mut values_again) = (self::packed(), self::values());
        let [slice, solid, solid_values, span, span_values] = best(
            rounds,
            [
                &mut || {
                    for (x, y) in starts() {
                        let start = (y * SCREEN.width + x) as usize;
                        black_box(&mut plain)[start..start + width as usize].fill(black_box(0xFD20));
                    }
                },
                &mut || solids(black_box(&mut packed), starts(), width),
                &mut || solids(black_box(&mut values), starts(), width),
                &mut || blocks(&mut packed_again.solid(black_box(COLOUR)), starts(), width),
                &mut || blocks(&mut values_again.solid(black_box(COLOUR)), starts(), width),
            ],
        )
        .map(|time| time / 200.0);
        let [solid, solid_values, span, span_values] =
            [solid, solid_values, span, span_values].map(|time| format!("{:.2}", slice / time));
        writeln!(table, "| {width} px | {slice:.1} ns | {solid} | {solid_values} | {span} | {span_values} |")
            .expect("text");
    }
    table
}

#[inline(always)]
fn solids(target: &mut impl DrawTarget<Color = Rgb565>, starts: impl Iterator<Item = (u32, u32)>, width: u32) {
    for (x, y) in starts {
        let area = Rectangle::new(Point::new(x as i32, y as i32), Size::new(width, 1));
        assert!(target.fill_solid(&area, black_box(COLOUR)).is_ok());
    }
}

#[inline(always)]
fn blocks(sink: &mut impl BlockSink, starts: impl Iterator<Item = (u32, u32)>, width: u32) {
    for (x, y) in starts.map(black_box) {
        let (x, y) = (x as i32, y as i32);
        assert!(sink.block(y..y + 1, x..x + width as i32).is_ok());
    }
}

fn clears(rounds: u32) -> String {
    let mut of_eg = Box::new(OfEg::new());
    let (mut packed, mut values) = (packed(), values());
    let mut plain = vec![0_u16; BYTES / 2];
    let [of_eg, slice, bytes, values] = best(
        rounds,
        [
            &mut || {
                let Ok(()) = black_box(&mut *of_eg).clear(black_box(COLOUR));
            },
            &mut || black_box(&mut plain).fill(black_box(0xFD20)),
            &mut || {
                let Ok(()) = black_box(&mut packed).clear(black_box(COLOUR));
            },
            &mut || {
                let Ok(()) = black_box(&mut values).clear(black_box(COLOUR));
            },
        ],
    );
    let mut table = "| cleared, 320 x 240, RGB565 | time | embedded-graphics / it |\n|---|--:|--:|\n".to_owned();
    for (name, time) in
        [("embedded-graphics", of_eg), ("`slice::fill`", slice), ("in bytes", bytes), ("as values", values)]
    {
        writeln!(table, "| {name} | {:.2} us | {:.1} |", time / 1e3, of_eg / time).expect("text");
    }
    table
}

/// Everything that a scene consists of: outlines are prepared as a constant is, or as a program does once.
enum Item {
    Triangle(Triangle),
    Circle(Circle),
    Line(Line),
    Outline(Bounded<Filled<PolygonWithCapacity<'static, EDGES>, Rgb565>>, BlendedOutline),
}

type BlendedOutline = Bounded<AntiAliased<PolygonCoverageWith<'static, EDGES>, Rgb565, InPlace>>;

/// Enough for each of the drawings but the coast, whose scratch would be most of what it costs.
const EDGES: usize = 64;

impl Item {
    #[inline(always)]
    fn draw<D: Canvas<Color = Rgb565>>(&self, target: &mut D) -> Result<(), D::Error> {
        match self {
            Self::Triangle(shape) => shape.filled(COLOUR).draw_on(target),
            Self::Circle(shape) => shape.filled(COLOUR).draw_on(target),
            Self::Line(shape) => shape.filled(COLOUR).draw_on(target),
            Self::Outline(filled, _) => filled.draw_on(target),
        }
    }

    #[inline(always)]
    fn blend<D: Canvas<Color = Rgb565>>(&self, target: &mut D) -> Result<(), D::Error>
    where
        InPlace: Blend<D>,
    {
        match self {
            Self::Triangle(shape) => shape.antialiased(COLOUR, InPlace).draw_on(target),
            Self::Circle(shape) => shape.antialiased(COLOUR, InPlace).draw_on(target),
            Self::Line(shape) => shape.antialiased(COLOUR, InPlace).draw_on(target),
            Self::Outline(_, blended) => blended.draw_on(target),
        }
    }
}

fn outlines(drawing: &Drawing) -> Vec<Item> {
    let outline = |shape: &drawings::Shape| {
        let contour = |contour: &Vec<[i32; 2]>| -> &'static [Vertex] {
            contour.iter().map(|&[x, y]| Vertex::from_bits(x, y)).collect::<Vec<_>>().leak()
        };
        let contours: Vec<&'static [Vertex]> = shape.contours.iter().map(contour).collect();
        let rule = if shape.even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let [r, g, b] = shape.rgb;
        let polygon = Polygon::with_contours(contours.leak()).fill_rule(rule);
        let colour = Rgb565::from(Rgb888::new(r, g, b));
        let enough = "the drawings need less";
        Item::Outline(
            Bounded::new(polygon.with_capacity().expect(enough).filled(colour)),
            Bounded::new(polygon.coverage_with().expect(enough).antialiased(colour, InPlace)),
        )
    };
    drawing.shapes.iter().map(outline).collect()
}

/// Filled shapes of a few pixels, and a few large ones.
fn shapes(small: bool) -> Vec<Item> {
    let point = |[x, y]: [i32; 2]| Point::new(x, y);
    let (count, triangle, circle, line) = if small { (200, 10, 5, 10) } else { (40, 50, 20, 50) };
    let triangles = scenes::triangles(triangle).map(|corners| corners.map(point));
    let circles = scenes::circles(circle).map(|[x, y]| Circle::new(Vertex::new(x, y), circle));
    let lines = scenes::lines(line).map(|ends| ends.map(point));
    (triangles.take(count).map(|[a, b, c]| Item::Triangle(Triangle::new(a, b, c))))
        .chain(circles.take(count).map(Item::Circle))
        .chain(lines.take(count).map(|[a, b]| Item::Line(Line::new(a, b))))
        .collect()
}

const BAND_ROWS: u32 = 8;

/// Drawn in bands, and at once: nothing is sent, as that takes the same.
fn bands(rounds: u32) -> String {
    let mut table = "| scene, RGB565 in bytes | filled at once | in bands of 8 rows | times | blended at once | in bands | times |\n\
                     |---|--:|--:|--:|--:|--:|--:|\n"
        .to_owned();
    let mut scenes =
        vec![("600 shapes of 10 px".to_owned(), shapes(true)), ("120 shapes of 50 px".to_owned(), shapes(false))];
    for (name, bytes) in drawings::DRAWINGS {
        if !["coast", "stroked-world"].contains(&name) {
            scenes.push((name.to_owned(), outlines(&drawings::load(bytes))));
        }
    }
    for (name, items) in &scenes {
        let of = |work: fn(&[Item], &mut Frame), in_bands: fn(&[Item], &mut InBands)| {
            let mut frame = packed();
            let buffer = vec![0; buffer_size::<Rgb565, Packed>(SCREEN.width, BAND_ROWS)];
            let mut bands = Bands::new([buffer], SCREEN, Rgb565::BLACK).expect("a band has room");
            best(
                rounds / 4 + 3,
                [&mut || work(black_box(items), &mut frame), &mut || {
                    in_bands(black_box(items), &mut bands);
                }],
            )
        };
        let [at_once, in_bands] = of(
            |items, frame| whole(items, frame, |item, frame| item.draw(frame)),
            |items, bands| split(items, bands, |item, band| item.draw(band)),
        );
        let [blended, blended_in_bands] = of(
            |items, frame| whole(items, frame, |item, frame| item.blend(frame)),
            |items, bands| split(items, bands, |item, band| item.blend(band)),
        );
        writeln!(
            table,
            "| {name} | {:.1} us | {:.1} us | {:.2} | {:.1} us | {:.1} us | {:.2} |",
            at_once / 1e3,
            in_bands / 1e3,
            in_bands / at_once,
            blended / 1e3,
            blended_in_bands / 1e3,
            blended_in_bands / blended,
        )
        .expect("text");
    }
    table
}

type Frame = Framebuffer<Rgb565, Packed, Vec<u8>>;
type InBands = Bands<Rgb565, Packed, Vec<u8>, 1>;

#[inline(always)]
fn whole(items: &[Item], frame: &mut Frame, draw: impl Fn(&Item, &mut Frame) -> Result<(), core::convert::Infallible>) {
    let Ok(()) = frame.clear(Rgb565::BLACK);
    for item in items {
        let Ok(()) = draw(item, frame);
    }
    black_box(frame.units());
}

#[inline(always)]
fn split(
    items: &[Item],
    bands: &mut InBands,
    draw: impl Fn(&Item, &mut Band<'_, Rgb565, Packed>) -> Result<(), core::convert::Infallible>,
) {
    bands
        .draw(
            |band| items.iter().try_for_each(|item| draw(item, band)),
            |band| {
                black_box(band.units());
                Ok::<(), core::convert::Infallible>(())
            },
        )
        .expect("nothing fails");
}
