//! Ordered dithering.

use core::{iter::once, ops::Range};

use embedded_graphics_core::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{Point, Size},
    pixelcolor::PixelColor,
    primitives::Rectangle,
};

use crate::blend::Blend;

/// Draws a part of the pixels in the colour itself and leaves the others: ordered dithering, for displays with few
/// colours.
///
/// Works on every target and in every colour, and never reads. The pattern (B. E. Bayer, "An optimum method for
/// two-level rendition of continuous-tone pictures", 1973) belongs to the screen and repeats every 8 x 8 pixels,
/// above and to the left of the origin too: shapes that move do not carry it with them. A pixel whose alpha is `a` is
/// drawn if `a / 255 > (m + 1/2) / 64`, where `m` is its number in the pattern, each of 0..=63 once:
///
/// ```text
///    0 32  8 40 ..        . . . .     # . # .     # . # .     # # # #
///   48 16 56 24           . . . .     . . . .     . # . #     # # # #
///   12 44  4 36           . . . .     # . # .     # . # .     # # # #
///   60 28 52 20           . . . .     . . . .     . # . #     # # # #
///    :
///                       alpha  0         64         128         255
/// ```
///
/// Of the 64 pixels of an aligned tile that are all covered alike, exactly `round(64 a / 255)` are drawn: none for
/// alpha 0, all for 255. A greater alpha keeps the pixels of a smaller one.
///
/// # Cost
///
/// A byte of a table (64 bytes in all) and a comparison a pixel. Pixels that stay cut a run in pieces; each piece goes
/// to the target as one, by `fill_solid`.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Dither, Polygon, Vertex, prelude::*};
///
/// let square = [(0, 0), (4, 0), (4, 4), (0, 4)].map(|(x, y)| Vertex::new(x, y));
/// let square = Polygon::new(&square).coverage_with::<4>()?;
/// let mut display = MockDisplay::new();
/// square.antialiased(BinaryColor::On, Dither).opacity(128).draw(&mut display).unwrap();
/// display.assert_pattern(&[
///     "# # ",
///     " # #",
///     "# # ",
///     " # #",
/// ]);
/// # Ok::<(), spanfill::TooManyEdges>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Dither;

/// The pattern's side, and its mask.
const SIDE: usize = 8;

/// For each row of the pattern, the greatest alpha that does not draw.
static THRESHOLDS: [[u8; SIDE]; SIDE] = thresholds();

/// The number of a pixel in the pattern, from the recurrence of Bayer's matrices:
///
/// ```text
///                 | 4 M(n)      4 M(n) + 2 |
///   M(2n)   =     |                        |
///                 | 4 M(n) + 3  4 M(n) + 1 |
/// ```
///
/// Each halving of the place, from the whole pattern down, says two bits, from the lowest up: those of `x ^ y` and `y`.
const fn bayer(x: usize, y: usize) -> usize {
    let mut number = 0;
    let mut bit = 1;
    while bit < SIDE {
        let (right, lower) = (x & bit != 0, y & bit != 0);
        number = 4 * number + 2 * ((right != lower) as usize) + lower as usize;
        bit *= 2;
    }
    number
}

/// `alpha / 255 > (number + 1/2) / 64` is `alpha > 255 (2 number + 1) / 128`, which is never an integer.
#[allow(clippy::indexing_slicing, reason = "run by the compiler, which would fail")]
const fn thresholds() -> [[u8; SIDE]; SIDE] {
    let mut thresholds = [[0; SIDE]; SIDE];
    let mut index = 0;
    while index < SIDE * SIDE {
        let (x, y) = (index % SIDE, index / SIDE);
        #[allow(clippy::cast_possible_truncation, reason = "at most 255 * 127 / 128")]
        let threshold = (255 * (2 * bayer(x, y) + 1) / 128) as u8;
        thresholds[y][x] = threshold;
        index += 1;
    }
    thresholds
}

/// Where a coordinate lies in the pattern; two's complement continues it below zero.
#[inline(always)]
fn place(coordinate: i32) -> usize {
    coordinate.cast_unsigned() as usize % SIDE
}

impl<C: PixelColor, D: DrawTarget<Color = C>> Blend<D> for Dither {
    #[inline]
    fn run(&self, target: &mut D, start: Point, colour: C, alphas: &[u8]) -> Result<(), D::Error> {
        let row = THRESHOLDS.get(place(start.y)).copied().unwrap_or_default();
        // What is to be drawn and not yet sent.
        let mut piece = start.x..start.x;
        for &alpha in alphas {
            let next = piece.end.wrapping_add(1);
            let threshold = row.get(place(piece.end)).copied().unwrap_or_default();
            if alpha <= threshold {
                send(target, start.y, &piece, colour)?;
                piece.start = next;
            }
            piece.end = next;
        }
        send(target, start.y, &piece, colour)
    }
}

/// Draws the columns, of which there may be none.
#[inline]
fn send<D: DrawTarget>(target: &mut D, row: i32, columns: &Range<i32>, colour: D::Color) -> Result<(), D::Error> {
    let start = Point::new(columns.start, row);
    match columns.end.wrapping_sub(columns.start).cast_unsigned() {
        0 => Ok(()),
        // Half the pixels have no neighbour in the lighter half of the greys.
        1 => target.draw_iter(once(Pixel(start, colour))),
        width => target.fill_solid(&Rectangle::new(start, Size::new(width, 1)), colour),
    }
}
