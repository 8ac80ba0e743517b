//! The table for readers, in Markdown.

use std::fmt::{self, Write as _};

use crate::{
    row::{Rows, Unit},
    scenes::Scene,
    variant::Variant,
};

use Variant::{EmbeddedGraphics, Floor, Spanfill, TinySkia, TinySkiaKeptPath};

/// What every scene costs, and by which factor; an empty field where a library has no such shape.
pub(crate) fn markdown(rows: &Rows) -> String {
    let mut table = String::new();
    write_table(&mut table, rows).expect("a string takes everything");
    table
}

fn write_table(table: &mut String, rows: &Rows) -> fmt::Result {
    let unit = match rows.unit {
        Unit::Nanoseconds => "ns",
        Unit::Instructions => "instructions",
    };
    writeln!(
        table,
        "| a shape, {unit} | floor | spanfill | embedded-graphics | tiny-skia | tiny-skia, path kept | spanfill / floor \
         | embedded-graphics / spanfill | tiny-skia / spanfill | other pixels per 1000: embedded-graphics, tiny-skia |"
    )?;
    writeln!(table, "|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|")?;
    for scene in rows.scenes() {
        write!(table, "| {} |", title(scene))?;
        for variant in [Floor, Spanfill, EmbeddedGraphics, TinySkia, TinySkiaKeptPath] {
            write_field(table, rows.get(scene, variant).map(|row| row.cost), 0)?;
        }
        write_field(table, rows.ratio(scene, Spanfill, Floor), 2)?;
        write_field(table, rows.ratio(scene, EmbeddedGraphics, Spanfill), 1)?;
        write_field(table, rows.ratio(scene, TinySkia, Spanfill), 1)?;
        let differing = |variant| match rows.get(scene, variant) {
            Some(row) => format!("{:.1}", row.difference.per_thousand),
            None => "-".to_owned(),
        };
        writeln!(table, " {}, {} |", differing(EmbeddedGraphics), differing(TinySkia))?;
    }
    Ok(())
}

fn write_field(table: &mut String, value: Option<f64>, decimals: usize) -> fmt::Result {
    match value {
        Some(value) => write!(table, " {value:.decimals$} |"),
        None => write!(table, " |"),
    }
}

/// The scene as readers know it.
pub(crate) fn title(scene: Scene) -> String {
    match scene {
        Scene::Triangles(box_px) => format!("triangle, {box_px} px box"),
        Scene::Circles(radius_px) => format!("circle, r = {radius_px} px"),
        Scene::Lines(box_px) => format!("thin line, {box_px} px box"),
        Scene::Star => format!("five-point star, r = {} px", scene.size_px()),
        Scene::Concave64 => "concave polygon, 64 vertices".to_owned(),
    }
}
