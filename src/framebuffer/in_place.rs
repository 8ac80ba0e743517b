//! Blending in packed memory.

use embedded_graphics_core::geometry::Point;

use crate::{
    blend::{Blend, InPlace, Linear, Mix, MixLinear},
    framebuffer::{Framebuffer, Layout, PackedColor, Pages, Rows, Surface},
};

/// Mixes each of a run with what is there: its line is looked up once.
#[inline(always)]
pub(crate) fn mix_run<C: PackedColor, L: Layout<C>>(
    surface: Surface<'_, C, L>,
    start: Point,
    alphas: &[u8],
    over: impl Fn(C, u8) -> C,
) {
    let mut rest = alphas.iter();
    surface.change(start, alphas.len(), |backdrop| match rest.next() {
        Some(&alpha) => over(backdrop, alpha),
        None => backdrop,
    });
}

macro_rules! impl_in_place {
    ($target:ident, $surface:ident: $($layout:ident)+) => {
        $(impl<C, O, S> Blend<$target<C, $layout<O>, S>> for InPlace
        where
            C: PackedColor + Mix,
            $layout<O>: Layout<C, Unit = u8>,
            S: AsRef<[u8]> + AsMut<[u8]>,
        {
            #[inline]
            fn run(
                &self,
                target: &mut $target<C, $layout<O>, S>,
                start: Point,
                colour: C,
                alphas: &[u8],
            ) -> Result<(), core::convert::Infallible> {
                mix_run(target.$surface(), start, alphas, move |backdrop, alpha| colour.over(backdrop, alpha));
                Ok(())
            }

            #[inline]
            fn fill(
                &self,
                target: &mut $target<C, $layout<O>, S>,
                start: Point,
                width: u32,
                colour: C,
            ) -> Result<(), core::convert::Infallible> {
                target.$surface().fill_right(start, width, colour);
                Ok(())
            }
        }

        impl<C, O, S> Blend<$target<C, $layout<O>, S>> for Linear<InPlace>
        where
            C: PackedColor + MixLinear,
            $layout<O>: Layout<C, Unit = u8>,
            S: AsRef<[u8]> + AsMut<[u8]>,
        {
            #[inline]
            fn run(
                &self,
                target: &mut $target<C, $layout<O>, S>,
                start: Point,
                colour: C,
                alphas: &[u8],
            ) -> Result<(), core::convert::Infallible> {
                mix_run(target.$surface(), start, alphas, move |backdrop, alpha| colour.over_linear(backdrop, alpha));
                Ok(())
            }

            #[inline]
            fn fill(
                &self,
                target: &mut $target<C, $layout<O>, S>,
                start: Point,
                width: u32,
                colour: C,
            ) -> Result<(), core::convert::Infallible> {
                target.$surface().fill_right(start, width, colour);
                Ok(())
            }
        })+
    };
}

impl_in_place!(Framebuffer, surface_at_origin: Rows Pages);
