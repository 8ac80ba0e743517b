//! The unmodified `lcd-async` driver, an SPI bus that somebody listens to and that makes everybody wait, and bands: the panel shows
//! what a framebuffer holds, and pixels go over once.

use std::{
    cell::RefCell,
    convert::Infallible,
    future::{Future, poll_fn},
    pin::pin,
    rc::Rc,
    task::{Context, Poll, Waker},
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

async fn wait() {
    let mut waited = false;
    poll_fn(|_| if std::mem::replace(&mut waited, true) { Poll::Ready(()) } else { Poll::Pending }).await;
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

#[test]
fn bands_by_an_async_driver() {
    let mut whole =
        Framebuffer::<Rgb565, Packed, _>::new(vec![0; buffer_size::<Rgb565, Packed>(320, 240)], SCREEN).unwrap();
    scene(&mut whole).unwrap();

    let panel = Panel { pixels: vec![0x11; 2 * 320 * 240], ..Panel::default() };
    let bus = Bus(Rc::new(RefCell::new(panel)));
    block_on(async {
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
    });
    let panel = bus.0.borrow();
    assert!(panel.pixels == whole.units());
    assert_eq!(panel.pixel_bytes, 2 * 320 * 240);
}
