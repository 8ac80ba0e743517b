//! Bad input: every method ends, inside its clip, whatever it is given.

use std::convert::Infallible;

use spanfill::{
    Fragment, FragmentSink, PixelRect,
    methods::{
        attribute::{
            Corner, affine_pieces::affine_pieces, average::flat, depth, gouraud_barycentric::gouraud_barycentric,
            gouraud_edge_walk::gouraud_edge_walk, gouraud_fixed, gouraud_planes::gouraud_planes,
            perspective::perspective, perspective_weights::perspective_weights,
        },
        number::{Fixed, Number, Real},
        triangle::{
            barycentric::{Step, barycentric},
            bounds::Bounds,
            dda_float::FloatDda,
            edge_equations::{Options, Test, edge_equations},
            edge_walk::{Spans, edge_walk},
            equation::Constant,
            orientation::Orientation,
            printed,
            three_edges::{edges_of, three_edges},
        },
    },
};

use crate::{
    oracle::{Rng, rect},
    scenes::{Corners, draw, picture},
    variants::{
        attribute::{ATTRIBUTES, Shaded},
        triangle::{INSIDE, SHARED, TRAVERSAL},
    },
};

const ENDS: [i32; 12] =
    [i32::MIN, i32::MIN + 1, -(1 << 30), -65536, -1, 0, 128, 5000, 1 << 20, 1 << 30, i32::MAX - 128, i32::MAX];

#[test]
fn the_ends_of_the_range_and_degenerate_triangles_end() {
    let clip = rect(10..31, 5..22);
    let mut picture = picture();
    for case in 0..60 {
        let mut rng = Rng::new(0xBAD, case);
        let mut v: Corners = [(); 3].map(|()| [rng.pick(&ENDS), rng.pick(&ENDS)]);
        match case % 5 {
            0 => v[2] = v[0],
            1 => v = [v[0]; 3],
            _ => {}
        }
        for variant in INSIDE.iter().chain(TRAVERSAL) {
            let _: Result<(), &str> = draw(variant, &v, &clip, &mut picture);
        }
        for variant in SHARED {
            draw(variant, [v, [v[0]; 3]].as_slice(), &clip, &mut picture).expect("nothing to refuse");
            draw(variant, [].as_slice(), &clip, &mut picture).expect("nothing to refuse");
        }
        let shape = Shaded {
            vertices: v,
            attributes: [[i32::MIN, i32::MAX, 0, 255], [i32::MAX, i32::MIN, -1, 0], [0, 0, 0, i32::MAX]],
            w: [rng.pick(&ENDS), 0, rng.pick(&[0, 1, -1, 65536])],
            depth: [0, u16::MAX, 1],
        };
        for variant in ATTRIBUTES {
            let _: Result<(), &str> = draw(variant, &shape, &clip, &mut picture);
        }
    }
}

/// Counts what leaves its clip.
struct Within {
    clip: PixelRect,
    outside: u32,
}

impl<const N: usize> FragmentSink<N> for Within {
    type Error = Infallible;

    fn fragment(&mut self, fragment: Fragment<N>) -> Result<(), Infallible> {
        let inside = self.clip.columns.contains(&fragment.x) && self.clip.rows.contains(&fragment.y);
        self.outside += u32::from(!inside);
        Ok(())
    }
}

fn all_options() -> Vec<Options> {
    let mut all = Vec::new();
    for constant in [Constant::CrossProduct, Constant::OneVertex, Constant::Averaged, Constant::Differences] {
        for orientation in [Orientation::SumOfCs, Orientation::Area, Orientation::ThirdVertex] {
            for bounds in [Bounds::Centres, Bounds::Outwards, Bounds::Inwards, Bounds::Table] {
                for test in [Test::Comparisons, Test::OrOfSigns] {
                    for bits in 0..8 {
                        let is_set = |bit: i32| bits & bit != 0;
                        let (at_centre, stepped, early_out) = (is_set(1), is_set(2), is_set(4));
                        all.push(Options { constant, orientation, bounds, at_centre, stepped, test, early_out });
                    }
                }
            }
        }
    }
    all
}

fn by_edge_equations<N: Number>(v: [[f64; 2]; 3], options: Options, sink: &mut Within) {
    let v = v.map(|vertex| vertex.map(N::Setup::from_f64));
    let clip = sink.clip.clone();
    // Refused or not.
    let _: Result<(), _> = edge_equations::<N, _>(&v, options, &clip, sink);
}

fn by_floats<R: Real + Number<Setup = R>>(v: [[f64; 2]; 3], sink: &mut Within) {
    let v = v.map(|vertex| vertex.map(R::from_f64));
    let clip = sink.clip.clone();
    for step in [
        Step::EveryPixel,
        Step::EveryPixelByColumns,
        Step::BoundingBox,
        Step::Incremental,
        Step::WithoutUpperBounds,
        Step::BetaPlusGamma,
    ] {
        let Ok(()) = barycentric(&v, step, &clip, sink);
    }
    let Ok(()) = three_edges(&edges_of(&v), &clip, sink);
    let Ok(()) = edge_walk::<FloatDda<R>, _>(&v, Spans::Closed, &clip, sink);
    let Ok(()) = edge_walk::<FloatDda<R>, _>(&v, Spans::HalfOpen, &clip, sink);
    let corner = |number: usize| Corner {
        x: v[number][0],
        y: v[number][1],
        w: v[2 - number][0],
        depth: u16::MAX,
        attributes: [i32::MAX, i32::MIN, 7],
    };
    let corners = [0, 1, 2].map(corner);
    let Ok(()) = flat(&corners, &clip, sink);
    let Ok(()) = gouraud_planes(&corners, &clip, sink);
    let Ok(()) = gouraud_barycentric(&corners, &clip, sink);
    let Ok(()) = gouraud_edge_walk(&corners, true, &clip, sink);
    let Ok(()) = gouraud_edge_walk(&corners, false, &clip, sink);
    let Ok(()) = perspective(&corners, &clip, sink);
    let Ok(()) = perspective_weights(&corners, &clip, sink);
    let Ok(()) = affine_pieces(&corners, &clip, sink);
    let Ok(()) = depth::depth(&corners, &clip, sink);
}

#[test]
fn not_a_number_and_infinities_end() {
    const VALUES: [f64; 10] =
        [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 0.0, -0.0, 1e300, -1e300, 1e-320, 12.5, 4_294_967_296.0];
    let options = all_options();
    for case in 0..400 {
        let mut rng = Rng::new(0x000F_10A7, case);
        let v = [(); 3].map(|()| [rng.pick(&VALUES), rng.pick(&VALUES)]);
        let mut sink = Within { clip: rect(-3..9, -2..10), outside: 0 };
        let clip = sink.clip.clone();
        for options in &options {
            by_edge_equations::<f32>(v, *options, &mut sink);
            by_edge_equations::<f64>(v, *options, &mut sink);
            by_edge_equations::<Fixed<i32, 12>>(v, *options, &mut sink);
            by_edge_equations::<Fixed<i64, 16>>(v, *options, &mut sink);
        }
        by_floats::<f32>(v, &mut sink);
        by_floats::<f64>(v, &mut sink);
        let corner = |number: usize| Corner {
            x: v[number][0],
            y: v[number][1],
            w: 1.0,
            depth: u16::MAX,
            attributes: [i32::MAX, i32::MIN, 7],
        };
        let corners = [0, 1, 2].map(corner);
        let Ok(()) = depth::depth_fixed::<12, 3, _>(&corners, &clip, &mut sink);
        for (half_added, at_centre) in [(false, false), (false, true), (true, false), (true, true)] {
            let rounding = gouraud_fixed::Rounding { half_added, at_centre };
            let _: Result<(), _> = gouraud_fixed::gouraud_fixed(&corners, rounding, &clip, &mut sink);
        }
        let _: Result<(), _> = printed::flat_tri_java(&v, &clip, &mut sink);
        let _: Result<(), _> = printed::flat_tri_csharp(&v, &clip, &mut sink);
        assert_eq!(sink.outside, 0, "{v:?}");
    }
}

/// A clip that is empty, runs backwards or lies at the end of the range.
#[test]
#[allow(clippy::reversed_empty_ranges, reason = "a clip may run backwards")]
fn any_clip_will_do() {
    let v: Corners = [[0, 0], [5000, 900], [700, 6000]];
    for clip in [rect(5..5, 0..9), rect(9..3, 0..9), rect(0..9, 7..2), rect(7..7, 7..7)] {
        let mut picture = picture();
        for variant in INSIDE.iter().chain(TRAVERSAL) {
            picture.count.fill(0);
            let _: Result<(), &str> = (variant.check)(&v, &clip, &mut picture);
            assert!(picture.count.iter().all(|count| *count == 0), "{}", crate::scenes::name(variant));
        }
    }
    let far: Corners = [[i32::MAX - 2000, i32::MAX - 2000], [i32::MAX, i32::MAX - 1000], [i32::MAX - 1500, i32::MAX]];
    for end in [i32::MAX, i32::MIN + 20] {
        let mut picture = picture();
        let clip = rect(end - 20..end, end - 20..end);
        for variant in INSIDE.iter().chain(TRAVERSAL) {
            let _: Result<(), &str> = (variant.check)(&far, &clip, &mut picture);
        }
    }
}
