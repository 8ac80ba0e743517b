//! Where polygons fail.

use super::report::{Report, outcomes};
use crate::{
    measure::{Aim, Scene, Suite, subjects::outline},
    random::Random,
    scenes,
    variants::polygon::{Outline, POLYGONS},
};

const ONE: i32 = 256;

pub(crate) fn report(report: &mut Report) {
    let suite = suite();
    report.heading("Polygons: horizontal edges, and vertices on scan lines");
    report.say(
        "Combs and stairs whose vertices all lie on pixel centres: every other edge is level, every vertex is on a scan line. \
         An active edge table that keeps an edge at its Ymax, or counts a vertex for both of its edges, pairs the wrong \
         crossings. A centre on the outline is *another tie*.",
    );
    report.pixels("levels", "level edges, by the methods that are worst", outcomes(&suite, "levels"));
    report.heading("Polygons: outlines that cross themselves");
    report.say(
        "Random contours of nine vertices, by both rules. A fan fills what the outline surrounds in whatever way; ears need a \
         vertex wherever the outline crosses itself, and round it; seed fill fills the one region that its seed is in.",
    );
    report.pixels(
        "crossings",
        "contours that cross themselves, by the methods that are worst",
        outcomes(&suite, "crossings"),
    );
    report.heading("Seed fill: through diagonal gaps");
    report.say(
        "Diamonds, and two triangles that meet in a point. Outlines one pixel thin are 8-connected: an 8-connected fill leaves \
         through their diagonals, all over the screen. A 4-connected one stays inside, and does not reach what lies behind a \
         passage that is narrower than a pixel.",
    );
    report.pixels("gaps", "diagonal gaps, by the methods that are worst", outcomes(&suite, "gaps"));
}

fn suite() -> Suite {
    let scenes = vec![
        Scene { name: "levels", shapes: (0..30).map(levels).collect() },
        Scene { name: "crossings", shapes: (0..40).map(|index| made("self-intersecting", index)).collect() },
        Scene { name: "gaps", shapes: (0..24).map(gaps).collect() },
    ];
    Suite::new("polygon", POLYGONS, scenes, |_, _| Aim::Fill)
}

fn centre(x: i32, y: i32) -> [i32; 2] {
    [x * ONE + ONE / 2, y * ONE + ONE / 2]
}

/// A comb, or stairs up and down, on pixel centres.
fn levels(index: u64) -> Outline {
    let mut random = Random::new(0x1E7E + index);
    let (left, bottom) = (30 + random.below(60), 150 + random.below(60));
    let mut x = left;
    let mut contour = vec![centre(left, bottom)];
    for _ in 0..5 {
        let top = bottom - 2 - random.below(40);
        contour.push(centre(x, top));
        x += 1 + random.below(6);
        contour.push(centre(x, top));
        if index.is_multiple_of(2) {
            // A tooth's gap, down to a level of its own.
            let floor = bottom - random.below(2);
            contour.push(centre(x, floor));
            x += 1 + random.below(5);
            contour.push(centre(x, floor));
        }
    }
    contour.push(centre(x, bottom));
    outline(vec![contour], index.is_multiple_of(3))
}

/// A diamond, or two triangles that meet in a point.
fn gaps(index: u64) -> Outline {
    let mut random = Random::new(0x6A95 + index);
    let (x, y, size) = (60 + random.below(180), 60 + random.below(100), 4 + random.below(30));
    let contour = if index.is_multiple_of(2) {
        vec![centre(x, y - size), centre(x + size, y), centre(x, y + size), centre(x - size, y)]
    } else {
        vec![
            centre(x - size, y - size),
            centre(x + size, y + size),
            centre(x + size, y - size),
            centre(x - size, y + size),
        ]
    };
    outline(vec![contour], false)
}

/// A polygon of a scene of the charts.
fn made(scene: &str, index: usize) -> Outline {
    let mut vertices = [[0; 2]; scenes::MOST_VERTICES];
    let count = scenes::polygon(scene, index, &mut vertices);
    outline(vec![vertices[..count].to_vec()], index % 2 == 1)
}
