//! How each library draws a whole drawing, one opaque shape over the other.
//!
//! Everybody is given what it takes, prepared: vertices, paths, commands, and scratch that is large enough. What is
//! measured is from there to pixels, or, of zeno and for comparison of spanfill, to masks that are yet to be blended.

use std::{convert::Infallible, hint::black_box, ops::Range};

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888},
    prelude::*,
};
use spanfill::{
    ActiveEdge, AntiAlias, Cover, CoverageEdge, CoverageSink, Fill, FillRule, InPlace, PixelRect, Polygon, Span, Vertex,
};
use tiny_skia::{Paint, Path, PathBuilder, Pixmap, Shader, Transform};
use vello_cpu::{Level, RenderContext, RenderSettings, Resources, color::AlphaColor, kurbo::BezPath, peniko};
use zeno::Command;

use crate::{
    drawings::{Drawing, Shape},
    lineup::{pixmap, renderer_at},
    picture::{Bounds, Coverage, Mask, Picture},
    scenes::{FRAME_HEIGHT, FRAME_WIDTH, Frame},
    variant::Variant,
};

pub(crate) trait Painter {
    /// The whole drawing. This is what is measured.
    fn paint(&mut self);

    /// What the picture shows, if it is one.
    fn pixels(&self) -> Option<Vec<[u8; 3]>>;

    /// Draws one shape by itself, and tells how much of each pixel it covers, if the picture has the bits to tell.
    fn coverage(&mut self, shape: usize, coverage: &mut Coverage) -> bool;
}

/// `None` for what draws no real drawings.
pub(crate) fn painter(drawing: &Drawing, variant: Variant) -> Option<Box<dyn Painter>> {
    Some(match variant {
        Variant::AntiAliased => Box::new(AntiAliased::new(drawing)),
        Variant::Mask => Box::new(Masks::new(drawing)),
        Variant::Aliased => Box::new(Aliased::new(drawing)),
        Variant::Vello => Box::new(Vello::new(drawing, RenderSettings::default().level)),
        Variant::VelloBaseline => Box::new(Vello::new(drawing, Level::baseline())),
        Variant::TinySkiaAntiAliased => Box::new(TinySkia::new(drawing, true)),
        Variant::TinySkia => Box::new(TinySkia::new(drawing, false)),
        Variant::Zeno => Box::new(Zeno::new(drawing)),
        _ => return None,
    })
}

/// A shape as spanfill takes it.
struct Outline {
    polygon: Polygon<'static>,
    colour: Rgb565,
}

fn outlines(drawing: &Drawing) -> Vec<Outline> {
    drawing.shapes.iter().map(outline).collect()
}

fn outline(shape: &Shape) -> Outline {
    // Kept until the program ends, as constants are.
    let contours: Vec<&'static [Vertex]> = shape
        .contours
        .iter()
        .map(|contour| &*contour.iter().map(|&[x, y]| Vertex::from_bits(x, y)).collect::<Vec<_>>().leak())
        .collect();
    let [r, g, b] = shape.rgb;
    let rule = if shape.even_odd { FillRule::EvenOdd } else { FillRule::NonZero };
    Outline { polygon: Polygon::with_contours(contours.leak()).fill_rule(rule), colour: Rgb888::new(r, g, b).into() }
}

fn frame_pixels(frame: &Frame) -> Vec<[u8; 3]> {
    let rgb = |pixel: &Rgb565| {
        let pixel = Rgb888::from(*pixel);
        [pixel.r(), pixel.g(), pixel.b()]
    };
    frame.rows().as_flattened().iter().map(rgb).collect()
}

/// The caller's: enough for any of the drawing's outlines.
struct Scratch {
    edges: Vec<CoverageEdge>,
}

impl Scratch {
    fn new(outlines: &[Outline]) -> Self {
        let edges = outlines.iter().map(|outline| outline.polygon.coverage_edges_at_most()).max().unwrap_or(0);
        Self { edges: vec![CoverageEdge::EMPTY; edges] }
    }

    fn cover(&mut self, outline: &Outline) -> impl Cover {
        outline.polygon.coverage_in(&mut self.edges).expect("there is enough for each outline")
    }
}

/// Blended over what the frame shows, in its memory.
struct AntiAliased {
    outlines: Vec<Outline>,
    scratch: Scratch,
    frame: Box<Frame>,
}

impl AntiAliased {
    fn new(drawing: &Drawing) -> Self {
        let outlines = outlines(drawing);
        Self { scratch: Scratch::new(&outlines), outlines, frame: Box::new(Frame::new()) }
    }
}

impl Painter for AntiAliased {
    fn paint(&mut self) {
        for outline in &self.outlines {
            let outline = black_box(outline);
            let Ok(()) = self.scratch.cover(outline).antialiased(outline.colour, InPlace).draw_on(&mut *self.frame);
        }
        black_box(&self.frame);
    }

    fn pixels(&self) -> Option<Vec<[u8; 3]>> {
        Some(frame_pixels(&self.frame))
    }

    /// Five bits are not enough: [`Masks`] has the same coverage.
    fn coverage(&mut self, _: usize, _: &mut Coverage) -> bool {
        false
    }
}

/// The coverage alone.
struct Masks {
    outlines: Vec<Outline>,
    scratch: Scratch,
    mask: Mask,
}

impl Masks {
    fn new(drawing: &Drawing) -> Self {
        let outlines = outlines(drawing);
        Self { scratch: Scratch::new(&outlines), outlines, mask: Mask::new() }
    }

    /// Whether there is anything of it on the frame.
    #[inline]
    fn draw(&mut self, shape: usize) -> bool {
        let cover = self.scratch.cover(black_box(&self.outlines[shape]));
        let touched = cover.touched();
        let Some(bounds) = on_frame([touched.columns.start, touched.rows.start, touched.columns.end, touched.rows.end])
        else {
            return false;
        };
        let clip = PixelRect {
            rows: bounds.top..bounds.top + bounds.height,
            columns: bounds.left..bounds.left + bounds.width,
        };
        let Ok(()) = cover.coverage(&clip, &mut MaskSink { bytes: self.mask.start(bounds), bounds });
        black_box(&self.mask);
        true
    }
}

impl Painter for Masks {
    fn paint(&mut self) {
        for shape in 0..self.outlines.len() {
            self.draw(shape);
        }
    }

    fn pixels(&self) -> Option<Vec<[u8; 3]>> {
        None
    }

    fn coverage(&mut self, shape: usize, coverage: &mut Coverage) -> bool {
        if self.draw(shape) {
            self.mask.read(coverage);
        } else {
            coverage.fill(0);
        }
        true
    }
}

struct MaskSink<'a> {
    bytes: &'a mut [u8],
    bounds: Bounds,
}

impl MaskSink<'_> {
    fn pixels(&mut self, row: i32, column: i32, count: usize) -> &mut [u8] {
        let start = (row - self.bounds.top) * self.bounds.width + (column - self.bounds.left);
        &mut self.bytes[start as usize..][..count]
    }
}

impl CoverageSink for MaskSink<'_> {
    type Error = Infallible;

    fn span(&mut self, Span { row, columns }: Span, coverage: u8) -> Result<(), Infallible> {
        self.pixels(row, columns.start, columns.len()).fill(coverage);
        Ok(())
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Infallible> {
        self.pixels(row, column, coverage.len()).copy_from_slice(coverage);
        Ok(())
    }
}

/// What of left, top, right and bottom lies on the frame.
fn on_frame([left, top, right, bottom]: [i32; 4]) -> Option<Bounds> {
    let (left, top) = (left.max(0), top.max(0));
    let (width, height) = (right.min(FRAME_WIDTH) - left, bottom.min(FRAME_HEIGHT) - top);
    (width > 0 && height > 0).then_some(Bounds { left, top, width, height })
}

/// Without anti-aliasing.
struct Aliased {
    outlines: Vec<Outline>,
    edges: Vec<ActiveEdge>,
    frame: Box<Frame>,
}

impl Aliased {
    fn new(drawing: &Drawing) -> Self {
        let outlines = outlines(drawing);
        let edges = outlines.iter().map(|outline| outline.polygon.active_edges_at_most()).max().unwrap_or(0);
        Self { edges: vec![ActiveEdge::EMPTY; edges], outlines, frame: Box::new(Frame::new()) }
    }
}

impl Aliased {
    #[inline]
    fn draw(&mut self, shape: usize, colour: Rgb565) {
        let outline = black_box(&self.outlines[shape]);
        let polygon = outline.polygon.in_scratch(&mut self.edges).expect("there is enough for each outline");
        let Ok(()) = polygon.filled(colour).draw(&mut *self.frame);
    }
}

impl Painter for Aliased {
    fn paint(&mut self) {
        for shape in 0..self.outlines.len() {
            self.draw(shape, self.outlines[shape].colour);
        }
        black_box(&self.frame);
    }

    fn pixels(&self) -> Option<Vec<[u8; 3]>> {
        Some(frame_pixels(&self.frame))
    }

    fn coverage(&mut self, shape: usize, coverage: &mut Coverage) -> bool {
        self.frame.clear();
        self.draw(shape, Rgb565::WHITE);
        self.frame.read(coverage);
        true
    }
}

fn position([x, y]: [i32; 2]) -> (f64, f64) {
    (f64::from(x) / 256.0, f64::from(y) / 256.0)
}

fn position_f32(vertex: [i32; 2]) -> (f32, f32) {
    let (x, y) = position(vertex);
    (x as f32, y as f32)
}

/// By its quick pipeline, without threads, the whole drawing in one scene.
struct Vello {
    paths: Vec<(BezPath, peniko::Fill, AlphaColor<vello_cpu::color::Srgb>)>,
    context: RenderContext,
    resources: Resources,
    picture: vello_cpu::Pixmap,
}

impl Vello {
    fn new(drawing: &Drawing, level: Level) -> Self {
        let path = |shape: &Shape| {
            let mut path = BezPath::new();
            for contour in &shape.contours {
                let Some((&first, rest)) = contour.split_first() else { continue };
                path.move_to(position(first));
                rest.iter().for_each(|&vertex| path.line_to(position(vertex)));
                path.close_path();
            }
            let rule = if shape.even_odd { peniko::Fill::EvenOdd } else { peniko::Fill::NonZero };
            let [r, g, b] = shape.rgb;
            (path, rule, AlphaColor::from_rgb8(r, g, b))
        };
        Self {
            paths: drawing.shapes.iter().map(path).collect(),
            context: renderer_at(level),
            resources: Resources::new(),
            picture: vello_cpu::Pixmap::new(FRAME_WIDTH as u16, FRAME_HEIGHT as u16),
        }
    }
}

impl Vello {
    fn draw(&mut self, shapes: Range<usize>) {
        self.context.reset();
        for (path, rule, colour) in black_box(&self.paths[shapes]) {
            self.context.set_paint(*colour);
            self.context.set_fill_rule(*rule);
            self.context.fill_path(path);
        }
        self.context.flush();
        self.context.render(&mut self.picture, &mut self.resources);
        black_box(&self.picture);
    }
}

impl Painter for Vello {
    fn paint(&mut self) {
        self.draw(0..self.paths.len());
    }

    fn pixels(&self) -> Option<Vec<[u8; 3]>> {
        Some(self.picture.data().iter().map(|pixel| [pixel.r, pixel.g, pixel.b]).collect())
    }

    fn coverage(&mut self, shape: usize, coverage: &mut Coverage) -> bool {
        self.draw(shape..shape + 1);
        self.picture.read(coverage);
        true
    }
}

struct TinySkia {
    /// `None` for what it takes for nothing.
    paths: Vec<Option<(Path, tiny_skia::FillRule, Paint<'static>)>>,
    picture: Pixmap,
}

impl TinySkia {
    fn new(drawing: &Drawing, anti_alias: bool) -> Self {
        let path = |shape: &Shape| {
            let mut path = PathBuilder::new();
            for contour in &shape.contours {
                let Some((&first, rest)) = contour.split_first() else { continue };
                let (x, y) = position_f32(first);
                path.move_to(x, y);
                for &vertex in rest {
                    let (x, y) = position_f32(vertex);
                    path.line_to(x, y);
                }
                path.close();
            }
            let rule = if shape.even_odd { tiny_skia::FillRule::EvenOdd } else { tiny_skia::FillRule::Winding };
            let [r, g, b] = shape.rgb;
            let shader = Shader::SolidColor(tiny_skia::Color::from_rgba8(r, g, b, 255));
            Some((path.finish()?, rule, Paint { shader, anti_alias, ..Paint::default() }))
        };
        Self { paths: drawing.shapes.iter().map(path).collect(), picture: pixmap() }
    }
}

impl TinySkia {
    fn draw(&mut self, shapes: Range<usize>) {
        for (path, rule, paint) in black_box(&self.paths[shapes]).iter().flatten() {
            self.picture.fill_path(path, paint, *rule, Transform::identity(), None);
        }
        black_box(&self.picture);
    }
}

impl Painter for TinySkia {
    fn paint(&mut self) {
        self.draw(0..self.paths.len());
    }

    fn pixels(&self) -> Option<Vec<[u8; 3]>> {
        Some(self.picture.pixels().iter().map(|pixel| [pixel.red(), pixel.green(), pixel.blue()]).collect())
    }

    fn coverage(&mut self, shape: usize, coverage: &mut Coverage) -> bool {
        self.picture.clear();
        self.draw(shape..shape + 1);
        self.picture.read(coverage);
        true
    }
}

/// Into a mask of each shape's bounds, which it is told.
struct Zeno {
    /// `None` for what lies beyond the frame.
    paths: Vec<Option<(Vec<Command>, zeno::Fill, Bounds)>>,
    scratch: zeno::Scratch,
    mask: Mask,
}

impl Zeno {
    fn new(drawing: &Drawing) -> Self {
        let path = |shape: &Shape| {
            let mut commands = Vec::new();
            for contour in &shape.contours {
                let Some((&first, rest)) = contour.split_first() else { continue };
                commands.push(Command::MoveTo(position_f32(first).into()));
                commands.extend(rest.iter().map(|&vertex| Command::LineTo(position_f32(vertex).into())));
                commands.push(Command::Close);
            }
            let rule = if shape.even_odd { zeno::Fill::EvenOdd } else { zeno::Fill::NonZero };
            Some((commands, rule, bounds(shape)?))
        };
        let paths = drawing.shapes.iter().map(path).collect();
        Self { paths, scratch: zeno::Scratch::new(), mask: Mask::new() }
    }
}

fn bounds(shape: &Shape) -> Option<Bounds> {
    let vertices = || shape.contours.iter().flatten();
    let least = |axis: usize| vertices().map(|vertex| vertex[axis]).min();
    let most = |axis: usize| vertices().map(|vertex| vertex[axis]).max();
    on_frame([least(0)? >> 8, least(1)? >> 8, (most(0)? + 255) >> 8, (most(1)? + 255) >> 8])
}

impl Zeno {
    #[inline]
    fn draw(&mut self, shape: usize) -> bool {
        let Some((commands, rule, bounds)) = black_box(&self.paths[shape]) else { return false };
        zeno::Mask::with_scratch(commands.as_slice(), &mut self.scratch)
            .style(*rule)
            .size(bounds.width.unsigned_abs(), bounds.height.unsigned_abs())
            .offset((-bounds.left as f32, -bounds.top as f32))
            .render_into(self.mask.start(*bounds), None);
        black_box(&self.mask);
        true
    }
}

impl Painter for Zeno {
    fn paint(&mut self) {
        for shape in 0..self.paths.len() {
            self.draw(shape);
        }
    }

    fn pixels(&self) -> Option<Vec<[u8; 3]>> {
        None
    }

    fn coverage(&mut self, shape: usize, coverage: &mut Coverage) -> bool {
        if self.draw(shape) {
            self.mask.read(coverage);
        } else {
            coverage.fill(0);
        }
        true
    }
}
