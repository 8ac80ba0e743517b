//! The chart of speed and accuracy: what a shape costs, and how far its worst pixel is from the exact area.

use plotters::{
    coord::Shift,
    prelude::*,
    style::text_anchor::{HPos, Pos, VPos},
};

use crate::{
    row::{Rows, Unit},
    scenes::Scene,
    variant::Variant,
};

const SPANFILL: RGBColor = RGBColor(0x0b, 0x6e, 0x4f);
const PEER: RGBColor = RGBColor(0x4a, 0x7a, 0xb5);

/// A mark for each of these, of those that were measured.
const MARKS: [(Variant, &str, RGBColor, Ends); 11] = [
    (Variant::Aliased, "spanfill, aliased", SPANFILL, Ends::Picture),
    (Variant::Samples4, "spanfill, 4x4 samples", SPANFILL, Ends::Picture),
    (Variant::SamplesWeighted, "spanfill, weighted", SPANFILL, Ends::Picture),
    (Variant::Samples16, "spanfill, 16x16 samples", SPANFILL, Ends::Picture),
    (Variant::AntiAliased, "spanfill", SPANFILL, Ends::Picture),
    (Variant::Mask, "spanfill, mask", SPANFILL, Ends::Mask),
    (Variant::TinySkiaAntiAliased, "tiny-skia", PEER, Ends::Picture),
    (Variant::Vello, "vello_cpu", PEER, Ends::Picture),
    (Variant::VelloAlone, "vello_cpu, one by one", PEER, Ends::Picture),
    (Variant::Zeno, "zeno", PEER, Ends::Mask),
    (Variant::AbGlyph, "ab_glyph_rasterizer", PEER, Ends::Mask),
];

/// Where a library's work ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Ends {
    Picture,
    Mask,
}

/// What is averaged: the simple outlines without curves. Curves are flattened before they are filled, by whatever
/// tolerance a library has; and where an outline crosses itself within a pixel, adding up areas is off by 50 255ths.
const SCENES: [Scene; 4] = [Scene::Triangles(10), Scene::Triangles(50), Scene::Triangles(200), Scene::Concave64(100)];

const WIDTH: i32 = 900;
const HEIGHT: i32 = 520;
const LEFT: i32 = 80;
const RIGHT: i32 = 40;
const TOP: i32 = 100;
const BOTTOM: i32 = 76;
const RADIUS: i32 = 6;

const INK: RGBColor = RGBColor(0x22, 0x26, 0x2b);
const PALE: RGBColor = RGBColor(0x6b, 0x72, 0x7b);
const GRID: RGBColor = RGBColor(0xdd, 0xe0, 0xe4);

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn std::error::Error>>;

/// The chart as SVG.
pub(crate) fn svg(rows: &Rows) -> Result<String, Box<dyn std::error::Error>> {
    let scenes: Vec<Scene> =
        SCENES.into_iter().filter(|scene| rows.scenes().any(|measured| measured == *scene)).collect();
    let marks: Vec<Mark> = MARKS.into_iter().filter_map(|mark| Mark::new(rows, &scenes, mark)).collect();
    if marks.is_empty() {
        return Err("there is nothing to draw the chart of accuracy from".into());
    }
    let extremes = |value: fn(&Mark) -> f64| {
        let values = || marks.iter().map(value);
        (values().fold(f64::INFINITY, f64::min), values().fold(0.0, f64::max))
    };
    let ((least, most), (_, worst)) = (extremes(|mark| mark.cost), extremes(|mark| mark.error));
    let across = Axis { low: least / 1.3, high: most * 1.6, from: LEFT, to: WIDTH - RIGHT };
    let up = Axis { low: 0.15, high: worst.max(1.0) * 1.5, from: HEIGHT - BOTTOM, to: TOP };
    let mut svg = String::new();
    {
        let size = (WIDTH.unsigned_abs(), HEIGHT.unsigned_abs());
        let canvas = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        canvas.fill(&WHITE)?;
        draw_head(&canvas, scenes.len())?;
        draw_grid(&canvas, across, up, rows.unit)?;
        draw_marks(&canvas, across, up, &marks)?;
        canvas.present()?;
    }
    Ok(svg)
}

#[derive(Debug, Clone, Copy)]
struct Mark {
    name: &'static str,
    colour: RGBColor,
    ends: Ends,
    /// The geometric mean over the scenes.
    cost: f64,
    /// The largest in any scene.
    error: f64,
}

impl Mark {
    fn new(
        rows: &Rows,
        scenes: &[Scene],
        (variant, name, colour, ends): (Variant, &'static str, RGBColor, Ends),
    ) -> Option<Self> {
        let measured: Option<Vec<_>> = scenes.iter().map(|&scene| rows.get(scene, variant)).collect();
        let measured = measured.filter(|measured| !measured.is_empty())?;
        let logarithms: f64 = measured.iter().map(|row| row.cost.ln()).sum();
        let error = measured.iter().map(|row| row.difference.max).fold(0.0, f64::max);
        Some(Self { name, colour, ends, cost: (logarithms / measured.len() as f64).exp(), error })
    }
}

/// Logarithmic.
#[derive(Debug, Clone, Copy)]
struct Axis {
    low: f64,
    high: f64,
    from: i32,
    to: i32,
}

impl Axis {
    fn at(self, value: f64) -> i32 {
        let share = (value.max(self.low) / self.low).ln() / (self.high / self.low).ln();
        self.from + (share * f64::from(self.to - self.from)).round() as i32
    }

    /// 1, 2 and 5 times the powers of ten, and a half.
    fn grid(self) -> impl Iterator<Item = f64> {
        let decades = (-1..=9).map(|power| 10.0_f64.powi(power));
        let values = decades.flat_map(|decade| [decade, 2.0 * decade, 5.0 * decade]);
        values.filter(move |value| (self.low..=self.high).contains(value))
    }
}

fn text(size: i32, colour: RGBColor, horizontal: HPos) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&colour).pos(Pos::new(horizontal, VPos::Center))
}

fn draw_head(canvas: &Canvas<'_>, scenes: usize) -> Drawn {
    let title = "What an anti-aliased shape costs, and its worst pixel";
    canvas.draw(&Text::new(title, (20, 26), text(23, INK, HPos::Left)))?;
    let mut x = 20 + RADIUS;
    for (name, ends) in [("blended into a picture", Ends::Picture), ("a mask, not yet blended", Ends::Mask)] {
        draw_mark(canvas, (x, 58), INK, ends)?;
        canvas.draw(&Text::new(name, (x + 14, 57), text(16, INK, HPos::Left)))?;
        x += 220;
    }
    let note = format!("triangles, 64-gon: the mean of {scenes} scenes; best at the bottom left");
    canvas.draw(&Text::new(note, (x, 58), text(15, PALE, HPos::Left)))?;
    Ok(())
}

fn draw_grid(canvas: &Canvas<'_>, across: Axis, up: Axis, unit: Unit) -> Drawn {
    for value in across.grid() {
        let x = across.at(value);
        canvas.draw(&PathElement::new([(x, up.to), (x, up.from)], GRID))?;
        canvas.draw(&Text::new(format!("{value}"), (x, up.from + 14), text(15, PALE, HPos::Center)))?;
    }
    for value in up.grid() {
        let y = up.at(value);
        canvas.draw(&PathElement::new([(across.from, y), (across.to, y)], GRID))?;
        canvas.draw(&Text::new(format!("{value}"), (across.from - 8, y), text(15, PALE, HPos::Right)))?;
    }
    let name = match unit {
        Unit::Nanoseconds => "nanoseconds a shape (logarithmic)",
        Unit::Instructions => "instructions a shape (logarithmic)",
    };
    canvas.draw(&Text::new(name, ((across.from + across.to) / 2, up.from + 40), text(16, INK, HPos::Center)))?;
    let name = "largest error of a pixel, in 255ths of the exact area (logarithmic)";
    canvas.draw(&Text::new(name, (20, up.to - 12), text(15, PALE, HPos::Left)))?;
    Ok(())
}

fn draw_mark(canvas: &Canvas<'_>, centre: (i32, i32), colour: RGBColor, ends: Ends) -> Drawn {
    match ends {
        Ends::Picture => canvas.draw(&Circle::new(centre, RADIUS, colour.filled()))?,
        Ends::Mask => canvas.draw(&Circle::new(centre, RADIUS - 1, colour.stroke_width(2)))?,
    }
    Ok(())
}

/// Each name goes to the first place around its mark where it covers nothing; a line leads to those that are farther.
fn draw_marks(canvas: &Canvas<'_>, across: Axis, up: Axis, marks: &[Mark]) -> Drawn {
    let centre = |mark: &Mark| (across.at(mark.cost), up.at(mark.error));
    let around_mark = |mark: &Mark| Area::around(centre(mark), RADIUS + 1, RADIUS + 1);
    let mut taken: Vec<Area> = marks.iter().map(around_mark).collect();
    let mut labels = Vec::new();
    for mark in marks {
        let (x, y) = centre(mark);
        // In the widest of the usual fonts.
        let half_width = i32::try_from(mark.name.len()).unwrap_or(0) * 7 / 2;
        let area = |label: &Label| {
            let (x, y) = label.at;
            let centre = match label.starts {
                HPos::Left => (x + half_width, y),
                HPos::Center => (x, y),
                HPos::Right => (x - half_width, y),
            };
            Area::around(centre, half_width, TEXT_HEIGHT / 2)
        };
        let fits = |label: &Label| {
            let area = area(label);
            let is_inside =
                area.left > across.from && area.right < across.to && area.top > up.to && area.bottom < up.from;
            is_inside && taken.iter().all(|other| !area.overlaps(*other))
        };
        let label = Label::places((x, y)).find(fits).unwrap_or_else(|| Label::beside((x, y)));
        taken.push(area(&label));
        labels.push(label);
    }
    for (mark, label) in marks.iter().zip(&labels) {
        if label.is_far {
            canvas.draw(&PathElement::new([centre(mark), (label.at.0, label.at.1 + label.towards)], mark.colour))?;
        }
    }
    for (mark, label) in marks.iter().zip(&labels) {
        canvas.draw(&Text::new(mark.name, label.at, text(16, mark.colour, label.starts)))?;
        draw_mark(canvas, centre(mark), mark.colour, mark.ends)?;
    }
    Ok(())
}

const TEXT_HEIGHT: i32 = 18;

/// Where a mark's name may be.
#[derive(Clone, Copy)]
struct Label {
    at: (i32, i32),
    starts: HPos,
    is_far: bool,
    /// From the middle of its height to the side where the mark is.
    towards: i32,
}

impl Label {
    fn beside((x, y): (i32, i32)) -> Self {
        Self { at: (x + RADIUS + 6, y), starts: HPos::Left, is_far: false, towards: 0 }
    }

    fn places((x, y): (i32, i32)) -> impl Iterator<Item = Self> {
        let left = Self { at: (x - RADIUS - 6, y), starts: HPos::Right, is_far: false, towards: 0 };
        let near = RADIUS + TEXT_HEIGHT / 2 + 2;
        let aligned = move |starts, distance: i32| Self {
            at: (x, y + distance),
            starts,
            is_far: distance.abs() > near,
            towards: -distance.signum() * TEXT_HEIGHT / 2,
        };
        let above_and_below =
            (0..5).map(move |step| near + step * TEXT_HEIGHT).flat_map(|distance| [-distance, distance]);
        let rest = above_and_below
            .flat_map(move |distance| [HPos::Center, HPos::Left, HPos::Right].map(|starts| aligned(starts, distance)));
        [Self::beside((x, y)), left].into_iter().chain(rest)
    }
}

#[derive(Debug, Clone, Copy)]
struct Area {
    left: i32,
    top: i32,
    right: i32,
    bottom: i32,
}

impl Area {
    fn around((x, y): (i32, i32), half_width: i32, half_height: i32) -> Self {
        Self { left: x - half_width, top: y - half_height, right: x + half_width, bottom: y + half_height }
    }

    fn overlaps(self, other: Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }
}
