//! How a stroke looks.

use crate::outline::{StrokeReach, clamp_fine};

/// What is at the ends of an open stroke, and of dashes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Cap {
    /// Nothing: it is cut off square at the end.
    #[default]
    Butt,
    /// Half a disc.
    Round,
    /// Half a square.
    Square,
}

/// What is at the corners of a stroke.
///
/// ```text
///      Miter           Round           Bevel
///    ------.         -----.          -----.
///          |              |               \
///    ---.  |         ---. |          ---.  |
///       |  |            | |             |  |
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Join {
    /// The sides go on until they meet, unless that is further from the corner than `limit` times half the width, in
    /// 1/256: then a bevel. SVG has a limit of 4, which is 1024 here.
    Miter {
        /// In 1/256. At less than 256, which is 1, all corners are bevels.
        limit: u32,
    },
    /// A sector of a disc.
    Round,
    /// A triangle.
    Bevel,
}

impl Default for Join {
    #[inline]
    fn default() -> Self {
        Self::Miter { limit: 4 * 256 }
    }
}

/// On which side of a closed contour a stroke lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Align {
    /// Half of it on either side.
    #[default]
    Center,
    /// Within what the contours go around.
    Inside,
    /// Around that.
    Outside,
}

impl Align {
    pub(super) const fn opposite(self) -> Self {
        match self {
            Self::Center => Self::Center,
            Self::Inside => Self::Outside,
            Self::Outside => Self::Inside,
        }
    }
}

/// Width, caps, joins and dashes of a stroke.
///
/// # Examples
///
/// ```
/// use spanfill::{Cap, Join, StrokeStyle};
///
/// const DOTS: StrokeStyle = StrokeStyle::new(640).cap(Cap::Round).join(Join::Round).dashes(&[0, 5 * 256]);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct StrokeStyle<'d> {
    pub(super) width: u32,
    pub(super) cap: Cap,
    pub(super) join: Join,
    pub(super) dashes: &'d [u32],
    pub(super) phase: i32,
    pub(super) align: Align,
}

impl<'d> StrokeStyle<'d> {
    /// A stroke of a width in 1/256 pixel: half of it on either side. One of no width draws nothing; 131072 pixels are
    /// the most.
    #[inline]
    pub const fn new(width: u32) -> Self {
        Self {
            width,
            cap: Cap::Butt,
            join: Join::Miter { limit: 4 * 256 },
            dashes: &[],
            phase: 0,
            align: Align::Center,
        }
    }

    /// A stroke of a width in pixels.
    #[inline]
    pub const fn pixels(width: u32) -> Self {
        Self::new(width.saturating_mul(256))
    }

    /// The same with other caps.
    #[inline]
    #[must_use]
    pub const fn cap(self, cap: Cap) -> Self {
        Self { cap, ..self }
    }

    /// The same with other joins.
    #[inline]
    #[must_use]
    pub const fn join(self, join: Join) -> Self {
        Self { join, ..self }
    }

    /// The same in dashes and gaps of these lengths in turn, in 1/256 pixel; an odd number of them is gone through
    /// twice. Without any, or where all are 0, it has no gaps. Dashes of no length are dots.
    #[inline]
    #[must_use]
    pub const fn dashes(self, dashes: &'d [u32]) -> Self {
        Self { dashes, ..self }
    }

    /// The same with the dashes moved back along the path, in 1/256 pixel.
    #[inline]
    #[must_use]
    pub const fn phase(self, phase: i32) -> Self {
        Self { phase, ..self }
    }

    /// The same on one side of the contours, which do not cross themselves or each other, go around what they enclose the
    /// same way, and around holes in it the other way. Open subpaths have no sides, and are not drawn; dashes always lie in
    /// the middle.
    #[inline]
    #[must_use]
    pub const fn align(self, align: Align) -> Self {
        Self { align, ..self }
    }

    pub(super) const fn has_gaps(&self) -> bool {
        let mut dashes = self.dashes;
        while let [first, rest @ ..] = dashes {
            if *first > 0 {
                return true;
            }
            dashes = rest;
        }
        false
    }

    /// For the chains of a stroke: how far it reaches, and how many times as many its alignment makes of them.
    pub(crate) const fn chains(&self) -> (StrokeReach, usize) {
        let (mut sum, mut dashes) = (0, self.dashes);
        while let [first, rest @ ..] = dashes {
            sum += 16 * *first as u64;
            dashes = rest;
        }
        #[allow(clippy::cast_possible_truncation, reason = "more are no pattern")]
        let count = self.dashes.len() as u32;
        let dashes = if self.has_gaps() { Some((count, sum)) } else { None };
        let (radius, more) = match self.align {
            Align::Inside | Align::Outside if !self.has_gaps() => (2 * self.radius(), 2),
            _ => (self.radius(), 1),
        };
        (StrokeReach { radius, most: self.reach(), dashes }, more)
    }

    /// How far from its line anything of it may be, in 1/4096 pixel.
    pub(super) const fn reach(&self) -> i32 {
        let width = match self.align {
            Align::Center => 1,
            Align::Inside | Align::Outside => 2,
        };
        let radius = self.radius() * width;
        let miter = match self.join {
            Join::Miter { limit } if limit > 256 => limit as i64,
            _ => 256,
        };
        // Half the diagonal of a square is less than 363 256ths.
        let most = if matches!(self.cap, Cap::Square) && miter < 363 { 363 } else { miter };
        clamp_fine(((radius * most) >> 8) + 8)
    }

    /// Half of the width, in 1/4096 pixel.
    #[inline]
    pub(super) const fn radius(&self) -> i64 {
        const MOST: u32 = 1 << 25;
        8 * if self.width < MOST { self.width as i64 } else { MOST as i64 }
    }
}
