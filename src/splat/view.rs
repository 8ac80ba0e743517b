//! Where a model is seen from.

use core::fmt;

/// A view needs something in front of it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct NoView;

impl fmt::Display for NoView {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a view needs a positive focal length and near plane, and axes of at most 16384")
    }
}

impl core::error::Error for NoView {}

/// An eye and where it looks.
///
/// ```text
///           y (down)
///           |  / z (forwards)      a point is seen at the middle of the screen, and `focal x / z`, `focal y / z` from there
///           | /
///     eye   *---- x (right)
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct View {
    pub(super) eye: [i32; 3],
    pub(super) axes: [[i32; 3]; 3],
    pub(super) middle: [i32; 2],
    pub(super) focal: i32,
    pub(super) near: i32,
}

impl View {
    /// A view.
    ///
    /// - `eye`: in units of the model's, at most 2^27 from 0.
    /// - `axes`: right, down and forwards, of length 16384, at right angles.
    /// - `middle`: the column and the row that z points to, in 1/256 px.
    /// - `focal`: how large what is as far away as it is large is seen, in 1/256 px: at most 2^20.
    /// - `near`: what is nearer than that is not seen, in units of the model's.
    ///
    /// # Errors
    ///
    /// [`NoView`] where that makes no view.
    pub fn new(eye: [i32; 3], axes: [[i32; 3]; 3], middle: [i32; 2], focal: i32, near: i32) -> Result<Self, NoView> {
        let long = axes.iter().flatten().any(|part| part.unsigned_abs() > 16384);
        let far = eye.iter().any(|part| part.unsigned_abs() > 1 << 27);
        if long || far || !(1..=1 << 20).contains(&focal) || near < 1 {
            return Err(NoView);
        }
        Ok(Self { eye, axes, middle, focal, near })
    }

    /// A point as the eye sees it: right, down, forwards. Coordinates of 28 bits, axes of 15: sums of 45.
    #[inline(always)]
    pub(super) fn seen(&self, offset: [i64; 3]) -> [i64; 3] {
        let [x, y, z] = offset;
        self.axes.map(|[a, b, c]| (x * i64::from(a) + y * i64::from(b) + z * i64::from(c)) >> 14)
    }
}
