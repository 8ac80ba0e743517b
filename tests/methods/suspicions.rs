//! Where the notes' code looks wrong: what is, and what only looks so.

use std::convert::Infallible;

use spanfill::{
    Fragment, FragmentSink, PixelRect,
    methods::{
        number::Fixed,
        triangle::{
            Failure,
            backtrack::backtrack,
            blocks::blocks,
            bounds::Bounds,
            dda_exact::ExactDda,
            edge_equations::{Options, edge_equations},
            edge_walk::{Spans, edge_walk},
            equation::{Constant, EdgeEqn},
            every_pixel::every_pixel,
            micropolygons::{Middles, micropolygons},
            midpoint_outline::midpoint_outline,
            orientation::Orientation,
            printed::{flat_tri_csharp, flat_tri_java},
            tie_break::{Axis, tie_break},
            warnock::warnock,
        },
    },
};

use crate::{
    oracle::{Rng, rect},
    scenes::{self, Truth},
};

/// The pixels in the order they come.
#[derive(Debug, Default)]
struct Pixels {
    drawn: Vec<(i32, i32)>,
    visited: usize,
}

impl FragmentSink for Pixels {
    type Error = Infallible;

    fn fragment(&mut self, fragment: Fragment) -> Result<(), Infallible> {
        self.drawn.push((fragment.x, fragment.y));
        Ok(())
    }

    fn visit(&mut self, _: i32, _: i32) {
        self.visited += 1;
    }
}

fn pixels(v: &[[f64; 2]; 3], options: Options, clip: &PixelRect) -> Pixels {
    let mut pixels = Pixels::default();
    edge_equations::<f64, _>(v, options, clip, &mut pixels).expect("nothing to refuse");
    pixels
}

/// All x equal: no area, but the sum of three C's that were truncated one by one need not be 0, and then the table is
/// asked for entry 6 of 0 to 5. With doubles and vertices in 1/256 px the sum is 0 and the triangle is gone before.
#[test]
fn the_table_has_no_entry_where_all_x_are_equal() {
    let (mut thrown, mut thrown_in_doubles, mut thrown_in_tenths) = (0, 0, 0);
    for case in 0..1000 {
        let mut rng = Rng::new(0x006E_7247, case);
        let mut coordinate = |unit: f64| rng.int(0..=25600) as f64 / unit;
        let x = coordinate(256.0);
        let v = [(); 3].map(|()| [x, coordinate(256.0)]);
        let mut sink = Pixels::default();
        match flat_tri_java(&v, &rect(0..100, 0..100), &mut sink) {
            Err(Failure::NoEntry { index }) => {
                assert_eq!((index, sink.visited), (6, 0));
                thrown += 1;
            }
            result => assert_eq!((result, sink.visited), (Ok(()), 0)),
        }
        thrown_in_doubles += u32::from(flat_tri_csharp(&v, &rect(0..100, 0..100), &mut sink).is_err());
        let x = coordinate(10.0);
        let v = [(); 3].map(|()| [x, coordinate(10.0)]);
        thrown_in_tenths += u32::from(flat_tri_csharp(&v, &rect(0..100, 0..100), &mut sink).is_err());
    }
    assert_eq!((thrown, thrown_in_doubles, thrown_in_tenths), (404, 0, 515), "of 1000");
}

/// What only looks wrong: the table's other six entries are right for every order of the vertices, equal ones included.
#[test]
fn the_table_is_right_where_two_are_equal() {
    for order in 0..729_usize {
        let digit = |place: usize| (order / 3_usize.pow(place as u32) % 3) as f64 * 7.0;
        let v = [[digit(0), digit(1)], [digit(2), digit(3)], [digit(4), digit(5)]];
        let clip = rect(0..20, 0..20);
        let mut sink = Pixels::default();
        let table = Options { bounds: Bounds::Table, ..Options::USUAL };
        let result = edge_equations::<f64, _>(&v, table, &clip, &mut sink);
        assert_eq!(result, Ok(()), "{v:?}");
        let outwards = pixels(&v, Options { bounds: Bounds::Outwards, ..Options::USUAL }, &clip);
        assert_eq!((sink.drawn, sink.visited), (outwards.drawn, outwards.visited), "{v:?}");
    }
}

/// `(int)` goes towards zero: left of the origin a box starts a pixel late. A clip from 0 on hides it.
#[test]
fn truncation_loses_a_column_left_of_the_origin() {
    let v = [[-3.75, 0.25], [-0.25, 0.25], [-3.75, 8.0]];
    let (whole, screen) = (rect(-8..8, 0..8), rect(0..8, 0..8));
    let drawn = |bounds, clip| pixels(&v, Options { bounds, ..Options::USUAL }, clip).drawn;
    let (right, outwards, inwards) =
        (drawn(Bounds::Centres, &whole), drawn(Bounds::Outwards, &whole), drawn(Bounds::Inwards, &whole));
    assert_eq!(right.iter().map(|(x, _)| *x).min(), Some(-4));
    assert_eq!(outwards.iter().map(|(x, _)| *x).min(), Some(-3));
    assert_eq!(inwards, outwards);
    assert_eq!(right.len() - outwards.len(), 7);
    for bounds in [Bounds::Centres, Bounds::Outwards, Bounds::Inwards] {
        let across = [[-3.75, 0.25], [5.5, 0.25], [-3.75, 8.0]];
        let drawn = |bounds| pixels(&across, Options { bounds, ..Options::USUAL }, &screen).drawn;
        assert_eq!(drawn(bounds), drawn(Bounds::Centres));
    }
}

/// `(int) (min + .5)` leaves out a column whose centres are on the outline, `(int) (max - .5)` takes one in.
#[test]
fn a_box_that_is_rounded_inwards_decides_ties() {
    let v = [[2.5, 2.5], [6.5, 2.5], [6.5, 6.5]];
    let clip = rect(0..9, 0..9);
    let inwards = pixels(&v, Options { bounds: Bounds::Inwards, ..Options::USUAL }, &clip).drawn;
    let centres = pixels(&v, Options::USUAL, &clip).drawn;
    let extent = |pixels: &[(i32, i32)], of: fn(&(i32, i32)) -> i32| {
        (pixels.iter().map(of).min().unwrap(), pixels.iter().map(of).max().unwrap())
    };
    assert_eq!((extent(&centres, |p| p.0), extent(&centres, |p| p.1)), ((2, 6), (2, 6)));
    assert_eq!((extent(&inwards, |p| p.0), extent(&inwards, |p| p.1)), ((3, 6), (3, 6)));
}

/// `(int) min` to `(int) (max + 1)` looks at up to two columns and rows more than have a centre inside.
#[test]
fn the_outward_box_is_two_pixels_too_large_at_most() {
    let v = [[2.75, 2.75], [5.25, 2.75], [2.75, 5.25]];
    let clip = rect(0..9, 0..9);
    let visited = |bounds| pixels(&v, Options { bounds, ..Options::USUAL }, &clip).visited;
    assert_eq!(visited(Bounds::Centres), 2 * 2);
    // Columns 2 to 6: of 3 and 4 the centre is inside.
    assert_eq!(visited(Bounds::Outwards), 5 * 5);
    assert_eq!(visited(Bounds::Inwards), 2 * 2);
}

/// 12 fraction bits: C leaves 32 bits from products of 2^19 square pixels on, and `(int)` saturates it.
#[test]
fn twelve_bits_leave_32_at_1024_px() {
    let c = |size: f64| {
        let edge = EdgeEqn::<Fixed<i32, 12>>::new([size, 0.0], [0.0, size], Constant::CrossProduct);
        f64::from(edge.c.0) / 4096.0
    };
    for power in 1..=9 {
        let size = f64::from(1 << power);
        assert_eq!(c(size), size * size);
    }
    // 724.07 = sqrt(2^19).
    assert_eq!(c(724.0), 724.0 * 724.0);
    assert_eq!(c(1024.0), f64::from(i32::MAX) / 4096.0);
    // What that draws: the diagonal of a square of 1024 px has moved inwards to where x + y is 512.
    let clip = rect(0..1024, 0..1024);
    let v = [[0.0, 0.0], [1024.0, 0.0], [0.0, 1024.0]];
    let options = Options { orientation: Orientation::Area, ..Options::USUAL };
    let mut sink = Pixels::default();
    edge_equations::<Fixed<i32, 12>, _>(&v, options, &clip, &mut sink).expect("nothing to refuse");
    let furthest = sink.drawn.iter().map(|(x, y)| x + y + 1).max();
    assert_eq!(furthest, Some(511));
}

/// Wrapping on the way does no harm: `A x + B y + C` is right modulo 2^32 as long as C is and the value fits.
#[test]
fn sums_may_wrap_as_long_as_the_value_fits() {
    let edge = EdgeEqn::<Fixed<i32, 12>>::new([600.0, 0.0], [0.0, 600.0], Constant::Averaged);
    let (x, y) = (900, 900);
    let partial = i64::from(edge.a.0) * i64::from(x);
    assert!(i32::try_from(partial).is_err());
    // e = y0 (x1 - x) ... = 600 (600 - x - y) px^2, of which 31 - 12 bits are left.
    let value = f64::from(edge.evaluate(x, y, false).0) / 4096.0;
    let expected = 600.0 * (600.0 - 1800.0);
    let modulus = f64::from(1 << 20);
    assert_eq!((value - expected).rem_euclid(modulus), 0.0);
    let near =
        EdgeEqn::<Fixed<i32, 12>>::new([600.0, 0.0], [0.0, 600.0], Constant::Averaged).evaluate(900, -800, false);
    assert_eq!(f64::from(near.0) / 4096.0, 600.0 * 500.0);
}

/// Fails when it has had enough.
struct Limited(u32);

impl FragmentSink for Limited {
    type Error = &'static str;

    fn fragment(&mut self, _: Fragment) -> Result<(), &'static str> {
        self.0 = self.0.checked_sub(1).ok_or("full")?;
        Ok(())
    }
}

/// A sink that fails ends the walk, and its error arrives.
#[test]
fn the_sinks_error_arrives() {
    let v = [[256, 256], [9000, 700], [3000, 9000]];
    let clip = rect(0..40, 0..40);
    let failures = [
        every_pixel(&v, &clip, &mut Limited(7)),
        backtrack(&v, &clip, &mut Limited(7)),
        blocks(&v, &clip, &mut Limited(7)),
        warnock(&v, &clip, &mut Limited(7)),
        midpoint_outline(&v, &clip, &mut Limited(7)),
        edge_walk::<ExactDda, _>(&v, Spans::HalfOpen, &clip, &mut Limited(7)),
        tie_break(&v, Axis::Up, &clip, &mut Limited(7)),
    ];
    assert_eq!(failures, [Err("full"); 7]);
    let pieces = micropolygons(&v, Middles::Exact, &clip, &mut Limited(7));
    assert_eq!(pieces, Err(Failure::Sink("full")));
    // What is refused is refused before a fragment comes.
    let long = [[0, 0], [1 << 22, 0], [0, 900]];
    assert_eq!(micropolygons(&long, Middles::Exact, &clip, &mut Limited(0)), Err(Failure::TooLong));
}

/// Samples at integer coordinates: every pixel is that of a triangle half a pixel to the lower right, at centres.
#[test]
fn integer_samples_move_the_triangle_by_half_a_pixel() {
    for case in 0..50 {
        let mut rng = Rng::new(0x1A7, case);
        let v = [(); 3].map(|()| [(); 2].map(|()| rng.int(256..=9000) as i32));
        let moved = v.map(|vertex| vertex.map(|value| value + 128));
        let clip = rect(0..40, 0..40);
        let options = Options { at_centre: false, bounds: Bounds::Outwards, ..Options::USUAL };
        let drawn = pixels(&v.map(|vertex| vertex.map(|value| f64::from(value) / 256.0)), options, &clip).drawn;
        for y in clip.rows.clone() {
            for x in clip.columns.clone() {
                let expected = scenes::truth(&moved, x, y) != Truth::Outside;
                assert_eq!(drawn.contains(&(x, y)), expected, "({x}, {y}) of {v:?}");
            }
        }
    }
}
