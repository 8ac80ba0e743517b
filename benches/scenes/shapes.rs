//! The shapes of the scenes, as plain integers.

use super::{FRAME_HEIGHT, FRAME_WIDTH, Random};

/// x and y of a pixel. For a shape with sub-pixel vertices it stands for that pixel's centre.
pub(crate) type PixelPoint = [i32; 2];

/// x and y in 1/256 pixel, (0, 0) being the top-left corner of the top-left pixel.
pub(crate) type SubpixelPoint = [i32; 2];

/// What is drawn, and how large.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Scene {
    /// [`triangles`] in boxes of so many pixels.
    Triangles(i32),
    /// [`circles`] of this radius in pixels.
    Circles(i32),
    /// [`lines`] in boxes of so many pixels.
    Lines(i32),
    /// [`stars`] of this radius in pixels.
    Stars(i32),
    /// [`concave_polygons`] of this radius in pixels.
    Concave64(i32),
}

impl Scene {
    /// Every scene that is measured, in the order of the tables.
    pub(crate) const ALL: [Self; 12] = [
        Self::Triangles(10),
        Self::Triangles(50),
        Self::Triangles(200),
        Self::Circles(5),
        Self::Circles(20),
        Self::Circles(100),
        Self::Lines(50),
        Self::Lines(200),
        Self::Stars(100),
        Self::Concave64(5),
        Self::Concave64(20),
        Self::Concave64(100),
    ];

    /// The scene's name in tables and CSV rows; [`Scene::size_px`] goes with it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Triangles(_) => "triangle",
            Self::Circles(_) => "circle",
            Self::Lines(_) => "line",
            Self::Stars(_) => "star",
            Self::Concave64(_) => "concave-64",
        }
    }

    /// The size that belongs to the name: the side of the box, a circle's radius, an outline's largest radius.
    pub(crate) const fn size_px(self) -> i32 {
        match self {
            Self::Triangles(size_px)
            | Self::Circles(size_px)
            | Self::Lines(size_px)
            | Self::Stars(size_px)
            | Self::Concave64(size_px) => size_px,
        }
    }

    /// What the size is of.
    pub(crate) const fn size_name(self) -> &'static str {
        match self {
            Self::Triangles(_) | Self::Lines(_) => "box",
            Self::Circles(_) | Self::Stars(_) | Self::Concave64(_) => "radius",
        }
    }
}

/// Triangles with three uniform random pixels of a square box as vertices, the box placed at random on the frame.
///
/// A few of the small ones have no area: every library meets the same ones.
pub(crate) fn triangles(box_px: i32) -> impl Iterator<Item = [PixelPoint; 3]> {
    points_in_boxes(box_px, 0x7121)
}

/// Lines between two uniform random pixels of a square box, the box placed at random on the frame. Both ends are drawn.
pub(crate) fn lines(box_px: i32) -> impl Iterator<Item = [PixelPoint; 2]> {
    points_in_boxes(box_px, 0x0011)
}

/// Centres of circles of this radius, the whole circle on the frame.
///
/// A centre [x, y] is the corner between four pixels, x pixels to the right of the frame's left edge: the circle that
/// embedded-graphics draws inside the square of 2 radius with its top-left pixel at [x - radius, y - radius].
pub(crate) fn circles(radius_px: i32) -> impl Iterator<Item = PixelPoint> {
    let mut random = seeded(0xC12C, radius_px);
    core::iter::repeat_with(move || {
        [
            radius_px + random.below(FRAME_WIDTH + 1 - 2 * radius_px),
            radius_px + random.below(FRAME_HEIGHT + 1 - 2 * radius_px),
        ]
    })
}

/// Five-pointed stars of this radius as [`STAR`] is one, turned at random, around a random point that is no further from
/// the frame's edge than the radius.
pub(crate) fn stars(radius_px: i32) -> impl Iterator<Item = [SubpixelPoint; 5]> {
    let mut random = seeded(0x57A2, radius_px);
    core::iter::repeat_with(move || {
        let (centre, turned) = (centre_for(radius_px, &mut random), random.below(TURN));
        core::array::from_fn(|tip| on_circle(centre, radius_px * 256, turned + TURN * 2 * tip as i32 / 5))
    })
}

/// Polygons of 64 vertices as [`CONCAVE_64`] is one, around a random point that is no further from the frame's edge than
/// the radius: at equal angles, in turn 74 to 100 and 35 to 74 hundredths of it away.
pub(crate) fn concave_polygons(radius_px: i32) -> impl Iterator<Item = [SubpixelPoint; 64]> {
    let mut random = seeded(0xC0CA, radius_px);
    core::iter::repeat_with(move || {
        let (centre, turned) = (centre_for(radius_px, &mut random), random.below(TURN));
        core::array::from_fn(|i| {
            let (shortest, longest) = if i % 2 == 0 { (74, 100) } else { (35, 74) };
            let distance =
                radius_px * 256 * shortest / 100 + random.below(radius_px * 256 * (longest - shortest) / 100);
            on_circle(centre, distance, turned + TURN * i as i32 / 64)
        })
    })
}

/// A point from which a circle of this radius lies on the frame, a pixel away from its edges.
fn centre_for(radius_px: i32, random: &mut Random) -> SubpixelPoint {
    let within = |length: i32, random: &mut Random| {
        let margin = (radius_px + 1) * 256;
        margin + random.below(length * 256 - 2 * margin)
    };
    [within(FRAME_WIDTH, random), within(FRAME_HEIGHT, random)]
}

/// Angles are in this part of a turn.
const TURN: i32 = 1 << 16;

fn on_circle([x, y]: SubpixelPoint, radius: i32, angle: i32) -> SubpixelPoint {
    [x + ((radius * sin_between(angle)) >> 14), y - ((radius * sin_between(angle + TURN / 4)) >> 14)]
}

/// 2^14 sin(angle), to 0.13 %: straight between 64ths of a turn.
fn sin_between(angle: i32) -> i32 {
    let step = TURN / 64;
    let (index, rest) = (angle.rem_euclid(TURN) / step, angle.rem_euclid(step));
    let (before, after) = (sin_q14(index.unsigned_abs() as usize), sin_q14(index.unsigned_abs() as usize + 1));
    before + (after - before) * rest / step
}

fn points_in_boxes<const N: usize>(box_px: i32, kind: u64) -> impl Iterator<Item = [PixelPoint; N]> {
    let mut random = seeded(kind, box_px);
    core::iter::repeat_with(move || {
        let left = random.below(FRAME_WIDTH + 1 - box_px);
        let top = random.below(FRAME_HEIGHT + 1 - box_px);
        core::array::from_fn(|_| [left + random.below(box_px), top + random.below(box_px)])
    })
}

fn seeded(kind: u64, size_px: i32) -> Random {
    Random::new((kind << 32) | u64::from(size_px.unsigned_abs()))
}

pub(crate) const STAR_RADIUS_PX: i32 = 100;

/// A five-pointed star around the frame's centre, drawn without lifting the pen: each vertex is two fifths of a turn
/// on from the one before, [160 + 100 sin, 120 - 100 cos] rounded to 1/256 pixel.
pub(crate) const STAR: [SubpixelPoint; 5] =
    [[40960, 5120], [56007, 51431], [16613, 22809], [65307, 22809], [25913, 51431]];

pub(crate) const CONCAVE_RADIUS_PX: i32 = 115;

/// A polygon that does not cross itself and is far from convex: 64 vertices around the frame's centre, at equal
/// angles, in turn 85 to 115 and 40 to 85 pixels away.
pub(crate) const CONCAVE_64: [SubpixelPoint; 64] = concave_64();

const fn concave_64() -> [SubpixelPoint; 64] {
    let mut random = Random::new(0xC0CA);
    let mut outline = [[0; 2]; 64];
    let mut i = 0;
    while i < outline.len() {
        let (shortest_px, longest_px) = if i % 2 == 0 { (85, CONCAVE_RADIUS_PX) } else { (40, 85) };
        let radius = shortest_px * 256 + random.below((longest_px - shortest_px) * 256);
        outline[i] =
            [FRAME_WIDTH * 128 + ((radius * cos_q14(i)) >> 14), FRAME_HEIGHT * 128 + ((radius * sin_q14(i)) >> 14)];
        i += 1;
    }
    outline
}

/// 2^14 sin(angle), the angle in 64ths of a turn. Times a radius of 115 * 256 it stays below 2^29.
const fn sin_q14(angle: usize) -> i32 {
    const QUARTER_TURN: [i32; 17] =
        [0, 1606, 3196, 4756, 6270, 7723, 9102, 10394, 11585, 12665, 13623, 14449, 15137, 15679, 16069, 16305, 16384];
    match angle % 64 {
        a @ 0..16 => QUARTER_TURN[a],
        a @ 16..32 => QUARTER_TURN[32 - a],
        a @ 32..48 => -QUARTER_TURN[a - 32],
        a => -QUARTER_TURN[64 - a],
    }
}

const fn cos_q14(angle: usize) -> i32 {
    sin_q14(angle + 16)
}
