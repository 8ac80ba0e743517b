//! Colours that vary across a triangle (H. Gouraud, "Continuous shading of curved surfaces", 1971).
//!
//! # Packed channels
//!
//! In 16 bits a pixel, binary fixed point has room for two channels in a word:
//!
//! ```text
//!   31   27 26           16 15   11 10            0        31    26 25                     0
//!   [ red  |   11 bits    ][ blue |   11 bits    ]        [ green  |       26 bits         ]
//! ```
//!
//! and one addition steps both: the words are integers, linear in the column, and a carry out of blue is part of red's
//! own fraction. Starts are exact to half of the last bit, `2^-12` of a level, and so is each step. After `n` pixels
//! the error is at most `(n + 1) 2^-12`: pieces of 127 pixels, each of which starts anew, keep it within 1/32 of a
//! level, and the level that is shown within 1/2 + 1/32. Half a level more in the start rounds by the shift that takes the
//! channel out: `31 + 1/2 + 1/32 < 32` and `0 + 1/2 - 1/32 > 0`, so no channel runs over.

use core::iter::repeat_with;

use embedded_graphics_core::{
    Drawable,
    draw_target::DrawTarget,
    geometry::Dimensions,
    pixelcolor::{Bgr555, Bgr565, PixelColor, Rgb555, Rgb565, raw::RawData},
    primitives::Rectangle,
};

use crate::{
    PixelRect, Triangle,
    attribute::{
        Affine, Attributes as _, Channels,
        joined::{Joined, Units},
        plane::{Planes, Word},
        shaded::{row_area, row_of},
        walk::{Follow as _, Oriented, walk},
    },
    draw::Fill as _,
    shape::Shape as _,
    target::PixelRows,
};

/// Every channel is stepped by itself: the level that is nearest to the exact one.
pub const EXACT: bool = false;
/// Channels share words: a level within 1/2 + 1/32 of the exact one, in half the instructions. For colours of 15 or 16
/// bits.
pub const PACKED: bool = true;

/// A triangle whose colour varies linearly between those of its vertices.
///
/// Each channel has the level of the target's colour that is nearest to the exact one, at every pixel centre, and so
/// never leaves the range of the three vertices. Triangles that share an edge and its colours agree along it. Where
/// the three colours are equal it is filled as any shape of one colour is.
///
/// With [`PACKED`] as its parameter, channels are within 1/2 + 1/32 of a level.
///
/// ```text
///    red * . . . . . . * green
///          .         .
///            .     .
///              . .
///               * blue
/// ```
///
/// No errors but the target's.
///
/// # Cost
///
/// Each channel is an attribute: see [`Affine`]. Packed, two additions a pixel for three channels.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
/// use spanfill::{Gouraud, Triangle, prelude::*};
///
/// let triangle = Triangle::new(Point::new(0, 0), Point::new(31, 0), Point::new(0, 31));
/// let mut display = MockDisplay::new();
/// let colours = [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE];
/// Gouraud::new(triangle, colours).draw(&mut display)?;
/// assert_eq!(display.get_pixel(Point::new(8, 8)), Some(Rgb565::new(15, 16, 8)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Gouraud<C, const HOW: bool = EXACT> {
    /// Where it is.
    pub triangle: Triangle,
    /// The colours of its vertices.
    pub colours: [C; 3],
}

impl<C> Gouraud<C> {
    /// A triangle with the colour of each vertex.
    #[inline]
    pub const fn new(triangle: Triangle, colours: [C; 3]) -> Self {
        Self { triangle, colours }
    }
}

impl<C> Gouraud<C, PACKED> {
    /// The same with packed channels.
    #[inline]
    pub const fn packed(triangle: Triangle, colours: [C; 3]) -> Self {
        Self { triangle, colours }
    }
}

impl<C: PixelColor, const HOW: bool> Gouraud<C, HOW> {
    /// The colour, where there is only one.
    #[inline]
    fn flat(&self) -> Option<C> {
        let [a, b, c] = self.colours;
        (a == b && a == c).then_some(a)
    }
}

impl<C: PixelColor, const HOW: bool> Dimensions for Gouraud<C, HOW> {
    #[inline]
    fn bounding_box(&self) -> Rectangle {
        self.triangle.bounds().into()
    }
}

impl<C: PixelColor> Gouraud<C> {
    /// Draws into the rows of a target's memory: the same pixels, in less time.
    pub fn draw_on<D: PixelRows<Color = C>, const N: usize>(&self, target: &mut D) -> Result<(), D::Error>
    where
        C: Channels<N>,
    {
        if let Some(colour) = self.flat() {
            return self.triangle.filled(colour).draw(target);
        }
        let clip = PixelRect::from(target.bounding_box());
        let Some(oriented) = Oriented::new(&self.triangle) else { return Ok(()) };
        match oriented.narrow(&self.colours.map(C::channels)) {
            Some(area) => self.rows(&oriented, area, &clip, target),
            None => self.rows(&oriented, oriented.area, &clip, target),
        }
    }

    #[inline]
    fn rows<W: Word, D: PixelRows<Color = C>, const N: usize>(
        &self,
        oriented: &Oriented,
        area: W,
        clip: &PixelRect,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        C: Channels<N>,
    {
        let values = oriented.ordered(&self.colours).map(C::channels);
        let make = |start| Joined::new(Planes::new(&oriented.vertices, &values, area, start));
        walk(&self.triangle, clip, make, |span, joined: &Joined<W, BitsOf<C>, N, 1>| {
            fill_joined(row_of(target, &span), joined);
            Ok(())
        })
    }

    /// Its channels as attributes.
    #[inline]
    pub fn affine<const N: usize>(&self) -> Affine<N>
    where
        C: Channels<N>,
    {
        Affine::new(self.triangle, self.colours.map(C::channels))
    }
}

/// Channels joined to the bits of a colour.
#[derive(Debug)]
struct BitsOf<C>(core::marker::PhantomData<C>);

impl<C: Channels<N>, const N: usize> Units<N, 1> for BitsOf<C> {
    const UNITS: [[u32; 1]; N] = {
        let mut units = [[0]; N];
        let mut index = 0;
        while index < N {
            #[allow(clippy::indexing_slicing, reason = "run by the compiler, which would fail")]
            let unit = C::UNITS[index];
            #[allow(clippy::indexing_slicing, reason = "run by the compiler, which would fail")]
            let place = &mut units[index];
            *place = [unit];
            index += 1;
        }
        units
    };
}

/// Out of line: within a walk, its registers would be taken.
#[inline(never)]
fn fill_joined<W: Word, C: Channels<N>, const N: usize>(row: &mut [C], joined: &Joined<W, BitsOf<C>, N, 1>) {
    joined.write(row, |pixel, [bits]| *pixel = C::from_bits(bits));
}

macro_rules! impl_drawable {
    ($($colour:ident)+) => {
        $(impl Drawable for Gouraud<$colour> {
            type Color = $colour;
            type Output = ();

            fn draw<D: DrawTarget<Color = $colour>>(&self, target: &mut D) -> Result<(), D::Error> {
                if let Some(colour) = self.flat() {
                    return self.triangle.filled(colour).draw(target);
                }
                self.affine().shaded(<$colour>::from_channels).draw(target)
            }
        })+
    };
}

mod drawable {
    use embedded_graphics_core::pixelcolor::{Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb666, Rgb888};

    use super::*;

    impl_drawable!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888 Gray2 Gray4 Gray8 BinaryColor);
}

/// Pixels that a piece may have, see the module.
const PIECE_PX: u32 = 127;
const _: () = assert!((PIECE_PX + 1) * 32 <= 1 << 12);

/// Fraction bits of a channel that has half a word.
const HALF_WORD_FRACTION: u32 = 11;

/// A colour of 15 or 16 bits, whose outer channels have five.
trait Packed: Channels<3> {
    const GREEN_BITS: u32;

    fn from_halfword(bits: u16) -> Self;
    /// The channels in the order of the bits, from the highest down.
    fn in_order(self) -> [i32; 3];
}

macro_rules! impl_packed {
    ($($colour:ident, $bits:literal, [$($order:literal)+];)+) => {
        $(impl Packed for $colour {
            const GREEN_BITS: u32 = $bits;

            #[inline(always)]
            fn from_halfword(bits: u16) -> Self {
                <Self as PixelColor>::Raw::from_u32(bits.into()).into()
            }

            #[inline(always)]
            fn in_order(self) -> [i32; 3] {
                let [r, g, b] = self.channels();
                if [$($order),+] == [0, 1, 2] { [r, g, b] } else { [b, g, r] }
            }
        }

        impl Drawable for Gouraud<$colour, PACKED> {
            type Color = $colour;
            type Output = ();

            fn draw<D: DrawTarget<Color = $colour>>(&self, target: &mut D) -> Result<(), D::Error> {
                if let Some(colour) = self.flat() {
                    return self.triangle.filled(colour).draw(target);
                }
                let clip = PixelRect::from(target.bounding_box());
                self.pieces(&clip, |area, mut words| {
                    let width = usize::try_from(area.size.width).unwrap_or(usize::MAX);
                    target.fill_contiguous(&area, repeat_with(|| words.next()).take(width))
                })
            }
        }

        impl Gouraud<$colour, PACKED> {
            /// Draws into the rows of a target's memory: the same pixels, in less time.
            ///
            /// # Errors
            ///
            /// The target's, at once.
            pub fn draw_on<D: PixelRows<Color = $colour>>(&self, target: &mut D) -> Result<(), D::Error> {
                if let Some(colour) = self.flat() {
                    return self.triangle.filled(colour).draw(target);
                }
                let clip = PixelRect::from(target.bounding_box());
                self.pieces(&clip, |area, words| {
                    let (row, x) = (area.top_left.y, area.top_left.x);
                    let columns = x..x.wrapping_add_unsigned(area.size.width);
                    words.fill(row_of(target, &crate::Span { row, columns }));
                    Ok(())
                })
            }
        })+
    };
}

impl_packed! {
    Rgb565, 6, [0 1 2];
    Bgr565, 6, [2 1 0];
    Rgb555, 5, [0 1 2];
    Bgr555, 5, [2 1 0];
}

/// See the module.
struct Words<C> {
    outer: u32,
    middle: u32,
    outer_step: u32,
    middle_step: u32,
    colour: core::marker::PhantomData<C>,
}

/// Channels joined to the two words: the outer ones to one, the middle one to the other.
#[derive(Debug, Clone, Copy)]
struct PackedUnits;

/// Differences of values must fit 31 bits: two bits fewer than there is room for.
const SPARE: u32 = 2;

impl Units<3, 2> for PackedUnits {
    const UNITS: [[u32; 2]; 3] = [[1 << 16, 0], [0, 1 << SPARE], [1, 0]];
}

impl<C: Packed> Words<C> {
    /// Fraction bits of the middle channel's values.
    const MIDDLE_FRACTION: u32 = 32 - SPARE - C::GREEN_BITS;

    /// From the words of joined channels, and those of their steps.
    #[inline(always)]
    fn new([outer, middle]: [u32; 2], [outer_step, middle_step]: [u32; 2]) -> Self {
        const HALVES: u32 = (1 << (16 + HALF_WORD_FRACTION - 1)) | (1 << (HALF_WORD_FRACTION - 1));
        Self {
            outer: outer.wrapping_add(HALVES),
            middle: middle.wrapping_add(1 << (Self::MIDDLE_FRACTION + SPARE - 1)),
            outer_step,
            middle_step,
            colour: core::marker::PhantomData,
        }
    }

    /// Out of line: within a walk, its registers would be taken.
    #[inline(never)]
    fn fill(mut self, row: &mut [C]) {
        for pixel in row {
            *pixel = self.next();
        }
    }

    #[inline(always)]
    fn next(&mut self) -> C {
        let high = self.outer >> (16 + HALF_WORD_FRACTION);
        let low = (self.outer >> HALF_WORD_FRACTION) & 31;
        let middle = self.middle >> (32 - C::GREEN_BITS);
        self.outer = self.outer.wrapping_add(self.outer_step);
        self.middle = self.middle.wrapping_add(self.middle_step);
        let bits = low | (middle << 5) | (high << (5 + C::GREEN_BITS));
        #[allow(clippy::cast_possible_truncation, reason = "16 bits at most, see the module")]
        let bits = bits as u16;
        C::from_halfword(bits)
    }
}

#[allow(private_bounds, reason = "no other colours can have it")]
impl<C: Packed> Gouraud<C, PACKED> {
    /// Emits the spans in pieces, each with its words.
    #[inline]
    fn pieces<E>(&self, clip: &PixelRect, emit: impl FnMut(Rectangle, Words<C>) -> Result<(), E>) -> Result<(), E> {
        let Some(oriented) = Oriented::new(&self.triangle) else { return Ok(()) };
        let values = oriented.ordered(&self.colours).map(|colour| {
            let [high, middle, low] = colour.in_order();
            [high << HALF_WORD_FRACTION, middle << Words::<C>::MIDDLE_FRACTION, low << HALF_WORD_FRACTION]
        });
        match oriented.narrow(&values) {
            Some(area) => self.pieces_by(&oriented, &values, area, clip, emit),
            None => self.pieces_by(&oriented, &values, oriented.area, clip, emit),
        }
    }

    #[inline]
    fn pieces_by<W: Word, E>(
        &self,
        oriented: &Oriented,
        values: &[[i32; 3]; 3],
        area: W,
        clip: &PixelRect,
        mut emit: impl FnMut(Rectangle, Words<C>) -> Result<(), E>,
    ) -> Result<(), E> {
        let make = |start| Joined::new(Planes::new(&oriented.vertices, values, area, start));
        let mut step = None;
        walk(&self.triangle, clip, make, |span, joined: &Joined<W, PackedUnits, 3, 2>| {
            let step = *step.get_or_insert_with(|| joined.rounded_step());
            const PIECE: u32 = PIECE_PX;
            let mut area = row_area(&span);
            if area.size.width <= PIECE {
                return emit(area, Words::new(joined.words, step));
            }
            let (mut joined, mut rest) = (joined.clone(), area.size.width);
            while rest > 0 {
                joined.go_to(area.top_left.y, area.top_left.x);
                area.size.width = rest.min(PIECE);
                emit(area, Words::new(joined.words, step))?;
                area.top_left.x = area.top_left.x.wrapping_add_unsigned(PIECE);
                rest = rest.saturating_sub(PIECE);
            }
            Ok(())
        })
    }
}
