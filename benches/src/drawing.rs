//! The shapes of a scene, ready to be drawn by one library on a picture of its own.

use std::{fmt, hint::black_box, ops::Range};

use crate::{
    picture::Picture,
    scenes::{FRAME_HEIGHT, FRAME_WIDTH},
};

/// Pixels of the picture that every variant draws on.
pub(crate) const PIXELS: usize = (FRAME_WIDTH * FRAME_HEIGHT) as usize;

/// See the module. Object safe, so that variants can take turns; a call draws many shapes, and costs nothing beside them.
pub(crate) trait Drawing: fmt::Debug {
    /// How many shapes there are.
    fn shapes(&self) -> usize;

    /// How many shapes the library wants to be given at once: it is never timed on fewer, but at the scene's end.
    fn batch(&self) -> usize {
        1
    }

    /// Draws these shapes. This is what is measured.
    fn draw(&mut self, shapes: Range<usize>);

    /// Draws one shape on an empty picture.
    fn draw_alone(&mut self, shape: usize) -> &dyn Picture;
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

    fn draw_alone(&mut self, shape: usize) -> &dyn Picture {
        self.picture.clear();
        (self.draw)(&self.shapes[shape], &mut self.picture);
        &self.picture
    }
}
