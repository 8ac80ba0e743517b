//! The variants of `attribute`: shapes are triangles with what varies across them.

use core::convert::Infallible;

use spanfill::{
    Affine, AttributeRow, AttributeSink, Attributes, Fragment, FragmentSink, Perspective, PixelRect, Shape, Span,
    SpanSink, Triangle, Vertex,
    methods::{
        attribute::{
            Corner,
            affine_pieces::affine_pieces,
            average::{average, flat},
            depth::{depth, depth_fixed},
            gouraud_barycentric::gouraud_barycentric,
            gouraud_edge_walk::gouraud_edge_walk,
            gouraud_fixed::{Rounding, gouraud_fixed},
            gouraud_planes::gouraud_planes,
            perspective::perspective,
            perspective_weights::perspective_weights,
        },
        number::Real,
    },
};

use super::{
    Outcome,
    triangle::{done, outcome},
};

/// A triangle with what varies across it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shaded {
    /// In 1/256 px.
    pub vertices: [[i32; 2]; 3],
    /// Red, green, blue, alpha, 0 to 255, at each vertex: or texture coordinates of any size, but for what has 12
    /// fraction bits, which clamps to 0 to 255.
    pub attributes: [[i32; 4]; 3],
    /// In 1/65536, above 0: 65536 throughout where there is no perspective. Only what is `in_perspective` looks.
    pub w: [i32; 3],
    /// 0 in front. Only what `is_depth` looks; it sends fragments without attributes, all others with depth 0.
    pub depth: [u16; 3],
}

fn corners<R: Real>(shape: &Shaded) -> [Corner<R, 4>; 3] {
    let corner = |vertex: usize| {
        let [x, y] = shape.vertices[vertex].map(R::from_subpixels);
        let w = R::from_integer(shape.w[vertex]) / R::from_integer(65536);
        Corner { x, y, w, depth: shape.depth[vertex], attributes: shape.attributes[vertex] }
    };
    [0, 1, 2].map(corner)
}

fn triangle(shape: &Shaded) -> Triangle {
    Triangle::from_vertices(shape.vertices.map(|[x, y]| Vertex::from_bits(x, y)))
}

/// The spans of a shipped triangle in one colour.
struct Flat<'s, S>(&'s mut S, [i32; 4]);

impl<S: FragmentSink<4, Error = Infallible>> SpanSink for Flat<'_, S> {
    type Error = Infallible;

    #[inline(always)]
    fn span(&mut self, Span { row: y, columns }: Span) -> Result<(), Infallible> {
        for x in columns {
            self.0.visit(x, y);
            self.0.fragment(Fragment { x, y, coverage: 255, depth: 0, attributes: self.1 })?;
        }
        Ok(())
    }
}

fn shipped_flat(shape: &Shaded, clip: &PixelRect, sink: &mut impl FragmentSink<4, Error = Infallible>) -> Outcome {
    let [c0, c1, c2] = &shape.attributes;
    done(triangle(shape).spans(clip, &mut Flat(sink, average([c0, c1, c2]))))
}

/// Fragments with `FRACTION` bits behind the binary point, to the nearest whole number, halves upwards.
struct Rounded<'s, S, const FRACTION: u32>(&'s mut S);

impl<S: FragmentSink<N>, const N: usize, const FRACTION: u32> FragmentSink<N> for Rounded<'_, S, FRACTION> {
    type Error = S::Error;

    #[inline(always)]
    fn fragment(&mut self, mut fragment: Fragment<N>) -> Result<(), S::Error> {
        for attribute in &mut fragment.attributes {
            *attribute = (*attribute + ((1 << FRACTION) >> 1)) >> FRACTION;
        }
        self.0.visit(fragment.x, fragment.y);
        self.0.fragment(fragment)
    }
}

fn shipped_gouraud(shape: &Shaded, clip: &PixelRect, sink: &mut impl FragmentSink<4, Error = Infallible>) -> Outcome {
    done(Affine::new(triangle(shape), shape.attributes).fragments(clip, &mut Rounded::<_, 0>(sink)))
}

/// In 1/256 of the attributes' unit, within so many of them; where attributes leave -8192 to 8192 they are clamped.
fn shipped_perspective(
    shape: &Shaded,
    tolerance: u32,
    clip: &PixelRect,
    sink: &mut impl FragmentSink<4, Error = Infallible>,
) -> Outcome {
    let values = shape.attributes.map(|attributes| attributes.map(|attribute| attribute.saturating_mul(256)));
    let Ok(seen) = Perspective::new(triangle(shape), values, shape.w) else {
        return Err("a vertex is not in front of the eye");
    };
    done(seen.tolerance(tolerance).fragments(clip, &mut Rounded::<_, 8>(sink)))
}

/// The depths of a shipped triangle's spans, as a depth buffer gets them.
struct Depths<'s, S>(&'s mut S);

impl<S: FragmentSink<Error = Infallible>> AttributeSink<0> for Depths<'_, S> {
    type Error = Infallible;

    #[inline(always)]
    fn span(
        &mut self,
        Span { row: y, columns }: Span,
        _: impl AttributeRow<0>,
        depths: impl Iterator<Item = u16>,
    ) -> Result<(), Infallible> {
        for (x, depth) in columns.zip(depths) {
            self.0.visit(x, y);
            self.0.fragment(Fragment { x, y, coverage: 255, depth, attributes: [] })?;
        }
        Ok(())
    }
}

fn shipped_depth(shape: &Shaded, clip: &PixelRect, sink: &mut impl FragmentSink<Error = Infallible>) -> Outcome {
    done(Affine::new(triangle(shape), [[]; 3]).interpolate_with_depth(shape.depth, clip, &mut Depths(sink)))
}

/// Whether a variant's attributes are to be divided by `w`.
pub fn in_perspective(method: &str, option: &str) -> bool {
    method == "perspective" || (method == "spanfill" && option.starts_with("perspective"))
}

/// Whether a variant sends depths, and no attributes.
pub fn is_depth(method: &str, option: &str) -> bool {
    method == "depth" || (method, option) == ("spanfill", "depth")
}

crate::variants! { ATTRIBUTES: Shaded;
    "attributes", "average", "" => |shape, clip, sink| done(flat(&corners::<f64>(shape), clip, sink));
    "attributes", "Gouraud, plane equations", "f64" => |shape, clip, sink|
        done(gouraud_planes(&corners::<f64>(shape), clip, sink));
    "attributes", "Gouraud, plane equations", "f32" => |shape, clip, sink|
        done(gouraud_planes(&corners::<f32>(shape), clip, sink));
    "attributes", "Gouraud, plane equations", "F = 12" => |shape, clip, sink|
        outcome(gouraud_fixed(&corners(shape), Rounding { half_added: false, at_centre: true }, clip, sink));
    "attributes", "Gouraud, plane equations", "F = 12, half added" => |shape, clip, sink|
        outcome(gouraud_fixed(&corners(shape), Rounding { half_added: true, at_centre: true }, clip, sink));
    "attributes", "Gouraud, plane equations", "F = 12, half added, as printed" => |shape, clip, sink|
        outcome(gouraud_fixed(&corners(shape), Rounding { half_added: true, at_centre: false }, clip, sink));
    "attributes", "Gouraud, barycentric", "f64" => |shape, clip, sink|
        done(gouraud_barycentric(&corners::<f64>(shape), clip, sink));
    "attributes", "Gouraud, barycentric", "f32" => |shape, clip, sink|
        done(gouraud_barycentric(&corners::<f32>(shape), clip, sink));
    "attributes", "Gouraud, edge walking", "fractional offsets" => |shape, clip, sink|
        done(gouraud_edge_walk(&corners::<f32>(shape), true, clip, sink));
    "attributes", "Gouraud, edge walking", "without offsets" => |shape, clip, sink|
        done(gouraud_edge_walk(&corners::<f32>(shape), false, clip, sink));
    "attributes", "perspective", "s/w and 1/w, f64" => |shape, clip, sink|
        done(perspective(&corners::<f64>(shape), clip, sink));
    "attributes", "perspective", "s/w and 1/w, f32" => |shape, clip, sink|
        done(perspective(&corners::<f32>(shape), clip, sink));
    "attributes", "perspective", "f = e/w" => |shape, clip, sink|
        done(perspective_weights(&corners::<f64>(shape), clip, sink));
    "attributes", "perspective", "affine" => |shape, clip, sink|
        done(gouraud_planes(&corners::<f64>(shape), clip, sink));
    "attributes", "perspective", "affine pieces of 16 px" => |shape, clip, sink|
        done(affine_pieces(&corners::<f64>(shape), clip, sink));
    "attributes", "depth", "f64" => |shape, clip, sink| done(depth(&corners::<f64>(shape), clip, sink));
    "attributes", "depth", "F = 12" => |shape, clip, sink| done(depth_fixed::<12, 4, _>(&corners(shape), clip, sink));
    "attributes", "spanfill", "flat" => |shape, clip, sink| shipped_flat(shape, clip, sink);
    "attributes", "spanfill", "gouraud" => |shape, clip, sink| shipped_gouraud(shape, clip, sink);
    "attributes", "spanfill", "perspective" => |shape, clip, sink| shipped_perspective(shape, 64, clip, sink);
    "attributes", "spanfill", "perspective, divided at each pixel" => |shape, clip, sink|
        shipped_perspective(shape, 0, clip, sink);
    "attributes", "spanfill", "depth" => |shape, clip, sink| shipped_depth(shape, clip, sink);
}
