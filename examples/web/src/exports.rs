//! What the page calls. Whatever is handed over is a number, or lies in the memory that the page can read.

#![allow(unsafe_code, reason = "a name that JavaScript can call is an `unsafe` attribute; no name here is another's")]

use std::cell::RefCell;

use crate::{
    catalogue::{self, choice},
    drawing::Choice,
    page::Page,
    subject::Subject,
};

/// What a program in the browser keeps between calls.
#[derive(Default)]
struct State {
    page: Page,
    points: Vec<[i32; 2]>,
    text: String,
    numbers: [f64; 9],
}

thread_local! {
    static STATE: RefCell<State> = RefCell::default();
}

fn with<R>(run: impl FnOnce(&mut State) -> R) -> R {
    STATE.with_borrow_mut(run)
}

fn asked(state: &State, kind: usize, place: [usize; 3]) -> Option<(Subject, Choice)> {
    let [family, method, option] = place;
    Some((Subject::new(kind, &state.points)?, choice(family, method, option)?))
}

/// Where the canvas' bytes are.
#[unsafe(no_mangle)]
extern "C" fn canvas() -> *const u8 {
    with(|state| state.page.canvas().bytes().as_ptr())
}

/// Where the verdicts are, a byte a pixel.
#[unsafe(no_mangle)]
extern "C" fn verdicts() -> *const u8 {
    with(|state| state.page.verdicts().as_ptr())
}

/// Where the outline is, as of the last drawing.
#[unsafe(no_mangle)]
extern "C" fn outline() -> *const i32 {
    with(|state| state.page.outline().as_ptr())
}

/// Where the report's nine numbers are.
#[unsafe(no_mangle)]
extern "C" fn report() -> *const f64 {
    with(|state| {
        state.numbers = state.page.report().numbers();
        state.numbers.as_ptr()
    })
}

/// Where what the page offers is, as JSON.
#[unsafe(no_mangle)]
extern "C" fn catalogue() -> *const u8 {
    with(|state| {
        state.text = catalogue::json();
        state.text.as_ptr()
    })
}

#[unsafe(no_mangle)]
extern "C" fn catalogue_length() -> usize {
    with(|state| state.text.len())
}

#[unsafe(no_mangle)]
extern "C" fn draw_dashboard(value: i32, by_embedded_graphics: u32) {
    with(|state| state.page.draw_dashboard(value, by_embedded_graphics != 0));
}

/// Forgets the vertices that have been moved.
#[unsafe(no_mangle)]
extern "C" fn clear_points() {
    with(|state| state.points.clear());
}

/// The next vertex, in 1/256 pixel.
#[unsafe(no_mangle)]
extern "C" fn push_point(x: i32, y: i32) {
    with(|state| state.points.push([x, y]));
}

/// 1 if it has been drawn, 0 if the method is not one for such a subject.
#[unsafe(no_mangle)]
extern "C" fn draw(kind: usize, family: usize, method: usize, option: usize) -> u32 {
    with(|state| match asked(state, kind, [family, method, option]) {
        Some((subject, choice)) => state.page.draw(&subject, &choice).into(),
        None => 0,
    })
}

/// The same, some times over and for the clock.
#[unsafe(no_mangle)]
extern "C" fn time(kind: usize, family: usize, method: usize, option: usize, times: u32) -> u32 {
    with(|state| match asked(state, kind, [family, method, option]) {
        Some((subject, choice)) => state.page.time(&subject, &choice, times).into(),
        None => 0,
    })
}
