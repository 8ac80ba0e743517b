//! How fast spanfill must at least be.

use std::fmt;

use crate::{
    row::{Rows, full_name},
    scenes::Scene,
    variant::Variant,
};

/// spanfill must be `times` as fast as the peer on the scene.
#[derive(Debug, Clone, Copy)]
struct Bar {
    scene: Scene,
    peer: Variant,
    times: f64,
}

const fn bar(scene: Scene, peer: Variant, times: f64) -> Bar {
    Bar { scene, peer, times }
}

const BARS: [Bar; 11] = [
    bar(Scene::Triangles(10), Variant::EmbeddedGraphics, 16.0),
    bar(Scene::Triangles(50), Variant::EmbeddedGraphics, 16.0),
    bar(Scene::Triangles(200), Variant::EmbeddedGraphics, 16.0),
    bar(Scene::Triangles(10), Variant::TinySkia, 6.0),
    bar(Scene::Triangles(200), Variant::TinySkia, 1.9),
    bar(Scene::Concave64, Variant::TinySkia, 1.6),
    bar(Scene::Circles(5), Variant::EmbeddedGraphics, 2.0),
    bar(Scene::Circles(20), Variant::EmbeddedGraphics, 2.0),
    bar(Scene::Circles(100), Variant::EmbeddedGraphics, 2.0),
    bar(Scene::Lines(50), Variant::EmbeddedGraphics, 1.6),
    bar(Scene::Lines(200), Variant::EmbeddedGraphics, 1.6),
];

/// A bar and what was measured.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Verdict {
    bar: Bar,
    measured: f64,
    /// What a rasterizer would reach that costs nothing beside the filling.
    limit: f64,
}

impl Verdict {
    pub(crate) fn is_reached(&self) -> bool {
        self.measured >= self.bar.times
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { bar: Bar { scene, peer, times }, measured, limit } = self;
        let (scene, verdict) = (full_name(*scene), if self.is_reached() { "reached" } else { "NOT reached" });
        write!(
            f,
            "{scene:<14} {times:>4.1} x as fast as {peer:<17}: {measured:>5.2} x, {verdict} (the floor: {limit:.1} x)"
        )
    }
}

/// The bars for what was measured.
pub(crate) fn verdicts(rows: &Rows) -> Vec<Verdict> {
    let verdict = |bar: Bar| {
        let measured = rows.ratio(bar.scene, bar.peer, Variant::Spanfill)?;
        Some(Verdict { bar, measured, limit: rows.ratio(bar.scene, bar.peer, Variant::Floor)? })
    };
    BARS.into_iter().filter_map(verdict).collect()
}
