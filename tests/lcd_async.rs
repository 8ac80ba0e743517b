//! The unmodified `lcd-async` driver, an SPI bus that somebody listens to and that makes everybody wait, and bands: the panel shows
//! what a framebuffer holds, and pixels go over once.

use std::{
    cell::{Cell, RefCell},
    convert::Infallible,
    future::{Future, poll_fn},
    pin::pin,
    rc::Rc,
    sync::mpsc::{Sender, channel},
    task::{Context, Poll, Waker},
    thread,
    time::Duration,
};

use embedded_graphics::{
    pixelcolor::{Rgb565, raw::RawU16},
    prelude::*,
    primitives::Rectangle,
};
use embedded_hal::{
    digital::{ErrorType as PinError, OutputPin},
    spi::{ErrorType as SpiError, Operation},
};
use embedded_hal_async::{delay::DelayNs, spi::SpiDevice};
use lcd_async::{
    Builder,
    interface::SpiInterface,
    models::ILI9341Rgb565,
    options::{Orientation, Rotation},
};
use spanfill::{Bands, Circle, Framebuffer, InPlace, MsbFirst, Rows, buffer_size, prelude::*};

const SCREEN: Size = Size::new(320, 240);

type Packed = Rows<MsbFirst>;

/// The panel's side of the bus.
#[derive(Default)]
struct Panel {
    is_data: bool,
    command: u8,
    arguments: Vec<u8>,
    columns: [u16; 2],
    rows: [u16; 2],
    pixels: Vec<u8>,
    /// How many bytes of pixels the window has got.
    received: usize,
    pixel_bytes: usize,
}

impl Panel {
    fn receive(&mut self, byte: u8) {
        if !self.is_data {
            (self.command, self.received) = (byte, 0);
            self.arguments.clear();
            return;
        }
        match self.command {
            0x2A | 0x2B => {
                self.arguments.push(byte);
                if let [a, b, c, d] = self.arguments[..] {
                    let range = [u16::from_be_bytes([a, b]), u16::from_be_bytes([c, d])];
                    if self.command == 0x2A { self.columns = range } else { self.rows = range }
                }
            }
            0x2C => {
                let width = usize::from(self.columns[1] - self.columns[0] + 1);
                let (x, y) = (self.received / 2 % width, self.received / 2 / width);
                let (x, y) = (usize::from(self.columns[0]) + x, usize::from(self.rows[0]) + y);
                assert!(y <= usize::from(self.rows[1]), "more pixels than the window has");
                self.pixels[2 * (320 * y + x) + self.received % 2] = byte;
                self.received += 1;
                self.pixel_bytes += 1;
            }
            _ => {}
        }
    }
}

#[derive(Clone)]
struct Bus(Rc<RefCell<Panel>>);

impl SpiError for Bus {
    type Error = Infallible;
}

impl PinError for Bus {
    type Error = Infallible;
}

impl OutputPin for Bus {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().is_data = false;
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.0.borrow_mut().is_data = true;
        Ok(())
    }
}

impl SpiDevice for Bus {
    async fn transaction(&mut self, operations: &mut [Operation<'_, u8>]) -> Result<(), Infallible> {
        for operation in operations {
            let Operation::Write(bytes) = operation else { panic!("the panel is only written to") };
            wait().await;
            bytes.iter().for_each(|byte| self.0.borrow_mut().receive(*byte));
        }
        Ok(())
    }
}

struct NoDelay;

impl DelayNs for NoDelay {
    async fn delay_ns(&mut self, _: u32) {}
}

/// Until the executor has had a look at everybody else.
async fn wait() {
    let mut waited = false;
    poll_fn(|context| {
        context.waker().wake_by_ref();
        if std::mem::replace(&mut waited, true) { Poll::Ready(()) } else { Poll::Pending }
    })
    .await;
}

fn block_on<T>(future: impl Future<Output = T>) -> T {
    let mut future = pin!(future);
    loop {
        if let Poll::Ready(output) = future.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            return output;
        }
    }
}

fn scene<D>(target: &mut D) -> Result<(), Infallible>
where
    D: spanfill::Canvas<Color = Rgb565, Error = Infallible>,
    InPlace: spanfill::Blend<D>,
{
    Circle::new(Point::new(150, 120), 100).filled(Rgb565::CSS_DARK_ORANGE).draw_on(target)?;
    Circle::new(Point::new(220, 90), 60).antialiased(Rgb565::CSS_STEEL_BLUE, InPlace).opacity(170).draw_on(target)
}

/// The scene in bands, over the bus; what the panel shows then, and how many bytes of pixels it was sent.
async fn show() -> (Vec<u8>, usize) {
    let panel = Panel { pixels: vec![0x11; 2 * 320 * 240], ..Panel::default() };
    let bus = Bus(Rc::new(RefCell::new(panel)));
    let mut lcd = Builder::new(ILI9341Rgb565, SpiInterface::new(bus.clone(), bus.clone()))
        .reset_pin(bus.clone())
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .init(&mut NoDelay)
        .await
        .unwrap_or_else(|_| panic!("the panel answers nothing"));
    // As after a real reset line.
    bus.0.borrow_mut().pixel_bytes = 0;
    let mut bands = Bands::<Rgb565, Packed, _, 2>::new([[0; 640 * 16]; 2], SCREEN, RawU16::new(0).into()).unwrap();
    bands
        .draw_async(
            |band| scene(band),
            async |band| {
                let Rectangle { top_left, size } = band.bounding_box();
                let (x, y) = (top_left.x as u16, top_left.y as u16);
                lcd.show_raw_data(x, y, size.width as u16, size.height as u16, band.units()).await
            },
        )
        .await
        .unwrap_or_else(|_| panic!("the bus takes everything"));
    let mut panel = bus.0.borrow_mut();
    (std::mem::take(&mut panel.pixels), panel.pixel_bytes)
}

fn whole() -> Vec<u8> {
    let mut whole =
        Framebuffer::<Rgb565, Packed, _>::new(vec![0; buffer_size::<Rgb565, Packed>(320, 240)], SCREEN).unwrap();
    scene(&mut whole).unwrap();
    whole.units().to_vec()
}

#[test]
fn bands_by_an_async_driver() {
    let (pixels, pixel_bytes) = block_on(show());
    assert!(pixels == whole());
    assert_eq!(pixel_bytes, 2 * 320 * 240);
}

#[embassy_executor::task]
async fn show_and_tell(shown: Sender<(Vec<u8>, usize, usize)>, turns: Rc<Cell<usize>>) {
    let (pixels, pixel_bytes) = show().await;
    shown.send((pixels, pixel_bytes, turns.get())).expect("the test waits");
}

#[embassy_executor::task]
async fn count_turns(turns: Rc<Cell<usize>>) {
    loop {
        turns.set(turns.get() + 1);
        wait().await;
    }
}

/// As a task of embassy's executor, with another that has its turn at every transfer.
#[test]
fn bands_as_a_task_of_embassy() {
    let (sender, shown) = channel();
    thread::spawn(move || {
        let executor = Box::leak(Box::new(embassy_executor::Executor::new()));
        let turns = Rc::new(Cell::new(0));
        executor.run(|spawner| {
            spawner.spawn(show_and_tell(sender, turns.clone()).expect("there is room for one"));
            spawner.spawn(count_turns(turns).expect("there is room for one"));
        });
    });
    let (pixels, pixel_bytes, turns) = shown.recv_timeout(Duration::from_secs(60)).expect("the task ends");
    assert!(pixels == whole());
    assert_eq!(pixel_bytes, 2 * 320 * 240);
    // Of 15 bands, each transfer waits at least once.
    assert!(turns >= 15, "{turns}");
}
