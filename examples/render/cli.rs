//! What the command line says.

use std::{num::NonZeroU32, path::PathBuf};

use clap::{Parser, ValueEnum};
use embedded_graphics::{
    geometry::{Point, Size},
    pixelcolor::Rgb888,
    primitives::Rectangle,
};

/// No side of the display, and no side of the picture, is longer than this.
pub(crate) const LONGEST_SIDE: u32 = 16_384;

/// No picture has more pixels than this: 8192 x 8192.
pub(crate) const MOST_PIXELS: u64 = 1 << 26;

/// Draws an SVG file on a simulated display with spanfill, and saves what the display shows as a PNG file.
///
/// Shapes are filled as the crate does on a microcontroller: without anti-aliasing, a pixel has a shape's colour when its
/// centre is inside; with --aa, the colour is blended by how much of the pixel the shape covers. Coordinates go to the
/// nearest 1/256 pixel, straight outlines stay as they are, and curves are flattened to within 1/8 pixel. A stroke is
/// outlined and filled; without anti-aliasing, one thinner than a pixel is drawn one pixel wide. What cannot be drawn yet
/// is named on stderr.
#[derive(Debug, Parser)]
#[command(name = "render", version)]
pub(crate) struct Args {
    /// The SVG file to draw [default: a bundled map of the world]
    #[arg(value_name = "IN.svg")]
    pub(crate) input: Option<PathBuf>,

    /// The PNG file to write
    #[arg(value_name = "OUT.png", default_value = "render.png")]
    pub(crate) output: PathBuf,

    /// The display's size in pixels [default: the SVG's own, one unit a pixel]
    ///
    /// The drawing is scaled by the same factor in both directions until it just fits, and centred (as by
    /// preserveAspectRatio="xMidYMid meet"); the rest of the display shows the background.
    #[arg(long, value_name = "WxH", value_parser = parse_size)]
    pub(crate) size: Option<Size>,

    /// The display's colours
    #[arg(long, value_enum, value_name = "COLOR", default_value_t = ColorDepth::Rgb565)]
    pub(crate) color: ColorDepth,

    /// How edges are blended
    #[arg(long, value_enum, value_name = "HOW", default_value_t = Aa::None)]
    pub(crate) aa: Aa,

    /// The colour that the display is cleared with
    #[arg(long, value_name = "#rrggbb", default_value = "#ffffff", value_parser = parse_color)]
    pub(crate) background: Rgb888,

    /// The PNG's pixels along each side of one pixel of the display
    #[arg(long, value_name = "N", default_value = "1")]
    pub(crate) scale: NonZeroU32,

    /// The part of the display to save, in its pixels; with --scale, a magnified detail [default: all of it]
    #[arg(long, value_name = "X,Y,W,H", value_parser = parse_crop)]
    pub(crate) crop: Option<Rectangle>,
}

/// Ways to anti-alias.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Aa {
    /// Not at all: a pixel is covered when its centre is
    None,
    /// By the exact area that a shape covers of a pixel
    Exact,
    /// By 4 x 4 samples a pixel
    #[value(name = "4")]
    Four,
    /// By 16 x 16 samples a pixel
    #[value(name = "16")]
    Sixteen,
    /// By 4 x 4 samples that count for more near the pixel's centre
    Weighted,
}

impl Aa {
    /// None when edges are not blended.
    pub(crate) fn name(self) -> Option<&'static str> {
        match self {
            Self::None => None,
            Self::Exact => Some("exact areas"),
            Self::Four => Some("4 x 4 samples"),
            Self::Sixteen => Some("16 x 16 samples"),
            Self::Weighted => Some("4 x 4 weighted samples"),
        }
    }
}

/// The colour types of embedded-graphics that a display may have here.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum ColorDepth {
    /// 16 bits: most colour LCDs
    Rgb565,
    /// 24 bits
    Rgb888,
    /// 256 levels
    Gray8,
    /// 16 levels: many OLEDs
    Gray4,
    /// On or off: e-paper, small OLEDs
    Binary,
}

impl ColorDepth {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Rgb565 => "rgb565",
            Self::Rgb888 => "rgb888",
            Self::Gray8 => "gray8",
            Self::Gray4 => "gray4",
            Self::Binary => "binary",
        }
    }
}

/// Whether a display of this size, each pixel drawn as `scale` x `scale`, can be made.
pub(crate) fn check_size(size: Size, scale: u32) -> Result<(), String> {
    let Size { width, height } = size;
    if width == 0 || height == 0 {
        return Err(format!("a display of {width}x{height} has no pixels"));
    }
    let side = |pixels: u32| u64::from(pixels).saturating_mul(u64::from(scale));
    let longest = side(width.max(height));
    let pixels = side(width).saturating_mul(side(height));
    if longest > u64::from(LONGEST_SIDE) || pixels > MOST_PIXELS {
        return Err(format!(
            "{width}x{height} at scale {scale} is too large: at most {LONGEST_SIDE} pixels a side and {MOST_PIXELS} in all"
        ));
    }
    Ok(())
}

fn parse_size(text: &str) -> Result<Size, String> {
    let (width, height) = text.split_once(['x', 'X']).ok_or("expected WIDTHxHEIGHT, for example 320x240")?;
    let side =
        |digits: &str| digits.parse::<u32>().map_err(|error| format!("'{digits}' is not a number of pixels: {error}"));
    let size = Size::new(side(width)?, side(height)?);
    check_size(size, 1)?;
    Ok(size)
}

fn parse_crop(text: &str) -> Result<Rectangle, String> {
    let expected = "expected X,Y,WIDTH,HEIGHT, for example 100,80,64,40";
    let numbers: Vec<&str> = text.split(',').map(str::trim).collect();
    let [x, y, width, height] = *numbers else { return Err(expected.into()) };
    let number = |digits: &str| digits.parse::<u32>().map_err(|error| format!("'{digits}': {error}; {expected}"));
    let size = Size::new(number(width)?, number(height)?);
    check_size(size, 1)?;
    // A Rectangle's arithmetic overflows far beyond.
    let place = |digits| match number(digits)? {
        position @ 0..LONGEST_SIDE => Ok(position.cast_signed()),
        position => Err(format!("no display reaches as far as {position}; {expected}")),
    };
    Ok(Rectangle::new(Point::new(place(x)?, place(y)?), size))
}

/// What of a display to save: all of it, unless a part is asked for, which must lie on it.
pub(crate) fn part_of(display: Size, crop: Option<Rectangle>) -> Result<Rectangle, String> {
    let all = Rectangle::new(Point::zero(), display);
    let Some(crop) = crop else { return Ok(all) };
    if all.intersection(&crop) == crop {
        return Ok(crop);
    }
    let (Point { x, y }, Size { width, height }) = (crop.top_left, crop.size);
    Err(format!(
        "the crop {x},{y},{width},{height} is not on the display of {}x{} pixels",
        display.width, display.height
    ))
}

fn parse_color(text: &str) -> Result<Rgb888, String> {
    let digits = text.strip_prefix('#').unwrap_or(text);
    let expected = "expected '#rrggbb', six hexadecimal digits";
    // from_str_radix would take a sign, and a digit count says nothing about non-ASCII text.
    if digits.len() != 6 || !digits.bytes().all(|byte| byte.is_ascii_hexdigit()) {
        return Err(expected.into());
    }
    let value = u32::from_str_radix(digits, 16).map_err(|_| expected)?;
    let [_, red, green, blue] = value.to_be_bytes();
    Ok(Rgb888::new(red, green, blue))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_size_is_two_numbers_of_pixels() {
        assert_eq!(parse_size("320x240"), Ok(Size::new(320, 240)));
        assert_eq!(parse_size("1X16384"), Ok(Size::new(1, 16_384)));
        for bad in ["", "x", "320", "320x", "0x240", "320x0", "-1x5", "3.5x4", "16385x1", "99999999999x1", "9000x9000"]
        {
            assert!(parse_size(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn a_crop_is_a_place_and_a_size_on_the_display() {
        let rectangle = |x, y, width, height| Rectangle::new(Point::new(x, y), Size::new(width, height));
        assert_eq!(parse_crop("1,2,3,4"), Ok(rectangle(1, 2, 3, 4)));
        assert_eq!(parse_crop("0, 16383, 16, 1"), Ok(rectangle(0, 16_383, 16, 1)));
        for bad in ["", "1,2,3", "1,2,3,4,5", "1,2,0,4", "-1,2,3,4", "a,2,3,4", "1,2,3,99999", "1 2 3 4", "16384,2,3,4"]
        {
            assert!(parse_crop(bad).is_err(), "{bad}");
        }
        let display = Size::new(8, 4);
        assert_eq!(part_of(display, None), Ok(rectangle(0, 0, 8, 4)));
        assert_eq!(part_of(display, Some(rectangle(6, 1, 2, 3))), Ok(rectangle(6, 1, 2, 3)));
        for (x, y) in [(7, 1), (6, 2), (16_384, 0)] {
            assert!(part_of(display, Some(rectangle(x, y, 2, 3))).is_err(), "{x} {y}");
        }
    }

    #[test]
    fn a_scale_counts_towards_the_size() {
        assert_eq!(check_size(Size::new(4096, 4096), 2), Ok(()));
        assert!(check_size(Size::new(4096, 4097), 2).is_err());
        assert!(check_size(Size::new(1, 1), u32::MAX).is_err());
        assert!(check_size(Size::new(u32::MAX, u32::MAX), u32::MAX).is_err());
    }

    #[test]
    fn a_colour_is_six_hexadecimal_digits() {
        assert_eq!(parse_color("#12aBff"), Ok(Rgb888::new(0x12, 0xab, 0xff)));
        assert_eq!(parse_color("000001"), Ok(Rgb888::new(0, 0, 1)));
        for bad in ["", "#", "#fff", "#12345g", "#1234567", "+12345", "#+12345", "red", "#ééé"] {
            assert!(parse_color(bad).is_err(), "{bad}");
        }
    }
}
