//! The lines of a chain within a row of pixels: worked out from vertices, or kept from when they were.
//!
//! Chains whose extents overlap are asked for their lines again and again, by each they are compared with and for each pixel
//! in which they cross. To ask vertices that are worked out is dear; to keep the lines costs memory. So what has room is
//! kept, on hosts most, on boards next to nothing, and the bits are the same.

use core::slice;

use crate::area::{
    line::{Line, finest},
    source::{Contour, FINE_ONE, Point, Source},
};

/// So many lines of a group are kept, 24 bytes of stack each.
const MOST: usize = if cfg!(target_pointer_width = "64") { 256 } else { 2 };

/// A row of pixels.
#[derive(Clone, Copy)]
pub(super) struct Row<'r> {
    pub(super) source: Source<'r>,
    /// Its top, in 2^-16 pixel.
    pub(super) top: i32,
    pub(super) kept: &'r [Line],
}

/// The lines of a group of chains that are kept.
pub(super) struct Kept {
    lines: [Line; MOST],
    used: usize,
}

impl Kept {
    pub(super) const fn new() -> Self {
        Self { lines: [Line { x0: 0, y0: 0, x1: 0, y1: 0 }; MOST], used: 0 }
    }

    pub(super) fn clear(&mut self) {
        self.used = 0;
    }

    #[inline]
    pub(super) fn lines(&self) -> &[Line] {
        &self.lines
    }

    /// Keeps lines, if there is room for all: the first, and how many.
    pub(super) fn keep(&mut self, lines: Course<'_>) -> Option<(u8, u8)> {
        let mut end = self.used;
        for line in lines {
            *self.lines.get_mut(end)? = line;
            end += 1;
        }
        let kept = (u8::try_from(self.used).ok()?, u8::try_from(end - self.used).ok()?);
        self.used = end;
        Some(kept)
    }
}

/// The lines of a chain, worked out.
pub(super) struct Course<'a> {
    vertices: Contour<'a>,
    is_forward: bool,
    row_top: i32,
    /// Where the next line starts.
    start: (i64, i32),
    /// The next vertex, if there is one within the row.
    vertex: Option<(u32, Point)>,
    /// The index that the row ends before, or at which the chain ends.
    last: u32,
    /// Where it leaves the row, if it does not end.
    end: Option<i64>,
}

impl<'a> Course<'a> {
    const NOTHING: Self = Self {
        vertices: Contour::Slice { vertices: &[], origin: (0, 0) },
        is_forward: true,
        row_top: 0,
        start: (0, 0),
        vertex: None,
        last: 0,
        end: None,
    };

    /// From where the chain is at the top of the row, over the vertices between two indices, to where it leaves the row.
    #[inline]
    pub(super) fn new(
        (vertices, is_forward): (Contour<'a>, bool),
        row_top: i32,
        start: (i64, i32),
        (first, last): (Option<u32>, u32),
        end: Option<i64>,
    ) -> Self {
        let vertex = first.map(|first| (first, vertices.vertex(first)));
        Self { vertices, is_forward, row_top, start, vertex, last, end }
    }
}

impl Iterator for Course<'_> {
    type Item = Line;

    #[inline(always)]
    fn next(&mut self) -> Option<Line> {
        loop {
            let (x0, y0) = self.start;
            let (x1, y1) = if let Some((index, point)) = self.vertex {
                self.vertex = None;
                if index != self.last {
                    let (next, point) = self.vertices.step(index, self.is_forward);
                    if next != self.last || self.end.is_none() {
                        self.vertex = Some((next, point));
                    }
                }
                (finest(point.x), point.y - self.row_top)
            } else {
                (self.end.take()?, FINE_ONE)
            };
            self.start = (x1, y1);
            if y0 < y1 {
                return Some(Line { x0, y0, x1, y1 });
            }
        }
    }
}

/// See the module.
pub(super) struct Lines<'a> {
    kept: slice::Iter<'a, Line>,
    course: Course<'a>,
}

impl<'a> Lines<'a> {
    #[inline]
    pub(super) fn kept(lines: &'a [Line]) -> Self {
        Self { kept: lines.iter(), course: Course::NOTHING }
    }

    #[inline]
    pub(super) fn worked_out(course: Course<'a>) -> Self {
        Self { kept: [].iter(), course }
    }
}

impl Iterator for Lines<'_> {
    type Item = Line;

    #[cfg_attr(target_pointer_width = "64", inline)]
    fn next(&mut self) -> Option<Line> {
        if let Some(line) = self.kept.next() {
            return Some(*line);
        }
        next_of(&mut self.course)
    }
}

/// One copy for all but the most frequent uses.
#[inline(never)]
fn next_of(course: &mut Course<'_>) -> Option<Line> {
    course.next()
}
