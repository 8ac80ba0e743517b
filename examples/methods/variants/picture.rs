//! The two sinks.

use core::convert::Infallible;

use spanfill::{Fragment, FragmentSink};

/// The screen's width in pixels.
pub const WIDTH: i32 = 320;
/// The screen's height in pixels.
pub const HEIGHT: i32 = 240;

const PIXELS: usize = (WIDTH * HEIGHT) as usize;

/// Where a pixel of the screen lies in memory.
#[inline(always)]
fn index(x: i32, y: i32) -> Option<usize> {
    let inside = x.cast_unsigned() < WIDTH.cast_unsigned() && y.cast_unsigned() < HEIGHT.cast_unsigned();
    inside.then_some((y * WIDTH + x) as usize)
}

/// For the tests: everything that can be told of each pixel.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// How often it came.
    pub count: [u16; PIXELS],
    /// What it last came with.
    pub coverage: [u8; PIXELS],
    pub depth: [u16; PIXELS],
    pub attributes: [[i32; 4]; PIXELS],
    /// How many pixels the method looked at.
    pub visited: u64,
    /// How many came from outside of the screen.
    pub outside: u64,
}

impl Picture {
    /// Of some 1.8 MB: keep it in a `static` or a box.
    pub const fn new() -> Self {
        Self {
            count: [0; PIXELS],
            coverage: [0; PIXELS],
            depth: [0; PIXELS],
            attributes: [[0; 4]; PIXELS],
            visited: 0,
            outside: 0,
        }
    }
}

impl<const N: usize> FragmentSink<N> for Picture {
    type Error = Infallible;

    fn fragment(&mut self, fragment: Fragment<N>) -> Result<(), Infallible> {
        let Some(at) = index(fragment.x, fragment.y) else {
            self.outside += 1;
            return Ok(());
        };
        self.count[at] = self.count[at].saturating_add(1);
        self.coverage[at] = fragment.coverage;
        self.depth[at] = fragment.depth;
        for (to, from) in self.attributes[at].iter_mut().zip(fragment.attributes) {
            *to = from;
        }
        Ok(())
    }

    fn visit(&mut self, _: i32, _: i32) {
        self.visited += 1;
    }
}

/// For the clock: RGB565, as a firmware's framebuffer; blended where a pixel is covered in part.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame(pub [u16; PIXELS]);

impl Frame {
    /// Black, of 150 KB: keep it in a `static` or a box.
    pub const fn new() -> Self {
        Self([0; PIXELS])
    }
}

impl<const N: usize> FragmentSink<N> for Frame {
    type Error = Infallible;

    #[inline(always)]
    fn fragment(&mut self, fragment: Fragment<N>) -> Result<(), Infallible> {
        let Some(pixel) = index(fragment.x, fragment.y).and_then(|at| self.0.get_mut(at)) else { return Ok(()) };
        let mut colour = 0xFFFF_u16;
        for attribute in fragment.attributes {
            colour = colour.wrapping_shl(5) ^ attribute as u16;
        }
        if fragment.coverage == 255 {
            *pixel = colour;
        } else {
            let alpha = u32::from(fragment.coverage);
            let mix = |shift: u32, mask: u32| {
                let (s, d) = ((u32::from(colour) >> shift) & mask, (u32::from(*pixel) >> shift) & mask);
                ((s * alpha + d * (255 - alpha) + 127) / 255) << shift
            };
            *pixel = (mix(11, 31) | mix(5, 63) | mix(0, 31)) as u16;
        }
        Ok(())
    }
}
