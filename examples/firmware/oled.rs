//! The scene of `examples/scene` on a board: a Cortex-M3 (LM3S6965) with a 128 x 64 OLED of 16 greys.
//!
//! `examples/firmware/run.sh oled OUT.png` builds it, runs it in QEMU and saves what the panel shows. `tests/oled.rs`
//! compares that with what the host draws.

#![no_std]
#![no_main]

mod lm3s6965;
#[path = "../scene/mod.rs"]
mod scene;
mod ssd0323;

use cortex_m_semihosting::hprintln;
use panic_semihosting as _;

use lm3s6965::PanelPort;
use ssd0323::Ssd0323;

#[cortex_m_rt::entry]
fn main() -> ! {
    let core = cortex_m::Peripherals::take().expect("nobody else takes the peripherals");
    let mut panel = Ssd0323::new(PanelPort::new(core));
    scene::draw(&mut panel).expect("the scene sizes its own scratch, and the panel takes everything");
    panel.flush();

    // Whoever photographs the panel waits for this line.
    hprintln!("oled: the scene is on the panel");
    loop {
        cortex_m::asm::wfi();
    }
}
