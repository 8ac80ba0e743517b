//! Fixed triangles of several kinds, what the rule says of their pixels, and what a method makes of them.

mod pictures;

pub(crate) use pictures::picture;
use spanfill::PixelRect;

use crate::{
    oracle::{
        Rng,
        rule::{At, centre, cross, side},
    },
    variants::{Outcome, Picture, SCREEN, Variant, WIDTH},
};

pub(crate) type Corners = [[i32; 2]; 3];

/// What the rule says of a pixel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Truth {
    Outside,
    Inside,
    /// On the outline, the neighbour's.
    TieOutside,
    /// On the outline, the triangle's own.
    TieInside,
}

pub(crate) fn truth(v: &Corners, x: i32, y: i32) -> Truth {
    let [a, b, c] = v.map(|[x, y]| At { x: x.into(), y: y.into() });
    let p = centre(x, y);
    let area = cross(a, b, c).signum();
    let edges = [(a, b), (b, c), (c, a)];
    let signs = edges.map(|(from, to)| cross(from, to, p).signum() * area);
    if area == 0 || signs.contains(&-1) {
        return Truth::Outside;
    }
    if !signs.contains(&0) {
        return Truth::Inside;
    }
    let owns = edges.iter().all(|(from, to)| i128::from(side(*from, *to, p)) == area);
    if owns { Truth::TieInside } else { Truth::TieOutside }
}

/// Wipes the rows that a clip has, and one around them.
pub(crate) fn wipe(picture: &mut Picture, clip: &PixelRect) {
    let rows = (clip.rows.start - 1).max(SCREEN.rows.start)..(clip.rows.end + 1).min(SCREEN.rows.end);
    let pixels = index(0, rows.start)..index(0, rows.end);
    picture.count[pixels].fill(0);
    (picture.visited, picture.outside) = (0, 0);
}

pub(crate) fn index(x: i32, y: i32) -> usize {
    usize::try_from(y * WIDTH + x).unwrap()
}

/// Draws, and checks that nothing leaves the clip, as far as one pixel around it and the screen's edge can tell, and
/// that nothing is drawn by what refuses.
pub(crate) fn draw<S: ?Sized>(variant: &Variant<S>, shape: &S, clip: &PixelRect, picture: &mut Picture) -> Outcome {
    wipe(picture, clip);
    let outcome = (variant.check)(shape, clip, picture);
    let name = name(variant);
    assert_eq!(picture.outside, 0, "{name} left the screen");
    let around = [clip.rows.start - 1, clip.rows.end];
    for y in around.into_iter().filter(|y| SCREEN.rows.contains(y)) {
        assert!(picture.count[index(0, y)..index(0, y + 1)].iter().all(|count| *count == 0), "{name} left its rows");
    }
    for y in clip.rows.clone() {
        let row = &picture.count[index(0, y)..index(0, y + 1)];
        let columns = usize::try_from(clip.columns.start).unwrap()..usize::try_from(clip.columns.end).unwrap();
        let sides = row[..columns.start].iter().chain(&row[columns.end..]);
        assert!(sides.into_iter().all(|count| *count == 0), "{name} left its columns");
        assert!(outcome.is_ok() || row.iter().all(|count| *count == 0), "{name} refused and drew");
    }
    outcome
}

pub(crate) fn name<S: ?Sized>(variant: &Variant<S>) -> String {
    format!("{}, {}", variant.method, variant.option)
}

type Make = fn(&mut Rng) -> Corners;

/// Kinds of triangles, by name; each is the same on every machine.
pub(crate) const SCENES: [(&str, Make); 6] = [
    ("typical", |rng| corners(rng, 0, 320, 0, 240, 1)),
    ("half pixels", |rng| corners(rng, 20, 100, 20, 100, 128)),
    ("small", |rng| {
        let (x, y) = (rng.int(4..=310) as i32, rng.int(4..=230) as i32);
        corners(rng, x - 4, x + 4, y - 4, y + 4, 1)
    }),
    ("slivers", |rng| {
        let [[x0, y0], [x1, y1], _] = corners(rng, 0, 320, 0, 240, 1);
        let part = rng.int(0..=256) as i32;
        let near = |from: i32, to: i32, off: i64| from + ((to - from) / 256) * part + off as i32;
        [[x0, y0], [x1, y1], [near(x0, x1, rng.int(-2..=2)), near(y0, y1, rng.int(-2..=2))]]
    }),
    ("off-screen", |rng| corners(rng, -2000, 2320, -2000, 2240, 1)),
    ("one x", |rng| {
        let [[x, y0], [_, y1], [_, y2]] = corners(rng, 0, 320, 0, 240, 1);
        [[x, y0], [x, y1], [x, y2]]
    }),
];

fn corners(rng: &mut Rng, left: i32, right: i32, top: i32, bottom: i32, step: i32) -> Corners {
    let mut coordinate = |low: i32, high: i32| {
        let parts = 256 / step;
        rng.int(i64::from(low * parts)..=i64::from(high * parts)) as i32 * step
    };
    [(); 3].map(|()| [coordinate(left, right), coordinate(top, bottom)])
}

/// The first triangles of a scene.
pub(crate) fn triangles(scene: usize, count: u64) -> Vec<Corners> {
    (0..count).map(|case| SCENES[scene].1(&mut Rng::new(0x7216_0000 + scene as u64, case))).collect()
}
