//! Proof by linking that the library has no panic path: this program calls all of it on values the compiler does not
//! know, and its panic handler needs a function that does not exist. If one panic were left in, it would not link.
//!
//! `examples/firmware/run.sh build` links it; there is nothing to run.

#![no_std]
#![no_main]

use core::{convert::Infallible, hint::black_box, panic::PanicInfo};

use embedded_graphics::{
    geometry::Angle,
    image::GetPixel,
    pixelcolor::{Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888},
    prelude::*,
    primitives::{self as eg, CornerRadii, Rectangle, StrokeAlignment, StyledDimensions, StyledDrawable},
};
use spanfill::{
    ActiveEdge, Align, Arc, Blend, BlockSink, Cap, Circle, CircleOutline, Connectivity, Cover, CoverageEdge,
    CoverageSink, Dither, Element, Ellipse, FillRegion, FillRule, FillSegment, FinePoint, I24F8, InPlace, Join, Line,
    Linear, Mix, MixLinear, Outline, OutlineSink, Over, Path, PixelRect, PixelRows, Polygon, ReadBack, Ring,
    RoundedRectangle, SampleCell, SampleEdge, Samples, Scratch, Sector, SeedFill, Shape, Span, SpanSink, Stroke,
    StrokeStyle, SvgElements, TaperedLine, TooLittleScratch, Transform, Triangle, Turn, Vertex, collect,
    eg::{DrawOn, Style, StyleBuilder},
    prelude::*,
};

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    #[allow(unsafe_code, reason = "declared, never defined: that is the point")]
    unsafe extern "C" {
        safe fn the_library_has_a_panic_path() -> !;
    }
    the_library_has_a_panic_path()
}

/// A display of unknown size and place that can be read.
struct Display(Rectangle);

impl Dimensions for Display {
    fn bounding_box(&self) -> Rectangle {
        self.0
    }
}

impl DrawTarget for Display {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().for_each(|pixel| {
            black_box(pixel);
        });
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Infallible> {
        black_box(area);
        colours.into_iter().for_each(|colour| {
            black_box(colour);
        });
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        black_box((area, colour));
        Ok(())
    }
}

impl GetPixel for Display {
    type Color = Rgb565;

    fn pixel(&self, point: Point) -> Option<Rgb565> {
        black_box(point);
        black_box(None)
    }
}

/// A sink that can fail.
struct Sink;

impl SpanSink for Sink {
    type Error = u8;

    fn span(&mut self, span: Span) -> Result<(), u8> {
        black_box(span);
        black_box(Ok(()))
    }
}

impl BlockSink for Sink {
    type Error = u8;

    fn block(&mut self, rows: core::ops::Range<i32>, columns: core::ops::Range<i32>) -> Result<(), u8> {
        black_box((rows, columns));
        black_box(Ok(()))
    }
}

impl CoverageSink for Sink {
    type Error = u8;

    fn span(&mut self, span: Span, coverage: u8) -> Result<(), u8> {
        black_box((span, coverage));
        black_box(Ok(()))
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), u8> {
        black_box((row, column, coverage));
        black_box(Ok(()))
    }
}

impl PixelRows for Display {
    fn row_from(&mut self, start: Point) -> Option<&mut [Rgb565]> {
        black_box(start);
        black_box(None)
    }
}

/// A bitmap that nobody knows, and that can fail.
struct Region(PixelRect);

impl FillRegion for Region {
    type Error = u8;

    fn bounds(&self) -> PixelRect {
        self.0.clone()
    }

    fn is_open(&self, x: i32, y: i32) -> bool {
        black_box((x, y));
        black_box(false)
    }

    fn fill(&mut self, row: i32, columns: core::ops::Range<i32>) -> Result<(), u8> {
        black_box((row, columns));
        black_box(Ok(()))
    }
}

fn fill_from_seed(clip: &PixelRect, display: &mut Display) {
    let mut stack = black_box([FillSegment::EMPTY; 16]);
    for connectivity in black_box([Connectivity::Four, Connectivity::Eight]) {
        let fill = SeedFill::new(black_box(Point::zero())).connectivity(connectivity);
        let _ = black_box(fill.fill(&mut Region(clip.clone()), some_of(&mut stack)));
        let _ = black_box(fill.draw(black_box(Rgb565::RED), display, some_of(&mut stack)));
    }
}

fn push(shape: impl Shape, clip: &PixelRect, display: &mut Display) {
    black_box(shape.bounds());
    let _ = black_box(shape.spans(clip, &mut Sink));
    let _ = black_box(shape.blocks(clip, &mut Sink));
    let filled = shape.filled(Rgb565::RED);
    black_box(filled.bounding_box());
    let Ok(()) = filled.draw(display);
}

/// Everything that a coverage can be asked, and blended in every way there is.
fn cover(shape: &impl Cover, clip: &PixelRect, display: &mut Display) {
    black_box(shape.touched());
    let _ = black_box(shape.coverage(clip, &mut Sink));
    let background = Over(black_box(Rgb565::BLUE));
    let drawable = Borrowed(shape).antialiased(black_box(Rgb565::RED), background);
    black_box(drawable.bounding_box());
    let Ok(()) = drawable.draw(display);
    blend(shape, background, display);
    blend(shape, Linear(background), display);
    blend(shape, Dither, display);
    blend(shape, ReadBack, display);
    blend(shape, Linear(ReadBack), display);
    blend(shape, InPlace, display);
    blend(shape, Linear(InPlace), display);
}

fn blend(shape: &impl Cover, blend: impl Blend<Display>, display: &mut Display) {
    let antialiased = Borrowed(shape).antialiased(black_box(Rgb565::RED), blend);
    let Ok(()) = antialiased.opacity(black_box(255)).draw_on(display);
}

/// For shapes that cannot be copied.
struct Borrowed<'a, S>(&'a S);

impl<S: Cover> Cover for Borrowed<'_, S> {
    fn touched(&self) -> PixelRect {
        self.0.touched()
    }

    fn coverage<K: CoverageSink>(&self, clip: &PixelRect, sink: &mut K) -> Result<(), K::Error> {
        self.0.coverage(clip, sink)
    }
}

fn mix<C: Mix + MixLinear + Default>() {
    let (top, bottom, alpha) = (black_box(C::default()), black_box(C::default()), black_box(0));
    black_box((top.over(bottom, alpha), top.over_linear(bottom, alpha)));
}

fn mix_all() {
    mix::<BinaryColor>();
    mix::<Gray2>();
    mix::<Gray4>();
    mix::<Gray8>();
    mix::<Rgb555>();
    mix::<Bgr555>();
    mix::<Rgb565>();
    mix::<Bgr565>();
    mix::<Rgb666>();
    mix::<Bgr666>();
    mix::<Rgb888>();
    mix::<Bgr888>();
}

/// embedded-graphics' primitives, in each style that this library has for them.
macro_rules! draw_styled {
    ($style:expr, $display:expr, [$($primitive:expr),+ $(,)?]) => { $({
        let (style, display, primitive): (Style<Rgb565>, &mut Display, _) = ($style, $display, $primitive);
        let Ok(()) = primitive.draw_styled(&style, display);
        black_box(primitive.styled_bounding_box(&style));
        let background = Over(black_box(Rgb565::BLUE));
        let blended = style.antialiased(background).opacity(black_box(255));
        let Ok(()) = primitive.draw_styled(&blended, display);
        black_box(primitive.styled_bounding_box(&blended));
        let Ok(()) = primitive.draw_styled(&style.antialiased(Linear(background)), display);
        let Ok(()) = primitive.draw_styled(&style.antialiased(Dither), display);
        let Ok(()) = primitive.into_styled(style.antialiased(ReadBack)).draw_on(display);
        let Ok(()) = primitive.into_styled(style.antialiased(Linear(ReadBack))).draw_on(display);
    })+ };
}

fn draw_primitives(display: &mut Display) {
    let colours = StyleBuilder::new().fill_color(Rgb565::RED).stroke_color(Rgb565::BLUE);
    let styles = black_box([
        colours.stroke_width(1).stroke_alignment(StrokeAlignment::Center).build(),
        colours.reset_fill_color().build(),
        colours.reset_stroke_color().build(),
    ]);
    let (point, size, diameter) = (black_box(Point::zero()), black_box(Size::zero()), black_box(0));
    let angle = || Angle::from_radians(black_box(0.0));
    let rectangle = Rectangle::new(point, size);
    let points = black_box([point; 5]);
    for style in styles {
        black_box(style.is_transparent());
        draw_styled!(
            style,
            display,
            [
                rectangle,
                eg::Circle::new(point, diameter),
                eg::Ellipse::new(point, size),
                eg::RoundedRectangle::new(rectangle, black_box(CornerRadii::default())),
                eg::Triangle::new(point, black_box(point), black_box(point)),
                eg::Line::new(point, black_box(point)),
                eg::Polyline::new(&points),
                eg::Arc::new(point, diameter, angle(), angle()),
                eg::Sector::new(point, diameter, angle(), angle()),
            ]
        );
    }
}

fn draw_polygon(polygon: Polygon<'_>, clip: &PixelRect, display: &mut Display) -> Result<(), TooLittleScratch> {
    black_box((polygon.active_edges_at_most(), polygon.coverage_edges_at_most()));
    let mut room = black_box([0; 16]);
    black_box((polygon.active_edges_in(some_of(&mut room)), polygon.coverage_edges_in(some_of(&mut room))));
    push(polygon.with_capacity::<8>()?, clip, display);
    let mut slots = black_box([ActiveEdge::EMPTY; 16]);
    push(polygon.in_scratch(some_of(&mut slots))?, clip, display);

    let mut scratch = black_box(Scratch::<8>::new());
    if let Ok(polygon) = polygon.within(&mut scratch) {
        cover(&polygon, clip, display);
        push(polygon, clip, display);
    }
    cover(&polygon.coverage_with::<8>()?, clip, display);
    let mut edges = black_box([CoverageEdge::EMPTY; 16]);
    cover(&polygon.coverage_in(some_of(&mut edges))?, clip, display);
    let (mut edges, mut cells) = (black_box([SampleEdge::EMPTY; 16]), black_box([SampleCell::EMPTY; 32]));
    cover(&polygon.supersampled_in(samples(), some_of(&mut edges), some_of(&mut cells))?, clip, display);
    Ok(())
}

/// As many as nobody knows.
fn some_of<T>(slots: &mut [T]) -> &mut [T] {
    slots.get_mut(..black_box(16)).unwrap_or_default()
}

fn samples() -> Samples {
    if black_box(false) { Samples::WEIGHTED } else { Samples::grid(black_box(4)) }
}

/// Takes the points of an outline, and makes a polygon of them.
fn outline(outline: &impl Outline, clip: &PixelRect, display: &mut Display) {
    struct Points;

    impl OutlineSink for Points {
        fn point(&mut self, x: i64, y: i64) {
            black_box((x, y));
        }

        fn close(&mut self) {
            black_box(());
        }
    }

    let mut scratch = black_box(Scratch::<8, 16>::new());
    if let Ok(polygon) = outline.within(&mut scratch) {
        cover(&polygon, clip, display);
        push(polygon, clip, display);
    }
    outline.emit(&mut Points);
    black_box((outline.extent(), outline.count(), outline.chains()));
    let mut edges = black_box([CoverageEdge::EMPTY; 16]);
    if let Ok(shape) = outline.coverage_in(some_of(&mut edges)) {
        cover(&shape, clip, display);
    }
    let mut vertices = black_box([Vertex::from_bits(0, 0); 16]);
    if let Ok(polygon) = collect(outline, some_of(&mut vertices)) {
        black_box(draw_polygon(polygon, clip, display)).unwrap_or_default();
    }
}

fn draw_paths(clip: &PixelRect, display: &mut Display) {
    let mut elements = black_box([Element::Close; 16]);
    for (slot, element) in
        elements.iter_mut().zip(SvgElements::new(black_box("M1 1z"), black_box(1), black_box(1)).flatten())
    {
        *slot = element;
    }
    let point = || black_box(FinePoint::from_bits(0, 0));
    let angle = || spanfill::Angle::from_degrees(black_box(0.0)) + spanfill::Angle::of(black_box(1), black_box(1));
    if let Some(last) = elements.last_mut() {
        *last = Element::arc(point(), point(), angle(), black_box(true), black_box(true), point());
    }
    let transform = Transform::turned_about(point(), angle()).then(black_box(Transform::IDENTITY));
    let path = Path::new(&elements).transformed(transform);
    outline(&path, clip, display);
    let dashes = black_box([256_u32; 3]);
    let style = StrokeStyle::new(black_box(256)).cap(black_box(Cap::Round)).join(black_box(Join::Round));
    let stroke = Stroke::new(path, style.dashes(&dashes).phase(black_box(1)).align(black_box(Align::Inside)));
    outline(&stroke, clip, display);
    black_box(stroke.coverage_edges());
    black_box(stroke.connect(Rgb565::RED, display)).unwrap_or_default();
}

fn draw_curves(clip: &PixelRect, display: &mut Display) {
    let vertex = || black_box(Vertex::from_bits(0, 0));
    let length = || black_box(I24F8::ZERO);
    let angle = || black_box(spanfill::Angle::ZERO);
    let rectangle = spanfill::Rectangle::new(vertex(), vertex());
    let rounded = RoundedRectangle { rectangle, radii: [vertex(), vertex(), vertex(), vertex()] };
    let ellipse = Ellipse::new(vertex(), vertex()).turned(angle());
    let ring = Ring::new(vertex(), length(), length());
    let sector = Sector::new(vertex(), length(), angle(), angle());
    let arc = Arc::new(vertex(), length(), length(), angle(), angle());
    let hand = TaperedLine { is_connected: black_box(true), ..TaperedLine::new(vertex(), vertex(), black_box([1, 2])) };
    push(rectangle, clip, display);
    push(rounded, clip, display);
    push(ellipse, clip, display);
    push(ring, clip, display);
    push(sector, clip, display);
    push(arc, clip, display);
    push(hand, clip, display);
    push(CircleOutline::new(vertex(), length()), clip, display);
    outline(&rounded, clip, display);
    outline(&ellipse, clip, display);
    outline(&arc, clip, display);
    outline(&Stroke::new(arc.center_line(), StrokeStyle::new(black_box(256))), clip, display);
}

fn draw_shapes(clip: &PixelRect, display: &mut Display) -> Result<(), TooLittleScratch> {
    let vertices = black_box([Vertex::from_bits(0, 0); 9]);
    let [a, b, c, ..] = vertices;
    let turn = Turn::from_degrees(black_box(0.0));
    let turn_back = Turn::from_radians(black_box(0.0));
    let triangle = Triangle::new(a, turn_back.about(a, b), turn.about(c, a));
    let line = Line::new(a, Vertex::from(black_box(Point::zero())));
    let circle = Circle::new(Vertex::new(black_box(0.5_f32), black_box(1_i64)), black_box(0.0_f32));
    push(triangle, clip, display);
    push(line, clip, display);
    push(circle, clip, display);
    push(Circle::new(Vertex::pixel(black_box(0), black_box(0)), black_box(0)), clip, display);

    cover(&triangle, clip, display);
    cover(&line, clip, display);
    cover(&circle, clip, display);
    let mut cells = black_box([SampleCell::EMPTY; 32]);
    cover(&triangle.supersampled_in(samples(), some_of(&mut cells))?, clip, display);
    cover(&circle.supersampled_in(samples(), some_of(&mut cells))?, clip, display);

    let contours = [vertices.as_slice(), &vertices];
    let many = black_box(contours.as_slice());
    draw_polygon(Polygon::new(&vertices), clip, display)?;
    draw_polygon(Polygon::with_contours(many).fill_rule(FillRule::EvenOdd), clip, display)
}

#[cortex_m_rt::entry]
fn main() -> ! {
    loop {
        let mut display = Display(black_box(Rectangle::zero()));
        let clip = &black_box(PixelRect { rows: 0..0, columns: 0..0 });
        if let Err(error) = draw_shapes(clip, &mut display) {
            black_box(error);
        }
        fill_from_seed(clip, &mut display);
        draw_paths(clip, &mut display);
        draw_curves(clip, &mut display);
        draw_primitives(&mut display);
        mix_all();
    }
}
