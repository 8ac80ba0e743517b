//! A drawing measured, and all of them as CSV, with the columns that the scenes have.

use std::fmt;

use crate::{
    environment::TARGET,
    gallery::{CUTS, NOISY, SAMPLES, is_for_growth},
    row::{Difference, Unit},
    variant::Variant,
};

/// A variant measured on a drawing.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    pub(crate) drawing: String,
    pub(crate) vertices: usize,
    pub(crate) variant: Variant,
    /// Of a picture.
    pub(crate) cost: f64,
    /// Of the coverage, in 255ths; `None` where it was not asked for, or is not to be had.
    pub(crate) error: Option<Difference>,
}

/// The rows of one run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Rows {
    pub(crate) unit: Unit,
    pub(crate) rows: Vec<Row>,
}

impl Rows {
    pub(crate) fn get(&self, drawing: &str, variant: Variant) -> Option<&Row> {
        self.rows.iter().find(|row| row.drawing == drawing && row.variant == variant)
    }

    /// What the one costs, over what the other costs.
    pub(crate) fn ratio(&self, drawing: &str, one: Variant, other: Variant) -> Option<f64> {
        Some(self.get(drawing, one)?.cost / self.get(drawing, other)?.cost)
    }

    /// Those of the table, in the order in which they were measured: not those that are there for their growth.
    pub(crate) fn drawings(&self) -> Vec<&str> {
        let mut names: Vec<&str> = self.rows.iter().map(|row| &*row.drawing).collect();
        names.dedup();
        names.retain(|name| !is_for_growth(name));
        names
    }

    /// Pairs of which the second has more vertices than the first: cut edges, or more samples of noise.
    pub(crate) fn growths(&self) -> Vec<(String, String)> {
        let cut = |name: &str| CUTS.map(|parts| (name.to_owned(), format!("{name}/{parts}")));
        let samples = SAMPLES.map(|samples| format!("{NOISY}{samples}"));
        let noisy = samples.windows(2).map(|pair| (pair[0].clone(), pair[1].clone()));
        let drawings = self.drawings();
        let mut growths: Vec<(String, String)> = drawings.into_iter().flat_map(cut).chain(noisy).collect();
        let is_there = |name: &str| self.rows.iter().any(|row| row.drawing == name);
        growths.retain(|(from, to)| is_there(from) && is_there(to));
        growths
    }

    /// By how much the variant's cost grows from the one to the other, and the number of vertices.
    pub(crate) fn growth(&self, from: &str, to: &str, variant: Variant) -> Option<(f64, f64)> {
        let (from, to) = (self.get(from, variant)?, self.get(to, variant)?);
        Some((to.cost / from.cost, to.vertices as f64 / from.vertices as f64))
    }

    /// The geometric mean of that ratio over all drawings that have it.
    pub(crate) fn mean_ratio(&self, drawings: &[&str], one: Variant, other: Variant) -> Option<f64> {
        let ratios: Vec<f64> = drawings.iter().filter_map(|drawing| self.ratio(drawing, one, other)).collect();
        (!ratios.is_empty()).then(|| (ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp())
    }
}

/// As CSV: `px` is the number of vertices.
impl fmt::Display for Rows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "scene,variant,target,px,{},max_err,mean_err", self.unit.column())?;
        for Row { drawing, vertices, variant, cost, error } in &self.rows {
            write!(f, "{drawing},{variant},{TARGET},{vertices},{cost:.0},")?;
            match error {
                Some(Difference { max, mean }) => writeln!(f, "{max:.2},{mean:.2}")?,
                None => writeln!(f, ",")?,
            }
        }
        Ok(())
    }
}
