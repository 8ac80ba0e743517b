//! A family's methods with the scenes that they are measured on, whatever kind of shape that is.

use std::{
    fmt,
    ops::Range,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::{Arc, OnceLock},
    thread,
};

use super::truth::{Tally, Truth};
use crate::variants::{
    Frame, Outcome, Picture, SCREEN, Variant,
    attribute::{in_perspective, is_depth},
};

/// What a method is meant to draw of a shape.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Aim {
    /// The pixels inside.
    Fill,
    /// The pixels of its outline.
    Outline,
    /// How much of each pixel is inside.
    Coverage,
    /// What varies across it.
    Attributes,
    /// What varies across it in perspective.
    Perspective,
    /// Its depth.
    Depth,
}

/// A shape that the oracle knows.
pub(crate) trait Subject: Send + Sync + 'static {
    /// What the methods draw of it.
    type Drawn: ?Sized + 'static;

    /// Its parts, to be drawn one after the other: itself, or the triangles of a mesh.
    fn parts(&self) -> impl Iterator<Item = &Self::Drawn>;

    /// What the oracle makes of it; only what lies in `window` is asked for.
    fn truth(&self, aim: Aim, window: &[Range<i32>; 2]) -> Truth;

    /// The true outline in pixels, for the eye.
    fn outline(&self) -> Vec<Vec<(f64, f64)>>;
}

/// Shapes that are measured together, each drawn alone on an empty screen.
#[derive(Debug, Clone)]
pub(crate) struct Scene<S> {
    pub(crate) name: &'static str,
    pub(crate) shapes: Vec<S>,
}

type Check = Box<dyn Fn(usize, usize, &mut Picture) -> Outcome + Send + Sync>;
type Time = Box<dyn Fn(usize, usize, &mut Frame) -> Outcome + Send + Sync>;

/// One method with one option on a suite's scenes.
pub(crate) struct Entry {
    pub(crate) method: &'static str,
    pub(crate) option: &'static str,
    pub(crate) aim: Aim,
    check: Check,
    time: Time,
}

impl fmt::Debug for Entry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.method, self.option)
    }
}

impl Entry {
    /// Whether this is what the crate ships.
    pub(crate) fn is_shipped(&self) -> bool {
        self.method == "spanfill"
    }

    /// The method's name, and the option's where there is one.
    pub(crate) fn label(&self) -> String {
        if self.option.is_empty() { self.method.into() } else { format!("{}: {}", self.method, self.option) }
    }
}

type OutlineOf = Box<dyn Fn(usize, usize) -> Vec<Vec<(f64, f64)>> + Send + Sync>;
type Truths = Vec<Vec<[OnceLock<Box<Truth>>; AIMS]>>;
const AIMS: usize = 6;

/// A family's methods and scenes.
pub(crate) struct Suite {
    pub(crate) family: &'static str,
    /// What tells it from others of its family; mostly nothing.
    pub(crate) part: &'static str,
    pub(crate) entries: Vec<Entry>,
    pub(crate) scenes: Vec<(&'static str, usize)>,
    truths: Truths,
    truth: Box<dyn Fn(usize, usize, Aim) -> Truth + Send + Sync>,
    outline: OutlineOf,
}

impl fmt::Debug for Suite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} with {:?} on {:?}", self.family, self.entries, self.scenes)
    }
}

impl Suite {
    /// Every variant of `variants` that belongs to `family`, on these scenes.
    pub(crate) fn new<S: Subject>(
        family: &'static str,
        variants: &'static [Variant<S::Drawn>],
        scenes: Vec<Scene<S>>,
        aim: fn(&str, &str) -> Aim,
    ) -> Self {
        let names = scenes.iter().map(|scene| (scene.name, scene.shapes.len())).collect();
        let truths = scenes.iter().map(|scene| scene.shapes.iter().map(|_| Default::default()).collect()).collect();
        let scenes = Arc::new(scenes);
        let entry = |variant: &'static Variant<S::Drawn>| {
            let (checked, timed) = (Arc::clone(&scenes), Arc::clone(&scenes));
            Entry {
                method: variant.method,
                option: variant.option,
                aim: aim(variant.method, variant.option),
                check: Box::new(move |scene, shape, picture| {
                    checked[scene].shapes[shape].parts().try_for_each(|part| (variant.check)(part, &SCREEN, picture))
                }),
                time: Box::new(move |scene, shape, frame| {
                    timed[scene].shapes[shape].parts().try_for_each(|part| (variant.time)(part, &SCREEN, frame))
                }),
            }
        };
        let entries = variants.iter().filter(|variant| variant.family == family).map(entry).collect();
        let (of_truth, of_outline) = (Arc::clone(&scenes), scenes);
        let screen = [SCREEN.columns, SCREEN.rows];
        Self {
            family,
            part: "",
            entries,
            scenes: names,
            truths,
            truth: Box::new(move |scene, shape, aim| of_truth[scene].shapes[shape].truth(aim, &screen)),
            outline: Box::new(move |scene, shape| of_outline[scene].shapes[shape].outline()),
        }
    }

    /// What the oracle makes of a shape; worked out once.
    pub(crate) fn truth(&self, scene: usize, shape: usize, aim: Aim) -> &Truth {
        self.truths[scene][shape][aim as usize].get_or_init(|| Box::new((self.truth)(scene, shape, aim)))
    }

    pub(crate) fn outline(&self, scene: usize, shape: usize) -> Vec<Vec<(f64, f64)>> {
        (self.outline)(scene, shape)
    }

    /// Draws a shape on an empty picture. What a panic said comes as an error: no method may.
    pub(crate) fn draw(&self, entry: &Entry, scene: usize, shape: usize, picture: &mut Picture) -> Result<(), String> {
        clear(picture);
        // No method may panic; were one to, it is a refusal that says so.
        match catch_unwind(AssertUnwindSafe(|| (entry.check)(scene, shape, picture))) {
            Ok(outcome) => outcome.map_err(Into::into),
            Err(_) => Err("panicked".into()),
        }
    }

    /// Draws a shape for the clock.
    pub(crate) fn time(&self, entry: &Entry, scene: usize, shape: usize, frame: &mut Frame) {
        // What a method cannot draw is in its other columns.
        let _ = (entry.time)(scene, shape, frame);
    }

    /// How a method's pictures of a scene's first shapes differ from the oracle's.
    pub(crate) fn tally(&self, entry: &Entry, scene: usize, shapes: usize, picture: &mut Picture) -> Tally {
        let mut tally = Tally::default();
        for shape in 0..shapes.min(self.scenes[scene].1) {
            let truth = self.truth(scene, shape, entry.aim);
            let outcome = self.draw(entry, scene, shape, picture);
            if outcome.is_err() {
                tally += Tally { pixels: truth.pixels(), refused: 1, ..Tally::default() };
            } else {
                tally += Tally::of(picture, truth);
            }
        }
        tally
    }
}

/// An empty picture: its 1.8 MB need a larger stack than a test has.
pub(crate) fn new_picture() -> Box<Picture> {
    let made = thread::Builder::new().stack_size(16 << 20).spawn(|| Box::new(Picture::new()));
    made.expect("a thread can be had").join().expect("it does nothing that fails")
}

/// Where a pixel did not come, nothing else is looked at.
fn clear(picture: &mut Picture) {
    picture.count.fill(0);
    picture.visited = 0;
    picture.outside = 0;
}

impl Aim {
    /// Its name in tables and files.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Fill => "fill",
            Self::Outline => "outline",
            Self::Coverage => "coverage",
            Self::Attributes => "attributes",
            Self::Perspective => "perspective",
            Self::Depth => "depth",
        }
    }

    /// That of a variant of the family "attributes".
    pub(crate) fn of_attributes(method: &str, option: &str) -> Self {
        if in_perspective(method, option) {
            Self::Perspective
        } else if is_depth(method, option) {
            Self::Depth
        } else {
            Self::Attributes
        }
    }

    /// Whether what counts is how far values are off, not which pixels are there.
    pub(crate) const fn is_of_levels(self) -> bool {
        matches!(self, Self::Coverage | Self::Attributes | Self::Perspective | Self::Depth)
    }
}
