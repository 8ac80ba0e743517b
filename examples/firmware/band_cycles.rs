//! What scenes cost a Cortex-M4 in bands, in instructions, beside the same at once. A program of its own: what is inlined depends
//! on how often a program draws.
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
use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use panic_semihosting as _;
use spanfill::{
    AntiAlias, Bands, Bounded, Circle, Cover, Fill, Framebuffer, InPlace, Line, MsbFirst, Rows, Shape, Triangle,
    Vertex, buffer_size,
};

use instruction_counter::InstructionCounter;
use scenes::{PixelPoint, Scene, circles, lines, triangles};

const SHAPES: usize = 256;

/// Of two different bytes.
const COLOUR: Rgb565 = Rgb565::CSS_ORANGE;

type Packed = Framebuffer<Rgb565, Rows<MsbFirst>, [u8; buffer_size::<Rgb565, Rows<MsbFirst>>(320, 240)]>;

static mut PACKED: Packed = Packed::blank::<320, 240>();

struct Bench {
    counter: InstructionCounter,
    packed: &'static mut Packed,
}

#[cortex_m_rt::entry]
fn main() -> ! {
    let core = cortex_m::Peripherals::take().expect("nobody else takes the peripherals");
    let counter = InstructionCounter::new(core.SYST);
    #[allow(unsafe_code, reason = "the one use of the static")]
    let packed = unsafe { &mut *(&raw mut PACKED) };
    let mut host = hio::hstdout().expect("the host takes text");
    in_bands(&mut host, &mut Bench { counter, packed });
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the host has ended this program");
}

type Band<'b> = spanfill::Band<'b, Rgb565, Rows<MsbFirst>>;

/// The shapes at once, and in 30 bands of 8 rows.
fn in_bands(host: &mut HostStream, bench: &mut Bench) {
    writeln!(
        host,
        "\n| 256 shapes | filled at once | in 30 bands | times | with bounds kept | times | blended at once | in 30 bands | times |\n\
         |---|--:|--:|--:|--:|--:|--:|--:|--:|"
    )
    .expect("text");
    let pixel = |[x, y]: PixelPoint| Point::new(x, y);
    for px in [10, 50] {
        let shapes =
            take::<_, SHAPES>(triangles(px).map(|corners| corners.map(pixel)).map(|[a, b, c]| Triangle::new(a, b, c)));
        split(host, bench, Scene::Triangles(px), &shapes);
    }
    for px in [5, 20] {
        let shapes = take::<_, SHAPES>(circles(px).map(|[x, y]| Circle::new(Vertex::new(x, y), px)));
        split(host, bench, Scene::Circles(px), &shapes);
    }
    for px in [10, 50] {
        let shapes = take::<_, SHAPES>(lines(px).map(|ends| ends.map(pixel)).map(|[a, b]| Line::new(a, b)));
        split(host, bench, Scene::Lines(px), &shapes);
    }
}

fn split<S: Shape + Cover + Copy>(host: &mut HostStream, bench: &mut Bench, scene: Scene, shapes: &[S; SHAPES]) {
    let Bench { counter, packed, .. } = bench;
    let filled = counter.count(&[()], |()| {
        for shape in shapes {
            let Ok(()) = shape.filled(COLOUR).draw_on(*packed);
        }
    });
    let blended = counter.count(&[()], |()| {
        for shape in shapes {
            let Ok(()) = shape.antialiased(COLOUR, InPlace).draw_on(*packed);
        }
    });
    let kept = shapes.map(|shape| Bounded::new(shape.filled(COLOUR)));
    let mut count = |draw: &dyn Fn(&mut Band<'_>)| {
        let mut buffer = [0; buffer_size::<Rgb565, Rows<MsbFirst>>(320, 8)];
        let mut bands =
            Bands::<Rgb565, Rows<MsbFirst>, _, 1>::new([&mut buffer[..]], Size::new(320, 240), Rgb565::BLACK)
                .expect("a line at least");
        let mut count = |draw: &dyn Fn(&mut Band<'_>)| {
            counter.count(&[()], |()| {
                let drawn = bands.draw(
                    |band| {
                        draw(band);
                        Ok::<(), core::convert::Infallible>(())
                    },
                    |_| Ok::<(), core::convert::Infallible>(()),
                );
                drawn.expect("nothing fails");
            })
        };
        // What the bands cost without a scene is the frame's, and not that of the shapes.
        let nothing = count(&|_| ());
        count(draw) - nothing
    };
    let split = count(&|band| {
        for shape in shapes {
            let Ok(()) = shape.filled(COLOUR).draw_on(band);
        }
    });
    let split_kept = count(&|band| {
        for shape in &kept {
            let Ok(()) = shape.draw_on(band);
        }
    });
    let split_blended = count(&|band| {
        for shape in shapes {
            let Ok(()) = shape.antialiased(COLOUR, InPlace).draw_on(band);
        }
    });
    let times = |a: u32, b: u32| (a / b, a % b * 100 / b);
    let (all, some, mixed) = (times(split, filled), times(split_kept, filled), times(split_blended, blended));
    writeln!(
        host,
        "| {}, {} {} px | {filled} | {split} | {}.{:02} | {split_kept} | {}.{:02} | {blended} | {split_blended} | {}.{:02} |",
        scene.name(),
        scene.size_name(),
        scene.size_px(),
        all.0,
        all.1,
        some.0,
        some.1,
        mixed.0,
        mixed.1,
    )
    .expect("text");
}

fn take<T, const N: usize>(mut shapes: impl Iterator<Item = T>) -> [T; N] {
    core::array::from_fn(|_| shapes.next().expect("the scenes are endless"))
}
