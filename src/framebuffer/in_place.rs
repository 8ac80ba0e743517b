//! Blending in packed memory.

use embedded_graphics_core::geometry::Point;

use crate::framebuffer::{Framebuffer, Layout, PackedColor, Pages, Rows, Surface};

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
    (@blend ($($generics:tt)*) $target:ty, $layout:ty, ($($bounds:tt)*), $blend:ty, $mix:ident, $over:ident) => {
        impl<$($generics)*> $crate::blend::Blend<$target> for $blend
        where
            C: PackedColor + $crate::blend::$mix,
            $layout: Layout<C, Unit = u8>,
            $($bounds)*
        {
            #[inline]
            fn run(
                &self,
                target: &mut $target,
                start: Point,
                colour: C,
                alphas: &[u8],
            ) -> Result<(), core::convert::Infallible> {
                let over = move |backdrop, alpha| colour.$over(backdrop, alpha);
                $crate::framebuffer::mix_run(target.surface(), start, alphas, over);
                Ok(())
            }

            #[inline]
            fn fill(
                &self,
                target: &mut $target,
                start: Point,
                width: u32,
                colour: C,
            ) -> Result<(), core::convert::Infallible> {
                target.surface().fill_right(start, width, colour);
                Ok(())
            }
        }
    };
    (($($generics:tt)*) $target:ty, $layout:ty, $bounds:tt) => {
        impl_in_place!(@blend ($($generics)*) $target, $layout, $bounds, $crate::blend::InPlace, Mix, over);
        impl_in_place!(@blend ($($generics)*) $target, $layout, $bounds,
            $crate::blend::Linear<$crate::blend::InPlace>, MixLinear, over_linear);
    };
}

pub(crate) use impl_in_place;

impl_in_place!((C, O, S) Framebuffer<C, Rows<O>, S>, Rows<O>, (S: AsRef<[u8]> + AsMut<[u8]>));
impl_in_place!((C, O, S) Framebuffer<C, Pages<O>, S>, Pages<O>, (S: AsRef<[u8]> + AsMut<[u8]>));
