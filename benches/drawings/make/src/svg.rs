//! Fills and strokes of SVG files.

use std::{fs, path::Path};

use kurbo::{Affine, BezPath, Cap, Join, Stroke, StrokeOpts};
use usvg::{
    Group, Node, Paint, PaintOrder, Tree,
    tiny_skia_path::{self, PathSegment},
};

use crate::{
    Outcome,
    outline::{Shape, TOLERANCE},
};

/// What of a drawing is taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Parts {
    Fills,
    FillsAndStrokes,
}

pub(crate) fn read(file: &Path) -> Outcome<Tree> {
    let text = fs::read_to_string(file).map_err(|error| format!("{}: {error}", file.display()))?;
    Ok(Tree::from_str(&text, &usvg::Options::default()).map_err(|error| format!("{}: {error}", file.display()))?)
}

/// In the order in which they are drawn, opaque, without clips and masks.
pub(crate) fn shapes(tree: &Tree, to_pixels: Affine, parts: Parts) -> Vec<Shape> {
    let mut shapes = Vec::new();
    group(tree.root(), to_pixels, parts, &mut shapes);
    shapes
}

fn group(of: &Group, to_pixels: Affine, parts: Parts, shapes: &mut Vec<Shape>) {
    for node in of.children() {
        match node {
            Node::Group(inner) => group(inner, to_pixels, parts, shapes),
            Node::Path(path) if path.is_visible() => self::path(path, to_pixels, parts, shapes),
            _ => {}
        }
    }
}

fn path(path: &usvg::Path, to_pixels: Affine, parts: Parts, shapes: &mut Vec<Shape>) {
    let to_pixels = to_pixels * affine(path.abs_transform());
    let outline = bez_path(path.data());
    let fill = path.fill().and_then(|fill| {
        let even_odd = fill.rule() == usvg::FillRule::EvenOdd;
        Shape::new(rgb(fill.paint()), even_odd, &(to_pixels * &outline))
    });
    let stroke = path.stroke().filter(|_| parts == Parts::FillsAndStrokes).and_then(|stroke| {
        // The scale is the same in both directions in all of these drawings.
        let scale = to_pixels.determinant().abs().sqrt();
        let style = style(stroke);
        let outlined = kurbo::stroke(&outline, &style, &StrokeOpts::default(), TOLERANCE / scale);
        Shape::new(rgb(stroke.paint()), false, &(to_pixels * outlined))
    });
    match path.paint_order() {
        PaintOrder::FillAndStroke => shapes.extend(fill.into_iter().chain(stroke)),
        PaintOrder::StrokeAndFill => shapes.extend(stroke.into_iter().chain(fill)),
    }
}

fn style(stroke: &usvg::Stroke) -> Stroke {
    let join = match stroke.linejoin() {
        usvg::LineJoin::Miter | usvg::LineJoin::MiterClip => Join::Miter,
        usvg::LineJoin::Round => Join::Round,
        usvg::LineJoin::Bevel => Join::Bevel,
    };
    let cap = match stroke.linecap() {
        usvg::LineCap::Butt => Cap::Butt,
        usvg::LineCap::Round => Cap::Round,
        usvg::LineCap::Square => Cap::Square,
    };
    let style = Stroke::new(f64::from(stroke.width().get()))
        .with_join(join)
        .with_caps(cap)
        .with_miter_limit(f64::from(stroke.miterlimit().get()));
    match stroke.dasharray() {
        Some(lengths) => {
            style.with_dashes(f64::from(stroke.dashoffset()), lengths.iter().map(|&length| f64::from(length)))
        }
        None => style,
    }
}

/// A gradient's first colour stands for it.
fn rgb(paint: &Paint) -> [u8; 3] {
    let colour = match paint {
        Paint::Color(colour) => *colour,
        Paint::LinearGradient(gradient) => gradient.stops()[0].color(),
        Paint::RadialGradient(gradient) => gradient.stops()[0].color(),
        Paint::Pattern(_) => usvg::Color::black(),
    };
    [colour.red, colour.green, colour.blue]
}

fn bez_path(path: &tiny_skia_path::Path) -> BezPath {
    let point = |point: tiny_skia_path::Point| (f64::from(point.x), f64::from(point.y));
    let mut out = BezPath::new();
    for segment in path.segments() {
        match segment {
            PathSegment::MoveTo(p) => out.move_to(point(p)),
            PathSegment::LineTo(p) => out.line_to(point(p)),
            PathSegment::QuadTo(a, p) => out.quad_to(point(a), point(p)),
            PathSegment::CubicTo(a, b, p) => out.curve_to(point(a), point(b), point(p)),
            PathSegment::Close => out.close_path(),
        }
    }
    out
}

fn affine(t: usvg::Transform) -> Affine {
    Affine::new([t.sx, t.ky, t.kx, t.sy, t.tx, t.ty].map(f64::from))
}
