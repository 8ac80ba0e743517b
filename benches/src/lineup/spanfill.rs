//! spanfill, and the floor under it: the rectangles that it sends, sent again.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use spanfill::{ActiveEdge, Circle, Fill, Line, Polygon, Triangle, Vertex};

use crate::{
    drawing::{Drawing, On},
    lineup::{COLOUR, point, some},
    scenes::{
        Frame, PixelPoint, RecordBlocks, Scene, SubpixelPoint, circles, concave_polygons, lines, stars, triangles,
    },
};

pub(super) fn drawing(scene: Scene) -> Box<dyn Drawing> {
    with_figures(scene, Draw)
}

pub(super) fn floor(scene: Scene) -> Box<dyn Drawing> {
    with_figures(scene, Replay)
}

/// Coordinates that a target of any type can be asked to draw.
trait Figure: 'static {
    fn draw<D: DrawTarget<Color = Rgb565>>(&self, scratch: &mut Scratch, target: &mut D) -> Result<(), D::Error>;
}

/// The caller's, kept from one drawing to the next: two edges for each turn from up to down are enough for any outline
/// here, so that none is looked over twice.
type Scratch = [ActiveEdge; 64];

struct TriangleFigure([PixelPoint; 3]);

impl Figure for TriangleFigure {
    #[inline]
    fn draw<D: DrawTarget<Color = Rgb565>>(&self, _: &mut Scratch, target: &mut D) -> Result<(), D::Error> {
        let [a, b, c] = self.0.map(point);
        Triangle::new(a, b, c).filled(COLOUR).draw(target)
    }
}

struct CircleFigure {
    centre: PixelPoint,
    radius_px: i32,
}

impl Figure for CircleFigure {
    #[inline]
    fn draw<D: DrawTarget<Color = Rgb565>>(&self, _: &mut Scratch, target: &mut D) -> Result<(), D::Error> {
        let [x, y] = self.centre;
        Circle::new(Vertex::new(x, y), self.radius_px).filled(COLOUR).draw(target)
    }
}

struct LineFigure([PixelPoint; 2]);

impl Figure for LineFigure {
    #[inline]
    fn draw<D: DrawTarget<Color = Rgb565>>(&self, _: &mut Scratch, target: &mut D) -> Result<(), D::Error> {
        let [start, end] = self.0.map(point);
        Line::new(start, end).filled(COLOUR).draw(target)
    }
}

struct OutlineFigure<const N: usize>([SubpixelPoint; N]);

impl<const N: usize> Figure for OutlineFigure<N> {
    #[inline]
    fn draw<D: DrawTarget<Color = Rgb565>>(&self, scratch: &mut Scratch, target: &mut D) -> Result<(), D::Error> {
        let outline = self.0.map(|[x, y]| Vertex::from_bits(x, y));
        let polygon = Polygon::new(&outline).in_scratch(scratch).expect("there is enough for any outline here");
        polygon.filled(COLOUR).draw(target)
    }
}

/// What to do with a scene's figures, whatever their type.
trait FigureVisitor {
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

struct Draw;

impl FigureVisitor for Draw {
    fn visit<F: Figure>(self, figures: Vec<F>) -> Box<dyn Drawing> {
        let mut scratch = [ActiveEdge::EMPTY; 64];
        On::boxed(Box::new(Frame::new()), figures, move |figure: &F, frame: &mut Box<Frame>| {
            let Ok(()) = figure.draw(&mut scratch, &mut **frame);
        })
    }
}

struct Replay;

impl FigureVisitor for Replay {
    fn visit<F: Figure>(self, figures: Vec<F>) -> Box<dyn Drawing> {
        let blocks: Vec<Blocks> = figures.iter().map(Blocks::of).collect();
        On::boxed(Box::new(Frame::new()), blocks, |blocks: &Blocks, frame: &mut Box<Frame>| {
            for block in &blocks.0 {
                let Ok(()) = frame.fill_solid(block, COLOUR);
            }
        })
    }
}

/// The rectangles that spanfill sends for a figure.
struct Blocks(Box<[Rectangle]>);

impl Blocks {
    fn of(figure: &impl Figure) -> Self {
        let mut room = vec![Rectangle::zero(); 10_000];
        let mut recorder = RecordBlocks::new(&mut room);
        figure.draw(&mut [ActiveEdge::EMPTY; 64], &mut recorder).expect("no figure has so many rectangles");
        Self(recorder.into_blocks().into())
    }
}
