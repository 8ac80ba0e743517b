//! The tables for readers, in Markdown.

use std::fmt::Write as _;

use crate::{
    gallery::{VARIANTS, growth::Query, row::Rows},
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
    let growths = rows.growths();
    if !growths.is_empty() {
        let unit = unit(rows);
        let _ = writeln!(
            table,
            "| more vertices | times as many | spanfill-aa, {unit} | times | vello-cpu-baseline, {unit} | times \
             | zeno-mask, {unit} | times | aa / vello_cpu baseline |\n|---|{}",
            "--:|".repeat(8)
        );
    }
    for (from, to) in growths {
        let vertices = rows.growth(&from, &to, Variant::AntiAliased).map(|(_, vertices)| vertices);
        let _ = write!(table, "| {to} | {} |", ratio(vertices));
        for variant in [Variant::AntiAliased, Variant::VelloBaseline, Variant::Zeno] {
            let cost = rows.get(&to, variant).map(|row| in_unit(row.cost)).unwrap_or_default();
            let times = rows.growth(&from, &to, variant).map(|(cost, _)| cost);
            let _ = write!(table, " {cost} | {} |", ratio(times));
        }
        let _ = writeln!(table, " {} |", ratio(rows.ratio(&to, Variant::AntiAliased, Variant::VelloBaseline)));
    }
    if !queries.is_empty() {
        let _ = writeln!(
            table,
            "\n| scratch for an outline of | `coverage_edges`, ms | `coverage_edges_in`, ms \
             | `coverage_edges_at_most`, ms |"
        );
        let _ = writeln!(table, "|---|--:|--:|--:|");
        for Query { vertices, exact_ns, sorted_ns, bound_ns } in queries {
            let [exact, sorted, bound] = [exact_ns, sorted_ns, bound_ns].map(|ns| ns / 1e6);
            let _ = writeln!(table, "| {vertices} vertices | {exact:.3} | {sorted:.3} | {bound:.3} |");
        }
    }
    table
}

/// How far coverage is from the area, of those that tell.
pub(super) fn errors(rows: &Rows) -> String {
    let mut table = String::new();
    let variants: Vec<Variant> = VARIANTS
        .into_iter()
        .filter(|variant| rows.rows.iter().any(|row| row.variant == *variant && row.error.is_some()))
        .collect();
    if variants.is_empty() {
        return table;
    }
    let _ = writeln!(table, "| largest, mean error in 255ths | {} |", Variant::list(&variants).replace(", ", " | "));
    let _ = writeln!(table, "|---|{}", "--:|".repeat(variants.len()));
    for name in rows.drawings() {
        let _ = write!(table, "| {name} |");
        for &variant in &variants {
            match rows.get(name, variant).and_then(|row| row.error) {
                Some(error) => _ = write!(table, " {:.2}, {:.2} |", error.max, error.mean),
                None => table.push_str(" |"),
            }
        }
        table.push('\n');
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
