//! The same primitives drawn by embedded-graphics and by its styles' stand-ins here: the same pixels, with the
//! exceptions that stand here and nowhere else.
//!
//! Exceptions, each of which a test of its own pins down:
//!
//! - A filled triangle without a stroke is this crate's own: embedded-graphics adds the lines around it.
//! - Strokes of triangles, lines and polylines wider than one pixel are exact outlines.
//! - A row of a rounded rectangle on which a stroke leaves nothing to fill: embedded-graphics has no stroke there.
//!   And corners that still overlap after embedded-graphics has made them fit the longest side.
//! - An ellipse whose first row has no pixel: embedded-graphics ends there.
//! - A filled sector of no angle, of which embedded-graphics draws a diameter: it is nothing.
//! - Angles whose sine and cosine in 1/1024 differ between micromath and the standard library.
//! - Whatever overflows in embedded-graphics: ellipses of more than 46340 square pixels, sectors of thousands of
//!   pixels.

mod oracle;

use std::{convert::Infallible, fmt::Debug};

use embedded_graphics::{
    Pixel,
    geometry::Angle,
    pixelcolor::Rgb565,
    prelude::*,
    primitives::{
        Arc, Circle, CornerRadii, Ellipse, Line, Polyline, PrimitiveStyle, PrimitiveStyleBuilder, Rectangle,
        RoundedRectangle, Sector, StrokeAlignment, StyledDimensions, StyledDrawable, Triangle,
    },
};
use oracle::{Rng, cases, for_each_case};
use spanfill::eg::Style;

const FILL: Rgb565 = Rgb565::RED;
const STROKE: Rgb565 = Rgb565::BLUE;

/// A picture of `SIDE` x `SIDE` pixels around the origin; what lies outside is left out.
#[derive(Clone, PartialEq, Eq)]
struct Picture {
    side: i32,
    pixels: Vec<Option<Rgb565>>,
    /// How many rectangles and single pixels it was sent: the address windows of a display.
    windows: usize,
}

impl Picture {
    fn new(side: i32) -> Self {
        Self { side, pixels: vec![None; (side * side) as usize], windows: 0 }
    }

    /// The first few pixels that differ.
    fn against(&self, other: &Self) -> String {
        let width = self.side as usize;
        let differing = self.pixels.iter().zip(&other.pixels).enumerate().filter(|(_, (a, b))| a != b);
        let places = differing.take(5).map(|(index, (a, b))| {
            let place = Point::new((index % width) as i32, (index / width) as i32) + self.bounding_box().top_left;
            format!("{place:?}: {a:?} and {b:?}")
        });
        places.collect::<Vec<_>>().join("\n")
    }

    fn rows(&self) -> String {
        let symbol = |pixel: &Option<Rgb565>| match *pixel {
            None => '.',
            Some(FILL) => 'o',
            Some(STROKE) => '#',
            Some(_) => '?',
        };
        let rows = self.pixels.chunks(self.side as usize).map(|row| row.iter().map(symbol).collect::<String>());
        let rows: Vec<String> = rows.filter(|row| row.contains(['o', '#', '?'])).collect();
        let columns =
            |row: &String| row.find(['o', '#', '?']).unwrap_or(0)..row.rfind(['o', '#', '?']).map_or(0, |end| end + 1);
        let left = rows.iter().map(|row| columns(row).start).min().unwrap_or(0);
        let right = rows.iter().map(|row| columns(row).end).max().unwrap_or(0);
        rows.iter().map(|row| &row[left..right]).collect::<Vec<_>>().join("\n")
    }
}

impl Dimensions for Picture {
    fn bounding_box(&self) -> Rectangle {
        Rectangle::new(Point::new_equal(-self.side / 2), Size::new_equal(self.side as u32))
    }
}

impl DrawTarget for Picture {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let area = self.bounding_box();
        for Pixel(point, colour) in pixels {
            if area.contains(point) {
                let place = point - area.top_left;
                self.pixels[(place.y * self.side + place.x) as usize] = Some(colour);
                self.windows += 1;
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, colour: Rgb565) -> Result<(), Infallible> {
        let windows = self.windows + usize::from(!area.intersection(&self.bounding_box()).is_zero_sized());
        let Ok(()) = self.draw_iter(area.points().map(|point| Pixel(point, colour)));
        self.windows = windows;
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colours: I,
    ) -> Result<(), Infallible> {
        let windows = self.windows + usize::from(!area.intersection(&self.bounding_box()).is_zero_sized());
        let Ok(()) = self.draw_iter(area.points().zip(colours).map(|(point, colour)| Pixel(point, colour)));
        self.windows = windows;
        Ok(())
    }
}

fn drawn<P, S>(primitive: &P, style: &S, side: i32) -> Picture
where
    P: StyledDrawable<S, Color = Rgb565>,
{
    let mut picture = Picture::new(side);
    let Ok(_) = primitive.draw_styled(style, &mut picture);
    picture
}

/// How many pixels differ.
fn difference<P>(primitive: &P, style: &PrimitiveStyle<Rgb565>, side: i32) -> (usize, Picture, Picture)
where
    P: StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565> + StyledDrawable<Style<Rgb565>, Color = Rgb565>,
{
    let theirs = drawn(primitive, style, side);
    let ours = drawn(primitive, &Style::from(*style), side);
    (theirs.pixels.iter().zip(&ours.pixels).filter(|(a, b)| a != b).count(), theirs, ours)
}

/// Holds the pixels, how many windows they take on a display, and the bounding boxes against each other.
fn check<P>(primitive: &P, style: &PrimitiveStyle<Rgb565>, side: i32) -> Result<u64, String>
where
    P: StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565>
        + StyledDrawable<Style<Rgb565>, Color = Rgb565>
        + StyledDimensions<PrimitiveStyle<Rgb565>>
        + StyledDimensions<Style<Rgb565>>
        + Debug,
{
    check_within(primitive, style, side, 0)
}

/// The same, with as many windows as that where embedded-graphics has fewer.
fn check_within<P>(primitive: &P, style: &PrimitiveStyle<Rgb565>, side: i32, most_windows: usize) -> Result<u64, String>
where
    P: StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565>
        + StyledDrawable<Style<Rgb565>, Color = Rgb565>
        + StyledDimensions<PrimitiveStyle<Rgb565>>
        + StyledDimensions<Style<Rgb565>>
        + Debug,
{
    let (pixels, theirs, ours) = difference(primitive, style, side);
    if pixels > 0 {
        return Err(format!(
            "{pixels} pixels differ: {primitive:?}, {style:?}\n{}\nembedded-graphics:\n{}\nspanfill:\n{}",
            theirs.against(&ours),
            theirs.rows(),
            ours.rows()
        ));
    }
    if ours.windows > most_windows.max(theirs.windows) {
        return Err(format!("{} windows in place of {}: {primitive:?}, {style:?}", ours.windows, theirs.windows));
    }
    let (theirs, ours) = (primitive.styled_bounding_box(style), primitive.styled_bounding_box(&Style::from(*style)));
    if theirs != ours && !(theirs.is_zero_sized() && ours.is_zero_sized()) {
        return Err(format!("{ours:?} in place of {theirs:?}: {primitive:?}, {style:?}"));
    }
    Ok(1)
}

/// Fill, stroke, and both; thin and wide; on each side.
fn styles() -> Vec<PrimitiveStyle<Rgb565>> {
    let mut styles = vec![PrimitiveStyle::new(), PrimitiveStyle::with_fill(FILL)];
    for width in [0, 1, 2, 3, 5, 8, 40] {
        for alignment in [StrokeAlignment::Inside, StrokeAlignment::Center, StrokeAlignment::Outside] {
            let sized = PrimitiveStyleBuilder::new().stroke_width(width).stroke_alignment(alignment);
            styles.push(sized.fill_color(FILL).build());
            styles.push(sized.stroke_color(STROKE).build());
            styles.push(sized.fill_color(FILL).stroke_color(STROKE).build());
        }
    }
    styles
}

fn all<P>(primitives: impl Iterator<Item = P>, styles: &[PrimitiveStyle<Rgb565>], side: i32) -> u64
where
    P: StyledDrawable<PrimitiveStyle<Rgb565>, Color = Rgb565>
        + StyledDrawable<Style<Rgb565>, Color = Rgb565>
        + StyledDimensions<PrimitiveStyle<Rgb565>>
        + StyledDimensions<Style<Rgb565>>
        + Debug,
{
    let checks = primitives.flat_map(|primitive| {
        styles
            .iter()
            .map(move |style| check(&primitive, style, side).unwrap_or_else(|message| panic!("{message}")))
            .collect::<Vec<_>>()
    });
    checks.sum()
}

fn place(rng: &mut Rng, reach: i64) -> Point {
    Point::new(rng.int(-reach..=reach) as i32, rng.int(-reach..=reach) as i32)
}

fn size(rng: &mut Rng, most: i64) -> Size {
    Size::new(rng.int(0..=most) as u32, rng.int(0..=most) as u32)
}

#[test]
fn circles() {
    let circles = (0..=140).map(|diameter| Circle::with_center(Point::new(1, -2), diameter));
    assert!(all(circles, &styles(), 240) > 5000);
    let large = [300, 511, 512, 999].map(|diameter| Circle::with_center(Point::zero(), diameter));
    all(large.into_iter(), &styles()[..12], 1020);
}

#[test]
fn ellipses() {
    let styles = styles();
    let mut checked = 0;
    let mut left_out = 0;
    for (width, height) in (0..40).flat_map(|width| (0..40).map(move |height| (width, height))) {
        let ellipse = Ellipse::with_center(Point::zero(), Size::new(width, height));
        for style in &styles {
            if ends_at_once(&ellipse, style) {
                left_out += 1;
            } else {
                checked += check(&ellipse, style, 124).unwrap_or_else(|message| panic!("{message}"));
            }
        }
    }
    assert!(checked > 90_000 && left_out < 6000, "{checked}, {left_out}");
    // No more: the threshold of embedded-graphics leaves 32 bits.
    let large = [Size::new(190, 100), Size::new(60, 250), Size::new(250, 1)];
    all(large.into_iter().map(|size| Ellipse::with_center(Point::zero(), size)), &styles[..8], 256);
}

/// The first row has no pixel, as an ellipse of two columns and eight rows: embedded-graphics then draws none at all.
fn ends_at_once(ellipse: &Ellipse, style: &PrimitiveStyle<Rgb565>) -> bool {
    let styled = ellipse.into_styled(*style);
    let has_stroke = style.stroke_color.is_some() && style.stroke_width > 0;
    let area = if has_stroke { styled.stroke_area() } else { styled.fill_area() };
    let Size { width, height } = area.size;
    let column = area.top_left.x + (width as i32 - 1) / 2;
    height > 0 && !area.contains(Point::new(column, area.top_left.y))
}

#[test]
fn ellipses_keep_what_is_below_an_empty_row() {
    let narrow = Ellipse::new(Point::new(-1, -4), Size::new(2, 8));
    let (pixels, theirs, ours) = difference(&narrow, &PrimitiveStyle::with_fill(FILL), 10);
    assert_eq!((pixels, theirs.rows().as_str(), ours.rows().as_str()), (12, "", "oo\noo\noo\noo\noo\noo"));
}

#[test]
fn rectangles() {
    let sizes = (0..24).flat_map(|width| (0..24).map(move |height| Size::new(width, height)));
    assert!(all(sizes.map(|size| Rectangle::new(Point::new(-9, -7), size)), &styles(), 130) > 10_000);
}

#[test]
fn rounded_rectangles() {
    let styles = styles();
    let checked = for_each_case(210, cases(20_000), |rng| {
        let corners = CornerRadii {
            top_left: size(rng, 20),
            top_right: size(rng, 20),
            bottom_right: size(rng, 20),
            bottom_left: size(rng, 20),
        };
        let corners = if rng.one_in(2) { CornerRadii::new(size(rng, 12)) } else { corners };
        let shape = RoundedRectangle::new(Rectangle::new(place(rng, 20), size(rng, 50)), corners);
        let style = rng.pick(&styles);
        if is_collapsed(&shape, &style) { Ok(0) } else { check(&shape, &style, 200) }
    });
    assert!(checked > 0);
}

/// Some row inside the stroke has no pixel to fill: embedded-graphics fills all of that row.
fn is_collapsed(shape: &RoundedRectangle, style: &PrimitiveStyle<Rgb565>) -> bool {
    let inside = shape.into_styled(*style).fill_area();
    if overlap(&inside) || overlap(&shape.into_styled(*style).stroke_area()) {
        return true;
    }
    let Rectangle { top_left, size } = inside.rectangle;
    let columns = top_left.x..top_left.x + size.width as i32;
    let mut rows = top_left.y..top_left.y + size.height as i32;
    style.stroke_color.is_some()
        && rows.any(|row| !columns.clone().any(|column| inside.contains(Point::new(column, row))))
}

/// Corners that meet: embedded-graphics scales all by what the worst side needs, which may not be enough for another
/// side, and does not look at opposite corners.
fn overlap(shape: &RoundedRectangle) -> bool {
    let RoundedRectangle { rectangle: Rectangle { size, .. }, corners } = shape.confine_radii();
    let CornerRadii { top_left, top_right, bottom_right, bottom_left } = corners;
    top_left.width + top_right.width > size.width
        || bottom_left.width + bottom_right.width > size.width
        || top_left.height + bottom_left.height > size.height
        || top_right.height + bottom_right.height > size.height
        || (top_left.width + bottom_right.width > size.width && top_left.height + bottom_right.height > size.height)
        || (top_right.width + bottom_left.width > size.width && top_right.height + bottom_left.height > size.height)
}

#[test]
fn lines() {
    let ends = (-12..=12).flat_map(|x| (-12..=12).map(move |y| Point::new(x, y)));
    let style = [PrimitiveStyle::with_stroke(STROKE, 1), PrimitiveStyle::with_stroke(STROKE, 0)];
    assert!(all(ends.map(|end| Line::new(Point::new(2, -1), end)), &style, 40) > 1000);
    let checked = for_each_case(211, cases(20_000), |rng| {
        check(&Line::new(place(rng, 400), place(rng, 400)), &PrimitiveStyle::with_stroke(STROKE, 1), 300)
    });
    assert!(checked > 0);
}

#[test]
fn polylines() {
    let checked = for_each_case(212, cases(10_000), |rng| {
        let points: Vec<Point> = (0..rng.index(8)).map(|_| place(rng, 40)).collect();
        let polyline = Polyline::new(&points).translate(place(rng, 10));
        check(&polyline, &PrimitiveStyle::with_stroke(STROKE, 1), 120)
    });
    assert!(checked > 0);
}

/// Sides are lines of a run a row, or a column where they are steep, and the fill below them is a block a row. embedded-graphics
/// looks for the ends of each row instead: where sides run beside each other, one window does there for two or three here.
/// Of triangles within 80 pixels that is a quarter; on average, these have 82 windows where embedded-graphics has 108, as steep
/// sides are sent column by column. To join runs that meet, the three sides would have to be stepped side by side, row
/// by row, and steep ones be cut at every row.
#[test]
fn triangles_with_a_thin_stroke() {
    let sized = PrimitiveStyleBuilder::new().stroke_width(1).stroke_color(STROKE);
    let checked = for_each_case(213, cases(20_000), |rng| {
        let reach = rng.pick(&[3, 10, 40]);
        let triangle = Triangle::new(place(rng, reach), place(rng, reach), place(rng, reach));
        // The longest side meets every row, and the others one row more together.
        let rows = triangle.bounding_box().size.height as usize;
        let (style, most) =
            if rng.one_in(2) { (sized.fill_color(FILL).build(), 3 * rows) } else { (sized.build(), 2 * rows + 1) };
        check_within(&triangle, &style, 100, most)
    });
    assert!(checked > 0);
}

/// Whether the sine and cosine in 1/1024 are the same by micromath and by the standard library. embedded-graphics takes
/// them from the one or the other: from the latter if anything that it depends on was built with the standard library.
fn is_certain(angle: Angle) -> bool {
    let radians = angle.to_radians();
    let exact = [radians.cos(), radians.sin()];
    let approximate = [micromath::F32Ext::cos(radians), micromath::F32Ext::sin(radians)];
    exact.map(|value| (value * 1024.0) as i32) == approximate.map(|value| (value * 1024.0) as i32)
}

#[test]
fn arcs_and_sectors() {
    let styles = styles();
    let checked = for_each_case(214, cases(30_000), |rng| {
        let angle = |rng: &mut Rng| match rng.index(3) {
            0 => (90.0 * rng.int(-5..=5) as f32).deg(),
            1 => (5.0 * rng.int(-80..=80) as f32).deg(),
            _ => (rng.int(-4000..=4000) as f32 / 10.0).deg(),
        };
        let (top_left, diameter) = (place(rng, 30), rng.int(0..=80) as u32);
        let (start, sweep) = (angle(rng), angle(rng));
        let middle = start + Angle::from_radians(sweep.to_radians() / 2.0);
        let quarter = Angle::from_radians(std::f32::consts::FRAC_PI_2);
        if ![start, start + sweep, middle - quarter, middle + quarter].into_iter().all(is_certain) {
            return Ok(0);
        }
        check(&Arc::new(top_left, diameter, start, sweep), &rng.pick(&styles), 240)?;
        if sweep == Angle::zero() {
            return Ok(0);
        }
        check(&Sector::new(top_left, diameter, start, sweep), &rng.pick(&styles), 240)
    });
    assert!(checked > 0);
}
