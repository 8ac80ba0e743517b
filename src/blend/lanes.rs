//! Mixing eight pixels at once, where there are registers for it.
//!
//! The sides of a span are mostly one to three pixels wide. Mixing eight of which some stay as they are takes as long as mixing
//! two or three one by one, and no processor has to guess where a run ends.

use core::hint::black_box;

use embedded_graphics_core::pixelcolor::{IntoStorage, PixelColor, raw::RawData};

/// One of eight colours of three channels, of at most six bits each, in a register of eight lanes of 16 bits.
///
/// A channel is `b + q`, with `q` the nearest to `(t - b) alpha / 255`: adding the whole number `b` changes no rounding. To keep what
/// is divided positive, `q` is moved by 64, as `|t - b| alpha` is less than 64 times 255: it is `255 (q + 64) + r` with `|r| <= 127`, so
/// adding 127 and dividing gives `q + 64`, and all of it has 16 bits. The lanes of `bottom` and of the sums wrap together: what is
/// added to a channel leaves it within its bits.
#[inline(always)]
pub(super) fn narrow_lane<C, const LOW: u32, const MIDDLE: u32, const HIGH: u32>(top: C, bottom: C, alpha: u8) -> C
where
    C: PixelColor + IntoStorage + From<C::Raw>,
    u16: From<C::Storage>,
{
    const MOVED: u16 = 64;
    let (top, bottom) = (u16::from(top.into_storage()), u16::from(bottom.into_storage()));
    let channel = |shift: u32, bits: u32| {
        let part = |colour: u16| (colour >> shift) & (u16::MAX >> (u16::BITS - bits));
        let product = part(top).wrapping_sub(part(bottom)).wrapping_mul(alpha.into());
        (product.wrapping_add(255 * MOVED + 127) / 255) << shift
    };
    let moved = MOVED | (MOVED << LOW) | (MOVED << (LOW + MIDDLE));
    let sum = channel(0, LOW).wrapping_add(channel(LOW, MIDDLE)).wrapping_add(channel(LOW + MIDDLE, HIGH));
    C::Raw::from_u32(bottom.wrapping_add(sum).wrapping_sub(moved).into()).into()
}

macro_rules! lane {
    ($name:ident, $lane:ident, $divided_by_255:expr) => {
        /// One of eight colours in a register of eight lanes.
        #[inline(always)]
        pub(super) fn $name<C, const LOW: u32, const MIDDLE: u32, const HIGH: u32>(top: C, bottom: C, alpha: u8) -> C
        where
            C: PixelColor + IntoStorage + From<C::Raw>,
            $lane: From<C::Storage>,
        {
            let (top, bottom) = ($lane::from(top.into_storage()), $lane::from(bottom.into_storage()));
            let alpha = <$lane as From<u8>>::from(alpha);
            let channel = |shift: u32, bits: u32| {
                let mask = $lane::MAX >> ($lane::BITS - bits);
                let (top, bottom) = ((top >> shift) & mask, (bottom >> shift) & mask);
                $divided_by_255(top * alpha + bottom * (255 - alpha)) << shift
            };
            let low = channel(0, LOW);
            let mixed = if MIDDLE > 0 { low | channel(LOW, MIDDLE) | channel(LOW + MIDDLE, HIGH) } else { low };
            C::Raw::from_u32(mixed.into()).into()
        }
    };
}

// To the nearest, without ties. For lanes of 16 bits the compiler knows a reciprocal that takes two instructions; for wider ones
// what it knows takes eight `Rgb888` in 144, and what `mix_one` does, in 124.
lane!(grey_lane, u16, |sum: u16| (sum + 127) / 255);
lane!(wide_lane, u32, |sum: u32| (sum + 128 + ((sum + 128) >> 8)) >> 8);

/// What a lane does, in all eight.
#[inline(always)]
pub(super) fn mix_eight<C: Copy>(backdrops: &mut [C; 8], alphas: &[u8; 8], mix: impl Fn(C, u8) -> C) {
    for (backdrop, alpha) in backdrops.iter_mut().zip(alphas) {
        *backdrop = mix(*backdrop, *alpha);
    }
}

/// The same for a caller that it becomes part of.
///
/// To see what is done to all eight, the compiler has to find the alphas in memory, one by one, where it otherwise takes the word apart
/// that they were; and the colours read before any is written, as it does not know that nobody else reads them.
#[inline(always)]
pub(super) fn mix_eight_here<C: Copy>(backdrops: &mut [C; 8], alphas: &[u8; 8], mix: impl Fn(C, u8) -> C) {
    let alphas = black_box(alphas);
    let mut eight = *backdrops;
    mix_eight(&mut eight, alphas, mix);
    *backdrops = eight;
}

/// `slice::fill` for rows that are mostly short: eights (below eight pixels, fours), and one more that ends where the row
/// does and may overlap the last, in the place of a loop over what is left.
#[inline(never)]
pub(super) fn fill<C: Copy>(row: &mut [C], colour: C) {
    if row.len() >= 8 {
        fill_eights(row, colour);
    } else if let Some(last) = row.last_chunk_mut::<4>() {
        last.fill(colour);
        if let Some(first) = row.first_chunk_mut::<4>() {
            first.fill(colour);
        }
    } else if let [first, others @ ..] = row {
        *first = colour;
        if let [.., last] = others {
            *last = colour;
        }
        if let [middle, _] = others {
            *middle = colour;
        }
    }
}

/// The same for at least eight.
#[inline(always)]
pub(super) fn fill_eights<C: Copy>(row: &mut [C], colour: C) {
    if let Some(last) = row.last_chunk_mut::<8>() {
        last.fill(colour);
    }
    // By four at once; if the compiler unrolls it, as many instructions more find out where to begin.
    let (fours, rest) = row.as_chunks_mut::<32>();
    for four in fours {
        black_box(());
        four.fill(colour);
    }
    for eight in rest.as_chunks_mut::<8>().0 {
        black_box(());
        eight.fill(colour);
    }
}
