//! Outlines of all kinds, around the origin, in sub-pixels; wherever they are put, what leaves the range is cut.

use std::f64::consts::TAU;

use crate::source::Source;

pub(crate) type At = (i64, i64);
pub(crate) type Contour = Vec<At>;

/// How large, and how many.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Extent {
    /// What lies around the origin is as far from it as this, in sub-pixels.
    pub(crate) reach: i64,
    /// The most vertices of a contour, about.
    pub(crate) vertices: usize,
    /// The most contours.
    pub(crate) contours: usize,
}

/// One or more contours.
pub(crate) fn contours(source: &mut Source<'_>, extent: Extent) -> Vec<Contour> {
    let one: [fn(&mut Source<'_>, Extent) -> Contour; 8] =
        [scattered, on_lattice, star, spikes, comb, zigzag, sliver, stroked];
    let many: [fn(&mut Source<'_>, Extent) -> Vec<Contour>; 3] = [nested, several, crumbs];
    let kind = source.count(0..=one.len() + many.len() - 1);
    let mut contours = match kind.checked_sub(one.len()) {
        // Edges far beyond the window cost many times as much.
        _ if source.one_in(100) => {
            let far: [fn(&mut Source<'_>, Extent) -> Contour; 2] = [large, anywhere];
            vec![source.pick(&far)(source, extent)]
        }
        None => vec![one[kind](source, extent)],
        Some(kind) => many[kind](source, extent),
    };
    if source.one_in(6) {
        disturb(source, &mut contours);
    }
    contours
}

fn point(source: &mut Source<'_>, reach: i64) -> At {
    (source.int(-reach..=reach), source.int(-reach..=reach))
}

/// Any polygon, mostly one that crosses itself.
fn scattered(source: &mut Source<'_>, extent: Extent) -> Contour {
    let count = source.count(3..=extent.vertices);
    (0..count).map(|_| point(source, extent.reach)).collect()
}

/// Vertices on corners, centres and middles of pixels: edges that touch, coincide, and end on others.
fn on_lattice(source: &mut Source<'_>, extent: Extent) -> Contour {
    let step = source.pick(&[256, 128, 64, 512]);
    let most = (extent.reach / step).clamp(1, 12);
    let count = source.count(3..=extent.vertices);
    (0..count)
        .map(|_| {
            let beside = if source.one_in(8) { source.int(-1..=1) } else { 0 };
            let (x, y) = point(source, most);
            (x * step + beside, y * step)
        })
        .collect()
}

fn on_circle(radius: i64, part: f64) -> At {
    let (sine, cosine) = (part * TAU).sin_cos();
    ((radius as f64 * cosine) as i64, (radius as f64 * sine) as i64)
}

/// Corners on a circle, every so manieth joined to the next: goes around several times.
fn star(source: &mut Source<'_>, extent: Extent) -> Contour {
    let count = source.count(3..=extent.vertices);
    let stride = source.count(1..=count - 1);
    let turned = source.int(0..=255) as f64 / 256.0;
    (0..count).map(|step| on_circle(extent.reach, turned + (step * stride % count) as f64 / count as f64)).collect()
}

/// Far and near in turn; tips sharp, flat, or with a loop.
fn spikes(source: &mut Source<'_>, extent: Extent) -> Contour {
    let count = source.count(2..=extent.vertices.div_ceil(2)) * 2;
    let inner = extent.reach * source.int(0..=15) / 16;
    let turned = source.int(0..=255) as f64 / 256.0;
    let half = if source.one_in(3) { source.int(-200..=200) } else { 0 };
    let mut contour = Vec::with_capacity(2 * count);
    for index in 0..count {
        let radius = if index % 2 == 0 { extent.reach } else { inner };
        let (x, y) = on_circle(radius, turned + index as f64 / count as f64);
        contour.push((x - half, y));
        if half != 0 && index % 2 == 0 {
            contour.push((x + half, y));
        }
    }
    contour
}

/// Teeth of a sub-pixel and wider, upright or on their side.
fn comb(source: &mut Source<'_>, extent: Extent) -> Contour {
    let teeth = source.int(1..=extent.vertices as i64 / 2);
    let pitch = source.int(1..=(2 * extent.reach / teeth).max(1));
    let shaken = source.pick(&[0, 0, 1, 60]);
    let mut contour = Vec::with_capacity(2 * teeth as usize + 3);
    for tooth in 0..=teeth {
        let x = tooth * pitch - extent.reach;
        contour.push((x, -extent.reach + source.int(0..=shaken)));
        if tooth < teeth {
            contour.push((x + source.int(0..=pitch), extent.reach / 2 - source.int(0..=shaken)));
        }
    }
    contour.extend([(teeth * pitch - extent.reach, extent.reach), (-extent.reach, extent.reach)]);
    turned(source, contour)
}

/// There in a zigzag and back in another: crossings in every row, and many within a pixel.
fn zigzag(source: &mut Source<'_>, extent: Extent) -> Contour {
    let half = source.int(1..=(extent.vertices as i64 / 2).max(2));
    let back = source.int(1..=half);
    let sway = source.int(1..=extent.reach);
    let side = |step: i64, of: i64| {
        let along = -extent.reach + 2 * extent.reach * step / of;
        (if step % 2 == 0 { -sway } else { sway }, along)
    };
    let shift = source.magnitude(8);
    let mut contour: Contour = (0..=half).map(|step| side(step, half)).collect();
    contour.extend((0..=back).rev().map(|step| side(step, back)).map(|(x, y)| (x + shift, y)));
    turned(source, contour)
}

/// Two long edges a sub-pixel apart, or a pixel, and perhaps a spike along one of them.
fn sliver(source: &mut Source<'_>, extent: Extent) -> Contour {
    let (a, b) = (point(source, extent.reach), point(source, extent.reach));
    let along = source.int(0..=256);
    let beside = |source: &mut Source<'_>| (source.magnitude(8), source.magnitude(8));
    let by = beside(source);
    let c = (a.0 + (b.0 - a.0) * along / 256 + by.0, a.1 + (b.1 - a.1) * along / 256 + by.1);
    let mut contour = vec![a, b, c];
    if source.one_in(2) {
        let by = beside(source);
        contour.extend([a, (b.0 + by.0, b.1 + by.1)]);
    }
    contour
}

/// A wide line along a path, out on one side and back on the other: overlaps itself at every corner.
fn stroked(source: &mut Source<'_>, extent: Extent) -> Contour {
    let count = source.count(2..=(extent.vertices / 2).max(2));
    let half = source.int(1..=(extent.reach / 3).max(1));
    let path: Contour = (0..count).map(|_| point(source, extent.reach)).collect();
    let mut contour = Vec::with_capacity(4 * count);
    let there = path.windows(2).map(|pair| (pair[0], pair[1]));
    let back = path.windows(2).rev().map(|pair| (pair[1], pair[0]));
    for (a, b) in there.chain(back) {
        let (dx, dy) = (b.0 - a.0, b.1 - a.1);
        let length = ((dx * dx + dy * dy) as f64).sqrt().max(1.0);
        let across = ((-dy * half) as f64 / length, (dx * half) as f64 / length);
        let beside = |p: At| (p.0 + across.0 as i64, p.1 + across.1 as i64);
        contour.extend([beside(a), beside(b)]);
    }
    contour
}

/// Edges from one far vertex past the origin to the next.
fn large(source: &mut Source<'_>, extent: Extent) -> Contour {
    let count = source.count(2..=(extent.vertices / 2).max(2));
    let bits = source.pick(&[22, 13, 16, 21, 24, 30, 31, 32]);
    let mut contour = Vec::with_capacity(2 * count);
    for _ in 0..count {
        let (dx, dy) = (source.magnitude(bits), source.magnitude(bits));
        let near = point(source, extent.reach);
        contour.extend([(near.0 - dx, near.1 - dy), (near.0 + dx, near.1 + dy)]);
    }
    contour
}

/// Every vertex of a magnitude of its own.
fn anywhere(source: &mut Source<'_>, extent: Extent) -> Contour {
    let count = source.count(3..=extent.vertices);
    (0..count).map(|_| (source.magnitude(32), source.magnitude(32))).collect()
}

/// Around each other, in either direction, sub-pixels apart or pixels.
fn nested(source: &mut Source<'_>, extent: Extent) -> Vec<Contour> {
    let rim = scattered(source, Extent { vertices: extent.vertices.min(8), ..extent });
    let step = source.int(0..=64);
    (0..source.int(2..=extent.contours.max(2) as i64))
        .map(|ring| {
            let share = 256 - step * ring;
            let mut contour: Contour = rim.iter().map(|(x, y)| (x * share / 256, y * share / 256)).collect();
            if source.one_in(2) {
                contour.reverse();
            }
            contour
        })
        .collect()
}

fn several(source: &mut Source<'_>, extent: Extent) -> Vec<Contour> {
    let kinds: [fn(&mut Source<'_>, Extent) -> Contour; 4] = [scattered, on_lattice, star, sliver];
    (0..source.count(2..=extent.contours.max(2)))
        .map(|_| source.pick(&kinds)(source, Extent { vertices: extent.vertices.min(6), ..extent }))
        .collect()
}

/// Many contours within a pixel or two.
fn crumbs(source: &mut Source<'_>, extent: Extent) -> Vec<Contour> {
    let middle = point(source, extent.reach);
    (0..source.count(2..=2 * extent.contours))
        .map(|_| {
            let from = point(source, 300);
            let count = source.count(3..=4);
            (0..count)
                .map(|_| {
                    let by = point(source, 120);
                    (middle.0 + from.0 + by.0, middle.1 + from.1 + by.1)
                })
                .collect()
        })
        .collect()
}

/// Vertices doubled, put level with or upon others, on edges between others; a contour twice, in either direction; an empty
/// one, and one far away.
fn disturb(source: &mut Source<'_>, contours: &mut Vec<Contour>) {
    let which = source.count(0..=contours.len() - 1);
    let contour = &mut contours[which];
    let at = source.count(0..=contour.len() - 1);
    let other = contour[source.count(0..=contour.len() - 1)];
    match source.int(0..=9) {
        0 => contour.insert(at, contour[at]),
        1 => contour[at].1 = other.1,
        2 => contour[at].0 = other.0,
        3 => contour[at] = other,
        4 => {
            let (a, share) = (contour[at], source.int(0..=16));
            contour.insert(at, (a.0 + (other.0 - a.0) * share / 16, a.1 + (other.1 - a.1) * share / 16));
        }
        5 => contour[at] = (source.magnitude(32), source.magnitude(32)),
        6 => contour.truncate(source.count(0..=2)),
        7 => contours.push(Vec::new()),
        8 => {
            let again = contour.clone();
            contours.push(again);
        }
        _ => {
            let mut again = contour.clone();
            again.reverse();
            contours.push(again);
        }
    }
}

fn turned(source: &mut Source<'_>, contour: Contour) -> Contour {
    if source.one_in(2) { contour.into_iter().map(|(x, y)| (y, x)).collect() } else { contour }
}
