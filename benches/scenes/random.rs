//! Random numbers that are the same everywhere and forever.

/// SplitMix64 (Steele, Lea and Flood, 2014): a counter, scrambled. Every seed is a good one.
#[derive(Debug, Clone)]
pub(crate) struct Random(u64);

impl Random {
    pub(crate) const fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) const fn next_u64(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number in `0..bound`, for a positive `bound`.
    ///
    /// The high half of a 32 x 32 bit product: no division, and off from uniform by less than `bound / 2^32`.
    #[allow(clippy::cast_possible_truncation, reason = "the product's high half is less than `bound`")]
    pub(crate) const fn below(&mut self, bound: i32) -> i32 {
        (((self.next_u64() >> 32) * bound.unsigned_abs() as u64) >> 32) as i32
    }
}
