//! Directions, in 14 bits.

/// How many codes there are: 52 x 52 on each side of a cube.
pub const NORMAL_CODES: u16 = 6 * 52 * 52;

/// The sines of a cone's half-angle, in 16ths.
pub const CONE_SINES: [i32; 4] = [1, 4, 9, 16];

const SIDE: usize = 52;
const _: () = assert!(NORMAL_CODES as usize == 6 * SIDE * SIDE);

/// On the side of a cube that looks along z: x, y and z in 1/16384.
static DIRECTIONS: [[i16; 3]; SIDE * SIDE] = directions();

/// The direction of a code, of length 16384; none for a code that says nothing.
///
/// Codes lie at equal angles along both sides of a face, `tan((2i + 1 - 52) / 52 * 45 degrees)` from its middle, so
/// that they are spread evenly.
#[inline]
pub fn normal(code: u16) -> Option<[i32; 3]> {
    let code = usize::from(code);
    let (face, index) = (code / (SIDE * SIDE), code % (SIDE * SIDE));
    let [a, b, c] = DIRECTIONS.get(index)?.map(i32::from);
    match face {
        0 => Some([a, b, c]),
        1 => Some([a, b, -c]),
        2 => Some([c, a, b]),
        3 => Some([-c, a, b]),
        4 => Some([b, c, a]),
        5 => Some([b, -c, a]),
        _ => None,
    }
}

#[allow(clippy::indexing_slicing, reason = "run by the compiler, which would fail")]
const fn directions() -> [[i16; 3]; SIDE * SIDE] {
    let mut table = [[0; 3]; SIDE * SIDE];
    let mut index = 0;
    while index < SIDE * SIDE {
        let (x, y) = (tangent(index / SIDE), tangent(index % SIDE));
        let length = root(1.0 + x * x + y * y);
        table[index] = [in_16384ths(x / length), in_16384ths(y / length), in_16384ths(1.0 / length)];
        index += 1;
    }
    table
}

/// By its series up to the 13th power: angles are below 45 degrees.
const fn tangent(index: usize) -> f64 {
    let x = (2.0 * index as f64 + 1.0 - SIDE as f64) / SIDE as f64 * core::f64::consts::FRAC_PI_4;
    let square = x * x;
    let (mut sine, mut cosine, mut term, mut n) = (x, 1.0, 1.0, 1.0);
    while n < 12.0 {
        term = -term * square / ((2.0 * n - 1.0) * (2.0 * n));
        cosine += term;
        sine += term * x / (2.0 * n + 1.0);
        n += 1.0;
    }
    sine / cosine
}

/// By Newton's iteration.
const fn root(x: f64) -> f64 {
    let (mut root, mut step) = (x, 0);
    while step < 12 {
        root = (root + x / root) / 2.0;
        step += 1;
    }
    root
}

#[allow(clippy::cast_possible_truncation, reason = "at most 16384")]
const fn in_16384ths(x: f64) -> i16 {
    (x * 16384.0 + if x < 0.0 { -0.5 } else { 0.5 }) as i16
}
