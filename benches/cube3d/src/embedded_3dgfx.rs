//! By embedded-3dgfx: the rasterizers behind its engine, as it calls them. They take vertices in whole pixels.

use embedded_3dgfx::pipeline::{
    assemble::primitive::DrawPrimitive,
    rasterize::{
        draw::{RasterState, textured::draw_zbuffered_with_textures_state},
        texture::{Texture, TextureManager},
    },
};
use embedded_graphics::pixelcolor::Rgb565;
use nalgebra::Point2;

use crate::{
    frame::Frame,
    peers::{BACKGROUND, Library, Seen},
    scene::{SIDE, TEXELS, ring_colour},
};

pub(crate) struct Embedded3dgfx {
    frame: Frame,
    depths: Vec<embedded_3dgfx::ZDepth>,
    textures: TextureManager<1>,
    board: u32,
}

impl Embedded3dgfx {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let mut textures = TextureManager::new();
        let side = SIDE.unsigned_abs();
        let board = textures.add_texture(Texture::new(TEXELS.as_flattened(), side, side)).unwrap_or_default();
        Self { frame: Frame::new(width, height), depths: vec![0; width * height], textures, board }
    }
}

impl Library for Embedded3dgfx {
    fn draw(&mut self, triangles: &[Seen]) {
        self.frame.pixels.fill(BACKGROUND);
        self.depths.fill(embedded_3dgfx::Z_MAX_VALUE);
        let state = RasterState::from_zbuffer(self.frame.width, self.depths.len());
        for Seen { projected, is_textured } in triangles {
            // The nearest pixel's corner.
            let points = projected.triangle.vertices.map(|vertex| {
                let pixel = |part: spanfill::I24F8| part.round().to_num::<i32>();
                Point2::new(pixel(vertex.x), pixel(vertex.y))
            });
            // In 16 bits it keeps the whole part.
            let depths = projected.depths.map(f32::from);
            let primitive = if *is_textured {
                let last = (SIDE * 256) as f32;
                DrawPrimitive::TexturedTriangleWithDepth {
                    points,
                    depths,
                    ws: projected.distances.map(|w| w as f32),
                    // Its textures repeat: the last texel is just before the end.
                    uvs: projected.varying.map(|uv| uv.map(|part| (part as f32 / last).min(0.9999))),
                    texture_id: self.board,
                }
            } else {
                let colors = projected.varying.map(|[light, _]| ring_colour(light));
                DrawPrimitive::GouraudTriangleWithDepth { points, depths, colors }
            };
            draw_zbuffered_with_textures_state(primitive, &mut self.frame, &mut self.depths, &self.textures, &state);
        }
    }

    fn picture(&self) -> Vec<Rgb565> {
        self.frame.pixels.clone()
    }
}
