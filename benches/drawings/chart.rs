//! A chart as sensors draw it: more samples than the display has columns.

use super::{Drawing, Shape};

/// The left edge, the base line and how far the samples reach, in 1/256 pixel.
const LEFT: i32 = 40 * 256;
const WIDTH: i32 = 240 * 256;
const BASE: i32 = 220 * 256;
const MIDDLE: i32 = 120 * 256;
const NOISE: i32 = 80 * 256;

/// The area below so many samples of noise, 240 pixels wide, as one shape.
pub(crate) fn noisy_chart(samples: i32) -> Drawing {
    let mut noise = Noise(0x5EED);
    let last = (samples - 1).max(1);
    let x = |sample: i32| LEFT + (i64::from(WIDTH) * i64::from(sample) / i64::from(last)) as i32;
    let curve = (0..samples).map(|sample| [x(sample), MIDDLE + noise.within(NOISE)]);
    let contour = [[LEFT, BASE]].into_iter().chain(curve).chain([[LEFT + WIDTH, BASE]]).collect();
    Drawing { shapes: vec![Shape { rgb: [0x2b, 0x7b, 0xba], even_odd: false, contours: vec![contour] }] }
}

/// SplitMix64 (Steele, Lea and Flood, 2014).
struct Noise(u64);

impl Noise {
    /// A number in `-most..most`.
    fn within(&mut self, most: i32) -> i32 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        let upper = ((z ^ (z >> 31)) >> 32) as i64;
        ((upper * 2 * i64::from(most)) >> 32) as i32 - most
    }
}
