//! The rim of a mosaic is that of the union of its tiles: for every partition of the quadrilaterals of small grids, and for
//! random partitions into many polygons.

mod memory;
mod oracle;

use std::collections::BTreeMap;

use embedded_graphics::{image::GetPixel as _, pixelcolor::Gray8, prelude::*, primitives::Rectangle};
use memory::Memory;
use oracle::{Rng, cases, for_each_case};
use spanfill::{
    AreaSink, Areas, Mosaic, MosaicCell, Over, PixelRect, Polygon, Solid, Span, Tile, Tiles, Triangle, Vertex,
};

const SIDE: i32 = 10;
const WHOLE: i64 = 1 << 24;

/// Areas of pixels, added up in 2^-24, and nothing of what is 0.
#[derive(Default, PartialEq, Debug)]
struct Sum(BTreeMap<(i32, i32), i64>);

impl Sum {
    fn add(&mut self, shape: &impl Areas) {
        shape.push_areas(&PixelRect { rows: 0..SIDE, columns: 0..SIDE }, self);
        self.0.retain(|_, area| *area != 0);
    }

    fn of(shapes: impl IntoIterator<Item = impl Areas>) -> Self {
        let mut sum = Self::default();
        shapes.into_iter().for_each(|shape| sum.add(&shape));
        sum
    }

    /// To the nearest level.
    fn levels(&self) -> Vec<u8> {
        let mut levels = vec![0; (SIDE * SIDE) as usize];
        for ((row, column), area) in &self.0 {
            levels[(row * SIDE + column) as usize] = ((area * 255 + WHOLE / 2) / WHOLE) as u8;
        }
        levels
    }
}

impl AreaSink for Sum {
    fn alike(&mut self, span: Span, area: u32) {
        for column in span.columns {
            *self.0.entry((span.row, column)).or_default() += i64::from(area);
        }
    }

    fn areas(&mut self, row: i32, column: i32, areas: impl Iterator<Item = u32>) {
        for (column, area) in (column..).zip(areas) {
            *self.0.entry((row, column)).or_default() += i64::from(area);
        }
    }
}

/// White on black is the coverage.
fn drawn(tiles: impl Tiles<Gray8, 1>) -> Vec<u8> {
    let area = Rectangle::new(Point::zero(), Size::new_equal(SIDE as u32));
    let mut target = Memory::new(area, |_| Gray8::BLACK);
    let mut cells = [MosaicCell::EMPTY; 3 * SIDE as usize];
    Mosaic::new(tiles).draw_on(&mut target, Over(Gray8::BLACK), &mut cells).expect("it is enough");
    area.points().map(|point| target.pixel(point).expect("inside").luma()).collect()
}

fn white<S: Areas>(shape: S) -> Tile<S, Solid<Gray8>> {
    Tile::new(shape, Solid(Gray8::WHITE))
}

/// Every quadrilateral between the points of a grid whose corners turn clockwise, once.
fn convex_quadrilaterals(coordinates: &[i32]) -> Vec<[Vertex; 4]> {
    let points: Vec<_> = coordinates.iter().flat_map(|y| coordinates.iter().map(|x| [*x, *y])).collect();
    let turns = |[a, b, c]: [[i32; 2]; 3]| (b[0] - a[0]) * (c[1] - a[1]) > (b[1] - a[1]) * (c[0] - a[0]);
    let mut found = Vec::new();
    for (first, a) in points.iter().enumerate() {
        // The first corner is the one with the least number.
        let later = &points[first + 1..];
        for b in later {
            for c in later.iter().filter(|c| turns([*a, *b, **c])) {
                let is_fourth = |d: &&[i32; 2]| turns([*b, *c, **d]) && turns([*c, **d, *a]) && turns([**d, *a, *b]);
                for d in later.iter().filter(is_fourth) {
                    found.push([a, b, c, d].map(|[x, y]| Vertex::from_bits(*x, *y)));
                }
            }
        }
    }
    found
}

/// The two pairs of triangles that a quadrilateral can be cut in.
fn pairs([a, b, c, d]: [Vertex; 4]) -> [[[Vertex; 3]; 2]; 2] {
    [[[a, b, c], [a, c, d]], [[a, b, d], [b, c, d]]]
}

/// Multiples of a pixel's halves, and what is a multiple of nothing.
const GRIDS: [&[i32]; 2] = [&[0, 128, 384, 512, 896], &[3, 217, 409, 750, 1301]];

#[test]
fn polygons_have_the_rim_of_their_union() {
    for grid in GRIDS {
        let quadrilaterals = convex_quadrilaterals(grid);
        assert!(quadrilaterals.len() > 3_000, "{} are too few", quadrilaterals.len());
        for corners in quadrilaterals {
            let union = Polygon::new(&corners);
            let union = Sum::of([union.coverage_with::<4>().expect("enough")]);
            for pair in pairs(corners) {
                let [one, other] = &pair.map(|corners| corners.to_vec());
                let parts = [one, other].map(|part| Polygon::new(part).coverage_with::<4>().expect("enough"));
                // Not only to the level: to the last bit.
                assert_eq!(Sum::of(parts), union, "{pair:?}");
                let [one, other] = parts.map(white);
                assert_eq!(drawn((one, other)), union.levels(), "{pair:?}");
            }
        }
    }
}

#[test]
fn triangles_have_one_rim_and_that_of_a_polygon_but_for_ties() {
    // Halves of a pixel are ties, which are frequent where vertices are multiples of halves.
    for (grid, most) in GRIDS.into_iter().zip([5_000, 50_000]) {
        let (mut pixels, mut others) = (0, 0);
        for corners in convex_quadrilaterals(grid) {
            let sums = pairs(corners).map(|pair| Sum::of(pair.map(Triangle::from_vertices)));
            let [sum, other] = &sums;
            // Whichever way it is cut.
            assert_eq!(sum, other, "{corners:?}");
            let [one, other] = pairs(corners)[0].map(|corners| white(Triangle::from_vertices(corners)));
            let levels = drawn((one, other));
            assert_eq!(levels, sum.levels(), "{corners:?}");
            // A polygon's rows are added up in another order.
            let polygon = Polygon::new(&corners);
            let union = Sum::of([polygon.coverage_with::<4>().expect("enough")]);
            for (place, area) in &union.0 {
                let found = sum.0.get(place).copied().unwrap_or(0);
                assert!((found - area).abs() <= NEAR, "{found} in place of {area} at {place:?} of {corners:?}");
                pixels += u64::from(*area < WHOLE);
            }
            for (index, (found, expected)) in levels.iter().zip(union.levels()).enumerate() {
                if *found != expected {
                    others += 1;
                    let area = union.0[&(index as i32 / SIDE, index as i32 % SIDE)];
                    let from_tie = (area * 255 - WHOLE / 2).rem_euclid(WHOLE);
                    let from_tie = from_tie.min(WHOLE - from_tie);
                    assert!(from_tie <= 255 * NEAR && found.abs_diff(expected) == 1, "{corners:?}");
                }
            }
        }
        println!("{grid:?}: {others} of {pixels} pixels of the rim are on the other side of a tie");
        assert!(others * most < pixels, "{others} of {pixels}");
    }
}

/// What the two ways to add an area up may differ by: 2^-22 of a pixel.
const NEAR: i64 = 1 << 2;

/// Strips between jagged lines, as many as are in a pixel at most, here 24: what is nearer to a whole pixel than all of them may
/// be off is nearer to 255 than to 254, too.
#[test]
fn many_polygons_have_the_rim_of_their_union() {
    for_each_case(0x305A, cases(2_000), |rng| {
        let count = rng.int(1..=24) as usize;
        let height = 2300 / count as i64;
        let columns: Vec<i64> = (0..6).map(|step| 60 + 480 * step + rng.int(-200..=200)).collect();
        let borders: Vec<Vec<Vertex>> = (0..=count as i64)
            .map(|index| {
                let shaken = |rng: &mut Rng| 100 + index * height + rng.int(1 - height / 2..=height / 2 - 1);
                columns.iter().map(|x| Vertex::from_bits(*x as i32, shaken(rng) as i32)).collect()
            })
            .collect();
        let around = |above: &[Vertex], below: &[Vertex]| -> Vec<Vertex> {
            above.iter().chain(below.iter().rev()).copied().collect()
        };
        let strips: Vec<_> = borders.windows(2).map(|two| around(&two[0], &two[1])).collect();
        let mut tiles: Vec<_> =
            strips.iter().map(|strip| white(Polygon::new(strip).coverage_with::<32>().expect("enough"))).collect();
        let rim = around(&borders[0], &borders[count]);
        let union = Sum::of([Polygon::new(&rim).coverage_with::<32>().expect("enough")]);
        rng.shuffle(&mut tiles);
        if drawn(&tiles[..]) == union.levels() { Ok(1) } else { Err(format!("{strips:?}")) }
    });
}
