//! Framebuffers of every format hold what a naive model of their memory holds, whatever is drawn on them.
//!
//! The model knows one thing: which bit of which byte a bit of a pixel is. It sets bits one at a time.

use std::fmt::Debug;

use embedded_graphics::{
    Pixel,
    image::{GetPixel, Image, ImageDrawable},
    mock_display::MockDisplay,
    pixelcolor::{Bgr565, BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb565, Rgb666, Rgb888, raw::RawU32},
    prelude::*,
    primitives::{PointsIter, Rectangle},
};
use proptest::{collection::vec, prelude::*};
use spanfill::{
    Blend, Canvas, Circle, Framebuffer, FramebufferError, InPlace, Layout, LsbFirst, Mix, MsbFirst, PackedColor, Pages,
    PixelRows, ReadBack, Rows, Triangle, Values, Vertex, buffer_size, prelude::*,
};

/// A colour of 32 bits, which embedded-graphics has none of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Argb8888(u32);

impl PixelColor for Argb8888 {
    type Raw = RawU32;
}

impl From<RawU32> for Argb8888 {
    fn from(raw: RawU32) -> Self {
        Self(raw.into_inner())
    }
}

impl From<Argb8888> for RawU32 {
    fn from(colour: Argb8888) -> Self {
        Self::new(colour.0)
    }
}

impl Mix for Argb8888 {
    fn over(self, backdrop: Self, alpha: u8) -> Self {
        let channel = |shift: u32| {
            let of = |colour: Self| (colour.0 >> shift) & 0xFF;
            ((of(self) * u32::from(alpha) + of(backdrop) * u32::from(255 - alpha) + 127) / 255) << shift
        };
        Self(channel(0) | channel(8) | channel(16) | channel(24))
    }
}

/// How a model lays its bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Format {
    bits: usize,
    msb_first: bool,
    vertical: bool,
}

/// A naive framebuffer.
#[derive(Debug, Clone)]
struct Model {
    format: Format,
    bytes: Vec<u8>,
    stride: usize,
    size: Size,
}

impl Model {
    /// Where bit `bit` (0 is the lowest) of a pixel lies: the byte, and the bit in it.
    fn place(&self, x: usize, y: usize, bit: usize) -> (usize, usize) {
        let Format { bits, msb_first, vertical } = self.format;
        if bits >= 8 {
            let byte = bit / 8;
            let byte = if msb_first { bits / 8 - 1 - byte } else { byte };
            return (y * self.stride + x * bits / 8 + byte, bit % 8);
        }
        let in_a_byte = 8 / bits;
        let (byte, nth) = if vertical {
            (y / in_a_byte * self.stride + x, y % in_a_byte)
        } else {
            (y * self.stride + x / in_a_byte, x % in_a_byte)
        };
        let nth = if msb_first { in_a_byte - 1 - nth } else { nth };
        (byte, nth * bits + bit)
    }

    fn contains(&self, point: Point) -> bool {
        Rectangle::new(Point::zero(), self.size).contains(point)
    }

    fn set(&mut self, point: Point, value: u32) {
        if self.contains(point) {
            for bit in 0..self.format.bits {
                let (byte, place) = self.place(point.x as usize, point.y as usize, bit);
                self.bytes[byte] = self.bytes[byte] & !(1 << place) | (((value >> bit) as u8 & 1) << place);
            }
        }
    }

    fn get(&self, point: Point) -> Option<u32> {
        self.contains(point).then(|| {
            (0..self.format.bits)
                .map(|bit| {
                    let (byte, place) = self.place(point.x as usize, point.y as usize, bit);
                    u32::from(self.bytes[byte] >> place & 1) << bit
                })
                .sum()
        })
    }
}

/// Something drawn.
#[derive(Debug, Clone)]
enum Drawing {
    Solid(Rectangle, u32),
    Contiguous(Rectangle, Vec<u32>),
    Pixels(Vec<(Point, u32)>),
    Clear(u32),
    Triangle([Point; 3], u32),
    Circle(Point, u32, u32),
    Blended(Point, u32, u32, u8),
    View(Rectangle, Rectangle, u32),
}

fn drawings() -> impl Strategy<Value = Drawing> {
    let far = prop_oneof![8 => -9..60_i32, 1 => Just(i32::MIN), 1 => Just(i32::MAX), 1 => any::<i32>()];
    let point = (far.clone(), far).prop_map(Point::from);
    let near = (-9..60_i32, -9..40_i32).prop_map(Point::from);
    let side = prop_oneof![8 => 0..50_u32, 1 => Just(u32::MAX), 1 => any::<u32>()];
    let area = (point.clone(), side.clone(), side).prop_map(|(point, w, h)| Rectangle::new(point, Size::new(w, h)));
    let small = (near.clone(), 0..30_u32, 0..20_u32).prop_map(|(point, w, h)| Rectangle::new(point, Size::new(w, h)));
    let value = prop_oneof![any::<u32>(), Just(0), Just(u32::MAX)];
    prop_oneof![
        4 => (area, value.clone()).prop_map(|(area, value)| Drawing::Solid(area, value)),
        4 => (small.clone(), value.clone()).prop_map(|(area, value)| Drawing::Solid(area, value)),
        2 => (small.clone(), vec(value.clone(), 0..400)).prop_map(|(area, values)| Drawing::Contiguous(area, values)),
        1 => vec((point.clone(), value.clone()), 0..20).prop_map(Drawing::Pixels),
        1 => vec((near.clone(), value.clone()), 0..20).prop_map(Drawing::Pixels),
        1 => value.clone().prop_map(Drawing::Clear),
        1 => ([near.clone(), near.clone(), near.clone()], value.clone()).prop_map(|(points, value)| Drawing::Triangle(points, value)),
        1 => (near.clone(), 0..20_u32, value.clone()).prop_map(|(point, radius, value)| Drawing::Circle(point, radius, value)),
        2 => (near, 0..20_u32, value.clone(), any::<u8>()).prop_map(|(point, radius, value, opacity)| Drawing::Blended(point, radius, value, opacity)),
        2 => (small.clone(), small, value).prop_map(|(view, area, value)| Drawing::View(view, area, value)),
    ]
}

/// The model as a target without a fast way, which blends what it reads.
struct Slow<'m, C> {
    model: &'m mut Model,
    colour: std::marker::PhantomData<C>,
}

impl<C> OriginDimensions for Slow<'_, C> {
    fn size(&self) -> Size {
        self.model.size
    }
}

impl<C: PackedColor> DrawTarget for Slow<'_, C> {
    type Color = C;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(point, colour) in pixels {
            self.model.set(point, colour.to_bits());
        }
        Ok(())
    }
}

impl<C: PackedColor> GetPixel for Slow<'_, C> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        self.model.get(point).map(C::from_bits)
    }
}

/// Draws on a framebuffer by the way that has to be tested, and on the model by pixels.
fn draw<C, L, S>(drawing: &Drawing, frame: &mut Framebuffer<C, L, S>, model: &mut Model)
where
    C: PackedColor + Mix + Debug,
    L: Layout<C>,
    S: AsRef<[L::Unit]> + AsMut<[L::Unit]>,
    InPlace: Blend<Framebuffer<C, L, S>>,
{
    let all = Rectangle::new(Point::zero(), model.size);
    let mut slow = Slow { model, colour: std::marker::PhantomData };
    match drawing.clone() {
        Drawing::Solid(area, value) => {
            let colour = C::from_bits(value);
            frame.fill_solid(&area, colour).unwrap();
            // Pixels by their own coordinates: no arithmetic on the area that could wrap.
            let inside = |point: &Point| {
                let from = |at: i32, start: i32, length: u32| {
                    (0..i64::from(length)).contains(&(i64::from(at) - i64::from(start)))
                };
                from(point.x, area.top_left.x, area.size.width) && from(point.y, area.top_left.y, area.size.height)
            };
            slow.draw_iter(all.points().filter(inside).map(|point| Pixel(point, colour))).unwrap();
        }
        Drawing::Contiguous(area, values) => {
            let colours = || values.iter().map(|value| C::from_bits(*value));
            frame.fill_contiguous(&area, colours()).unwrap();
            slow.draw_iter(area.points().zip(colours()).map(|(point, colour)| Pixel(point, colour))).unwrap();
        }
        Drawing::Pixels(pixels) => {
            let pixels = || pixels.iter().map(|(point, value)| Pixel(*point, C::from_bits(*value)));
            frame.draw_iter(pixels()).unwrap();
            slow.draw_iter(pixels()).unwrap();
        }
        Drawing::Clear(value) => {
            frame.clear(C::from_bits(value)).unwrap();
            slow.draw_iter(all.points().map(|point| Pixel(point, C::from_bits(value)))).unwrap();
        }
        Drawing::Triangle([a, b, c], value) => {
            let filled = Triangle::new(a, b, c).filled(C::from_bits(value));
            filled.draw_on(frame).unwrap();
            filled.draw(&mut slow).unwrap();
        }
        Drawing::Circle(centre, radius, value) => {
            let filled = Circle::new(centre, radius as i32).filled(C::from_bits(value));
            filled.draw_on(frame).unwrap();
            filled.draw(&mut slow).unwrap();
        }
        Drawing::Blended(centre, radius, value, opacity) => {
            let circle = Circle::new(Vertex::new(centre.x, centre.y), radius as i32);
            circle.antialiased(C::from_bits(value), InPlace).opacity(opacity).draw_on(frame).unwrap();
            circle.antialiased(C::from_bits(value), ReadBack).opacity(opacity).draw_on(&mut slow).unwrap();
        }
        Drawing::View(view, area, value) => {
            let colour = C::from_bits(value);
            let shown = view.intersection(&all);
            match frame.view(&view) {
                Some(mut part) => {
                    assert_eq!(part.size(), shown.size);
                    part.fill_solid(&area, colour).unwrap();
                    let points =
                        area.points().filter(|point| Rectangle::new(Point::zero(), shown.size).contains(*point));
                    slow.draw_iter(points.map(|point| Pixel(point + shown.top_left, colour))).unwrap();
                    for point in area.points() {
                        assert_eq!(part.pixel(point), part.bounding_box().contains(point).then_some(colour));
                    }
                }
                None => assert!(shown.is_zero_sized()),
            }
        }
    }
}

/// Bytes as a naive model lays them.
fn check_bytes<C, L>(format: Format, [width, pages]: [u32; 2], padding: usize, drawings: &[Drawing], start: u8)
where
    C: PackedColor + Mix + Debug,
    L: Layout<C, Unit = u8>,
    for<'b> InPlace: Blend<Framebuffer<C, L, &'b mut [u8]>>,
{
    let height = pages * if format.vertical && format.bits < 8 { 8 / format.bits as u32 } else { 1 };
    let line =
        if format.vertical && format.bits < 8 { width as usize } else { (width as usize * format.bits).div_ceil(8) };
    let lines = if format.vertical { pages } else { height };
    let stride = line + padding;
    assert_eq!(buffer_size::<C, L>(width, height), line * lines as usize);
    // What follows the framebuffer must stay, too.
    let mut bytes: Vec<u8> = (0..stride * lines as usize + 3).map(|index| start.wrapping_mul(index as u8)).collect();
    let mut model = Model { format, bytes: bytes.clone(), stride, size: Size::new(width, height) };
    let mut frame = Framebuffer::<C, L, _>::with_stride(&mut bytes[..], model.size, stride).unwrap();
    for drawing in drawings {
        draw(drawing, &mut frame, &mut model);
        assert_eq!(frame.units(), model.bytes, "{drawing:?} on {format:?} of {width} x {height}, stride {stride}");
    }
    for y in -1..=height as i32 {
        for x in -1..=width as i32 {
            // Colours of 18 bits leave out six of their 24.
            assert_eq!(frame.pixel(Point::new(x, y)), model.get(Point::new(x, y)).map(C::from_bits));
        }
    }
}

macro_rules! formats {
    ($($name:ident: $colour:ty, $layout:ty, $bits:literal $msb_first:literal $vertical:literal;)+) => {
        proptest! {
            #![proptest_config(ProptestConfig::with_cases(300))]
            $(#[test]
            fn $name(size in [1..50_u32, 1..8_u32], padding in 0..4_usize, drawings in vec(drawings(), 1..12), start: u8) {
                let format = Format { bits: $bits, msb_first: $msb_first, vertical: $vertical };
                check_bytes::<$colour, $layout>(format, size, padding, &drawings, start);
            })+
        }
    };
}

formats! {
    one_bit_msb_first: BinaryColor, Rows<MsbFirst>, 1 true false;
    one_bit_lsb_first: BinaryColor, Rows<LsbFirst>, 1 false false;
    two_bits_msb_first: Gray2, Rows<MsbFirst>, 2 true false;
    two_bits_lsb_first: Gray2, Rows<LsbFirst>, 2 false false;
    four_bits_msb_first: Gray4, Rows<MsbFirst>, 4 true false;
    four_bits_lsb_first: Gray4, Rows<LsbFirst>, 4 false false;
    eight_bits: Gray8, Rows<MsbFirst>, 8 true false;
    sixteen_bits_big_endian: Rgb565, Rows<MsbFirst>, 16 true false;
    sixteen_bits_little_endian: Bgr565, Rows<LsbFirst>, 16 false false;
    twenty_four_bits_big_endian: Rgb888, Rows<MsbFirst>, 24 true false;
    twenty_four_bits_little_endian: Rgb666, Rows<LsbFirst>, 24 false false;
    thirty_two_bits_big_endian: Argb8888, Rows<MsbFirst>, 32 true false;
    thirty_two_bits_little_endian: Argb8888, Rows<LsbFirst>, 32 false false;
    pages_of_one_bit_lsb_first: BinaryColor, Pages<LsbFirst>, 1 false true;
    pages_of_one_bit_msb_first: BinaryColor, Pages<MsbFirst>, 1 true true;
    pages_of_two_bits: Gray2, Pages<LsbFirst>, 2 false true;
    pages_of_four_bits: Gray4, Pages<MsbFirst>, 4 true true;
    pages_of_sixteen_bits: Rgb565, Pages<MsbFirst>, 16 true true;
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    /// Values have no bytes that could be compared, but the pixels of RGB565 in little-endian bytes.
    #[test]
    fn values(size in [1..50_u32, 1..20_u32], padding in 0..4_usize, drawings in vec(drawings(), 1..12)) {
        let [width, height] = size;
        let stride = width as usize + padding;
        let mut pixels = vec![Rgb565::BLACK; stride * height as usize];
        let format = Format { bits: 16, msb_first: false, vertical: false };
        let bytes = vec![0; pixels.len() * 2];
        let mut model = Model { format, bytes, stride: 2 * stride, size: Size::new(width, height) };
        let mut frame = Framebuffer::<Rgb565, Values, _>::with_stride(&mut pixels[..], model.size, stride).unwrap();
        for drawing in &drawings {
            draw(drawing, &mut frame, &mut model);
            let bytes: Vec<u8> = frame.units().iter().flat_map(|pixel| (pixel.to_bits() as u16).to_le_bytes()).collect();
            prop_assert_eq!(&bytes, &model.bytes, "{:?}", drawing);
        }
        let right = i32::try_from(width).unwrap() - 1;
        prop_assert_eq!(frame.row_from(Point::new(right, 0)).map(|row| row.len()), Some(1));
        prop_assert_eq!(frame.row_from(Point::new(right + 1, 0)), None);
        prop_assert_eq!(frame.row_from(Point::new(0, -1)), None);
    }

    /// A part that is shown elsewhere is what lies there, and nothing else.
    #[test]
    fn images(x in -5..12_i32, y in -5..12_i32, width in 0..14_u32, height in 0..14_u32) {
        let mut frame = Framebuffer::<Gray4, Rows<MsbFirst>, _>::new([0; 50], Size::new(10, 10)).unwrap();
        let colour = |point: Point| Gray4::new((7 * point.x + 3 * point.y) as u8 % 16);
        let pixels = frame.bounding_box().points().map(|point| Pixel(point, colour(point)));
        frame.draw_iter(pixels).unwrap();
        let area = Rectangle::new(Point::new(x, y), Size::new(width, height));
        let (mut shown, mut expected) = (MockDisplay::new(), MockDisplay::new());
        frame.draw_sub_image(&mut shown, &area).unwrap();
        let inside = area.points().filter(|point| frame.bounding_box().contains(*point));
        expected.draw_iter(inside.map(|point| Pixel(point - area.top_left, colour(point)))).unwrap();
        shown.assert_eq(&expected);
        let (mut shown, mut expected) = (MockDisplay::new(), MockDisplay::new());
        Image::new(&frame, Point::new(7, 3)).draw(&mut shown).unwrap();
        frame.show(Point::new(7, 3), &mut expected).unwrap();
        shown.assert_eq(&expected);
        assert_eq!(shown.get_pixel(Point::new(16, 12)), Some(colour(Point::new(9, 9))));
    }
}

/// Each refusal tells what was asked for and what would do.
#[test]
fn what_cannot_be_is_refused_with_the_numbers() {
    type Packed = Rows<MsbFirst>;
    let of = |bytes: usize, width, height, stride| {
        let storage = vec![0; bytes];
        Framebuffer::<Rgb565, Packed, _>::with_stride(storage, Size::new(width, height), stride)
            .map(|_| ())
            .unwrap_err()
    };
    assert_eq!(of(99, 0, 5, 0), FramebufferError::Empty { width: 0, height: 5 });
    assert_eq!(of(99, 5, 0, 10), FramebufferError::Empty { width: 5, height: 0 });
    assert_eq!(of(99, 10, 5, 19), FramebufferError::StrideTooShort { needed: 20, stride: 19 });
    assert_eq!(of(99, 10, 5, 20), FramebufferError::BufferTooSmall { needed: 100, available: 99 });
    assert_eq!(of(103, 10, 5, 21), FramebufferError::BufferTooSmall { needed: 104, available: 103 });
    assert!(Framebuffer::<Rgb565, Packed, _>::with_stride([0; 104], Size::new(10, 5), 21).is_ok());
    assert_eq!(of(99, u32::MAX, 1, 20), FramebufferError::TooLarge { width: u32::MAX, height: 1 });
    let longest = i32::MAX.unsigned_abs();
    assert_eq!(
        of(99, longest, longest, usize::MAX),
        FramebufferError::BufferTooSmall { needed: usize::MAX, available: 99 }
    );
    let pages = |height| Framebuffer::<Gray2, Pages<LsbFirst>, _>::new([0; 64], Size::new(16, height)).map(|_| ());
    assert_eq!(pages(14), Err(FramebufferError::PartialPage { height: 14, page_rows: 4 }));
    assert_eq!(pages(16), Ok(()));
    assert_eq!(pages(20), Err(FramebufferError::BufferTooSmall { needed: 80, available: 64 }));
    assert_eq!(pages(14).unwrap_err().to_string(), "a height of 14 rows is not a multiple of the 4 rows of a page");
}

/// Blocks from outside of a canvas do not come from shapes; whatever they do to its pixels, nothing panics and no memory behind
/// it changes.
#[test]
fn a_canvas_takes_any_block() {
    use spanfill::BlockSink as _;
    fn check<L: Layout<Gray2, Unit = u8>>() {
        let mut memory = [0; 40];
        let mut frame = Framebuffer::<Gray2, L, _>::new(&mut memory[..32], Size::new(16, 8)).unwrap();
        for (rows, columns) in [
            (0..9, 0..1),
            (-1..1, 0..1),
            (0..1, -1..1),
            (0..1, 15..17),
            (0..1, i32::MIN..i32::MAX),
            (i32::MAX - 1..i32::MAX, 3..5),
            (i32::MIN..i32::MIN + 1, 3..5),
            (2..3, std::ops::Range { start: 5, end: 4 }),
            (2..3, i32::MAX - 1..i32::MAX),
        ] {
            let Ok(()) = frame.solid(Gray2::WHITE).block(rows, columns);
        }
        assert_eq!(memory[32..], [0; 8]);
    }
    check::<Rows<MsbFirst>>();
    check::<Rows<LsbFirst>>();
    check::<Pages<LsbFirst>>();
    check::<Pages<MsbFirst>>();
}

static BLANK: Framebuffer<Rgb888, Rows<MsbFirst>, [u8; 60]> = Framebuffer::blank::<5, 4>();
static WHITE: Framebuffer<Gray8, Values, [Gray8; 20]> = Framebuffer::<_, _, [_; 20]>::filled::<5, 4>(Gray8::WHITE);

#[test]
fn statics_are_made_by_the_compiler() {
    assert_eq!((BLANK.size(), BLANK.pixel(Point::new(4, 3))), (Size::new(5, 4), Some(Rgb888::BLACK)));
    assert_eq!((WHITE.size(), WHITE.pixel(Point::new(4, 3))), (Size::new(5, 4), Some(Gray8::WHITE)));
    assert_eq!(WHITE.pixel(Point::new(5, 3)), None);
}
