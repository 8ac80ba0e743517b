//! A window of a method's picture, enlarged: what is right, what is wrong and how, and the true outline over it.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

use std::ops::Range;

use embedded_graphics::pixelcolor::Rgb888;

use crate::{
    canvas::Canvas,
    measure::{Truth, Verdict, levels_off, verdict},
    variants::{Picture, WIDTH},
};

pub(crate) const PAPER: Rgb888 = Rgb888::new(0xff, 0xff, 0xff);
pub(crate) const INK: Rgb888 = Rgb888::new(0x22, 0x26, 0x2b);
pub(crate) const PALE: Rgb888 = Rgb888::new(0x6b, 0x72, 0x7b);
pub(crate) const GRID: Rgb888 = Rgb888::new(0xe4, 0xe7, 0xea);
pub(crate) const RIGHT: Rgb888 = Rgb888::new(0x9d, 0xb8, 0xcf);
pub(crate) const EXTRA: Rgb888 = Rgb888::new(0xd6, 0x1f, 0x26);
pub(crate) const MISSING: Rgb888 = Rgb888::new(0xff, 0xd9, 0xd6);
pub(crate) const DOUBLED: Rgb888 = Rgb888::new(0x8c, 0x1a, 0x6a);
pub(crate) const MOVED: Rgb888 = Rgb888::new(0xf2, 0xb1, 0x34);
pub(crate) const OUTLINE: Rgb888 = Rgb888::new(0x14, 0x3a, 0x5a);

/// What is known of each pixel of a window, from the pictures of one shape after another.
#[derive(Debug, Clone)]
pub(crate) struct Panel {
    columns: Range<i32>,
    rows: Range<i32>,
    cells: Vec<Cell>,
}

#[derive(Debug, Clone, Copy)]
struct Cell {
    verdict: Verdict,
    /// What fills it where it is right.
    colour: Rgb888,
    levels_off: f64,
}

impl Panel {
    pub(crate) fn new(columns: Range<i32>, rows: Range<i32>) -> Self {
        let empty = Cell { verdict: Verdict::Empty, colour: PAPER, levels_off: 0.0 };
        Self { cells: vec![empty; columns.len() * rows.len()], columns, rows }
    }

    /// The size of its picture.
    pub(crate) fn size(&self, scale: i32) -> (i32, i32) {
        (self.columns.len() as i32 * scale + 1, self.rows.len() as i32 * scale + 1)
    }

    /// Adds what a shape's picture has in the window.
    pub(crate) fn add(&mut self, picture: &Picture, truth: &Truth) {
        let places = self.rows.clone().flat_map(|row| self.columns.clone().map(move |column| row * WIDTH + column));
        for (cell, at) in self.cells.iter_mut().zip(places) {
            let at = at as usize;
            let mut verdict = verdict(picture, truth, at);
            if verdict == Verdict::Empty {
                continue;
            }
            if !truth.coverage.is_empty() && verdict != Verdict::Doubled {
                // What counts is how far it is off.
                verdict = Verdict::Right;
            }
            let colour = if truth.is_depth {
                attribute_colour([i32::from(picture.depth[at] >> 8); 4], 1)
            } else if !truth.attributes.is_empty() {
                attribute_colour(picture.attributes[at], truth.channels)
            } else if truth.coverage.is_empty() {
                RIGHT
            } else {
                shade(if picture.count[at] == 0 { 0 } else { picture.coverage[at] })
            };
            *cell = Cell { verdict, colour, levels_off: levels_off(picture, truth, at) };
        }
    }

    /// How many pixels differ from the oracle's.
    pub(crate) fn wrong(&self) -> usize {
        let is_wrong = |cell: &&Cell| !matches!(cell.verdict, Verdict::Empty | Verdict::Right | Verdict::Moved);
        self.cells.iter().filter(is_wrong).count()
    }

    /// Draws it, and outlines in pixels of the screen over it.
    pub(crate) fn draw(&self, canvas: &mut Canvas, left: i32, top: i32, scale: i32, outlines: &[Vec<(f64, f64)>]) {
        let (width, height) = self.size(scale);
        canvas.rect(left, top, width, height, GRID);
        let places = (0..self.rows.len() as i32).flat_map(|y| (0..self.columns.len() as i32).map(move |x| (x, y)));
        for (cell, (x, y)) in self.cells.iter().zip(places) {
            draw_cell(canvas, cell, left + x * scale + 1, top + y * scale + 1, scale - 1);
        }
        self.draw_outlines(canvas, left, top, scale, outlines);
    }

    fn draw_outlines(&self, canvas: &mut Canvas, left: i32, top: i32, scale: i32, outlines: &[Vec<(f64, f64)>]) {
        let (origin, scale_by) = ((f64::from(left), f64::from(top)), f64::from(scale));
        let place = |(x, y): (f64, f64)| {
            let (x, y) = (x - f64::from(self.columns.start), y - f64::from(self.rows.start));
            (origin.0 + x * scale_by, origin.1 + y * scale_by)
        };
        let (width, height) = self.size(scale);
        let window = [origin, (origin.0 + f64::from(width), origin.1 + f64::from(height))];
        for outline in outlines {
            let following = outline.iter().cycle().skip(1);
            for (from, to) in outline.iter().zip(following) {
                if let Some((from, to)) = within(window, place(*from), place(*to)) {
                    canvas.line(from, to, OUTLINE);
                }
            }
        }
    }
}

fn draw_cell(canvas: &mut Canvas, cell: &Cell, left: i32, top: i32, size: i32) {
    match cell.verdict {
        Verdict::Extra => canvas.rect(left, top, size, size, EXTRA),
        Verdict::Missing => {
            canvas.rect(left, top, size, size, EXTRA);
            canvas.rect(left + 1, top + 1, size - 2, size - 2, MISSING);
        }
        Verdict::Doubled => canvas.rect(left, top, size, size, DOUBLED),
        Verdict::Moved => canvas.rect(left, top, size, size, MOVED),
        Verdict::Right | Verdict::Empty => {
            canvas.rect(left, top, size, size, cell.colour);
            // A dot, the larger the farther it is off: 1 px for one level, one more whenever that doubles twice.
            if cell.levels_off >= 1.0 {
                let dot = (1 + cell.levels_off.log2() as i32 / 2).min(size - 2);
                let inset = (size - dot) / 2;
                canvas.rect(left + inset, top + inset, dot, dot, EXTRA);
            }
        }
    }
}

/// White to blue.
fn shade(coverage: u8) -> Rgb888 {
    let mix = |from: u8, to: u8| from - ((u16::from(from - to) * u16::from(coverage) + 127) / 255) as u8;
    Rgb888::new(mix(0xff, 0x6a), mix(0xff, 0x95), mix(0xff, 0xbd))
}

/// Up to three attributes as red, green and blue; one as a grey; in steps of 16.
fn attribute_colour(attributes: [i32; 4], channels: usize) -> Rgb888 {
    let level = |attribute: i32| (attribute.clamp(0, 255) as u8 & 0xf0) | 0x08;
    let [a, b, c, _] = attributes;
    if channels >= 3 { Rgb888::new(level(a), level(b), level(c)) } else { Rgb888::new(level(a), level(a), level(a)) }
}

/// The part of a line within a rectangle (Liang and Barsky, 1984).
fn within([least, most]: [(f64, f64); 2], from: (f64, f64), to: (f64, f64)) -> Option<((f64, f64), (f64, f64))> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut start, mut end) = (0.0_f64, 1.0_f64);
    let sides = [(-dx, from.0 - least.0), (dx, most.0 - from.0), (-dy, from.1 - least.1), (dy, most.1 - from.1)];
    for (step, room) in sides {
        if step == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if step < 0.0 {
            start = start.max(room / step);
        } else {
            end = end.min(room / step);
        }
    }
    let at = |share: f64| (from.0 + share * dx, from.1 + share * dy);
    (start <= end).then(|| (at(start), at(end)))
}
