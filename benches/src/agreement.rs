//! Whether the variants draw the same, before anything is timed.

use crate::{
    drawing::{Drawing, PIXELS},
    row::Difference,
};

/// So many shapes of a scene are compared.
const COMPARED: usize = 1000;

/// How far the pixels of `other` are from those of `reference`, shape by shape.
pub(crate) fn difference(reference: &mut dyn Drawing, other: &mut dyn Drawing) -> Difference {
    assert_eq!(reference.shapes(), other.shapes(), "both draw the same scene");
    let (mut expected, mut actual) = (pixels(), pixels());
    let (mut most_in_a_shape, mut differing, mut drawn) = (0, 0, 0);
    for shape in 0..reference.shapes().min(COMPARED) {
        reference.draw_alone(shape, &mut expected);
        other.draw_alone(shape, &mut actual);
        let in_shape = expected.iter().zip(actual.iter()).filter(|(expected, actual)| expected != actual).count();
        most_in_a_shape = most_in_a_shape.max(in_shape);
        differing += in_shape;
        drawn += expected.iter().filter(|&&is_drawn| is_drawn).count();
    }
    Difference { most_in_a_shape, per_thousand: 1000.0 * differing as f64 / drawn.max(1) as f64 }
}

fn pixels() -> Box<[bool; PIXELS]> {
    vec![false; PIXELS].try_into().expect("as many as asked for")
}
