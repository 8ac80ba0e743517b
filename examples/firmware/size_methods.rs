//! The families of methods, each as the charts draw it: all of its methods with all of their options.

use core::hint::black_box;

use super::{
    draws,
    variants::{Frame, SCREEN, Variant, polygon},
};

/// Draws the shape by each of the family's methods.
fn draw_all<S>(variants: &[Variant<S>], shape: &S) {
    let frame = cortex_m::singleton!(: Frame = Frame::new());
    if let Some(frame) = frame {
        for variant in variants {
            let _ = black_box((variant.time)(shape, &black_box(SCREEN), frame));
        }
    }
}

pub(super) fn draw() {
    if const { draws("methods-polygon") } {
        let outline = polygon::Outline { contours: &[&[[0, 0], [9_000, 2_000], [3_000, 7_000]]], even_odd: true };
        // The last one is the crate's own.
        if let [variants @ .., _] = polygon::POLYGONS {
            draw_all(variants, &black_box(outline));
        }
    }
}
