//! Which coverage the pixels get: a grid of 255ths, fed by a sink that refuses what its contract does not allow.

use std::{
    convert::Infallible,
    fmt,
    ops::Range,
    sync::atomic::{AtomicU64, Ordering},
};

use spanfill::{Cover, CoverageEdge, CoverageSink, PixelRect, Span};

use super::{
    area::{Area, HasArea},
    rule::{Belongs, Outline},
};

/// The coverage of each pixel of a window; 0 where none was sent.
#[derive(Clone, PartialEq, Eq)]
pub(crate) struct CoverageGrid {
    window: PixelRect,
    coverage: Vec<u8>,
}

impl CoverageGrid {
    pub(crate) fn new(window: PixelRect) -> Self {
        let coverage = vec![0; window.columns.len() * window.rows.len()];
        Self { window, coverage }
    }

    pub(crate) fn window(&self) -> &PixelRect {
        &self.window
    }

    pub(crate) fn at(&self, column: i32, row: i32) -> u8 {
        self.row(row)[length(&(self.window.columns.start..column))]
    }

    pub(crate) fn row(&self, row: i32) -> &[u8] {
        &self.coverage[self.indices(row, &self.window.columns)]
    }

    /// Whether there are pixels that are covered and pixels that are not wholly.
    pub(crate) fn is_mixed(&self) -> bool {
        self.coverage.iter().any(|coverage| *coverage > 0) && self.coverage.iter().any(|coverage| *coverage < 255)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.coverage.iter().all(|coverage| *coverage == 0)
    }

    /// The pixels that are covered.
    pub(crate) fn covered(&self) -> impl Iterator<Item = (i32, i32)> {
        let pixels =
            self.window.rows.clone().flat_map(|row| self.window.columns.clone().map(move |column| (column, row)));
        pixels.zip(&self.coverage).filter(|(_, coverage)| **coverage > 0).map(|(pixel, _)| pixel)
    }

    /// Sets one pixel that has not been set.
    pub(crate) fn set(&mut self, column: i32, row: i32, coverage: u8) {
        let index = self.indices(row, &(column..column + 1)).start;
        assert_eq!(self.coverage[index], 0, "({column}, {row}) came twice");
        self.coverage[index] = coverage;
    }

    /// Adds a part of the window, drawn by itself.
    pub(crate) fn add(&mut self, part: &Self) {
        for (column, row) in part.covered() {
            self.set(column, row, part.at(column, row));
        }
    }

    fn indices(&self, row: i32, columns: &Range<i32>) -> Range<usize> {
        let PixelRect { rows, columns: all } = &self.window;
        let inside = rows.contains(&row) && all.start <= columns.start && columns.end <= all.end;
        assert!(inside, "row {row}, columns {columns:?} leave {:?}", self.window);
        let start = length(&(rows.start..row)) * length(all) + length(&(all.start..columns.start));
        start..start + length(columns)
    }
}

/// A clip may be all of `i32`.
fn length(range: &Range<i32>) -> usize {
    if range.is_empty() { 0 } else { (i64::from(range.end) - i64::from(range.start)) as usize }
}

/// Rows of two digits a pixel, hexadecimal; `..` for 0.
impl fmt::Display for CoverageGrid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for row in self.window.rows.clone() {
            for coverage in self.row(row) {
                if *coverage == 0 { write!(f, " ..")? } else { write!(f, " {coverage:02x}")? }
            }
            writeln!(f)?;
        }
        Ok(())
    }
}

impl fmt::Debug for CoverageGrid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}\n{self}", self.window)
    }
}

/// Takes coverage; refuses what is empty, not covered, outside the clip or sent twice.
struct CheckedCoverage {
    clip: PixelRect,
    grid: CoverageGrid,
}

impl CheckedCoverage {
    fn new(clip: &PixelRect, window: &PixelRect) -> Self {
        Self { clip: clip.clone(), grid: CoverageGrid::new(window.clone()) }
    }

    fn check(&self, row: i32, columns: &Range<i32>) {
        assert!(!columns.is_empty(), "row {row}, columns {columns:?}: empty");
        let PixelRect { rows, columns: all } = &self.clip;
        let inside = rows.contains(&row) && all.start <= columns.start && columns.end <= all.end;
        assert!(inside, "row {row}, columns {columns:?} leave the clip {:?}", self.clip);
    }
}

impl CoverageSink for CheckedCoverage {
    type Error = Infallible;

    fn span(&mut self, span: Span, coverage: u8) -> Result<(), Infallible> {
        self.check(span.row, &span.columns);
        assert_ne!(coverage, 0, "{span:?} of nothing");
        for column in span.columns {
            self.grid.set(column, span.row, coverage);
        }
        Ok(())
    }

    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), Infallible> {
        let end = i32::try_from(i64::from(column) + coverage.len() as i64).expect("the end of a run");
        self.check(row, &(column..end));
        for (column, coverage) in (column..end).zip(coverage) {
            assert_ne!(*coverage, 0, "nothing at ({column}, {row}) of a run");
            self.grid.set(column, row, *coverage);
        }
        Ok(())
    }
}

/// The coverage that a shape sends.
pub(crate) fn coverage(shape: &impl Cover, clip: &PixelRect) -> CoverageGrid {
    coverage_within(shape, clip, clip)
}

/// The same for a clip too large to count in: all pixels must lie in `window`.
pub(crate) fn coverage_within(shape: &impl Cover, clip: &PixelRect, window: &PixelRect) -> CoverageGrid {
    let mut sink = CheckedCoverage::new(clip, window);
    let Ok(()) = shape.coverage(clip, &mut sink);
    sink.grid
}

/// The polygon in scratch of exactly the size it asks for.
impl Cover for Outline {
    fn touched(&self) -> PixelRect {
        self.with_polygon(|polygon| {
            let mut edges = vec![CoverageEdge::EMPTY; polygon.coverage_edges()];
            polygon.coverage_in(&mut edges).expect("scratch of the size asked for").touched()
        })
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        self.with_polygon(|polygon| {
            let mut edges = vec![CoverageEdge::EMPTY; polygon.coverage_edges()];
            polygon.coverage_in(&mut edges).expect("scratch of the size asked for").coverage(clip, sink)
        })
    }
}

/// The greatest error seen, in 255ths of a pixel, in pixels of up to four edges and of more.
#[derive(Debug, Default)]
pub(crate) struct Worst {
    few: AtomicU64,
    many: AtomicU64,
}

impl Worst {
    pub(crate) const fn new() -> Self {
        Self { few: AtomicU64::new(0), many: AtomicU64::new(0) }
    }

    fn note(&self, edges: usize, error: f64) {
        let worst = if edges > FEW_EDGES { &self.many } else { &self.few };
        // Of two numbers that are not negative, the greater one has the greater bits.
        worst.fetch_max(error.to_bits(), Ordering::Relaxed);
    }

    pub(crate) fn few(&self) -> f64 {
        f64::from_bits(self.few.load(Ordering::Relaxed))
    }

    pub(crate) fn many(&self) -> f64 {
        f64::from_bits(self.many.load(Ordering::Relaxed))
    }
}

/// Up to so many edges in a pixel, its coverage is the exact area rounded once.
pub(crate) const FEW_EDGES: usize = 4;

/// How far a pixel's coverage may be from the exact area, in 255ths.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tolerance {
    pub(crate) few: f64,
    pub(crate) many: f64,
}

impl Tolerance {
    /// Rounded once.
    pub(crate) const EXACT: Self = Self { few: 0.51, many: 0.51 };

    fn of(self, area: &Area) -> f64 {
        let tolerance = if area.edges > FEW_EDGES { self.many } else { self.few };
        // A pixel without an edge is wholly covered or not at all.
        if area.edges == 0 { 0.0 } else { tolerance + 255.0 * area.error }
    }
}

/// Whether there are coordinates in the pixel. No shape covers any other.
pub(crate) fn has_coordinates(column: i32, row: i32) -> bool {
    [column, row].iter().all(|pixel| (i32::MIN >> 8..=i32::MAX >> 8).contains(pixel))
}

/// Holds a shape's coverage against its areas. `Ok` says whether the window shows an outline.
pub(crate) fn check_coverage<S: Cover + HasArea + Belongs>(
    shape: &S,
    clip: &PixelRect,
    tolerance: Tolerance,
    worst: &Worst,
) -> Result<bool, String> {
    let drawn = coverage(shape, clip);
    for row in clip.rows.clone() {
        let areas = shape.areas_in_row(row, &clip.columns);
        for ((column, area), coverage) in clip.columns.clone().zip(areas).zip(drawn.row(row)) {
            let area = if has_coordinates(column, row) { area } else { Area::whole(false) };
            let error = (f64::from(*coverage) - 255.0 * area.value).abs();
            worst.note(area.edges, error);
            if error > tolerance.of(&area) {
                return Err(format!(
                    "({column}, {row}) has {coverage}, not {:.3}, of {} edges: {}\nin {clip:?}:\n{drawn}",
                    255.0 * area.value,
                    area.edges,
                    shape.code()
                ));
            }
        }
    }
    Ok(drawn.is_mixed())
}

/// Holds two grids of one window against each other.
pub(crate) fn check_same_coverage(drawn: &CoverageGrid, expected: &CoverageGrid, what: impl FnOnce() -> String) {
    assert!(drawn == expected, "{}\n{drawn:?}\nand not\n{expected:?}", what());
}
