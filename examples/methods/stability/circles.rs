//! Where circles fail.

use super::report::{Outcome, POWERS, Report, outcomes};
use crate::{
    measure::{Aim, Scene, Suite},
    variants::circle::CIRCLES,
};

pub(crate) fn report(report: &mut Report) {
    let suite = suite();
    let of_aim = |scene: &str, ending: &str| -> Vec<Outcome> {
        outcomes(&suite, scene).into_iter().filter(|outcome| outcome.label.ends_with(ending)).collect()
    };
    report.heading("Circles: outlines");
    report.say(
        "All radii from 1 to 100 px. Right is the nearest pixel in each column of the octant. Roots that are cut off draw the \
         pixel inside; 4-way symmetry leaves gaps where the circle is steep; what draws the octants' common pixels for both \
         draws them *twice*, which costs time and shows where pixels are blended or inverted. The `5 / 4` that integers cut \
         to 1 is right in every pixel.",
    );
    report.pixels("outlines", "circles' outlines, by the methods that are worst", of_aim("radii", "outline"));
    report.heading("Circles: filled");
    report.say(
        "The same, filled. Right is what is nearer to the centre than r + 1/2; *another tie* is a pixel which that rule and \
         the one by outlines decide differently.",
    );
    report.pixels("discs", "discs, by the methods that are worst", of_aim("radii", "filled"));
    report.heading("Circles: radii that grow");
    report.say(
        "Radius 2^k px, the circle's lowest or rightmost point on the screen: the first k at which a pixel is missing \
         or extra. What fails at k = 4 is wrong at every size.",
    );
    report.powers(std::slice::from_ref(&suite));
}

pub(crate) fn suite() -> Suite {
    let mut scenes = vec![Scene { name: "radii", shapes: (1..=100).map(|radius| [160, 120, radius]).collect() }];
    for (k, name) in POWERS.iter().enumerate().take(23).skip(4) {
        let radius = (1 << k) - 3;
        let shapes = vec![[160, 200 - radius, radius], [300 - radius, 90, radius], [10, 230 - radius, radius]];
        scenes.push(Scene { name, shapes });
    }
    Suite::new(
        "circle",
        CIRCLES,
        scenes,
        |_, option| if option.ends_with("outline") { Aim::Outline } else { Aim::Fill },
    )
}
