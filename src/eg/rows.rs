//! Primitives drawn row by row in two colours: the pixels of each are named, and equal rows are sent as one.

use core::{mem::swap, ops::Range};

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    primitives::Rectangle,
};
use heapless::Vec;

use crate::PixelRect;

use super::{
    paint::Paint,
    pixel_box::{PixelBox, cut},
};

/// What a pixel is part of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    Stroke,
    Fill,
}

/// The most parts that a row can have: five lines and two circles cut that of a sector into ten.
const PARTS: usize = 12;

/// The parts of one row from left to right.
#[derive(Debug)]
pub(super) struct Row {
    parts: Vec<(Range<i32>, Part), PARTS>,
    clip: Range<i32>,
}

impl Row {
    fn new(clip: &Range<i32>) -> Self {
        Self { parts: Vec::new(), clip: clip.clone() }
    }

    /// The next pixels to the right; none where the range runs backwards.
    pub(super) fn add(&mut self, columns: Range<i64>, part: Part) {
        let columns = cut(&columns, &self.clip);
        if columns.is_empty() {
            return;
        }
        match self.parts.last_mut() {
            Some((last, last_part)) if last.end == columns.start && *last_part == part => last.end = columns.end,
            // There is room for as many parts as a row can have.
            _ => self.parts.push((columns, part)).unwrap_or_default(),
        }
    }

    /// The stroke around the fill, both from their outlines; either may be empty.
    pub(super) fn add_ring(&mut self, outer: Range<i64>, inner: Range<i64>) {
        if inner.is_empty() {
            self.add(outer, Part::Stroke);
        } else {
            self.add(outer.start..inner.start, Part::Stroke);
            self.add(inner.clone(), Part::Fill);
            self.add(inner.end..outer.end, Part::Stroke);
        }
    }

    /// The pixels of `columns`, each of which `part` tells what it is part of; that changes only at the ends of
    /// `ranges`.
    pub(super) fn add_classified(
        &mut self,
        columns: &Range<i64>,
        ranges: &[&Range<i64>],
        part: impl Fn(i64) -> Option<Part>,
    ) {
        let visible = cut(columns, &self.clip);
        let end = i64::from(visible.end);
        let mut column = i64::from(visible.start);
        while column < end {
            let ends = ranges.iter().flat_map(|range| [range.start, range.end]);
            let next = ends.filter(|&end| end > column).fold(end, i64::min);
            if let Some(part) = part(column) {
                self.add(column..next, part);
            }
            column = next;
        }
    }

    fn send<D: DrawTarget>(&self, rows: Range<i32>, paint: &Paint<D::Color>, target: &mut D) -> Result<(), D::Error> {
        for (columns, part) in &self.parts {
            let colour = match part {
                Part::Stroke => paint.stroke,
                Part::Fill => paint.fill,
            };
            if let Some(colour) = colour {
                let size = Size::new(columns.end.abs_diff(columns.start), rows.end.abs_diff(rows.start));
                target.fill_solid(&Rectangle::new(Point::new(columns.start, rows.start), size), colour)?;
            }
        }
        Ok(())
    }
}

/// Draws the visible rows of `area`, whose parts `parts` names.
pub(super) fn draw_rows<D: DrawTarget>(
    area: &PixelBox,
    paint: &Paint<D::Color>,
    target: &mut D,
    mut parts: impl FnMut(i64, &mut Row),
) -> Result<(), D::Error> {
    let clip = PixelRect::from(target.bounding_box());
    let PixelRect { rows, columns } = area.visible(&clip);
    if columns.is_empty() {
        return Ok(());
    }
    let end = rows.end;
    let (mut a, mut b) = (Row::new(&columns), Row::new(&columns));
    let (mut top, mut open, mut next) = (rows.start, &mut a, &mut b);
    for row in rows {
        next.parts.clear();
        parts(row.into(), next);
        if next.parts != open.parts {
            open.send(top..row, paint, target)?;
            swap(&mut open, &mut next);
            top = row;
        }
    }
    open.send(top..end, paint, target)
}
