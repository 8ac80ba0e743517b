//! What the command line says.

use std::{num::NonZeroU32, path::PathBuf};

use clap::{Parser, ValueEnum};
use embedded_graphics::{geometry::Size, pixelcolor::Rgb888};

/// No side of the display, and no side of the picture, is longer than this.
pub(crate) const LONGEST_SIDE: u32 = 16_384;

/// No picture has more pixels than this: 8192 x 8192.
pub(crate) const MOST_PIXELS: u64 = 1 << 26;

/// Draws an SVG file on a simulated display with spanfill, and saves what the display shows as a PNG file.
///
/// Shapes are filled without anti-aliasing, as the crate does on a microcontroller: a pixel has a shape's colour when
/// its centre is inside. Coordinates go to the nearest 1/256 pixel, straight outlines stay as they are, and curves
/// are flattened to within 1/8 pixel. A stroke is outlined and filled; one thinner than a pixel is drawn one pixel
/// wide. What cannot be drawn yet is named on stderr.
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

    /// The colour that the display is cleared with
    #[arg(long, value_name = "#rrggbb", default_value = "#ffffff", value_parser = parse_color)]
    pub(crate) background: Rgb888,

    /// The PNG's pixels along each side of one pixel of the display
    #[arg(long, value_name = "N", default_value = "1")]
    pub(crate) scale: NonZeroU32,
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
