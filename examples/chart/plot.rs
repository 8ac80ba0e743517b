//! A chart of cost against error: log scales, zero in a band of its own, the Pareto front, curves of options that are numbers.

use plotters::{
    coord::Shift,
    prelude::*,
    style::text_anchor::{HPos, Pos, VPos},
};

use crate::labels::Labels;

/// A method with an option, measured.
#[derive(Debug, Clone)]
pub(crate) struct Mark {
    pub(crate) method: String,
    pub(crate) option: String,
    pub(crate) cost: f64,
    pub(crate) error: f64,
    pub(crate) is_shipped: bool,
}

/// A chart but for its marks.
#[derive(Debug, Clone)]
pub(crate) struct Frame {
    pub(crate) title: String,
    pub(crate) note: String,
    pub(crate) cost: &'static str,
    pub(crate) error: &'static str,
    /// What the band of zero is called.
    pub(crate) zero: &'static str,
}

pub(crate) const WIDTH: i32 = 1180;
const LEFT: i32 = 84;
const RIGHT: i32 = 250;
const TOP: i32 = 84;
const BOTTOM: i32 = 64;
/// A mark in the band of zero has a row of its own.
const ROW: i32 = 16;
const RADIUS: i32 = 5;
const TEXT: i32 = 12;

const INK: RGBColor = RGBColor(0x22, 0x26, 0x2b);
const PALE: RGBColor = RGBColor(0x6b, 0x72, 0x7b);
const GRID: RGBColor = RGBColor(0xe2, 0xe5, 0xe8);
const BAND: RGBColor = RGBColor(0xf1, 0xf6, 0xf3);
const SHIPPED: RGBColor = RGBColor(0x0b, 0x6e, 0x4f);
const FRONT: RGBColor = RGBColor(0x9c, 0xc3, 0xb3);
const COLOURS: [RGBColor; 9] = [
    RGBColor(0x2f, 0x6f, 0xb0),
    RGBColor(0xc0, 0x5a, 0x12),
    RGBColor(0x7a, 0x4a, 0xa8),
    RGBColor(0xb0, 0x2a, 0x4b),
    RGBColor(0x2b, 0x7f, 0x8c),
    RGBColor(0x8a, 0x6d, 0x0b),
    RGBColor(0x56, 0x5f, 0x6a),
    RGBColor(0x9b, 0x4f, 0x8f),
    RGBColor(0x3f, 0x7d, 0x34),
];

type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;
type Drawn = Result<(), Box<dyn std::error::Error>>;

/// The chart as SVG.
pub(crate) fn svg(frame: &Frame, marks: &[Mark]) -> Result<String, Box<dyn std::error::Error>> {
    let plot = Plot::new(marks);
    let height = plot.bottom + BOTTOM;
    let mut svg = String::new();
    {
        let size = (WIDTH.unsigned_abs(), height.unsigned_abs());
        let canvas = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        canvas.fill(&WHITE)?;
        plot.draw_grid(&canvas, frame)?;
        plot.draw_front(&canvas, marks)?;
        plot.draw_curves(&canvas, marks)?;
        plot.draw_marks(&canvas, marks)?;
        canvas.present()?;
    }
    Ok(svg)
}

/// Where things are.
struct Plot {
    across: Axis,
    up: Option<Axis>,
    /// The band of zero lies below the rest.
    band: (i32, i32),
    bottom: i32,
    at: Vec<(i32, i32)>,
    colours: Vec<RGBColor>,
}

impl Plot {
    fn new(marks: &[Mark]) -> Self {
        let costs = || marks.iter().map(|mark| mark.cost);
        let (least, most) = (costs().fold(f64::INFINITY, f64::min), costs().fold(0.0, f64::max));
        let across = Axis::new(least, most, LEFT + 12, WIDTH - RIGHT);
        let errors = || marks.iter().map(|mark| mark.error).filter(|error| *error > 0.0);
        let some = errors().count() as i32;
        let height = if some == 0 { 0 } else { (some * 26).clamp(300, 760) };
        let up = (some > 0).then(|| {
            Axis::new(errors().fold(f64::INFINITY, f64::min), errors().fold(0.0, f64::max), TOP + height - 14, TOP + 14)
        });
        let mut zeros: Vec<usize> = (0..marks.len()).filter(|&index| marks[index].error == 0.0).collect();
        zeros.sort_by(|&a, &b| marks[b].cost.total_cmp(&marks[a].cost));
        let band_top = TOP + height + if some > 0 { 10 } else { 0 };
        let bottom = band_top + (zeros.len() as i32).max(1) * ROW + 12;
        let mut at = vec![(0, 0); marks.len()];
        for (place, mark) in at.iter_mut().zip(marks) {
            *place = (across.place(mark.cost), up.map_or(0, |up| up.place(mark.error)));
        }
        for (row, &index) in zeros.iter().enumerate() {
            at[index].1 = band_top + 6 + ROW / 2 + row as i32 * ROW;
        }
        let mut methods: Vec<&str> = Vec::new();
        let colours = marks.iter().map(|mark| {
            if mark.is_shipped {
                return SHIPPED;
            }
            let known = methods.iter().position(|method| *method == mark.method);
            let place = known.unwrap_or_else(|| {
                methods.push(&mark.method);
                methods.len() - 1
            });
            COLOURS[place % COLOURS.len()]
        });
        let colours = colours.collect();
        Self { across, up, band: (band_top, bottom), bottom, at, colours }
    }

    fn draw_grid(&self, canvas: &Canvas<'_>, frame: &Frame) -> Drawn {
        canvas.draw(&Text::new(frame.title.clone(), (20, 26), text(21, INK, HPos::Left)))?;
        canvas.draw(&Text::new(frame.note.clone(), (20, 50), text(13, PALE, HPos::Left)))?;
        let right = WIDTH - RIGHT + 12;
        canvas.draw(&Rectangle::new([(LEFT, self.band.0), (right, self.band.1)], BAND.filled()))?;
        canvas.draw(&Text::new(frame.zero, (LEFT - 8, self.band.0 + 14), text(13, PALE, HPos::Right)))?;
        for (value, name) in self.across.ticks() {
            let x = self.across.place(value);
            canvas.draw(&PathElement::new([(x, TOP), (x, self.bottom)], GRID))?;
            canvas.draw(&Text::new(name, (x, self.bottom + 14), text(12, PALE, HPos::Center)))?;
        }
        for (value, name) in self.up.iter().flat_map(Axis::ticks) {
            let Some(up) = self.up else { continue };
            let y = up.place(value);
            canvas.draw(&PathElement::new([(LEFT, y), (right, y)], GRID))?;
            canvas.draw(&Text::new(name, (LEFT - 8, y), text(12, PALE, HPos::Right)))?;
        }
        let middle = (LEFT + right) / 2;
        canvas.draw(&Text::new(frame.cost, (middle, self.bottom + 40), text(14, INK, HPos::Center)))?;
        let name = text(14, INK, HPos::Left);
        canvas.draw(&Text::new(frame.error, (20, TOP - 14), name))?;
        Ok(())
    }

    /// From the left, what nothing cheaper or as cheap betters: across, and then down.
    fn front_path(&self, marks: &[Mark]) -> Vec<(i32, i32)> {
        let mut path: Vec<(i32, i32)> = Vec::new();
        for &index in &pareto_front(marks) {
            let (x, y) = self.at[index];
            if let Some(&(_, last)) = path.last() {
                path.push((x, last));
            }
            path.push((x, y));
        }
        path
    }

    fn draw_front(&self, canvas: &Canvas<'_>, marks: &[Mark]) -> Drawn {
        let style = ShapeStyle { color: FRONT.to_rgba(), filled: false, stroke_width: 4 };
        canvas.draw(&PathElement::new(self.front_path(marks), style))?;
        Ok(())
    }

    /// Options that differ in a number alone are points of a curve.
    fn draw_curves(&self, canvas: &Canvas<'_>, marks: &[Mark]) -> Drawn {
        for curve in curves(marks) {
            let path: Vec<(i32, i32)> = curve.iter().map(|&index| self.at[index]).collect();
            canvas.draw(&PathElement::new(path, self.colours[curve[0]].mix(0.4).stroke_width(2)))?;
        }
        Ok(())
    }

    fn draw_marks(&self, canvas: &Canvas<'_>, marks: &[Mark]) -> Drawn {
        let front = pareto_front(marks);
        let mut labels = Labels::new((LEFT + 2, TOP - 4), (WIDTH - 4, self.band.0 - 2));
        for &(x, y) in &self.at {
            labels.occupy((x, y), RADIUS + 2);
        }
        for ends in self.front_path(marks).windows(2) {
            labels.keep_off(ends[0], ends[1]);
        }
        for index in (0..marks.len()).filter(|&index| marks[index].error > 0.0) {
            let width = text_width(&label(&marks[index]));
            labels.add(index, self.at[index], width);
        }
        for (index, mark) in marks.iter().enumerate() {
            let (colour, (x, y)) = (self.colours[index], self.at[index]);
            let name = label(mark);
            if mark.error == 0.0 {
                let gap = RADIUS + if mark.is_shipped { 10 } else { 6 };
                let fits = x + gap + text_width(&name) < WIDTH - 4;
                let (at, side) = if fits { (x + gap, HPos::Left) } else { (x - gap, HPos::Right) };
                canvas.draw(&Text::new(name, (at, y), text(TEXT, colour, side)))?;
            }
            draw_mark(canvas, (x, y), colour, front.contains(&index), mark.is_shipped)?;
        }
        for (index, place) in labels.places() {
            let (colour, (x, y)) = (self.colours[index], self.at[index]);
            if place.is_far {
                let end = place.nearest_to((x, y));
                canvas.draw(&PathElement::new([(x, y), end], colour.mix(0.55).stroke_width(1)))?;
            }
            canvas.draw(&Text::new(
                label(&marks[index]),
                (place.left, place.middle()),
                text(TEXT, colour, HPos::Left),
            ))?;
        }
        Ok(())
    }
}

fn draw_mark(canvas: &Canvas<'_>, at: (i32, i32), colour: RGBColor, is_on_front: bool, is_shipped: bool) -> Drawn {
    if is_shipped {
        canvas.draw(&Circle::new(at, RADIUS + 4, colour.stroke_width(2)))?;
        canvas.draw(&Circle::new(at, RADIUS, colour.filled()))?;
    } else if is_on_front {
        canvas.draw(&Circle::new(at, RADIUS, colour.filled()))?;
    } else {
        canvas.draw(&Circle::new(at, RADIUS - 1, WHITE.filled()))?;
        canvas.draw(&Circle::new(at, RADIUS - 1, colour.stroke_width(2)))?;
    }
    Ok(())
}

/// A shipped method is named by what it is, the others by method and option.
fn label(mark: &Mark) -> String {
    if mark.option.is_empty() { mark.method.clone() } else { format!("{}: {}", mark.method, mark.option) }
}

fn text_width(text: &str) -> i32 {
    i32::try_from(text.chars().count()).unwrap_or(0) * 13 / 2
}

/// The marks that none betters in one way without being worse in the other, cheapest first.
pub(crate) fn pareto_front(marks: &[Mark]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..marks.len()).collect();
    order.sort_by(|&a, &b| marks[a].cost.total_cmp(&marks[b].cost).then(marks[a].error.total_cmp(&marks[b].error)));
    let mut front: Vec<usize> = Vec::new();
    for index in order {
        if front.last().is_none_or(|&last| marks[index].error < marks[last].error) {
            front.push(index);
        }
    }
    front
}

/// Marks of one method whose options differ in their last number alone, in the order of that number; three or more.
fn curves(marks: &[Mark]) -> Vec<Vec<usize>> {
    type Curve<'a> = ((&'a str, String), Vec<(f64, usize)>);
    let mut curves: Vec<Curve<'_>> = Vec::new();
    for (index, mark) in marks.iter().enumerate() {
        let Some((rest, number)) = split_number(&mark.option) else { continue };
        let key = (mark.method.as_str(), rest);
        match curves.iter_mut().find(|(other, _)| *other == key) {
            Some((_, points)) => points.push((number, index)),
            None => curves.push((key, vec![(number, index)])),
        }
    }
    let in_order = curves.into_iter().filter(|(_, points)| points.len() > 2).map(|(_, mut points)| {
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        points.into_iter().map(|(_, index)| index).collect()
    });
    in_order.collect()
}

/// What is varied in an option: its first number, but not the digits of a number type's name.
fn split_number(option: &str) -> Option<(String, f64)> {
    let is_start = |(at, _): &(usize, char)| {
        let before = option[..*at].chars().next_back();
        option[*at..].starts_with(|c: char| c.is_ascii_digit()) && !before.is_some_and(|c| c.is_alphanumeric())
    };
    let (start, _) = option.char_indices().find(is_start)?;
    let length = option[start..].find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(option.len() - start);
    let (number, after) = option[start..].split_at(length);
    // "8 x 8" is one number.
    let after = after.strip_prefix(&format!(" x {number}")).unwrap_or(after);
    let after = after.strip_prefix('/').map_or(after, |rest| rest.trim_start_matches(|c: char| c.is_ascii_digit()));
    Some((format!("{}#{after}", &option[..start]), number.trim_end_matches('.').parse().ok()?))
}

fn text(size: i32, colour: RGBColor, horizontal: HPos) -> TextStyle<'static> {
    ("sans-serif", size).into_font().color(&colour).pos(Pos::new(horizontal, VPos::Center))
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
    /// From a little below the least to a little above the most: at least half a decade.
    fn new(least: f64, most: f64, from: i32, to: i32) -> Self {
        let (low, high) = (least / 1.15, most * 1.15);
        let widen = (3.0 / (high / low)).max(1.0).sqrt();
        Self { low: low / widen, high: high * widen, from, to }
    }

    fn place(&self, value: f64) -> i32 {
        let share = (value / self.low).ln() / (self.high / self.low).ln();
        self.from + (share * f64::from(self.to - self.from)).round() as i32
    }

    fn ticks(&self) -> Vec<(f64, String)> {
        let decades = (self.high / self.low).log10();
        let steps: &[f64] = if decades < 2.5 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let powers = self.low.log10().floor() as i32..=self.high.log10().ceil() as i32;
        let values = powers.flat_map(|power| steps.iter().map(move |step| (step * 10_f64.powi(power), power, *step)));
        let within = values.filter(|(value, ..)| (self.low..=self.high).contains(value));
        within.map(|(value, power, step)| (value, tick_name(value, power, step))).collect()
    }
}

fn tick_name(value: f64, power: i32, step: f64) -> String {
    if (-3..6).contains(&power) {
        format!("{value:.*}", power.min(0).unsigned_abs() as usize)
    } else {
        format!("{step}e{power}")
    }
}
