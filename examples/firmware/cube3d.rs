//! What a frame of `examples/cube3d/scene.rs` costs a Cortex-M4, in instructions: `examples/firmware/run.sh cube3d`.

#![no_std]
#![no_main]

mod instruction_counter;
#[path = "../cube3d/scene.rs"]
mod scene;
#[path = "../../benches/scenes/mod.rs"]
mod scenes;

use core::fmt::Write as _;

use cortex_m_semihosting::{debug, hio};
use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use panic_semihosting as _;
use spanfill::DepthBuffer;

use instruction_counter::InstructionCounter;
use scenes::{FRAME_HEIGHT, FRAME_WIDTH, Frame};

const PIXELS: usize = (FRAME_WIDTH * FRAME_HEIGHT) as usize;

#[cortex_m_rt::entry]
fn main() -> ! {
    let core = cortex_m::Peripherals::take().expect("nobody else takes the peripherals");
    let mut counter = InstructionCounter::new(core.SYST);
    let frame = cortex_m::singleton!(: Frame = Frame::new()).expect("taken once");
    let memory = cortex_m::singleton!(: [u16; PIXELS] = [0; PIXELS]).expect("taken once");
    let area = Rectangle::new(Point::zero(), Size::new(FRAME_WIDTH as u32, FRAME_HEIGHT as u32));
    let mut depths = DepthBuffer::new(area, FRAME_WIDTH as usize, memory).expect("it is large enough");
    let mut host = hio::hstdout().expect("the host takes text");
    let (mut all, mut most, mut triangles) = (0_u64, 0, 0);
    for index in 0..scene::FRAMES {
        let Ok(()) = frame.clear(Rgb565::BLACK);
        let instructions = counter.count(&[index], |index| triangles += scene::draw(frame, &mut depths, *index));
        all += u64::from(instructions);
        most = most.max(instructions);
    }
    let frames = scene::FRAMES;
    writeln!(
        host,
        "| frames | triangles a frame | instructions a frame | at most |\n|--:|--:|--:|--:|\n| {frames} | {} | {} | {most} |",
        triangles / frames,
        all / u64::from(frames),
    )
    .expect("the host takes text");
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the host has ended this program");
}
