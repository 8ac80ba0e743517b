//! The coverage of the pixels of a window, from a sink that refuses what its contract does not allow.

use std::ops::Range;

use spanfill::{CoverageSink, PixelRect, Span};

/// 0 where nothing was sent.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Picture {
    window: PixelRect,
    width: usize,
    pixels: Vec<u8>,
}

impl Picture {
    pub(crate) fn new(window: &PixelRect) -> Self {
        let (width, height) = (window.columns.len(), window.rows.len());
        Self { window: window.clone(), width, pixels: vec![0; width * height] }
    }

    /// Row by row, from the first.
    pub(crate) fn rows(&self) -> impl Iterator<Item = &[u8]> {
        self.pixels.chunks_exact(self.width.max(1))
    }

    /// Whether it shows an outline.
    pub(crate) fn is_mixed(&self) -> bool {
        self.pixels.iter().any(|coverage| *coverage > 0) && self.pixels.iter().any(|coverage| *coverage < 255)
    }

    /// Takes what is sent within `clip`, a part of the window.
    pub(crate) fn part<'p>(&'p mut self, clip: &'p PixelRect) -> Part<'p> {
        Part { picture: self, clip }
    }

    /// Where the first pixel is that differs.
    pub(crate) fn difference(&self, other: &Self) -> Option<String> {
        let index = self.pixels.iter().zip(&other.pixels).position(|(a, b)| a != b)?;
        let column = self.window.columns.start + (index % self.width) as i32;
        let row = self.window.rows.start + (index / self.width) as i32;
        Some(format!("({column}, {row}) is {} and {}", self.pixels[index], other.pixels[index]))
    }
}

#[derive(Debug)]
pub(crate) struct Part<'p> {
    picture: &'p mut Picture,
    clip: &'p PixelRect,
}

impl Part<'_> {
    fn pixels(&mut self, row: i32, columns: Range<i32>) -> Result<&mut [u8], String> {
        let PixelRect { rows, columns: all } = self.clip;
        if columns.is_empty() || !rows.contains(&row) || columns.start < all.start || columns.end > all.end {
            return Err(format!("row {row}, columns {columns:?} are nothing, or leave the clip {:?}", self.clip));
        }
        let Picture { window, width, pixels } = &mut *self.picture;
        let start = (row - window.rows.start) as usize * *width + (columns.start - window.columns.start) as usize;
        let pixels = &mut pixels[start..start + columns.len()];
        if pixels.iter().any(|coverage| *coverage != 0) {
            return Err(format!("some pixels of row {row}, columns {columns:?} came twice"));
        }
        Ok(pixels)
    }
}

impl CoverageSink for Part<'_> {
    type Error = String;

    fn span(&mut self, span: Span, coverage: u8) -> Result<(), String> {
        if coverage == 0 {
            return Err(format!("{span:?} of nothing"));
        }
        self.pixels(span.row, span.columns)?.fill(coverage);
        Ok(())
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), String> {
        if coverage.contains(&0) {
            return Err(format!("a run of row {row} from column {column} has nothing in {coverage:?}"));
        }
        self.pixels(row, column..column.saturating_add(coverage.len() as i32))?.copy_from_slice(coverage);
        Ok(())
    }
}
