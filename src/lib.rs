//! Exact fixed-point fill of triangles, lines, circles and polygons on any embedded-graphics
//! [`DrawTarget`](embedded_graphics_core::draw_target::DrawTarget), with or without anti-aliasing: `no_std`, without
//! allocation, without `unsafe`.
//!
//! The pixels of a shape are those whose centres it covers, exactly, for vertices in 1/256 pixel and for every
//! coordinate there is. They are the same on every machine, in every clip, whatever the order of the vertices.
//!
//! ```text
//! Shape -clip-> Edge -one step a row-> Span, or a block of equal rows -> colour -> DrawTarget::fill_solid
//! Cover -clip-> chains of edges -a row of pixels-> Span, run of coverage -> Blend -> fill_solid, fill_contiguous
//!
//! limits · subpixel · geometry, fragment · contours · angle · turn · outline · path, stroke · edge · span, error
//! · coverage · area · shape, target · primitive, collected · scratch · blend · draw · seed_fill · attribute · paint, splat
//! · framebuffer · band, damage · eg · methods
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
//! and a circle may be off by 1/255 before it is rounded.
//!
//! What that makes of a colour is up to the [`Blend`]:
//!
//! | target | [`Blend`] |
//! |---|---|
//! | cannot be read, background known | [`Over`] |
//! | can be read | [`ReadBack`] |
//! | in memory | [`InPlace`]: the same pixels in less time |
//! | few colours | [`Dither`] |
//! | any of the first three, mixed as light adds up | [`Linear`] around it |
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
//! # Polygons, paths and strokes
//!
//! A [`Polygon`] works in scratch. One [`Scratch`] serves all of them, one after the other, and can be a `static`; constants
//! tell how large it has to be. A [`Path`], a [`Stroke`] or any other [`Outline`] is drawn [`within`](Within::within) it,
//! too, or anti-aliased without memory for its vertices ([`CoverOutline`]).
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4, prelude::*};
//! use spanfill::{Over, Polygon, Scratch, Vertex, prelude::*};
//!
//! const ARROW: Polygon =
//!     Polygon::new(&[Vertex::pixel(0, 0), Vertex::pixel(5, 2), Vertex::pixel(0, 4), Vertex::pixel(2, 2)]);
//!
//! let mut scratch = Scratch::<{ ARROW.coverage_edges() }>::new();
//! let mut display = MockDisplay::new();
//! ARROW.within(&mut scratch)?.antialiased(Gray4::WHITE, Over(Gray4::BLACK)).draw(&mut display)?;
//! display.assert_pattern(&["12    ", " 7B50 ", "  BFC2", " 7B50 ", "12    "]);
//! # Ok::<(), Box<dyn core::error::Error>>(())
//! ```
//!
//! # What varies
//!
//! [`Painting::painted`] gives a shape a [`Paint`]: a gradient, a pattern, or your own; [`Masked`] lets only so much of a
//! shape through as another paint says. [`Attributes`] interpolate across
//! triangles: [`Gouraud`] colours, [`Affine`] and [`Perspective`] values, depth ([`DepthTested`]), a [`Texture`]. A
//! [`Mosaic`] draws neighbours without a seam, and [`splat`] points in place of triangles.
//!
//! # Memory
//!
//! A [`Framebuffer`] holds a screen as the display takes it, [`Bands`] a few of its rows, and [`Damage`] what has
//! changed. `draw_on` fills their memory where a shape is walked. What is [`Bounded`] costs a comparison on a band that it is
//! not on.
//!
//! # Features
//!
//! - `embedded-graphics`: `spanfill::eg::Style` takes the place of `PrimitiveStyle` on embedded-graphics' own
//!   primitives.
//! - `methods`: `spanfill::methods`, the methods of the literature, to be drawn, timed and compared.
//!
//! # Off the screen
//!
//! Nothing off the screen is ever sent, or costs more than finding out that it is. Shapes have no errors but too little
//! scratch for a polygon, which is found before anything is drawn, and the target's own.

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

mod angle;
mod area;
mod attribute;
mod band;
mod blend;
mod collected;
mod contours;
mod coverage;
mod damage;
mod draw;
mod edge;
#[cfg(feature = "embedded-graphics")]
pub mod eg;
mod error;
mod fragment;
mod framebuffer;
mod geometry;
mod limits;
#[cfg(feature = "methods")]
pub mod methods;
mod outline;
mod paint;
mod path;
mod primitive;
mod scratch;
mod seed_fill;
mod shape;
mod span;
pub mod splat;
mod stroke;
mod subpixel;
mod target;
mod turn;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

#[cfg(test)]
extern crate std;

pub use angle::Angle;
pub use area::CoverageEdge;
pub use attribute::{
    Affine, AttributeRow, AttributeSink, Attributes, Barycentric, Channels, DepthBuffer, DepthBufferError, DepthTest,
    DepthTested, EXACT, EmptyTexture, Filter, Gouraud, NotInFront, PACKED, Perspective, Shaded, Texture, Weights, Wrap,
    average,
};
pub use band::{Band, Bands, FrameError, Parts, Transfer, Transmit};
pub use blend::{Blend, Dither, InPlace, Linear, Mix, MixLinear, Over, ReadBack};
pub use collected::{TooFewVertices, collect};
pub use coverage::{CoverageSink, SampleCell, Samples};
pub use damage::Damage;
pub use draw::{AntiAlias, AntiAliased, Bounded, Fill, Filled};
pub use error::{TooLittleScratch, TooManyEdges};
pub use fixed::types::I24F8;
pub use fragment::{Fragment, FragmentSink};
pub use framebuffer::{
    Framebuffer, FramebufferError, Layout, LsbFirst, MsbFirst, Order, PackedColor, Pages, Rows, Values, buffer_size,
};
pub use geometry::{PixelRect, Vertex};
pub use outline::{
    Curve, CurvePoints, Curves, FinePoint, FineRect, Flattened, Outline, OutlineCount, OutlineSink, Step, StrokeReach,
    Vertices, WindingRule,
};
pub use paint::{
    AreaSink, Areas, BadStops, Cells as MosaicCells, ConicalGradient, EmptyPattern, GouraudPaint, Hatch,
    LinearGradient, Masked, Mosaic, MosaicCell, MosaicError, MosaicScratchTooSmall, Paint, Painted, PaintedAntiAliased,
    Painting, Pattern, RadialGradient, Rounded, Solid, Spread, Stop, Stops, Tile, Tiles,
};
pub use path::{ArcTo, Element, Path, PathError, SvgElements, Transform, Transformed};
pub use primitive::{Arc, ArcLine, CircleOutline, Ellipse, Rectangle, Ring, RoundedRectangle, Sector, TaperedLine};
pub use scratch::{PolygonWithin, Scratch, ScratchSize, ScratchTooSmall, Within, edges_for};
pub use seed_fill::{Connectivity, FillRegion, FillSegment, SeedFill, SeedFillError};
pub use shape::{
    ActiveEdge, Circle, Cover, CoverOutline, FillRule, Line, OutlineCoverageIn, OutlineCoverageWith, Polygon,
    PolygonCoverageIn, PolygonCoverageWith, PolygonEdges, PolygonInScratch, PolygonWithCapacity, SampleEdge, Shape,
    SupersampledIn, Triangle,
};
pub use span::{BlockSink, Span, SpanSink};
pub use stroke::{Align, Cap, Join, Stroke, StrokeStyle};
pub use target::{Canvas, PixelRows, View};
pub use turn::Turn;

/// The traits that a program which draws needs in scope.
pub mod prelude {
    pub use crate::{
        AntiAlias as _, Attributes as _, Cover as _, CoverOutline as _, Fill as _, Painting as _, Shape as _,
        Within as _,
    };
}
