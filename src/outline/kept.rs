//! The latest few of what is worked out by number.

use core::cell::Cell;

/// `N` of them, each in the one place that its number may be in. `N` is a power of 2.
pub(crate) struct Kept<T, const N: usize>([Cell<Option<(u64, T)>>; N]);

impl<T: Copy, const N: usize> Kept<T, N> {
    pub(crate) const fn new() -> Self {
        Self([const { Cell::new(None) }; N])
    }

    /// Neighbours are kept in different places (D. E. Knuth, "The art of computer programming", volume 3, 6.4: hashing by
    /// the golden ratio).
    #[inline]
    pub(crate) fn get(&self, number: u64, make: impl FnOnce() -> T) -> T {
        #[allow(clippy::cast_possible_truncation, reason = "any bits will do")]
        let mixed = (number ^ number >> 32) as u32;
        let place = mixed.wrapping_mul(0x9E37_79B9).checked_shr(u32::BITS - N.trailing_zeros()).unwrap_or(0);
        let Some(cell) = self.0.get(place as usize) else { return make() };
        match cell.get() {
            Some((kept, value)) if kept == number => value,
            _ => {
                let value = make();
                cell.set(Some((number, value)));
                value
            }
        }
    }
}
