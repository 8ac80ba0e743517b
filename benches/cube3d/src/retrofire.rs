//! By retrofire-core: its scan conversion of triangles on the screen, its fragments, and its frame with a depth buffer.

use embedded_graphics::{
    pixelcolor::{Rgb565, Rgb888, raw::RawU16},
    prelude::*,
};
use retrofire_core::{
    geom::Vertex,
    math::{Color3f, Color4, Vary, color::rgb, point::pt3, rgba},
    render::{
        Colorbuf, Context, Frag, Framebuf, Target, raster,
        shader::FragmentShader,
        tex::{SamplerClamp, Texture, uv},
    },
    util::{Buf2, Dims, pixfmt},
};

use crate::{
    peers::{BACKGROUND, Library, Seen},
    scene::{Projected, SIDE, TEXELS, ring_colour},
};

pub(crate) struct Retrofire {
    target: Framebuf<Colorbuf<Buf2<u16>, pixfmt::Rgb565>, Buf2<f32>>,
    board: Texture<Buf2<Color4>>,
    context: Context,
    size: [u32; 2],
}

impl Retrofire {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let size = [width as u32, height as u32];
        let dims = Dims(size[0], size[1]);
        let texel = |x: u32, y: u32| {
            let colour = Rgb888::from(TEXELS[y as usize][x as usize]);
            rgba(colour.r(), colour.g(), colour.b(), 255)
        };
        Self {
            target: Framebuf { color_buf: Colorbuf::new(Buf2::new(dims)), depth_buf: Buf2::new(dims) },
            board: Texture::from(Buf2::new_with(Dims(SIDE as u32, SIDE as u32), texel)),
            context: Context::default(),
            size,
        }
    }
}

/// Draws a triangle whose third coordinate is the reciprocal of the distance, as retrofire has it; what varies comes
/// divided by the distance.
fn draw<V: Vary>(
    target: &mut impl Target,
    seen: &Projected,
    context: &Context,
    varying: [V; 3],
    shader: impl FragmentShader<V, ()>,
) {
    let mut varying = varying.into_iter();
    let mut corners = seen.triangle.vertices.iter().zip(seen.distances).filter_map(|(vertex, w)| {
        let w = w as f32 / 4096.0;
        let attrib = varying.next()?.z_div(w);
        Some(Vertex { pos: pt3(vertex.x.to_num(), vertex.y.to_num(), 1.0 / w), attrib })
    });
    let (Some(a), Some(b), Some(c)) = (corners.next(), corners.next(), corners.next()) else { return };
    raster::tri_fill([a, b, c], |line| target.rasterize(line, &shader, (), context));
}

impl Library for Retrofire {
    fn draw(&mut self, triangles: &[Seen]) {
        let Self { target, board, context, .. } = self;
        target.color_buf.buf.data_mut().fill(RawU16::from(BACKGROUND).into_inner());
        target.depth_buf.data_mut().fill(0.0);
        for Seen { projected, is_textured } in triangles {
            if *is_textured {
                let texel = |part: i32| part as f32 / 256.0;
                let varying = projected.varying.map(|[u, v]| uv(texel(u), texel(v)));
                draw(target, projected, context, varying, |frag: Frag<_>, ()| SamplerClamp.sample_abs(board, frag.var));
            } else {
                let varying = projected.varying.map(|[light, _]| {
                    let colour = ring_colour(light);
                    let part = |step: u8, last: u8| f32::from(step) / f32::from(last);
                    rgb(part(colour.r(), 31), part(colour.g(), 63), part(colour.b(), 31))
                });
                draw(target, projected, context, varying, |frag: Frag<Color3f>, ()| frag.var.to_color4());
            }
        }
    }

    fn picture(&self) -> Vec<Rgb565> {
        let [width, height] = self.size;
        (0..height)
            .flat_map(|y| (0..width).map(move |x| (x, y)))
            .map(|(x, y)| RawU16::new(self.target.color_buf.buf[y as usize][x as usize]).into())
            .collect()
    }
}
