//! Models of points: what is built encloses what it was built from, and what is broken is an error.

#[path = "../examples/splats/builder.rs"]
mod builder;
mod oracle;

use builder::{Point, build, normal_code};
use embedded_graphics::{
    Pixel,
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Point as Point2, Size},
    pixelcolor::{Rgb565, RgbColor as _},
    primitives::Rectangle,
};
use oracle::{Rng, cases, for_each_case};
use spanfill::{
    DepthBuffer, PixelRect, PixelRows,
    splat::{
        BrokenModel, CONE_SINES, Model, NORMAL_CODES, Node, Refinement, SPHERE_CODES, Sphere, Splat, SplatSink,
        Squares, View, normal,
    },
};

fn cloud(rng: &mut Rng, count: usize) -> Vec<Point> {
    (0..count)
        .map(|_| Point {
            at: [(); 3].map(|()| rng.int(-1 << 22..=1 << 22) as i32),
            radius: rng.int(1..=1 << 16) as i32,
            normal: rng.int(0..=i64::from(NORMAL_CODES) - 1) as u16,
            colour: Rgb565::new(rng.int(0..=31) as u8, rng.int(0..=63) as u8, rng.int(0..=31) as u8),
        })
        .collect()
}

fn view() -> View {
    let axes = [[16384, 0, 0], [0, 16384, 0], [0, 0, 16384]];
    View::new([0, 0, -(1 << 24)], axes, [160 * 256, 120 * 256], 300 * 256, 1 << 16).expect("a view")
}

const SCREEN: PixelRect = PixelRect { rows: 0..240, columns: 0..320 };

#[derive(Default)]
struct Record(Vec<Splat>);

impl SplatSink for Record {
    fn splat(&mut self, splat: &Splat) {
        self.0.push(*splat);
    }
}

#[test]
fn every_node_encloses_every_point_below_it() {
    for_each_case(0x5971, cases(300), |rng| {
        let count = rng.int(1..=400) as usize;
        let mut points = cloud(rng, count);
        let bytes = build(&mut points);
        let model = Model::new(&bytes).map_err(|error| error.to_string())?;
        model.check().map_err(|error| error.to_string())?;
        // By a reader of its own: down the groups, with the points of each node in the builder's order of leaves.
        let offset = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        let node = |at: usize| Node::from_bytes(bytes[at..at + 6].try_into().unwrap());
        let mut leaves = 0;
        let mut waiting = vec![(model.bounds(), node(24), offset(30))];
        let mut spheres: Vec<Sphere> = Vec::new();
        while let Some((sphere, parent, group)) = waiting.pop() {
            if parent.children == 0 {
                leaves += 1;
                spheres.push(sphere);
                continue;
            }
            let mut below = if parent.grandchildren { offset(group + 6 * parent.children as usize) } else { 0 };
            for index in 0..parent.children as usize {
                let child = node(group + 6 * index);
                waiting.push((sphere.child(child.sphere).ok_or("no sphere")?, child, below));
                if child.children > 0 {
                    below += 6 * child.children as usize + if child.grandchildren { 4 } else { 0 };
                }
            }
        }
        if leaves != points.len() {
            return Err(format!("{leaves} leaves of {}", points.len()));
        }
        // Each point lies in a leaf's sphere, to the units that rounding in 24 levels may lose.
        let enclosed = |point: &Point| {
            spheres.iter().any(|sphere| {
                let square: f64 = (0..3).map(|axis| f64::from(sphere.centre[axis] - point.at[axis]).powi(2)).sum();
                square.sqrt() + f64::from(point.radius) <= f64::from(sphere.radius) + 64.0
            })
        };
        match points.iter().find(|point| !enclosed(point)) {
            Some(point) => Err(format!("{:?} is in no leaf", point.at)),
            None => Ok(1),
        }
    });
}

#[test]
fn spheres_that_are_encoded_enclose_what_they_should() {
    for_each_case(0x5972, cases(20_000), |rng| {
        let outer = Sphere {
            centre: [(); 3].map(|()| rng.int(-1 << 20..=1 << 20) as i32),
            radius: rng.int(100..=1 << 20) as i32,
        };
        let radius = rng.int(0..=i64::from(outer.radius) * 9 / 10);
        // Within the cube around the middle that still holds the sphere.
        let reach = ((i64::from(outer.radius) - radius) as f64 / 3_f64.sqrt()) as i64 * 9 / 10;
        let centre = outer.centre.map(|middle| middle + rng.int(-reach..=reach) as i32);
        let inner = Sphere { centre, radius: radius as i32 };
        let code = outer.encode(&inner).ok_or(format!("no code for {inner:?} in {outer:?}"))?;
        let found = outer.child(code).ok_or("no sphere")?;
        let square: f64 = (0..3).map(|axis| f64::from(found.centre[axis] - inner.centre[axis]).powi(2)).sum();
        if square.sqrt() + f64::from(inner.radius) > f64::from(found.radius) {
            return Err(format!("{found:?} does not enclose {inner:?}"));
        }
        Ok(1)
    });
    let unit = Sphere { centre: [0; 3], radius: 1300 };
    assert!(unit.child(SPHERE_CODES).is_none() && unit.child(SPHERE_CODES - 1).is_some());
    assert_eq!(unit.child(SPHERE_CODES - 1), Some(unit));
}

#[test]
fn directions_are_spread_evenly_and_nearest() {
    let mut least = 1.0_f64;
    for_each_case(0x5973, cases(100_000), |rng| {
        let direction = [(); 3].map(|()| rng.int(-1000..=1000) as f64);
        let length = direction.iter().map(|part| part * part).sum::<f64>().sqrt();
        if length == 0.0 {
            return Ok(0);
        }
        let found = normal(normal_code(direction)).ok_or("no direction")?.map(f64::from);
        let cosine = (0..3).map(|axis| found[axis] * direction[axis]).sum::<f64>() / 16384.0 / length;
        // Half the diagonal of 90/52 degrees, 1.22, and a little more where a side is stretched.
        if cosine < (1.45_f64).to_radians().cos() { Err(format!("{direction:?} became {found:?}")) } else { Ok(1) }
    });
    for code in 0..NORMAL_CODES {
        let [x, y, z] = normal(code).expect("a code").map(f64::from);
        least = least.min((x * x + y * y + z * z).sqrt() / 16384.0);
        assert_eq!(normal_code([x, y, z]), code, "{x} {y} {z}");
    }
    assert!(least > 0.9999, "{least}");
    assert_eq!(normal(NORMAL_CODES), None);
    assert_eq!(CONE_SINES, [1, 4, 9, 16]);
}

#[test]
fn nodes_are_what_they_were() {
    for_each_case(0x5974, cases(20_000), |rng| {
        let bytes: [u8; 6] = std::array::from_fn(|_| rng.bits() as u8);
        if Node::from_bytes(bytes).to_bytes() == bytes { Ok(1) } else { Err(format!("{bytes:?}")) }
    });
}

#[test]
fn budgets_and_thresholds_hold() {
    let mut rng = Rng::new(0x5975, 0);
    let bytes = build(&mut cloud(&mut rng, 20_000));
    let model = Model::new(&bytes).unwrap();
    let mut all = Record::default();
    let everything = Refinement { threshold: 0, budget: u32::MAX };
    let drawn = model.draw(&view(), &SCREEN, everything, &mut all).unwrap();
    assert_eq!(drawn as usize, all.0.len());
    assert!(drawn > 5_000, "half of all directions face the eye: {drawn}");
    for budget in [0, 1, 10, 100, 1000, 5000] {
        let (threshold, expected) = model.threshold_for(&view(), &SCREEN, budget).unwrap();
        let mut some = Record::default();
        let drawn = model.draw(&view(), &SCREEN, Refinement { threshold, budget }, &mut some).unwrap();
        assert!(drawn <= budget && drawn == expected && drawn as usize == some.0.len());
        let finer = threshold.saturating_sub(32);
        if threshold > 0 && threshold < 64 * 256 {
            let more = Refinement { threshold: finer, budget: u32::MAX };
            assert!(model.draw(&view(), &SCREEN, more, &mut Record::default()).unwrap() > budget);
        }
    }
}

/// Pixels and depths of their own, around which nothing may be drawn.
struct Screen(Vec<Rgb565>);

impl OriginDimensions for Screen {
    fn size(&self) -> Size {
        Size::new(32, 24)
    }
}

impl DrawTarget for Screen {
    type Color = Rgb565;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(Point2 { x, y }, colour) in pixels {
            *self.row_from(Point2::new(x, y)).expect("nothing is sent outside").first_mut().expect("a pixel") = colour;
        }
        Ok(())
    }
}

impl PixelRows for Screen {
    fn row_from(&mut self, start: Point2) -> Option<&mut [Rgb565]> {
        let (x, y) = (usize::try_from(start.x).ok()?, usize::try_from(start.y).ok()?);
        self.0.chunks_mut(32).nth(y)?.get_mut(x..).filter(|row| !row.is_empty())
    }
}

/// Looks at every node of a model that may be broken, and draws it, finely and roughly: within the budget, on the screen and
/// nowhere else, or an error. Whether it is whole.
fn survives(bytes: &[u8]) -> bool {
    let Ok(model) = Model::new(bytes) else { return false };
    let whole = model.check();
    let axes = [[16384, 0, 0], [0, 16384, 0], [0, 0, 16384]];
    let view = View::new([0, 0, -(1 << 24)], axes, [16 * 256, 12 * 256], 40 * 256, 1 << 16).expect("a view");
    let screen = PixelRect { rows: 0..24, columns: 0..32 };
    for threshold in [0, 256] {
        let refinement = Refinement { threshold, budget: 999 };
        let mut splats = Record::default();
        let drawn = model.draw(&view, &screen, refinement, &mut splats);
        assert!(splats.0.len() <= 999 && drawn.is_err() | (drawn == Ok(splats.0.len() as u32)));
        let (mut target, mut memory) = (Screen(vec![Rgb565::BLACK; 32 * 24]), vec![u16::MAX; 32 * 24]);
        let area = Rectangle::new(Point2::zero(), Size::new(32, 24));
        let mut depths = DepthBuffer::new(area, 32, &mut memory).expect("large enough");
        let on_screen =
            model.draw(&view, &screen, refinement, &mut Squares::new(&mut target, &mut depths, |s| s.colour));
        assert_eq!(drawn, on_screen);
        // A model that is whole is drawn.
        assert!(whole.is_err() || drawn.is_ok());
    }
    whole.is_ok()
}

/// Where the offsets of a model are: of the root's group, then those of groups with grandchildren; and the groups themselves.
fn offsets_and_groups(bytes: &[u8]) -> (Vec<usize>, Vec<usize>) {
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
    let node = |at: usize| Node::from_bytes(bytes[at..at + 6].try_into().unwrap());
    let (mut offsets, mut groups, mut waiting) = (vec![30], Vec::new(), vec![(node(24), word(30))]);
    while let Some((parent, group)) = waiting.pop() {
        groups.push(group);
        if !parent.grandchildren {
            continue;
        }
        let at = group + 6 * parent.children as usize;
        offsets.push(at);
        let mut below = word(at);
        for child in (0..parent.children as usize).map(|index| node(group + 6 * index)) {
            if child.children > 0 {
                waiting.push((child, below));
                below += 6 * child.children as usize + if child.grandchildren { 4 } else { 0 };
            }
        }
    }
    (offsets, groups)
}

#[test]
fn every_truncation_is_an_error() {
    for count in [2, 3, 5, 40, 150] {
        let bytes = build(&mut cloud(&mut Rng::new(0x5978, count), count as usize));
        assert!(survives(&bytes));
        for length in 0..bytes.len() {
            assert!(!survives(&bytes[..length]), "{length} of {} bytes", bytes.len());
        }
    }
}

/// A byte that is another is an error, or a sphere, normal or colour that there is: never more nodes, never fewer.
#[test]
fn every_byte_may_be_any_other() {
    let bytes = build(&mut cloud(&mut Rng::new(0x5979, 0), 24));
    let (mut broken, mut others) = (0, 0);
    for at in 0..bytes.len() {
        for change in 1..=255 {
            let mut changed = bytes.clone();
            changed[at] ^= change;
            if survives(&changed) {
                others += 1
            } else {
                broken += 1
            }
            // What a model begins with, and how many nodes it has, may not be anything else.
            assert!(at >= 8 || !survives(&changed), "byte {at}");
        }
    }
    println!("{broken} are errors, {others} another model");
    assert!(broken > 10_000 && others > 10_000);
}

/// Every offset to every group at or before its own: all ways to go in a circle.
#[test]
fn offsets_that_go_in_a_circle_are_errors() {
    let bytes = build(&mut cloud(&mut Rng::new(0x597A, 0), 200));
    let (offsets, groups) = offsets_and_groups(&bytes);
    assert!(offsets.len() > 20 && groups.len() > 60);
    for at in offsets.iter().copied().filter(|at| *at > 30) {
        for group in groups.iter().copied().chain([0, 24, at]).filter(|group| *group < at + 4) {
            let mut circle = bytes.clone();
            circle[at..at + 4].copy_from_slice(&(group as u32).to_le_bytes());
            assert_eq!(Model::new(&circle).unwrap().check(), Err(BrokenModel::Backwards { offset: group }));
            assert!(!survives(&circle));
        }
    }
    // The root's group cannot be within the header.
    for group in 0..34 {
        let mut circle = bytes.clone();
        circle[30..34].copy_from_slice(&(group as u32).to_le_bytes());
        assert_eq!(Model::new(&circle).err(), Some(BrokenModel::Backwards { offset: group }));
    }
}

#[test]
fn more_nodes_or_fewer_are_errors() {
    let bytes = build(&mut cloud(&mut Rng::new(0x597B, 0), 300));
    let nodes = u32::from_le_bytes(bytes[4..8].try_into().unwrap());
    let with = |nodes: u32| [&bytes[..4], &nodes.to_le_bytes(), &bytes[8..]].concat();
    for (wrong, error) in [
        (nodes - 1, BrokenModel::TooManyNodes),
        (0, BrokenModel::TooManyNodes),
        (nodes + 1, BrokenModel::TooFewNodes { missing: 1 }),
        (u32::MAX, BrokenModel::TooFewNodes { missing: u32::MAX - nodes }),
    ] {
        assert_eq!(Model::new(&with(wrong)).unwrap().check(), Err(error));
    }
}

#[test]
fn many_wrong_bytes_end() {
    let bytes = build(&mut cloud(&mut Rng::new(0x5976, 0), 3_000));
    assert_eq!(Model::new(&bytes[..33]).err(), Some(BrokenModel::NoHeader));
    assert!(matches!(Model::new(&bytes[..1000]).unwrap().check(), Err(BrokenModel::Ends { .. })));
    for_each_case(0x5977, cases(5_000), |rng| {
        let mut broken = bytes.clone();
        for _ in 0..rng.int(1..=6) {
            let at = if rng.one_in(2) { rng.index(200) } else { rng.index(broken.len()) };
            broken[at] = rng.bits() as u8;
        }
        if rng.one_in(4) {
            broken.truncate(rng.index(broken.len()));
        }
        // No more nodes are looked at than a whole model has, unless the header lies about it.
        if Model::new(&broken).is_ok_and(|model| model.nodes() < 1 << 16) {
            survives(&broken);
        }
        Ok(1)
    });
}

#[test]
fn views_that_see_nothing_are_refused() {
    let axes = [[16384, 0, 0], [0, 16384, 0], [0, 0, 16384]];
    for (axes, focal, near) in [(axes, 0, 1), (axes, 1, 0), ([[16385, 0, 0]; 3], 1, 1), (axes, (1 << 20) + 1, 1)] {
        assert!(View::new([0; 3], axes, [0; 2], focal, near).is_err());
    }
}
