//! The unmodified `ssd1306` driver, an I2C bus that somebody listens to, and the crate's pages: the display's memory holds what a
//! framebuffer holds, and what the driver's own buffer shows.

use std::{cell::RefCell, convert::Infallible, rc::Rc};

use embedded_graphics::{
    mono_font::{MonoTextStyle, ascii::FONT_6X10},
    pixelcolor::BinaryColor,
    prelude::*,
    primitives::Rectangle,
    text::Text,
};
use embedded_hal::i2c::{ErrorType, I2c, Operation};
use spanfill::{Band, Bands, Circle, Damage, Dither, Framebuffer, LsbFirst, Pages, Triangle, buffer_size, prelude::*};
use ssd1306::{I2CDisplayInterface, Ssd1306, prelude::*};

/// The display's side of the bus: its memory, and where the next byte goes.
#[derive(Debug)]
struct Panel {
    memory: [[u8; 128]; 8],
    columns: [u8; 2],
    pages: [u8; 2],
    at: [u8; 2],
    data_bytes: usize,
}

impl Panel {
    fn command(&mut self, bytes: &[u8]) {
        match *bytes {
            [0x21, first, last] => (self.columns, self.at[0]) = ([first, last], first),
            [0x22, first, last] => (self.pages, self.at[1]) = ([first, last], first),
            // Horizontal addressing.
            [0x20, mode] => assert_eq!(mode, 0),
            _ => {}
        }
    }

    fn data(&mut self, byte: u8) {
        let [column, page] = self.at;
        self.memory[usize::from(page)][usize::from(column)] = byte;
        self.data_bytes += 1;
        self.at[0] += 1;
        if column == self.columns[1] {
            self.at[0] = self.columns[0];
            self.at[1] = if page == self.pages[1] { self.pages[0] } else { page + 1 };
        }
    }
}

#[derive(Debug, Clone)]
struct Bus(Rc<RefCell<Panel>>);

impl ErrorType for Bus {
    type Error = Infallible;
}

impl I2c for Bus {
    fn transaction(&mut self, address: u8, operations: &mut [Operation<'_>]) -> Result<(), Infallible> {
        assert_eq!(address, 0x3C);
        for operation in operations {
            let Operation::Write(bytes) = operation else { panic!("the display is only written to") };
            match bytes {
                [0x00, command @ ..] => self.0.borrow_mut().command(command),
                [0x40, data @ ..] => data.iter().for_each(|byte| self.0.borrow_mut().data(*byte)),
                _ => panic!("neither a command nor data: {bytes:02x?}"),
            }
        }
        Ok(())
    }
}

type Packed = Pages<LsbFirst>;
type Display = Ssd1306<I2CInterface<Bus>, DisplaySize128x64, ssd1306::mode::BasicMode>;

const SCREEN: Size = Size::new(128, 64);

fn start() -> (Display, Bus) {
    let panel = Panel { memory: [[0xEE; 128]; 8], columns: [0, 127], pages: [0, 7], at: [0, 0], data_bytes: 0 };
    let bus = Bus(Rc::new(RefCell::new(panel)));
    let interface = I2CDisplayInterface::new(bus.clone());
    let mut display = Ssd1306::new(interface, DisplaySize128x64, DisplayRotation::Rotate0);
    display.init_with_addr_mode(ssd1306::command::AddrMode::Horizontal).unwrap();
    (display, bus)
}

fn scene<D: DrawTarget<Color = BinaryColor>>(target: &mut D, angle: i32) -> Result<(), D::Error> {
    Circle::new(Point::new(40, 32), 28).filled(BinaryColor::On).draw(target)?;
    let needle = Triangle::new(Point::new(40 + angle, 8), Point::new(44, 40), Point::new(36, 40));
    needle.filled(BinaryColor::Off).draw(target)?;
    Circle::new(Point::new(100, 20), 15.5).antialiased(BinaryColor::On, Dither).opacity(150).draw(target)?;
    Text::new("pages", Point::new(80, 54), MonoTextStyle::new(&FONT_6X10, BinaryColor::On)).draw(target)?;
    Ok(())
}

/// Sends what a band holds.
fn flush(display: &mut Display, band: &Band<'_, BinaryColor, Packed>) -> Result<(), Infallible> {
    let Rectangle { top_left, size } = band.bounding_box();
    let (x, y) = (top_left.x as u8, top_left.y as u8);
    display.set_draw_area((x, y), (x + size.width as u8, y + size.height as u8)).unwrap();
    display.draw(band.units()).unwrap();
    Ok(())
}

fn whole(angle: i32) -> [u8; 1024] {
    let mut frame =
        Framebuffer::<BinaryColor, Packed, [u8; buffer_size::<BinaryColor, Packed>(128, 64)]>::blank::<128, 64>();
    scene(&mut frame, angle).unwrap();
    frame.into_storage()
}

#[test]
fn a_framebuffer_goes_over_as_it_is() {
    let (mut display, bus) = start();
    display.set_draw_area((0, 0), (128, 64)).unwrap();
    display.draw(&whole(5)).unwrap();
    assert_eq!(bus.0.borrow().memory.as_flattened(), whole(5));

    // The driver's own buffer, drawn on as any display, shows the same.
    let (display, by_driver) = start();
    let mut display = display.into_buffered_graphics_mode();
    display.clear(BinaryColor::Off).unwrap();
    scene(&mut display, 5).unwrap();
    display.flush().unwrap();
    assert_eq!(by_driver.0.borrow().memory, bus.0.borrow().memory);
}

#[test]
fn bands_of_any_number_of_pages_show_the_whole() {
    for pages in 1..=8 {
        let (mut display, bus) = start();
        let buffer = vec![0x55; 128 * pages];
        let mut bands = Bands::<BinaryColor, Packed, _, 1>::new([buffer], SCREEN, BinaryColor::Off).unwrap();
        assert_eq!(bands.rows(), 8 * pages as u32);
        bands.draw(|band| scene(band, 5), |band| flush(&mut display, band)).unwrap();
        assert_eq!(bus.0.borrow().memory.as_flattened(), whole(5), "bands of {pages} pages");
        assert_eq!(bus.0.borrow().data_bytes, 1024);
    }
}

/// What has changed goes over in whole pages, and no more of it.
#[test]
fn a_moved_needle_sends_its_pages_only() {
    let (mut display, bus) = start();
    let mut bands = Bands::<BinaryColor, Packed, _, 1>::new([[0; 256]], SCREEN, BinaryColor::Off).unwrap();
    bands.draw(|band| scene(band, 5), |band| flush(&mut display, band)).unwrap();
    bus.0.borrow_mut().data_bytes = 0;
    let mut damage = Damage::<2>::new(SCREEN);
    for x in [5, 8] {
        damage.add(&Rectangle::new(Point::new(36, 8), Size::new(x + 5, 33)));
    }
    damage.redraw(|area| bands.draw_area(area, |band| scene(band, 8), |band| flush(&mut display, band))).unwrap();
    assert_eq!(bus.0.borrow().memory.as_flattened(), whole(8));
    // Rows 8 to 40 lie in pages 1 to 5.
    assert_eq!(bus.0.borrow().data_bytes, 13 * 5);
}
