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
    primitives::{self as eg, PrimitiveStyle, Rectangle},
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
         embedded-graphics / `draw_on` | values, `draw_on` | anti-aliased, `ReadBack` | `InPlace` | values, `InPlace` |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|--:|"
    )
    .expect("text");
    let filled = PrimitiveStyle::with_fill(COLOUR);
    let pixel = |[x, y]: PixelPoint| Point::new(x, y);
    for scene in Scene::ALL {
        let mut row = |theirs: &[_], ours: &[_]| {
            shapes(host, scene, &mut counter, (packed, values, of_eg), theirs, ours);
        };
        match scene {
            Scene::Triangles(px) => {
                let theirs = triangles(px).map(|v| v.map(pixel));
                let theirs: [_; SHAPES] =
                    take(theirs.map(|[a, b, c]| Theirs::Triangle(eg::Triangle::new(a, b, c).into_styled(filled))));
                let ours = triangles(px).map(|v| v.map(pixel)).map(|[a, b, c]| Triangle::new(a, b, c));
                let ours: [_; SHAPES] = take(ours);
                shapes(host, scene, &mut counter, (packed, values, of_eg), &theirs, &ours);
            }
            _ => {}
        }
    }
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the host has ended this program");
}
