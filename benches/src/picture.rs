//! Pictures that can be emptied and looked at.

use std::fmt;

use tiny_skia::Pixmap;

use crate::{
    drawing::PIXELS,
    scenes::{FRAME_HEIGHT, FRAME_WIDTH, Frame},
};

/// How much of each pixel is covered, in 255ths.
pub(crate) type Coverage = [u8; PIXELS];

/// Nothing covered.
pub(crate) fn no_coverage() -> Box<Coverage> {
    vec![0; PIXELS].try_into().expect("as many as asked for")
}

pub(crate) trait Picture: fmt::Debug {
    fn clear(&mut self);

    /// How much of each pixel was drawn on since it was cleared. An RGB565 picture has not the bits to tell: for it, a
    /// pixel is drawn or it is not.
    fn read(&self, coverage: &mut Coverage);

    /// The picture itself, if it is a frame.
    fn frame(&self) -> Option<&Frame> {
        None
    }
}

impl Picture for Box<Frame> {
    fn clear(&mut self) {
        **self = const { Frame::new() };
    }

    fn read(&self, coverage: &mut Coverage) {
        let empty = const { Frame::new() }.rows()[0][0];
        for (coverage, pixel) in coverage.iter_mut().zip(self.rows().as_flattened()) {
            *coverage = if *pixel == empty { 0 } else { 255 };
        }
    }

    fn frame(&self) -> Option<&Frame> {
        Some(self)
    }
}

/// Everything is drawn opaque: the alpha is the coverage.
impl Picture for Pixmap {
    fn clear(&mut self) {
        self.data_mut().fill(0);
    }

    fn read(&self, coverage: &mut Coverage) {
        for (coverage, pixel) in coverage.iter_mut().zip(self.pixels()) {
            *coverage = pixel.alpha();
        }
    }
}

/// As with [`Pixmap`].
impl Picture for vello_cpu::Pixmap {
    fn clear(&mut self) {
        self.data_as_u8_slice_mut().fill(0);
    }

    fn read(&self, coverage: &mut Coverage) {
        for (coverage, pixel) in coverage.iter_mut().zip(self.data()) {
            *coverage = pixel.a;
        }
    }
}

/// Whole pixels of the frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Bounds {
    pub(crate) left: i32,
    pub(crate) top: i32,
    /// Positive.
    pub(crate) width: i32,
    /// Positive.
    pub(crate) height: i32,
}

/// The coverage of one shape's bounds: what text is drawn from.
#[derive(Debug)]
pub(crate) struct Mask {
    bounds: Bounds,
    bytes: Vec<u8>,
}

impl Mask {
    /// With room for any bounds on the frame.
    pub(crate) fn new() -> Self {
        Self { bounds: Bounds { left: 0, top: 0, width: 1, height: 1 }, bytes: Vec::with_capacity(PIXELS) }
    }

    /// The bytes for another shape, row by row, all 0.
    #[inline]
    pub(crate) fn start(&mut self, bounds: Bounds) -> &mut [u8] {
        self.bytes.clear();
        self.start_with_any(bounds)
    }

    /// The bytes for another shape, row by row, whatever they are.
    #[inline]
    pub(crate) fn start_with_any(&mut self, bounds: Bounds) -> &mut [u8] {
        self.bounds = bounds;
        self.bytes.resize((bounds.width * bounds.height).unsigned_abs() as usize, 0);
        &mut self.bytes
    }
}

impl Picture for Mask {
    fn clear(&mut self) {
        self.bytes.clear();
    }

    fn read(&self, coverage: &mut Coverage) {
        coverage.fill(0);
        let Bounds { left, top, width, height } = self.bounds;
        assert!(left >= 0 && top >= 0 && left + width <= FRAME_WIDTH && top + height <= FRAME_HEIGHT);
        for (row, bytes) in (top..).zip(self.bytes.chunks_exact(width.unsigned_abs() as usize)) {
            let start = (row * FRAME_WIDTH + left).unsigned_abs() as usize;
            coverage[start..][..bytes.len()].copy_from_slice(bytes);
        }
    }
}
