//! Exact fixed-point fill of triangles, lines, circles and polygons on any embedded-graphics
//! [`DrawTarget`](embedded_graphics_core::draw_target::DrawTarget), with or without anti-aliasing: `no_std`, without
//! allocation, without `unsafe`.
//!
//! The pixels of a shape are those whose centres it covers, exactly, for vertices in 1/256 pixel and for every
//! coordinate there is. They are the same on every machine, in every clip, whatever the order of the vertices.
//!
//! ```text
//! Shape -clip-> Edge -one step a row-> Span, or a block of equal rows -> colour -> DrawTarget::fill_solid
//! Cover -clip-> edges and cells -a row of pixels-> Span, run of coverage -> Blend -> fill_solid, fill_contiguous
//!
//! limits · subpixel · geometry, fragment · turn · edge · span, error · coverage · shape, target · blend · draw · seed_fill · eg · methods
//! ```
//!
//! A module uses only what stands to its left. Shapes know no colours and no targets: they push [`Span`]s or blocks
//! into a sink ([`SpanSink`], [`BlockSink`]), cut to a clip, rows downwards, each pixel once. They meet colours and
//! targets in [`Filled`]. Anti-aliased, they push how much of each pixel they cover into a [`CoverageSink`], and meet
//! colours and targets in [`AntiAliased`], by a [`Blend`].
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
//! use spanfill::{Circle, Triangle, prelude::*};
//!
//! let mut display = MockDisplay::new();
//! display.set_allow_overdraw(true);
//! Circle::new(Point::new(4, 4), 4.5).filled(BinaryColor::On).draw(&mut display)?;
//! Triangle::new(Point::new(4, 1), Point::new(7, 6), Point::new(1, 6)).filled(BinaryColor::Off).draw(&mut display)?;
//! display.assert_pattern(&[
//!     "  #####  ",
//!     " ####### ",
//!     "####.####",
//!     "###...###",
//!     "###...###",
//!     "##.....##",
//!     "#########",
//!     " ####### ",
//!     "  #####  ",
//! ]);
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! # The pixel rule
//!
//! (0, 0) is the top-left corner of the top-left pixel, y grows downwards, pixel centres lie at half integers.
//!
//! - A pixel belongs to a filled shape when its centre does. A centre exactly on the outline of a triangle or polygon
//!   belongs to the side that lies to its right, or, on a horizontal edge, below: the top-left rule. Shapes that share
//!   an edge cover each pixel once, without a gap.
//! - A circle covers the centres that are nearer to its own than its radius.
//! - A thin line has one pixel for each step of its longer axis: the one that it crosses the middle of that step in.
//! - `Vertex::from(Point)` is the centre of the pixel that the point names.
//!
//! # Anti-aliasing
//!
//! A pixel's coverage is the exact area of the shape within it, rounded once to 255ths, by the fill rule where contours
//! overlap. Shapes that share an edge share the area of each pixel. A line covers the rectangle of width 1 around it,
//! and a circle may be off by 1/255 before it is rounded. What that makes of a colour is up to the [`Blend`]: [`Over`]
//! a known background, [`ReadBack`] of what a framebuffer shows, [`InPlace`] in its memory, [`Dither`] for few colours, [`Linear`] to mix as light
//! adds up.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
//! use spanfill::{Over, Triangle, Vertex, prelude::*};
//!
//! let mut display = MockDisplay::new();
//! let triangle = Triangle::new(Vertex::new(0, 0), Vertex::new(10, 3), Vertex::new(2, 6));
//! triangle.antialiased(Gray4::WHITE, Over(Gray4::BLACK)).draw(&mut display)?;
//! display.assert_pattern(&[
//!     "A840      ",
//!     "8FFEA51   ",
//!     "3FFFFFFB72",
//!     " DFFFFFE83",
//!     " 8FFFA50  ",
//!     " 3C71     ",
//! ]);
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! # embedded-graphics' own primitives
//!
//! With the feature `embedded-graphics`, `spanfill::eg::Style` takes the place of `PrimitiveStyle`.
//!
//! # Off the screen
//!
//! Nothing off the screen is ever sent, or costs more than finding out that it is; nothing is an error but too little
//! scratch for a polygon, which is found before anything is drawn.

#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
#![deny(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    clippy::unwrap_used
)]

mod blend;
mod coverage;
mod draw;
mod edge;
#[cfg(feature = "embedded-graphics")]
pub mod eg;
mod error;
mod fragment;
mod geometry;
mod limits;
#[cfg(feature = "methods")]
pub mod methods;
mod seed_fill;
mod shape;
mod span;
mod subpixel;
mod target;
mod turn;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(test)]
extern crate std;

pub use blend::{Blend, Dither, InPlace, Linear, Mix, MixLinear, Over, ReadBack};
pub use coverage::{Cell, CoverageSink, SampleCell, Samples};
pub use draw::{AntiAlias, AntiAliased, Fill, Filled};
pub use error::{TooLittleScratch, TooManyEdges};
pub use fixed::types::I24F8;
pub use fragment::{Fragment, FragmentSink};
pub use geometry::{PixelRect, Vertex};
pub use seed_fill::{Connectivity, FillRegion, FillSegment, SeedFill, SeedFillError};
pub use shape::{
    ActiveEdge, ActiveEdges, Circle, Cover, CoverageEdge, FillRule, Line, Polygon, PolygonCoverageIn,
    PolygonCoverageWith, PolygonEdges, PolygonInScratch, PolygonWithCapacity, SampleEdge, Shape, SupersampledIn,
    Triangle,
};
pub use span::{BlockSink, Span, SpanSink};
pub use target::PixelRows;
pub use turn::Turn;

/// The traits that a program which draws needs in scope.
pub mod prelude {
    pub use crate::{AntiAlias as _, Cover as _, Fill as _, Shape as _};
}
