//! The whole scene drawn n times larger, in one bit a sample, and averaged at the end.
//!
//! Of shapes that share an edge, each sample is one's or the other's: drawn one after the other into the larger picture,
//! they leave no seam, which blended coverage does. That is paid for in memory: n^2 bits for each pixel of the clip.

use crate::{
    Fragment, FragmentSink, PixelRect,
    methods::antialias::{Error, Outline, Side, outline::width},
};

/// A picture n times larger than the clip, without any shape in it.
#[derive(Debug)]
pub struct Scene<'s> {
    side: Side,
    clip: PixelRect,
    /// Bytes to a line of samples.
    stride: usize,
    bits: &'s mut [u8],
    /// For each sample of a line, the change of the winding number.
    changes: &'s mut [i32],
}

impl<'s> Scene<'s> {
    /// How much scratch a clip needs: bytes, and changes.
    pub fn needed(side: Side, clip: &PixelRect) -> [usize; 2] {
        let n = usize::from(side.get());
        let samples = width(clip).saturating_mul(n);
        let lines = (clip.rows.end.abs_diff(clip.rows.start) as usize).saturating_mul(n);
        [samples.div_ceil(8).saturating_mul(lines), samples]
    }

    /// An empty picture.
    ///
    /// # Errors
    ///
    /// With less scratch than [`needed`](Self::needed), of bytes or of changes.
    pub fn new(
        side: Side,
        clip: &PixelRect,
        bits: &'s mut [u8],
        changes: &'s mut [i32],
    ) -> Result<Self, Error<core::convert::Infallible>> {
        let [bytes, samples] = Self::needed(side, clip);
        Error::check(bytes, bits.len())?;
        Error::check(samples, changes.len())?;
        bits.fill(0);
        changes.fill(0);
        let changes = changes.get_mut(..samples).unwrap_or_default();
        Ok(Self { side, clip: clip.clone(), stride: samples.div_ceil(8), bits, changes })
    }

    /// Draws an outline, n times larger.
    pub fn draw(&mut self, outline: &Outline<'_>) {
        let Self { side, clip, stride, bits, changes } = self;
        let n = i64::from(side.get());
        let step = 256 / n;
        let first = 256 * i64::from(clip.columns.start) + step / 2;
        let pixels = outline.pixels(clip);
        if width(&pixels) == 0 {
            return;
        }
        for row in pixels.rows {
            for i in 0..n {
                let y = 256 * i64::from(row) + i * step + step / 2;
                let mut any = false;
                for edge in outline.edges() {
                    let Some(sample) = edge.crossing(y, first, step) else { continue };
                    if let Some(change) = changes.get_mut(usize::try_from(sample.max(0)).unwrap_or(usize::MAX)) {
                        *change = change.wrapping_add(edge.winding);
                        any = true;
                    }
                }
                if !any {
                    continue;
                }
                let line = (i64::from(row) - i64::from(clip.rows.start)) * n + i;
                let start = line as usize * *stride;
                let line = bits.get_mut(start..start + *stride).unwrap_or_default();
                let mut winding = 0_i32;
                for (byte, changes) in line.iter_mut().zip(changes.chunks_mut(8)) {
                    for (change, bit) in changes.iter_mut().zip(0..) {
                        winding = winding.wrapping_add(core::mem::take(change));
                        *byte |= u8::from(outline.is_inside(winding)) << bit;
                    }
                }
            }
        }
    }

    /// The average of each pixel's samples, in 255ths, of those that are not 0.
    ///
    /// # Errors
    ///
    /// The sink's.
    pub fn average<S: FragmentSink>(&self, sink: &mut S) -> Result<(), S::Error> {
        let n = usize::from(self.side.get());
        let whole = (n * n) as u32;
        if width(&self.clip) == 0 {
            return Ok(());
        }
        for (row, y) in self.clip.rows.clone().zip(0..) {
            for (column, x) in self.clip.columns.clone().zip(0..) {
                sink.visit(column, row);
                let count: u32 = (0..n).map(|i| self.ones(y * n + i, x * n)).sum();
                if count > 0 {
                    let coverage = (255 * count + whole / 2) / whole;
                    sink.fragment(Fragment::covered(column, row, coverage.min(255) as u8))?;
                }
            }
        }
        Ok(())
    }

    /// How many of n samples of a line are set; n divides 8, or is a multiple of it.
    fn ones(&self, line: usize, sample: usize) -> u32 {
        let n = usize::from(self.side.get());
        let start = line * self.stride + sample / 8;
        let bytes = self.bits.get(start..start + n.div_ceil(8)).unwrap_or_default();
        let mask = if n < 8 { ((1_u8 << n) - 1) << (sample % 8) } else { u8::MAX };
        bytes.iter().map(|byte| (byte & mask).count_ones()).sum()
    }
}
