//! An SSD0323 panel: 128 x 64 pixels, 16 greys, two pixels a byte, the left one in the high half.
//!
//! The panel takes bytes into an address window and cannot be read back over its serial bus. A span that starts or
//! ends inside a byte therefore needs to know the other half of that byte, so the picture is kept here as well: 4096
//! bytes. That being so, shapes are drawn into the copy, and [`Ssd0323::flush`] sends the window that has changed:
//! one command and each byte once, however many shapes lie on top of each other.

use core::{convert::Infallible, ops::Range};

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point, Size},
    pixelcolor::{Gray4, GrayColor},
    primitives::Rectangle,
};

const COLUMNS: usize = 128;
const ROWS: usize = 64;
const ROW_BYTES: usize = COLUMNS / 2;

/// What the panel is connected to.
pub(crate) trait Bus {
    /// Sends a command and its parameters.
    fn command(&mut self, bytes: &[u8]);
    /// Sends bytes of the picture.
    fn data(&mut self, bytes: impl Iterator<Item = u8>);
}

/// The panel and the picture that it shows or is about to show.
#[derive(Debug)]
pub(crate) struct Ssd0323<B> {
    bus: B,
    rows: [[u8; ROW_BYTES]; ROWS],
    /// What was drawn since the picture was last sent. Neither range is ever empty.
    changed: Option<Window>,
}

/// A rectangle in the panel's terms: rows, and columns of bytes.
#[derive(Debug, Clone)]
struct Window {
    rows: Range<usize>,
    bytes: Range<usize>,
}

impl Window {
    const ALL: Self = Self { rows: 0..ROWS, bytes: 0..ROW_BYTES };

    /// The smallest window that holds both.
    fn around(self, other: Self) -> Self {
        let around = |a: Range<usize>, b: Range<usize>| a.start.min(b.start)..a.end.max(b.end);
        Self { rows: around(self.rows, other.rows), bytes: around(self.bytes, other.bytes) }
    }
}

impl<B: Bus> Ssd0323<B> {
    /// Turns the panel on, black.
    pub(crate) fn new(mut bus: B) -> Self {
        const NORMAL_DISPLAY: u8 = 0xA4;
        const DISPLAY_ON: u8 = 0xAF;

        bus.command(&[NORMAL_DISPLAY]);
        let mut panel = Self { bus, rows: [[0; ROW_BYTES]; ROWS], changed: Some(Window::ALL) };
        // What the panel's memory holds after a reset is not defined.
        panel.flush();
        panel.bus.command(&[DISPLAY_ON]);
        panel
    }

    /// Sends what was drawn since the last time.
    pub(crate) fn flush(&mut self) {
        const COLUMN_WINDOW: u8 = 0x15;
        const ROW_WINDOW: u8 = 0x75;

        let Some(Window { rows, bytes }) = self.changed.take() else { return };
        // The window's last row and column are part of it. All are below 128.
        let inclusive = |range: &Range<usize>| [range.start as u8, (range.end - 1) as u8];
        let [first, last] = inclusive(&bytes);
        self.bus.command(&[COLUMN_WINDOW, first, last]);
        let [first, last] = inclusive(&rows);
        self.bus.command(&[ROW_WINDOW, first, last]);
        self.bus.data(self.rows[rows].iter().flat_map(|row| &row[bytes.clone()]).copied());
    }

    /// Fills pixels that all lie on the panel.
    fn fill(&mut self, rows: Range<usize>, columns: Range<usize>, colour: Gray4) {
        if rows.is_empty() || columns.is_empty() {
            return;
        }
        let luma = colour.luma();
        let both_pixels = luma << 4 | luma;
        let bytes = columns.start / 2..columns.end.div_ceil(2);
        let window = Window { rows: rows.clone(), bytes };
        self.changed = Some(match self.changed.take() {
            Some(changed) => changed.around(window),
            None => window,
        });
        for row in &mut self.rows[rows] {
            // Whole bytes first, if there are any, then the half a byte at either end.
            if let Some(whole_bytes) = row.get_mut(columns.start.div_ceil(2)..columns.end / 2) {
                whole_bytes.fill(both_pixels);
            }
            if columns.start % 2 == 1 {
                let right_half = &mut row[columns.start / 2];
                *right_half = *right_half & 0xF0 | luma;
            }
            if columns.end % 2 == 1 {
                let left_half = &mut row[columns.end / 2];
                *left_half = *left_half & 0x0F | luma << 4;
            }
        }
    }
}

impl<B> OriginDimensions for Ssd0323<B> {
    fn size(&self) -> Size {
        Size::new(COLUMNS as u32, ROWS as u32)
    }
}

impl<B: Bus> DrawTarget for Ssd0323<B> {
    type Color = Gray4;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray4>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels
            .into_iter()
            .try_for_each(|Pixel(point, colour)| self.fill_solid(&Rectangle::new(point, Size::new_equal(1)), colour))
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Gray4) -> Result<(), Infallible> {
        let Rectangle { top_left: Point { x, y }, size: Size { width, height } } = *area;
        self.fill(on_panel(y, height, ROWS), on_panel(x, width, COLUMNS), colour);
        Ok(())
    }
}

/// What of `start..start + length` lies in `0..end`.
fn on_panel(start: i32, length: u32, end: usize) -> Range<usize> {
    let index = |coordinate: i32| usize::try_from(coordinate).unwrap_or(0).min(end);
    index(start)..index(start.saturating_add_unsigned(length))
}
