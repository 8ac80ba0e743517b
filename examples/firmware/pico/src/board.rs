//! The board: a Pico with an ILI9341 on SPI0, and words on UART0.

use core::{cell::RefCell, fmt::Write as _};

use embedded_hal::{digital::OutputPin as _, spi::MODE_0};
use embedded_hal_bus::spi::{NoDelay, RefCellDevice};
use mipidsi::{
    Builder, Display,
    interface::SpiInterface,
    models::ILI9341Rgb565,
    options::{ColorOrder, Orientation, Rotation},
};
use rp2040_hal::{
    Clock, Sio, Spi, Timer, Watchdog,
    clocks::init_clocks_and_plls,
    dma::{self, DMAExt as _},
    fugit::RateExtU32 as _,
    gpio::{
        FunctionSioOutput, FunctionSpi, FunctionUart, Pin, Pins, PullDown,
        bank0::{Gpio0, Gpio1, Gpio17, Gpio18, Gpio19, Gpio20, Gpio21},
    },
    pac,
    spi::Enabled,
    uart::{UartConfig, UartPeripheral},
};

pub type Bus = Spi<Enabled, pac::SPI0, (Pin<Gpio19, FunctionSpi, PullDown>, Pin<Gpio18, FunctionSpi, PullDown>), 8>;
pub type Output<G> = Pin<G, FunctionSioOutput, PullDown>;
type Device<'b> = RefCellDevice<'b, Bus, &'b mut Output<Gpio17>, NoDelay>;
pub type Lcd<'b> = Display<SpiInterface<'b, Device<'b>, &'b mut Output<Gpio20>>, ILI9341Rgb565, &'b mut Output<Gpio21>>;
pub type Words = UartPeripheral<
    rp2040_hal::uart::Enabled,
    pac::UART0,
    (Pin<Gpio0, FunctionUart, PullDown>, Pin<Gpio1, FunctionUart, PullDown>),
>;
pub type Channel = dma::Channel<dma::CH0>;

/// The second stage of the boot loader, without which a real board does not start.
#[allow(unsafe_code, reason = "a section's name")]
#[unsafe(link_section = ".boot2")]
#[used]
static BOOT2: [u8; 256] = rp2040_boot2::BOOT_LOADER_GENERIC_03H;

/// All that there is on the board.
pub struct Board {
    pub bus: RefCell<Bus>,
    pub select: Output<Gpio17>,
    pub command: Output<Gpio20>,
    pub reset: Output<Gpio21>,
    pub timer: Timer,
    pub words: Words,
    pub channel: Channel,
}

/// Starts clocks and bus.
pub fn start() -> Board {
    let mut pac = pac::Peripherals::take().expect("taken once");
    let mut watchdog = Watchdog::new(pac.WATCHDOG);
    let clocks = init_clocks_and_plls(
        12_000_000,
        pac.XOSC,
        pac.CLOCKS,
        pac.PLL_SYS,
        pac.PLL_USB,
        &mut pac.RESETS,
        &mut watchdog,
    )
    .ok()
    .expect("the crystal swings");
    let sio = Sio::new(pac.SIO);
    let pins = Pins::new(pac.IO_BANK0, pac.PADS_BANK0, sio.gpio_bank0, &mut pac.RESETS);

    let words = UartPeripheral::new(pac.UART0, (pins.gpio0.reconfigure(), pins.gpio1.reconfigure()), &mut pac.RESETS)
        .enable(UartConfig::default(), clocks.peripheral_clock.freq())
        .expect("115200 baud can be had");

    let bus = Spi::<_, _, _, 8>::new(pac.SPI0, (pins.gpio19.reconfigure(), pins.gpio18.reconfigure())).init(
        &mut pac.RESETS,
        clocks.peripheral_clock.freq(),
        62_500_000.Hz(),
        MODE_0,
    );
    let mut select = pins.gpio17.reconfigure();
    let Ok(()) = select.set_high();
    Board {
        bus: RefCell::new(bus),
        select,
        command: pins.gpio20.reconfigure(),
        reset: pins.gpio21.reconfigure(),
        timer: Timer::new(pac.TIMER, &mut pac.RESETS, &clocks),
        words,
        channel: pac.DMA.split(&mut pac.RESETS).ch0,
    }
}

/// Starts the display; `buffer` is the driver's, for pixels on their way.
pub fn lcd<'b>(
    bus: &'b RefCell<Bus>,
    select: &'b mut Output<Gpio17>,
    command: &'b mut Output<Gpio20>,
    reset: &'b mut Output<Gpio21>,
    timer: &mut Timer,
    buffer: &'b mut [u8],
) -> Lcd<'b> {
    let device = RefCellDevice::new_no_delay(bus, select).unwrap_or_else(|error| match error {});
    Builder::new(ILI9341Rgb565, SpiInterface::new(device, command, buffer))
        .reset_pin(reset)
        .orientation(Orientation::new().rotate(Rotation::Deg90))
        .color_order(ColorOrder::Bgr)
        .init(timer)
        .ok()
        .expect("the display answers nothing that could be wrong")
}

/// Starts everything, draws, and sleeps.
pub fn run(draw: impl FnOnce(&mut Lcd<'_>)) -> ! {
    let Board { bus, mut select, mut command, mut reset, mut timer, mut words, .. } = start();
    let mut buffer = [0; 128];
    draw(&mut lcd(&bus, &mut select, &mut command, &mut reset, &mut timer, &mut buffer));
    say(&mut words, "done", "");
    loop {
        cortex_m::asm::wfi();
    }
}

/// Tells what comes, or that it is over.
pub fn say(words: &mut Words, what: &str, name: &str) {
    let _ = writeln!(words, "{what} {name}");
}
