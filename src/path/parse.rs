//! SVG path data into elements, when the program is compiled or when it runs.
//!
//! The grammar is that of SVG 1.1 and SVG 2 (section 9.3.9), as viewers read it: commands in both cases, repeated
//! without their letter, numbers that need nothing between them where they cannot be misread (`.5.5`, `1-2`), flags of
//! arcs that need nothing ever (`a1 1 0 01.5 2`).

use core::fmt;

use crate::{
    Angle,
    outline::{FinePoint, clamp_fine},
    path::{
        Path,
        arc::Ends,
        element::Element,
        number::{PARSED_BITS, Scale, number},
    },
};

/// What is wrong with SVG path data, and where.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct PathError {
    /// Bytes before what is wrong.
    pub position: usize,
    kind: Kind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Kind {
    NoMove,
    NoCommand,
    NoNumber,
    NoFlag,
    WrongLength,
}

impl PathError {
    /// In words.
    pub const fn message(&self) -> &'static str {
        match self.kind {
            Kind::NoMove => "SVG path data must begin with a move: M or m",
            Kind::NoCommand => "SVG path data: a command is expected, one of MmLlHhVvCcSsQqTtAaZz",
            Kind::NoNumber => "SVG path data: a number is expected",
            Kind::NoFlag => "SVG path data: a flag is expected, 0 or 1",
            Kind::WrongLength => "the path data has another number of elements",
        }
    }
}

impl fmt::Display for PathError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}, at byte {}", self.message(), self.position)
    }
}

impl core::error::Error for PathError {}

impl Path<'_> {
    /// How many elements there are in SVG path data.
    ///
    /// # Errors
    ///
    /// Where the data is wrong.
    pub const fn count_svg(data: &str) -> Result<usize, PathError> {
        let mut parser = SvgElements::new(data, 1, 1);
        let mut count = 0;
        loop {
            match parser.next_element() {
                Ok(Some(_)) => count += 1,
                Ok(None) => return Ok(count),
                Err(error) => return Err(error),
            }
        }
    }

    /// The elements of SVG path data, of which there must be `N`: see [`count_svg`](Self::count_svg). A unit is so many
    /// pixels as the fraction says.
    ///
    /// # Errors
    ///
    /// Where the data is wrong, or has another number of elements.
    ///
    /// # Examples
    ///
    /// ```
    /// use spanfill::{Element, FinePoint, Path};
    ///
    /// let elements = Path::parse_svg::<3>("m1 1.5h.5z", 2, 1)?;
    /// assert_eq!(elements[0], Element::Move(FinePoint::whole(2, 3)));
    /// assert_eq!(elements[1], Element::Line(FinePoint::whole(3, 3)));
    ///
    /// let error = Path::count_svg("M1 1L2").unwrap_err();
    /// assert_eq!(error.to_string(), "SVG path data: a number is expected, at byte 6");
    /// # Ok::<(), spanfill::PathError>(())
    /// ```
    pub const fn parse_svg<const N: usize>(
        data: &str,
        numerator: u32,
        denominator: u32,
    ) -> Result<[Element; N], PathError> {
        let mut parser = SvgElements::new(data, numerator, denominator);
        let mut elements = [Element::Close; N];
        let mut count = 0;
        loop {
            match parser.next_element() {
                Ok(Some(element)) if count < N => {
                    #[allow(clippy::indexing_slicing, reason = "compared on the line above")]
                    let slot = &mut elements[count];
                    *slot = element;
                    count += 1;
                }
                Ok(None) if count == N => return Ok(elements),
                Ok(_) => return Err(parser.error(Kind::WrongLength)),
                Err(error) => return Err(error),
            }
        }
    }
}

/// A [`Path`] from SVG path data, made when the program is compiled. What is wrong does not compile.
///
/// A unit is a pixel, or a fraction of one that is given after the data: `path!(DATA, 2, 3)` makes an icon of 24 units
/// 16 pixels large. Numbers are rounded to 1/4096 pixel once, after that.
///
/// # Examples
///
/// ```
/// use spanfill::{Path, path};
///
/// const HOME: Path = path!("M10 20v-6h4v6h5v-8h3L12 3 2 12h3v8z");
/// static LARGE_HOME: Path = path!("M10 20v-6h4v6h5v-8h3L12 3 2 12h3v8z", 2, 1);
/// assert_eq!(HOME.elements().len(), 12);
/// ```
///
/// ```compile_fail
/// const WRONG: spanfill::Path = spanfill::path!("M10 20v-6h4v6h5v-8h3L12 3 2");
/// ```
#[macro_export]
macro_rules! path {
    ($data:expr) => {
        $crate::path!($data, 1, 1)
    };
    ($data:expr, $numerator:expr, $denominator:expr) => {{
        const COUNT: usize = match $crate::Path::count_svg($data) {
            Ok(count) => count,
            Err(error) => ::core::panic!("{}", error.message()),
        };
        const ELEMENTS: [$crate::Element; COUNT] = match $crate::Path::parse_svg($data, $numerator, $denominator) {
            Ok(elements) => elements,
            Err(error) => ::core::panic!("{}", error.message()),
        };
        const PATH: $crate::Path<'static> = $crate::Path::new(&ELEMENTS);
        PATH
    }};
}

/// A point in pixels, with 32 fraction bits.
#[derive(Debug, Clone, Copy)]
struct Point {
    x: i64,
    y: i64,
}

impl Point {
    const ORIGIN: Self = Self { x: 0, y: 0 };

    const fn plus(self, other: Self) -> Self {
        Self { x: self.x.saturating_add(other.x), y: self.y.saturating_add(other.y) }
    }

    /// This one mirrored at the other.
    const fn mirrored(self, at: Self) -> Self {
        Self {
            x: at.x.saturating_add(at.x.saturating_sub(self.x)),
            y: at.y.saturating_add(at.y.saturating_sub(self.y)),
        }
    }

    const fn rounded(self) -> FinePoint {
        const BITS: u32 = PARSED_BITS - 12;
        const fn nearest(value: i64) -> i32 {
            clamp_fine(value.saturating_add(1 << (BITS - 1)) >> BITS)
        }
        FinePoint::from_bits(nearest(self.x), nearest(self.y))
    }
}

/// What a smooth curve goes on from.
#[derive(Debug, Clone, Copy)]
enum Before {
    Quadratic(Point),
    Cubic(Point),
    Other,
}

/// The elements of SVG path data, one after the other, while the program runs.
///
/// Ends with the first error; viewers draw what comes before it.
///
/// # Examples
///
/// ```
/// use spanfill::{Path, SvgElements};
///
/// let elements: Vec<_> = SvgElements::new("M1 1h5v5z", 1, 1).collect::<Result<_, _>>()?;
/// let path = Path::new(&elements);
/// # assert_eq!(path.elements().len(), 4);
/// # Ok::<(), spanfill::PathError>(())
/// ```
#[derive(Debug, Clone)]
pub struct SvgElements<'a> {
    rest: &'a [u8],
    length: usize,
    scale: Scale,
    /// To be repeated when no command follows; 0 before the first, and after a close.
    command: u8,
    start: Point,
    at: Point,
    before: Before,
}

/// `?` is not there for constant functions.
macro_rules! attempt {
    ($result:expr) => {
        match $result {
            Ok(value) => value,
            Err(error) => return Err(error),
        }
    };
}

impl Iterator for SvgElements<'_> {
    type Item = Result<Element, PathError>;

    fn next(&mut self) -> Option<Self::Item> {
        let next = self.next_element().transpose();
        if let Some(Err(_)) = next {
            self.rest = &[];
        }
        next
    }
}

impl<'a> SvgElements<'a> {
    /// Reads path data whose unit is so many pixels as the fraction says.
    pub const fn new(data: &'a str, numerator: u32, denominator: u32) -> Self {
        let scale = Scale { numerator, denominator };
        let rest = data.as_bytes();
        let (start, at) = (Point::ORIGIN, Point::ORIGIN);
        Self { rest, length: rest.len(), scale, command: 0, start, at, before: Before::Other }
    }

    const fn error(&self, kind: Kind) -> PathError {
        PathError { position: self.length - self.rest.len(), kind }
    }

    const fn skip_space(&mut self) {
        while let [b' ' | b'\t' | b'\n' | b'\r' | 0x0c, rest @ ..] = self.rest {
            self.rest = rest;
        }
    }

    /// Between two numbers: spaces, and one comma.
    const fn skip_separator(&mut self) {
        self.skip_space();
        if let [b',', rest @ ..] = self.rest {
            self.rest = rest;
            self.skip_space();
        }
    }

    const fn next_element(&mut self) -> Result<Option<Element>, PathError> {
        let is_first = self.command == 0;
        let is_after_close = matches!(self.command, b'Z' | b'z');
        self.skip_space();
        let Some((&byte, rest)) = self.rest.split_first() else { return Ok(None) };
        let is_letter = byte.is_ascii_alphabetic();
        if is_letter {
            if is_first && !matches!(byte, b'M' | b'm') {
                return Err(self.error(Kind::NoMove));
            }
            if !matches!(byte.to_ascii_lowercase(), b'm' | b'l' | b'h' | b'v' | b'c' | b's' | b'q' | b't' | b'a' | b'z')
            {
                return Err(self.error(Kind::NoCommand));
            }
            self.command = byte;
            self.rest = rest;
            self.skip_space();
        } else if is_first {
            return Err(self.error(Kind::NoMove));
        } else if is_after_close {
            return Err(self.error(Kind::NoCommand));
        } else {
            self.skip_separator();
            // Further points of a move are lines.
            if let b'M' | b'm' = self.command {
                self.command -= 1;
            }
        }
        let element = attempt!(self.element());
        Ok(Some(element))
    }

    const fn element(&mut self) -> Result<Element, PathError> {
        let origin = if self.command.is_ascii_uppercase() { Point::ORIGIN } else { self.at };
        let mut before = Before::Other;
        let (element, to) = match self.command.to_ascii_lowercase() {
            b'm' => {
                let to = attempt!(self.point(origin));
                self.start = to;
                (Element::Move(to.rounded()), to)
            }
            b'l' => {
                let to = attempt!(self.point(origin));
                (Element::Line(to.rounded()), to)
            }
            b'h' => {
                let x = attempt!(self.number());
                let to = Point { x: origin.x.saturating_add(x), y: self.at.y };
                (Element::Line(to.rounded()), to)
            }
            b'v' => {
                let y = attempt!(self.number());
                let to = Point { x: self.at.x, y: origin.y.saturating_add(y) };
                (Element::Line(to.rounded()), to)
            }
            command @ (b'c' | b's') => {
                let control1 = if command == b'c' {
                    let control = attempt!(self.point(origin));
                    self.skip_separator();
                    control
                } else if let Before::Cubic(control) = self.before {
                    control.mirrored(self.at)
                } else {
                    self.at
                };
                let control2 = attempt!(self.point(origin));
                self.skip_separator();
                let to = attempt!(self.point(origin));
                before = Before::Cubic(control2);
                (Element::Cubic(control1.rounded(), control2.rounded(), to.rounded()), to)
            }
            command @ (b'q' | b't') => {
                let control = if command == b'q' {
                    let control = attempt!(self.point(origin));
                    self.skip_separator();
                    control
                } else if let Before::Quadratic(control) = self.before {
                    control.mirrored(self.at)
                } else {
                    self.at
                };
                let to = attempt!(self.point(origin));
                before = Before::Quadratic(control);
                (Element::Quadratic(control.rounded(), to.rounded()), to)
            }
            b'a' => attempt!(self.arc(origin)),
            _ => (Element::Close, self.start),
        };
        self.before = before;
        self.at = to;
        Ok(element)
    }

    const fn arc(&mut self, origin: Point) -> Result<(Element, Point), PathError> {
        let radii = attempt!(self.point(Point::ORIGIN));
        self.skip_separator();
        let degrees = attempt!(self.unscaled());
        self.skip_separator();
        let is_large = attempt!(self.flag());
        self.skip_separator();
        let is_clockwise = attempt!(self.flag());
        self.skip_separator();
        let to = attempt!(self.point(origin));
        // Whole turns are of no interest.
        let degrees = degrees % (360 << PARSED_BITS);
        #[allow(clippy::cast_possible_truncation, reason = "whole turns are of no interest")]
        let rotation = Angle::from_bits((degrees / 360).cast_unsigned() as u32);
        let [from, end, radii] = [[self.at.x, self.at.y], [to.x, to.y], [radii.x, radii.y]];
        Ok((Ends { from, to: end, radii, rotation, is_large, is_clockwise }.element(), to))
    }

    const fn point(&mut self, origin: Point) -> Result<Point, PathError> {
        let x = attempt!(self.number());
        self.skip_separator();
        let y = attempt!(self.number());
        Ok(origin.plus(Point { x, y }))
    }

    const fn number(&mut self) -> Result<i64, PathError> {
        self.number_times(self.scale)
    }

    const fn unscaled(&mut self) -> Result<i64, PathError> {
        self.number_times(Scale::ONE)
    }

    const fn number_times(&mut self, scale: Scale) -> Result<i64, PathError> {
        match number(self.rest, scale) {
            Some((value, rest)) => {
                self.rest = rest;
                Ok(value)
            }
            None => Err(self.error(Kind::NoNumber)),
        }
    }

    const fn flag(&mut self) -> Result<bool, PathError> {
        match self.rest {
            [byte @ (b'0' | b'1'), rest @ ..] => {
                self.rest = rest;
                Ok(*byte == b'1')
            }
            _ => Err(self.error(Kind::NoFlag)),
        }
    }
}
