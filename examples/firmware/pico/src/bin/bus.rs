//! Draws every picture by embedded-graphics and by this crate on the display itself, and the dashboard by way of a framebuffer, of
//! bands, and of bands that DMA sends. What goes over the bus is counted by whoever listens: `run.mjs`.

#![no_std]
#![no_main]
#![allow(missing_docs, reason = "a program")]

use core::{
    convert::Infallible,
    future::Future,
    pin::pin,
    task::{Context, Poll, Waker},
};

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use embedded_hal::{digital::OutputPin as _, spi::SpiBus as _};
use panic_halt as _;
use rp2040_hal::{
    dma::single_buffer::{Config, Transfer as Single},
    entry,
    gpio::bank0::{Gpio17, Gpio20},
};
use spanfill::{Bands, Framebuffer, MsbFirst, Rows, Transfer, Transmit, buffer_size};
use spanfill_pico::{
    BACKGROUND, Picture, SCREEN, board,
    board::{Bus, Channel, Output, say},
    dashboard::{self, Dashboard},
};

type Packed = Rows<MsbFirst>;
type Frame = Framebuffer<Rgb565, Packed, [u8; buffer_size::<Rgb565, Packed>(320, 240)]>;

const ROWS: u32 = 8;
type Band = [u8; buffer_size::<Rgb565, Packed>(320, ROWS)];

static mut FRAME: Frame = Frame::blank::<320, 240>();

#[entry]
fn main() -> ! {
    let driver = cortex_m::singleton!(: [u8; 512] = [0; 512]).expect("taken once");
    #[allow(
        unsafe_code,
        reason = "taken here, once; the frame is larger than the stack that a singleton's would pass through"
    )]
    let frame = unsafe { &mut *(&raw mut FRAME) };
    let first = cortex_m::singleton!(: Band = [0; 5120]).expect("taken once");
    let second = cortex_m::singleton!(: Band = [0; 5120]).expect("taken once");

    let board::Board { bus, mut select, mut command, mut reset, mut timer, mut words, channel } = board::start();
    let words = &mut words;
    let (dashboard, moved) = (Dashboard::new(62), Dashboard::new(65));
    let mut lcd = board::lcd(&bus, &mut select, &mut command, &mut reset, &mut timer, driver);
    for picture in Picture::ALL {
        let _ = lcd.clear(BACKGROUND);
        say(words, "begin embedded-graphics", picture.name());
        let drawn = picture.draw_by_embedded_graphics(&mut lcd, &dashboard);
        say(words, if drawn.is_some() { "end" } else { "skip" }, "");
        let _ = lcd.clear(BACKGROUND);
        say(words, "begin direct", picture.name());
        let _ = picture.draw(&mut lcd, &dashboard);
        say(words, "end", "");
    }

    for picture in [Picture::SmoothStar, Picture::Dashboard] {
        let _ = lcd.clear(BACKGROUND);
        say(words, "begin framebuffer", picture.name());
        let Ok(()) = frame.clear(BACKGROUND);
        let Ok(()) = picture.draw(frame, &dashboard);
        let _ = frame.show(Point::zero(), &mut lcd);
        say(words, "end", "");
    }

    {
        let mut bands =
            Bands::<Rgb565, Packed, _, 1>::new([&mut first[..]], SCREEN, BACKGROUND).expect("a line at least");
        for picture in Picture::ALL {
            let _ = lcd.clear(BACKGROUND);
            say(words, "begin bands", picture.name());
            let _ = bands.draw(|band| picture.draw(band, &dashboard), |band| band.show(&mut lcd));
            say(words, "end", "");
        }
        // Only the needle moves: what it covered and what it covers.
        say(words, "begin damage", "dashboard-moved");
        let mut damage = spanfill::Damage::<4>::new(SCREEN);
        for value in [62, 65] {
            damage.add(&spanfill::Fill::filled(dashboard::needle_shape(value), BACKGROUND));
        }
        let redrawn = damage
            .redraw(|area| bands.draw_area(area, |band| dashboard::draw(band, &moved), |band| band.show(&mut lcd)));
        let _ = redrawn;
        say(words, "end", "");
        let _ = lcd.clear(BACKGROUND);
    }

    // The bus without its driver, for DMA.
    drop(lcd);
    let panel = Panel { bus: bus.into_inner(), select, command, channel };
    let mut bands = Bands::<Rgb565, Packed, &'static mut Band, 2>::new([first, second], SCREEN, BACKGROUND)
        .expect("a line at least");
    say(words, "begin dma", "dashboard");
    let (panel, _) = bands.draw_by_transfers(panel, |band| Picture::Dashboard.draw(band, &dashboard));
    say(words, "end", "");

    // The same sender, as a future that is done when DMA is.
    let mut panel = Some(panel);
    let mut spare = cortex_m::singleton!(: Band = [0; 5120]);
    say(words, "begin async", "dashboard");
    let mut frame = pin!(bands.draw_async(
        |band| Picture::Dashboard.draw(band, &dashboard),
        async |band| {
            let (Some(sender), Some(buffer)) = (panel.take(), spare.take()) else { return Ok::<(), Infallible>(()) };
            buffer.copy_from_slice(band.units());
            let running = sender.start(&band.bounding_box(), buffer, buffer_size::<Rgb565, Packed>(320, ROWS));
            core::future::poll_fn(|_| if running.0.is_done() { Poll::Ready(()) } else { Poll::Pending }).await;
            let (sender, buffer, _) = running.wait();
            (panel, spare) = (Some(sender), Some(buffer));
            Ok(())
        },
    ));
    let mut context = Context::from_waker(Waker::noop());
    while frame.as_mut().poll(&mut context).is_pending() {}
    say(words, "end", "");
    say(words, "done", "");
    loop {
        cortex_m::asm::wfi();
    }
}

/// What it takes to send by DMA.
struct Panel {
    bus: Bus,
    select: Output<Gpio17>,
    command: Output<Gpio20>,
    channel: Channel,
}

impl Panel {
    fn send(&mut self, command: u8, arguments: &[u8]) {
        let Ok(()) = self.command.set_low();
        let Ok(()) = self.bus.write(&[command]);
        let Ok(()) = self.bus.flush();
        let Ok(()) = self.command.set_high();
        let Ok(()) = self.bus.write(arguments);
        let Ok(()) = self.bus.flush();
    }
}

/// The transfer, and the two pins that it needs not.
struct Running(Single<Channel, &'static mut Band, Bus>, Output<Gpio17>, Output<Gpio20>);

impl Transmit<&'static mut Band> for Panel {
    type Transfer = Running;

    fn start(mut self, area: &Rectangle, buffer: &'static mut Band, length: usize) -> Running {
        // The screen's rows are a multiple of the band's.
        assert_eq!(length, buffer.len());
        let Ok(()) = self.select.set_low();
        let ends = |start: i32, length: u32| {
            let [first, second] = (start as u16).to_be_bytes();
            let [third, fourth] = (start as u16 + length as u16 - 1).to_be_bytes();
            [first, second, third, fourth]
        };
        self.send(0x2A, &ends(area.top_left.x, area.size.width));
        self.send(0x2B, &ends(area.top_left.y, area.size.height));
        self.send(0x2C, &[]);
        Running(Config::new(self.channel, buffer, self.bus).start(), self.select, self.command)
    }
}

impl Transfer<&'static mut Band> for Running {
    type Sender = Panel;
    type Error = Infallible;

    fn wait(self) -> (Panel, &'static mut Band, Result<(), Infallible>) {
        let Self(transfer, mut select, command) = self;
        let (channel, buffer, mut bus) = transfer.wait();
        let Ok(()) = bus.flush();
        let Ok(()) = select.set_high();
        (Panel { bus, select, command, channel }, buffer, Ok(()))
    }
}
