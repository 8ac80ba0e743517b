//! The same small scene by every method of a family, panel beside panel.

#![allow(dead_code, reason = "each program that takes this file in uses the part it needs")]

use std::error::Error;

use crate::{
    canvas::{Canvas, Size},
    families::GALLERY,
    measure::{Aim, Entry, Suite, Tally, new_picture},
    panel::{DOUBLED, EXTRA, INK, MISSING, MOVED, PALE, PAPER, Panel, RIGHT},
};

/// The window that panels show, in pixels of the screen.
const COLUMNS: i32 = 20;
const ROWS: i32 = 16;
const SCALE: i32 = 8;
const ACROSS: usize = 7;
const GAP: i32 = 16;
const MARGIN: i32 = 16;
const HEAD: i32 = 58;
const TEXT_LINES: i32 = 5;
const LINE: i32 = 11;

/// What one method makes of the scene.
#[derive(Debug)]
pub(crate) struct Drawn {
    method: &'static str,
    option: &'static str,
    aim: Aim,
    panel: Panel,
    outline: Vec<Vec<(f64, f64)>>,
    tally: Tally,
}

impl Drawn {
    /// A row of the list of what was drawn.
    pub(crate) fn row(&self, family: &str, file: &str) -> [String; 5] {
        [family.into(), self.method.into(), self.option.into(), self.aim.name().into(), file.into()]
    }
}

/// The columns of the list.
pub(crate) const INDEX: [&str; 5] = ["family", "method", "option", "of", "picture"];

/// The list of what was drawn.
pub(crate) fn index(rows: &[[String; 5]]) -> Result<String, Box<dyn Error>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(INDEX)?;
    for row in rows {
        writer.write_record(row)?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// The panels of each family; a family may have suites for shapes of several kinds.
pub(crate) fn by_family(suites: &[Suite], mut progress: impl FnMut(&Entry)) -> Vec<(&'static str, Vec<Drawn>)> {
    let mut families: Vec<(&'static str, Vec<Drawn>)> = Vec::new();
    let mut picture = new_picture();
    for suite in suites {
        if families.iter().all(|(family, _)| *family != suite.family) {
            families.push((suite.family, Vec::new()));
        }
        let Some((_, panels)) = families.iter_mut().find(|(family, _)| *family == suite.family) else { continue };
        let Some(scene) = suite.scenes.iter().position(|(name, _)| *name == GALLERY) else { continue };
        for entry in &suite.entries {
            progress(entry);
            let mut panel = Panel::new(0..COLUMNS, 0..ROWS);
            let mut tally = Tally::default();
            let mut outline = Vec::new();
            for shape in 0..suite.scenes[scene].1 {
                let truth = suite.truth(scene, shape, entry.aim);
                outline.extend(suite.outline(scene, shape));
                if suite.draw(entry, scene, shape, &mut picture).is_ok() {
                    tally += Tally::of(&picture, truth);
                } else {
                    tally += Tally { pixels: truth.pixels(), missing: truth.pixels(), ..Tally::default() };
                }
                panel.add(&picture, truth);
            }
            let Entry { method, option, aim, .. } = *entry;
            panels.push(Drawn { method, option, aim, panel, outline, tally });
        }
    }
    families
}

/// The picture of a family.
pub(crate) fn draw(family: &str, panels: &[Drawn]) -> Canvas {
    let (panel_width, panel_height) = Panel::new(0..COLUMNS, 0..ROWS).size(SCALE);
    let down = panels.len().div_ceil(ACROSS) as i32;
    let across = panels.len().clamp(1, ACROSS) as i32;
    let cell_height = panel_height + TEXT_LINES * LINE + 14;
    let width = (2 * MARGIN + across * (panel_width + GAP) - GAP).max(560);
    let mut canvas = Canvas::new(width, HEAD + down * cell_height + 4, PAPER);
    canvas.text(family, MARGIN, 12, Size::Title, INK);
    legend(&mut canvas, panels.iter().any(|drawn| drawn.aim.is_of_levels()));
    for (place, drawn) in panels.iter().enumerate() {
        let (column, row) = ((place % ACROSS) as i32, (place / ACROSS) as i32);
        let (left, top) = (MARGIN + column * (panel_width + GAP), HEAD + row * cell_height);
        drawn.panel.draw(&mut canvas, left, top, SCALE, &drawn.outline);
        let letters = (panel_width / Size::Small.advance()) as usize;
        let mut lines = wrap(drawn.method, letters, 2);
        lines.extend(wrap(drawn.option, letters, 2));
        lines.truncate(TEXT_LINES as usize - 2);
        let names = lines.len() as i32;
        let in_method = wrap(drawn.method, letters, 2).len() as i32;
        for (line, text) in (0..).zip(&lines) {
            let colour = if line < in_method { INK } else { PALE };
            canvas.text(text, left, top + panel_height + 4 + line * LINE, Size::Small, colour);
        }
        let (verdict, is_right) = verdict(drawn);
        let colour = if is_right { PALE } else { EXTRA };
        for (line, text) in (names..).zip(wrap(&verdict, letters, 2)) {
            canvas.text(&text, left, top + panel_height + 4 + line * LINE, Size::Small, colour);
        }
    }
    canvas
}

/// What is wrong, in a few words.
fn verdict(drawn: &Drawn) -> (String, bool) {
    let Tally { missing, extra, doubled, moved, worst, refused, .. } = drawn.tally;
    let (missing, extra, moved) = if drawn.aim == Aim::Coverage { (0, 0, 0) } else { (missing, extra, moved) };
    let mut parts = Vec::new();
    let counts = [(missing, "missing"), (extra, "extra"), (doubled, "twice"), (refused, "refused")];
    parts.extend(counts.iter().filter(|(count, _)| *count > 0).map(|(count, name)| format!("{count} {name}")));
    if drawn.aim.is_of_levels() && worst > 0.0 {
        parts.push(format!("{worst:.1} off"));
    }
    let is_right = parts.is_empty() || (missing + extra + doubled == 0 && worst <= 0.51);
    if moved > 0 {
        parts.push(format!("{moved} ties"));
    }
    if parts.is_empty() { ("exact".into(), true) } else { (parts.join(", "), is_right) }
}

fn legend(canvas: &mut Canvas, of_levels: bool) {
    let mut left = MARGIN;
    for (colour, name) in
        [(RIGHT, "right"), (EXTRA, "extra"), (MISSING, "missing"), (DOUBLED, "twice"), (MOVED, "another tie rule")]
    {
        canvas.rect(left, 34, 9, 9, if colour == MISSING { EXTRA } else { colour });
        if colour == MISSING {
            canvas.rect(left + 1, 35, 7, 7, MISSING);
        }
        canvas.text(name, left + 14, 33, Size::Small, PALE);
        left += 14 + name.len() as i32 * Size::Small.advance() + 18;
    }
    if of_levels {
        canvas.rect(left, 34, 9, 9, RIGHT);
        canvas.rect(left + 3, 37, 3, 3, EXTRA);
        canvas.text("so far off", left + 14, 33, Size::Small, PALE);
    }
}

/// Words in lines of so many letters at most; what does not fit is cut.
fn wrap(text: &str, letters: usize, lines: usize) -> Vec<String> {
    let mut wrapped: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match wrapped.last_mut().filter(|line| line.len() + 1 + word.len() <= letters) {
            Some(line) => *line = format!("{line} {word}"),
            None => wrapped.push(word.chars().take(letters).collect()),
        }
    }
    wrapped.truncate(lines);
    wrapped
}
