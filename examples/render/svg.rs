//! From an SVG file to a scene.

use embedded_graphics::{
    geometry::{Point as Pixel, Size},
    primitives::Rectangle,
};
use kurbo::{Affine, BezPath, Shape};
use usvg::{ClipPath, Group, Node, Paint, PaintOrder, Tree, roxmltree};

use super::{
    arcs::split_arcs,
    cli::{LONGEST_SIDE, check_size},
    ellipse::Ellipse,
    flatten, gradient,
    missing::{Missing, MissingKinds, elements_left_out},
    scene::{Colours, Item, Outline, Scene},
    stroke::{Hairlines, Stroked, bez_path, stroke},
    transform::{affine, stretches},
};

/// Reads an SVG file's content. Says what of it is not drawn as the file asks.
pub(crate) fn scene_from(
    source: &[u8],
    size: Option<Size>,
    hairlines: Hairlines,
) -> Result<(Scene, MissingKinds), String> {
    let text = std::str::from_utf8(source).map_err(|_| "not an SVG file: not UTF-8 text")?;
    let syntax = roxmltree::ParsingOptions { allow_dtd: true, ..Default::default() };
    let document =
        roxmltree::Document::parse_with_options(text, syntax).map_err(|e| format!("not an SVG file: {e}"))?;
    let mut options = usvg::Options::default();
    // Images are not drawn yet: no file that an SVG file names is opened.
    options.image_href_resolver.resolve_string = Box::new(|_, _| None);
    let tree = match split_arcs(&document) {
        None => Tree::from_xmltree(&document, &options),
        Some(text) => Tree::from_str(&text, &options),
    };
    let tree = tree.map_err(|error| match error {
        usvg::Error::InvalidSize => "its width and height must be above zero".into(),
        usvg::Error::ParsingFailed(roxmltree::Error::NoRootNode) => {
            "not an SVG file: its root is no svg element".into()
        }
        other => format!("not an SVG file that can be drawn: {other}"),
    })?;

    let view = View::new(&tree, size)?;
    let missing = elements_left_out(&document);
    let mut walk = Walk { hairlines, items: Vec::new(), missing };
    walk.group(tree.root(), view.to_device, view.visible, 1.0);
    Ok((Scene { size: view.size, items: walk.items }, walk.missing))
}

/// Where on the display the drawing goes.
struct View {
    size: Size,
    to_device: Affine,
    /// The pixels of the drawing's own rectangle: the rest of the display stays background.
    visible: Rectangle,
}

impl View {
    fn new(tree: &Tree, requested: Option<Size>) -> Result<Self, String> {
        let own = kurbo::Size::new(f64::from(tree.size().width()), f64::from(tree.size().height()));
        // As many pixels as the drawing touches, as other renderers have it; the casts saturate, and check_size
        // refuses the result.
        let natural = Size::new(own.width.ceil().max(1.0) as u32, own.height.ceil().max(1.0) as u32);
        let size = requested.unwrap_or(natural);
        check_size(size, 1)?;

        let display = kurbo::Size::new(f64::from(size.width), f64::from(size.height));
        let to_device = if size == natural {
            Affine::IDENTITY
        } else {
            let scale = (display.width / own.width).min(display.height / own.height);
            let rest = (display - own * scale) * 0.5;
            Affine::translate(rest.to_vec2()) * Affine::scale(scale)
        };
        let all = Rectangle::new(Pixel::zero(), size);
        // Where the drawing is as large as it says, what it has beyond a part of a pixel is seen in the rest of that.
        let visible = if size == natural {
            all
        } else {
            pixels_in(to_device.transform_rect_bbox(own.to_rect())).intersection(&all)
        };
        Ok(Self { size, to_device, visible })
    }
}

/// The pixels whose centres a rectangle contains, its left and top edge included, as for every shape.
fn pixels_in(rect: kurbo::Rect) -> Rectangle {
    // Beyond any display, and far from where a Rectangle's arithmetic overflows; the cast keeps such a number.
    let far = f64::from(2 * LONGEST_SIDE);
    let first_centre_from = |position: f64| ((position * 256.0).round() / 256.0 - 0.5).ceil().clamp(-far, far) as i32;
    let (left, right) = (first_centre_from(rect.x0), first_centre_from(rect.x1));
    let (top, bottom) = (first_centre_from(rect.y0), first_centre_from(rect.y1));
    Rectangle::new(Pixel::new(left, top), Size::new(left.abs_diff(right), top.abs_diff(bottom)))
}

/// Goes through the tree in painting order.
///
/// Transforms are put together on the way: what usvg calls absolute leaves out that of a group which it makes to clip
/// a symbol, and that of the root for a background.
struct Walk {
    hairlines: Hairlines,
    items: Vec<Item>,
    missing: MissingKinds,
}

impl Walk {
    fn group(&mut self, group: &Group, to_device: Affine, clip: Rectangle, mut opacity: f32) {
        let to_device = to_device * affine(group.transform());
        // Nothing of a group is seen that is wholly transparent.
        if group.opacity().get() == 0.0 {
            return;
        }
        if group.opacity().get() < 1.0 {
            // What is painted once may as well be transparent itself; of more, what lies below would show.
            if paints_in(group) == 1 {
                opacity *= group.opacity().get();
            } else {
                self.missing.insert(Missing::Opacity);
            }
        }
        if group.mask().is_some() {
            self.missing.insert(Missing::Mask);
        }
        if !group.filters().is_empty() {
            self.missing.insert(Missing::Filter);
        }
        if group.blend_mode() != usvg::BlendMode::Normal {
            self.missing.insert(Missing::BlendMode);
        }
        let clip = match group.clip_path() {
            None => clip,
            Some(path) => self.clipped(clip, path, to_device),
        };
        for node in group.children() {
            match node {
                Node::Group(child) => self.group(child, to_device, clip, opacity),
                Node::Path(path) => self.path(path, to_device, clip, opacity),
                // Named already, from the source.
                Node::Image(_) | Node::Text(_) => {}
            }
        }
    }

    /// An upright rectangle clips for certain pixels wholly; nested `svg` elements, symbols and markers have such ones.
    fn clipped(&mut self, clip: Rectangle, path: &ClipPath, to_device: Affine) -> Rectangle {
        let outer = match path.clip_path() {
            None => clip,
            Some(outer) => self.clipped(clip, outer, to_device),
        };
        match upright_rectangle(path.root(), to_device * affine(path.transform())) {
            Some(rect) => outer.intersection(&pixels_in(rect)),
            None => {
                self.missing.insert(Missing::ClipPath);
                outer
            }
        }
    }

    fn path(&mut self, path: &usvg::Path, to_device: Affine, clip: Rectangle, opacity: f32) {
        if !path.is_visible() {
            return;
        }
        match path.paint_order() {
            PaintOrder::FillAndStroke => {
                self.fill(path, to_device, clip, opacity);
                self.stroke(path, to_device, clip, opacity);
            }
            PaintOrder::StrokeAndFill => {
                self.stroke(path, to_device, clip, opacity);
                self.fill(path, to_device, clip, opacity);
            }
        }
    }

    fn fill(&mut self, path: &usvg::Path, to_device: Affine, clip: Rectangle, opacity: f32) {
        let Some(fill) = path.fill() else { return };
        let Some(opacity) = in_255ths(opacity * fill.opacity().get()) else { return };
        let Some(colours) = self.colours(fill.paint(), to_device) else { return };
        let ellipse = Ellipse::recognise(path.data());
        let circle = ellipse.and_then(|ellipse| ellipse.circle(to_device));
        let outline = match circle {
            Some((center, radius)) => Some(Outline::Circle { center, radius }),
            None => {
                let rule = match fill.rule() {
                    usvg::FillRule::NonZero => spanfill::FillRule::NonZero,
                    usvg::FillRule::EvenOdd => spanfill::FillRule::EvenOdd,
                };
                Outline::filling(flatten::flatten(&(to_device * curve(path, ellipse, to_device))), rule)
            }
        };
        self.items.extend(outline.map(|outline| Item { outline, colours, opacity, clip }));
    }

    fn stroke(&mut self, path: &usvg::Path, to_device: Affine, clip: Rectangle, opacity: f32) {
        let Some(style) = path.stroke() else { return };
        let Some(opacity) = in_255ths(opacity * style.opacity().get()) else { return };
        let Some(colours) = self.colours(style.paint(), to_device) else { return };
        let curve = curve(path, Ellipse::recognise(path.data()), to_device);
        match stroke(&curve, style, to_device, self.hairlines) {
            None => {}
            Some(Stroked::Lines(lines)) => {
                let lines = lines.into_iter().map(Outline::Line);
                self.items.extend(lines.map(|outline| Item { outline, colours: colours.clone(), opacity, clip }));
            }
            Some(Stroked::Contours(contours)) => {
                let outline = Outline::filling(contours, spanfill::FillRule::NonZero);
                self.items.extend(outline.map(|outline| Item { outline, colours, opacity, clip }));
            }
        }
    }

    /// None when there is nothing to see.
    fn colours(&mut self, paint: &Paint, to_device: Affine) -> Option<Colours> {
        match paint {
            Paint::Color(colour) => Some(Colours::One(gradient::colour(*colour))),
            Paint::LinearGradient(linear) => gradient::linear(linear, to_device),
            Paint::RadialGradient(radial) => gradient::radial(radial, to_device),
            Paint::Pattern(_) => {
                self.missing.insert(Missing::Pattern);
                None
            }
        }
    }
}

/// None when there is nothing to see.
fn in_255ths(opacity: f32) -> Option<u8> {
    // The cast saturates, and keeps the whole number that it is given.
    Some((opacity * 255.0).round() as u8).filter(|&opacity| opacity > 0)
}

/// How often something of a group is painted over what is there.
fn paints_in(group: &Group) -> usize {
    let paints = |node: &Node| match node {
        Node::Group(group) => paints_in(group),
        Node::Path(path) if path.is_visible() => {
            usize::from(path.fill().is_some()) + usize::from(path.stroke().is_some())
        }
        Node::Path(_) | Node::Image(_) | Node::Text(_) => 0,
    };
    group.children().iter().map(paints).sum()
}

/// The outline of an element in its own units. Of an ellipse, usvg's cubics are within a tenth of a unit, which may
/// be many pixels: they are made anew, for the display's resolution.
fn curve(path: &usvg::Path, ellipse: Option<Ellipse>, to_device: Affine) -> BezPath {
    let (scale, _) = stretches(to_device);
    match ellipse {
        Some(Ellipse { center, radii }) if scale > 0.0 => kurbo::Ellipse::new(center, radii, 0.0).to_path(1e-3 / scale),
        _ => bez_path(path.data()),
    }
}

/// The rectangle on the display that is all of a clip path, if that is what it is.
fn upright_rectangle(root: &Group, to_device: Affine) -> Option<kurbo::Rect> {
    let to_device = to_device * affine(root.transform());
    let [only] = root.children() else { return None };
    let path = match only {
        Node::Group(group) if group.clip_path().is_none() => return upright_rectangle(group, to_device),
        Node::Path(path) if path.is_visible() && path.fill().is_some() => path,
        Node::Group(_) | Node::Path(_) | Node::Image(_) | Node::Text(_) => return None,
    };
    use kurbo::PathEl::{ClosePath, LineTo, MoveTo};
    let outline = to_device * bez_path(path.data());
    let [MoveTo(a), LineTo(b), LineTo(c), LineTo(d), ClosePath] = *outline.elements() else { return None };
    let same = |p: f64, q: f64| (p - q).abs() < 1.0 / 512.0;
    let along_x_first = same(a.y, b.y) && same(b.x, c.x) && same(c.y, d.y) && same(d.x, a.x);
    let along_y_first = same(a.x, b.x) && same(b.y, c.y) && same(c.x, d.x) && same(d.y, a.y);
    (along_x_first || along_y_first).then(|| kurbo::Rect::from_points(a, c))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene(attributes: &str, content: &str, size: Option<Size>) -> Scene {
        let source = format!(r#"<svg xmlns="http://www.w3.org/2000/svg" {attributes}>{content}</svg>"#);
        let (scene, missing) = scene_from(source.as_bytes(), size, Hairlines::OnePixel).expect("a drawing");
        assert!(missing.is_empty(), "{missing:?}");
        scene
    }

    fn vertices(outline: &Outline) -> Vec<(i32, i32)> {
        let all = match outline {
            Outline::Triangle(vertices) => vertices.to_vec(),
            Outline::Line(ends) => ends.to_vec(),
            Outline::Circle { center, .. } => vec![*center],
            Outline::Polygon { contours, .. } => contours.concat(),
        };
        all.iter().map(|vertex| (vertex.x.to_bits(), vertex.y.to_bits())).collect()
    }

    #[test]
    fn a_unit_is_a_pixel_and_no_vertex_is_lost() {
        let content = r#"<path d="M0 0H5V0.25L5 .251 2 3.001Z"/>"#;
        let scene = scene(r#"width="8" height="4.4""#, content, None);
        assert_eq!(scene.size, Size::new(8, 5));
        assert_eq!(vertices(&scene.items[0].outline), [(0, 0), (1280, 0), (1280, 64), (1280, 64), (512, 768)]);
    }

    #[test]
    fn a_size_scales_uniformly_and_centres() {
        let content = r#"<path d="M0 0H10V5H0Z"/>"#;
        let scene = scene(r#"width="10" height="5""#, content, Some(Size::new(40, 40)));
        assert_eq!(scene.size, Size::new(40, 40));
        let expected = [(0, 10), (40, 10), (40, 30), (0, 30)].map(|(x, y)| (x * 256, y * 256));
        assert_eq!(vertices(&scene.items[0].outline), expected);
        assert_eq!(scene.items[0].clip, Rectangle::new(Pixel::new(0, 10), Size::new(40, 20)));
    }

    #[test]
    fn an_arc_is_as_exact_as_the_display_however_large_its_units() {
        // Radius 0.4 of a unit that is 2000 pixels.
        let half_disc = r#"<path d="M.9 .5A.4 .4 0 0 1 .1 .5"/>"#;
        let ellipse = r#"<ellipse cx=".5" cy=".5" rx=".4" ry=".2"/>"#;
        for (content, squeeze) in [(half_disc, 1.0), (ellipse, 0.5)] {
            let scene = scene(r#"viewBox="0 0 1 1""#, content, Some(Size::new(2000, 2000)));
            let outline = vertices(&scene.items[0].outline);
            let pixels = outline.iter().map(|&(x, y)| (f64::from(x) / 256.0, f64::from(y) / 256.0));
            let points: Vec<_> = pixels.map(|(x, y)| kurbo::Point::new(x - 1000.0, (y - 1000.0) / squeeze)).collect();
            assert!(points.len() > 100);
            for pair in points.windows(2) {
                for point in [pair[0], pair[0].midpoint(pair[1])] {
                    let distance = point.to_vec2().hypot();
                    assert!((distance - 800.0).abs() < 0.08, "{distance} of 800 at {point}");
                }
            }
        }
    }

    #[test]
    fn opacity_is_that_of_the_paint_and_of_groups_around_it_alone() {
        let content = r#"<rect width="4" height="4" fill-opacity=".5"/>
            <g opacity=".5"><g opacity=".5"><rect width="4" height="4" fill-opacity=".8"/></g></g>
            <rect width="4" height="4" opacity=".001"/><rect width="4" height="4"/>"#;
        let scene = scene(r#"width="4" height="4""#, content, None);
        let opacities: Vec<u8> = scene.items.iter().map(|item| item.opacity).collect();
        assert_eq!(opacities, [128, 51, 255]);
    }

    #[test]
    fn clips_may_be_larger_than_any_display() {
        let content = r#"<clipPath id="c"><rect x="-2e9" y="1" width="4e9" height="1e30"/></clipPath>
            <rect width="4" height="4" clip-path="url(#c)"/>"#;
        let scene = scene(r#"width="4" height="4""#, content, None);
        assert_eq!(scene.items[0].clip, Rectangle::new(Pixel::new(0, 1), Size::new(4, 3)));
    }

    #[test]
    fn clips_within_clips_intersect() {
        let content = r#"<clipPath id="a"><rect x="1" width="9" height="9"/></clipPath>
            <clipPath id="b" clip-path="url(#a)"><rect y="2" width="3" height="9"/></clipPath>
            <g clip-path="url(#b)" transform="translate(1 0)"><rect width="9" height="9"/></g>"#;
        let scene = scene(r#"width="9" height="9""#, content, None);
        assert_eq!(scene.items[0].clip, Rectangle::new(Pixel::new(2, 2), Size::new(2, 7)));
    }

    #[test]
    fn a_clip_element_and_what_it_holds_have_transforms_of_their_own() {
        let content = r#"<clipPath id="c" transform="translate(3 1)">
                <rect width="2" height="1" transform="scale(2) translate(1 2)"/>
            </clipPath>
            <g transform="translate(10 20)"><rect width="40" height="40" clip-path="url(#c)"/></g>"#;
        let scene = scene(r#"width="60" height="60""#, content, None);
        assert_eq!(scene.items[0].clip, Rectangle::new(Pixel::new(15, 25), Size::new(4, 2)));
        let turned = r#"<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">
            <clipPath id="c" transform="rotate(30)"><rect width="4" height="4"/></clipPath>
            <rect width="9" height="9" clip-path="url(#c)"/></svg>"#;
        let (_, missing) = scene_from(turned.as_bytes(), None, Hairlines::OnePixel).expect("a drawing");
        assert!(missing.contains(&Missing::ClipPath));
    }

    /// As resvg's program has it; the nearest whole number would cut off a part of the drawing.
    #[test]
    fn sizes_are_rounded_up() {
        let sizes = [("8.01", "4.4", (9, 5)), ("8", "4", (8, 4)), ("0.3", "7.999", (1, 8)), ("2mm", "1in", (8, 96))];
        for (width, height, (columns, rows)) in sizes {
            let scene = scene(&format!(r#"width="{width}" height="{height}""#), "", None);
            assert_eq!(scene.size, Size::new(columns, rows), "{width} x {height}");
        }
    }

    #[test]
    fn a_symbol_is_clipped_where_it_is_used() {
        let content = r##"<symbol id="s" viewBox="0 0 10 10"><rect x="2" y="3" width="20" height="5"/></symbol>
            <use href="#s" width="10" height="10" transform="translate(51 30)"/>"##;
        let scene = scene(r#"width="80" height="60""#, content, None);
        assert_eq!(scene.items[0].clip, Rectangle::new(Pixel::new(51, 30), Size::new(10, 10)));
        let expected = [(53, 33), (73, 33), (73, 38), (53, 38)].map(|(x, y)| (x * 256, y * 256));
        assert_eq!(vertices(&scene.items[0].outline), expected);
    }

    #[test]
    fn a_background_is_all_of_the_view_box() {
        let attributes = r#"viewBox="-20 -10 40 20" background-color="red""#;
        let scene = scene(attributes, r#"<rect x="-20" y="-10" width="1" height="1"/>"#, None);
        let expected = [(0, 0), (40, 0), (40, 20), (0, 20)].map(|(x, y)| (x * 256, y * 256));
        assert_eq!(vertices(&scene.items[0].outline), expected);
        assert_eq!(scene.size, Size::new(40, 20));
    }
}
