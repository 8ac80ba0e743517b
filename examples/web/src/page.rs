//! What the page shows: a canvas, what became of each pixel, the true outline, and numbers.

use core::convert::Infallible;

use crate::{
    canvas::Canvas,
    dashboard::{self, Dashboard},
    drawing::{Choice, drawing, is_antialiased},
    judge::{Truth, Verdict},
    subject::{Geometry, Subject},
    variants::{Frame, HEIGHT, Picture, WIDTH},
};

const PIXELS: usize = (WIDTH * HEIGHT) as usize;
const BACKGROUND: [u8; 3] = [18, 22, 30];
const INK: [u8; 3] = [255, 176, 64];

/// What was found, in the order in which the page reads it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Report {
    /// Pixels of the exact picture.
    pub pixels: f64,
    pub missing: f64,
    pub extra: f64,
    pub doubled: f64,
    pub ties: f64,
    /// Pixels whose coverage or colour is not the nearest.
    pub off: f64,
    /// By how many levels the worst of them is off, beyond rounding once.
    pub worst: f64,
    /// Shapes that the method could not draw.
    pub refused: f64,
    /// Pixels that it looked at, where it counts them.
    pub visited: f64,
}

impl Report {
    pub fn numbers(&self) -> [f64; 9] {
        let Self { pixels, missing, extra, doubled, ties, off, worst, refused, visited } = *self;
        [pixels, missing, extra, doubled, ties, off, worst, refused, visited]
    }
}

pub struct Page {
    /// What was right for the last subject: most methods are judged alike.
    truth: Option<Truth>,
    canvas: Canvas,
    picture: Box<Picture>,
    frame: Box<Frame>,
    verdicts: Vec<u8>,
    outline: Vec<i32>,
    report: Report,
}

impl Default for Page {
    fn default() -> Self {
        Self {
            truth: None,
            canvas: Canvas::new(),
            picture: Box::new(Picture::new()),
            frame: Box::new(Frame::new()),
            verdicts: vec![0; PIXELS],
            outline: vec![],
            report: Report::default(),
        }
    }
}

impl Page {
    pub fn canvas(&self) -> &Canvas {
        &self.canvas
    }

    /// A [`Verdict`] for each pixel.
    pub fn verdicts(&self) -> &[u8] {
        &self.verdicts
    }

    /// The number of contours, then for each the number of its points and their coordinates in 1/256 pixel.
    pub fn outline(&self) -> &[i32] {
        &self.outline
    }

    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Draws the dashboard, its needle at `value` of 100.
    pub fn draw_dashboard(&mut self, value: i32, by_embedded_graphics: bool) {
        let dashboard = Dashboard::new(value);
        let drawn: Result<(), Infallible> = if by_embedded_graphics {
            dashboard::draw_by_embedded_graphics(&mut self.canvas, &dashboard)
        } else {
            dashboard::draw(&mut self.canvas, &dashboard)
        };
        let Ok(()) = drawn;
    }

    /// Draws a subject by a method, and judges it. False where the method is not one for such a subject.
    pub fn draw(&mut self, subject: &Subject, choice: &Choice) -> bool {
        let Some(drawing) = drawing(subject, choice) else { return false };
        self.clear();
        let truth = match self.truth.take() {
            Some(truth) if truth.is_of(subject, choice) => truth,
            _ => Truth::new(subject, choice),
        };
        let mut drawn = vec![0; PIXELS];
        let is_one_part = drawing.parts() == 1;
        for part in 0..drawing.parts() {
            self.report.refused += f64::from(u8::from(drawing.check(part, &mut self.picture).is_err()));
            for row in 0..HEIGHT as usize {
                let pixels = row * WIDTH as usize..(row + 1) * WIDTH as usize;
                // Most parts are on a few rows.
                if drawn[pixels.clone()] == self.picture.count[pixels.clone()] {
                    continue;
                }
                for at in pixels {
                    let count = self.picture.count[at];
                    if count == drawn[at] {
                        continue;
                    }
                    drawn[at] = count;
                    // A mesh that is drawn at once has the colours of the triangles that own the pixels.
                    let shape = if is_one_part { truth.owner(at).unwrap_or(0) } else { part };
                    let colour = colour(subject, choice, shape, &self.picture, at);
                    self.canvas.set(at, colour);
                }
            }
        }
        self.report.pixels = truth.pixels() as f64;
        self.report.visited = self.picture.visited as f64;
        for (at, place) in self.verdicts.iter_mut().enumerate() {
            let (verdict, off) = truth.judge(subject, choice, &self.picture, at);
            *place = verdict as u8;
            self.report.worst = self.report.worst.max(off);
            match verdict {
                Verdict::Empty | Verdict::Right => {}
                Verdict::Missing => self.report.missing += 1.0,
                Verdict::Extra => self.report.extra += 1.0,
                Verdict::Doubled => self.report.doubled += 1.0,
                Verdict::Tie => self.report.ties += 1.0,
                Verdict::Off => self.report.off += 1.0,
            }
        }
        let contours = subject.outline(is_antialiased(choice));
        self.outline.push(contours.len() as i32);
        for contour in contours {
            self.outline.push(contour.len() as i32);
            self.outline.extend(contour.iter().flatten());
        }
        self.truth = Some(truth);
        true
    }

    /// Draws a subject some times over, for the clock: into RGB565, as on a microcontroller, and without judging it.
    pub fn time(&mut self, subject: &Subject, choice: &Choice, times: u32) -> bool {
        let Some(drawing) = drawing(subject, choice) else { return false };
        for _ in 0..times {
            drawing.time(&mut self.frame);
            core::hint::black_box(&mut self.frame);
        }
        true
    }

    fn clear(&mut self) {
        (0..PIXELS).for_each(|at| self.canvas.set(at, BACKGROUND));
        let Picture { count, coverage, depth, attributes, visited, outside } = &mut *self.picture;
        count.fill(0);
        coverage.fill(0);
        depth.fill(0);
        attributes.fill([0; 4]);
        (*visited, *outside) = (0, 0);
        self.outline.clear();
        self.report = Report::default();
    }
}

/// What a pixel looks like that has just been drawn.
fn colour(subject: &Subject, choice: &Choice, shape: usize, picture: &Picture, at: usize) -> [u8; 3] {
    let byte = |value: i32| value.clamp(0, 255) as u8;
    match &subject.geometry {
        Geometry::Triangles(_) if choice.method == "depth" => [255 - (picture.depth[at] >> 8) as u8; 3],
        Geometry::Triangles(_) if choice.family == "attributes" => {
            let [red, green, blue, _] = picture.attributes[at];
            [red, green, blue].map(byte)
        }
        Geometry::Triangles(all) if !is_antialiased(choice) => {
            let of = &all[shape].attributes;
            [0, 1, 2].map(|channel| byte((of[0][channel] + of[1][channel] + of[2][channel]) / 3))
        }
        _ => {
            let part = u32::from(picture.coverage[at]);
            let mixed = |channel: usize| {
                (u32::from(INK[channel]) * part + u32::from(BACKGROUND[channel]) * (255 - part) + 127) / 255
            };
            [0, 1, 2].map(|channel| mixed(channel) as u8)
        }
    }
}
