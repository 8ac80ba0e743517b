//! What must hold of every case.

use std::{
    fmt,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::atomic::{AtomicU64, Ordering},
};

use embedded_graphics::{
    image::GetPixel,
    pixelcolor::{Gray8, Rgb565, Rgb888, raw::RawData},
    prelude::*,
};
use spanfill::{Blend, Circle, CoverageEdge, FillRule, InPlace, Linear, Mix, MixLinear, ReadBack, Shape, prelude::*};

use crate::{
    areas::{self, Areas},
    case::{Case, Figure, Size},
    memory::Memory,
    oracle::{self, Belongs, HasArea, Tolerance, Worst},
    picture::Picture,
    shrink::shrunk,
};

/// What a case is held against: a function of bytes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Target {
    /// Small shapes, anti-aliased: each pixel's coverage is the exact area, rounded once.
    Areas,
    /// Shapes of up to two hundred edges, anti-aliased: the same in any clip and with any scratch, and an error with too
    /// little.
    Clips,
    /// Shapes blended in a target's memory are those that are read back and blended pixel by pixel.
    Blends,
    /// Shapes without anti-aliasing: no pixel is wrong, as spans and as blocks, whole and in parts.
    Pixels,
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Areas => "areas",
            Self::Clips => "clips",
            Self::Blends => "blends",
            Self::Pixels => "pixels",
        })
    }
}

impl Target {
    /// All of them.
    pub const ALL: [Self; 4] = [Self::Areas, Self::Clips, Self::Blends, Self::Pixels];

    /// Makes a case of the bytes and checks it. `Ok` says whether it showed an outline; an error is what is wrong, as short
    /// as it could be made, and the shape as Rust code.
    ///
    /// # Errors
    ///
    /// What is wrong.
    pub fn check(self, bytes: &[u8]) -> Result<bool, String> {
        // Large ones take a hundred times as long, and are seen less often.
        let (first, bytes) = bytes.split_first().unwrap_or((&1, &[]));
        let is_large = self != Self::Areas && *first == 0;
        let case = Case::decode(bytes, if is_large { Size::Any } else { Size::Small });
        let failing = match self.outcome(&case) {
            Ok(is_mixed) => return Ok(is_mixed),
            Err(message) => message,
        };
        let smallest = shrunk(case.clone(), |case| self.outcome(case).is_err());
        let message = self.outcome(&smallest).err().unwrap_or(failing);
        Err(format!("{message}\n\n{}\n\nas it was found:\n{}", smallest.code(), case.code()))
    }

    /// For libFuzzer.
    ///
    /// # Panics
    ///
    /// Where something is wrong.
    pub fn run(self, bytes: &[u8]) {
        if let Err(message) = self.check(bytes) {
            panic!("{self}: {message}");
        }
    }

    /// A panic is an error, too.
    fn outcome(self, case: &Case) -> Result<bool, String> {
        let check = match self {
            Self::Areas => check_areas,
            Self::Clips => check_clips,
            Self::Blends => check_blends,
            Self::Pixels => check_pixels,
        };
        catch_unwind(AssertUnwindSafe(|| check(case)))
            .unwrap_or_else(|panic| Err(format!("panicked: {}", oracle::random::panic_message(&*panic))))
    }
}

/// The greatest errors that were met, in 255ths: of outlines and triangles, lines, circles.
static WORST: [AtomicU64; 3] = [const { AtomicU64::new(0) }; 3];

/// The greatest errors that were met, in 255ths, each with what it was met in.
pub fn worst() -> [(&'static str, f64); 3] {
    let [outlines, lines, circles] = &WORST;
    [("outlines", outlines), ("lines", lines), ("circles", circles)]
        .map(|(name, worst)| (name, f64::from_bits(worst.load(Ordering::Relaxed))))
}

/// 0.5 by rounding, 0.1 by chords, and what lengths of 2^-16 px lose; the most that was seen is 0.5965.
const CIRCLES: Tolerance = Tolerance { few: 0.61, many: 0.61 };

/// Every so manieth case is held against the slow, exact oracle, too, and sent in eights.
const EXACTLY: usize = 256;

fn check_areas(case: &Case) -> Result<bool, String> {
    let drawn = whole(case)?;
    let window = &case.window;
    let (columns, rows) = (window.columns.len(), window.rows.len());
    let (kind, tolerance) = match &case.figure {
        Figure::Outline(_) | Figure::Triangle(_) => (0, Tolerance::EXACT),
        Figure::Line(_) => (1, Tolerance::EXACT),
        Figure::Circle(_) => (2, CIRCLES),
    };
    let mut all = Areas::new(FillRule::NonZero);
    let relative = |vertex| Areas::relative(vertex, window.columns.start, window.rows.start);
    match &case.figure {
        Figure::Outline(outline) => {
            all = Areas::new(outline.fill_rule);
            outline.contours.iter().for_each(|contour| all.add_contour(contour.iter().map(|v| relative(*v))));
        }
        Figure::Triangle(triangle) => all.add_contour(triangle.vertices.iter().map(|v| relative(*v))),
        Figure::Line(line) => {
            let (a, b) = (relative(line.start), relative(line.end));
            let (dx, dy) = (b.0 - a.0, b.1 - a.1);
            let length = dx.hypot(dy).max(f64::MIN_POSITIVE);
            let (x, y) = (-dy / length / 2.0, dx / length / 2.0);
            all.add_contour(
                [(a.0 + x, a.1 + y), (b.0 + x, b.1 + y), (b.0 - x, b.1 - y), (a.0 - x, a.1 - y)].into_iter(),
            );
        }
        Figure::Circle(_) => {}
    }
    let mut areas = vec![0.0; columns];
    let mut worst = 0.0_f64;
    for (row, pixels) in (0..rows).zip(drawn.rows()) {
        match &case.figure {
            Figure::Circle(circle) => disc(circle, window.rows.start + row as i32, window.columns.start, &mut areas),
            _ => _ = all.row(row as f64, &mut areas),
        }
        for (coverage, area) in pixels.iter().zip(&areas) {
            worst = worst.max((f64::from(*coverage) - 255.0 * area).abs());
        }
    }
    // Of two numbers that are not negative, the greater one has the greater bits.
    WORST[kind].fetch_max(worst.to_bits(), Ordering::Relaxed);
    let is_wrong = worst > tolerance.few + 255.0 * areas::ERROR;
    if is_wrong || case.column as usize % EXACTLY == case.row as usize % EXACTLY {
        exactly(case, tolerance)?;
    }
    if is_wrong { Err(format!("off by {worst:.4}, and not by the exact oracle")) } else { Ok(drawn.is_mixed()) }
}

/// By the oracle of the tests.
fn exactly(case: &Case, tolerance: Tolerance) -> Result<bool, String> {
    let worst = Worst::new();
    match &case.figure {
        Figure::Outline(outline) => oracle::check_coverage(outline, &case.window, tolerance, &worst),
        Figure::Triangle(triangle) => oracle::check_coverage(triangle, &case.window, tolerance, &worst),
        Figure::Line(line) => oracle::check_coverage(line, &case.window, tolerance, &worst),
        Figure::Circle(circle) => oracle::check_coverage(circle, &case.window, tolerance, &worst),
    }
}

/// The areas of a disc: by the oracle of the tests where its rim is.
fn disc(circle: &Circle, row: i32, first: i32, areas: &mut [f64]) {
    let radius = i64::from(circle.radius.to_bits());
    let (x, y) = (i64::from(circle.center.x.to_bits()), i64::from(circle.center.y.to_bits()));
    let square = |distance: i64| i128::from(distance) * i128::from(distance);
    // How far a pixel's nearest and farthest points are, in one direction.
    let reach = |pixel: i32, center: i64| {
        let (start, end) = (256 * i64::from(pixel) - center, 256 * i64::from(pixel) + 256 - center);
        (start.max(0) + (-end).max(0), end.abs().max(start.abs()))
    };
    let (near_y, far_y) = reach(row, y);
    for (area, column) in areas.iter_mut().zip(first..) {
        let (near_x, far_x) = reach(column, x);
        *area = if radius <= 0 || square(near_x) + square(near_y) >= square(radius) {
            0.0
        } else if square(far_x) + square(far_y) <= square(radius) {
            1.0
        } else {
            circle.areas_in_row(row, &(column..column + 1))[0].value
        };
    }
}

/// Drawn at once, in as much scratch as it asks for.
fn whole(case: &Case) -> Result<Picture, String> {
    let mut picture = Picture::new(&case.window);
    case.figure.cover(0, &case.window, &mut picture.part(&case.window))?;
    Ok(picture)
}

fn check_clips(case: &Case) -> Result<bool, String> {
    let expected = whole(case)?;
    let mut drawn = Picture::new(&case.window);
    for (index, part) in case.parts().iter().enumerate() {
        case.figure.cover(case.more * index, part, &mut drawn.part(part))?;
    }
    if let Some(difference) = expected.difference(&drawn) {
        return Err(format!("whole and in parts: {difference}"));
    }
    case.figure.check_refusals()?;
    Ok(expected.is_mixed())
}

/// Colours that differ in all their bits.
fn raw<C: PixelColor + From<C::Raw>>(number: u32) -> C {
    C::from(C::Raw::from_u32(number.wrapping_mul(0x9E37_79B9).rotate_left(13) ^ number))
}

fn check_blends(case: &Case) -> Result<bool, String> {
    match case.more {
        0..=4 => check_blends_of::<Rgb565>(case),
        5..=7 => check_blends_of::<Rgb888>(case),
        _ => check_blends_of::<Gray8>(case),
    }
}

fn check_blends_of<C: PixelColor + From<C::Raw> + Mix + MixLinear>(case: &Case) -> Result<bool, String> {
    let before = Memory::new(case.window.clone().into(), raw::<C>);
    let (in_place, read_back) = (blended(case, &before, InPlace), blended(case, &before, ReadBack));
    if in_place != read_back {
        return Err("InPlace and ReadBack draw different pixels".to_owned());
    }
    if case.more.is_multiple_of(4) {
        let (in_place, read_back) = (blended(case, &before, Linear(InPlace)), blended(case, &before, Linear(ReadBack)));
        if in_place != read_back {
            return Err("Linear(InPlace) and Linear(ReadBack) draw different pixels".to_owned());
        }
    }
    Ok(in_place != before)
}

fn blended<C, B>(case: &Case, before: &Memory<C>, blend: B) -> Memory<C>
where
    C: PixelColor + From<C::Raw>,
    B: Blend<Memory<C>>,
    Memory<C>: GetPixel,
{
    let mut memory = before.clone();
    let colour = raw::<C>(case.opacity.into());
    macro_rules! draw {
        ($shape:expr) => {{
            let Ok(()) = $shape.antialiased(colour, blend).opacity(case.opacity).draw_on(&mut memory);
        }};
    }
    match &case.figure {
        Figure::Outline(outline) => outline.with_polygon(|polygon| {
            let mut edges = vec![CoverageEdge::EMPTY; polygon.coverage_edges() + case.more];
            draw!(polygon.coverage_in(&mut edges).expect("more than it asks for"));
        }),
        Figure::Triangle(triangle) => draw!(triangle),
        Figure::Line(line) => draw!(line),
        Figure::Circle(circle) => draw!(circle),
    }
    memory
}

fn check_pixels(case: &Case) -> Result<bool, String> {
    match &case.figure {
        Figure::Outline(outline) => check_pixels_of(outline, case),
        Figure::Triangle(triangle) => check_pixels_of(triangle, case),
        Figure::Line(line) => check_pixels_of(line, case),
        Figure::Circle(circle) => check_pixels_of(circle, case),
    }
}

fn check_pixels_of(shape: &(impl Shape + Belongs), case: &Case) -> Result<bool, String> {
    let is_mixed = oracle::check_exact(shape, &case.window)?;
    if case.more == 0 {
        let whole = oracle::span_pixels(shape, &case.window);
        if oracle::block_pixels(shape, &case.window) != whole {
            return Err("blocks and spans draw different pixels".to_owned());
        }
    }
    if case.more % 4 == 1 {
        for part in case.parts() {
            oracle::check_exact(shape, &part)?;
        }
    }
    Ok(is_mixed)
}
