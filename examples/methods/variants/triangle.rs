//! The variants of the triangle families: shapes are vertices in 1/256 px, and meshes of such triangles.
//!
//! Each variant converts to its own numbers. What floats make of vertices in 1/256 px is exact up to 2^16 px (f32); what
//! F = 4 makes of them is rounded to the nearest 1/16 px.

use core::convert::Infallible;

use spanfill::{
    Fragment, FragmentSink, PixelRect, Shape, Span, SpanSink, Triangle, Vertex,
    methods::{
        number::{Fixed, Real, Word},
        triangle::{
            Failure,
            backtrack::backtrack,
            barycentric::{Step, barycentric},
            blocks::blocks,
            bounding_box::bounding_box,
            bounds::Bounds,
            dda_exact::ExactDda,
            dda_fixed::FixedDda,
            dda_float::FloatDda,
            edge_equations::{Options, Test, edge_equations},
            edge_walk::{Spans, edge_walk},
            equation::Constant,
            every_pixel::every_pixel,
            micropolygons::{Middles, micropolygons},
            midpoint_outline::midpoint_outline,
            orientation::Orientation,
            printed,
            reference_point::reference_point,
            snapped::snapped,
            three_edges::{edges_of, three_edges},
            tie_break::{Axis, tie_break},
            untied::{Boundary, untied},
            warnock::{warnock, warnock_in_box},
        },
    },
};

use super::Outcome;

/// A triangle: three vertices in 1/256 px.
pub type Corners = [[i32; 2]; 3];

/// Vertices in pixels.
fn real<R: Real>(v: &Corners) -> [[R; 2]; 3] {
    v.map(|vertex| vertex.map(R::from_subpixels))
}

/// Vertices with `F` fraction bits; wraps.
fn snap<W: Word, const F: u32>(v: &Corners) -> [[W; 2]; 3] {
    v.map(|vertex| {
        vertex.map(|value| match F.checked_sub(8) {
            Some(more) => W::from_integer(value).shifted_left(more),
            None => W::from_integer(value.wrapping_add(1 << (7 - F)) >> (8 - F)),
        })
    })
}

/// What a method that cannot refuse answers.
pub(super) fn done(result: Result<(), Infallible>) -> Outcome {
    let Ok(()) = result;
    Ok(())
}

/// What one answers that can.
pub(super) fn outcome(result: Result<(), Failure<Infallible>>) -> Outcome {
    result.map_err(|failure| match failure {
        Failure::NoEntry { .. } => "the six-entry table has no such entry",
        Failure::TooLong => "longer than 2^13 px",
        Failure::Sink(never) => match never {},
    })
}

/// The shipped triangle's spans, pixel by pixel.
struct Pixels<'s, S>(&'s mut S);

impl<S: FragmentSink<Error = Infallible>> SpanSink for Pixels<'_, S> {
    type Error = Infallible;

    #[inline(always)]
    fn span(&mut self, Span { row, columns }: Span) -> Result<(), Infallible> {
        for x in columns {
            self.0.visit(x, row);
            self.0.fragment(Fragment::pixel(x, row))?;
        }
        Ok(())
    }
}

fn shipped(v: &Corners, clip: &PixelRect, sink: &mut impl FragmentSink<Error = Infallible>) -> Outcome {
    let triangle = Triangle::from_vertices(v.map(|[x, y]| Vertex::from_bits(x, y)));
    done(triangle.spans(clip, &mut Pixels(sink)))
}

const USUAL: Options = Options::USUAL;

crate::variants! { INSIDE: Corners;
    "triangle: inside test", "midpoint outline, filled", "" => |v, clip, sink| done(midpoint_outline(v, clip, sink));
    "triangle: inside test", "barycentric", "every pixel, rows first" => |v, clip, sink|
        done(barycentric(&real::<f32>(v), Step::EveryPixel, clip, sink));
    "triangle: inside test", "barycentric", "every pixel, columns first" => |v, clip, sink|
        done(barycentric(&real::<f32>(v), Step::EveryPixelByColumns, clip, sink));
    "triangle: inside test", "barycentric", "bounding box" => |v, clip, sink|
        done(barycentric(&real::<f32>(v), Step::BoundingBox, clip, sink));
    "triangle: inside test", "barycentric", "bounding box, f64" => |v, clip, sink|
        done(barycentric(&real::<f64>(v), Step::BoundingBox, clip, sink));
    "triangle: inside test", "barycentric", "incremental" => |v, clip, sink|
        done(barycentric(&real::<f32>(v), Step::Incremental, clip, sink));
    "triangle: inside test", "barycentric", "without upper bounds" => |v, clip, sink|
        done(barycentric(&real::<f32>(v), Step::WithoutUpperBounds, clip, sink));
    "triangle: inside test", "barycentric", "beta + gamma <= 1" => |v, clip, sink|
        done(barycentric(&real::<f32>(v), Step::BetaPlusGamma, clip, sink));
    "triangle: inside test", "given by", "three vertices" => |v, clip, sink|
        outcome(edge_equations::<f64, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "given by", "three edges" => |v, clip, sink|
        done(three_edges::<f64, _>(&edges_of(&real(v)), clip, sink));
    "triangle: inside test", "edge equations", "f32" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge equations", "f64" => |v, clip, sink|
        outcome(edge_equations::<f64, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge equations", "F = 4, 32 bits" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i32, 4>, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge equations", "F = 8, 32 bits" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i32, 8>, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge equations", "F = 12, 32 bits" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i32, 12>, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge equations", "F = 16, 32 bits" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i32, 16>, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge equations", "F = 4, 64 bits" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i64, 4>, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge equations", "F = 8, 64 bits" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i64, 8>, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge equations", "F = 12, 64 bits" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i64, 12>, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge equations", "F = 16, 64 bits" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i64, 16>, _>(&real(v), USUAL, clip, sink));
    "triangle: inside test", "edge functions, snapped", "F = 4, 32 bits" => |v, clip, sink|
        done(snapped::<i32, 4, _>(&snap::<i32, 4>(v), clip, sink));
    "triangle: inside test", "edge functions, snapped", "F = 8, 32 bits" => |v, clip, sink|
        done(snapped::<i32, 8, _>(&snap::<i32, 8>(v), clip, sink));
    "triangle: inside test", "edge functions, snapped", "F = 12, 32 bits" => |v, clip, sink|
        done(snapped::<i32, 12, _>(&snap::<i32, 12>(v), clip, sink));
    "triangle: inside test", "edge functions, snapped", "F = 16, 32 bits" => |v, clip, sink|
        done(snapped::<i32, 16, _>(&snap::<i32, 16>(v), clip, sink));
    "triangle: inside test", "edge functions, snapped", "F = 4, 64 bits" => |v, clip, sink|
        done(snapped::<i64, 4, _>(&snap::<i64, 4>(v), clip, sink));
    "triangle: inside test", "edge functions, snapped", "F = 8, 64 bits" => |v, clip, sink|
        done(snapped::<i64, 8, _>(&snap::<i64, 8>(v), clip, sink));
    "triangle: inside test", "edge functions, snapped", "F = 12, 64 bits" => |v, clip, sink|
        done(snapped::<i64, 12, _>(&snap::<i64, 12>(v), clip, sink));
    "triangle: inside test", "edge functions, snapped", "F = 16, 64 bits" => |v, clip, sink|
        done(snapped::<i64, 16, _>(&snap::<i64, 16>(v), clip, sink));
    "triangle: inside test", "constant C", "cross product" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), Options { constant: Constant::CrossProduct, ..USUAL }, clip, sink));
    "triangle: inside test", "constant C", "one vertex" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), Options { constant: Constant::OneVertex, ..USUAL }, clip, sink));
    "triangle: inside test", "constant C", "averaged" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), Options { constant: Constant::Averaged, ..USUAL }, clip, sink));
    "triangle: inside test", "constant C", "differences" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), DIFFERENCES, clip, sink));
    "triangle: inside test", "constant C", "differences, stepped" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), Options { stepped: true, ..DIFFERENCES }, clip, sink));
    "triangle: inside test", "constant C", "cross product, at each pixel" => |v, clip, sink| {
        let options = Options { constant: Constant::CrossProduct, stepped: false, ..USUAL };
        outcome(edge_equations::<f32, _>(&real(v), options, clip, sink))
    };
    "triangle: inside test", "constant C", "averaged, at each pixel" => |v, clip, sink| {
        let options = Options { constant: Constant::Averaged, stepped: false, ..USUAL };
        outcome(edge_equations::<f32, _>(&real(v), options, clip, sink))
    };
    "triangle: inside test", "area", "sum of the C's" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), Options { orientation: Orientation::SumOfCs, ..USUAL }, clip, sink));
    "triangle: inside test", "area", "cross product" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), Options { orientation: Orientation::Area, ..USUAL }, clip, sink));
    "triangle: inside test", "orientation", "signed area" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), Options { orientation: Orientation::Area, ..USUAL }, clip, sink));
    "triangle: inside test", "orientation", "third vertex" => |v, clip, sink|
        outcome(edge_equations::<f32, _>(&real(v), THIRD_VERTEX, clip, sink));
    "triangle: inside test", "orientation", "signed area, F = 12" => |v, clip, sink| {
        let options = Options { orientation: Orientation::Area, ..USUAL };
        outcome(edge_equations::<Fixed<i32, 12>, _>(&real(v), options, clip, sink))
    };
    "triangle: inside test", "orientation", "third vertex, F = 12" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i32, 12>, _>(&real(v), THIRD_VERTEX, clip, sink));
    "triangle: inside test", "bounding box", "centres" => |v, clip, sink|
        outcome(edge_equations::<f64, _>(&real(v), Options { bounds: Bounds::Centres, ..USUAL }, clip, sink));
    "triangle: inside test", "bounding box", "(int) min to (int) (max + 1)" => |v, clip, sink|
        outcome(edge_equations::<f64, _>(&real(v), Options { bounds: Bounds::Outwards, ..USUAL }, clip, sink));
    "triangle: inside test", "bounding box", "(int) (min + .5) to (int) (max - .5)" => |v, clip, sink|
        outcome(edge_equations::<f64, _>(&real(v), Options { bounds: Bounds::Inwards, ..USUAL }, clip, sink));
    "triangle: inside test", "bounding box", "six-entry table" => |v, clip, sink|
        outcome(edge_equations::<f64, _>(&real(v), Options { bounds: Bounds::Table, ..USUAL }, clip, sink));
    "triangle: inside test", "bounding box", "six-entry table, F = 12" => |v, clip, sink| {
        let options = Options { bounds: Bounds::Table, ..USUAL };
        outcome(edge_equations::<Fixed<i32, 12>, _>(&real(v), options, clip, sink))
    };
    "triangle: inside test", "samples", "integer coordinates" => |v, clip, sink| {
        let options = Options { at_centre: false, bounds: Bounds::Outwards, ..USUAL };
        outcome(edge_equations::<f64, _>(&real(v), options, clip, sink))
    };
    "triangle: inside test", "samples", "centres" => |v, clip, sink| {
        let options = Options { at_centre: true, bounds: Bounds::Outwards, ..USUAL };
        outcome(edge_equations::<f64, _>(&real(v), options, clip, sink))
    };
    "triangle: inside test", "sign test", "three comparisons" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i32, 12>, _>(&real(v), Options { test: Test::Comparisons, ..USUAL }, clip, sink));
    "triangle: inside test", "sign test", "OR of the signs" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i32, 12>, _>(&real(v), Options { test: Test::OrOfSigns, ..USUAL }, clip, sink));
    "triangle: inside test", "row", "whole" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i32, 12>, _>(&real(v), Options { early_out: false, ..USUAL }, clip, sink));
    "triangle: inside test", "row", "early-out" => |v, clip, sink|
        outcome(edge_equations::<Fixed<i32, 12>, _>(&real(v), Options { early_out: true, ..USUAL }, clip, sink));
    "triangle: inside test", "as printed", "FlatTri, Java" => |v, clip, sink|
        outcome(printed::flat_tri_java(&real(v), clip, sink));
    "triangle: inside test", "as printed", "FlatTri, C#" => |v, clip, sink|
        outcome(printed::flat_tri_csharp(&real(v), clip, sink));
    "triangle: inside test", "as printed", "guidelines, C" => |v, clip, sink|
        outcome(printed::guidelines(&real(v), clip, sink));
    "triangle: inside test", "spanfill", "shipped" => |v, clip, sink| shipped(v, clip, sink);
}

const DIFFERENCES: Options =
    Options { constant: Constant::Differences, orientation: Orientation::Area, stepped: false, ..USUAL };
const THIRD_VERTEX: Options = Options { orientation: Orientation::ThirdVertex, ..USUAL };

crate::variants! { TRAVERSAL: Corners;
    "triangle: traversal", "every pixel", "" => |v, clip, sink| done(every_pixel(v, clip, sink));
    "triangle: traversal", "bounding box", "" => |v, clip, sink| done(bounding_box(v, clip, sink));
    "triangle: traversal", "backtrack", "" => |v, clip, sink| done(backtrack(v, clip, sink));
    "triangle: traversal", "edge walking", "f32 DDA, ceiling and floor" => |v, clip, sink|
        done(edge_walk::<FloatDda<f32>, _>(&real(v), Spans::Closed, clip, sink));
    "triangle: traversal", "edge walking", "f32 DDA, half open" => |v, clip, sink|
        done(edge_walk::<FloatDda<f32>, _>(&real(v), Spans::HalfOpen, clip, sink));
    "triangle: traversal", "edge walking", "f64 DDA, half open" => |v, clip, sink|
        done(edge_walk::<FloatDda<f64>, _>(&real(v), Spans::HalfOpen, clip, sink));
    "triangle: traversal", "edge walking", "fixed DDA, F = 8, half open" => |v, clip, sink|
        done(edge_walk::<FixedDda<8>, _>(&v.map(FixedDda::<8>::vertex), Spans::HalfOpen, clip, sink));
    "triangle: traversal", "edge walking", "fixed DDA, F = 12, half open" => |v, clip, sink|
        done(edge_walk::<FixedDda<12>, _>(&v.map(FixedDda::<12>::vertex), Spans::HalfOpen, clip, sink));
    "triangle: traversal", "edge walking", "fixed DDA, F = 16, ceiling and floor" => |v, clip, sink|
        done(edge_walk::<FixedDda<16>, _>(&v.map(FixedDda::<16>::vertex), Spans::Closed, clip, sink));
    "triangle: traversal", "edge walking", "fixed DDA, F = 16, half open" => |v, clip, sink|
        done(edge_walk::<FixedDda<16>, _>(&v.map(FixedDda::<16>::vertex), Spans::HalfOpen, clip, sink));
    "triangle: traversal", "edge walking", "exact remainder, ceiling and floor" => |v, clip, sink|
        done(edge_walk::<ExactDda, _>(v, Spans::Closed, clip, sink));
    "triangle: traversal", "edge walking", "exact remainder, half open" => |v, clip, sink|
        done(edge_walk::<ExactDda, _>(v, Spans::HalfOpen, clip, sink));
    "triangle: traversal", "Warnock", "whole screen" => |v, clip, sink| done(warnock(v, clip, sink));
    "triangle: traversal", "Warnock", "bounding box" => |v, clip, sink| done(warnock_in_box(v, clip, sink));
    "triangle: traversal", "micropolygons", "middles to 1/256 px" => |v, clip, sink|
        outcome(micropolygons(v, Middles::Rounded, clip, sink));
    "triangle: traversal", "micropolygons", "middles exact" => |v, clip, sink|
        outcome(micropolygons(v, Middles::Exact, clip, sink));
    "triangle: traversal", "8 x 8 blocks", "" => |v, clip, sink| done(blocks(v, clip, sink));
    "triangle: traversal", "spanfill", "shipped" => |v, clip, sink| shipped(v, clip, sink);
}

/// A point off the clip on the line of the mesh's first edge, in pixels along `axis`.
fn on_an_edges_line(mesh: &[Corners], axis: Axis, clip: &PixelRect) -> [f64; 2] {
    let mut point = mesh.first().map_or([-256, -256], |[v0, _, _]| v0.map(i64::from));
    let beyond =
        mesh.first().map_or([0, 0], |[v0, v1, _]| [0, 1].map(|axis| i64::from(v0[axis]) - i64::from(v1[axis])));
    let is_in = |value: i64, pixels: &core::ops::Range<i32>| {
        256 * i64::from(pixels.start) <= value && value < 256 * i64::from(pixels.end)
    };
    let mut steps = 1;
    while steps < 1 << 16 && is_in(point[0], &clip.columns) && is_in(point[1], &clip.rows) {
        point = [0, 1].map(|axis| point[axis] + steps * beyond[axis]);
        steps *= 2;
    }
    let y = if axis == Axis::Up { 256 * i64::from(clip.rows.end) - point[1] } else { point[1] };
    [point[0] as f64 / 256.0, y as f64 / 256.0]
}

/// Shirley's.
const CORNER: [f64; 2] = [-1.0, -1.0];

fn each(mesh: &[Corners], draw: impl FnMut(&Corners) -> Result<(), Infallible>) -> Outcome {
    done(mesh.iter().try_for_each(draw))
}

crate::variants! { SHARED: [Corners];
    "shared edges", "none", ">= 0" => |mesh, clip, sink| each(mesh, |v| untied(v, Boundary::Included, clip, sink));
    "shared edges", "none", "> 0" => |mesh, clip, sink| each(mesh, |v| untied(v, Boundary::Excluded, clip, sink));
    "shared edges", "tie-break", "left and bottom, y up" => |mesh, clip, sink|
        each(mesh, |v| tie_break(v, Axis::Up, clip, sink));
    "shared edges", "tie-break", "left and top, y down" => |mesh, clip, sink|
        each(mesh, |v| tie_break(v, Axis::Down, clip, sink));
    "shared edges", "reference point", "(-1, -1), y up" => |mesh, clip, sink|
        each(mesh, |v| reference_point(v, Axis::Up, &[CORNER], clip, sink));
    "shared edges", "reference point", "(-1, -1), y down" => |mesh, clip, sink|
        each(mesh, |v| reference_point(v, Axis::Down, &[CORNER], clip, sink));
    "shared edges", "reference point", "on an edge's line, y up" => |mesh, clip, sink| {
        let points = [on_an_edges_line(mesh, Axis::Up, clip)];
        each(mesh, |v| reference_point(v, Axis::Up, &points, clip, sink))
    };
    "shared edges", "reference point", "on an edge's line, y down" => |mesh, clip, sink| {
        let points = [on_an_edges_line(mesh, Axis::Down, clip)];
        each(mesh, |v| reference_point(v, Axis::Down, &points, clip, sink))
    };
    "shared edges", "reference point", "on an edge's line, then a second, y up" => |mesh, clip, sink| {
        let points = [on_an_edges_line(mesh, Axis::Up, clip), CORNER];
        each(mesh, |v| reference_point(v, Axis::Up, &points, clip, sink))
    };
    "shared edges", "reference point", "on an edge's line, then a second, y down" => |mesh, clip, sink| {
        let points = [on_an_edges_line(mesh, Axis::Down, clip), CORNER];
        each(mesh, |v| reference_point(v, Axis::Down, &points, clip, sink))
    };
    "shared edges", "spanfill", "shipped" => |mesh, clip, sink| {
        for v in mesh {
            shipped(v, clip, sink)?;
        }
        Ok(())
    };
}
