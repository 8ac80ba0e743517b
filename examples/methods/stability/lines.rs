//! Where lines fail.

use super::report::{POWERS, Report, outcomes};
use crate::{
    measure::{Aim, Scene, Suite},
    random::Random,
    variants::{Variant, line::LINES},
};

type Line = [[i32; 2]; 2];

pub(crate) fn report(report: &mut Report) {
    let suite = suite();
    report.heading("Lines: every direction");
    report.say(
        "Lines of 20 px to all sides. Printed code is for one octant or two, and draws something else in the others; \
         `floor` and a cut-off fraction take the lower of two rows, not the nearest.",
    );
    report.pixels("directions", "lines to all sides, by the methods that are worst", outcomes(&suite, "directions"));
    report.heading("Lines: exactly between two pixels");
    report.say(
        "All lines of even length up to 24 px in the first octant that lead between two pixels somewhere. Both are nearest: \
         which one is taken is *another tie*, and no error.",
    );
    report.pixels("halves", "lines between two pixels, by the methods that are worst", outcomes(&suite, "halves"));
    report.heading("Lines: drift over a long way");
    report.say(
        "Lines that come from 2^k px away, cross the screen and go on as far: the first k at which a pixel of 16 lines is \
         wrong. What is added up step by step in `f32` or with 16 fraction bits is off by as much as the steps' rounding \
         times their number, before the line has reached the screen.",
    );
    report.powers(std::slice::from_ref(&suite));
}

/// The methods that draw pixels that are there or not.
pub(crate) fn suite() -> Suite {
    let mut scenes = vec![
        Scene { name: "directions", shapes: (0..80).map(direction).collect() },
        Scene { name: "halves", shapes: halves() },
        Scene { name: "first octant", shapes: first_octant() },
    ];
    for (k, name) in POWERS.iter().enumerate().take(23).skip(8) {
        scenes.push(Scene { name, shapes: (0..16).map(|index| far(k, index)).collect() });
    }
    let mut suite = Suite::new("line", lines(), scenes, |_, _| Aim::Fill);
    let is_smooth =
        |method: &str, option: &str| ["Wu", "Gupta-Sproull"].contains(&method) || option == "exact coverage";
    suite.entries.retain(|entry| !is_smooth(entry.method, entry.option));
    suite
}

fn lines() -> &'static [Variant<Line>] {
    LINES
}

/// To the rim of a square, all around it.
fn direction(index: i32) -> Line {
    let (side, at) = (index / 20, index % 20 - 10);
    let [x, y] = [[at, -10], [10, at], [-at, 10], [-10, -at]][side as usize];
    [[160, 120], [160 + x, 120 + y]]
}

fn halves() -> Vec<Line> {
    let lines = (2..=24).step_by(2).flat_map(|dx| (1..=dx).map(move |dy| [[20, 20], [20 + dx, 20 + dy]]));
    // Somewhere 2 k dy is an odd multiple of dx.
    let is_halfway = |line: &Line| {
        let [dx, dy] = [line[1][0] - line[0][0], line[1][1] - line[0][1]];
        (0..=dx).any(|k| (2 * k * dy) % (2 * dx) == dx)
    };
    lines.filter(is_halfway).collect()
}

/// All lines of up to 16 px for which the printed code is made, but for level ones.
fn first_octant() -> Vec<Line> {
    (1..=16).flat_map(|dx| (1..=dx).map(move |dy| [[20, 20], [20 + dx, 20 + dy]])).collect()
}

/// Through the screen in the first octant, from far away to far away.
fn far(k: usize, index: u64) -> Line {
    let mut random = Random::new(0x11FE + index);
    let middle = [20 + random.below(280), 20 + random.below(200)];
    let reach = 1_i32 << k;
    let (before, after) = (reach / 2 + random.below(reach / 2), reach / 2 + random.below(reach / 2));
    // A slope below 1/2: what the printed code is made for, and little enough that the line stays on the screen.
    let slope = 1 + random.below(499);
    let rise = |run: i32| i32::try_from(i64::from(run) * i64::from(slope) / 1000).unwrap_or(i32::MAX);
    [[middle[0] - before, middle[1] - rise(before)], [middle[0] + after, middle[1] + rise(after)]]
}
