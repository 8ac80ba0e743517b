//! spanfill with anti-aliasing: blended into the frame in two ways, into a mask, and the floor under the blending.

use std::{convert::Infallible, ops::Range};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*};
use spanfill::{
    AntiAlias, Circle, Cover, CoverageEdge, CoverageSink, InPlace, Line, Mix, Over, PixelRect, Polygon, SampleCell,
    SampleEdge, Span, Triangle, Vertex,
};

use crate::{
    drawing::{Drawing, On},
    lineup::{COLOUR, point, some},
    picture::{Bounds, Coverage, Mask, no_coverage},
    scenes::{
        FRAME_HEIGHT, FRAME_WIDTH, Frame, PixelPoint, Scene, SubpixelPoint, circles, concave_polygons, lines, stars,
        triangles,
    },
};

/// What the frame is cleared to.
const BACKGROUND: Rgb565 = Rgb565::BLACK;

/// Blended over what the frame shows.
pub(super) fn drawing(scene: Scene) -> Box<dyn Drawing> {
    with_figures(scene, OverFrame)
}

/// Blended over a background that is known.
pub(super) fn drawing_over(scene: Scene) -> Box<dyn Drawing> {
    with_figures(scene, OverBackground)
}

/// The coverage alone.
pub(super) fn mask(scene: Scene) -> Box<dyn Drawing> {
    with_figures(scene, IntoMask)
}

/// The coverage, recorded, and blended over what the frame shows.
pub(super) fn blend_floor(scene: Scene) -> Box<dyn Drawing> {
    with_figures(scene, Replay)
}

/// Coordinates, and the coverage that they become.
pub(super) trait Figure: 'static {
    fn cover<V: CoverVisitor>(&self, scratch: &mut Scratch, visitor: V);
}

/// What to do with a coverage, whatever its type.
pub(super) trait CoverVisitor {
    fn visit(self, cover: impl Cover);
}

/// The caller's, kept from one drawing to the next: enough for any outline here, in one pass over all the columns.
pub(super) struct Scratch {
    edges: [CoverageEdge; 64],
    pub(super) sample_edges: [SampleEdge; 64],
    pub(super) sample_cells: [SampleCell; FRAME_WIDTH as usize],
}

impl Scratch {
    const fn new() -> Self {
        Self {
            edges: [CoverageEdge::EMPTY; 64],
            sample_edges: [SampleEdge::EMPTY; 64],
            sample_cells: [SampleCell::EMPTY; FRAME_WIDTH as usize],
        }
    }
}

pub(super) struct TriangleFigure(pub(super) [PixelPoint; 3]);

impl Figure for TriangleFigure {
    #[inline]
    fn cover<V: CoverVisitor>(&self, _: &mut Scratch, visitor: V) {
        let [a, b, c] = self.0.map(point);
        visitor.visit(Triangle::new(a, b, c));
    }
}

pub(super) struct CircleFigure {
    pub(super) centre: PixelPoint,
    pub(super) radius_px: i32,
}

impl Figure for CircleFigure {
    #[inline]
    fn cover<V: CoverVisitor>(&self, _: &mut Scratch, visitor: V) {
        let [x, y] = self.centre;
        visitor.visit(Circle::new(Vertex::new(x, y), self.radius_px));
    }
}

struct LineFigure([PixelPoint; 2]);

impl Figure for LineFigure {
    #[inline]
    fn cover<V: CoverVisitor>(&self, _: &mut Scratch, visitor: V) {
        let [start, end] = self.0.map(point);
        visitor.visit(Line::new(start, end));
    }
}

pub(super) struct OutlineFigure<const N: usize>(pub(super) [SubpixelPoint; N]);

impl<const N: usize> Figure for OutlineFigure<N> {
    #[inline]
    fn cover<V: CoverVisitor>(&self, scratch: &mut Scratch, visitor: V) {
        let outline = self.0.map(|[x, y]| Vertex::from_bits(x, y));
        let polygon = Polygon::new(&outline).coverage_in(&mut scratch.edges);
        visitor.visit(polygon.expect("there is enough for any outline here"));
    }
}

/// What to do with a scene's figures, whatever their type.
pub(super) trait FigureVisitor {
    fn visit<F: Figure>(self, figures: Vec<F>) -> Box<dyn Drawing>;
}

fn with_figures(scene: Scene, visitor: impl FigureVisitor) -> Box<dyn Drawing> {
    match scene {
        Scene::Triangles(box_px) => visitor.visit(some(scene, triangles(box_px).map(TriangleFigure))),
        Scene::Circles(radius_px) => {
            visitor.visit(some(scene, circles(radius_px).map(|centre| CircleFigure { centre, radius_px })))
        }
        Scene::Lines(box_px) => visitor.visit(some(scene, lines(box_px).map(LineFigure))),
        Scene::Stars(radius_px) => visitor.visit(some(scene, stars(radius_px).map(OutlineFigure))),
        Scene::Concave64(radius_px) => visitor.visit(some(scene, concave_polygons(radius_px).map(OutlineFigure))),
    }
}

pub(super) struct OverFrame;

impl FigureVisitor for OverFrame {
    fn visit<F: Figure>(self, figures: Vec<F>) -> Box<dyn Drawing> {
        struct Blend<'a>(&'a mut Frame);

        impl CoverVisitor for Blend<'_> {
            #[inline]
            fn visit(self, cover: impl Cover) {
                let Ok(()) = cover.antialiased(COLOUR, InPlace).draw_on(self.0);
            }
        }

        let mut scratch = Box::new(Scratch::new());
        On::boxed(Box::new(Frame::new()), figures, move |figure: &F, frame: &mut Box<Frame>| {
            figure.cover(&mut scratch, Blend(frame));
        })
    }
}

struct OverBackground;

impl FigureVisitor for OverBackground {
    fn visit<F: Figure>(self, figures: Vec<F>) -> Box<dyn Drawing> {
        struct Blend<'a>(&'a mut Frame);

        impl CoverVisitor for Blend<'_> {
            #[inline]
            fn visit(self, cover: impl Cover) {
                let Ok(()) = cover.antialiased(COLOUR, Over(BACKGROUND)).draw_on(self.0);
            }
        }

        let mut scratch = Box::new(Scratch::new());
        On::boxed(Box::new(Frame::new()), figures, move |figure: &F, frame: &mut Box<Frame>| {
            figure.cover(&mut scratch, Blend(frame));
        })
    }
}

pub(super) struct IntoMask;

impl FigureVisitor for IntoMask {
    fn visit<F: Figure>(self, figures: Vec<F>) -> Box<dyn Drawing> {
        struct Write<'a>(&'a mut Mask);

        impl CoverVisitor for Write<'_> {
            #[inline]
            fn visit(self, cover: impl Cover) {
                let touched = cover.touched();
                let (left, right) = (touched.columns.start.max(0), touched.columns.end.min(FRAME_WIDTH));
                let (top, bottom) = (touched.rows.start.max(0), touched.rows.end.min(FRAME_HEIGHT));
                // A mask has at least a pixel.
                let bounds = Bounds { left, top, width: (right - left).max(1), height: (bottom - top).max(1) };
                let clip = PixelRect { rows: top..bottom.max(top), columns: left..right.max(left) };
                let Ok(()) = cover.coverage(&clip, &mut MaskSink { bytes: self.0.start(bounds), bounds });
            }
        }

        let mut scratch = Box::new(Scratch::new());
        On::boxed(Mask::new(), figures, move |figure: &F, mask: &mut Mask| figure.cover(&mut scratch, Write(mask)))
    }
}

struct MaskSink<'a> {
    bytes: &'a mut [u8],
    bounds: Bounds,
}

impl MaskSink<'_> {
    #[inline]
    fn pixels(&mut self, row: i32, column: i32, count: usize) -> &mut [u8] {
        let start = (row - self.bounds.top) * self.bounds.width + (column - self.bounds.left);
        &mut self.bytes[start as usize..][..count]
    }
}

impl CoverageSink for MaskSink<'_> {
    type Error = Infallible;

    #[inline]
    fn span(&mut self, Span { row, columns }: Span, coverage: u8) -> Result<(), Infallible> {
        self.pixels(row, columns.start, columns.len()).fill(coverage);
        Ok(())
    }

    #[inline]
    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Infallible> {
        self.pixels(row, column, coverage.len()).copy_from_slice(coverage);
        Ok(())
    }
}

struct Replay;

impl FigureVisitor for Replay {
    fn visit<F: Figure>(self, figures: Vec<F>) -> Box<dyn Drawing> {
        let mut scratch = Box::new(Scratch::new());
        let recorded = figures.iter().map(|figure| {
            let mut recording = Recording::default();
            figure.cover(&mut scratch, &mut recording);
            recording
        });
        On::boxed(Box::new(Frame::new()), recorded.collect(), |recording: &Recording, frame: &mut Box<Frame>| {
            let Ok(()) = Replayed(recording).antialiased(COLOUR, InPlace).draw_on(&mut **frame);
        })
    }
}

/// The spans and runs of a figure, in order.
#[derive(Debug, Default)]
struct Recording {
    pieces: Vec<Piece>,
    /// Of all runs.
    bytes: Vec<u8>,
}

#[derive(Debug)]
enum Piece {
    Span(Span, u8),
    Run { row: i32, column: i32, bytes: Range<usize> },
}

impl CoverVisitor for &mut Recording {
    fn visit(self, cover: impl Cover) {
        let clip = PixelRect { rows: 0..FRAME_HEIGHT, columns: 0..FRAME_WIDTH };
        let Ok(()) = cover.coverage(&clip, self);
    }
}

impl CoverageSink for Recording {
    type Error = Infallible;

    fn span(&mut self, span: Span, coverage: u8) -> Result<(), Infallible> {
        self.pieces.push(Piece::Span(span, coverage));
        Ok(())
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Infallible> {
        let start = self.bytes.len();
        self.bytes.extend_from_slice(coverage);
        self.pieces.push(Piece::Run { row, column, bytes: start..self.bytes.len() });
        Ok(())
    }
}

struct Replayed<'a>(&'a Recording);

impl Cover for Replayed<'_> {
    fn touched(&self) -> PixelRect {
        PixelRect { rows: 0..FRAME_HEIGHT, columns: 0..FRAME_WIDTH }
    }

    #[inline]
    fn coverage<S: CoverageSink>(&self, _: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        let Self(Recording { pieces, bytes: all }) = self;
        pieces.iter().try_for_each(|piece| match piece {
            Piece::Span(span, coverage) => sink.span(span.clone(), *coverage),
            Piece::Run { row, column, bytes } => sink.run(*row, *column, &all[bytes.clone()]),
        })
    }
}

/// Whether the drawings of a scene on a frame show its mask, in the colour, over the background: the pixel that is the
/// first not to be so.
pub(super) fn disagreement(mask: &mut dyn Drawing, frames: &mut dyn Drawing, shapes: usize) -> Option<(usize, Point)> {
    let mut coverage: Box<Coverage> = no_coverage();
    (0..shapes.min(mask.shapes())).find_map(|shape| {
        mask.draw_alone(shape).read(&mut coverage);
        let frame = frames.draw_alone(shape).frame().expect("it was asked for a drawing on frames");
        let pixels = frame.rows().as_flattened().iter().zip(coverage.iter());
        let wrong = pixels.enumerate().find(|(_, (shown, coverage))| **shown != COLOUR.over(BACKGROUND, **coverage));
        let (index, _) = wrong?;
        Some((shape, Point::new(index as i32 % FRAME_WIDTH, index as i32 / FRAME_WIDTH)))
    })
}
