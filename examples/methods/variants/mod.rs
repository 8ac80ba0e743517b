//! Every method with every option, as a function of a shape and a sink: what the gallery draws, the chart measures, the
//! stability report breaks and the tests pin.
//!
//! Taken in by `#[path]`, hence `no_std` and without allocation: the firmware counts the same functions.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]
#![allow(
    missing_docs,
    missing_debug_implementations,
    unreachable_pub,
    reason = "public to the program that takes it in"
)]

pub mod antialias;
pub mod attribute;
pub mod circle;
pub mod line;
pub mod picture;
pub mod points;
pub mod polygon;
pub mod triangle;

pub use picture::{Frame, HEIGHT, Picture, WIDTH};
use spanfill::PixelRect;

/// The screen that every method draws on.
pub const SCREEN: PixelRect = PixelRect { rows: 0..HEIGHT, columns: 0..WIDTH };

/// Whether a method could draw a shape; where it could not, the sink has been left alone.
pub type Outcome = Result<(), &'static str>;

/// One method with one option, on shapes `S`.
pub struct Variant<S: ?Sized + 'static> {
    /// As in `spanfill::methods::FAMILIES`.
    pub family: &'static str,
    /// As in `spanfill::methods::Method::name`.
    pub method: &'static str,
    /// One of `spanfill::methods::Method::options`.
    pub option: &'static str,
    /// Draws for the tests: how often each pixel comes, and with what.
    pub check: fn(&S, &PixelRect, &mut Picture) -> Outcome,
    /// Draws for the clock.
    pub time: fn(&S, &PixelRect, &mut Frame) -> Outcome,
}

/// A list of [`Variant`]s; each body is compiled for both sinks.
///
/// `variants! { TRIANGLES: [[i32; 2]; 3]; "triangle: inside test", "edge equations", "f32" => |shape, clip, sink| ...; }`
#[macro_export]
macro_rules! variants {
    ($list:ident: $shape:ty; $($family:literal, $method:literal, $option:literal => |$s:ident, $clip:ident, $sink:ident| $body:expr;)*) => {
        pub const $list: &[$crate::variants::Variant<$shape>] = &[$(
            $crate::variants::Variant {
                family: $family,
                method: $method,
                option: $option,
                check: |$s: &$shape, $clip: &spanfill::PixelRect, $sink: &mut $crate::variants::Picture| $body,
                time: |$s: &$shape, $clip: &spanfill::PixelRect, $sink: &mut $crate::variants::Frame| $body,
            },
        )*];
    };
}
