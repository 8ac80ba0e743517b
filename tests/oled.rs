//! One scene, two machines: what the emulated board's OLED shows is what the host draws, in every pixel.
//!
//! `cargo test --features _qemu --test oled`. The feature keeps it out of a plain `cargo test`, which then needs no
//! more than Rust; with it, a missing QEMU or a missing compiler for the board is a failure.

use std::{fs, path::Path, process::Command};

use embedded_graphics::{pixelcolor::Gray4, prelude::*};
use embedded_graphics_simulator::SimulatorDisplay;

#[path = "../examples/scene/mod.rs"]
mod scene;

/// QEMU magnifies the panel's pixels.
const SCREEN_PIXELS_A_PIXEL: usize = 4;

#[test]
fn the_panel_shows_what_the_host_draws() {
    let mut display = SimulatorDisplay::<Gray4>::new(scene::SIZE);
    scene::draw(&mut display).expect("a simulated display takes everything");
    let screen = photograph_of_the_panel();

    let mut different = Vec::new();
    let mut times_seen = [0; 16];
    for (y, row) in screen.rows().enumerate() {
        for (x, &seen) in row.iter().enumerate() {
            let [column, row] = [x, y].map(|coordinate| (coordinate / SCREEN_PIXELS_A_PIXEL) as i32);
            let luma = display.get_pixel(Point::new(column, row)).luma();
            // Sixteen greys, spread from black to white.
            if seen == [luma * 0x11; 3] {
                times_seen[usize::from(luma)] += 1;
            } else {
                different.push((column, row, luma, seen));
            }
        }
    }
    assert!(
        different.is_empty(),
        "{} of {} screen pixels differ; (x, y, luma on the host, colour on the panel) of the first ones: {:?}",
        different.len(),
        screen.pixels.len(),
        &different[..different.len().min(5)],
    );

    // Two empty pictures would be the same, too.
    let greys = times_seen.iter().filter(|&&times| times > 0).count();
    assert!(greys >= 10, "the scene has more greys than {times_seen:?}");
    let lit: usize = times_seen[1..].iter().sum();
    assert!(lit > screen.pixels.len() / 2, "the scene covers more than {lit} of the screen's pixels");
}

/// Builds the firmware, runs it on the emulated board and saves what the panel shows once the scene is on it.
fn photograph_of_the_panel() -> Ppm {
    let photograph = Path::new(env!("CARGO_TARGET_TMPDIR")).join("oled.ppm");
    let status = Command::new("bash")
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/firmware/run.sh"))
        .arg("oled")
        .arg(&photograph)
        .status()
        .expect("bash starts");
    assert!(status.success(), "run.sh says above what went wrong");

    let screen = Ppm::parse(&fs::read(&photograph).expect("run.sh has saved the photograph"));
    let panel = [scene::SIZE.width, scene::SIZE.height].map(|pixels| pixels as usize);
    assert_eq!([screen.width, screen.height], panel.map(|pixels| pixels * SCREEN_PIXELS_A_PIXEL));
    screen
}

/// A picture in the binary "portable pixmap" format, 8 bits a channel.
struct Ppm {
    width: usize,
    height: usize,
    pixels: Vec<[u8; 3]>,
}

impl Ppm {
    fn parse(file: &[u8]) -> Self {
        // Magic number, width, height and largest value, each ended by one white space as QEMU writes them.
        let mut fields = file.splitn(5, u8::is_ascii_whitespace);
        let mut field = || fields.next().expect("a PPM has four fields and then its pixels");
        let number = |digits: &[u8]| str::from_utf8(digits).expect("ASCII").parse::<usize>().expect("a number");

        assert_eq!(field(), b"P6");
        let [width, height, largest] = [number(field()), number(field()), number(field())];
        assert_eq!(largest, 255);
        let channels = field();
        assert_eq!(channels.len(), 3 * width * height, "the file is cut off");
        Self { width, height, pixels: channels.chunks_exact(3).map(|rgb| [rgb[0], rgb[1], rgb[2]]).collect() }
    }

    fn rows(&self) -> impl Iterator<Item = &[[u8; 3]]> {
        self.pixels.chunks_exact(self.width)
    }
}
