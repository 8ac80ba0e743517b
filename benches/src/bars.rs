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
    spanfill: Variant,
    /// What costs nothing beside setting the same pixels.
    floor: Variant,
}

const fn bar(scene: Scene, peer: Variant, times: f64) -> Bar {
    Bar { scene, peer, times, spanfill: Variant::Spanfill, floor: Variant::Floor }
}

const BARS: [Bar; 11] = [
    bar(Scene::Triangles(10), Variant::EmbeddedGraphics, 16.0),
    bar(Scene::Triangles(50), Variant::EmbeddedGraphics, 16.0),
    bar(Scene::Triangles(200), Variant::EmbeddedGraphics, 16.0),
    bar(Scene::Triangles(10), Variant::TinySkia, 6.0),
    bar(Scene::Triangles(200), Variant::TinySkia, 1.9),
    bar(Scene::Concave64(100), Variant::TinySkia, 1.6),
    bar(Scene::Circles(5), Variant::EmbeddedGraphics, 2.0),
    bar(Scene::Circles(20), Variant::EmbeddedGraphics, 2.0),
    bar(Scene::Circles(100), Variant::EmbeddedGraphics, 2.0),
    bar(Scene::Lines(50), Variant::EmbeddedGraphics, 1.6),
    bar(Scene::Lines(200), Variant::EmbeddedGraphics, 1.6),
];

/// Blended over what the frame shows, at most vello_cpu's time by the same instructions, and where there is little but
/// pixels to fill, this part of it.
const PART_OF_VELLO: [(Scene, f64); 2] = [(Scene::Triangles(200), 0.6), (Scene::Stars(100), 0.6)];

fn part_of_vello(scene: Scene) -> f64 {
    PART_OF_VELLO.into_iter().find(|(special, _)| *special == scene).map_or(1.0, |(_, part)| part)
}

/// Outlines without curves: a fifth of tiny-skia's time, and less than it takes others to write a mask that is still to
/// be blended.
const STRAIGHT: [Scene; 5] =
    [Scene::Triangles(10), Scene::Triangles(50), Scene::Triangles(200), Scene::Stars(100), Scene::Concave64(100)];

fn anti_aliased() -> impl Iterator<Item = Bar> {
    let bar =
        |scene, peer, times| Bar { scene, peer, times, spanfill: Variant::AntiAliased, floor: Variant::BlendFloor };
    let vello = Scene::ALL.into_iter().map(move |scene| bar(scene, Variant::VelloBaseline, 1.0 / part_of_vello(scene)));
    let others = [(Variant::TinySkiaAntiAliased, 5.0), (Variant::Zeno, 1.0), (Variant::AbGlyph, 1.0)];
    let straight = STRAIGHT.into_iter().flat_map(move |scene| others.map(|(peer, times)| bar(scene, peer, times)));
    vello.chain(straight)
}

/// A bar and what was measured.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Verdict {
    bar: Bar,
    measured: f64,
    /// What a rasterizer would reach that costs nothing beside the filling or the blending.
    limit: f64,
}

impl Verdict {
    pub(crate) fn is_reached(&self) -> bool {
        self.measured >= self.bar.times
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { bar: Bar { scene, peer, times, spanfill, floor }, measured, limit } = self;
        let (scene, verdict) = (full_name(*scene), if self.is_reached() { "reached" } else { "NOT reached" });
        write!(
            f,
            "{scene:<14} {spanfill:<11} {times:>5.2} x as fast as {peer:<18}: {measured:>5.2} x, {verdict} \
             (the {floor}: {limit:.1} x)"
        )
    }
}

/// The bars for what was measured.
pub(crate) fn verdicts(rows: &Rows) -> Vec<Verdict> {
    let verdict = |bar: Bar| {
        let measured = rows.ratio(bar.scene, bar.peer, bar.spanfill)?;
        Some(Verdict { bar, measured, limit: rows.ratio(bar.scene, bar.peer, bar.floor)? })
    };
    BARS.into_iter().chain(anti_aliased()).filter_map(verdict).collect()
}
