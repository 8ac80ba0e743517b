//! Draws what `examples/firmware/size.sh` measured: flash in bars, a panel for each group.
//!
//! `cargo run --release --example flash_chart -- docs/charts/flash.csv docs/charts/flash.svg`

use std::{error::Error, fs, path::PathBuf};

use clap::Parser;
use plotters::{
    prelude::*,
    style::text_anchor::{HPos, Pos, VPos},
};

/// Draws a table of flash sizes as bars.
#[derive(Debug, Parser)]
struct Arguments {
    /// The table, as written by examples/firmware/size.sh.
    table: PathBuf,
    /// The picture, an SVG.
    picture: PathBuf,
}

/// A row of the table.
#[derive(Debug)]
struct Row {
    group: String,
    capability: String,
    library: String,
    flash: i64,
    stack: Option<i64>,
}

/// The groups, in the order and with the titles of the picture.
const PANELS: [(&str, &str); 5] = [
    ("shapes", "Shapes, Cortex-M0+, for size"),
    ("fast", "Shapes, Cortex-M4, level 3 (and stack)"),
    ("plug-in", "embedded-graphics' primitives, filled and stroked, Cortex-M0+, for size"),
    ("blends", "Anti-aliased circle by each way to mix, Cortex-M0+, for size"),
    ("methods", "Methods of the literature, whole families, Cortex-M0+, for size"),
];

const WIDTH: i32 = 900;
const LABEL_WIDTH: i32 = 190;
const BAR_HEIGHT: i32 = 9;
const ROW_GAP: i32 = 6;
const TITLE_HEIGHT: i32 = 34;
const LEGEND_HEIGHT: i32 = 30;

/// Colours that colour-blind readers tell apart (Okabe and Ito).
fn colour(library: &str) -> RGBColor {
    match library {
        "embedded-graphics" => RGBColor(153, 153, 153),
        "spanfill" => RGBColor(0, 114, 178),
        "spanfill, anti-aliased" => RGBColor(230, 159, 0),
        _ => RGBColor(0, 158, 115),
    }
}

/// Fields between commas; those with a comma in them are quoted.
fn fields(line: &str) -> Vec<String> {
    let mut fields = vec![String::new()];
    let mut quoted = false;
    for character in line.chars() {
        match character {
            '"' => quoted = !quoted,
            ',' if !quoted => fields.push(String::new()),
            other => fields.last_mut().expect("there is one from the start").push(other),
        }
    }
    fields
}

fn rows(table: &str) -> Result<Vec<Row>, Box<dyn Error>> {
    let parse = |line: &str| {
        let [group, capability, library, _target, _level, flash, _ram, stack, _compiler] =
            fields(line).try_into().map_err(|fields: Vec<String>| format!("{} fields in `{line}`", fields.len()))?;
        let stack = if stack.is_empty() { None } else { Some(stack.parse()?) };
        Ok(Row { group, capability, library, flash: flash.parse()?, stack })
    };
    table.lines().skip(1).map(parse).collect()
}

/// The rows of a panel, those of a capability together, in the order that capabilities first come in.
fn by_capability<'r>(rows: &'r [Row], group: &str) -> Vec<(&'r str, Vec<&'r Row>)> {
    let mut capabilities: Vec<(&str, Vec<&Row>)> = Vec::new();
    for row in rows.iter().filter(|row| row.group == group) {
        match capabilities.iter_mut().find(|(capability, _)| *capability == row.capability) {
            Some((_, rows)) => rows.push(row),
            None => capabilities.push((&row.capability, vec![row])),
        }
    }
    capabilities
}

fn panel_height(capabilities: &[(&str, Vec<&Row>)]) -> i32 {
    let rows = capabilities.iter().map(|(_, rows)| rows.len() as i32 * BAR_HEIGHT + ROW_GAP);
    TITLE_HEIGHT + rows.sum::<i32>()
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments = Arguments::parse();
    let rows = rows(&fs::read_to_string(&arguments.table)?)?;
    let panels: Vec<_> = PANELS
        .into_iter()
        .map(|(group, title)| (title, by_capability(&rows, group)))
        .filter(|(_, capabilities)| !capabilities.is_empty())
        .collect();
    let height = LEGEND_HEIGHT + panels.iter().map(|(_, capabilities)| panel_height(capabilities)).sum::<i32>() + 10;

    let area = SVGBackend::new(&arguments.picture, (WIDTH.unsigned_abs(), height.unsigned_abs())).into_drawing_area();
    area.fill(&WHITE)?;
    let text = |size: i32| ("sans-serif", size).into_font().color(&BLACK);
    let left = |size: i32| text(size).pos(Pos::new(HPos::Left, VPos::Center));
    let mut x = LABEL_WIDTH;
    for (library, width) in
        [("embedded-graphics", 150), ("spanfill", 90), ("spanfill, anti-aliased", 170), ("methods", 100)]
    {
        area.draw(&Rectangle::new([(x, 10), (x + 12, 20)], colour(library).filled()))?;
        area.draw(&Text::new(library, (x + 17, 15), left(12)))?;
        x += width;
    }
    area.draw(&Text::new("bytes of flash", (x + 10, 15), left(12)))?;

    let mut y = LEGEND_HEIGHT;
    for (title, capabilities) in &panels {
        area.draw(&Text::new(*title, (10, y + TITLE_HEIGHT / 2), left(14)))?;
        y += TITLE_HEIGHT;
        let most = capabilities.iter().flat_map(|(_, rows)| rows).map(|row| row.flash).max().unwrap_or(1).max(1);
        let room = i64::from(WIDTH - LABEL_WIDTH - 150);
        for (capability, rows) in capabilities {
            let middle = y + rows.len() as i32 * BAR_HEIGHT / 2;
            let right = text(12).pos(Pos::new(HPos::Right, VPos::Center));
            area.draw(&Text::new(*capability, (LABEL_WIDTH - 8, middle), right))?;
            for row in rows {
                let end = LABEL_WIDTH + i32::try_from(row.flash * room / most)?;
                let bar = [(LABEL_WIDTH, y + 1), (end.max(LABEL_WIDTH + 1), y + BAR_HEIGHT)];
                area.draw(&Rectangle::new(bar, colour(&row.library).filled()))?;
                let stack = row.stack.map(|stack| format!(" (stack {stack})")).unwrap_or_default();
                area.draw(&Text::new(format!("{}{stack}", row.flash), (end + 5, y + BAR_HEIGHT / 2 + 1), left(9)))?;
                y += BAR_HEIGHT;
            }
            y += ROW_GAP;
        }
    }
    area.present()?;
    Ok(())
}
