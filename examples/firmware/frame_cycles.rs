//! What the crate's framebuffers cost a Cortex-M4, in instructions: clears, and shapes that are filled where they are walked,
//! beside embedded-graphics' primitives on the same framebuffer and on its own.
//!
//! Run as `cycles` is: `examples/firmware/run.sh frame`.

#![no_std]
#![no_main]

mod instruction_counter;
#[path = "../../benches/scenes/mod.rs"]
mod scenes;

use core::fmt::Write as _;

use cortex_m_semihosting::{
    debug,
    hio::{self, HostStream},
};
use embedded_graphics::{
    framebuffer::{Framebuffer as EgFramebuffer, buffer_size as eg_buffer_size},
    pixelcolor::{
        BinaryColor, Rgb565,
        raw::{BigEndian, RawU16},
    },
    prelude::*,
    primitives::{self as eg, PrimitiveStyle},
};
use panic_semihosting as _;
use spanfill::{
    AntiAlias, Circle, Cover, Fill, Framebuffer, InPlace, Line, LsbFirst, MsbFirst, Pages, ReadBack, Rows, Shape,
    Triangle, Values, Vertex, buffer_size,
};

use instruction_counter::InstructionCounter;
use scenes::{PixelPoint, Scene, circles, lines, triangles};

const SHAPES: usize = 256;

/// Of two different bytes, and drawn one by one it takes longer.
const COLOUR: Rgb565 = Rgb565::CSS_ORANGE;

const SIZE: usize = 320 * 240;

type Packed = Framebuffer<Rgb565, Rows<MsbFirst>, [u8; buffer_size::<Rgb565, Rows<MsbFirst>>(320, 240)]>;
type InValues = Framebuffer<Rgb565, Values, [Rgb565; SIZE]>;
type OfEg = EgFramebuffer<Rgb565, RawU16, BigEndian, 320, 240, { eg_buffer_size::<Rgb565>(320, 240) }>;
type Bits = Framebuffer<BinaryColor, Rows<MsbFirst>, [u8; SIZE / 8]>;
type BitPages = Framebuffer<BinaryColor, Pages<LsbFirst>, [u8; SIZE / 8]>;

static mut PACKED: Packed = Packed::blank::<320, 240>();
static mut VALUES: InValues = InValues::filled::<320, 240>(Rgb565::BLACK);
static mut BITS: Bits = Bits::blank::<320, 240>();
static mut BIT_PAGES: BitPages = BitPages::blank::<320, 240>();

#[cortex_m_rt::entry]
fn main() -> ! {
    let core = cortex_m::Peripherals::take().expect("nobody else takes the peripherals");
    let mut counter = InstructionCounter::new(core.SYST);
    #[allow(unsafe_code, reason = "the one use of each static")]
    let (packed, values, bits, pages) = unsafe {
        (&mut *(&raw mut PACKED), &mut *(&raw mut VALUES), &mut *(&raw mut BITS), &mut *(&raw mut BIT_PAGES))
    };
    let of_eg = cortex_m::singleton!(: OfEg = OfEg::new()).expect("taken once");
    let mut host = hio::hstdout().expect("the host takes text");
    let host = &mut host;

    writeln!(host, "| cleared, 320 x 240 | instructions | a pixel |\n|---|--:|--:|").expect("text");
    clear(host, "embedded-graphics, RGB565", &mut counter, of_eg, COLOUR);
    clear(host, "RGB565 in bytes", &mut counter, packed, COLOUR);
    clear(host, "RGB565 as values", &mut counter, values, COLOUR);
    clear(host, "1 bit in rows", &mut counter, bits, BinaryColor::On);
    clear(host, "1 bit in pages", &mut counter, pages, BinaryColor::On);

    writeln!(
        host,
        "\n| shape on RGB565 in bytes | embedded-graphics | its own framebuffer | `draw` | `draw_on` | \
         embedded-graphics / `draw_on` | values, `draw_on` | walk alone | anti-aliased, `ReadBack` | `InPlace` | values, `InPlace` |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
    )
    .expect("text");
    let mut bench = Bench { counter, packed, values, of_eg };
    let filled = PrimitiveStyle::with_fill(COLOUR);
    let pixel = |[x, y]: PixelPoint| Point::new(x, y);
    for px in [10, 50, 200] {
        let theirs = triangles(px).map(|vertices| vertices.map(pixel));
        let theirs = theirs.map(|[a, b, c]| eg::Triangle::new(a, b, c).into_styled(filled));
        let ours = triangles(px).map(|vertices| vertices.map(pixel)).map(|[a, b, c]| Triangle::new(a, b, c));
        bench.compare(host, Scene::Triangles(px), theirs, ours);
    }
    for px in [5, 20, 100] {
        let theirs = circles(px)
            .map(|[x, y]| eg::Circle::new(Point::new(x - px, y - px), 2 * px.unsigned_abs()).into_styled(filled));
        let ours = circles(px).map(|[x, y]| Circle::new(Vertex::new(x, y), px));
        bench.compare(host, Scene::Circles(px), theirs, ours);
    }
    let thin = PrimitiveStyle::with_stroke(COLOUR, 1);
    for px in [50, 200] {
        let theirs = lines(px).map(|ends| ends.map(pixel)).map(|[a, b]| eg::Line::new(a, b).into_styled(thin));
        let ours = lines(px).map(|ends| ends.map(pixel)).map(|[a, b]| Line::new(a, b));
        bench.compare(host, Scene::Lines(px), theirs, ours);
    }
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the host has ended this program");
}

fn clear<D: DrawTarget>(
    host: &mut HostStream,
    name: &str,
    counter: &mut InstructionCounter,
    target: &mut D,
    colour: D::Color,
) {
    let instructions = counter.count(&[colour; 8], |colour| {
        assert!(target.clear(*colour).is_ok());
    }) / 8;
    let thousandths = u64::from(instructions) * 1000 / SIZE as u64;
    writeln!(host, "| {name} | {instructions} | {}.{:03} |", thousandths / 1000, thousandths % 1000).expect("text");
}

struct Bench {
    counter: InstructionCounter,
    packed: &'static mut Packed,
    values: &'static mut InValues,
    of_eg: &'static mut OfEg,
}

impl Bench {
    fn compare<S: Copy + Shape + Cover>(
        &mut self,
        host: &mut HostStream,
        scene: Scene,
        theirs: impl Iterator<Item = impl Drawable<Color = Rgb565>>,
        ours: impl Iterator<Item = S>,
    ) {
        let theirs: [_; SHAPES] = take(theirs);
        let ours: [S; SHAPES] = take(ours);
        let Self { counter, packed, values, of_eg } = self;
        let mut of_eg_there = counter.count(&theirs, |shape| {
            let Ok(_) = shape.draw(*of_eg);
        });
        let mut of_eg_here = counter.count(&theirs, |shape| {
            let Ok(_) = shape.draw(*packed);
        });
        let mut drawn = counter.count(&ours, |shape| {
            let Ok(()) = shape.filled(COLOUR).draw(*packed);
        });
        let mut drawn_on = counter.count(&ours, |shape| {
            let Ok(()) = shape.filled(COLOUR).draw_on(*packed);
        });
        let mut on_values = counter.count(&ours, |shape| {
            let Ok(()) = shape.filled(COLOUR).draw_on(*values);
        });
        for count in [&mut of_eg_there, &mut of_eg_here, &mut drawn, &mut drawn_on, &mut on_values] {
            *count /= SHAPES as u32;
        }
        let clip = spanfill::PixelRect { rows: 0..240, columns: 0..320 };
        let mut nothing = Nothing(0);
        let walked = counter.count(&ours, |shape| {
            let Ok(()) = shape.blocks(&clip, &mut nothing);
        }) / SHAPES as u32;
        core::hint::black_box(nothing.0);
        let few = &ours[..64];
        let read_back = counter.count(few, |shape| {
            let Ok(()) = shape.antialiased(COLOUR, ReadBack).draw_on(*packed);
        }) / 64;
        let in_place = counter.count(few, |shape| {
            let Ok(()) = shape.antialiased(COLOUR, InPlace).draw_on(*packed);
        }) / 64;
        let in_values = counter.count(few, |shape| {
            let Ok(()) = shape.antialiased(COLOUR, InPlace).draw_on(*values);
        }) / 64;
        let hundredths = of_eg_here * 100 / drawn_on;
        writeln!(
            host,
            "| {}, {} {} px | {of_eg_here} | {of_eg_there} | {drawn} | {drawn_on} | {}.{:02} | {on_values} | {walked} | {read_back} | \
             {in_place} | {in_values} |",
            scene.name(),
            scene.size_name(),
            scene.size_px(),
            hundredths / 100,
            hundredths % 100,
        )
        .expect("text");
    }
}

/// Takes blocks and fills nothing: the walk's own cost.
struct Nothing(i32);

impl spanfill::BlockSink for Nothing {
    type Error = core::convert::Infallible;

    #[inline(always)]
    fn block(&mut self, rows: core::ops::Range<i32>, columns: core::ops::Range<i32>) -> Result<(), Self::Error> {
        self.0 = self.0.wrapping_add(rows.end ^ rows.start ^ columns.end ^ columns.start);
        Ok(())
    }
}

fn take<T, const N: usize>(mut shapes: impl Iterator<Item = T>) -> [T; N] {
    core::array::from_fn(|_| shapes.next().expect("the scenes are endless"))
}
