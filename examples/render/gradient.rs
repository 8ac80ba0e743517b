//! From an SVG gradient to one of the crate's, on the display.

use embedded_graphics::pixelcolor::{Gray8, Rgb888};
use kurbo::{Affine, Point, Vec2};
use spanfill::{Spread, Stop};

use super::{
    flatten::vertex,
    scene::{Colours, Gradient, Places},
    transform::affine,
};

pub(crate) fn colour(usvg::Color { red, green, blue }: usvg::Color) -> Rgb888 {
    Rgb888::new(red, green, blue)
}

/// None when there is nothing to see.
pub(crate) fn linear(gradient: &usvg::LinearGradient, to_device: Affine) -> Option<Colours> {
    let point = |x: f32, y: f32| Point::new(x.into(), y.into());
    let (start, end) = (point(gradient.x1(), gradient.y1()), point(gradient.x2(), gradient.y2()));
    let (start, end) = on_the_display(start, end, to_device * affine(gradient.transform()))?;
    with_stops(gradient, Places::Linear { start: vertex(start), end: vertex(end) })
}

/// The line across which colours are alike may be squeezed on the way to the display: the end is then the foot of the
/// start on the line that is as far as the end was.
fn on_the_display(start: Point, end: Point, transform: Affine) -> Option<(Point, Point)> {
    let along = end - start;
    // Along the images of `along` and of what is across it, the place grows by 1 and by 0.
    let [a, b, c, d, _, _] = transform.as_coeffs();
    let image = |v: Vec2| Vec2::new(a * v.x + c * v.y, b * v.x + d * v.y);
    let (along, across) = (image(along), image(along.turn_90()));
    let start = transform * start;
    let area = along.cross(across);
    if area == 0.0 {
        // Of no length, or flat: see the crate's rule.
        return (along.hypot2() == 0.0).then_some((start, start));
    }
    let normal = across.turn_90();
    Some((start, start + normal * (along.dot(normal) / normal.hypot2())))
}

/// None when there is nothing to see.
pub(crate) fn radial(gradient: &usvg::RadialGradient, to_device: Affine) -> Option<Colours> {
    let transform = to_device * affine(gradient.transform());
    let point = |x: f32, y: f32| Point::new(x.into(), y.into());
    let (center, focus) = (point(gradient.cx(), gradient.cy()), point(gradient.fx(), gradient.fy()));
    let radius = f64::from(gradient.r().get());
    let ends = [Vec2::new(radius, 0.0), Vec2::new(0.0, radius)].map(|way| vertex(transform * (center + way)));
    // The cast saturates.
    let focal_radius = (f64::from(gradient.fr().get()) / radius * 65536.0) as u32;
    let places =
        Places::Radial { center: vertex(transform * center), ends, focus: vertex(transform * focus), focal_radius };
    with_stops(gradient, places)
}

fn with_stops(gradient: &usvg::BaseGradient, places: Places) -> Option<Colours> {
    let spread = match gradient.spread_method() {
        usvg::SpreadMethod::Pad => Spread::Pad,
        usvg::SpreadMethod::Reflect => Spread::Reflect,
        usvg::SpreadMethod::Repeat => Spread::Repeat,
    };
    // The casts saturate; offsets are from 0 to 1, in order.
    let offset = |stop: &usvg::Stop| (f64::from(stop.offset().get()) * 65536.0).round() as u32;
    let opacity = |stop: &usvg::Stop| (f64::from(stop.opacity().get()) * 255.0).round() as u8;
    let stops = gradient.stops();
    if stops.iter().all(|stop| opacity(stop) == 0) {
        return None;
    }
    let opaque = stops.iter().all(|stop| opacity(stop) == 255);
    Some(Colours::Gradient(Gradient {
        places,
        spread,
        stops: stops.iter().map(|stop| Stop::new(offset(stop), colour(stop.color()))).collect(),
        opacities: (!opaque)
            .then(|| stops.iter().map(|stop| Stop::new(offset(stop), Gray8::new(opacity(stop)))).collect()),
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_of_one_colour_stay_such_when_they_are_squeezed() {
        let transform = Affine::new([2.0, 0.5, -1.0, 3.0, 7.0, -4.0]);
        let (start, end) = (Point::new(1.0, 2.0), Point::new(4.0, 3.0));
        let (from, to) = on_the_display(start, end, transform).expect("an area");
        for (x, y) in [(0.0, 0.0), (5.0, 1.0), (-3.0, 8.0)] {
            let place = (Point::new(x, y) - start).dot(end - start) / (end - start).hypot2();
            let seen = (transform * Point::new(x, y) - from).dot(to - from) / (to - from).hypot2();
            assert!((place - seen).abs() < 1e-12, "{place} {seen}");
        }
        assert_eq!(on_the_display(start, start, transform), Some((transform * start, transform * start)));
        assert_eq!(on_the_display(start, end, Affine::new([1.0, 2.0, 2.0, 4.0, 0.0, 0.0])), None);
    }
}
