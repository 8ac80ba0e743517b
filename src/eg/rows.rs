//! Primitives drawn row by row in two colours: the pixels of each are named, and equal rows are sent as one.

use core::{mem::swap, ops::Range};

use embedded_graphics_core::{draw_target::DrawTarget, pixelcolor::PixelColor};
use heapless::Vec;

use crate::PixelRect;

use super::{
    paint::Paint,
    pixel_box::{PixelBox, cut},
};

/// The most parts that a row can have: five lines and two circles cut that of a sector into ten.
const PARTS: usize = 12;

/// The parts of one row from left to right, and what of it is visible.
#[derive(Debug)]
pub(super) struct Row<C> {
    parts: Vec<(Range<i32>, C), PARTS>,
    clip: Range<i32>,
}

impl<C: PixelColor> Row<C> {
    /// The next pixels to the right; none where the range runs backwards.
    pub(super) fn add(&mut self, columns: Range<i64>, colour: Option<C>) {
        let (Some(colour), columns) = (colour, cut(&columns, &self.clip)) else { return };
        match self.parts.last_mut() {
            _ if columns.is_empty() => {}
            Some((last, other)) if last.end == columns.start && *other == colour => last.end = columns.end,
            // There is room for as many parts as a row can have.
            _ => self.parts.push((columns, colour)).unwrap_or_default(),
        }
    }

    /// The stroke around the fill, both from their outlines; either may be empty.
    pub(super) fn add_ring(&mut self, paint: &Paint<C>, outer: Range<i64>, inner: Range<i64>) {
        let inner = if inner.is_empty() { outer.end..outer.end } else { inner };
        self.add(outer.start..inner.start, paint.stroke);
        self.add(inner.clone(), paint.fill);
        self.add(inner.end..outer.end, paint.stroke);
    }

    /// The pixels of `columns`, each of which has its colour; that changes only at the ends of `ranges`.
    pub(super) fn add_cut(&mut self, columns: Range<i64>, ranges: &[&Range<i64>], colour: impl Fn(i64) -> Option<C>) {
        let (mut column, end) = (columns.start.max(self.clip.start.into()), columns.end.min(self.clip.end.into()));
        while column < end {
            let ends = ranges.iter().flat_map(|range| [range.start, range.end]);
            let next = ends.filter(|&end| end > column).fold(end, i64::min);
            self.add(column..next, colour(column));
            column = next;
        }
    }
}

/// Draws the visible rows of `area`, whose parts `parts` adds.
pub(super) fn draw_rows<D: DrawTarget>(
    area: &PixelBox,
    target: &mut D,
    mut parts: impl FnMut(i64, &mut Row<D::Color>),
) -> Result<(), D::Error> {
    let PixelRect { rows, columns } = area.visible(&target.bounding_box().into());
    let row = || Row { parts: Vec::new(), clip: columns.clone() };
    let (mut a, mut b) = (row(), row());
    let (mut top, mut open, mut next) = (rows.start, &mut a, &mut b);
    let mut send = |open: &Row<D::Color>, rows: Range<i32>| {
        open.parts.iter().try_for_each(|(columns, colour)| {
            target.fill_solid(&PixelRect { rows: rows.clone(), columns: columns.clone() }.into(), *colour)
        })
    };
    for row in rows.clone() {
        next.parts.clear();
        parts(row.into(), next);
        if next.parts != open.parts {
            send(open, top..row)?;
            swap(&mut open, &mut next);
            top = row;
        }
    }
    send(open, top..rows.end)
}
