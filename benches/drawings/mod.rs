//! Real drawings: what the bench, the charts and the firmware draw beside the scenes.
//!
//! Taken in by `#[path]`, hence `no_std`, without allocation and without dependencies; [`load`] is for hosts. What the
//! drawings are, where they come from and how they are made says `README.md`; all are meant for 320 x 240 pixels.
//!
//! # Format
//!
//! ```text
//! file     = "DRW1" shape*                                until the file ends
//! shape    = bytes of the rest; red, green, blue; rule; contour*
//! contour  = vertices; bytes of the rest; (dx, dy)*
//! ```
//!
//! Colours and the rule (1 for even-odd, 0 for non-zero) are bytes. All else are LEB128 numbers, seven bits in each
//! byte, the lowest first; the eighth says that there are more. `dx` and `dy` have a sign, in zigzag (0, -1, 1, -2, ...
//! are 0, 1, 2, 3, ...): the steps from the vertex before, the first from (0, 0), in 1/256 pixel. Contours are closed:
//! the first vertex is not there again.

#![allow(dead_code, reason = "each program that takes this file in uses the part it measures")]
#![allow(unused_imports, reason = "each program that takes this file in uses the part it measures")]

#[cfg(not(target_os = "none"))]
mod chart;
#[cfg(not(target_os = "none"))]
mod loaded;

#[cfg(not(target_os = "none"))]
pub(crate) use chart::noisy_chart;
#[cfg(not(target_os = "none"))]
pub(crate) use loaded::{Drawing, Shape, load};

/// The countries of the world at 1 : 110,000,000, a shape each.
pub(crate) const COUNTRIES: &[u8] = include_bytes!("countries.bin");
/// All coast lines of the world at 1 : 50,000,000, as one shape.
pub(crate) const COAST: &[u8] = include_bytes!("coast.bin");
/// Two pages of filled icons of 24 px.
pub(crate) const ICONS: &[u8] = include_bytes!("icons.bin");
/// Two pages of icons of 24 px that are made of strokes, outlined.
pub(crate) const STROKED_ICONS: &[u8] = include_bytes!("stroked-icons.bin");
/// Twelve people, drawn by hand.
pub(crate) const PEEPS: &[u8] = include_bytes!("peeps.bin");
/// The countries of the world at 1 : 50,000,000 with their borders, a graticule, cities; strokes outlined.
pub(crate) const STROKED_WORLD: &[u8] = include_bytes!("stroked-world.bin");
/// A gauge: rim, zones, ticks, needle; strokes outlined.
pub(crate) const GAUGE: &[u8] = include_bytes!("gauge.bin");
/// A paragraph in letters of 12 px.
pub(crate) const TEXT: &[u8] = include_bytes!("text.bin");

/// Every drawing with its name.
pub(crate) const DRAWINGS: [(&str, &[u8]); 8] = [
    ("countries", COUNTRIES),
    ("coast", COAST),
    ("icons", ICONS),
    ("stroked-icons", STROKED_ICONS),
    ("peeps", PEEPS),
    ("stroked-world", STROKED_WORLD),
    ("gauge", GAUGE),
    ("text", TEXT),
];

/// The shapes of a drawing, first to last, each drawn over those before it. None of what is not a drawing.
pub(crate) fn shapes(drawing: &[u8]) -> EncodedShapes<'_> {
    EncodedShapes { rest: drawing.strip_prefix(b"DRW1").unwrap_or_default() }
}

/// See [`shapes`].
#[derive(Debug, Clone)]
pub(crate) struct EncodedShapes<'a> {
    rest: &'a [u8],
}

/// What is filled in one colour.
#[derive(Debug, Clone)]
pub(crate) struct EncodedShape<'a> {
    pub(crate) rgb: [u8; 3],
    pub(crate) even_odd: bool,
    pub(crate) contours: EncodedContours<'a>,
}

/// The contours of a shape.
#[derive(Debug, Clone)]
pub(crate) struct EncodedContours<'a> {
    rest: &'a [u8],
}

/// The vertices of a contour, in 1/256 pixel.
#[derive(Debug, Clone)]
pub(crate) struct EncodedContour<'a> {
    vertices: usize,
    last: [i32; 2],
    rest: &'a [u8],
}

impl<'a> Iterator for EncodedShapes<'a> {
    type Item = EncodedShape<'a>;

    fn next(&mut self) -> Option<EncodedShape<'a>> {
        let bytes = take_number(&mut self.rest)?;
        let (shape, rest) = self.rest.split_at_checked(bytes as usize)?;
        self.rest = rest;
        let (&[r, g, b, rule], rest) = shape.split_first_chunk()?;
        Some(EncodedShape { rgb: [r, g, b], even_odd: rule == 1, contours: EncodedContours { rest } })
    }
}

impl<'a> Iterator for EncodedContours<'a> {
    type Item = EncodedContour<'a>;

    fn next(&mut self) -> Option<EncodedContour<'a>> {
        let vertices = take_number(&mut self.rest)? as usize;
        let bytes = take_number(&mut self.rest)?;
        let (contour, rest) = self.rest.split_at_checked(bytes as usize)?;
        self.rest = rest;
        Some(EncodedContour { vertices, last: [0, 0], rest: contour })
    }
}

impl Iterator for EncodedContour<'_> {
    type Item = [i32; 2];

    fn next(&mut self) -> Option<[i32; 2]> {
        self.vertices = self.vertices.checked_sub(1)?;
        let dx = unzigzag(take_number(&mut self.rest)?);
        let dy = unzigzag(take_number(&mut self.rest)?);
        self.last = [self.last[0].wrapping_add(dx), self.last[1].wrapping_add(dy)];
        Some(self.last)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.vertices, Some(self.vertices))
    }
}

impl ExactSizeIterator for EncodedContour<'_> {}

const fn unzigzag(number: u32) -> i32 {
    (number >> 1).cast_signed() ^ -(number & 1).cast_signed()
}

fn take_number(bytes: &mut &[u8]) -> Option<u32> {
    let mut number = 0;
    for shift in (0..32).step_by(7) {
        let (&byte, rest) = bytes.split_first()?;
        *bytes = rest;
        number |= u32::from(byte & 0x7f) << shift;
        if byte < 0x80 {
            return Some(number);
        }
    }
    None
}
