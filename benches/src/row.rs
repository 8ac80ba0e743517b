//! A measurement, and measurements as CSV.

use std::{fmt, str::FromStr};

use crate::{environment::TARGET, scenes::Scene, variant::Variant};

/// What a shape costs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Unit {
    Nanoseconds,
    Instructions,
}

impl Unit {
    /// The column's name in CSV.
    pub(crate) const fn column(self) -> &'static str {
        match self {
            Self::Nanoseconds => "ns",
            Self::Instructions => "instructions",
        }
    }
}

/// How far a variant's pixels are from what they should be.
///
/// Without anti-aliasing, from those of spanfill, which its tests hold to the exact rule: see
/// [`agreement`](crate::agreement). With it, from the exact areas: see [`accuracy`](crate::accuracy).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Difference {
    /// The most pixels that differ in one shape; or the largest error of a pixel, in 255ths.
    pub(crate) max: f64,
    /// The pixels that differ, per thousand that spanfill draws; or the mean error of those covered in part, in 255ths.
    pub(crate) mean: f64,
}

/// A variant measured on a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Row {
    pub(crate) scene: Scene,
    pub(crate) variant: Variant,
    /// Of one shape.
    pub(crate) cost: f64,
    pub(crate) difference: Difference,
}

/// The rows of one run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Rows {
    pub(crate) unit: Unit,
    pub(crate) rows: Vec<Row>,
}

impl Rows {
    pub(crate) fn get(&self, scene: Scene, variant: Variant) -> Option<&Row> {
        self.rows.iter().find(|row| row.scene == scene && row.variant == variant)
    }

    /// What the one costs, over what the other costs.
    pub(crate) fn ratio(&self, scene: Scene, one: Variant, other: Variant) -> Option<f64> {
        Some(self.get(scene, one)?.cost / self.get(scene, other)?.cost)
    }

    /// The scenes that were measured, in the order of the tables.
    pub(crate) fn scenes(&self) -> impl Iterator<Item = Scene> {
        Scene::ALL.into_iter().filter(|&scene| self.rows.iter().any(|row| row.scene == scene))
    }
}

/// As CSV.
impl fmt::Display for Rows {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "scene,variant,target,px,{},max_err,mean_err", self.unit.column())?;
        for Row { scene, variant, cost, difference: Difference { max, mean } } in &self.rows {
            let (name, px) = (scene.name(), scene.size_px());
            // Whole numbers stay whole.
            let max = (max * 100.0).round() / 100.0;
            writeln!(f, "{name},{variant},{TARGET},{px},{cost:.1},{max},{mean:.2}")?;
        }
        Ok(())
    }
}

/// From CSV.
impl FromStr for Rows {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut lines = text.lines().enumerate();
        let header = lines.next().map(|(_, header)| header).unwrap_or_default();
        let unit = [Unit::Nanoseconds, Unit::Instructions]
            .into_iter()
            .find(|unit| header == format!("scene,variant,target,px,{},max_err,mean_err", unit.column()))
            .ok_or("the first line names other columns than this program writes")?;
        let rows = lines
            .map(|(index, line)| row_from(line).map_err(|reason| format!("line {}: {reason}", index + 1)))
            .collect::<Result<_, _>>()?;
        Ok(Self { unit, rows })
    }
}

fn row_from(line: &str) -> Result<Row, String> {
    let fields: Vec<&str> = line.split(',').collect();
    let [scene, variant, _target, px, cost, max, mean] = fields[..] else {
        return Err(format!("{} fields in place of 7", fields.len()));
    };
    Ok(Row {
        scene: scene_from(&format!("{scene}-{px}"))?,
        variant: variant.parse()?,
        cost: number(cost)?,
        difference: Difference { max: number(max)?, mean: number(mean)? },
    })
}

fn number<T: FromStr>(field: &str) -> Result<T, String> {
    field.parse().map_err(|_| format!("'{field}' is no such number as belongs here"))
}

/// The scene's name on the command line: with its size.
pub(crate) fn full_name(scene: Scene) -> String {
    format!("{}-{}", scene.name(), scene.size_px())
}

/// The scene with this [`full_name`].
pub(crate) fn scene_from(name: &str) -> Result<Scene, String> {
    Scene::ALL
        .into_iter()
        .find(|&scene| full_name(scene) == name)
        .ok_or_else(|| format!("no scene is called that; there are {}", Scene::ALL.map(full_name).join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn csv_reads_back_as_it_was_written() {
        let row = |scene, variant, cost| Row { scene, variant, cost, difference: Difference { max: 3.0, mean: 1.25 } };
        let rows = Rows {
            unit: Unit::Nanoseconds,
            rows: vec![
                row(Scene::Triangles(10), Variant::Spanfill, 100.5),
                row(Scene::Concave64(20), Variant::TinySkiaKeptPath, 2000.0),
                row(Scene::Stars(100), Variant::AntiAliasedOver, 3000.0),
            ],
        };
        assert_eq!(rows.to_string().parse(), Ok(rows));
    }

    #[test]
    fn a_broken_line_is_named() {
        let text = "scene,variant,target,px,ns,max_err,mean_err\ntriangle,spanfill,x,10,fast,0,0\n";
        assert_eq!(text.parse::<Rows>(), Err("line 2: 'fast' is no such number as belongs here".to_owned()));
    }
}
