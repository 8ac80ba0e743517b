//! Points of a bumpy globe, as many as one likes.

use embedded_graphics::pixelcolor::Rgb565;

use super::builder::{Point, normal_code};

/// The model's radius, in its own units.
pub(crate) const UNIT: f64 = (1 << 24) as f64;

/// How far the surface is from the middle in a direction.
pub(crate) fn height([x, y, z]: [f64; 3]) -> f64 {
    let waves = (9.0 * x).sin() * (11.0 * y).sin() * (10.0 * z).sin();
    let ripples = (40.0 * (x + 0.3 * y)).sin() * (37.0 * (z - 0.2 * x)).sin();
    let grain = (230.0 * x + 3.0 * (31.0 * y).sin()).sin() * (210.0 * z).sin();
    0.8 * (1.0 + 0.12 * waves + 0.02 * ripples + 0.003 * grain)
}

/// Points spread evenly over a bumpy globe, along a spiral whose turns are a golden section apart.
pub(crate) fn cloud(count: usize) -> Vec<Point> {
    let golden = std::f64::consts::PI * (3.0 - 5_f64.sqrt());
    let spacing = (4.0 * std::f64::consts::PI / count as f64).sqrt() * 0.8;
    (0..count)
        .map(|index| {
            let z = 1.0 - (2.0 * index as f64 + 1.0) / count as f64;
            let (sine, cosine) = (golden * index as f64).sin_cos();
            let across = (1.0 - z * z).sqrt();
            let at = [across * cosine, across * sine, z];
            let here = height(at);
            // Two neighbours at right angles, for the direction.
            let aside = if z.abs() < 0.9 { [-sine, cosine, 0.0] } else { [1.0, 0.0, -at[0] / z] };
            let cross = |a: [f64; 3], b: [f64; 3]| {
                [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
            };
            let unit = |v: [f64; 3]| {
                let length = v.iter().map(|part| part * part).sum::<f64>().sqrt();
                v.map(|part| part / length)
            };
            let (u, v) = (unit(aside), unit(cross(at, unit(aside))));
            let near = |direction: [f64; 3]| {
                let moved = unit(std::array::from_fn(|axis| at[axis] + 1e-4 * direction[axis]));
                let height = height(moved);
                std::array::from_fn(|axis| moved[axis] * height - at[axis] * here)
            };
            let direction = unit(cross(near(u), near(v)));
            Point {
                at: at.map(|part| (part * here * UNIT) as i32),
                radius: (spacing * here * UNIT * 0.75) as i32 + 1,
                normal: normal_code(direction),
                colour: colour(here),
            }
        })
        .collect()
}

/// What colour the surface has at a height.
pub(crate) fn colour(height: f64) -> Rgb565 {
    let level = ((height - 0.68) / 0.24).clamp(0.0, 1.0);
    Rgb565::new((8.0 + 23.0 * level) as u8, (40.0 - 12.0 * level) as u8, (28.0 - 20.0 * level) as u8)
}
