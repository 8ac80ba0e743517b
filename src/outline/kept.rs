//! The latest few of what is worked out by number.

use core::cell::Cell;

/// Hosts keep more than boards: vertices, at 24 bytes each.
pub(crate) const KEPT_VERTICES: usize = if cfg!(target_pointer_width = "64") { 1024 } else { 32 };

/// `N` of them, each in the one place that its number may be in. `N` is a power of 2.
pub(crate) struct Kept<T, const N: usize>([Cell<(u64, T)>; N]);

/// No number.
const NONE: u64 = u64::MAX;

impl<T: Copy, const N: usize> Kept<T, N> {
    pub(crate) fn new(nothing: T) -> Self {
        Self(core::array::from_fn(|_| Cell::new((NONE, nothing))))
    }

    /// Neighbours are kept in different places (D. E. Knuth, "The art of computer programming", volume 3, 6.4: hashing by
    /// the golden ratio).
    #[inline]
    fn cell(&self, number: u64) -> Option<&Cell<(u64, T)>> {
        #[allow(clippy::cast_possible_truncation, reason = "any bits will do")]
        let mixed = (number ^ number >> 32) as u32;
        let place = mixed.wrapping_mul(0x9E37_79B9) >> (u32::BITS - N.trailing_zeros());
        self.0.get(place as usize)
    }

    #[inline]
    pub(crate) fn find(&self, number: u64) -> Option<T> {
        let (kept, value) = self.cell(number)?.get();
        (kept == number).then_some(value)
    }

    #[inline]
    pub(crate) fn keep(&self, number: u64, value: T) {
        if let Some(cell) = self.cell(number) {
            cell.set((number, value));
        }
    }

    #[inline]
    pub(crate) fn get(&self, number: u64, make: impl FnOnce() -> T) -> T {
        self.find(number).unwrap_or_else(|| {
            let value = make();
            self.keep(number, value);
            value
        })
    }
}
