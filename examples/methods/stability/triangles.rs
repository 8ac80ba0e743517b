//! Where triangles fail.

use super::report::{Outcome, POWERS, Report, outcomes};
use crate::{
    measure::{Aim, Scene, Suite, new_picture},
    random::Random,
    variants::{self, Variant},
};

type Triangle = [[i32; 2]; 3];

const ONE: i32 = 256;
pub(crate) const FAMILIES: [&str; 2] = ["triangle: inside test", "triangle: traversal"];

pub(crate) fn report(report: &mut Report) {
    let suites = FAMILIES.map(suite);
    let all = |scene: &str| -> Vec<Outcome> { suites.iter().flat_map(|suite| outcomes(suite, scene)).collect() };
    report.heading("Triangles: slivers");
    report.say(
        "100 px long, in any direction, 1/256 to 2 px wide at the base. A sliver covers few centres, and an edge that is \
         moved by less than it is wide can lose or gain all of them.",
    );
    report.pixels("slivers", "slivers, by the methods that are worst", all("slivers"));
    report.heading("Triangles: nearly collinear vertices");
    report.say(
        "Twice the area is 3 to 62 in units of 1/65536 px², over 100 px: less than one part in a million of what is \
         subtracted. Rounding decides on which side of the long edge the third vertex lies, or that there is no area.",
    );
    report.pixels("collinear", "nearly collinear vertices, by the methods that are worst", all("collinear"));
    report.heading("Triangles: edges through pixel centres");
    report.say(
        "All vertices lie on pixel centres, and the edges are level, upright or diagonal: centres lie on edges everywhere. \
         Whoever has no rule for ties draws all of these pixels, and draws them again with the neighbour's; \
         *another tie* counts those. What is missing or extra besides is an error that no rule excuses.",
    );
    report.pixels("centres", "edges through centres, by the methods that are worst", all("centres"));
    report.heading("Triangles: order of vertices");
    report.say(
        "30 triangles of each of the two scenes above in all six orders: pixels that differ from those of the first order, added \
         up. A method that gives another picture for another order opens cracks where neighbours name their common \
         vertices in another order.",
    );
    orders(report, &suites);
    report.heading("Triangles: coordinates that grow");
    report.say(
        "Vertices 2^k px away from the screen, edges across it: the first k at which some pixel of 12 triangles is wrong \
         (for k = 7, everything is near the screen; 22 is the end of the coordinates' range). `-`: never.",
    );
    report.powers(&suites);
}

pub(crate) fn suite(family: &'static str) -> Suite {
    let mut scenes = vec![
        Scene { name: "slivers", shapes: (0..120).map(|index| crate::scenes::triangle("slivers", index)).collect() },
        Scene { name: "collinear", shapes: (0..120).map(collinear).collect() },
        Scene { name: "centres", shapes: (0..60).map(centres).collect() },
    ];
    for (k, name) in POWERS.iter().enumerate().take(MOST_POWER + 1).skip(LEAST_POWER) {
        scenes.push(Scene { name, shapes: (0..12).map(|index| far(k, index)).collect() });
    }
    scenes.push(Scene { name: "equal x", shapes: (0..200).map(equal_x).collect() });
    Suite::new(family, list(family), scenes, |_, _| Aim::Fill)
}

/// A vertex next to the line between two others.
fn collinear(index: u64) -> Triangle {
    let mut random = Random::new(0xC011 + index);
    let start = [(40 + random.below(100)) * ONE, (30 + random.below(60)) * ONE];
    // A step of whole sub-pixels, taken many times; then beside the line by what the least area takes.
    let step = [20 + random.below(12), 3 + random.below(17)];
    let times = 600 + random.below(400);
    let at = |times: i32| [start[0] + step[0] * times, start[1] + step[1] * times];
    let [a, b] = [at(0), at(times)];
    let mut c = at(1 + random.below(times - 1));
    let beside = 1 + random.below(2);
    c[usize::from(random.below(2) == 1)] += if random.below(2) == 1 { beside } else { -beside };
    [a, b, c]
}

/// Vertices on pixel centres, edges level, upright or diagonal.
fn centres(index: u64) -> Triangle {
    let mut random = Random::new(0xCE47 + index);
    let centre = |x: i32, y: i32| [x * ONE + 128, y * ONE + 128];
    let (x, y, size) = (40 + random.below(200), 40 + random.below(120), 3 + random.below(24));
    match random.below(4) {
        0 => [centre(x, y), centre(x + size, y), centre(x, y + size)],
        1 => [centre(x, y), centre(x + size, y + size), centre(x - size, y + size)],
        2 => [centre(x, y), centre(x + size, y - size), centre(x + size, y + size)],
        _ => [centre(x, y), centre(x + 2 * size, y + size), centre(x + size, y + 2 * size)],
    }
}

pub(crate) fn list(family: &str) -> &'static [Variant<Triangle>] {
    if family == FAMILIES[0] { variants::triangle::INSIDE } else { variants::triangle::TRAVERSAL }
}

/// No area: all vertices on an upright line, at heights that are no whole numbers.
fn equal_x(index: u64) -> Triangle {
    let mut random = Random::new(0xE9A1 + index);
    let x = (20 + random.below(200)) * ONE + random.below(ONE);
    [0, 1, 2].map(|_| [x, (10 + random.below(200)) * ONE + random.below(ONE)])
}

const LEAST_POWER: usize = 7;
const MOST_POWER: usize = 22;

/// One edge leads across the screen, from and to places 2^k px away; the third vertex is as far to a side.
fn far(k: usize, index: u64) -> Triangle {
    let mut random = Random::new(0xFA2 + index);
    let middle =
        [(20 + random.below(280)) * ONE + random.below(ONE), (20 + random.below(200)) * ONE + random.below(ONE)];
    let reach = 1_i64 << (k + 8);
    // A part of the reach, in any direction.
    let mut part = || (i64::from(random.below(2001)) - 1000) * reach / 1024 + i64::from(random.below(ONE));
    let (to, away) = ([part(), part()], [part(), part()]);
    let place = |offset: [i64; 2]| {
        [0, 1].map(|axis| {
            let at = i64::from(middle[axis]) + offset[axis];
            at.clamp(i32::MIN.into(), i32::MAX.into()) as i32
        })
    };
    [place(to), place([-to[0], -to[1]]), place(away)]
}

/// The pixels by which pictures of other orders of the vertices differ.
fn orders(report: &mut Report, suites: &[Suite]) {
    const ORDERS: [[usize; 3]; 6] = [[0, 1, 2], [1, 2, 0], [2, 0, 1], [0, 2, 1], [2, 1, 0], [1, 0, 2]];
    let shapes: Vec<Triangle> = (0..30).map(collinear).chain((0..30).map(centres)).collect();
    let mut rows = Vec::new();
    let mut steady = Vec::new();
    let mut pictures = [new_picture(), new_picture()];
    for suite in suites {
        let ordered: Vec<Triangle> =
            shapes.iter().flat_map(|shape| ORDERS.map(|order| order.map(|corner| shape[corner]))).collect();
        let scene = vec![Scene { name: "orders", shapes: ordered }];
        let suite = Suite::new(suite.family, list(suite.family), scene, |_, _| Aim::Fill);
        for entry in &suite.entries {
            let (mut differing, mut triangles) = (0, 0);
            for shape in 0..shapes.len() {
                let [first, other] = &mut pictures;
                let _ = suite.draw(entry, 0, shape * 6, first);
                let by: usize = (1..6)
                    .map(|order| {
                        let _ = suite.draw(entry, 0, shape * 6 + order, other);
                        first.count.iter().zip(&other.count).filter(|(a, b)| (**a == 0) != (**b == 0)).count()
                    })
                    .sum();
                differing += by;
                triangles += usize::from(by > 0);
            }
            if differing > 0 || entry.is_shipped() {
                rows.push((
                    entry.is_shipped(),
                    differing,
                    vec![entry.label(), triangles.to_string(), differing.to_string()],
                ));
            } else {
                steady.push(entry.label());
            }
        }
    }
    rows.sort_by(|a, b| (b.0, b.1).cmp(&(a.0, a.1)).then_with(|| a.2.cmp(&b.2)));
    rows.dedup();
    let rows: Vec<Vec<String>> = rows.into_iter().map(|(_, _, row)| row).collect();
    report.table(&["method", "triangles of 60 that differ", "pixels that differ"], &rows);
    report.say(&format!("The order makes no difference to {} others.", steady.len()));
}
