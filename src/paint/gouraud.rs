//! Gouraud triangles as paints: beyond their outline, the nearest colour in the range of their vertices.

use crate::{
    Vertex,
    attribute::{Barycentric, Channels, Gouraud},
    paint::Paint,
};

/// At a pixel centre inside, the exact colour; outside, as at the edge of an anti-aliased triangle, each channel goes on
/// in its plane, kept within the range of the vertices. Without an area it has the first vertex' colour.
///
/// Costs a division of 128 bits a channel and pixel; [`Gouraud`]'s own drawing is the fast one.
impl<C: Channels<N>, const N: usize> Paint<C> for GouraudPaint<C, N> {
    fn row(&self, row: i32, column: i32) -> impl Iterator<Item = C> {
        let mut next = column;
        core::iter::repeat_with(move || {
            let centre = Vertex::pixel(next, row);
            next = next.wrapping_add(1);
            self.at(centre)
        })
    }
}

impl<C: Channels<N>, const N: usize> GouraudPaint<C, N> {
    fn at(&self, point: Vertex) -> C {
        let [a, b, c] = &self.channels;
        let Some(barycentric) = &self.barycentric else { return C::from_channels(*a) };
        let weights = barycentric.weights_at(point);
        let mut channels = *a;
        for (channel, (b, c)) in channels.iter_mut().zip(b.iter().zip(c)) {
            let (low, high) = ((*channel).min(*b).min(*c), (*channel).max(*b).max(*c));
            *channel = weights.mix([*channel, *b, *c]).clamp(low, high);
        }
        C::from_channels(channels)
    }
}

/// See [`Gouraud::paint`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct GouraudPaint<C, const N: usize> {
    barycentric: Option<Barycentric>,
    channels: [[i32; N]; 3],
    colour: core::marker::PhantomData<C>,
}

impl<C> Gouraud<C> {
    /// Its colours as a [`Paint`], for an anti-aliased triangle, or a [`Mosaic`](crate::Mosaic).
    pub fn paint<const N: usize>(&self) -> GouraudPaint<C, N>
    where
        C: Channels<N>,
    {
        GouraudPaint {
            barycentric: Barycentric::new(&self.triangle),
            channels: self.colours.map(C::channels),
            colour: core::marker::PhantomData,
        }
    }
}
