//! How deep the stack goes: it is painted below what is in use, and looked at afterwards.

use core::ptr;

use cortex_m_semihosting::{debug, hprintln};

/// More than anything here uses; there are 4 MB.
const PAINTED_BYTES: usize = 256 * 1024;
const PAINT: u32 = 0xA5A5_5A5A;

/// Says how many bytes of stack some work takes, and ends the program.
#[inline(never)]
pub(super) fn run(work: fn()) -> ! {
    let top = here();
    paint(top);
    work();
    hprintln!("stack {}", top as usize - lowest_used(top));
    debug::exit(debug::EXIT_SUCCESS);
    unreachable!("the host has ended this program");
}

/// Ends the program and says that it failed.
pub(super) fn fail() {
    debug::exit(debug::EXIT_FAILURE);
}

/// The stack pointer, or little above it.
#[inline(always)]
fn here() -> *mut u32 {
    cortex_m::register::msp::read() as *mut u32
}

#[inline(never)]
#[allow(unsafe_code, reason = "nothing else is below the stack pointer, and main memory reaches further than that")]
fn paint(top: *mut u32) {
    // A bit lower, to leave this function's own frame alone.
    for word in MARGIN_WORDS..PAINTED_BYTES / 4 {
        // SAFETY: see above.
        unsafe { ptr::write_volatile(top.wrapping_sub(word), PAINT) };
    }
}

/// Of the functions here.
const MARGIN_WORDS: usize = 16;

#[inline(never)]
#[allow(unsafe_code, reason = "as above")]
fn lowest_used(top: *mut u32) -> usize {
    let mut word = PAINTED_BYTES / 4 - 1;
    // SAFETY: as above.
    while word > MARGIN_WORDS && unsafe { ptr::read_volatile(top.wrapping_sub(word)) } == PAINT {
        word -= 1;
    }
    assert!(word < PAINTED_BYTES / 4 - 1, "more stack than was painted");
    top.wrapping_sub(word) as usize
}
