//! A paragraph of text.

use std::{fs, path::Path};

use kurbo::{Affine, BezPath};
use ttf_parser::{Face, OutlineBuilder};

use crate::{HEIGHT, Outcome, WIDTH, outline::Shape};

/// The beginning of "Alice's Adventures in Wonderland" by Lewis Carroll, 1865.
const TEXT: &str = "\
Alice was beginning to get very tired of sitting by her sister on the bank, and of having nothing to do: once or twice \
she had peeped into the book her sister was reading, but it had no pictures or conversations in it, “and what is the \
use of a book,” thought Alice “without pictures or conversations?” So she was considering in her own mind (as well as \
she could, for the hot day made her feel very sleepy and stupid), whether the pleasure of making a daisy-chain would be \
worth the trouble of getting up and picking the daisies, when suddenly a White Rabbit with pink eyes ran close by her. \
There was nothing so very remarkable in that; nor did Alice think it so very much out of the way to hear the Rabbit say \
to itself, “Oh dear! Oh dear! I shall be late!”";

const SIZE_PX: f64 = 12.0;
const LEADING_PX: f64 = 14.0;
const MARGIN_PX: f64 = 4.0;

/// A shape for each glyph that has an outline, on lines broken between words; advances as the font has them, no kerning.
pub(crate) fn paragraph(file: &Path) -> Outcome<Vec<Shape>> {
    let bytes = fs::read(file).map_err(|error| format!("{}: {error}", file.display()))?;
    let face = Face::parse(&bytes, 0)?;
    let scale = SIZE_PX / f64::from(face.units_per_em());
    let advance = |c: char| {
        let glyph = face.glyph_index(c).ok_or_else(|| format!("the font has no {c}"))?;
        Ok::<_, String>(scale * f64::from(face.glyph_hor_advance(glyph).unwrap_or(0)))
    };

    let mut shapes = Vec::new();
    let (mut x, mut y) = (MARGIN_PX, MARGIN_PX + SIZE_PX);
    for word in TEXT.split_inclusive(' ') {
        let width = word.trim_end().chars().map(advance).sum::<Result<f64, _>>()?;
        if x + width > WIDTH - MARGIN_PX {
            (x, y) = (MARGIN_PX, y + LEADING_PX);
        }
        for c in word.chars() {
            shapes.extend(glyph(&face, c, Affine::new([scale, 0.0, 0.0, -scale, x, y])));
            x += advance(c)?;
        }
    }
    if y > HEIGHT {
        return Err("the text is longer than the picture".into());
    }
    Ok(shapes)
}

fn glyph(face: &Face<'_>, c: char, to_pixels: Affine) -> Option<Shape> {
    let mut builder = Builder(BezPath::new());
    face.outline_glyph(face.glyph_index(c)?, &mut builder)?;
    Shape::new([0xe6, 0xe6, 0xdc], false, &(to_pixels * builder.0))
}

struct Builder(BezPath);

impl OutlineBuilder for Builder {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.move_to((f64::from(x), f64::from(y)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.line_to((f64::from(x), f64::from(y)));
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.quad_to((f64::from(x1), f64::from(y1)), (f64::from(x), f64::from(y)));
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.curve_to((f64::from(x1), f64::from(y1)), (f64::from(x2), f64::from(y2)), (f64::from(x), f64::from(y)));
    }

    fn close(&mut self) {
        self.0.close_path();
    }
}
