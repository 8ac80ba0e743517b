//! The table for readers, in Markdown.

use std::fmt::{self, Write as _};

use crate::{
    row::{Rows, Unit},
    scenes::Scene,
    variant::Variant,
};

use Variant::{
    AbGlyph, Aliased, AntiAliased, AntiAliasedOver, BlendFloor, EmbeddedGraphics, Floor, Mask, Samples4, Samples16,
    SamplesWeighted, Spanfill, TinySkia, TinySkiaAntiAliased, TinySkiaKeptPath, Vello, VelloAlone, VelloBaseline, Zeno,
};

/// What every scene costs without anti-aliasing, and by which factor; an empty field where a library has no such shape.
pub(crate) fn aliased(rows: &Rows) -> String {
    written(|table| write_aliased(table, rows))
}

/// What every scene costs with anti-aliasing, and by which factor; then the errors.
pub(crate) fn anti_aliased(rows: &Rows) -> String {
    written(|table| write_anti_aliased(table, rows).and_then(|()| write_errors(table, rows)))
}

fn written(write: impl Fn(&mut String) -> fmt::Result) -> String {
    let mut table = String::new();
    write(&mut table).expect("a string takes everything");
    table
}

fn unit(rows: &Rows) -> &'static str {
    match rows.unit {
        Unit::Nanoseconds => "ns",
        Unit::Instructions => "instructions",
    }
}

fn write_aliased(table: &mut String, rows: &Rows) -> fmt::Result {
    writeln!(
        table,
        "| a shape, {} | floor | spanfill | embedded-graphics | tiny-skia | tiny-skia, path kept | spanfill / floor \
         | embedded-graphics / spanfill | tiny-skia / spanfill | other pixels per 1000: embedded-graphics, tiny-skia |",
        unit(rows)
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
            Some(row) => format!("{:.1}", row.difference.mean),
            None => "-".to_owned(),
        };
        writeln!(table, " {}, {} |", differing(EmbeddedGraphics), differing(TinySkia))?;
    }
    Ok(())
}

fn write_anti_aliased(table: &mut String, rows: &Rows) -> fmt::Result {
    writeln!(
        table,
        "| a shape, {} | aliased | blend floor | spanfill | spanfill, `Over` | tiny-skia | vello_cpu \
         | vello_cpu at its baseline | vello_cpu, one by one | masks: spanfill | zeno | ab_glyph | spanfill / aliased \
         | spanfill / vello_cpu | spanfill / vello_cpu at its baseline | spanfill / vello_cpu, one by one \
         | tiny-skia / spanfill |",
        unit(rows)
    )?;
    writeln!(table, "|---|{}", "--:|".repeat(16))?;
    for scene in rows.scenes() {
        write!(table, "| {} |", title(scene))?;
        for variant in [
            Aliased,
            BlendFloor,
            AntiAliased,
            AntiAliasedOver,
            TinySkiaAntiAliased,
            Vello,
            VelloBaseline,
            VelloAlone,
            Mask,
            Zeno,
            AbGlyph,
        ] {
            write_field(table, rows.get(scene, variant).map(|row| row.cost), 0)?;
        }
        write_field(table, rows.ratio(scene, AntiAliased, Aliased), 2)?;
        write_field(table, rows.ratio(scene, AntiAliased, Vello), 2)?;
        write_field(table, rows.ratio(scene, AntiAliased, VelloBaseline), 2)?;
        write_field(table, rows.ratio(scene, AntiAliased, VelloAlone), 2)?;
        write_field(table, rows.ratio(scene, TinySkiaAntiAliased, AntiAliased), 1)?;
        writeln!(table)?;
    }
    writeln!(table)
}

fn write_errors(table: &mut String, rows: &Rows) -> fmt::Result {
    let variants =
        [Aliased, Samples4, SamplesWeighted, Samples16, AntiAliased, TinySkiaAntiAliased, Vello, Zeno, AbGlyph];
    writeln!(
        table,
        "| largest, mean error in 255ths | aliased | 4x4 samples | weighted | 16x16 samples | spanfill | tiny-skia \
         | vello_cpu | zeno | ab_glyph |"
    )?;
    writeln!(table, "|---|{}", "--:|".repeat(variants.len()))?;
    for scene in rows.scenes() {
        write!(table, "| {} |", title(scene))?;
        for variant in variants {
            match rows.get(scene, variant) {
                Some(row) => write!(table, " {:.2}, {:.2} |", row.difference.max, row.difference.mean)?,
                None => write!(table, " |")?,
            }
        }
        writeln!(table)?;
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
        Scene::Stars(radius_px) => format!("five-point star, r = {radius_px} px"),
        Scene::Concave64(radius_px) => format!("concave polygon, 64 vertices, r = {radius_px} px"),
    }
}
