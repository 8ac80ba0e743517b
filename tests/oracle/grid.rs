//! Where the pixels go: a grid of counts, fed by sinks that refuse what their contract does not allow.

use std::{convert::Infallible, fmt, ops::Range};

use spanfill::{BlockSink, PixelRect, Shape, Span, SpanSink};

use super::rule::Belongs;

/// The pixels of `columns` and `rows`.
pub(crate) fn rect(columns: Range<i32>, rows: Range<i32>) -> PixelRect {
    PixelRect { rows, columns }
}

/// How many pixels a range of them holds; the whole of `i32` is a legal range.
fn length(range: &Range<i32>) -> usize {
    if range.is_empty() { 0 } else { usize::try_from(i64::from(range.end) - i64::from(range.start)).unwrap() }
}

/// How often each pixel of a window was sent.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct Grid {
    window: PixelRect,
    counts: Vec<u8>,
}

impl Grid {
    pub(crate) fn new(window: PixelRect) -> Self {
        let counts = vec![0; length(&window.columns) * length(&window.rows)];
        Self { window, counts }
    }

    /// The pixels that the rule gives a shape.
    pub(crate) fn of_rule(shape: &impl Belongs, window: &PixelRect) -> Self {
        let mut grid = Self::new(window.clone());
        let mut counts = grid.counts.iter_mut();
        for row in window.rows.clone() {
            let has = shape.has_in_row(row);
            for column in window.columns.clone() {
                *counts.next().unwrap() = has(column).into();
            }
        }
        grid
    }

    pub(crate) fn window(&self) -> &PixelRect {
        &self.window
    }

    pub(crate) fn count(&self, column: i32, row: i32) -> u8 {
        if self.window.columns.contains(&column) && self.window.rows.contains(&row) {
            self.counts[self.index(column, row)]
        } else {
            0
        }
    }

    /// Counts one row's run; panics where it leaves the window.
    pub(crate) fn add(&mut self, row: i32, columns: &Range<i32>) {
        assert!(self.window.rows.contains(&row), "row {row} is outside {:?}", self.window);
        assert!(
            self.window.columns.start <= columns.start && columns.end <= self.window.columns.end,
            "columns {columns:?} are outside {:?}",
            self.window
        );
        let start = self.index(columns.start, row);
        for count in &mut self.counts[start..start + length(columns)] {
            *count += 1;
        }
    }

    /// Counts what another grid holds; both have the same window.
    pub(crate) fn add_all(&mut self, other: &Self) {
        assert_eq!(self.window, other.window);
        for (count, more) in self.counts.iter_mut().zip(&other.counts) {
            *count += more;
        }
    }

    pub(crate) fn covered(&self) -> usize {
        self.counts.iter().filter(|count| **count > 0).count()
    }

    pub(crate) fn most(&self) -> u8 {
        self.counts.iter().copied().max().unwrap_or(0)
    }

    /// Whether the window has pixels that are covered and pixels that are not: whether it shows an outline.
    pub(crate) fn is_mixed(&self) -> bool {
        let covered = self.covered();
        0 < covered && covered < self.counts.len()
    }

    fn index(&self, column: i32, row: i32) -> usize {
        length(&(self.window.rows.start..row)) * length(&self.window.columns)
            + length(&(self.window.columns.start..column))
    }

    /// The window with `#` where both have a pixel, `+` where only `self` has it, `-` where only `expected` has.
    fn difference(&self, expected: &Self) -> String {
        let mut text = String::new();
        for row in self.window.rows.clone() {
            for column in self.window.columns.clone() {
                text.push(match (self.count(column, row), expected.count(column, row)) {
                    (0, 0) => '.',
                    (0, _) => '-',
                    (_, 0) => '+',
                    (a, b) if a == b => '#',
                    _ => '!',
                });
            }
            text.push('\n');
        }
        text
    }
}

/// A picture: `.` for a pixel that was not sent, `#` for one that was sent once, else its count.
impl fmt::Display for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for row in self.window.rows.clone() {
            for column in self.window.columns.clone() {
                match self.count(column, row) {
                    0 => write!(f, ".")?,
                    1 => write!(f, "#")?,
                    count => write!(f, "{count}")?,
                }
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

impl fmt::Debug for Grid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}\n{self}", self.window)
    }
}

/// Takes spans; refuses one that is empty, leaves the clip, goes up, or goes left or back within its row.
struct CheckedSpans {
    clip: PixelRect,
    last: Option<Span>,
    grid: Grid,
}

impl SpanSink for CheckedSpans {
    type Error = Infallible;

    fn span(&mut self, span: Span) -> Result<(), Infallible> {
        check_in_clip(&self.clip, &(span.row..span.row + 1), &span.columns);
        if let Some(last) = &self.last {
            let goes_on = span.row > last.row || span.row == last.row && span.columns.start >= last.columns.end;
            assert!(goes_on, "{span:?} after {last:?}");
        }
        self.grid.add(span.row, &span.columns);
        self.last = Some(span);
        Ok(())
    }
}

/// Takes blocks; refuses one that is empty, leaves the clip, or starts above or left of where it may.
struct CheckedBlocks {
    clip: PixelRect,
    last: Option<(Range<i32>, Range<i32>)>,
    grid: Grid,
    /// The number of the block that sent each pixel.
    senders: Vec<usize>,
    blocks: usize,
}

impl BlockSink for CheckedBlocks {
    type Error = Infallible;

    fn block(&mut self, rows: Range<i32>, columns: Range<i32>) -> Result<(), Infallible> {
        check_in_clip(&self.clip, &rows, &columns);
        if let Some((last_rows, last_columns)) = &self.last {
            let goes_on =
                rows.start > last_rows.start || rows.start == last_rows.start && columns.start >= last_columns.end;
            assert!(goes_on, "block {rows:?} x {columns:?} after {last_rows:?} x {last_columns:?}");
        }
        self.blocks += 1;
        for row in rows.clone() {
            self.grid.add(row, &columns);
            let start = self.grid.index(columns.start, row);
            self.senders[start..start + length(&columns)].fill(self.blocks);
        }
        self.last = Some((rows, columns));
        Ok(())
    }
}

fn check_in_clip(clip: &PixelRect, rows: &Range<i32>, columns: &Range<i32>) {
    assert!(!rows.is_empty() && !columns.is_empty(), "rows {rows:?}, columns {columns:?}: empty");
    let inside = clip.rows.start <= rows.start
        && rows.end <= clip.rows.end
        && clip.columns.start <= columns.start
        && columns.end <= clip.columns.end;
    assert!(inside, "rows {rows:?}, columns {columns:?} leave the clip {clip:?}");
}

/// The pixels that `Shape::spans` sends, each of them once.
pub(crate) fn span_pixels(shape: &impl Shape, clip: &PixelRect) -> Grid {
    span_pixels_within(shape, clip, clip)
}

/// The same for a clip too large to count in: all pixels must lie in `window`.
pub(crate) fn span_pixels_within(shape: &impl Shape, clip: &PixelRect, window: &PixelRect) -> Grid {
    let mut sink = CheckedSpans { clip: clip.clone(), last: None, grid: Grid::new(window.clone()) };
    let Ok(()) = shape.spans(clip, &mut sink);
    assert!(sink.grid.most() <= 1, "a pixel was sent twice:\n{}", sink.grid);
    sink.grid
}

/// The pixels that `Shape::blocks` sends, each of them once and equal rows of one run together.
pub(crate) fn block_pixels(shape: &impl Shape, clip: &PixelRect) -> Grid {
    block_pixels_within(shape, clip, clip)
}

/// The same for a clip too large to count in: all pixels must lie in `window`.
pub(crate) fn block_pixels_within(shape: &impl Shape, clip: &PixelRect, window: &PixelRect) -> Grid {
    let grid = Grid::new(window.clone());
    let senders = vec![0; grid.counts.len()];
    let mut sink = CheckedBlocks { clip: clip.clone(), last: None, grid, senders, blocks: 0 };
    let Ok(()) = shape.blocks(clip, &mut sink);
    assert!(sink.grid.most() <= 1, "a pixel was sent twice:\n{}", sink.grid);
    sink.assert_equal_rows_are_merged();
    sink.grid
}

/// The most runs in a row whose merging the crate promises.
const MERGED_RUNS: usize = 8;

impl CheckedBlocks {
    /// Two consecutive rows of the same runs must have come in the same blocks.
    fn assert_equal_rows_are_merged(&self) {
        let width = length(&self.grid.window.columns);
        if width == 0 {
            return;
        }
        let rows: Vec<&[usize]> = self.senders.chunks_exact(width).collect();
        for pair in rows.windows(2) {
            let (upper, lower) = (runs(pair[0]), runs(pair[1]));
            if upper.len() <= MERGED_RUNS && upper == lower {
                assert_eq!(pair[0], pair[1], "equal rows came in different blocks:\n{}", self.grid);
            }
        }
    }
}

/// Where a row's blocks start and end.
fn runs(senders: &[usize]) -> Vec<Range<usize>> {
    let runs = senders.chunk_by(|left, right| left == right).scan(0, |end, run| {
        *end += run.len();
        Some((run[0], *end - run.len()..*end))
    });
    runs.filter(|(sender, _)| *sender != 0).map(|(_, columns)| columns).collect()
}

/// Holds a shape's spans against its rule. `Ok` says whether the window shows an outline.
pub(crate) fn check_exact<S: Shape + Belongs>(shape: &S, clip: &PixelRect) -> Result<bool, String> {
    let (drawn, expected) = (span_pixels(shape, clip), Grid::of_rule(shape, clip));
    if drawn == expected {
        return Ok(expected.is_mixed());
    }
    let difference = drawn.difference(&expected);
    Err(format!("{}\nin {clip:?} (# right, + drawn but outside, - missing):\n{difference}", shape.code()))
}

/// Holds two grids of one window against each other.
pub(crate) fn check_same(drawn: &Grid, expected: &Grid, what: impl FnOnce() -> String) {
    assert!(
        drawn == expected,
        "{}\nin {:?} (# both, + only the first, - only the second):\n{}",
        what(),
        drawn.window,
        drawn.difference(expected)
    );
}
