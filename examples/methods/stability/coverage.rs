//! Where anti-aliasing fails.

use spanfill::Vertex;

use super::report::{Report, outcomes};
use crate::{
    measure::{Aim, Scene, Suite, new_picture},
    random::Random,
    scenes,
    variants::antialias::{ANTIALIAS, Scene as Smooth},
};

const ONE: i32 = 256;

pub(crate) fn report(report: &mut Report) {
    let suite = suite();
    report.heading("Anti-aliasing: worst pixels of random triangles and stars");
    report.say(
        "Triangles of all kinds and contours that cross themselves: how far a pixel's coverage is off the exact area, beyond \
         what rounding takes, in 255ths. Methods that add up areas are wrong where an outline overlaps itself: the rule is \
         for each point, not for the sum.",
    );
    report.levels("coverage", "coverage, by the methods that are worst", "255ths", outcomes(&suite, "shapes"));
    report.heading("Anti-aliasing: bias");
    report.say(
        "Edges of every slope at 400 random places: the mean of drawn less exact over the pixels that an edge leads through, \
         in 255ths. A method without bias makes shapes neither larger nor smaller.",
    );
    bias(report, &suite);
    report.heading("Anti-aliasing: small objects that vanish or flicker");
    report.say(
        "A triangle of 0.6 px, and a bar 1/4 px wide and 8 px high, moved to the right by 1/16 px at a time: the least and the \
         most that a frame shows of it, in 255ths of its area. Exact areas show 255 in every frame, up to the rounding of a \
         few pixels.",
    );
    flicker(report, &suite);
}

fn vertex([x, y]: [i32; 2]) -> Vertex {
    Vertex::from_bits(x, y)
}

fn suite() -> Suite {
    let triangle = |scene: &'static str, index: usize| Smooth::Triangle(scenes::triangle(scene, index).map(vertex));
    let star = |index: usize| {
        let mut vertices = [[0; 2]; scenes::MOST_VERTICES];
        let count = scenes::polygon("self-intersecting", index, &mut vertices);
        let contour: &'static [Vertex] = Vec::leak(vertices[..count].iter().copied().map(vertex).collect());
        let rule = if index.is_multiple_of(2) { spanfill::FillRule::NonZero } else { spanfill::FillRule::EvenOdd };
        Smooth::Polygon(Vec::leak(vec![contour]), rule)
    };
    let triangles =
        ["typical", "small", "slivers"].into_iter().flat_map(|name| (0..12).map(move |index| (name, index)));
    let shapes = triangles.map(|(name, index)| triangle(name, index)).chain((20..28).map(star));
    let scenes = vec![
        Scene { name: "shapes", shapes: shapes.collect() },
        Scene { name: "edges", shapes: (0..400).map(edge).collect() },
        Scene { name: "speck", shapes: (0..32).map(speck).collect() },
        Scene { name: "bar", shapes: (0..32).map(bar).collect() },
    ];
    let mut suite = Suite::new("anti-aliasing", ANTIALIAS, scenes, |_, _| Aim::Coverage);
    suite.entries.retain(|entry| !entry.method.contains("texture") && !entry.method.starts_with("line's"));
    suite
}

/// A triangle one of whose edges leads through a pixel or two; the others lie on sides of pixels.
fn edge(index: u64) -> Smooth {
    let mut random = Random::new(0xED6E + index);
    let (x, y) = (20 * ONE, 20 * ONE);
    let [a, b] = [x + random.below(3 * ONE), x + random.below(3 * ONE)];
    Smooth::Polygon(
        Vec::leak(vec![&*Vec::leak(
            [[x - 2 * ONE, y], [a, y], [b, y + 2 * ONE], [x - 2 * ONE, y + 2 * ONE]].map(vertex).to_vec(),
        )]),
        spanfill::FillRule::NonZero,
    )
}

fn speck(step: i32) -> Smooth {
    let x = 20 * ONE + step * ONE / 16;
    Smooth::Triangle([[x, 20 * ONE + 40], [x + 154, 20 * ONE + 60], [x + 50, 20 * ONE + 194]].map(vertex))
}

fn bar(step: i32) -> Smooth {
    let x = 20 * ONE + step * ONE / 16;
    let corners = [[x, 10 * ONE + 30], [x + 64, 10 * ONE + 30], [x + 64, 18 * ONE + 30], [x, 18 * ONE + 30]];
    Smooth::Polygon(Vec::leak(vec![&*Vec::leak(corners.map(vertex).to_vec())]), spanfill::FillRule::NonZero)
}

fn scene_of(suite: &Suite, name: &str) -> usize {
    suite.scenes.iter().position(|(other, _)| *other == name).expect("a scene of the suite")
}

fn bias(report: &mut Report, suite: &Suite) {
    let scene = scene_of(suite, "edges");
    let mut picture = new_picture();
    let mut rows = Vec::new();
    for entry in &suite.entries {
        let (mut sum, mut squares, mut pixels) = (0.0, 0.0, 0.0);
        for shape in 0..suite.scenes[scene].1 {
            let truth = suite.truth(scene, shape, entry.aim);
            if suite.draw(entry, scene, shape, &mut picture).is_err() {
                continue;
            }
            for (at, exact) in truth.coverage.iter().enumerate().filter(|(_, exact)| **exact > 0.0 && **exact < 1.0) {
                let drawn = if picture.count[at] == 0 { 0.0 } else { f64::from(picture.coverage[at]) };
                sum += drawn - 255.0 * exact;
                squares += (drawn - 255.0 * exact).powi(2);
                pixels += 1.0;
            }
        }
        let pixels = f64::max(pixels, 1.0);
        rows.push(vec![entry.label(), format!("{:+.2}", sum / pixels), format!("{:.2}", f64::sqrt(squares / pixels))]);
    }
    report.table(&["method", "bias, 255ths", "root mean square, 255ths"], &rows);
}

fn flicker(report: &mut Report, suite: &Suite) {
    let mut picture = new_picture();
    let rows: Vec<Vec<String>> = suite
        .entries
        .iter()
        .map(|entry| {
            let range = |name: &str, picture: &mut crate::variants::Picture| {
                let scene = scene_of(suite, name);
                let shown = (0..suite.scenes[scene].1).map(|shape| {
                    let area: f64 = suite.truth(scene, shape, entry.aim).coverage.iter().sum();
                    let _ = suite.draw(entry, scene, shape, picture);
                    let sum: f64 = picture
                        .count
                        .iter()
                        .zip(&picture.coverage)
                        .map(|(count, coverage)| if *count == 0 { 0.0 } else { f64::from(*coverage) })
                        .sum();
                    sum / area
                });
                let shown: Vec<f64> = shown.collect();
                let (least, most) =
                    (shown.iter().copied().fold(f64::MAX, f64::min), shown.iter().copied().fold(0.0, f64::max));
                format!("{least:.0} to {most:.0}")
            };
            vec![entry.label(), range("speck", &mut picture), range("bar", &mut picture)]
        })
        .collect();
    report.table(&["method", "triangle of 0.6 px", "bar of 1/4 px"], &rows);
}
