//! Colours of 15 or 16 bits whose channels share a word of 64 bits.
//!
//! ```text
//!   63  59 58              37 36  32 31         19 18   13 12         0
//!   [ red |     22 bits     ][ blue |   13 bits   ][ green |  13 bits  ]
//! ```
//!
//! One addition steps all three: the word is an integer, linear in the column, and a carry out of a channel is part of the next
//! one's own fraction. Blue lies where the lower half carries into the upper one, so that it needs no shift: on processors of
//! 32 bits, eight instructions a pixel.
//!
//! Words begin at columns that are multiples of 256, whatever the clip, and at 2^-13 of a level from the exact one at most; each
//! step is off by half of that. After 255 of them the error is at most `2^-13 + 255 2^-14`, and what
//! [`BinaryPlanes`] loses, `2^-7`: together less than 1/32 of a level, and so the level that is shown is within 1/2 + 1/32. Half
//! a level more in the start rounds by the shift that takes the channel out: `31 + 1/2 + 1/32 < 32` and
//! `0 + 1/2 - 1/32 > 0`, so no channel runs over.
//!
//! Where a channel changes by 64 levels a pixel no span has two pixels; there each pixel has a start of its own.

use core::{iter::repeat_with, marker::PhantomData};

use embedded_graphics_core::{
    Drawable,
    draw_target::DrawTarget,
    pixelcolor::{Bgr555, Bgr565, PixelColor, Rgb555, Rgb565, raw::RawData},
};

use crate::{
    PixelRect, Span,
    attribute::{
        Channels, Gouraud, PACKED,
        binary::BinaryPlanes,
        shaded::{row_area, row_of},
        walk::Oriented,
    },
    draw::Fill as _,
    shape::Shape as _,
    span::SpanSink,
    target::PixelRows,
};

/// Columns from the start of one word to that of the next, see the module.
const COLUMNS: i32 = 256;
const _: () = assert!((1 << 14 >> 13) + (COLUMNS - 1) + (1 << 14 >> 7) < 1 << 14 >> 5);

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
                self.pieces(&clip, |span, mut word| {
                    let area = row_area(&span);
                    let width = usize::try_from(area.size.width).unwrap_or(usize::MAX);
                    target.fill_contiguous(&area, repeat_with(|| word.next()).take(width))
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
                self.pieces(&clip, |span, word| {
                    word.fill(row_of(target, &span));
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
struct Word<C> {
    channels: u64,
    step: u64,
    colour: PhantomData<C>,
}

/// Values with 32 bits of fraction in their places.
#[inline(always)]
fn joined([high, middle, low]: [u64; 3]) -> u64 {
    let places = |value: u64, fraction: u32| value.cast_signed() >> (32 - fraction);
    let high = places(high, 22) << 37;
    let low = places(low, 13) << 19;
    high.wrapping_add(low).wrapping_add(places(middle, 13)).cast_unsigned()
}

/// The planes of triangles of any size.
#[inline(never)]
fn far(oriented: &Oriented, values: &[[i32; 3]; 3]) -> BinaryPlanes<3> {
    BinaryPlanes::new::<i64>(oriented, values)
}

impl<C: Packed> Word<C> {
    /// Out of line: within a walk, its registers would be taken.
    #[inline(never)]
    fn fill(mut self, row: &mut [C]) {
        for pixel in row {
            *pixel = self.next();
        }
    }

    #[inline(always)]
    #[allow(clippy::cast_possible_truncation, reason = "halves of words, and of those the lower 16 bits")]
    fn next(&mut self) -> C {
        let (upper, lower) = ((self.channels >> 32) as u32, self.channels as u32);
        self.channels = self.channels.wrapping_add(self.step);
        let last = (1 << C::GREEN_BITS) - 1;
        // The highest channel is where it belongs, but for the bit that colours of 15 bits have less.
        let high = (upper >> (32 - 10 - C::GREEN_BITS)) & !((last << 5) | 31);
        C::from_halfword((high | ((lower >> 13 & last) << 5) | (upper & 31)) as u16)
    }
}

#[allow(private_bounds, reason = "no other colours can have it")]
impl<C: Packed> Gouraud<C, PACKED> {
    /// Emits the spans in pieces, each with its word.
    #[inline]
    fn pieces<E>(&self, clip: &PixelRect, emit: impl FnMut(Span, Word<C>) -> Result<(), E>) -> Result<(), E> {
        let Some(oriented) = Oriented::new(&self.triangle) else { return Ok(()) };
        let values = oriented.ordered(&self.colours).map(C::in_order);
        let mut planes = BinaryPlanes::new::<i32>(&oriented, &values);
        if !oriented.is_middling() {
            planes = far(&oriented, &values);
        }
        for at in &mut planes.at {
            *at = at.wrapping_add(1 << 31);
        }
        let is_steep = |step: u64| step.wrapping_add(1 << 38) >> 39 != 0;
        let columns = if planes.right.into_iter().any(is_steep) { 1 } else { COLUMNS };
        let half = |fraction: u32| 1_u64 << (31 - fraction);
        let [high, middle, low] = planes.right;
        let step = joined([high.wrapping_add(half(22)), middle.wrapping_add(half(13)), low.wrapping_add(half(13))]);
        self.triangle.spans(clip, &mut Pieces { planes, step, columns, emit, colour: PhantomData })
    }
}

struct Pieces<C, F> {
    planes: BinaryPlanes<3>,
    step: u64,
    /// A power of two.
    columns: i32,
    emit: F,
    colour: PhantomData<C>,
}

impl<C, E, F: FnMut(Span, Word<C>) -> Result<(), E>> SpanSink for Pieces<C, F> {
    type Error = E;

    #[inline]
    fn span(&mut self, span: Span) -> Result<(), E> {
        let Span { row, columns } = span;
        let mut column = columns.start;
        loop {
            let start = column & self.columns.wrapping_neg();
            self.planes.go_to(row, start);
            let from_start = u64::from(column.wrapping_sub(start).cast_unsigned());
            let channels = joined(self.planes.at).wrapping_add(self.step.wrapping_mul(from_start));
            let end = start.saturating_add(self.columns).min(columns.end);
            (self.emit)(Span { row, columns: column..end }, Word { channels, step: self.step, colour: PhantomData })?;
            if end == columns.end {
                return Ok(());
            }
            column = end;
        }
    }
}
