//! What interpolation hands on: a span and the values at its centres.

use crate::span::Span;

/// The values at the centres of a span, from left to right. They have no end: the span says how many there are.
pub trait AttributeRow<const N: usize>: Iterator<Item = [i32; N]> {
    /// Gives every item of `into` its values, from left to right: as by the iterator, and faster where values come in
    /// pieces.
    #[inline(always)]
    fn write<T>(&mut self, into: &mut [T], mut write: impl FnMut(&mut T, [i32; N]))
    where
        Self: Sized,
    {
        for (item, values) in into.iter_mut().zip(self) {
            write(item, values);
        }
    }
}

/// Receives the spans of a triangle with what varies across it.
///
/// Rows go down, each pixel comes once, and everything lies inside the clip that the triangle was given.
pub trait AttributeSink<const N: usize> {
    /// What can fail in the sink; it ends the walk and is handed to the caller.
    type Error;

    /// Takes one span, and the values and depths at its centres. Where no depths are interpolated they are 0.
    ///
    /// # Errors
    ///
    /// Whatever the sink cannot do; the walk stops at once.
    fn span(
        &mut self,
        span: Span,
        values: impl AttributeRow<N>,
        depths: impl Iterator<Item = u16> + Clone,
    ) -> Result<(), Self::Error>;
}
