//! Roots, sines and cosines: libm's, or micromath's, which are fast and a few per cent off.

use micromath::F32Ext;

/// Whose functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Functions {
    /// libm's, right to the last bit or the one before.
    Libm,
    /// micromath's.
    Micromath,
}

impl Functions {
    /// The square root.
    pub fn sqrt(self, value: f32) -> f32 {
        match self {
            Self::Libm => libm::sqrtf(value),
            Self::Micromath => F32Ext::sqrt(value),
        }
    }

    /// Sine and cosine.
    pub fn sin_cos(self, angle: f32) -> (f32, f32) {
        match self {
            Self::Libm => libm::sincosf(angle),
            Self::Micromath => F32Ext::sin_cos(angle),
        }
    }
}

/// How a float becomes a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Rounding {
    /// `(int) value`: the fraction is cut off.
    Truncated,
    /// `floor(value + 1/2)`.
    Nearest,
}

impl Rounding {
    /// The pixel.
    pub fn pixel(self, value: f32) -> i32 {
        match self {
            Self::Truncated => value as i32,
            Self::Nearest => libm::floorf(value + 0.5) as i32,
        }
    }
}
