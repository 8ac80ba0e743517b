//! Seed fill is right with any stack: what a queue reaches is what it fills, each pixel once.

use std::{collections::VecDeque, convert::Infallible, ops::Range};

use embedded_graphics::{
    framebuffer::{Framebuffer, buffer_size},
    image::GetPixel,
    pixelcolor::{BinaryColor, Gray8, raw::LittleEndian},
    prelude::*,
    primitives::Rectangle,
};
use spanfill::{Connectivity, FillRegion, FillSegment, PixelRect, SeedFill, SeedFillError};

mod oracle;
use oracle::Rng;

const BOTH: [Connectivity; 2] = [Connectivity::Four, Connectivity::Eight];

/// A bitmap somewhere on the plane: what is open, how often each pixel was filled.
#[derive(Clone)]
struct Bitmap {
    left: i32,
    top: i32,
    width: usize,
    open: Vec<bool>,
    filled: Vec<u8>,
}

impl Bitmap {
    fn new(width: usize, open: Vec<bool>) -> Self {
        assert_eq!(open.len() % width, 0);
        Self { left: 0, top: 0, width, filled: vec![0; open.len()], open }
    }

    /// `#` is closed.
    fn parse(picture: &str) -> Self {
        let rows: Vec<&str> = picture.split_whitespace().collect();
        Self::new(rows[0].len(), rows.concat().chars().map(|c| c != '#').collect())
    }

    fn height(&self) -> usize {
        self.open.len() / self.width
    }

    fn index(&self, x: i32, y: i32) -> usize {
        let (x, y) = (i64::from(x) - i64::from(self.left), i64::from(y) - i64::from(self.top));
        usize::try_from(y).unwrap() * self.width + usize::try_from(x).unwrap()
    }

    /// What can be reached from a pixel, by a queue.
    fn reachable(&self, seed: usize, connectivity: Connectivity) -> Vec<u8> {
        let mut reached = vec![0; self.open.len()];
        let mut queue = VecDeque::new();
        if self.open[seed] {
            reached[seed] = 1;
            queue.push_back(seed);
        }
        while let Some(at) = queue.pop_front() {
            let (x, y) = ((at % self.width) as i64, (at / self.width) as i64);
            for (dx, dy) in (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy))) {
                let is_neighbour = match connectivity {
                    Connectivity::Four => i64::abs(dx) + i64::abs(dy) == 1,
                    Connectivity::Eight => (dx, dy) != (0, 0),
                };
                let inside =
                    (0..self.width as i64).contains(&(x + dx)) && (0..self.height() as i64).contains(&(y + dy));
                if is_neighbour && inside {
                    let next = (y + dy) as usize * self.width + (x + dx) as usize;
                    if self.open[next] && reached[next] == 0 {
                        reached[next] = 1;
                        queue.push_back(next);
                    }
                }
            }
        }
        reached
    }

    fn check(&self, seed: usize, connectivity: Connectivity, stack: &mut [FillSegment]) {
        let mut bitmap = self.clone();
        let point = Point::new(self.left + (seed % self.width) as i32, self.top + (seed / self.width) as i32);
        let entries = stack.len();
        let result = SeedFill::new(point).connectivity(connectivity).fill(&mut bitmap, stack);
        assert!(
            result == Ok(()) && bitmap.filled == self.reachable(seed, connectivity),
            "{connectivity:?}, {entries} entries, seed {seed}: {result:?}\n{}",
            (0..self.height())
                .map(|row| (0..self.width)
                    .map(|x| match (self.open[row * self.width + x], bitmap.filled[row * self.width + x]) {
                        (false, 0) => '#',
                        (true, 0) => '.',
                        (true, 1) => 'o',
                        _ => '!',
                    })
                    .chain(['\n'])
                    .collect::<String>())
                .collect::<String>()
        );
    }

    /// From one of the open pixels, by stacks of no entry to some, and one that never fills up.
    fn check_stacks(&self, seed: usize) {
        for connectivity in BOTH {
            for entries in [0, 1, 2, 3, 4, 5, 8, 16, 3 * self.open.len() + 2] {
                self.check(seed, connectivity, &mut vec![FillSegment::EMPTY; entries]);
            }
        }
    }
}

impl FillRegion for Bitmap {
    type Error = Infallible;

    fn bounds(&self) -> PixelRect {
        PixelRect { rows: self.top..self.top + self.height() as i32, columns: self.left..self.left + self.width as i32 }
    }

    fn is_open(&self, x: i32, y: i32) -> bool {
        self.open[self.index(x, y)]
    }

    fn fill(&mut self, row: i32, columns: Range<i32>) -> Result<(), Infallible> {
        assert!(!columns.is_empty());
        for x in columns {
            let at = self.index(x, row);
            assert!(self.open[at], "({x}, {row}) is filled and was not open");
            self.open[at] = false;
            self.filled[at] += 1;
        }
        Ok(())
    }
}

/// Every bitmap of a size, from every open pixel.
fn check_all_bitmaps(width: usize, height: usize, entries: &[usize]) {
    let pixels = width * height;
    for bits in 0_u32..1 << pixels {
        let bitmap = Bitmap::new(width, (0..pixels).map(|at| bits >> at & 1 == 1).collect());
        for connectivity in BOTH {
            let mut done = vec![0; pixels];
            for seed in 0..pixels {
                // One seed a region is enough for bitmaps as many as that; where it lies in it changes from one to another.
                if bitmap.open[seed] && done[seed] == 0 {
                    let reached = bitmap.reachable(seed, connectivity);
                    done.iter_mut().zip(&reached).for_each(|(done, reached)| *done |= reached);
                    let mut members = (0..pixels).filter(|at| reached[*at] == 1);
                    let size = members.clone().count();
                    let seed = members.nth(bits as usize % size).unwrap();
                    for &entries in entries {
                        bitmap.check(seed, connectivity, &mut [FillSegment::EMPTY; 64][..entries]);
                    }
                }
            }
        }
    }
}

#[test]
fn every_bitmap_of_twenty_pixels_is_filled_by_any_stack() {
    check_all_bitmaps(4, 4, &[0, 1, 2, 3, 64]);
    check_all_bitmaps(5, 4, &[0, 1]);
    check_all_bitmaps(3, 6, &[0, 2]);
}

#[test]
fn random_bitmaps_of_any_density_are_filled_by_any_stack() {
    for case in 0..oracle::cases(400) {
        let mut rng = Rng::new(1979, case);
        let (width, height) = (rng.int(1..=40) as usize, rng.int(1..=30) as usize);
        let closed = rng.int(5..=60);
        let mut bitmap = Bitmap::new(width, (0..width * height).map(|_| rng.int(1..=100) > closed).collect());
        bitmap.left = rng.pick(&[0, -17, i32::MIN, i32::MAX - width as i32]);
        bitmap.top = rng.pick(&[0, -17, i32::MIN, i32::MAX - height as i32]);
        bitmap.check_stacks(rng.index(width * height));
    }
}

/// Corridors one pixel wide: a tree of them, and the same with `loops` of their walls opened.
fn maze(rng: &mut Rng, cells: usize, loops: usize) -> Bitmap {
    let width = 2 * cells + 1;
    let mut open = vec![false; width * width];
    let (mut path, mut at) = (Vec::new(), (1, 1));
    open[width + 1] = true;
    loop {
        let mut ways = [(2, 0), (-2, 0), (0, 2), (0, -2)];
        rng.shuffle(&mut ways);
        let free = ways.into_iter().find_map(|(dx, dy)| {
            let (x, y) = (at.0 + dx, at.1 + dy);
            let inside = (0..width as i32).contains(&x) && (0..width as i32).contains(&y);
            (inside && !open[y as usize * width + x as usize]).then_some((x, y))
        });
        if let Some((x, y)) = free {
            open[((at.1 + y) / 2) as usize * width + ((at.0 + x) / 2) as usize] = true;
            open[y as usize * width + x as usize] = true;
            path.push(at);
            at = (x, y);
        } else if let Some(back) = path.pop() {
            at = back;
        } else {
            break;
        }
    }
    for _ in 0..loops {
        let (x, y) = (1 + rng.index(width - 2), 1 + rng.index(width - 2));
        open[y * width + x] = true;
    }
    Bitmap::new(width, open)
}

#[test]
fn mazes_are_filled_by_any_stack() {
    for case in 0..oracle::cases(40) {
        let mut rng = Rng::new(1994, case);
        let loops = rng.pick(&[0, 0, 3, 20]);
        let bitmap = maze(&mut rng, 12, loops);
        let open: Vec<usize> = (0..bitmap.open.len()).filter(|at| bitmap.open[*at]).collect();
        bitmap.check_stacks(rng.pick(&open));
    }
}

#[test]
fn spirals_combs_gaps_islands_and_full_screens_are_filled_by_any_stack() {
    let spiral = "
        ............
        .##########.
        .#........#.
        .#.######.#.
        .#.#....#.#.
        .#.#.##.#.#.
        .#.#.#..#.#.
        .#.#.####.#.
        .#.#......#.
        .#.########.
        .#..........
        .###########";
    let comb = "
        .#.#.#.#.#.#
        .#.#.#.#.#.#
        .#.#.#.#.#.#
        ............
        #.#.#.#.#.#.
        #.#.#.#.#.#.";
    let diagonal = "
        ....#...
        ...#....
        ..#...#.
        .#...#..
        #...#...
        ...#....";
    let chessboard = "
        .#.#.#.#
        #.#.#.#.
        .#.#.#.#
        #.#.#.#.
        .#.#.#.#";
    let islands = "
        ...........
        .#.#.#.#.#.
        ...........
        .##.###.##.
        .#...#...#.
        .#.#.#.#.#.
        .#...#...#.
        .#########.
        ...........";
    // By corners, a ring with something hanging on each of its pixels: none can be spared as seen from the island, which is
    // where the walk arrives from below.
    let hung = "
        ###.###
        #.#.#.#
        ##.#.##
        ..###..
        ##.#.##
        #.#.#.#
        ###.###
        ###.###
        ###.###";
    for picture in [spiral, comb, diagonal, chessboard, islands, hung] {
        let bitmap = Bitmap::parse(picture);
        for seed in 0..bitmap.open.len() {
            bitmap.check_stacks(seed);
        }
    }
    let screen = Bitmap::new(320, vec![true; 320 * 240]);
    for entries in [0, 1, 2, 3, 8] {
        screen.check(120 * 320 + 160, Connectivity::Four, &mut vec![FillSegment::EMPTY; entries]);
        screen.check(320 * 240 - 1, Connectivity::Eight, &mut vec![FillSegment::EMPTY; entries]);
    }
}

/// A ring of corridors around a room each of whose pixels a dead end leaves from, so that the walk has to look for a higher
/// boundary, with islands on the way.
#[test]
fn islands_within_islands_are_filled_without_a_stack() {
    let (width, height) = (61, 61);
    let mut open = vec![true; width * height];
    for y in 0..height {
        for x in 0..width {
            let ring = x.min(y).min(width - 1 - x).min(height - 1 - y);
            // Walls between rings one pixel wide, each with a door, and notches so that corridors have no corners to spare.
            let is_door = (x + y + ring) % 23 == 0;
            open[y * width + x] = ring % 2 == 0 || is_door;
        }
    }
    let bitmap = Bitmap::new(width, open);
    for seed in [0, 30 * 61 + 30, 30 * 61 + 4] {
        bitmap.check_stacks(seed);
    }
}

type Frame = Framebuffer<Gray8, <Gray8 as PixelColor>::Raw, LittleEndian, 24, 16, { buffer_size::<Gray8>(24, 16) }>;
type Bits = Framebuffer<
    BinaryColor,
    <BinaryColor as PixelColor>::Raw,
    LittleEndian,
    24,
    16,
    { buffer_size::<BinaryColor>(24, 16) },
>;

/// Neighbours that had the fill's colour before, which lead to places of the region's old colour that are not in it: all
/// of that where there are but two colours.
#[test]
fn what_had_the_fills_colour_before_leads_nowhere() {
    for case in 0..oracle::cases(300) {
        let mut rng = Rng::new(1990, case);
        let (mut bits, mut frame) = (Bits::new(), Frame::new());
        let mut open = Vec::new();
        for (x, y) in (0..16).flat_map(|y| (0..24).map(move |x| (x, y))) {
            let is_open = rng.int(1..=3) > 1;
            open.push(is_open);
            bits.set_pixel(Point::new(x, y), BinaryColor::from(!is_open));
            // Closed by the fill's colour or another.
            let closed = rng.pick(&[200, 77]);
            frame.set_pixel(Point::new(x, y), Gray8::new(if is_open { 3 } else { closed }));
        }
        let bitmap = Bitmap::new(24, open);
        let seed = rng.index(24 * 16);
        let point = Point::new((seed % 24) as i32, (seed / 24) as i32);
        if !bitmap.open[seed] {
            continue;
        }
        for (connectivity, entries) in BOTH.into_iter().flat_map(|c| [0, 1, 2, 3, 7, 900].map(|entries| (c, entries))) {
            let mut stack = vec![FillSegment::EMPTY; entries];
            let (mut bits, mut filled) = (bits.clone(), frame.clone());
            let fill = SeedFill::new(point).connectivity(connectivity);
            fill.draw(BinaryColor::On, &mut bits, &mut stack).unwrap();
            fill.draw(Gray8::new(200), &mut filled, &mut stack).unwrap();
            for (at, reached) in bitmap.reachable(seed, connectivity).into_iter().enumerate() {
                let point = Point::new((at % 24) as i32, (at / 24) as i32);
                assert_eq!(bits.pixel(point), Some(BinaryColor::from(reached == 1 || !bitmap.open[at])));
                let expected = if reached == 1 { Some(Gray8::new(200)) } else { frame.pixel(point) };
                assert_eq!(filled.pixel(point), expected);
            }
        }
    }
}

#[test]
fn the_regions_own_colour_and_seeds_outside_change_nothing() {
    let mut frame = Frame::new();
    frame.set_pixel(Point::new(3, 3), Gray8::new(9));
    let before = frame.clone();
    for seed in [Point::new(-1, 0), Point::new(0, 16), Point::new(i32::MAX, i32::MIN)] {
        SeedFill::new(seed).draw(Gray8::new(50), &mut frame, &mut []).unwrap();
    }
    SeedFill::new(Point::new(5, 5)).draw(Gray8::new(0), &mut frame, &mut []).unwrap();
    assert_eq!(frame.data(), before.data());
}

/// A target that shows less than it is given, or fails.
struct Faulty {
    frame: Frame,
    shows: bool,
    calls_left: u32,
}

impl OriginDimensions for Faulty {
    fn size(&self) -> Size {
        self.frame.size()
    }
}

impl GetPixel for Faulty {
    type Color = Gray8;

    fn pixel(&self, point: Point) -> Option<Gray8> {
        self.frame.pixel(point)
    }
}

impl DrawTarget for Faulty {
    type Color = Gray8;
    type Error = &'static str;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, pixels: I) -> Result<(), &'static str> {
        self.calls_left = self.calls_left.checked_sub(1).ok_or("no more")?;
        if self.shows {
            let Ok(()) = self.frame.draw_iter(pixels);
        }
        Ok(())
    }
}

#[test]
fn a_target_that_does_not_show_what_is_drawn_or_fails_ends_the_fill() {
    for entries in [0, 1, 100] {
        let mut stack = vec![FillSegment::EMPTY; entries];
        let fill = SeedFill::new(Point::new(5, 4));
        let mut blind = Faulty { frame: Frame::new(), shows: false, calls_left: 1000 };
        let result = fill.draw(Gray8::new(1), &mut blind, &mut stack);
        assert_eq!(result, Err(SeedFillError::Unreadable { x: 0, y: 4 }));
        let mut failing = Faulty { frame: Frame::new(), shows: true, calls_left: 3 };
        assert_eq!(fill.draw(Gray8::new(1), &mut failing, &mut stack), Err(SeedFillError::Target("no more")));
        let box_of_it = Rectangle::new(Point::zero(), Size::new(24, 16));
        assert_eq!(failing.bounding_box(), box_of_it);
    }
}
