//! One shape of a scene on the display, anti-aliased or not.

use std::convert::Infallible;

use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{Gray8, Rgb888},
    prelude::*,
    primitives::Rectangle,
};
use embedded_graphics_simulator::SimulatorDisplay;
use spanfill::{
    ActiveEdge, AntiAlias, Circle, Cover, CoverageEdge, CoverageSink, Fill, Line, LinearGradient, Masked, Mix, Paint,
    Painted, PixelRect, Polygon, RadialGradient, ReadBack, SampleCell, SampleEdge, Samples, Shape, Span, SpanSink,
    Stop, Stops, Triangle, Vertex,
};

use super::{
    cli::Aa,
    scene::{Colours, Gradient, Item, Outline, Places},
};

/// A part of the display that can also be read.
pub(crate) struct Window<'d, C> {
    pub(crate) display: &'d mut SimulatorDisplay<C>,
    pub(crate) part: Rectangle,
}

impl<C> Dimensions for Window<'_, C> {
    fn bounding_box(&self) -> Rectangle {
        self.part
    }
}

impl<C: PixelColor> GetPixel for Window<'_, C> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        self.display.bounding_box().contains(point).then(|| self.display.get_pixel(point))
    }
}

/// The crate sends nothing outside of the bounding box.
impl<C: PixelColor> DrawTarget for Window<'_, C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.display.draw_iter(pixels)
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: C) -> Result<(), Infallible> {
        self.display.fill_solid(area, colour)
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colours: I) -> Result<(), Infallible> {
        self.display.fill_contiguous(area, colours)
    }
}

/// Scratch, as much as the shapes so far have needed.
#[derive(Debug, Default)]
pub(crate) struct Scratch {
    edges: Vec<ActiveEdge>,
    coverage_edges: Vec<CoverageEdge>,
    sample_edges: Vec<SampleEdge>,
    sample_cells: Vec<SampleCell>,
}

fn at_least<T: Copy>(scratch: &mut Vec<T>, needed: usize, empty: T) -> &mut [T] {
    if scratch.len() < needed {
        scratch.resize(needed, empty);
    }
    scratch
}

/// Draws the item in the window.
pub(crate) fn paint<C: Mix + From<Rgb888>>(
    item: &Item,
    aa: Aa,
    window: &mut Window<'_, C>,
    scratch: &mut Scratch,
) -> Result<(), Box<dyn std::error::Error>> {
    let columns = window.part.size.width.max(1) as usize;
    let mut brush = Brush { colours: &item.colours, opacity: item.opacity, window };
    let samples = match aa {
        Aa::None => return without_anti_aliasing(item, &mut brush, scratch),
        Aa::Exact => return by_area(item, &mut brush, scratch),
        Aa::Four => Samples::grid(4),
        Aa::Sixteen => Samples::grid(16),
        Aa::Weighted => Samples::WEIGHTED,
    };
    let cells = at_least(&mut scratch.sample_cells, columns, SampleCell::EMPTY);
    match &item.outline {
        Outline::Triangle([a, b, c]) => brush.blend(Triangle::new(*a, *b, *c).supersampled_in(samples, cells)?),
        Outline::Circle { center, radius } => {
            brush.blend(Circle::new(*center, *radius).supersampled_in(samples, cells)?)
        }
        Outline::Line(ends) => {
            let corners = corners_of(*ends);
            let edges = at_least(&mut scratch.sample_edges, 4, SampleEdge::EMPTY);
            brush.blend(Polygon::new(&corners).supersampled_in(samples, edges, cells)?)
        }
        Outline::Polygon { contours, rule } => {
            let contours: Vec<&[Vertex]> = contours.iter().map(Vec::as_slice).collect();
            let polygon = Polygon::with_contours(&contours).fill_rule(*rule);
            let needed = polygon.coverage_edges_at_most();
            let edges = at_least(&mut scratch.sample_edges, needed, SampleEdge::EMPTY);
            brush.blend(polygon.supersampled_in(samples, edges, cells)?)
        }
    }
    Ok(())
}

fn without_anti_aliasing<C: Mix + From<Rgb888>>(
    item: &Item,
    brush: &mut Brush<'_, '_, C>,
    scratch: &mut Scratch,
) -> Result<(), Box<dyn std::error::Error>> {
    match &item.outline {
        Outline::Triangle([a, b, c]) => brush.fill(Triangle::new(*a, *b, *c)),
        Outline::Line([start, end]) => brush.fill(Line::new(*start, *end)),
        Outline::Circle { center, radius } => brush.fill(Circle::new(*center, *radius)),
        Outline::Polygon { contours, rule } => {
            let contours: Vec<&[Vertex]> = contours.iter().map(Vec::as_slice).collect();
            let polygon = Polygon::with_contours(&contours).fill_rule(*rule);
            // Not the exact number, which takes a pass over the vertices for each of their turns.
            let edges = at_least(&mut scratch.edges, polygon.active_edges_at_most(), ActiveEdge::EMPTY);
            brush.fill(polygon.in_scratch(edges)?);
        }
    }
    Ok(())
}

fn by_area<C: Mix + From<Rgb888>>(
    item: &Item,
    brush: &mut Brush<'_, '_, C>,
    scratch: &mut Scratch,
) -> Result<(), Box<dyn std::error::Error>> {
    match &item.outline {
        Outline::Triangle([a, b, c]) => brush.blend(Triangle::new(*a, *b, *c)),
        Outline::Line([start, end]) => brush.blend(Line::new(*start, *end)),
        Outline::Circle { center, radius } => brush.blend(Circle::new(*center, *radius)),
        Outline::Polygon { contours, rule } => {
            let contours: Vec<&[Vertex]> = contours.iter().map(Vec::as_slice).collect();
            let polygon = Polygon::with_contours(&contours).fill_rule(*rule);
            let needed = polygon.coverage_edges_at_most();
            let edges = at_least(&mut scratch.coverage_edges, needed, CoverageEdge::EMPTY);
            brush.blend(polygon.coverage_in(edges)?);
        }
    }
    Ok(())
}

/// A thin line as a polygon: one pixel wide, with square ends that are exactly at the line's.
fn corners_of([start, end]: [Vertex; 2]) -> [Vertex; 4] {
    let point = |vertex: Vertex| kurbo::Point::new(vertex.x.to_num(), vertex.y.to_num());
    let (start, end) = (point(start), point(end));
    let along = end - start;
    let across = if along.hypot() > 0.0 { along.turn_90().normalize() * 0.5 } else { kurbo::Vec2::ZERO };
    [start + across, end + across, end - across, start - across].map(super::flatten::vertex)
}

/// What the shapes of an item have in common.
struct Brush<'w, 'd, C> {
    colours: &'w Colours,
    opacity: u8,
    window: &'w mut Window<'d, C>,
}

impl<C: Mix + From<Rgb888>> Brush<'_, '_, C> {
    fn fill(&mut self, shape: impl Shape) {
        match self.colours {
            Colours::One(colour) if self.opacity == 255 => {
                let Ok(()) = shape.filled(C::from(*colour)).draw(self.window);
            }
            _ => self.blend(Wholly(shape)),
        }
    }

    /// By way of a shape of one type: there are dozens, and as many ways to paint.
    fn blend(&mut self, shape: impl Cover) {
        let touched = shape.touched();
        let send = |clip: &PixelRect, mut sink: &mut AnySink<'_>| shape.coverage(clip, &mut sink);
        self.blend_any(AnyShape { touched, send: &send });
    }

    fn blend_any(&mut self, shape: AnyShape<'_>) {
        match self.colours {
            Colours::One(colour) => {
                let blended = shape.antialiased(C::from(*colour), ReadBack).opacity(self.opacity);
                let Ok(()) = blended.draw_on(self.window);
            }
            Colours::Gradient(gradient) => self.blend_gradient(shape, gradient),
        }
    }

    fn blend_gradient(&mut self, shape: AnyShape<'_>, gradient: &Gradient) {
        let Ok(colours) = Stops::new(&gradient.stops, gradient.spread) else { return };
        let through = opacities(gradient, self.opacity);
        let through = through.as_deref().and_then(|stops| Stops::new(stops, gradient.spread).ok());
        match gradient.places {
            Places::Linear { start, end } => self.blend_paint(
                shape,
                LinearGradient::new(start, end, colours),
                through.map(|stops| LinearGradient::new(start, end, stops)),
            ),
            Places::Radial { center, ends, focus, focal_radius } => self.blend_paint(
                shape,
                RadialGradient::elliptical(center, ends, colours).with_focus(focus, focal_radius),
                through.map(|stops| RadialGradient::elliptical(center, ends, stops).with_focus(focus, focal_radius)),
            ),
        }
    }

    fn blend_paint(&mut self, shape: AnyShape<'_>, colours: impl Paint<Rgb888>, through: Option<impl Paint<Gray8>>) {
        let colours = Converted(colours);
        let Ok(()) = match through {
            None => Painted::new(shape, colours).antialiased(ReadBack).draw_on(self.window),
            Some(through) => {
                Painted::new(Masked::new(shape, through), colours).antialiased(ReadBack).draw_on(self.window)
            }
        };
    }
}

/// How much of each stop is let through, less what the whole lets through; none where all is.
fn opacities(gradient: &Gradient, whole: u8) -> Option<Vec<Stop<Gray8>>> {
    let let_through = |opacity: u8| Gray8::new(((u32::from(opacity) * u32::from(whole) + 127) / 255) as u8);
    match &gradient.opacities {
        Some(stops) => Some(stops.iter().map(|stop| Stop::new(stop.offset, let_through(stop.colour.luma()))).collect()),
        None => (whole < 255).then(|| vec![Stop::new(0, Gray8::new(whole))]),
    }
}

/// A paint in true colour on a display of fewer.
struct Converted<P>(P);

impl<C: From<Rgb888>, P: Paint<Rgb888>> Paint<C> for Converted<P> {
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        self.0.row(row, column).map(C::from)
    }
}

/// A shape that covers its pixels wholly: without anti-aliasing, but as transparent as any.
struct Wholly<S>(S);

impl<S: Shape> Cover for Wholly<S> {
    fn touched(&self) -> PixelRect {
        self.0.bounds()
    }

    fn coverage<T: CoverageSink>(&self, clip: &PixelRect, sink: &mut T) -> Result<(), T::Error> {
        struct Whole<'s, T>(&'s mut T);

        impl<T: CoverageSink> SpanSink for Whole<'_, T> {
            type Error = T::Error;

            fn span(&mut self, span: Span) -> Result<(), T::Error> {
                self.0.span(span, 255)
            }
        }

        self.0.spans(clip, &mut Whole(sink))
    }
}

/// A shape of whatever type.
struct AnyShape<'s> {
    touched: PixelRect,
    send: &'s dyn Fn(&PixelRect, &mut AnySink<'_>) -> Result<(), Stopped>,
}

type AnySink<'s> = dyn CoverageSink<Error = Stopped> + 's;

/// The sink has kept its error.
struct Stopped;

impl Cover for AnyShape<'_> {
    fn touched(&self) -> PixelRect {
        self.touched.clone()
    }

    fn coverage<T: CoverageSink>(&self, clip: &PixelRect, sink: &mut T) -> Result<(), T::Error> {
        struct Keeping<'s, T: CoverageSink>(&'s mut T, Result<(), T::Error>);

        impl<T: CoverageSink> CoverageSink for Keeping<'_, T> {
            type Error = Stopped;

            fn span(&mut self, span: Span, coverage: u8) -> Result<(), Stopped> {
                self.0.span(span, coverage).map_err(|error| {
                    self.1 = Err(error);
                    Stopped
                })
            }

            fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Stopped> {
                self.0.run(row, column, coverage).map_err(|error| {
                    self.1 = Err(error);
                    Stopped
                })
            }
        }

        let mut keeping = Keeping(sink, Ok(()));
        let _ = (self.send)(clip, &mut keeping);
        keeping.1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thin_line_is_as_wide_as_a_pixel() {
        let corners = |start, end| corners_of([start, end]).map(|corner| (corner.x.to_num::<f64>(), corner.y.to_num()));
        let level = corners(Vertex::new(1, 2), Vertex::new(5, 2));
        assert_eq!(level, [(1.0, 2.5), (5.0, 2.5), (5.0, 1.5), (1.0, 1.5)]);
        let slanted = corners(Vertex::new(0, 0), Vertex::new(3, 4));
        assert_eq!(slanted[0], (-0.3984375, 0.30078125));
        assert_eq!(corners(Vertex::new(1, 1), Vertex::new(1, 1)), [(1.0, 1.0); 4]);
    }
}
