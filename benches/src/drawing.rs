//! The shapes of a scene, ready to be drawn by one library on a picture of its own.

use std::{fmt, hint::black_box, ops::Range};

use tiny_skia::Pixmap;

use crate::scenes::{FRAME_HEIGHT, FRAME_WIDTH, Frame};

/// Pixels of the picture that every variant draws on.
pub(crate) const PIXELS: usize = (FRAME_WIDTH * FRAME_HEIGHT) as usize;

/// See the module. Object safe, so that variants can take turns; a call draws many shapes, and costs nothing beside them.
pub(crate) trait Drawing: fmt::Debug {
    /// How many shapes there are.
    fn shapes(&self) -> usize;

    /// Draws these shapes. This is what is measured.
    fn draw(&mut self, shapes: Range<usize>);

    /// Draws one shape on an empty picture, and tells which pixels it has.
    fn draw_alone(&mut self, shape: usize, covered: &mut [bool; PIXELS]);
}

/// A picture that can be emptied and looked at.
pub(crate) trait Picture: fmt::Debug {
    fn clear(&mut self);
    fn read(&self, covered: &mut [bool; PIXELS]);
}

impl Picture for Box<Frame> {
    fn clear(&mut self) {
        **self = const { Frame::new() };
    }

    fn read(&self, covered: &mut [bool; PIXELS]) {
        let empty = const { Frame::new() }.rows()[0][0];
        for (covered, pixel) in covered.iter_mut().zip(self.rows().as_flattened()) {
            *covered = *pixel != empty;
        }
    }
}

impl Picture for Pixmap {
    fn clear(&mut self) {
        self.data_mut().fill(0);
    }

    fn read(&self, covered: &mut [bool; PIXELS]) {
        for (covered, pixel) in covered.iter_mut().zip(self.pixels()) {
            *covered = pixel.alpha() != 0;
        }
    }
}

/// A picture, shapes, and how to draw one of them.
pub(crate) struct On<P, T, F> {
    picture: P,
    shapes: Vec<T>,
    draw: F,
}

impl<P, T, F> On<P, T, F>
where
    P: Picture + 'static,
    T: 'static,
    F: FnMut(&T, &mut P) + 'static,
{
    pub(crate) fn boxed(picture: P, shapes: Vec<T>, draw: F) -> Box<dyn Drawing> {
        Box::new(Self { picture, shapes, draw })
    }
}

impl<P: Picture, T, F> fmt::Debug for On<P, T, F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("On").field("shapes", &self.shapes.len()).finish_non_exhaustive()
    }
}

impl<P: Picture, T, F: FnMut(&T, &mut P)> Drawing for On<P, T, F> {
    fn shapes(&self) -> usize {
        self.shapes.len()
    }

    fn draw(&mut self, shapes: Range<usize>) {
        for shape in &self.shapes[shapes] {
            (self.draw)(black_box(shape), &mut self.picture);
        }
        black_box(&self.picture);
    }

    fn draw_alone(&mut self, shape: usize, covered: &mut [bool; PIXELS]) {
        self.picture.clear();
        (self.draw)(&self.shapes[shape], &mut self.picture);
        self.picture.read(covered);
    }
}
