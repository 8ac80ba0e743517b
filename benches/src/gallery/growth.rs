//! How long it takes to find out how much scratch an outline needs.

use std::{hint::black_box, time::Duration};

use spanfill::{Polygon, Vertex};

use crate::{drawings::noisy_chart, timing::timed};

/// What the question costs for an outline of so many vertices.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Query {
    pub(crate) vertices: usize,
    pub(crate) exact_ns: f64,
    /// By sorting.
    pub(crate) sorted_ns: f64,
    pub(crate) bound_ns: f64,
}

/// Of charts of noise: the most turns from up to down that an outline can have.
pub(super) fn queries() -> Vec<Query> {
    [4_000, 16_000, 64_000].map(query).into()
}

fn query(samples: i32) -> Query {
    eprintln!("scratch for {samples} vertices");
    let chart = noisy_chart(samples - 2);
    let outline: Vec<Vertex> = chart.shapes[0].contours[0].iter().map(|&[x, y]| Vertex::from_bits(x, y)).collect();
    let polygon = Polygon::new(&outline);
    let mut room = vec![0; polygon.coverage_edges_at_most()];
    let mut best = |question: fn(&Polygon<'_>, &mut [i32]) -> usize| {
        let mut best = Duration::MAX;
        let mut spent = Duration::ZERO;
        while spent < Duration::from_millis(20) {
            let time = timed(|| {
                black_box(question(black_box(&polygon), &mut room));
            });
            best = best.min(time);
            spent += time;
        }
        best.as_secs_f64() * 1e9
    };
    Query {
        vertices: outline.len(),
        exact_ns: best(|polygon, _| polygon.coverage_edges()),
        sorted_ns: best(|polygon, room| polygon.coverage_edges_in(room)),
        bound_ns: best(|polygon, _| polygon.coverage_edges_at_most()),
    }
}
