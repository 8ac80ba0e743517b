//! Whether the variants draw the same, before anything is timed.

use crate::{
    drawing::Drawing,
    picture::{Coverage, no_coverage},
    row::Difference,
};

/// So many shapes of a scene are compared.
pub(crate) const COMPARED: usize = 1000;

/// How far the pixels of `other` are from those of `reference`, shape by shape: the most that differ in one shape, and
/// how many differ per thousand that are drawn.
pub(crate) fn difference(reference: &mut dyn Drawing, other: &mut dyn Drawing) -> Difference {
    assert_eq!(reference.shapes(), other.shapes(), "both draw the same scene");
    let (mut expected, mut actual): (Box<Coverage>, Box<Coverage>) = (no_coverage(), no_coverage());
    let (mut most_in_a_shape, mut differing, mut drawn) = (0, 0, 0);
    for shape in 0..reference.shapes().min(COMPARED) {
        reference.draw_alone(shape).read(&mut expected);
        other.draw_alone(shape).read(&mut actual);
        let in_shape = expected.iter().zip(actual.iter()).filter(|(expected, actual)| expected != actual).count();
        most_in_a_shape = most_in_a_shape.max(in_shape);
        differing += in_shape;
        drawn += expected.iter().filter(|&&coverage| coverage != 0).count();
    }
    Difference { max: most_in_a_shape as f64, mean: 1000.0 * differing as f64 / drawn.max(1) as f64 }
}
