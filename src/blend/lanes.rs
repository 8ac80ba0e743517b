//! Mixing eight pixels at once, where there are registers for it.
//!
//! The sides of a span are mostly one to three pixels wide. Mixing eight of which some stay as they are takes as long as mixing
//! two or three one by one, and no processor has to guess where a run ends.

macro_rules! lane {
    ($name:ident, $lane:ident) => {
        /// One of eight colours in a register of eight lanes. See `mix_one`.
        #[inline(always)]
        pub(super) fn $name<const LOW: u32, const MIDDLE: u32, const HIGH: u32>(
            top: $lane,
            bottom: $lane,
            alpha: u8,
        ) -> $lane {
            let alpha = $lane::from(alpha);
            let channel = |shift: u32, bits: u32| {
                let mask = $lane::MAX >> ($lane::BITS - bits);
                let (top, bottom) = ((top >> shift) & mask, (bottom >> shift) & mask);
                let biased = top * alpha + bottom * (255 - alpha) + 127;
                (biased / 255) << shift
            };
            let low = channel(0, LOW);
            if MIDDLE > 0 { low | channel(LOW, MIDDLE) | channel(LOW + MIDDLE, HIGH) } else { low }
        }
    };
}

lane!(narrow_lane, u16);
lane!(wide_lane, u32);

/// `slice::fill` for rows that are mostly short: eights (below eight pixels, fours), and one more that ends where the row
/// does and may overlap the last, in the place of a loop over what is left.
#[inline(never)]
pub(super) fn fill<C: Copy>(row: &mut [C], colour: C) {
    if let Some(last) = row.last_chunk_mut::<8>() {
        last.fill(colour);
        for eight in row.chunks_exact_mut(8) {
            eight.fill(colour);
        }
    } else if let Some(last) = row.last_chunk_mut::<4>() {
        last.fill(colour);
        if let Some(first) = row.first_chunk_mut::<4>() {
            first.fill(colour);
        }
    } else {
        for pixel in row {
            *pixel = colour;
        }
    }
}
