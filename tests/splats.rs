//! Models of points: what is built encloses what it was built from, and what is broken is an error.

#[path = "../examples/splats/builder.rs"]
mod builder;
mod oracle;

use builder::{Point, build, normal_code};
use embedded_graphics::pixelcolor::Rgb565;
use oracle::{Rng, cases, for_each_case};
use spanfill::{
    PixelRect,
    splat::{
        BrokenModel, CONE_SINES, Model, NORMAL_CODES, Node, Refinement, SPHERE_CODES, Sphere, Splat, SplatSink, View,
        normal,
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

#[test]
fn broken_models_are_errors_and_end() {
    let mut rng = Rng::new(0x5976, 0);
    let bytes = build(&mut cloud(&mut rng, 3_000));
    assert_eq!(Model::new(&bytes[..33]).err(), Some(BrokenModel::NoHeader));
    assert!(matches!(Model::new(&bytes[..1000]).unwrap().check(), Err(BrokenModel::Ends { .. })));
    // A group that leads to itself.
    let mut circle = bytes.clone();
    circle[58..62].copy_from_slice(&34_u32.to_le_bytes());
    assert_eq!(Model::new(&circle).unwrap().check(), Err(BrokenModel::Backwards { offset: 34 }));
    // Two groups that lead to one below: forwards, but twice.
    let mut twice = bytes.clone();
    let third = u32::from_le_bytes(bytes[58..62].try_into().unwrap()) as usize;
    let shared: [u8; 4] = twice[third + 24..third + 28].try_into().unwrap();
    twice[third + 28 + 24..third + 28 + 28].copy_from_slice(&shared);
    let _ = Model::new(&twice).unwrap().check();
    for_each_case(0x5977, cases(20_000), |rng| {
        let mut broken = bytes.clone();
        for _ in 0..rng.int(1..=6) {
            let at = if rng.one_in(2) { rng.index(200) } else { rng.index(broken.len()) };
            broken[at] = rng.bits() as u8;
        }
        if rng.one_in(4) {
            broken.truncate(rng.index(broken.len()));
        }
        if let Ok(model) = Model::new(&broken) {
            // No more nodes are looked at than a whole model has, unless the header lies about it.
            if model.nodes() < 1 << 16 {
                let _ = model.check();
                let _ =
                    model.draw(&view(), &SCREEN, Refinement { threshold: 64, budget: 9999 }, &mut Record::default());
            }
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
