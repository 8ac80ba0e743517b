//! How far the anti-aliased variants are from the exact areas.

use crate::{
    drawing::{Drawing, PIXELS},
    exact::ExactArea,
    lineup::outline::{Outline, OutlineVisitor, with_simple_outlines},
    picture::no_coverage,
    row::Difference,
    scenes::Scene,
};

/// So many shapes of a scene are compared.
pub(crate) const COMPARED: usize = 400;

/// The error of each drawing, in 255ths of a pixel: the largest, and the mean over the pixels that are covered in part.
pub(crate) fn errors(scene: Scene, drawings: &mut [Box<dyn Drawing>]) -> Vec<Difference> {
    with_simple_outlines(scene, Compare(drawings))
}

struct Compare<'a>(&'a mut [Box<dyn Drawing>]);

impl OutlineVisitor for Compare<'_> {
    type Output = Vec<Difference>;

    fn visit<O: Outline>(self, outlines: Vec<O>) -> Vec<Difference> {
        let mut areas: Box<[f64; PIXELS]> = vec![0.0; PIXELS].try_into().expect("as many as asked for");
        let mut exact = ExactArea::new();
        let mut coverage = no_coverage();
        let mut errors = vec![Difference::default(); self.0.len()];
        let mut in_part = 0;
        for (shape, outline) in outlines.iter().enumerate().take(COMPARED) {
            outline.trace(&mut exact);
            exact.take(&mut areas);
            in_part += areas.iter().filter(|area| (1e-9..1.0 - 1e-9).contains(*area)).count();
            for (drawing, error) in self.0.iter_mut().zip(&mut errors) {
                assert_eq!(drawing.shapes(), outlines.len(), "all draw the same scene");
                drawing.draw_alone(shape).read(&mut coverage);
                for (coverage, area) in coverage.iter().zip(areas.iter()) {
                    let off = (f64::from(*coverage) - 255.0 * area).abs();
                    error.max = error.max.max(off);
                    error.mean += off;
                }
            }
        }
        errors.iter_mut().for_each(|error| error.mean /= f64::from(u32::try_from(in_part.max(1)).unwrap_or(u32::MAX)));
        errors
    }
}
