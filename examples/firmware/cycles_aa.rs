//! What anti-aliased outlines cost a Cortex-M4F, in instructions: spanfill, blended in the frame's memory, and beside it
//! ab_glyph_rasterizer, which needs the float unit and an allocator: a mask, then blended into the same frame by the
//! same arithmetic.
//!
//! `examples/firmware/run.sh cycles_aa` builds it and runs it in QEMU's `mps2-an386` under `-icount shift=0`, where
//! every instruction takes the same time: a square root in the float unit counts as much as an addition.
//!
//! Outlines are prepared before the counting starts, for each in its own numbers. The rings differ from each other; the
//! drawings are those of `benches/drawings`. Before anything is counted, both draw everything, and the frames must agree
//! but where contours overlap, which adding up areas gets wrong.

#![no_std]
#![no_main]

#[path = "../../benches/drawings/mod.rs"]
mod drawings;
mod instruction_counter;
#[path = "../../benches/scenes/mod.rs"]
mod scenes;

use core::{
    fmt::{self, Write as _},
    mem,
};

use ab_glyph_rasterizer::{Rasterizer, point};
use cortex_m_semihosting::{
    debug,
    hio::{self, HostStream},
};
use embedded_alloc::LlffHeap;
use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
};
use panic_semihosting as _;
use spanfill::{AntiAlias, CoverageEdge, FillRule, InPlace, Mix, PixelRows, Polygon, Vertex};

use drawings::{GAUGE, ICONS, TEXT};
use instruction_counter::InstructionCounter;
use scenes::{FRAME_HEIGHT, FRAME_WIDTH, Frame, Random};

/// ab_glyph_rasterizer's: four bytes for each pixel of the largest mask, which is the gauge's rim, and as it grows, that of
/// the mask before and some more.
#[global_allocator]
static HEAP: LlffHeap = LlffHeap::empty();
const HEAP_BYTES: usize = 1_000_000;

/// How many different rings of a size are drawn.
const RINGS: usize = 32;
const COUNTED_ICONS: usize = 24;
/// The letters above this row are a line of text.
const TEXT_LINE_PX: i32 = 19;

const SHAPES: usize = 128;
const CONTOURS: usize = 1024;
const VERTICES: usize = 16 * 1024;
const EDGES: usize = 64;

#[cortex_m_rt::entry]
fn main() -> ! {
    let core = cortex_m::Peripherals::take().expect("nobody else takes the peripherals");
    start_heap();
    let mut bench = Bench {
        counter: InstructionCounter::new(core.SYST),
        frame: cortex_m::singleton!(: Frame = Frame::new()).expect("taken once"),
        other: cortex_m::singleton!(: Frame = Frame::new()).expect("taken once"),
        edges: cortex_m::singleton!(: [CoverageEdge; EDGES] = [CoverageEdge::EMPTY; EDGES]).expect("taken once"),
        mask: cortex_m::singleton!(: [u8; PIXELS] = [0; PIXELS]).expect("taken once"),
        rasterizer: Rasterizer::new(1, 1),
    };
    let mut room = Room {
        vertices: cortex_m::singleton!(: [Vertex; VERTICES] = [Vertex::from_bits(0, 0); VERTICES]).expect("taken once"),
        points: cortex_m::singleton!(: [[f32; 2]; VERTICES] = [[0.0; 2]; VERTICES]).expect("taken once"),
        contours: cortex_m::singleton!(: [Contour; CONTOURS] = [NO_CONTOUR; CONTOURS]).expect("taken once"),
        point_contours: cortex_m::singleton!(: [PointContour; CONTOURS] = [NO_POINTS; CONTOURS]).expect("taken once"),
    };

    let rows = [
        ("ring-12", 12, bench.each(&room.rings(12))),
        ("ring-24", 24, bench.each(&room.rings(24))),
        ("ring-48", 48, bench.each(&room.rings(48))),
        ("icons", 24, bench.all(&room.drawing(ICONS, COUNTED_ICONS, |_| true))),
        ("gauge", FRAME_HEIGHT, bench.all(&room.drawing(GAUGE, SHAPES, |_| true))),
        ("text-line", 12, bench.all(&room.drawing(TEXT, SHAPES, |bounds| bounds.bottom <= TEXT_LINE_PX))),
    ];
    let mut host = hio::hstdout().expect("the host takes text");
    print_table(&mut host, &rows).and_then(|()| print_csv(&mut host, &rows)).expect("the host takes text");
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the host has ended this program");
}

/// SAFETY: this is the only call, before anything is allocated.
#[allow(unsafe_code, reason = "an allocator is told of its memory")]
fn start_heap() {
    unsafe {
        embedded_alloc::init!(HEAP, HEAP_BYTES);
    }
}

const PIXELS: usize = (FRAME_WIDTH * FRAME_HEIGHT) as usize;

/// Pixels that an outline touches, all on the frame.
#[derive(Debug, Clone, Copy)]
struct Bounds {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
}

type Contour = &'static [Vertex];
type PointContour = &'static [[f32; 2]];
const NO_CONTOUR: Contour = &[];
const NO_POINTS: PointContour = &[];

/// An outline in everybody's numbers.
#[derive(Debug, Clone, Copy)]
struct Outline {
    polygon: Polygon<'static>,
    points: &'static [PointContour],
    bounds: Bounds,
    colour: Rgb565,
}

type Outlines = heapless::Vec<Outline, SHAPES>;

/// Where outlines are kept.
struct Room {
    vertices: &'static mut [Vertex],
    points: &'static mut [[f32; 2]],
    contours: &'static mut [Contour],
    point_contours: &'static mut [PointContour],
}

impl Room {
    fn outline<C: Iterator<Item = [i32; 2]>>(
        &mut self,
        contours: impl Iterator<Item = C>,
        rgb: [u8; 3],
        even_odd: bool,
    ) -> Outline {
        let mut bounds = Bounds { left: i32::MAX, top: i32::MAX, right: i32::MIN, bottom: i32::MIN };
        let mut count = 0;
        for contour in contours {
            let mut length = 0;
            for [x, y] in contour {
                self.vertices[length] = Vertex::from_bits(x, y);
                self.points[length] = [x as f32 / 256.0, y as f32 / 256.0];
                (bounds.left, bounds.right) = (bounds.left.min(x >> 8), bounds.right.max((x + 255) >> 8));
                (bounds.top, bounds.bottom) = (bounds.top.min(y >> 8), bounds.bottom.max((y + 255) >> 8));
                length += 1;
            }
            self.contours[count] = split(&mut self.vertices, length);
            self.point_contours[count] = split(&mut self.points, length);
            count += 1;
        }
        assert!(bounds.left >= 0 && bounds.right <= FRAME_WIDTH && bounds.top >= 0 && bounds.bottom <= FRAME_HEIGHT);
        let rule = if even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
        let polygon = Polygon::with_contours(split(&mut self.contours, count)).fill_rule(rule);
        let colour = Rgb888::new(rgb[0], rgb[1], rgb[2]).into();
        Outline { polygon, points: split(&mut self.point_contours, count), bounds, colour }
    }

    /// Rings between two wavy outlines of so many vertices each, in boxes of as many pixels, anywhere on the frame.
    fn rings(&mut self, vertices: i32) -> Outlines {
        let mut random = Random::new(0x2126 + vertices.unsigned_abs() as u64);
        let ring = |_| {
            let radius = vertices * 128;
            let centre = [FRAME_WIDTH, FRAME_HEIGHT].map(|length| radius + random.below(length * 256 - 2 * radius));
            let turned = random.below(TURN);
            let wavy = |largest: i32, direction: i32| {
                (0..vertices).map(move |i| {
                    let angle = direction * TURN / vertices * i;
                    // Three waves around, a seventh of the radius deep.
                    let distance = largest * 13 / 14 + ((largest / 14 * sin(3 * angle)) >> 14);
                    on_circle(centre, distance, turned + angle)
                })
            };
            self.outline([wavy(radius, 1), wavy(radius * 5 / 8, -1)].into_iter(), [0xff, 0xa5, 0x00], false)
        };
        (0..RINGS).map(ring).collect()
    }

    /// The first shapes of the drawing that are wanted.
    fn drawing(&mut self, drawing: &'static [u8], most: usize, is_wanted: fn(&Bounds) -> bool) -> Outlines {
        let mut outlines = Outlines::new();
        for shape in drawings::shapes(drawing) {
            if outlines.len() == most {
                break;
            }
            let outline = self.outline(shape.contours, shape.rgb, shape.even_odd);
            if !is_wanted(&outline.bounds) {
                break;
            }
            outlines.push(outline).expect("there is room for any drawing here");
        }
        outlines
    }
}

/// Splits off the first so many, for good.
fn split<T>(rest: &mut &'static mut [T], count: usize) -> &'static [T] {
    let (first, others) = mem::take(rest).split_at_mut(count);
    *rest = others;
    first
}

const TURN: i32 = 1 << 16;

fn on_circle([x, y]: [i32; 2], radius: i32, angle: i32) -> [i32; 2] {
    [x + ((radius * sin(angle + TURN / 4)) >> 14), y + ((radius * sin(angle)) >> 14)]
}

/// 2^14 sin(angle), the angle in 2^-16 turns, to 0.2 %: the approximation of Bhaskara I, seventh century.
fn sin(angle: i32) -> i32 {
    let half = TURN / 2;
    let (within, sign) = (angle.rem_euclid(half), if angle.rem_euclid(TURN) < half { 1 } else { -1 });
    let product = i64::from(within) * i64::from(half - within);
    let whole = i64::from(half) * i64::from(half);
    (sign * ((16 * product) << 14) / (5 * whole - 4 * product)) as i32
}

/// Instructions.
struct Cost {
    spanfill: u32,
    ab_glyph: u32,
}

struct Bench {
    counter: InstructionCounter,
    frame: &'static mut Frame,
    /// Both draw the same to begin with, each on a frame.
    other: &'static mut Frame,
    edges: &'static mut [CoverageEdge],
    mask: &'static mut [u8],
    rasterizer: Rasterizer,
}

impl Bench {
    /// An outline, on the average.
    fn each(&mut self, outlines: &[Outline]) -> Cost {
        let Cost { spanfill, ab_glyph } = self.all(outlines);
        let count = outlines.len() as u32;
        Cost { spanfill: spanfill / count, ab_glyph: ab_glyph / count }
    }

    /// All outlines.
    fn all(&mut self, outlines: &[Outline]) -> Cost {
        let Ok(()) = self.frame.clear(Rgb565::BLACK);
        let Ok(()) = self.other.clear(Rgb565::BLACK);
        for outline in outlines {
            spanfill(outline, self.edges, self.frame);
            // The largest mask is asked for here, too.
            ab_glyph(outline, &mut self.rasterizer, self.mask, self.other);
        }
        assert_similar(self.frame, self.other);
        Cost {
            spanfill: self.counter.count(outlines, |outline| spanfill(outline, self.edges, self.frame)),
            ab_glyph: self.counter.count(outlines, |outline| {
                ab_glyph(outline, &mut self.rasterizer, self.mask, self.frame);
            }),
        }
    }
}

fn assert_similar(frame: &Frame, other: &Frame) {
    let pixels = || frame.rows().as_flattened().iter().zip(other.rows().as_flattened());
    // A rounding is one step of a channel, and shapes lie over each other.
    let differ = |one: u8, other: u8| one.abs_diff(other) > 3;
    let is_other = |(one, other): &(&Rgb565, &Rgb565)| {
        differ(one.r(), other.r()) || differ(one.g(), other.g()) || differ(one.b(), other.b())
    };
    let drawn = pixels().filter(|(pixel, _)| **pixel != Rgb565::BLACK).count();
    let others = pixels().filter(is_other).count();
    assert!(others * 50 < drawn, "{others} of {drawn} pixels are not the same");
}

fn spanfill(outline: &Outline, edges: &mut [CoverageEdge], frame: &mut Frame) {
    let cover = outline.polygon.coverage_in(edges).expect("there is enough for each outline");
    let Ok(()) = cover.antialiased(outline.colour, InPlace).draw_on(frame);
}

fn ab_glyph(outline: &Outline, rasterizer: &mut Rasterizer, mask: &mut [u8], frame: &mut Frame) {
    rasterize(rasterizer, outline);
    rasterizer.for_each_pixel(|index, coverage| {
        if let Some(byte) = mask.get_mut(index) {
            *byte = (coverage * 255.0 + 0.5) as u8;
        }
    });
    blend(outline, mask, frame);
}

#[inline(never)]
fn rasterize(rasterizer: &mut Rasterizer, outline: &Outline) {
    let Bounds { left, top, right, bottom } = outline.bounds;
    rasterizer.reset(left.abs_diff(right) as usize, top.abs_diff(bottom) as usize);
    let (left, top) = (left as f32, top as f32);
    for contour in outline.points {
        let Some(&[x, y]) = contour.last() else { continue };
        let mut start = point(x - left, y - top);
        for &[x, y] in *contour {
            let end = point(x - left, y - top);
            rasterizer.draw_line(start, end);
            start = end;
        }
    }
}

/// The mask's pixels that are covered, over what the frame shows.
fn blend(outline: &Outline, mask: &[u8], frame: &mut Frame) {
    let Bounds { left, top, right, .. } = outline.bounds;
    for (row, alphas) in (top..outline.bounds.bottom).zip(mask.chunks_exact(left.abs_diff(right) as usize)) {
        let Some(pixels) = frame.row_from(Point::new(left, row)) else { continue };
        for (pixel, &alpha) in pixels.iter_mut().zip(alphas) {
            match alpha {
                0 => {}
                255 => *pixel = outline.colour,
                _ => *pixel = outline.colour.over(*pixel, alpha),
            }
        }
    }
}

type Row = (&'static str, i32, Cost);

fn print_table(host: &mut HostStream, rows: &[Row]) -> fmt::Result {
    writeln!(host, "| anti-aliased, instructions | spanfill | ab_glyph_rasterizer | spanfill / ab_glyph_rasterizer |")?;
    writeln!(host, "|---|--:|--:|--:|")?;
    for (name, _, Cost { spanfill, ab_glyph }) in rows {
        let title = match *name {
            "ring-12" => "a ring of 2 x 12 vertices in 12 px",
            "ring-24" => "a ring of 2 x 24 vertices in 24 px",
            "ring-48" => "a ring of 2 x 48 vertices in 48 px",
            "icons" => "twenty-four icons of 24 px",
            "gauge" => "a gauge of 220 px",
            _ => "a line of text of 12 px",
        };
        let hundredths = (u64::from(*spanfill) * 100 + u64::from(ab_glyph / 2)) / u64::from((*ab_glyph).max(1));
        writeln!(host, "| {title} | {spanfill} | {ab_glyph} | {}.{:02} |", hundredths / 100, hundredths % 100)?;
    }
    Ok(())
}

/// After an empty line, with the columns that `cycles` has.
fn print_csv(host: &mut HostStream, rows: &[Row]) -> fmt::Result {
    writeln!(host, "\nscene,variant,target,px,instructions")?;
    for (name, px, Cost { spanfill, ab_glyph }) in rows {
        writeln!(host, "{name},spanfill-aa,cortex-m4f,{px},{spanfill}")?;
        writeln!(host, "{name},ab-glyph-blended,cortex-m4f,{px},{ab_glyph}")?;
    }
    Ok(())
}
