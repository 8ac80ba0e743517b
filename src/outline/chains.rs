//! How many chains, edges that follow each other downwards, an outline may have in one row of pixels.

use crate::outline::{FineRect, Vertices};

/// Rows in so many parts: a count for each.
const PARTS: usize = 64;
const LAST_PART: i32 = 63;
const _: () = assert!(LAST_PART as usize + 1 == PARTS);

/// How many chains there are in each part of some rows: no fewer than in any row of it.
#[derive(Debug)]
pub(crate) struct RowCounts {
    first: i32,
    /// The rows of a part, as a power of 2.
    log_rows: u32,
    counts: [u32; PARTS],
}

impl RowCounts {
    pub(crate) const fn new(extent: FineRect) -> Self {
        let (first, last) = (extent.low.y >> 12, extent.high.y >> 12);
        let rows = if first <= last { last - first } else { 0 };
        let mut log_rows = 0;
        while rows >> log_rows > LAST_PART {
            log_rows += 1;
        }
        Self { first, log_rows, counts: [0; PARTS] }
    }

    /// Adds chains between two heights, in 1/4096 pixel.
    pub(crate) const fn add(&mut self, top: i32, bottom: i32, chains: u32) {
        let mut at = ((top >> 12).saturating_sub(self.first)) >> self.log_rows;
        let end = (((bottom - 1) >> 12).saturating_sub(self.first)) >> self.log_rows;
        if at < 0 {
            at = 0;
        }
        while at <= end && at <= LAST_PART {
            #[allow(clippy::indexing_slicing, clippy::cast_sign_loss, reason = "compared above")]
            let count = &mut self.counts[at as usize];
            *count = count.saturating_add(chains);
            at += 1;
        }
    }

    pub(crate) const fn most(&self) -> usize {
        let mut most = 0;
        let mut part = 0;
        while part < PARTS {
            #[allow(clippy::indexing_slicing, reason = "compared above")]
            let count = self.counts[part] as usize;
            if count > most {
                most = count;
            }
            part += 1;
        }
        most
    }
}

/// The most chains in a row, or a few more where there are more than 64 rows. Walks the outline.
pub(crate) fn most_chains(vertices: &dyn Vertices, extent: FineRect) -> usize {
    let mut counts = RowCounts::new(extent);
    for contour in 0..vertices.contours() {
        let Some(first) = vertices.first(contour) else { continue };
        let start = vertices.vertex(contour, first).y;
        // The chain that the walk begins within may go on at its end.
        let (mut index, mut from, mut top, mut bottom) = (first, start, start, start);
        let mut goes_down = None;
        loop {
            index = vertices.next(contour, index, true);
            let to = vertices.vertex(contour, index).y;
            if to != from {
                if goes_down.is_some_and(|down| down != (to > from)) {
                    counts.add(top, bottom, 1);
                    (top, bottom) = (from, from);
                }
                goes_down = Some(to > from);
                (top, bottom, from) = (top.min(to), bottom.max(to), to);
            }
            if index == first {
                break;
            }
        }
        if goes_down.is_some() {
            counts.add(top, bottom, 1);
        }
    }
    counts.most()
}
