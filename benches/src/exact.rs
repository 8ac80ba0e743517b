//! The exact area of each pixel that an outline covers.
//!
//! Every edge adds, to each pixel that it passes, the signed area between itself and the pixel's right side, and, to all
//! pixels further right, its signed height in that row. For an outline that does not cross itself, the sum of what lies
//! to the left is the area, with the sign of the outline's direction. All in `f64`: the libraries round to 255ths, this
//! to 10^-12.

use std::f64::consts::TAU;

use crate::{
    drawing::PIXELS,
    lineup::outline::{Pen, Position},
    scenes::{FRAME_HEIGHT, FRAME_WIDTH},
};

/// A circle is a polygon of so many edges: at a radius of 100 px, the area between the two is less than 10^-5 px^2 in a
/// pixel.
const CIRCLE_EDGES: u32 = 8192;

/// Signed areas, in one value for each pixel: the running sum of a row is what its pixels are covered by.
#[derive(Debug)]
pub(crate) struct ExactArea {
    /// One column more than the frame has: what lies on its right edge.
    sums: Vec<f64>,
}

const STRIDE: usize = FRAME_WIDTH as usize + 2;

impl ExactArea {
    pub(crate) fn new() -> Self {
        Self { sums: vec![0.0; STRIDE * FRAME_HEIGHT as usize] }
    }

    /// Writes the covered part of each pixel, 0 to 1, and starts anew.
    pub(crate) fn take(&mut self, areas: &mut [f64; PIXELS]) {
        for (row, areas) in self.sums.chunks_exact_mut(STRIDE).zip(areas.chunks_exact_mut(FRAME_WIDTH as usize)) {
            let mut sum = 0.0;
            for (area, change) in areas.iter_mut().zip(&*row) {
                sum += change;
                *area = sum.abs();
            }
            row.fill(0.0);
        }
    }

    /// From top to bottom, or the other way round, which counts as negative. All of it lies on the frame.
    fn edge(&mut self, start: Position, end: Position) {
        let (sign, (top_x, top), (bottom_x, bottom)) =
            if start.1 < end.1 { (1.0, start, end) } else { (-1.0, end, start) };
        let x_at = |y: f64| top_x + (bottom_x - top_x) * ((y - top) / (bottom - top));
        let mut y = top;
        while y < bottom {
            let row = y.floor();
            let next = bottom.min(row + 1.0);
            self.part_of_a_row(row as usize, sign * (next - y), (x_at(y), x_at(next)));
            y = next;
        }
    }

    /// The part of an edge within a row: its signed height, and where it enters and leaves.
    pub(crate) fn part_of_a_row(&mut self, row: usize, height: f64, (enters, leaves): (f64, f64)) {
        let sums = &mut self.sums[row * STRIDE..][..STRIDE];
        let (left, right) = (enters.min(leaves), enters.max(leaves));
        let mut x = left;
        loop {
            let column = x.floor();
            let next = right.min(column + 1.0);
            let height = if right > left { height * ((next - x) / (right - left)) } else { height };
            let to_the_right = height * (column + 1.0 - 0.5 * (x + next));
            sums[column as usize] += to_the_right;
            sums[column as usize + 1] += height - to_the_right;
            if next >= right {
                break;
            }
            x = next;
        }
    }
}

impl Pen for ExactArea {
    fn polygon(&mut self, vertices: &[Position]) {
        let Some(mut start) = vertices.last().copied() else { return };
        for &end in vertices {
            self.edge(start, end);
            start = end;
        }
    }

    fn circle(&mut self, (x, y): Position, radius: f64) {
        let vertex = |step: u32| {
            let (sin, cos) = (TAU * f64::from(step) / f64::from(CIRCLE_EDGES)).sin_cos();
            (x + radius * cos, y + radius * sin)
        };
        self.polygon(&(0..CIRCLE_EDGES).map(vertex).collect::<Vec<_>>());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        lineup::outline::{CircleOutline, LineOutline, Outline, PolygonOutline, TriangleOutline, star_outline},
        scenes::{CONCAVE_64, Random, STAR, stars},
    };

    /// Whether a point is inside, by the sign of the winding around it or the distance from a centre.
    struct Inside {
        at: Position,
        winding: i32,
        is_inside: bool,
    }

    impl Pen for Inside {
        fn polygon(&mut self, vertices: &[Position]) {
            let (x, y) = self.at;
            for (index, &(end_x, end_y)) in vertices.iter().enumerate() {
                let (start_x, start_y) = vertices[(index + vertices.len() - 1) % vertices.len()];
                let cross = (end_x - start_x) * (y - start_y) - (x - start_x) * (end_y - start_y);
                if start_y <= y && y < end_y && cross > 0.0 {
                    self.winding += 1;
                } else if end_y <= y && y < start_y && cross < 0.0 {
                    self.winding -= 1;
                }
            }
            self.is_inside |= self.winding != 0;
        }

        fn circle(&mut self, (x, y): Position, radius: f64) {
            self.is_inside |= (self.at.0 - x).hypot(self.at.1 - y) < radius;
        }
    }

    const SAMPLES: i32 = 256;

    /// The share of 256 x 256 samples of the pixel that are inside.
    fn sampled(outline: &impl Outline, column: i32, row: i32) -> f64 {
        let position = |pixel: i32, sample: i32| f64::from(pixel) + (f64::from(sample) + 0.5) / f64::from(SAMPLES);
        let mut count = 0;
        for sample in 0..SAMPLES * SAMPLES {
            let at = (position(column, sample % SAMPLES), position(row, sample / SAMPLES));
            let mut inside = Inside { at, winding: 0, is_inside: false };
            outline.trace(&mut inside);
            count += i32::from(inside.is_inside);
        }
        f64::from(count) / f64::from(SAMPLES * SAMPLES)
    }

    /// Compares the pixels that are covered in part, at most so many of them, and all of the others with 0 and 1.
    fn assert_as_sampled(exact: &impl Outline, drawn: &impl Outline, random: &mut Random) {
        let mut area = ExactArea::new();
        exact.trace(&mut area);
        let mut areas = Box::new([0.0; PIXELS]);
        area.take(&mut areas);
        let compare = |index: usize| {
            let (column, row) = (index as i32 % FRAME_WIDTH, index as i32 / FRAME_WIDTH);
            let sampled = sampled(drawn, column, row);
            // An edge across a pixel misjudges the samples of one row of them at most; a few edges may meet in a pixel.
            assert!((areas[index] - sampled).abs() < 0.01, "({column}, {row}): {} and {sampled}", areas[index]);
        };
        let partly = |area: f64| (1e-9..1.0 - 1e-9).contains(&area);
        let edges: Vec<usize> = (0..PIXELS).filter(|&index| partly(areas[index])).collect();
        (0..40.min(edges.len())).for_each(|_| compare(edges[random.below(edges.len() as i32) as usize]));
        let rest: Vec<usize> = (0..PIXELS).filter(|&index| !partly(areas[index])).collect();
        (0..10).for_each(|_| compare(rest[random.below(rest.len() as i32) as usize]));
    }

    #[test]
    fn areas_are_those_of_many_samples() {
        let mut random = Random::new(0xA2EA);
        let same = |outline: &dyn Fn() -> TriangleOutline, random: &mut Random| {
            assert_as_sampled(&outline(), &outline(), random);
        };
        same(&|| TriangleOutline([[3, 2], [60, 9], [14, 31]]), &mut random);
        same(&|| TriangleOutline([[3, 2], [14, 31], [60, 9]]), &mut random);
        same(&|| TriangleOutline([[300, 230], [319, 239], [310, 230]]), &mut random);
        let circle = CircleOutline { centre: [5, 5], radius_px: 5 };
        assert_as_sampled(&circle, &circle, &mut random);
        let line = LineOutline([[10, 10], [13, 4]]);
        assert_as_sampled(&line, &line, &mut random);
        assert_as_sampled(&PolygonOutline(CONCAVE_64), &PolygonOutline(CONCAVE_64), &mut random);
    }

    #[test]
    fn the_star_is_the_union_of_what_it_winds_around() {
        let mut random = Random::new(0x57A2);
        for star in [STAR].into_iter().chain(stars(100).take(3)) {
            assert_as_sampled(&star_outline(star), &PolygonOutline(star), &mut random);
        }
    }

    #[test]
    fn the_areas_of_a_circle_add_up() {
        let mut area = ExactArea::new();
        CircleOutline { centre: [160, 120], radius_px: 100 }.trace(&mut area);
        let mut areas = Box::new([0.0; PIXELS]);
        area.take(&mut areas);
        let sum: f64 = areas.iter().sum();
        assert!((sum - 1e4 * std::f64::consts::PI).abs() < 0.01, "{sum}");
    }
}
