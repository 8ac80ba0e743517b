//! A frame is the same drawn at once and in bands of any height, sent by any way; what goes wrong in one frame does not reach
//! the next; and what has changed is what is sent.

use std::{
    cell::{Cell, RefCell},
    convert::Infallible,
    future::Future,
    mem::forget,
    pin::{Pin, pin},
    task::{Context, Poll, Waker},
};

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888},
    prelude::*,
    primitives::Rectangle,
    text::Text,
};
use proptest::{collection::vec, prelude::*};
use spanfill::{
    Band, Bands, Blend, Bounded, Canvas, Circle, Damage, FrameError, Framebuffer, FramebufferError, InPlace, Layout,
    Line, LsbFirst, MsbFirst, PackedColor, Pages, PixelRect, Polygon, Rows, Transfer, Transmit, Triangle, Values,
    prelude::*,
};

const SCREEN: Size = Size::new(61, 48);

/// A scene of everything: filled, anti-aliased, text, and embedded-graphics' own.
#[derive(Debug, Clone)]
struct Scene {
    corners: [Point; 3],
    centre: Point,
    radius: u8,
    colours: [u32; 4],
}

impl Scene {
    fn draw<C, D>(&self, target: &mut D) -> Result<(), Infallible>
    where
        C: PackedColor + spanfill::Mix,
        D: Canvas<Color = C, Error = Infallible>,
        InPlace: Blend<D>,
    {
        let [a, b, c] = self.corners;
        let [fill, edge, line, text] = self.colours.map(C::from_bits);
        Triangle::new(a, b, c).filled(fill).draw_on(target)?;
        Circle::new(self.centre, self.radius).antialiased(edge, InPlace).opacity(200).draw_on(target)?;
        Line::new(a, self.centre).filled(line).draw_on(target)?;
        Circle::new(c, self.radius / 2).filled(line).draw(target)?;
        Text::new("bands", self.centre, MonoTextStyle::new(&FONT_6X10, text)).draw(target)?;
        Ok(())
    }
}

fn scenes() -> impl Strategy<Value = Scene> {
    let point = || (-10..70_i32, -10..60_i32).prop_map(Point::from);
    ([point(), point(), point()], point(), 0..40_u8, any::<[u32; 4]>())
        .prop_map(|(corners, centre, radius, colours)| Scene { corners, centre, radius, colours })
}

/// What a whole framebuffer has in memory.
fn whole<C, L>(scene: &Scene, background: C) -> Vec<L::Unit>
where
    C: PackedColor + spanfill::Mix,
    L: Layout<C>,
    L::Unit: Default,
    InPlace: Blend<Framebuffer<C, L, Vec<L::Unit>>>,
{
    let units = vec![L::Unit::default(); spanfill::buffer_size::<C, L>(SCREEN.width, SCREEN.height)];
    // Bits that are no pixels have the background's colour, too: first a frame that has pixels there.
    let beside = if L::LINE_ROWS == 1 && L::STEP < 8 { 8 / L::STEP } else { 1 };
    let size = Size::new(SCREEN.width.next_multiple_of(beside), SCREEN.height);
    let mut frame = Framebuffer::<C, L, _>::new(units, size).unwrap();
    frame.clear(background).unwrap();
    let mut frame = Framebuffer::<C, L, _>::new(frame.into_storage(), SCREEN).unwrap();
    scene.draw(&mut frame).unwrap();
    frame.into_storage()
}

/// What is to be done in a poll: how often a flush is pending before it is done.
#[derive(Debug)]
struct Bus {
    sent: RefCell<Vec<u8>>,
    pending: Cell<u32>,
}

impl Bus {
    fn new(pending: u32) -> Self {
        Self { sent: RefCell::new(Vec::new()), pending: Cell::new(pending) }
    }

    /// Sends half, waits, and sends the rest of what it was given at first.
    async fn send(&self, units: &[u8]) -> Result<(), Infallible> {
        let (first, second) = units.split_at(units.len() / 2);
        self.sent.borrow_mut().extend_from_slice(first);
        for _ in 0..self.pending.get() {
            yield_once().await;
        }
        self.sent.borrow_mut().extend_from_slice(second);
        Ok(())
    }
}

async fn yield_once() {
    let mut yielded = false;
    std::future::poll_fn(|_| if std::mem::replace(&mut yielded, true) { Poll::Ready(()) } else { Poll::Pending }).await;
}

/// Polls by hand, so often at most.
fn run<T>(mut future: Pin<&mut impl Future<Output = T>>, polls: usize) -> Option<T> {
    let mut context = Context::from_waker(Waker::noop());
    (0..polls).find_map(|_| match future.as_mut().poll(&mut context) {
        Poll::Ready(output) => Some(output),
        Poll::Pending => None,
    })
}

/// A DMA channel, more or less: it holds the buffer until somebody waits, and only then looks at it.
#[derive(Debug, Default)]
struct Dma {
    sent: Vec<u8>,
    starts: usize,
    fails_at: Option<usize>,
}

struct Running<B> {
    dma: Dma,
    buffer: B,
    length: usize,
}

impl<B: AsRef<[u8]>> Transmit<B> for Dma {
    type Transfer = Running<B>;

    fn start(mut self, area: &Rectangle, buffer: B, length: usize) -> Running<B> {
        assert_eq!(area.top_left.x, 0);
        self.starts += 1;
        Running { dma: self, buffer, length }
    }
}

impl<B: AsRef<[u8]>> Transfer<B> for Running<B> {
    type Sender = Dma;
    type Error = &'static str;

    fn wait(self) -> (Dma, B, Result<(), &'static str>) {
        let Self { mut dma, buffer, length } = self;
        if dma.fails_at == Some(dma.starts) {
            return (dma, buffer, Err("the bus is gone"));
        }
        dma.sent.extend_from_slice(&buffer.as_ref()[..length]);
        (dma, buffer, Ok(()))
    }
}

/// The frame in bands of so many rows, by every way.
fn check_split<C, L>(scene: &Scene, rows: u32, pending: u32)
where
    C: PackedColor + spanfill::Mix,
    L: Layout<C, Unit = u8>,
    InPlace: Blend<Framebuffer<C, L, Vec<u8>>> + for<'b> Blend<Band<'b, C, L>>,
{
    let rows = rows * L::LINE_ROWS;
    let background = C::from_bits(scene.colours[0] >> 7);
    let expected = whole::<C, L>(scene, background);
    // Whatever was in the memory before.
    let buffer = || vec![0x5A; spanfill::buffer_size::<C, L>(SCREEN.width, rows) + 3];
    let one = || Bands::<C, L, _, 1>::new([buffer()], SCREEN, background).unwrap().with_rows(rows).unwrap();
    let two = || Bands::<C, L, _, 2>::new([buffer(), buffer()], SCREEN, background).unwrap().with_rows(rows).unwrap();

    let mut sent = Vec::new();
    let mut next_row = 0;
    one()
        .draw(
            |band| scene.draw(band),
            |band| {
                let Rectangle { top_left, size } = band.bounding_box();
                assert_eq!((top_left.x, top_left.y, size.width), (0, next_row, SCREEN.width));
                assert!(size.height == rows || next_row as u32 + size.height == SCREEN.height);
                next_row += size.height as i32;
                sent.extend_from_slice(band.units());
                Ok::<(), Infallible>(())
            },
        )
        .unwrap();
    assert_eq!(next_row as u32, SCREEN.height);
    assert!(sent == expected, "in bands of {rows} rows");

    let (bus, mut bands) = (Bus::new(pending), one());
    let frame = bands.draw_async(|band| scene.draw(band), async |band| bus.send(band.units()).await);
    assert_eq!(run(pin!(frame), 10_000), Some(Ok(())));
    assert!(bus.sent.take() == expected, "async in bands of {rows} rows");

    let (bus, mut bands) = (Bus::new(pending), two());
    let frame = bands.draw_async(|band| scene.draw(band), async |band| bus.send(band.units()).await);
    assert_eq!(run(pin!(frame), 10_000), Some(Ok(())));
    assert!(bus.sent.take() == expected, "async in two bands of {rows} rows");

    let (dma, drawn) = one().draw_by_transfers(Dma::default(), |band| scene.draw(band));
    assert_eq!(drawn, Ok(()));
    assert!(dma.sent == expected, "by transfers in bands of {rows} rows");
    let (dma, drawn) = two().draw_by_transfers(Dma::default(), |band| scene.draw(band));
    assert_eq!(drawn, Ok(()));
    assert!(dma.sent == expected, "by transfers in two bands of {rows} rows");
}

/// A display that can be looked at.
#[derive(Clone, PartialEq)]
struct Panel<C>(Vec<C>);

impl<C> OriginDimensions for Panel<C> {
    fn size(&self) -> Size {
        SCREEN
    }
}

impl<C: PixelColor> DrawTarget for Panel<C> {
    type Color = C;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(point, colour) in pixels {
            assert!(self.bounding_box().contains(point), "{point}");
            self.0[point.y as usize * SCREEN.width as usize + point.x as usize] = colour;
        }
        Ok(())
    }
}

type ColourBand<'a> = Band<'a, Rgb565, Rows<MsbFirst>>;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn any_split_shows_the_whole(scene in scenes(), rows in 1..60_u32, pending in 0..3_u32) {
        check_split::<Rgb565, Rows<MsbFirst>>(&scene, rows, pending);
        check_split::<Rgb888, Rows<LsbFirst>>(&scene, rows, pending);
        check_split::<Gray4, Rows<MsbFirst>>(&scene, rows, pending);
        check_split::<BinaryColor, Pages<LsbFirst>>(&scene, rows % 7 + 1, pending);
    }

    /// What knows its bounds draws what it draws without, and nothing where it is not.
    #[test]
    fn bounded_drawings_are_the_same(scene in scenes(), rows in 1..20_u32) {
        let [a, b, c] = scene.corners;
        let [fill, edge, ..] = scene.colours.map(<Rgb565 as PackedColor>::from_bits);
        let outline = [a, b, scene.centre, c].map(spanfill::Vertex::from);
        let text = Text::new("bands", scene.centre, MonoTextStyle::new(&FONT_6X10, edge));
        let polygon = Polygon::new(&outline);
        let filled = polygon.with_capacity::<8>().unwrap().filled(fill);
        let blended = polygon.coverage_with::<8>().unwrap().antialiased(edge, InPlace).opacity(99);
        let (bounded, bounded_blended, bounded_text) =
            (Bounded::new(filled), Bounded::new(blended), Bounded::new(text));
        prop_assert_eq!(bounded_text.bounding_box().size, text.bounding_box().size);
        let drawn = |draw: &dyn Fn(&mut ColourBand)| {
            let buffer = vec![0; 2 * 61 * rows as usize];
            let mut bands = Bands::<Rgb565, Rows<MsbFirst>, _, 1>::new([buffer], SCREEN, Rgb565::BLACK).unwrap();
            let mut panel = Panel(vec![Rgb565::WHITE; 61 * 48]);
            let scene = |band: &mut Band<'_, Rgb565, Rows<MsbFirst>>| {
                draw(band);
                Ok::<(), Infallible>(())
            };
            bands.draw(scene, |band| band.show(&mut panel)).unwrap();
            panel.0
        };
        let plain = drawn(&|band| {
            filled.draw_on(band).unwrap();
            blended.draw_on(band).unwrap();
            text.draw(band).unwrap();
        });
        let with_bounds = drawn(&|band| {
            bounded.draw_on(band).unwrap();
            bounded_blended.draw_on(band).unwrap();
            bounded_text.draw(band).unwrap();
        });
        prop_assert!(plain == with_bounds);
        // Where the bounds are, nobody looks at the drawing itself.
        let nowhere = PixelRect { rows: -9..0, columns: 0..61 };
        let hidden = Bounded::within(filled, nowhere);
        let nothing = drawn(&|band| hidden.draw_on(band).unwrap());
        prop_assert!(nothing.iter().all(|pixel| *pixel == Rgb565::BLACK));
    }

    #[test]
    fn values_in_bands(scene in scenes(), rows in 1..60_u32) {
        let mut frame = Framebuffer::<Rgb565, Values, _>::new(vec![Rgb565::BLACK; 61 * 48], SCREEN).unwrap();
        scene.draw(&mut frame).unwrap();
        let buffer = vec![Rgb565::WHITE; 61 * rows as usize];
        let mut bands = Bands::<Rgb565, Values, _, 1>::new([buffer], SCREEN, Rgb565::BLACK).unwrap();
        let mut panel = Panel(vec![Rgb565::WHITE; 61 * 48]);
        bands.draw(|band| scene.draw(band), |band| band.show(&mut panel)).unwrap();
        prop_assert!(panel.0 == frame.units());
    }

    /// What has changed is redrawn, to whole bytes, and nothing else is touched: the screen shows the new scene wherever it was
    /// told to, and the old one elsewhere.
    #[test]
    fn damage_is_redrawn(
        (before, after) in (scenes(), scenes()),
        changed in vec(((-20..70_i32, -20..60_i32), (0..40_u32, 0..30_u32)), 0..12),
        units in 61..2000_usize,
        fails_at in 0..9_usize,
    ) {
        let mut bands = Bands::<Gray4, Rows<MsbFirst>, _, 1>::new([vec![0; units]], SCREEN, Gray4::BLACK).unwrap();
        let mut old = Panel(vec![Gray4::WHITE; 61 * 48]);
        bands.draw(|band| before.draw(band), |band| band.show(&mut old)).unwrap();
        let mut new = old.clone();
        bands.draw(|band| after.draw(band), |band| band.show(&mut new)).unwrap();

        let mut damage = Damage::<3>::new(SCREEN);
        let changed: Vec<_> =
            changed.iter().map(|&(at, size)| Rectangle::new(at.into(), size.into())).collect();
        for area in &changed {
            damage.add(area);
            prop_assert!(damage.areas().len() <= 3);
        }
        let areas = damage.areas().to_vec();
        for area in &changed {
            for point in area.points().filter(|point| Rectangle::new(Point::zero(), SCREEN).contains(*point)) {
                prop_assert!(areas.iter().any(|area| area.contains(point)), "{} is forgotten", point);
            }
        }
        let mut panel = old.clone();
        let mut flushes = 0;
        let mut redraw = |damage: &mut Damage<3>, panel: &mut Panel<Gray4>| damage.redraw(|area| {
            bands.draw_area(area, |band| after.draw(band), |band| {
                flushes += 1;
                if flushes == fails_at { return Err("the bus is gone") }
                band.show(panel).unwrap();
                Ok(())
            })
        });
        // The error comes once; then all is drawn that was not.
        if redraw(&mut damage, &mut panel).is_err() {
            prop_assert!(!damage.is_empty());
            prop_assert_eq!(redraw(&mut damage, &mut panel), Ok(()));
        }
        prop_assert!(damage.is_empty());
        for (index, point) in Rectangle::new(Point::zero(), SCREEN).points().enumerate() {
            // Two pixels share a byte.
            let other = Point::new(point.x ^ 1, point.y);
            let expected = if areas.iter().any(|area| area.contains(point) || area.contains(other)) { &new } else { &old };
            prop_assert_eq!(panel.0[index], expected.0[index], "{}", point);
        }
    }
}

fn scene() -> Scene {
    Scene {
        corners: [Point::new(3, 5), Point::new(58, 20), Point::new(20, 45)],
        centre: Point::new(30, 22),
        radius: 13,
        colours: [0xF800, 0x07FF, 0xFFE0, 0x1234],
    }
}

type Packed = Rows<MsbFirst>;

/// An error in the middle comes back at once, whoever meets it, and the next frame is complete.
#[test]
fn an_error_ends_its_frame_only() {
    let expected = whole::<Rgb565, Packed>(&scene(), Rgb565::BLACK);
    let mut bands = Bands::<Rgb565, Packed, _, 2>::new([[0; 61 * 2 * 5]; 2], SCREEN, Rgb565::BLACK).unwrap();
    for fails_at in 0..10 {
        let mut count = 0;
        let mut sent = Vec::new();
        let failed = bands.draw(
            |band| scene().draw(band),
            |band| {
                if count == fails_at {
                    return Err(count);
                }
                count += 1;
                sent.extend_from_slice(band.units());
                Ok(())
            },
        );
        assert_eq!(failed, Err(FrameError::Flush(fails_at)));
        assert_eq!(sent, expected[..fails_at * 61 * 2 * 5]);

        let count = Cell::new(0);
        let scene_fails = async |_: &Band<'_, Rgb565, Packed>| {
            yield_once().await;
            Ok::<(), Infallible>(())
        };
        let frame = bands.draw_async(
            |_| {
                count.set(count.get() + 1);
                if count.get() > fails_at { Err("the scene") } else { Ok(()) }
            },
            scene_fails,
        );
        assert_eq!(run(pin!(frame), 1000), Some(Err(FrameError::Scene("the scene"))));

        let (bus, flushed) = (Bus::new(1), Cell::new(0));
        let frame = bands.draw_async(
            |band| scene().draw(band),
            async |band| {
                if flushed.replace(flushed.get() + 1) == fails_at {
                    yield_once().await;
                    return Err("the bus is gone");
                }
                let Ok(()) = bus.send(band.units()).await;
                Ok(())
            },
        );
        assert_eq!(run(pin!(frame), 1000), Some(Err(FrameError::Flush("the bus is gone"))));
        assert_eq!(flushed.get(), fails_at + 1, "nothing is sent after an error");
        assert!(bus.sent.take() == expected[..fails_at * 61 * 2 * 5]);

        let dma = Dma { fails_at: Some(fails_at + 1), ..Dma::default() };
        let (dma, failed) = bands.draw_by_transfers(dma, |band| scene().draw(band));
        assert_eq!(failed, Err(FrameError::Flush("the bus is gone")));
        assert_eq!(dma.sent, expected[..fails_at * 61 * 2 * 5]);

        let (dma, drawn) = bands.draw_by_transfers(Dma::default(), |band| scene().draw(band));
        assert_eq!(drawn, Ok(()));
        assert!(dma.sent == expected, "after an error in band {fails_at}");
    }
}

/// With two buffers, the next band is drawn before a flush has ended; with one, it is not.
#[test]
fn drawing_and_sending_overlap() {
    fn order<const N: usize>(buffers: [[u8; 610]; N]) -> String {
        let log = RefCell::new(String::new());
        let mut bands = Bands::<Rgb565, Packed, _, N>::new(buffers, Size::new(61, 15), Rgb565::BLACK).unwrap();
        let frame = bands.draw_async(
            |band| {
                log.borrow_mut().push_str(&format!("d{} ", band.bounding_box().top_left.y / 5));
                Ok::<(), Infallible>(())
            },
            async |band| {
                log.borrow_mut().push_str(&format!("s{} ", band.bounding_box().top_left.y / 5));
                yield_once().await;
                log.borrow_mut().push_str("e ");
                Ok::<(), Infallible>(())
            },
        );
        assert_eq!(run(pin!(frame), 1000), Some(Ok(())));
        log.into_inner()
    }
    assert_eq!(order([[0; 610]]), "d0 s0 e d1 s1 e d2 s2 e ");
    assert_eq!(order([[0; 610]; 2]), "d0 s0 d1 e s1 d2 e s2 e ");
}

/// A frame that is dropped after any number of polls loses nothing of the next.
#[test]
fn a_dropped_flush_ends_its_frame_only() {
    let expected = whole::<Rgb565, Packed>(&scene(), Rgb565::BLACK);
    let mut bands = Bands::<Rgb565, Packed, _, 2>::new([[0; 61 * 2 * 7]; 2], SCREEN, Rgb565::BLACK).unwrap();
    let mut polls = 0;
    loop {
        let bus = Bus::new(2);
        let ended = {
            let frame = bands.draw_async(|band| scene().draw(band), async |band| bus.send(band.units()).await);
            run(pin!(frame), polls).is_some()
        };
        assert!(expected.starts_with(&bus.sent.take()));
        let frame = bands.draw_async(|band| scene().draw(band), async |band| bus.send(band.units()).await);
        assert_eq!(run(pin!(frame), 1000), Some(Ok(())));
        assert!(bus.sent.take() == expected, "after {polls} polls");
        if ended {
            break;
        }
        polls += 1;
    }
    assert!(polls > 7);
}

/// What is forgotten keeps its buffer; the frames after it are drawn in the other, and without any there is an error.
#[test]
fn a_forgotten_transfer_keeps_its_buffer() {
    let expected = whole::<Rgb565, Packed>(&scene(), Rgb565::BLACK);
    let (mut first, mut second) = ([0; 61 * 2 * 5], [0; 61 * 2 * 5]);
    let mut bands =
        Bands::<Rgb565, Packed, _, 2>::new([&mut first[..], &mut second[..]], SCREEN, Rgb565::BLACK).unwrap();
    for left in [1, 0] {
        let buffer = bands.take_buffer().unwrap();
        buffer.fill(0xA5);
        let area = Rectangle::new(Point::zero(), Size::new(61, 5));
        forget(Dma::default().start(&area, buffer, 610));
        let (dma, drawn) = bands.draw_by_transfers(Dma::default(), |band| scene().draw(band));
        if left == 1 {
            assert_eq!(drawn, Ok(()));
            assert!(dma.sent == expected);
        } else {
            assert_eq!(drawn, Err(FrameError::NoBuffer));
            assert_eq!(dma.starts, 0);
        }
    }
    let nothing = |_: &Band<'_, Rgb565, Packed>| Ok::<(), Infallible>(());
    assert_eq!(bands.draw(|band| scene().draw(band), nothing), Err(FrameError::NoBuffer));
    let frame = bands.draw_async(|band| scene().draw(band), async |_| Ok::<(), Infallible>(()));
    assert_eq!(run(pin!(frame), 1), Some(Err(FrameError::NoBuffer)));
    drop(bands);
    // One was drawn in after the other was lost; the one that was lost first still holds what it was lost with.
    assert_eq!(second, [0xA5; 610]);
}

#[test]
fn what_cannot_be_is_refused_with_the_numbers() {
    let of = |bytes: usize, screen: Size| {
        Bands::<BinaryColor, Pages<LsbFirst>, _, 1>::new([vec![0; bytes]], screen, BinaryColor::Off)
    };
    let screen = Size::new(128, 64);
    assert_eq!(of(127, screen).unwrap_err(), FramebufferError::BufferTooSmall { needed: 128, available: 127 });
    assert_eq!(of(300, Size::new(0, 64)).unwrap_err(), FramebufferError::Empty { width: 0, height: 64 });
    assert_eq!(of(300, Size::new(128, 0)).unwrap_err(), FramebufferError::Empty { width: 128, height: 0 });
    assert_eq!(of(300, Size::new(128, 60)).unwrap_err(), FramebufferError::PartialPage { height: 60, page_rows: 8 });
    assert_eq!(of(300, screen).unwrap().rows(), 16);
    let rows = |rows| of(300, screen).unwrap().with_rows(rows).map(|bands| bands.rows());
    assert_eq!(rows(8), Ok(8));
    assert_eq!(rows(12), Err(FramebufferError::PartialPage { height: 12, page_rows: 8 }));
    assert_eq!(rows(24), Err(FramebufferError::BufferTooSmall { needed: 384, available: 300 }));
    assert_eq!(rows(0), Err(FramebufferError::Empty { width: 128, height: 0 }));
    let mut bands = of(300, screen).unwrap().with_rows(16).unwrap();
    let buffer = bands.take_buffer().unwrap();
    assert_eq!(bands.give_back(vec![0; 255]).unwrap_err().len(), 255);
    assert_eq!(bands.give_back(buffer), Ok(()));
    assert_eq!(bands.give_back(vec![0; 256]).unwrap_err().len(), 256);
}

/// Damage that lies anywhere, or nowhere.
#[test]
fn damage_at_the_ends_of_the_range() {
    let mut damage = Damage::<1>::new(SCREEN);
    for (x, y, size) in [(i32::MAX, 0, 5), (i32::MIN, i32::MIN, u32::MAX / 4), (61, 0, 3), (0, -3, 3), (5, 5, 0)] {
        damage.add(&Rectangle::new(Point::new(x, y), Size::new(size, size)));
    }
    assert!(damage.is_empty());
    damage.add(&Rectangle::new(Point::new(i32::MIN, -1), Size::new(u32::MAX, u32::MAX)));
    assert_eq!(damage.areas(), [Rectangle::new(Point::zero(), SCREEN)]);
    damage.add_all();
    assert_eq!(damage.areas().len(), 1);
}
