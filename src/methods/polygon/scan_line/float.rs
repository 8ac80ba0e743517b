//! x and 1/m in single precision, in pixels.

use core::ops::Range;

use super::Crossing;
use crate::methods::polygon::half_plane::ceil;

/// x and 1/m in `f32`, as the lecture notes have them.
///
/// 24 bits of x and of 1/m: x drifts by half a unit in the last place with every addition.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Float {
    x: f32,
    inverse_slope: f32,
}

impl Crossing for Float {
    type Number = f32;

    const UNUSED: Self = Self { x: 0.0, inverse_slope: 0.0 };

    fn rows(edge: [[f32; 2]; 2]) -> Option<(Range<i32>, bool)> {
        let [[_, top], [_, bottom]] = downwards(edge)?;
        Some((ceil(top - 0.5)..ceil(bottom - 0.5), edge[0][1] < edge[1][1]))
    }

    fn at_row(edge: [[f32; 2]; 2], row: i32) -> Self {
        let Some([low, high]) = downwards(edge) else { return Self::UNUSED };
        let inverse_slope = (high[0] - low[0]) / (high[1] - low[1]);
        #[allow(clippy::cast_precision_loss, reason = "rows of single precision")]
        let x = low[0] + (row as f32 + 0.5 - low[1]) * inverse_slope;
        Self { x, inverse_slope }
    }

    fn step(&mut self) {
        self.x += self.inverse_slope;
    }

    fn is_left_of(&self, other: &Self) -> bool {
        self.x < other.x
    }

    fn column(&self) -> i32 {
        ceil(self.x - 0.5)
    }
}

/// The same with edges that are kept on the scan line `Ymax`, too: what goes wrong at vertices on scan lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Closed(Float);

impl Crossing for Closed {
    type Number = f32;

    const UNUSED: Self = Self(Float::UNUSED);

    fn rows(edge: [[f32; 2]; 2]) -> Option<(Range<i32>, bool)> {
        let [[_, top], [_, bottom]] = downwards(edge)?;
        // From the first centre at or below the upper vertex to the last one at or above the lower.
        Some((ceil(top - 0.5)..1_i32.saturating_sub(ceil(0.5 - bottom)), edge[0][1] < edge[1][1]))
    }

    fn at_row(edge: [[f32; 2]; 2], row: i32) -> Self {
        Self(Float::at_row(edge, row))
    }

    fn step(&mut self) {
        self.0.step();
    }

    fn is_left_of(&self, other: &Self) -> bool {
        self.0.is_left_of(&other.0)
    }

    fn column(&self) -> i32 {
        self.0.column()
    }
}

/// The edge from its upper vertex to its lower; none for a horizontal one, or one that is not a number.
fn downwards([a, b]: [[f32; 2]; 2]) -> Option<[[f32; 2]; 2]> {
    if a[1] < b[1] {
        Some([a, b])
    } else if b[1] < a[1] {
        Some([b, a])
    } else {
        None
    }
}
