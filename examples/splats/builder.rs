//! From a cloud of points to the bytes of a model.

use std::collections::VecDeque;

use embedded_graphics::pixelcolor::Rgb565;
use spanfill::splat::{CONE_SINES, NORMAL_CODES, Node, Sphere, normal};

/// A point of a surface.
#[derive(Clone, Copy)]
pub(crate) struct Point {
    /// In units of the model's.
    pub(crate) at: [i32; 3],
    /// How far the surface reaches to its neighbours.
    pub(crate) radius: i32,
    /// The code of its direction.
    pub(crate) normal: u16,
    pub(crate) colour: Rgb565,
}

/// The code whose direction is nearest, by the cube's side that it looks through.
pub(crate) fn normal_code(direction: [f64; 3]) -> u16 {
    let [x, y, z] = direction;
    let (face, [a, b, c]) = if z.abs() >= x.abs() && z.abs() >= y.abs() {
        (if z > 0.0 { 0 } else { 1 }, [x, y, z])
    } else if x.abs() >= y.abs() {
        (if x > 0.0 { 2 } else { 3 }, [y, z, x])
    } else {
        (if y > 0.0 { 4 } else { 5 }, [z, x, y])
    };
    let place = |part: f64| {
        let angle = (part / c.abs()).atan() / std::f64::consts::FRAC_PI_4;
        ((angle + 1.0) * 26.0).floor().clamp(0.0, 51.0) as u16
    };
    face * 52 * 52 + place(a) * 52 + place(b)
}

/// A range of the points that becomes a node.
struct Range {
    start: usize,
    end: usize,
    sphere: Sphere,
    /// Where its children's group is pointed to from: the group that it stands in itself.
    group: usize,
}

/// What a range's points have in common.
fn summary(points: &[Point]) -> (Sphere, u16, u8, Rgb565) {
    let bound = |pick: fn(i32, i32) -> i32| {
        let first = points[0].at;
        points.iter().fold(first, |bound, point| std::array::from_fn(|axis| pick(bound[axis], point.at[axis])))
    };
    let (low, high) = (bound(i32::min), bound(i32::max));
    let centre: [i32; 3] = std::array::from_fn(|axis| (low[axis] + high[axis]) / 2);
    let mut radius: f64 = 0.0;
    let (mut sum, mut colours) = ([0_i64; 3], [0_u64; 3]);
    for point in points {
        let square: f64 = (0..3).map(|axis| f64::from(point.at[axis] - centre[axis]).powi(2)).sum();
        radius = radius.max(square.sqrt() + f64::from(point.radius));
        let direction = normal(point.normal).expect("a code");
        use embedded_graphics::prelude::RgbColor;
        let colour = [point.colour.r(), point.colour.g(), point.colour.b()];
        for axis in 0..3 {
            sum[axis] += i64::from(direction[axis]);
            colours[axis] += u64::from(colour[axis]);
        }
    }
    let code = if sum == [0; 3] { points[0].normal } else { normal_code(sum.map(|part| part as f64)) };
    let middle = normal(code).expect("a code").map(f64::from);
    let least = points.iter().map(|point| {
        let direction = normal(point.normal).expect("a code").map(f64::from);
        (0..3).map(|axis| direction[axis] * middle[axis]).sum::<f64>() / (16384.0 * 16384.0)
    });
    let cosine = least.fold(1.0_f64, f64::min);
    let sine = if cosine <= 0.0 { 1.0 } else { (1.0 - cosine * cosine).max(0.0).sqrt() };
    let cone = CONE_SINES.iter().position(|limit| sine <= f64::from(*limit) / 16.0).unwrap_or(3) as u8;
    let count = points.len() as u64;
    let [r, g, b] = colours.map(|sum| ((sum + count / 2) / count) as u8);
    (Sphere { centre, radius: radius.ceil() as i32 }, code, cone, Rgb565::new(r, g, b))
}

/// Splits points at the middle of their longest axis.
fn halve(points: &mut [Point]) -> usize {
    let extent = |axis: usize| {
        let low = points.iter().map(|point| point.at[axis]).min().unwrap_or(0);
        let high = points.iter().map(|point| point.at[axis]).max().unwrap_or(0);
        high - low
    };
    let axis = (0..3).max_by_key(|axis| extent(*axis)).expect("three axes");
    let middle = points.len() / 2;
    points.select_nth_unstable_by_key(middle, |point| point.at[axis]);
    middle
}

/// The ranges of a node's children: two halves, each of them halved again.
fn quarters(points: &mut [Point], start: usize) -> Vec<std::ops::Range<usize>> {
    let count = points.len();
    if count <= 4 {
        return (start..start + count).map(|index| index..index + 1).collect();
    }
    let middle = halve(points);
    let (left, right) = points.split_at_mut(middle);
    let (a, b) = (halve(left), middle + halve(right));
    [0..a, a..middle, middle..b, b..count].map(|range| start + range.start..start + range.end).into()
}

/// The bytes of a model of points; it sorts them.
pub(crate) fn build(points: &mut [Point]) -> Vec<u8> {
    assert!(!points.is_empty(), "a model needs a point");
    assert!(points.iter().all(|point| point.normal < NORMAL_CODES), "directions are codes");
    let node = |points: &[Point], sphere: u16, normal: u16, cone: u8, colour: Rgb565| Node {
        sphere,
        children: if points.len() == 1 { 0 } else { points.len().min(4) as u8 },
        grandchildren: points.len() > 4,
        normal,
        cone,
        colour,
    };
    let (root, code, cone, colour) = summary(points);
    let mut bytes = b"SPL1".to_vec();
    bytes.extend([0; 4]);
    for word in root.centre.into_iter().chain([root.radius]) {
        bytes.extend(word.to_le_bytes());
    }
    bytes.extend(node(points, 0, code, cone, colour).to_bytes());
    bytes.extend(34_u32.to_le_bytes());
    let mut nodes = 1_u32;
    let mut waiting = VecDeque::new();
    if points.len() > 1 {
        waiting.push_back(Range { start: 0, end: points.len(), sphere: root, group: 30 });
    }
    // The pointer of each group is filled in when the first group below it is written.
    let mut last_pointer = 30;
    while let Some(range) = waiting.pop_front() {
        let group = bytes.len();
        if range.group != last_pointer {
            last_pointer = range.group;
            let offset = u32::try_from(group).expect("a model of less than 4 GB");
            bytes[range.group..range.group + 4].copy_from_slice(&offset.to_le_bytes());
        }
        let children = quarters(&mut points[range.start..range.end], range.start);
        let pointer = group + 6 * children.len();
        let mut any = false;
        for child in children {
            let points = &points[child.clone()];
            let (inner, normal, cone, colour) = summary(points);
            let code = range.sphere.encode(&inner).unwrap_or_else(|| {
                // Rounding down may leave a parent a unit too small: the largest sphere is the parent's own.
                range
                    .sphere
                    .encode(&Sphere { centre: range.sphere.centre, radius: range.sphere.radius / 13 * 13 - 13 })
                    .unwrap_or(7620)
            });
            bytes.extend(node(points, code, normal, cone, colour).to_bytes());
            nodes += 1;
            if points.len() > 1 {
                any = true;
                let sphere = range.sphere.child(code).expect("a code");
                waiting.push_back(Range { start: child.start, end: child.end, sphere, group: pointer });
            }
        }
        if any {
            bytes.extend([0; 4]);
        }
    }
    bytes[4..8].copy_from_slice(&nodes.to_le_bytes());
    bytes
}
