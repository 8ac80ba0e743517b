//! vello_cpu, single-threaded, by its fast pipeline, on an RGBA picture.
//!
//! It records shapes, and renders what is recorded into every pixel of a picture, used or not. That costs as much as
//! many small shapes, so it is drawn with in two ways: at its best, with hundreds of shapes recorded before they are
//! rendered; and as a program uses it that draws a shape here and one there, each of them rendered by itself, by a
//! context no larger than the shape, over what the picture shows.

use std::{fmt, hint::black_box, ops::Range};

use vello_cpu::{
    Level, Pixmap, RasterizerSettings, RenderContext, RenderSettings, Resources, TargetInit,
    color::palette::css,
    kurbo::{Affine, BezPath, Circle},
};

use crate::{
    drawing::Drawing,
    lineup::outline::{Outline, OutlineVisitor, Pen, Position, with_outlines},
    picture::{Bounds, Picture},
    scenes::{FRAME_HEIGHT, FRAME_WIDTH, Scene},
};

/// By the best instructions that the processor has, found at run time.
pub(super) fn drawing(scene: Scene) -> Box<dyn Drawing> {
    drawing_at(scene, best_level())
}

/// By those that every processor of the target has.
pub(super) fn drawing_at_baseline(scene: Scene) -> Box<dyn Drawing> {
    drawing_at(scene, Level::baseline())
}

fn best_level() -> Level {
    RenderSettings::default().level
}

fn drawing_at(scene: Scene, level: Level) -> Box<dyn Drawing> {
    // So many that rendering the rest of the picture is a few hundredths of the time, and no more, as each batch is
    // timed in one turn.
    let batch = match scene {
        Scene::Triangles(size_px) | Scene::Circles(size_px) | Scene::Concave64(size_px) if size_px <= 10 => 500,
        Scene::Triangles(..=50) | Scene::Circles(..=20) | Scene::Lines(..=50) | Scene::Concave64(..=20) => 200,
        Scene::Triangles(_) | Scene::Lines(_) => 100,
        Scene::Circles(_) | Scene::Stars(_) | Scene::Concave64(_) => 32,
    };
    with_outlines(scene, Batches { batch, level })
}

struct Batches {
    batch: usize,
    level: Level,
}

impl OutlineVisitor for Batches {
    type Output = Box<dyn Drawing>;

    fn visit<O: Outline>(self, outlines: Vec<O>) -> Box<dyn Drawing> {
        Box::new(InBatches { renderer: Renderer::new(self.level), outlines, batch: self.batch })
    }
}

pub(super) fn drawing_alone(scene: Scene) -> Box<dyn Drawing> {
    with_outlines(scene, Alone)
}

struct Alone;

impl OutlineVisitor for Alone {
    type Output = Box<dyn Drawing>;

    fn visit<O: Outline>(self, outlines: Vec<O>) -> Box<dyn Drawing> {
        Box::new(OneByOne { renderer: Renderer::new(best_level()), outlines })
    }
}

/// What is kept from one picture to the next.
#[derive(Debug)]
struct Renderer {
    context: RenderContext,
    resources: Resources,
    picture: Pixmap,
    path: BezPath,
}

const WIDTH: u16 = FRAME_WIDTH as u16;
const HEIGHT: u16 = FRAME_HEIGHT as u16;

/// For pictures of the frame's size; no threads.
pub(crate) fn renderer_at(level: Level) -> RenderContext {
    RenderContext::new_with(WIDTH, HEIGHT, RenderSettings { level, num_threads: 0 })
}

impl Renderer {
    fn new(level: Level) -> Self {
        Self {
            context: renderer_at(level),
            resources: Resources::new(),
            picture: Pixmap::new(WIDTH, HEIGHT),
            path: BezPath::new(),
        }
    }

    fn record(&mut self, outline: &impl Outline) {
        self.path.truncate(0);
        outline.trace(&mut PathPen(&mut self.path));
        self.context.fill_path(&self.path);
    }

    /// Onto a picture that is new.
    fn draw(&mut self, outlines: &[impl Outline]) {
        self.context.reset();
        self.context.set_paint(css::ORANGE);
        for outline in outlines {
            self.record(black_box(outline));
        }
        self.context.flush();
        self.context.render(&mut self.picture, &mut self.resources);
    }

    /// Over what the picture shows.
    fn draw_alone(&mut self, outline: &impl Outline) {
        let Bounds { left, top, width, height } = outline.bounds();
        self.context.reset_and_resize(width as u16, height as u16);
        self.context.set_transform(Affine::translate((-f64::from(left), -f64::from(top))));
        self.context.set_paint(css::ORANGE);
        self.record(outline);
        self.context.flush();
        let settings = RasterizerSettings {
            target_init: TargetInit::SrcOver,
            offset: (left as u16, top as u16),
            ..Default::default()
        };
        self.context.render_with(&mut self.picture, &mut self.resources, settings);
    }
}

struct InBatches<O> {
    renderer: Renderer,
    outlines: Vec<O>,
    batch: usize,
}

impl<O: Outline> Drawing for InBatches<O> {
    fn shapes(&self) -> usize {
        self.outlines.len()
    }

    fn batch(&self) -> usize {
        self.batch
    }

    fn draw(&mut self, shapes: Range<usize>) {
        for outlines in self.outlines[shapes].chunks(self.batch) {
            self.renderer.draw(outlines);
        }
        black_box(&self.renderer.picture);
    }

    fn draw_alone(&mut self, shape: usize) -> &dyn Picture {
        self.renderer.draw(&self.outlines[shape..=shape]);
        &self.renderer.picture
    }
}

impl<O> fmt::Debug for InBatches<O> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("InBatches").field("outlines", &self.outlines.len()).finish_non_exhaustive()
    }
}

struct OneByOne<O> {
    renderer: Renderer,
    outlines: Vec<O>,
}

impl<O: Outline> Drawing for OneByOne<O> {
    fn shapes(&self) -> usize {
        self.outlines.len()
    }

    fn draw(&mut self, shapes: Range<usize>) {
        for outline in &self.outlines[shapes] {
            self.renderer.draw_alone(black_box(outline));
        }
        black_box(&self.renderer.picture);
    }

    fn draw_alone(&mut self, shape: usize) -> &dyn Picture {
        self.renderer.picture.clear();
        self.renderer.draw_alone(&self.outlines[shape]);
        &self.renderer.picture
    }
}

impl<O> fmt::Debug for OneByOne<O> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("OneByOne").field("outlines", &self.outlines.len()).finish_non_exhaustive()
    }
}

struct PathPen<'a>(&'a mut BezPath);

impl Pen for PathPen<'_> {
    fn polygon(&mut self, vertices: &[Position]) {
        let Some((first, rest)) = vertices.split_first() else { return };
        self.0.move_to(*first);
        rest.iter().for_each(|&vertex| self.0.line_to(vertex));
        self.0.close_path();
    }

    fn circle(&mut self, centre: Position, radius: f64) {
        // As exact as vello_cpu's examples ask for: four curves.
        use vello_cpu::kurbo::Shape;
        self.0.extend(Circle::new(centre, radius).path_elements(0.1));
    }
}
