//! Which pixels are closed, a bit each.

use crate::{
    fragment::{Fragment, FragmentSink},
    geometry::PixelRect,
    methods::polygon::Failure,
};

/// By what pixels are neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Touch {
    /// By their sides: four of them.
    Sides,
    /// By their corners, too: eight of them.
    Corners,
}

/// Bits for the pixels of a clip, in words of the caller's. Outside, everything is closed.
#[derive(Debug)]
pub struct Canvas<'w> {
    pub(super) clip: PixelRect,
    words_per_row: usize,
    closed: &'w mut [u32],
}

impl<'w> Canvas<'w> {
    /// How many words a clip needs.
    pub fn words(clip: &PixelRect) -> usize {
        if clip.rows.is_empty() || clip.columns.is_empty() {
            return 0;
        }
        words_per_row(clip).saturating_mul(length(clip.rows.start, clip.rows.end))
    }

    /// All open.
    ///
    /// # Errors
    ///
    /// When there are too few words.
    pub fn new<E>(clip: &PixelRect, words: &'w mut [u32]) -> Result<Self, Failure<E>> {
        let (needed, available) = (Self::words(clip), words.len());
        let closed = words.get_mut(..needed).ok_or(Failure::TooLittleScratch { needed, available })?;
        closed.fill(0);
        Ok(Self { clip: clip.clone(), words_per_row: words_per_row(clip), closed })
    }

    fn bit(&self, x: i32, y: i32) -> Option<(usize, u32)> {
        if !self.clip.columns.contains(&x) || !self.clip.rows.contains(&y) {
            return None;
        }
        let (column, row) = (length(self.clip.columns.start, x), length(self.clip.rows.start, y));
        Some((row * self.words_per_row + column / 32, 1 << (column % 32)))
    }

    pub(super) fn is_open(&self, x: i32, y: i32) -> bool {
        self.bit(x, y).is_some_and(|(word, bit)| self.closed.get(word).is_some_and(|word| word & bit == 0))
    }

    /// Whether it was open.
    pub(super) fn close(&mut self, x: i32, y: i32) -> bool {
        let Some((word, bit)) = self.bit(x, y) else { return false };
        let Some(word) = self.closed.get_mut(word) else { return false };
        let was_open = *word & bit == 0;
        *word |= bit;
        was_open
    }

    /// Looks at a pixel.
    pub(super) fn look<S: FragmentSink>(&self, x: i32, y: i32, sink: &mut S) -> bool {
        sink.visit(x, y);
        self.is_open(x, y)
    }

    /// Closes an open pixel and sends it.
    pub(super) fn fill<S: FragmentSink>(&mut self, x: i32, y: i32, sink: &mut S) -> Result<(), S::Error> {
        if self.close(x, y) { sink.fragment(Fragment::pixel(x, y)) } else { Ok(()) }
    }

    /// Sends what is closed: the outline, before anything is filled.
    ///
    /// # Errors
    ///
    /// The sink's.
    pub fn send<S: FragmentSink>(&self, sink: &mut S) -> Result<(), S::Error> {
        let rows = self.closed.chunks(self.words_per_row.max(1));
        for (y, words) in self.clip.rows.clone().zip(rows) {
            for (left, word) in (self.clip.columns.start..).step_by(32).zip(words) {
                let mut rest = *word;
                while rest != 0 {
                    let x = left.wrapping_add_unsigned(rest.trailing_zeros());
                    rest &= rest - 1;
                    sink.fragment(Fragment::pixel(x, y))?;
                }
            }
        }
        Ok(())
    }

    /// How many pixels are open.
    pub(super) fn open_pixels(&self) -> usize {
        let closed: usize = self.closed.iter().map(|word| word.count_ones() as usize).sum();
        length(self.clip.columns.start, self.clip.columns.end) * length(self.clip.rows.start, self.clip.rows.end)
            - closed
    }

    /// How many runs the open pixels of all rows make.
    pub(super) fn open_runs(&self) -> usize {
        let starts = |y: i32| {
            let is_start = |x: &i32| self.is_open(*x, y) && !self.is_open(x.wrapping_sub(1), y);
            self.clip.columns.clone().filter(is_start).count()
        };
        self.clip.rows.clone().map(starts).sum()
    }
}

fn words_per_row(clip: &PixelRect) -> usize {
    length(clip.columns.start, clip.columns.end).div_ceil(32)
}

/// From one number to another that is not less.
fn length(start: i32, end: i32) -> usize {
    if start < end { end.abs_diff(start) as usize } else { 0 }
}
