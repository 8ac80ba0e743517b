//! The tables for readers, in Markdown.

use std::fmt::Write as _;

use crate::{
    gallery::{CUTS, VARIANTS, growth::Query, row::Rows},
    row::Unit,
    variant::Variant,
};

/// What every drawing costs, and by which factor.
pub(super) fn costs(rows: &Rows) -> String {
    let mut table = String::new();
    let unit = unit(rows);
    let names = VARIANTS.map(Variant::name).join(" | ");
    let _ = writeln!(
        table,
        "| a picture, {unit} | vertices | {names} | aa / vello_cpu baseline | aa / vello_cpu | aliased / tiny-skia |"
    );
    let _ = writeln!(table, "|---|--:|{}--:|--:|--:|", "--:|".repeat(VARIANTS.len()));
    let drawings = rows.drawings();
    for name in &drawings {
        let vertices = rows.rows.iter().find(|row| row.drawing == *name).map_or(0, |row| row.vertices);
        let _ = write!(table, "| {name} | {vertices} |");
        for variant in VARIANTS {
            let cost = rows.get(name, variant).map(|row| in_unit(row.cost));
            let _ = write!(table, " {} |", cost.unwrap_or_default());
        }
        for (one, other) in RATIOS {
            let _ = write!(table, " {} |", ratio(rows.ratio(name, one, other)));
        }
        table.push('\n');
    }
    let _ = write!(table, "| geometric mean | |{}", " |".repeat(VARIANTS.len()));
    for (one, other) in RATIOS {
        let _ = write!(table, " {} |", ratio(rows.mean_ratio(&drawings, one, other)));
    }
    table.push('\n');
    table
}

const RATIOS: [(Variant, Variant); 3] = [
    (Variant::AntiAliased, Variant::VelloBaseline),
    (Variant::AntiAliased, Variant::Vello),
    (Variant::Aliased, Variant::TinySkia),
];

/// What becomes of the times where every edge is cut, and what it costs to ask for the scratch.
pub(super) fn growth(rows: &Rows, queries: &[Query]) -> String {
    let mut table = String::new();
    let drawings = rows.drawings();
    let is_cut =
        |name: &&&str| CUTS.iter().any(|parts| rows.rows.iter().any(|row| row.drawing == format!("{name}/{parts}")));
    let cut: Vec<&&str> = drawings.iter().filter(is_cut).collect();
    if !cut.is_empty() {
        let _ = writeln!(
            table,
            "| every edge cut in | {} |",
            CUTS.map(|parts| format!(
                "{parts}: spanfill-aa, {} | of uncut | / vello_cpu baseline | zeno-mask",
                unit(rows)
            ))
            .join(" | ")
        );
        let _ = writeln!(table, "|---|{}", "--:|".repeat(4 * CUTS.len()));
        for name in cut {
            let _ = write!(table, "| {name} |");
            for parts in CUTS {
                let part = format!("{name}/{parts}");
                let cost = |variant| rows.get(&part, variant).map(|row| row.cost);
                let field = |variant| cost(variant).map(in_unit).unwrap_or_default();
                let whole = rows.get(name, Variant::AntiAliased).map(|row| row.cost);
                let growth = cost(Variant::AntiAliased).zip(whole).map(|(cut, whole)| cut / whole);
                let against = rows.ratio(&part, Variant::AntiAliased, Variant::VelloBaseline);
                let (aa, zeno) = (field(Variant::AntiAliased), field(Variant::Zeno));
                let _ = write!(table, " {aa} | {} | {} | {zeno} |", ratio(growth), ratio(against));
            }
            table.push('\n');
        }
    }
    if !queries.is_empty() {
        let _ =
            writeln!(table, "\n| scratch for an outline of | `coverage_edges`, ms | `coverage_edges_at_most`, ms |");
        let _ = writeln!(table, "|---|--:|--:|");
        for Query { vertices, exact_ns, bound_ns } in queries {
            let _ = writeln!(table, "| {vertices} vertices | {:.3} | {:.3} |", exact_ns / 1e6, bound_ns / 1e6);
        }
    }
    table
}

fn unit(rows: &Rows) -> &'static str {
    match rows.unit {
        Unit::Nanoseconds => "ms",
        Unit::Instructions => "million instructions",
    }
}

fn in_unit(cost: f64) -> String {
    format!("{:.3}", cost / 1e6)
}

fn ratio(ratio: Option<f64>) -> String {
    ratio.map(|ratio| format!("{ratio:.2}")).unwrap_or_default()
}
