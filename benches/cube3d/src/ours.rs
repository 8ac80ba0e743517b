//! By this crate.

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use spanfill::DepthBuffer;

use crate::{
    frame::Frame,
    peers::{BACKGROUND, Library, Seen},
    scene::{draw_lit, draw_textured},
};

#[derive(Debug)]
pub(crate) struct Ours {
    frame: Frame,
    depths: Vec<u16>,
}

impl Ours {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        Self { frame: Frame::new(width, height), depths: vec![0; width * height] }
    }
}

impl Library for Ours {
    fn draw(&mut self, triangles: &[Seen]) {
        self.frame.pixels.fill(BACKGROUND);
        let area = Rectangle::new(Point::zero(), self.frame.size());
        let width = self.frame.width;
        let Ok(mut depths) = DepthBuffer::new(area, width, &mut self.depths) else { return };
        depths.clear(u16::MAX);
        for seen in triangles {
            if seen.is_textured {
                draw_textured(&seen.projected, &mut self.frame, &mut depths);
            } else {
                draw_lit(&seen.projected, &mut self.frame, &mut depths);
            }
        }
    }

    fn picture(&self) -> Vec<Rgb565> {
        self.frame.pixels.clone()
    }
}
