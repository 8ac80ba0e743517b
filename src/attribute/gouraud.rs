//! Colours that vary across a triangle (H. Gouraud, "Continuous shading of curved surfaces", 1971).

use embedded_graphics_core::{
    Drawable, draw_target::DrawTarget, geometry::Dimensions, pixelcolor::PixelColor, primitives::Rectangle,
};

use crate::{
    PixelRect, Triangle,
    attribute::{
        Affine, Attributes as _, Channels,
        joined::{Joined, Units},
        plane::Planes,
        shaded::row_of,
        walk::{Oriented, walk},
        word::Word,
    },
    draw::Fill as _,
    shape::Shape as _,
    target::PixelRows,
};

/// Every channel is stepped by itself: the level that is nearest to the exact one.
pub const EXACT: bool = false;
/// Channels share a word: a level within 1/2 + 1/32 of the exact one, in little more than half the instructions. For colours of
/// 15 or 16 bits.
pub const PACKED: bool = true;

/// A triangle whose colour varies linearly between those of its vertices.
///
/// Each channel has the level of the target's colour that is nearest to the exact one, at every pixel centre, and so
/// never leaves the range of the three vertices. Triangles that share an edge and its colours agree along it. Where
/// the three colours are equal it is filled as any shape of one colour is.
///
/// With [`PACKED`] as its parameter, channels are within 1/2 + 1/32 of a level.
///
/// ```text
///    red * . . . . . . * green
///          .         .
///            .     .
///              . .
///               * blue
/// ```
///
/// No errors but the target's.
///
/// # Cost
///
/// Each channel is an attribute: see [`Affine`]. Packed, one addition of 64 bits a pixel for three channels, and one division of 32
/// bits for the whole triangle, however large it is. On a Cortex-M4, that is little more than half the instructions of exact
/// channels, and 5.3 KB of flash at level 3 in place of 14.6.
///
/// # Examples
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*};
/// use spanfill::{Gouraud, Triangle, prelude::*};
///
/// let triangle = Triangle::new(Point::new(0, 0), Point::new(31, 0), Point::new(0, 31));
/// let mut display = MockDisplay::new();
/// let colours = [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE];
/// Gouraud::new(triangle, colours).draw(&mut display)?;
/// assert_eq!(display.get_pixel(Point::new(8, 8)), Some(Rgb565::new(15, 16, 8)));
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Gouraud<C, const HOW: bool = EXACT> {
    /// Where it is.
    pub triangle: Triangle,
    /// The colours of its vertices.
    pub colours: [C; 3],
}

impl<C> Gouraud<C> {
    /// A triangle with the colour of each vertex.
    #[inline]
    pub const fn new(triangle: Triangle, colours: [C; 3]) -> Self {
        Self { triangle, colours }
    }
}

impl<C> Gouraud<C, PACKED> {
    /// The same with packed channels.
    #[inline]
    pub const fn packed(triangle: Triangle, colours: [C; 3]) -> Self {
        Self { triangle, colours }
    }
}

impl<C: PixelColor, const HOW: bool> Gouraud<C, HOW> {
    /// The colour, where there is only one.
    #[inline]
    pub(super) fn flat(&self) -> Option<C> {
        let [a, b, c] = self.colours;
        (a == b && a == c).then_some(a)
    }
}

impl<C: PixelColor, const HOW: bool> Dimensions for Gouraud<C, HOW> {
    #[inline]
    fn bounding_box(&self) -> Rectangle {
        self.triangle.bounds().into()
    }
}

impl<C: PixelColor> Gouraud<C> {
    /// Draws into the rows of a target's memory: the same pixels, in less time.
    pub fn draw_on<D: PixelRows<Color = C>, const N: usize>(&self, target: &mut D) -> Result<(), D::Error>
    where
        C: Channels<N>,
    {
        if let Some(colour) = self.flat() {
            return self.triangle.filled(colour).draw(target);
        }
        let clip = PixelRect::from(target.bounding_box());
        let Some(oriented) = Oriented::new(&self.triangle) else { return Ok(()) };
        // Channels are close.
        match oriented.near() {
            Some(area) => self.rows(&oriented, area, &clip, target),
            None => self.rows(&oriented, oriented.area, &clip, target),
        }
    }

    #[inline]
    fn rows<W: Word, D: PixelRows<Color = C>, const N: usize>(
        &self,
        oriented: &Oriented,
        area: W,
        clip: &PixelRect,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        C: Channels<N>,
    {
        let values = oriented.ordered(&self.colours).map(C::channels);
        let mut joined = Joined::<W, BitsOf<C>, N, 1>::new(Planes::new(&oriented.vertices, &values, area));
        walk(&self.triangle, clip, &mut joined, |span, joined| {
            fill_joined(row_of(target, &span), joined);
            Ok(())
        })
    }

    /// Its channels as attributes.
    #[inline]
    pub fn affine<const N: usize>(&self) -> Affine<N>
    where
        C: Channels<N>,
    {
        Affine::new(self.triangle, self.colours.map(C::channels))
    }
}

/// Channels joined to the bits of a colour.
#[derive(Debug)]
struct BitsOf<C>(core::marker::PhantomData<C>);

impl<C: Channels<N>, const N: usize> Units<N, 1> for BitsOf<C> {
    const UNITS: [[u32; 1]; N] = {
        let mut units = [[0]; N];
        let mut index = 0;
        while index < N {
            #[allow(clippy::indexing_slicing, reason = "run by the compiler, which would fail")]
            let unit = C::UNITS[index];
            #[allow(clippy::indexing_slicing, reason = "run by the compiler, which would fail")]
            let place = &mut units[index];
            *place = [unit];
            index += 1;
        }
        units
    };
}

/// Out of line: within a walk, its registers would be taken.
#[inline(never)]
fn fill_joined<W: Word, C: Channels<N>, const N: usize>(row: &mut [C], joined: &Joined<W, BitsOf<C>, N, 1>) {
    joined.write(row, |pixel, [bits]| *pixel = C::from_bits(bits));
}

macro_rules! impl_drawable {
    ($($colour:ident)+) => {
        $(impl Drawable for Gouraud<$colour> {
            type Color = $colour;
            type Output = ();

            fn draw<D: DrawTarget<Color = $colour>>(&self, target: &mut D) -> Result<(), D::Error> {
                if let Some(colour) = self.flat() {
                    return self.triangle.filled(colour).draw(target);
                }
                self.affine().shaded(<$colour>::from_channels).draw(target)
            }
        })+
    };
}

mod drawable {
    use embedded_graphics_core::pixelcolor::{
        Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, Rgb555, Rgb565, Rgb666, Rgb888,
    };

    use super::*;

    impl_drawable!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888 Gray2 Gray4 Gray8 BinaryColor);
}
