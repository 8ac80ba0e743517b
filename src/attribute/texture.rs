//! Textures: any picture that can be read.

use core::fmt;

use embedded_graphics_core::{
    geometry::{Dimensions, Point},
    image::GetPixel,
};

use crate::blend::Mix;

/// What lies beyond a texture's edges.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Wrap {
    /// The texels of the edge.
    #[default]
    Clamp,
    /// The texture again.
    Repeat,
}

/// What is shown between the centres of texels.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Filter {
    /// The nearest one.
    #[default]
    Nearest,
    /// The four around, by how near they are, in 1/256 of a texel.
    Bilinear,
}

/// A texture has to have at least one texel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct EmptyTexture;

impl fmt::Display for EmptyTexture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the texture has no texel")
    }
}

impl core::error::Error for EmptyTexture {}

/// A picture to be sampled at coordinates in 1/256 of a texel, (0, 0) being the top-left corner of its top-left texel.
///
/// Every pair of coordinates is legal.
///
/// ```text
///             0   256  512
///           0 +----+----+           nearest: the texel that has the point
///             | a  | b  |           bilinear: at the common corner a quarter of each,
///         256 +----+----+                     at (128, 128) a alone
///             | c  | d  |
///             +----+----+
/// ```
///
/// # Errors
///
/// A texture of no size.
///
/// # Cost
///
/// Nearest: where sides are powers of two, a mask for each coordinate ([`Wrap::Repeat`]), else a division. Bilinear:
/// four texels, mixed by three [`Mix::over`].
///
/// # Examples
///
/// ```
/// use embedded_graphics::{image::ImageRaw, pixelcolor::BinaryColor, prelude::*};
/// use spanfill::{Filter, Texture, Wrap};
///
/// let board = ImageRaw::<BinaryColor>::new(&[0b1000_0000, 0b0100_0000], 2);
/// let board = Texture::new(board, Wrap::Repeat, Filter::Nearest)?;
/// assert_eq!(board.texel([128, 128]), Some(BinaryColor::On));
/// assert_eq!(board.texel([-128, 128]), Some(BinaryColor::Off));
/// # Ok::<(), spanfill::EmptyTexture>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Texture<T> {
    texels: T,
    wrap: Wrap,
    filter: Filter,
    corner: Point,
    size: [i32; 2],
    /// The sides less one, where it repeats, both are powers of two and the corner is the origin.
    masks: Option<[i32; 2]>,
}

impl<T: GetPixel + Dimensions> Texture<T> {
    /// A texture of a picture's bounding box.
    ///
    /// # Errors
    ///
    /// See [`EmptyTexture`].
    pub fn new(texels: T, wrap: Wrap, filter: Filter) -> Result<Self, EmptyTexture> {
        let area = texels.bounding_box();
        let side = |length: u32| i32::try_from(length).unwrap_or(i32::MAX);
        let size = [side(area.size.width), side(area.size.height)];
        if size.contains(&0) {
            return Err(EmptyTexture);
        }
        let is_simple = wrap == Wrap::Repeat && area.top_left == Point::zero();
        let masks = (is_simple && size.iter().all(|side| side & (side - 1) == 0)).then(|| size.map(|side| side - 1));
        Ok(Self { texels, wrap, filter, corner: area.top_left, size, masks })
    }
}

impl<T: GetPixel> Texture<T> {
    /// The nearest texel; none only where the picture itself has a hole.
    #[inline]
    pub fn texel(&self, coordinates: [i32; 2]) -> Option<T::Color> {
        self.at(coordinates.map(|coordinate| coordinate >> 8))
    }

    #[inline(always)]
    fn at(&self, [x, y]: [i32; 2]) -> Option<T::Color> {
        let [width, height] = self.size;
        if let Some([columns, rows]) = self.masks {
            return self.texels.pixel(Point::new(x & columns, y & rows));
        }
        let (x, y) = match self.wrap {
            Wrap::Clamp => (x.clamp(0, (width - 1).max(0)), y.clamp(0, (height - 1).max(0))),
            Wrap::Repeat => (repeated(x, width), repeated(y, height)),
        };
        self.texels.pixel(Point::new(self.corner.x.wrapping_add(x), self.corner.y.wrapping_add(y)))
    }

    /// The colour by the texture's filter; none only where the picture itself has a hole.
    #[inline]
    pub fn sample(&self, coordinates: [i32; 2]) -> Option<T::Color>
    where
        T::Color: Mix,
    {
        if self.filter == Filter::Nearest { self.texel(coordinates) } else { self.bilinear(coordinates) }
    }

    #[inline]
    fn bilinear(&self, coordinates: [i32; 2]) -> Option<T::Color>
    where
        T::Color: Mix,
    {
        // From the centre of the texel to the upper left of the point.
        let [x, y] = coordinates.map(|coordinate| coordinate.saturating_sub(128));
        let (column, row) = (x >> 8, y >> 8);
        let [right, lower] = [x, y].map(alpha);
        let across = |row: i32| {
            let left = self.at([column, row])?;
            if right == 0 {
                return Some(left);
            }
            Some(self.at([column.wrapping_add(1), row])?.over(left, right))
        };
        let above = across(row)?;
        if lower == 0 {
            return Some(above);
        }
        Some(across(row.wrapping_add(1))?.over(above, lower))
    }
}

/// From 256ths of a texel to 255ths: 0 is 0, 255 is 254.
#[inline(always)]
fn alpha(coordinate: i32) -> u8 {
    let [fraction, ..] = coordinate.to_le_bytes();
    let [_, alpha] = (u16::from(fraction) * 255 + 128).to_le_bytes();
    alpha
}

#[inline(never)]
fn repeated(coordinate: i32, side: i32) -> i32 {
    coordinate.rem_euclid(side.max(1))
}
