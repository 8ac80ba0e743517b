//! Where attributes fail.

use super::report::{Outcome, Report, outcomes};
use crate::{
    measure::{Aim, Scene, Suite},
    scenes,
    variants::attribute::{ATTRIBUTES, Shaded},
};

pub(crate) fn report(report: &mut Report) {
    let suite = suite();
    let of_aim = |scene: &str, aim: Aim| -> Vec<Outcome> {
        let outcomes = outcomes(&suite, scene).into_iter().zip(&suite.entries);
        outcomes.filter(|(_, entry)| entry.aim == aim).map(|(outcome, _)| outcome).collect()
    };
    report.heading("Attributes: on slivers");
    report.say(
        "Four channels of 0 to 255 at each vertex, on the slivers of above: the steeper the plane, the more an error of the \
         position counts. How far the worst channel of a pixel is off, beyond what rounding takes; only pixels that the method \
         and the oracle both have count. What the crate ships is the exact value, to the nearest; or flat, the average.",
    );
    report.levels("attributes", "attributes on slivers", "levels", of_aim("slivers", Aim::Attributes));
    report.heading("Attributes: w towards zero");
    report.say(
        "Triangles of 50 px, w = 1, 1 and 2^-k: the nearer a vertex comes to the eye, the more of the texture's range lies in a \
         few pixels. The worst pixel, in levels of 255.",
    );
    towards_zero(report, &suite);
    report.say("At k = 8:");
    report.levels("perspective", "w towards zero", "levels", of_aim("8", Aim::Perspective));
    report.heading("Attributes: depth");
    report.say("Depths of 16 bits on the slivers, in units of the last bit.");
    report.levels("depth", "depth on slivers", "units", of_aim("slivers", Aim::Depth));
}

const POWERS: [&str; 5] = ["0", "4", "8", "12", "15"];

fn suite() -> Suite {
    let shade = |scene: &'static str, index: usize| -> Shaded {
        let (attributes, w, depth) = scenes::varying(scene, index);
        Shaded { vertices: scenes::triangle(scene, index), attributes, w, depth }
    };
    let mut all = vec![Scene { name: "slivers", shapes: (0..60).map(|index| shade("slivers", index)).collect() }];
    for name in POWERS {
        let k: u32 = name.parse().expect("a number");
        let near = |index: usize| Shaded { w: [65536, 65536, 65536 >> k], ..shade("typical", index) };
        all.push(Scene { name, shapes: (0..24).map(near).collect() });
    }
    Suite::new("attributes", ATTRIBUTES, all, Aim::of_attributes)
}

fn towards_zero(report: &mut Report, suite: &Suite) {
    let mut picture = crate::measure::new_picture();
    let mut columns = vec!["method".to_owned()];
    columns.extend(POWERS.map(|k| format!("k = {k}")));
    let columns: Vec<&str> = columns.iter().map(String::as_str).collect();
    let entries = suite.entries.iter().filter(|entry| entry.aim == Aim::Perspective);
    let rows: Vec<Vec<String>> = entries
        .map(|entry| {
            let worst = POWERS.map(|name| {
                let scene = suite.scenes.iter().position(|(other, _)| *other == name).expect("a scene of the suite");
                format!("{:.2}", suite.tally(entry, scene, usize::MAX, &mut picture).worst)
            });
            [entry.label()].into_iter().chain(worst).collect()
        })
        .collect();
    report.table(&columns, &rows);
}
