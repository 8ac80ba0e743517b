//! A textured cube and a lit ring, turning: the same file for a host and a microcontroller.
//!
//! Fixed point throughout. Lengths are in 1/4096, angles in 1/1024 of a turn, sines in 1/16384. Of each triangle:
//! vertices are turned, moved and cut at the near plane, projected to 1/256 px, dropped where they turn their back, and
//! drawn with a depth of `65535 (1 - near / z)`, which is a plane over the screen.

use embedded_graphics_core::{
    geometry::{OriginDimensions, Point, Size},
    image::GetPixel,
    pixelcolor::Rgb565,
};
use spanfill::{
    Attributes as _, DepthBuffer, DepthTest, Filter, Gouraud, Perspective, PixelRows, Texture, Triangle, Vertex, Wrap,
};

/// x to the right, y down, z away from the eye.
type Vector = [i32; 3];

/// Frames until everything is as it was.
pub(crate) const FRAMES: u32 = 96;

/// One.
const UNIT: i32 = 4096;
/// What is nearer is cut off.
const NEAR: i32 = UNIT;
const TURN: usize = 1024;

/// Sines of a turn, in 1/16384.
static SINES: [i16; TURN] = sines();

const fn sines() -> [i16; TURN] {
    let mut table = [0; TURN];
    let mut index = 0;
    while index < TURN {
        // To -1/2..1/2 of a turn, and the series up to the 19th power: off by 1e-9.
        let turns = index as f64 / TURN as f64 - if index > TURN / 2 { 1.0 } else { 0.0 };
        let x = turns * 2.0 * core::f64::consts::PI;
        let (mut term, mut sum, mut n) = (x, x, 1.0);
        while n < 12.0 {
            term = -term * x * x / ((2.0 * n) * (2.0 * n + 1.0));
            sum += term;
            n += 1.0;
        }
        table[index] = (sum * 16384.0 + if sum < 0.0 { -0.5 } else { 0.5 }) as i16;
        index += 1;
    }
    table
}

fn sine(angle: u32) -> i32 {
    i32::from(SINES[angle as usize % TURN])
}

fn cosine(angle: u32) -> i32 {
    sine(angle.wrapping_add(TURN as u32 / 4))
}

/// Turned around the y axis, then the x axis.
fn turned([x, y, z]: Vector, around_y: u32, around_x: u32) -> Vector {
    let (s, c) = (sine(around_y), cosine(around_y));
    let (x, z) = ((x * c + z * s) >> 14, (z * c - x * s) >> 14);
    let (s, c) = (sine(around_x), cosine(around_x));
    [x, (y * c - z * s) >> 14, (y * s + z * c) >> 14]
}

/// A vertex in front of the eye, and what varies: coordinates in a texture, or a shade.
#[derive(Clone, Copy)]
struct Seen {
    at: Vector,
    varying: [i32; 2],
}

/// Where the line between two vertices meets the near plane.
fn at_near_plane(inside: &Seen, outside: &Seen) -> Seen {
    let (depth, part) = (inside.at[2] - outside.at[2], inside.at[2] - NEAR);
    let mix = |a: i32, b: i32| a + (i64::from(b - a) * i64::from(part) / i64::from(depth.max(1))) as i32;
    let at = |axis: usize| mix(inside.at[axis], outside.at[axis]);
    let varying = |index: usize| mix(inside.varying[index], outside.varying[index]);
    Seen { at: [at(0), at(1), NEAR], varying: [varying(0), varying(1)] }
}

/// Cuts off what is before the near plane: three vertices or four, or none.
fn clipped(triangle: &[Seen; 3]) -> heapless::Vec<Seen, 4> {
    let mut kept = heapless::Vec::new();
    for index in 0..3 {
        let (here, next) = (&triangle[index], &triangle[(index + 1) % 3]);
        let (is_here, is_next) = (here.at[2] >= NEAR, next.at[2] >= NEAR);
        if is_here {
            let _ = kept.push(*here);
        }
        if is_here != is_next {
            let (inside, outside) = if is_here { (here, next) } else { (next, here) };
            let _ = kept.push(at_near_plane(inside, outside));
        }
    }
    kept
}

/// A triangle on the screen, with everything that drawing needs.
pub(crate) struct Projected {
    pub(crate) triangle: Triangle,
    pub(crate) varying: [[i32; 2]; 3],
    pub(crate) distances: [i32; 3],
    pub(crate) depths: [u16; 3],
}

/// How a screen sees.
#[derive(Clone, Copy)]
pub(crate) struct Camera {
    /// In 1/256 px.
    middle: [i32; 2],
    focal: i32,
}

impl Camera {
    pub(crate) fn of(size: Size) -> Self {
        let [width, height] = [size.width, size.height].map(|side| side as i32);
        Self { middle: [width * 128, height * 128], focal: height * 256 }
    }

    /// The pieces of a triangle that face the eye.
    fn project(&self, triangle: &[Seen; 3], mut draw: impl FnMut(&Projected)) {
        let corners = clipped(triangle);
        for last in 2..corners.len() {
            let corners = [&corners[0], &corners[last - 1], &corners[last]];
            let on_screen = |axis: usize, seen: &Seen| {
                (i64::from(seen.at[axis]) * i64::from(self.focal) / i64::from(seen.at[2])) as i32 + self.middle[axis]
            };
            let points = corners.map(|seen| [on_screen(0, seen), on_screen(1, seen)]);
            let [a, b, c] = points.map(|[x, y]| [i64::from(x), i64::from(y)]);
            if (b[0] - a[0]) * (c[1] - a[1]) <= (c[0] - a[0]) * (b[1] - a[1]) {
                continue;
            }
            draw(&Projected {
                triangle: Triangle::from_vertices(points.map(|[x, y]| Vertex::from_bits(x, y))),
                varying: corners.map(|seen| seen.varying),
                distances: corners.map(|seen| seen.at[2]),
                depths: corners.map(|seen| (65535 - i64::from(NEAR) * 65535 / i64::from(seen.at[2])) as u16),
            });
        }
    }
}

pub(crate) const SIDE: i32 = 64;

/// A picture of 64 x 64: a board with round holes.
struct Board;

impl OriginDimensions for Board {
    fn size(&self) -> Size {
        Size::new(SIDE as u32, SIDE as u32)
    }
}

pub(crate) static TEXELS: [[Rgb565; SIDE as usize]; SIDE as usize] = texels();

const fn texels() -> [[Rgb565; SIDE as usize]; SIDE as usize] {
    let mut texels = [[Rgb565::new(0, 0, 0); SIDE as usize]; SIDE as usize];
    let mut index = 0;
    while index < SIDE * SIDE {
        let (x, y) = (index % SIDE, index / SIDE);
        let (dx, dy) = (x % 16 * 2 - 15, y % 16 * 2 - 15);
        let rim = x < 2 || y < 2 || x >= SIDE - 2 || y >= SIDE - 2;
        texels[y as usize][x as usize] = if rim {
            Rgb565::new(31, 63, 31)
        } else if dx * dx + dy * dy < 90 {
            Rgb565::new(31, 40, 4)
        } else if (x / 16 + y / 16) % 2 == 0 {
            Rgb565::new(4, 20, 24)
        } else {
            Rgb565::new(8, 34, 14)
        };
        index += 1;
    }
    texels
}

impl GetPixel for Board {
    type Color = Rgb565;

    #[inline(always)]
    fn pixel(&self, point: Point) -> Option<Rgb565> {
        TEXELS.as_flattened().get((point.y * SIDE + point.x) as usize).copied()
    }
}

/// Corners of the cube, by bits: x, y, z.
fn corner(index: usize) -> Vector {
    [0, 1, 2].map(|bit| if index >> bit & 1 == 0 { -UNIT } else { UNIT })
}

/// The corners of each side, clockwise as seen from outside.
const SIDES: [[usize; 4]; 6] = [[0, 1, 3, 2], [5, 4, 6, 7], [4, 0, 2, 6], [1, 5, 7, 3], [4, 5, 1, 0], [2, 3, 7, 6]];

/// The cube's triangles, with coordinates in the texture in 1/256 texel.
pub(crate) fn for_each_of_cube(camera: Camera, frame: u32, mut draw: impl FnMut(&Projected)) {
    const LAST: i32 = SIDE * 256;
    let angle = frame * TURN as u32 / FRAMES;
    // Near enough to be cut, once a round.
    let away = 4 * UNIT + 3 * UNIT / 2 + (((9 * UNIT / 4) * cosine(angle)) >> 14);
    for side in SIDES {
        let texel = [[0, 0], [LAST, 0], [LAST, LAST], [0, LAST]];
        let corners: [Seen; 4] = core::array::from_fn(|index| {
            let [x, y, z] = turned(corner(side[index]), angle, angle * 2 + 80);
            Seen { at: [x - UNIT / 2, y, z + away], varying: texel[index] }
        });
        for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
            camera.project(&[corners[a], corners[b], corners[c]], &mut draw);
        }
    }
}

/// Around the ring, and around its tube: 24 x 12 x 2 triangles.
const AROUND: u32 = 24;
const ACROSS: u32 = 12;

/// A point of the ring and its shade, 0 to 16384, by the angle between its direction and the light.
fn ring_point(around: u32, across: u32, frame: u32, away: i32) -> Seen {
    let (around, across) = (around * TURN as u32 / AROUND, across * TURN as u32 / ACROSS);
    let (outwards, along) = (cosine(across), sine(across));
    let direction = [(outwards * cosine(around)) >> 14, along, (outwards * sine(around)) >> 14];
    let (large, small) = (11 * UNIT / 4, UNIT / 2);
    let length = large + ((small * outwards) >> 14);
    let at = [(length * cosine(around)) >> 14, (small * along) >> 14, (length * sine(around)) >> 14];
    let turn = frame * TURN as u32 / FRAMES;
    let tilt = 100 + (sine(turn) / 200) as u32;
    let [x, y, z] = turned(at, turn.wrapping_neg(), tilt);
    let [nx, ny, nz] = turned(direction, turn.wrapping_neg(), tilt);
    let light = ((-nx - ny - nz) * 9 / 16).clamp(0, 16384);
    Seen { at: [x - UNIT / 2, y, z + away], varying: [light, 0] }
}

/// The ring's triangles, with a shade, 0 to 16384, and nothing.
pub(crate) fn for_each_of_ring(camera: Camera, frame: u32, mut draw: impl FnMut(&Projected)) {
    let away = 4 * UNIT + 3 * UNIT / 2 + (((9 * UNIT / 4) * cosine(frame * TURN as u32 / FRAMES)) >> 14);
    for around in 0..AROUND {
        for across in 0..ACROSS {
            let at = |right: u32, down: u32| ring_point(around + right, across + down, frame, away);
            let (a, b, c, d) = (at(0, 0), at(1, 0), at(1, 1), at(0, 1));
            for triangle in [[a, b, c], [a, c, d]] {
                camera.project(&triangle, &mut draw);
            }
        }
    }
}

/// The colour of a shade of the ring.
pub(crate) fn ring_colour(light: i32) -> Rgb565 {
    let step = |last: i32| ((3 * 16384 + 13 * light) / 16 * last / 16384) as u8;
    Rgb565::new(step(30), step(44), step(31))
}

/// Draws one of the cube's.
pub(crate) fn draw_textured<D: PixelRows<Color = Rgb565>>(
    seen: &Projected,
    target: &mut D,
    depths: &mut DepthBuffer<'_>,
) {
    let Ok(texture) = Texture::new(Board, Wrap::Clamp, Filter::Nearest) else { return };
    let Ok(perspective) = Perspective::new(seen.triangle, seen.varying, seen.distances) else { return };
    let shaded = perspective.shaded(|at| texture.texel(at).unwrap_or(Rgb565::new(0, 0, 0)));
    shaded.depth_tested(seen.depths, DepthTest::LESS).draw_on(target, depths);
}

/// Draws one of the ring's.
pub(crate) fn draw_lit<D: PixelRows<Color = Rgb565>>(seen: &Projected, target: &mut D, depths: &mut DepthBuffer<'_>) {
    let shaded = Gouraud::new(seen.triangle, seen.varying.map(|[light, _]| ring_colour(light)))
        .affine()
        .shaded(|[r, g, b]: [i32; 3]| Rgb565::new(r as u8, g as u8, b as u8));
    shaded.depth_tested(seen.depths, DepthTest::LESS).draw_on(target, depths);
}

/// Draws a frame; how many triangles there were.
pub(crate) fn draw<D: PixelRows<Color = Rgb565>>(target: &mut D, depths: &mut DepthBuffer<'_>, frame: u32) -> u32 {
    depths.clear(u16::MAX);
    let camera = Camera::of(target.bounding_box().size);
    let mut drawn = 0;
    for_each_of_cube(camera, frame, |seen| {
        draw_textured(seen, target, depths);
        drawn += 1;
    });
    for_each_of_ring(camera, frame, |seen| {
        draw_lit(seen, target, depths);
        drawn += 1;
    });
    drawn
}
