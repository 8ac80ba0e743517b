//! embedded-graphics' own primitives, drawn by this crate: change `PrimitiveStyle` to [`Style`], and nothing else.
//!
//! A program that draws like this:
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::Triangle};
//! use embedded_graphics::primitives::PrimitiveStyle;
//!
//! # let mut display = MockDisplay::new();
//! # display.set_allow_overdraw(true);
//! let style = PrimitiveStyle::with_fill(Rgb565::RED);
//! Triangle::new(Point::new(2, 1), Point::new(60, 20), Point::new(20, 55)).into_styled(style).draw(&mut display)?;
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! draws like this with the Cargo feature `embedded-graphics`:
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::Triangle};
//! use spanfill::{Over, eg::Style};
//!
//! # let mut display = MockDisplay::new();
//! let style = Style::with_fill(Rgb565::RED);
//! Triangle::new(Point::new(2, 1), Point::new(60, 20), Point::new(20, 55)).into_styled(style).draw(&mut display)?;
//!
//! // The same with anti-aliased edges, over a black background.
//! # let mut display = MockDisplay::new();
//! let style = style.antialiased(Over(Rgb565::BLACK));
//! Triangle::new(Point::new(2, 1), Point::new(60, 20), Point::new(20, 55)).into_styled(style).draw(&mut display)?;
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! `PrimitiveStyleBuilder` becomes [`StyleBuilder`], and a `PrimitiveStyle` that is there already goes
//! [`into`](Style::from) a [`Style`]. Targets that can be read are blended over what they show by [`DrawOn`].
//!
//! # Which pixels
//!
//! Rectangles, circles, ellipses and rounded rectangles cover whole pixels from their `top_left`; the points of lines,
//! polylines and triangles are centres of pixels. Without anti-aliasing, the pixels are embedded-graphics' own:
//!
//! | | filled | stroke of 1 pixel | wider stroke |
//! |---|---|---|---|
//! | `Rectangle`, `Circle`, `Ellipse`, `RoundedRectangle`, `Arc`, `Sector` | the same | the same | the same |
//! | `Line`, `Polyline` | | the same | the true outline |
//! | `Triangle` | the true outline | the same | the true outline |
//!
//! ```text
//!     embedded-graphics          true outline: the centres inside it
//!     # # . . . . .              . . . . . . .
//!     # # # # . . .              # # . . . . .       a filled triangle from pixel to pixel: embedded-graphics
//!     # # # # # # .              # # # # . . .       adds the lines around it, and two triangles that share an
//!     # # # # # # #              . . . . . . .       edge overlap there
//! ```
//!
//! - A filled triangle is [`Triangle`](crate::Triangle): triangles that share an edge share no pixel.
//! - A stroke lies around the centres of the pixels that it runs through; where its width is even and it is not
//!   blended, half a pixel farther to the left of its direction, or outside, which is where embedded-graphics puts the
//!   odd pixel. Blended, it lies evenly about them, whichever way it is drawn. `Inside` and `Outside` keep those
//!   pixels and go on inside or outside of them. Corners have mitres up to twice the width and are cut off beyond.
//!   Ends reach as far as their pixels do: the line from (0, 0) to (9, 0) covers ten columns.
//! - embedded-graphics takes the sine and cosine of arcs and sectors from the standard library where that is linked,
//!   and from micromath elsewhere; here it is always micromath, in 1/1024. An end is within 0.2 degrees of its angle.
//!   Blended ends are where their angle says ([`Angle`](crate::Angle)), and sectors without a stroke that follow each
//!   other add up to the circle. A filled sector of no angle is nothing; embedded-graphics draws a diameter.
//! - Some things that embedded-graphics leaves out are drawn: ellipses without a pixel on their first row, the stroke
//!   of rounded rectangles on rows with nothing to fill, and whatever overflows its 32 bits.
//!
//! Without anti-aliasing some pixels are drawn more than once, in the end in the right colour: where lines of a thin
//! stroke run into each other, where a triangle is filled below its thin stroke, and at the joints of thick polylines.
//! `MockDisplay` has to be told to allow it.
//!
//! Anti-aliased primitives have the same outlines. Circles and whole turns of arcs are the exact ones; the polygons
//! that stand for other curves are off by at most a part of the radius: 1/15000 where an ellipse, rounded rectangle or
//! sector is filled, 1/4000 where it has a stroke, 1/8000 for an arc of 270 degrees (1/80 pixel at a radius of 100).
//! Stroke and fill are blended together: each pixel is drawn once, in the mixture of both. Where the segments of a
//! polyline overlap, they are covered once; of more than 24 segments and joints within 64 x 4 pixels, some may be
//! covered twice.
//!
//! # Limits
//!
//! Strokes count as 65535 pixels wide where they are wider. Primitives that reach farther than 2^22 pixels from the
//! origin are drawn without anti-aliasing and opaque, and lines and triangles end at 2^23 pixels. Nothing panics, and
//! what is off the target costs next to nothing.
//!
//! # Errors
//!
//! The target's, at once.
//!
//! # Cost
//!
//! Without anti-aliasing, spans and blocks as everywhere in this crate: no floating point but for the angles of arcs
//! and sectors, and no scratch. Anti-aliased ellipses, rounded rectangles, arcs and sectors make a polygon on the
//! stack, and stroke and fill are collected in tiles of 64 x 4 pixels. The stack that takes on a Cortex-M4, all in all:
//! 1.4 KiB for lines, 1.8 for circles, 3.3 for triangles, 4.1 for arcs, 4.9 for ellipses, 5.3 for sectors, 5.6 for rounded
//! rectangles and 9.4 for polylines; 1 KiB for a sector that is not anti-aliased.

mod boxes;
mod builder;
mod curve;
mod ellipse;
mod layers;
mod line;
mod outline;
mod paint;
mod pie;
mod pixel_box;
mod rectangle;
mod rounded_rectangle;
mod rows;
mod sector;
mod stroked;
mod style;
mod styled;
mod thin;
mod triangle;
mod wedge;

pub use builder::StyleBuilder;
pub use style::{Aliased, Blended, Style};
pub use styled::DrawOn;
