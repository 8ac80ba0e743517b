//! Any split of a clip into bands, columns and tiles draws what the whole draws.

mod oracle;

use oracle::{Belongs, Grid, Rng, block_pixels, cases, check_same, for_each_case, random, rect, span_pixels};
use spanfill::{PixelRect, Shape};

/// Cuts a range anywhere, into pieces some of which may be empty.
fn cuts(rng: &mut Rng, range: &std::ops::Range<i32>) -> Vec<std::ops::Range<i32>> {
    let mut at: Vec<i32> = (0..rng.index(5))
        .map(|_| rng.int(range.start.into()..=range.end.into()) as i32)
        .chain([range.start, range.end])
        .collect();
    at.sort_unstable();
    at.windows(2).map(|pair| pair[0]..pair[1]).collect()
}

/// Draws a shape in one piece and in many.
fn check_split<S: Shape + Belongs>(rng: &mut Rng, shape: &S, window: &PixelRect) -> u64 {
    let whole = span_pixels(shape, window);
    check_same(&block_pixels(shape, window), &whole, || format!("blocks and spans of {}", shape.code()));
    let mut pieces = Grid::new(window.clone());
    let bands = cuts(rng, &window.rows);
    for rows in bands {
        for columns in cuts(rng, &window.columns) {
            let clip = rect(columns, rows.clone());
            let piece = if rng.one_in(3) { block_pixels(shape, &clip) } else { span_pixels(shape, &clip) };
            for row in clip.rows.clone() {
                for column in clip.columns.clone() {
                    if piece.count(column, row) > 0 {
                        pieces.add(row, &(column..column + 1));
                    }
                }
            }
        }
    }
    check_same(&pieces, &whole, || format!("pieces of {}", shape.code()));
    whole.is_mixed().into()
}

#[test]
fn triangles_in_pieces() {
    let mixed = for_each_case(50, cases(100_000), |rng| {
        let (triangle, window) = random::triangle(rng);
        Ok(check_split(rng, &triangle, &window))
    });
    assert!(mixed > 0);
}

#[test]
fn lines_in_pieces() {
    let mixed = for_each_case(51, cases(100_000), |rng| {
        let (line, window) = random::line(rng);
        Ok(check_split(rng, &line, &window))
    });
    assert!(mixed > 0);
}

#[test]
fn circles_in_pieces() {
    let mixed = for_each_case(52, cases(100_000), |rng| {
        let (circle, window) = random::circle(rng);
        Ok(check_split(rng, &circle, &window))
    });
    assert!(mixed > 0);
}

#[test]
fn polygons_in_pieces() {
    let mixed = for_each_case(53, cases(50_000), |rng| {
        let (outline, window) = random::outline(rng);
        Ok(check_split(rng, &outline, &window))
    });
    assert!(mixed > 0);
}
