//! A texture drawn smaller than it is: one texel for each pixel, or the average of all that lie in it.
//!
//! ```text
//!     texels   0 1 0 1 0 1 0 1       point-sampled at half the size: 1 1 1 1, and 0 0 0 0 if it moves by one:
//!     pixels   [ ] [ ] [ ] [ ]       a pattern that is not there; averaged: 1/2 1/2 1/2 1/2
//! ```
//!
//! Averages are exact: a texel on the border of two pixels counts for its share in each. With W texels to P pixels, texel
//! j has `min((j + 1) P, (i + 1) W) - max(j P, i W)` parts of `W` in pixel i.

use crate::{
    Fragment, FragmentSink, PixelRect,
    methods::{antialias::Error, line::display::steps_within},
};

/// Grey texels, rows downwards.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Texture<'a> {
    texels: &'a [u8],
    width: u16,
    height: u16,
}

impl<'a> Texture<'a> {
    /// A texture of `width` x `height` texels.
    ///
    /// # Errors
    ///
    /// When there are fewer texels than that.
    pub fn new(texels: &'a [u8], width: u16, height: u16) -> Result<Self, Error<core::convert::Infallible>> {
        Error::check(usize::from(width) * usize::from(height), texels.len())?;
        Ok(Self { texels, width, height })
    }

    fn row(&self, row: u64) -> &'a [u8] {
        let start = row as usize * usize::from(self.width);
        self.texels.get(start..start + usize::from(self.width)).unwrap_or_default()
    }
}

/// What a pixel looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Sampling {
    /// The texel under its centre.
    Point,
    /// All texels in it, by their share.
    Averaged,
}

/// Draws a texture in `columns` x `rows` pixels from the pixel `corner` on; greys are coverage.
///
/// # Errors
///
/// The sink's.
pub fn draw<S: FragmentSink>(
    texture: &Texture<'_>,
    [left, top]: [i32; 2],
    [columns, rows]: [u16; 2],
    sampling: Sampling,
    clip: &PixelRect,
    sink: &mut S,
) -> Result<(), S::Error> {
    let (width, height) = (u64::from(texture.width), u64::from(texture.height));
    let (columns, rows) = (u64::from(columns), u64::from(rows));
    if width == 0 || height == 0 {
        return Ok(());
    }
    let last = |pixels: u64| pixels as i32 - 1;
    for y in steps_within(top, false, last(rows), &clip.rows) {
        let row = top.wrapping_add_unsigned(y);
        for x in steps_within(left, false, last(columns), &clip.columns) {
            let column = left.wrapping_add_unsigned(x);
            let (x, y) = (u64::from(x), u64::from(y));
            sink.visit(column, row);
            let grey = match sampling {
                Sampling::Point => {
                    let texels = texture.row((2 * y + 1) * height / (2 * rows));
                    texels.get(((2 * x + 1) * width / (2 * columns)) as usize).copied().unwrap_or(0)
                }
                Sampling::Averaged => average(texture, [x, y], [columns, rows]),
            };
            if grey > 0 {
                sink.fragment(Fragment::covered(column, row, grey))?;
            }
        }
    }
    Ok(())
}

fn average(texture: &Texture<'_>, [x, y]: [u64; 2], [columns, rows]: [u64; 2]) -> u8 {
    let (width, height) = (u64::from(texture.width), u64::from(texture.height));
    // The texels in a pixel, and their shares, of `texels` parts in all.
    let shares = |i: u64, texels: u64, pixels: u64| {
        let (start, end) = (i * texels, (i + 1) * texels);
        (start / pixels..end.div_ceil(pixels)).map(move |j| (j, ((j + 1) * pixels).min(end) - (j * pixels).max(start)))
    };
    let mut sum = 0;
    for (j, down) in shares(y, height, rows) {
        let texels = texture.row(j);
        for (i, right) in shares(x, width, columns) {
            sum += down * right * u64::from(texels.get(i as usize).copied().unwrap_or(0));
        }
    }
    // At most 255 parts of 2^32.
    let whole = width * height;
    ((sum + whole / 2) / whole).min(255) as u8
}
