//! Instruction counts, the same in every run, by running one variant at a time under valgrind.

use std::{env, fs, process::Command};

use crate::{lineup, scenes::Scene, variant::Variant};

/// Draws so many shapes of the scene, from the first again when it has fewer, in [`measured`].
pub(crate) fn profile(scene: Scene, variant: Variant, shapes: usize) -> Result<(), String> {
    let mut drawing = lineup::drawing(scene, variant).ok_or_else(|| format!("{variant} has no {}", scene.name()))?;
    // Symbols are looked up the first time.
    drawing.draw(0..1);
    measured(&mut || {
        let mut left = shapes;
        while left > 0 {
            let now = left.min(drawing.shapes());
            drawing.draw(0..now);
            left -= now;
        }
    });
    Ok(())
}

/// What callgrind is told to count: a function that keeps its name.
#[inline(never)]
pub(crate) fn measured(work: &mut dyn FnMut()) {
    work();
}

const MEASURED: &str = "spanfill_benches::callgrind::measured";

/// The instructions of a shape of the scene, or of a picture of the drawing.
pub(crate) fn instructions(name: &str, variant: Variant, shapes: usize) -> Result<f64, String> {
    let program = env::current_exe().map_err(|error| format!("where this program is: {error}"))?;
    let counts = env::temp_dir().join(format!("spanfill-benches-{}.callgrind", std::process::id()));
    let mut valgrind = Command::new("valgrind");
    valgrind
        .args(["--tool=callgrind", &format!("--toggle-collect={MEASURED}")])
        .arg(format!("--callgrind-out-file={}", counts.display()))
        .arg(program)
        .args(["profile", name, variant.name(), "--shapes", &shapes.to_string()]);
    let output = valgrind.output().map_err(|error| format!("valgrind: {error}"))?;
    if !output.status.success() {
        return Err(format!("valgrind: {}\n{}", output.status, String::from_utf8_lossy(&output.stderr)));
    }
    let text = fs::read_to_string(&counts).map_err(|error| format!("{}: {error}", counts.display()))?;
    // It is in the way of nobody, should it stay.
    let _ = fs::remove_file(&counts);
    match total(&text) {
        Some(total) if total > 0 => Ok(total as f64 / shapes as f64),
        _ => Err(format!("callgrind counted nothing in {MEASURED}")),
    }
}

/// From callgrind's file of counts.
fn total(counts: &str) -> Option<u64> {
    let line = counts.lines().find_map(|line| line.strip_prefix("summary:").or(line.strip_prefix("totals:")))?;
    line.trim().parse().ok()
}
