//! What a method of the literature makes of a shape: fragments, in whatever order it finds them.

/// A pixel that a shape has a part in: where it is, how much of it is covered, and what varies across the shape.
///
/// `N` attributes come in the unit that the vertices had them in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Fragment<const N: usize = 0> {
    /// The column, in whole pixels.
    pub x: i32,
    /// The row, in whole pixels.
    pub y: i32,
    /// How much of the pixel is covered, in 255ths.
    pub coverage: u8,
    /// The depth, 0 in front; 0 where the method knows none.
    pub depth: u16,
    /// What is interpolated.
    pub attributes: [i32; N],
}

impl Fragment {
    /// A pixel that is wholly covered, without attributes.
    #[inline(always)]
    pub const fn pixel(x: i32, y: i32) -> Self {
        Self { x, y, coverage: 255, depth: 0, attributes: [] }
    }

    /// A pixel of which `coverage` 255ths are covered.
    #[inline(always)]
    pub const fn covered(x: i32, y: i32, coverage: u8) -> Self {
        Self { x, y, coverage, depth: 0, attributes: [] }
    }
}

/// Receives fragments: in any order, and more than once where the method does that.
///
/// Everything lies inside the clip that the method was given.
pub trait FragmentSink<const N: usize = 0> {
    /// What can fail in the sink; it ends the walk and is handed to the caller.
    type Error;

    /// Takes one fragment.
    ///
    /// # Errors
    ///
    /// Whatever the sink cannot do; the method stops at once.
    fn fragment(&mut self, fragment: Fragment<N>) -> Result<(), Self::Error>;

    /// Takes note that the method looks at a pixel, which may turn out not to be covered: what a traversal costs.
    #[inline(always)]
    fn visit(&mut self, x: i32, y: i32) {
        let _ = (x, y);
    }
}
