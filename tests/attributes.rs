//! What is interpolated over a triangle, against exact rationals in `i128`.

mod oracle;

use std::collections::BTreeMap;

use embedded_graphics::{
    framebuffer::{Framebuffer, buffer_size},
    pixelcolor::{Gray8, Rgb565, Rgb888, raw::BigEndian},
    prelude::*,
    primitives::Rectangle,
};
use oracle::{Rng, cases, for_each_case, random, rect};
use spanfill::{
    Affine, Attributes, Barycentric, DepthBuffer, DepthBufferError, DepthTest, Fill as _, Filter, Fragment,
    FragmentSink, Gouraud, NotInFront, Perspective, PixelRect, PixelRows, Shape, Span, SpanSink, Texture, Triangle,
    Vertex, Wrap, average,
};

/// Columns and rows of the pixels of a shape.
fn span_pixels(shape: &impl Shape, clip: &PixelRect) -> Vec<(i32, i32)> {
    struct Spans(Vec<(i32, i32)>);
    impl SpanSink for Spans {
        type Error = std::convert::Infallible;
        fn span(&mut self, span: Span) -> Result<(), Self::Error> {
            self.0.extend(span.columns.map(|column| (column, span.row)));
            Ok(())
        }
    }
    let mut spans = Spans(Vec::new());
    let Ok(()) = shape.spans(clip, &mut spans);
    spans.0
}

type Pixels<const N: usize> = BTreeMap<(i32, i32), [i32; N]>;

struct Record<const N: usize>(Pixels<N>);

impl<const N: usize> FragmentSink<N> for Record<N> {
    type Error = String;

    fn fragment(&mut self, fragment: Fragment<N>) -> Result<(), String> {
        match self.0.insert((fragment.y, fragment.x), fragment.attributes) {
            None => Ok(()),
            Some(_) => Err(format!("({}, {}) came twice", fragment.x, fragment.y)),
        }
    }
}

fn pixels<const N: usize>(of: &impl Attributes<N>, clip: &PixelRect) -> Result<Pixels<N>, String> {
    let mut record = Record(BTreeMap::new());
    of.fragments(clip, &mut record)?;
    Ok(record.0)
}

/// The areas opposite to each vertex, at a pixel's centre, and their sum, which is positive.
fn areas(triangle: &Triangle, (row, column): (i32, i32)) -> ([i128; 3], i128) {
    let [a, b, c] = triangle.vertices.map(|v| [i128::from(v.x.to_bits()), i128::from(v.y.to_bits())]);
    let p = [column, row].map(|pixel| i128::from(pixel) * 256 + 128);
    let area =
        |a: [i128; 2], b: [i128; 2], c: [i128; 2]| a[0] * (b[1] - c[1]) + b[0] * (c[1] - a[1]) + c[0] * (a[1] - b[1]);
    let sum = area(a, b, c);
    ([area(p, b, c), area(a, p, c), area(a, b, p)].map(|part| part * sum.signum()), sum.abs())
}

fn nearest(numerator: i128, denominator: i128) -> i128 {
    (2 * numerator + denominator).div_euclid(2 * denominator)
}

fn value(rng: &mut Rng) -> i32 {
    match rng.int(0..=3) {
        0 => rng.int(0..=255) as i32,
        1 => rng.pick(&[i32::MIN, i32::MAX, 0, 1, -1]),
        2 => random::saturate(rng.magnitude(31)),
        _ => rng.int(random::LOWEST..=random::HIGHEST) as i32,
    }
}

#[test]
fn every_value_is_the_nearest_to_the_exact_one() {
    let checked = for_each_case(0xA771, cases(60_000), |rng| {
        let (triangle, clip) = random::triangle(rng);
        let values = [(); 3].map(|()| [value(rng), value(rng)]);
        let found = pixels(&Affine::new(triangle, values), &clip)?;
        let expected = span_pixels(&triangle, &clip);
        if found.len() != expected.len() {
            return Err(format!("{} pixels in place of {}: {triangle:?} in {clip:?}", found.len(), expected.len()));
        }
        for (at, found) in &found {
            let (parts, sum) = areas(&triangle, *at);
            for index in 0..2 {
                let of_vertices = values.map(|values| i128::from(values[index]));
                let exact = (0..3).map(|vertex| parts[vertex] * of_vertices[vertex]).sum();
                if i128::from(found[index]) != nearest(exact, sum) {
                    let exact = nearest(exact, sum);
                    return Err(format!("{at:?}: {found:?}, {exact} expected; {triangle:?} {values:?} in {clip:?}"));
                }
                let range = of_vertices.into_iter().min()..=of_vertices.into_iter().max();
                assert!(range.contains(&Some(i128::from(found[index]))), "follows from what is exact");
            }
        }
        Ok(found.len() as u64)
    });
    assert!(checked > 100_000, "{checked} pixels are not enough to tell");
}

/// One function over the whole plane: every triangle of a mesh, wherever it is cut, shows it.
#[test]
fn meshes_show_one_plane() {
    for_each_case(0xA772, cases(4_000), |rng| {
        let mut vertex = || [rng.int(-40..=40) * 32, rng.int(-40..=40) * 32];
        let corners: [_; 4] = std::array::from_fn(|_| vertex());
        // A multiple of a pixel, so that it is whole at every vertex.
        let (a, b, c) = (rng.int(-9..=9) as i32, rng.int(-9..=9) as i32, rng.int(-999..=999) as i32);
        let at = |x: i32, y: i32| a * x + b * y + c;
        let clip = rect(-8..8, -8..8);
        for triple in [[0, 1, 2], [2, 1, 3], [3, 0, 1]] {
            let of = triple.map(|index| corners[index].map(|coordinate| coordinate as i32));
            let triangle = Triangle::from_vertices(of.map(|[x, y]| Vertex::from_bits(x, y)));
            for ((row, column), [value]) in pixels(&Affine::new(triangle, of.map(|[x, y]| [at(x, y)])), &clip)? {
                let expected = at(column * 256 + 128, row * 256 + 128);
                if value != expected {
                    return Err(format!("{value}, {expected} expected at {column} {row} of {triangle:?}"));
                }
            }
        }
        Ok(1)
    });
}

#[test]
fn clips_cut_and_change_nothing() {
    for_each_case(0xA773, cases(4_000), |rng| {
        let (triangle, clip) = random::triangle(rng);
        let values = [(); 3].map(|()| [value(rng)]);
        let near = [(); 3].map(|()| [rng.int(0..=64 * 256) as i32]);
        let distances = [(); 3].map(|()| rng.int(1..=256) as i32);
        let affine = Affine::new(triangle, values);
        // Only what divides at every pixel does not depend on where spans begin.
        let seen = Perspective::new(triangle, near, distances).expect("positive").tolerance(0);
        let (whole, whole_seen) = (pixels(&affine, &clip)?, pixels(&seen, &clip)?);
        let row = rng.int(clip.rows.start.into()..=clip.rows.end.into()) as i32;
        let column = rng.int(clip.columns.start.into()..=clip.columns.end.into()) as i32;
        let (mut parts, mut parts_seen) = (Pixels::new(), Pixels::new());
        for rows in [clip.rows.start..row, row..clip.rows.end] {
            for columns in [clip.columns.start..column, column..clip.columns.end] {
                let part = PixelRect { rows: rows.clone(), columns };
                parts.extend(pixels(&affine, &part)?);
                parts_seen.extend(pixels(&seen, &part)?);
            }
        }
        if whole == parts && whole_seen == parts_seen { Ok(1) } else { Err(format!("{triangle:?} {clip:?}")) }
    });
}

#[test]
fn perspective_is_within_half_a_texel() {
    // The worst in 1/256 texel, by tolerance.
    for (tolerance, bound) in [(64, 128), (0, 64)] {
        let worst = std::sync::atomic::AtomicI64::new(0);
        for_each_case(0xA774, cases(20_000), |rng| {
            let (triangle, clip) = if rng.one_in(2) {
                random::triangle(rng)
            } else {
                let mut vertex = || Vertex::from_bits(rng.int(0..=320 * 256) as i32, rng.int(0..=64 * 256) as i32);
                (Triangle::from_vertices([vertex(), vertex(), vertex()]), rect(0..320, 0..64))
            };
            let values = [(); 3].map(|()| [rng.int(0..=64 * 256) as i32, rng.int(0..=64 * 256) as i32]);
            let scale = rng.int(1..=65536);
            let distances = [(); 3].map(|()| (rng.pick(&[1, 256, rng.clone().int(1..=256)]) * scale) as i32);
            let seen = Perspective::new(triangle, values, distances).expect("positive").tolerance(tolerance);
            for (at, found) in pixels(&seen, &clip)? {
                let (parts, _) = areas(&triangle, at);
                let w = distances.map(i128::from);
                // Over the common denominator of the three 1/w.
                let weights = [parts[0] * w[1] * w[2], parts[1] * w[0] * w[2], parts[2] * w[0] * w[1]];
                let sum: i128 = weights.iter().sum();
                for index in 0..2 {
                    let exact: i128 = (0..3).map(|vertex| weights[vertex] * i128::from(values[vertex][index])).sum();
                    let error = (i128::from(found[index]) * sum - exact).abs() / sum;
                    worst.fetch_max(error as i64, std::sync::atomic::Ordering::Relaxed);
                    let of = values.map(|values| values[index]);
                    let inside = of.iter().min() <= Some(&found[index]) && Some(&found[index]) <= of.iter().max();
                    if error > bound || !inside {
                        return Err(format!("{error} off at {at:?}: {triangle:?} {values:?} {distances:?}"));
                    }
                }
            }
            Ok(1)
        });
        println!("tolerance {tolerance}: {worst:?} of {bound}");
    }
}

/// s/w from 4/1 to 6/3, 1/w from 1 to 1/3: in the middle 3 over 2/3.
#[test]
fn the_middle_of_the_notes_example_is_four_and_a_half() {
    for length in [2, 8, 16, 64, 200] {
        let triangle = Triangle::new(Vertex::pixel(0, 0), Vertex::pixel(length, 0), Vertex::pixel(0, length));
        let seen = Perspective::new(triangle, [[4 << 8], [6 << 8], [4 << 8]], [1, 3, 1]).expect("positive");
        for (tolerance, units) in [(0, 0), (2, 4), (64, 66)] {
            let found = pixels(&seen.tolerance(tolerance), &rect(0..200, 0..1)).expect("each once");
            let [middle] = found[&(0, length / 2)];
            assert!(middle.abs_diff(4 * 256 + 128) <= units, "{middle} of {length}, tolerance {tolerance}");
        }
    }
}

/// Triangles from one end of the coordinates to the other, seen through a window in the middle and at each corner.
#[test]
fn vertices_at_the_ends_of_the_range() {
    let (low, high) = (i32::MIN, i32::MAX);
    let corners = [[low, low], [high, low], [high, high], [low, high], [0, low], [high, 1], [-3, 5]];
    let far = 1 << 23;
    for_each_case(0xA779, cases(400), |rng| {
        let vertices = [(); 3].map(|()| rng.pick(&corners)).map(|[x, y]| Vertex::from_bits(x, y));
        let triangle = Triangle::from_vertices(vertices);
        let near = |middle: i32| (middle - 8).max(-far)..(middle + 8).min(far);
        let clip = PixelRect { rows: near(rng.pick(&[-far, 0, far])), columns: near(rng.pick(&[-far, 0, far])) };
        let area = Rectangle::from(clip.clone());
        let values = [(); 3].map(|()| [value(rng)]);
        let texels = [(); 3].map(|()| [rng.int(0..=64 * 256) as i32]);
        let colours = [(); 3].map(|()| Rgb565::new(rng.int(0..=31) as u8, rng.int(0..=63) as u8, 7));
        let seen = Perspective::new(triangle, texels, [1, 2, 3]).expect("in front");
        let (found, seen) = (pixels(&Affine::new(triangle, values), &clip)?, pixels(&seen, &clip)?);
        let mut packed = Memory::new(area, Rgb565::BLACK);
        Gouraud::packed(triangle, colours).draw(&mut packed).expect("infallible");
        for at in span_pixels(&triangle, &clip).into_iter().map(|(column, row)| (row, column)) {
            let (parts, sum) = areas(&triangle, at);
            let mean = |values: [i128; 3]| (0..3).map(|vertex| parts[vertex] * values[vertex]).sum::<i128>();
            if i128::from(found[&at][0]) != nearest(mean(values.map(|[value]| value.into())), sum) {
                return Err(format!("{at:?} of {triangle:?} {values:?}"));
            }
            let green = i128::from(packed.at(Point::new(at.1, at.0)).g());
            if 32 * (green * sum - mean(colours.map(|colour| colour.g().into()))).abs() > 17 * sum {
                return Err(format!("packed {at:?} of {triangle:?} {colours:?}"));
            }
            // Over the common denominator of the three 1/w.
            let weights = [6 * parts[0], 3 * parts[1], 2 * parts[2]];
            let sum: i128 = weights.iter().sum();
            let exact: i128 = (0..3).map(|vertex| weights[vertex] * i128::from(texels[vertex][0])).sum();
            if (i128::from(seen[&at][0]) * sum - exact).abs() > 128 * sum {
                return Err(format!("seen {at:?} of {triangle:?} {texels:?}"));
            }
        }
        Ok(1)
    });
}

#[test]
fn vertices_behind_the_eye_are_refused() {
    let triangle = Triangle::new(Point::new(0, 0), Point::new(9, 0), Point::new(0, 9));
    for (distances, vertex) in [([1, 0, 1], 1), ([1, 1, -5], 2), ([i32::MIN, 0, 1], 0)] {
        assert_eq!(Perspective::new(triangle, [[0]; 3], distances), Err(NotInFront { vertex }));
    }
}

#[test]
fn packed_channels_are_within_a_half_and_a_thirty_second_of_a_level() {
    let frame = Rectangle::new(Point::new(-4, -4), Size::new(328, 40));
    let worst = std::sync::atomic::AtomicI64::new(0);
    for_each_case(0xA775, cases(3_000), |rng| {
        let triangle = if rng.one_in(2) {
            random::triangle(rng).0
        } else {
            let mut vertex = || Vertex::from_bits(rng.int(0..=320 * 256) as i32, rng.int(0..=32 * 256) as i32);
            Triangle::from_vertices([vertex(), vertex(), vertex()])
        };
        let mut end = |last: i64| rng.pick(&[0, last, rng.clone().int(0..=last)]) as u8;
        let colours = [(); 3].map(|()| Rgb565::new(end(31), end(63), end(31)));
        let mut target = Memory::new(frame, Rgb565::BLACK);
        Gouraud::packed(triangle, colours).draw(&mut target).expect("infallible");
        let mut in_rows = Memory::new(frame, Rgb565::BLACK);
        Gouraud::packed(triangle, colours).draw_on(&mut in_rows).expect("infallible");
        if target.pixels != in_rows.pixels {
            return Err(format!("rows differ: {triangle:?} {colours:?}"));
        }
        for (row, column) in span_pixels(&triangle, &PixelRect::from(frame)).into_iter().map(|(x, y)| (y, x)) {
            let found = target.at(Point::new(column, row));
            let (parts, sum) = areas(&triangle, (row, column));
            let channels = |c: Rgb565| [c.r(), c.g(), c.b()].map(i128::from);
            for index in 0..3 {
                let exact: i128 = (0..3).map(|vertex| parts[vertex] * channels(colours[vertex])[index]).sum();
                let error = (channels(found)[index] * sum - exact).abs();
                worst.fetch_max((error * 10_000 / sum) as i64, std::sync::atomic::Ordering::Relaxed);
                if 32 * error > 17 * sum {
                    return Err(format!("{found:?} at {column} {row} of {triangle:?} {colours:?}"));
                }
            }
        }
        Ok(1)
    });
    println!("worst: {worst:?} ten thousandths of a level");
}

#[test]
fn gouraud_is_flat_where_colours_are_equal_and_the_same_on_every_target() {
    let triangle =
        Triangle::new(Vertex::from_bits(130, 99), Vertex::from_bits(7000, 1500), Vertex::from_bits(900, 8001));
    let frame = Rectangle::new(Point::zero(), Size::new(32, 32));
    for colours in [[Rgb888::RED, Rgb888::GREEN, Rgb888::BLUE], [Rgb888::CYAN; 3]] {
        let gouraud = Gouraud::new(triangle, colours);
        let mut target = Memory::new(frame, Rgb888::BLACK);
        gouraud.draw(&mut target).expect("infallible");
        let mut rows = Memory::new(frame, Rgb888::BLACK);
        gouraud.draw_on(&mut rows).expect("infallible");
        assert_eq!(target.pixels, rows.pixels);
    }
    let mut flat = Memory::new(frame, Rgb888::BLACK);
    triangle.filled(Rgb888::CYAN).draw(&mut flat).expect("infallible");
    let mut gouraud = Memory::new(frame, Rgb888::BLACK);
    Gouraud::new(triangle, [Rgb888::CYAN; 3]).draw(&mut gouraud).expect("infallible");
    assert_eq!(flat.pixels, gouraud.pixels);
}

#[test]
fn the_average_is_the_notes() {
    for a in 0..=255_u8 {
        for (b, c) in [(0, 0), (1, 0), (255, 255), (a, 7), (a / 2, 255 - a)] {
            let expected = (2 * (u32::from(a) + u32::from(b) + u32::from(c)) + 3) / 6;
            assert_eq!(u32::from(average([Gray8::new(a), Gray8::new(b), Gray8::new(c)]).luma()), expected);
        }
    }
}

#[test]
fn barycentric_answers_are_those_of_pixels() {
    for_each_case(0xA776, cases(20_000), |rng| {
        let (triangle, clip) = random::triangle(rng);
        let pixels: std::collections::BTreeSet<_> = span_pixels(&triangle, &clip).into_iter().collect();
        let Some(barycentric) = Barycentric::new(&triangle) else {
            return if pixels.is_empty() { Ok(0) } else { Err(format!("{triangle:?} has no area but pixels")) };
        };
        for row in clip.rows.clone().filter(|row| (-8388608..8388608).contains(row)).take(8) {
            for column in clip.columns.clone().filter(|column| (-8388608..8388608).contains(column)) {
                let centre = Vertex::pixel(column, row);
                if barycentric.contains(centre) != pixels.contains(&(column, row)) {
                    return Err(format!("{column} {row} of {triangle:?}"));
                }
                let weights = barycentric.weights_at(centre);
                let (parts, sum) = areas(&triangle, (row, column));
                if (weights.numerators, weights.denominator) != (parts, sum) {
                    return Err(format!("{weights:?} in place of {parts:?} {sum}"));
                }
            }
        }
        Ok(1)
    });
}

mod depth {
    use super::*;

    #[test]
    fn too_little_memory_is_an_error_that_tells_how_much() {
        let area = Rectangle::new(Point::new(-3, 5), Size::new(10, 4));
        let error = DepthBuffer::new(area, 9, &mut [0; 100]).unwrap_err();
        assert_eq!(error, DepthBufferError::StrideTooSmall { width: 10, stride: 9 });
        let error = DepthBuffer::new(area, 12, &mut [0; 45]).unwrap_err();
        assert_eq!(error, DepthBufferError::TooShort { needed: 46, available: 45 });
        assert!(DepthBuffer::new(area, 12, &mut [0; 46]).is_ok());
        let endless = Rectangle::new(Point::zero(), Size::new(u32::MAX, u32::MAX));
        assert!(DepthBuffer::new(endless, usize::MAX, &mut [0; 46]).is_err());
    }

    /// Two triangles that cut through each other, on a whole buffer, on bands, on every kind of target, in either order.
    #[test]
    fn the_nearer_one_is_seen() {
        let frame = Rectangle::new(Point::zero(), Size::new(48, 40));
        for_each_case(0xA777, cases(500), |rng| {
            let mut triangle = || {
                let mut vertex = || Vertex::from_bits(rng.int(-999..=14000) as i32, rng.int(-999..=12000) as i32);
                let triangle = Triangle::from_vertices([vertex(), vertex(), vertex()]);
                (triangle, [(); 3].map(|()| rng.int(0..=65535) as u16))
            };
            let scene = [triangle(), triangle(), triangle()];
            // The exact depths of each at every pixel.
            let mut expected = vec![(u16::MAX, Rgb565::BLACK); 48 * 40];
            let colours = [Rgb565::RED, Rgb565::GREEN, Rgb565::BLUE];
            for ((triangle, depths), colour) in scene.iter().zip(colours) {
                for (x, y) in span_pixels(triangle, &PixelRect::from(frame)) {
                    let (parts, sum) = areas(triangle, (y, x));
                    let depth = nearest((0..3).map(|v| parts[v] * i128::from(depths[v])).sum(), sum) as u16;
                    let kept = &mut expected[y as usize * 48 + x as usize];
                    if depth < kept.0 {
                        *kept = (depth, colour);
                    }
                }
            }
            let draw = |target: &mut Memory<Rgb565>, area: Rectangle, rows: bool| {
                let mut memory = vec![0; 50 * 40];
                let mut buffer = DepthBuffer::new(area, 50, &mut memory).expect("large enough");
                buffer.clear(u16::MAX);
                for ((triangle, depths), colour) in scene.iter().zip(colours) {
                    let shaded = Affine::new(*triangle, [[], [], []]).shaded(|[]| colour);
                    let tested = shaded.depth_tested(*depths, DepthTest::LESS);
                    if rows {
                        tested.draw_on(target, &mut buffer);
                    } else {
                        tested.draw(target, &mut buffer).expect("infallible");
                    }
                }
            };
            for rows in [false, true] {
                let (mut whole, mut bands) = (Memory::new(frame, Rgb565::BLACK), Memory::new(frame, Rgb565::BLACK));
                draw(&mut whole, frame, rows);
                for top in [0, 8, 16, 24, 32] {
                    draw(&mut bands, Rectangle::new(Point::new(0, top), Size::new(48, 8)), rows);
                }
                let expected: Vec<_> = expected.iter().map(|(_, colour)| *colour).collect();
                if whole.pixels != expected || bands.pixels != expected {
                    return Err(format!("rows {rows}: {scene:?}"));
                }
            }
            Ok(1)
        });
    }

    /// Rows are tested in pieces: values go on where they stopped, whatever their pieces are.
    #[test]
    fn values_are_the_same_with_a_buffer() {
        let frame = Rectangle::new(Point::new(-7, 3), Size::new(150, 30));
        for_each_case(0xA778, cases(400), |rng| {
            let mut vertex = || Vertex::from_bits(rng.int(-9000..=44000) as i32, rng.int(-999..=12000) as i32);
            let triangle = Triangle::from_vertices([vertex(), vertex(), vertex()]);
            let mut three = |low: i64, high: i64| [(); 3].map(|()| rng.int(low..=high) as i32);
            let (u, v, w, z) = (three(0, 16384), three(-300, 9000), three(1, 4000), three(0, 65535));
            let values = [0, 1, 2].map(|vertex| [u[vertex], v[vertex]]);
            let depths = z.map(|depth| depth as u16);
            let shade = |[u, v]: [i32; 2]| Rgb565::new((u >> 6) as u8 & 31, (v >> 4) as u8 & 63, (u ^ v) as u8 & 31);
            let mut memory = vec![0; 150 * 30];
            let mut buffer = DepthBuffer::new(frame, 150, &mut memory).expect("large enough");
            let mut targets = [(); 6].map(|()| Memory::new(frame, Rgb565::BLACK));
            let [plain, tested, sent, seen, seen_tested, seen_sent] = &mut targets;
            let affine = Affine::new(triangle, values).shaded(shade);
            let perspective = Perspective::new(triangle, values, w).expect("in front").shaded(shade);
            affine.draw_on(plain);
            perspective.draw_on(seen);
            for (target, test) in [(&mut *tested, DepthTest::LESS), (sent, DepthTest::LESS_OR_EQUAL)] {
                buffer.clear(u16::MAX);
                if test == DepthTest::LESS {
                    affine.depth_tested(depths, test).draw_on(target, &mut buffer);
                } else {
                    affine.depth_tested(depths, test).draw(target, &mut buffer).expect("infallible");
                }
            }
            buffer.clear(u16::MAX);
            perspective.depth_tested(depths, DepthTest::ALWAYS).draw_on(seen_tested, &mut buffer);
            perspective.depth_tested(depths, DepthTest::ALWAYS).draw(seen_sent, &mut buffer).expect("infallible");
            // The furthest depth is not less than what is cleared to.
            let nearer = depths.iter().all(|depth| *depth < u16::MAX);
            if nearer && (plain.pixels != tested.pixels || plain.pixels != sent.pixels) {
                return Err(format!("affine {triangle:?} {values:?}"));
            }
            if seen.pixels != seen_tested.pixels || seen.pixels != seen_sent.pixels {
                return Err(format!("perspective {triangle:?} {values:?} {w:?}"));
            }
            Ok(1)
        });
    }

    /// Less, less or equal, always, each with and without writing, on every kind of target, with few depths that are often equal.
    #[test]
    fn every_test_draws_what_passes_and_keeps_what_it_should() {
        let frame = Rectangle::new(Point::new(2, -3), Size::new(40, 30));
        let plain = [DepthTest::LESS, DepthTest::LESS_OR_EQUAL, DepthTest::ALWAYS];
        for_each_case(0xA77A, cases(300), |rng| {
            let scene: [_; 5] = std::array::from_fn(|index| {
                let mut vertex = || Vertex::from_bits(rng.int(-999..=12000) as i32, rng.int(-999..=9000) as i32);
                let triangle = Triangle::from_vertices([vertex(), vertex(), vertex()]);
                let (which, writes) = (rng.index(3), rng.one_in(2));
                let test = if writes { plain[which] } else { plain[which].without_writing() };
                (
                    triangle,
                    [(); 3].map(|()| rng.int(7..=9) as u16),
                    (which, writes, test),
                    Rgb565::new(index as u8, 9, 9),
                )
            });
            let size = (frame.size.width * frame.size.height) as usize;
            let (mut expected, mut expected_depths) = (vec![Rgb565::BLACK; size], vec![8_u16; size]);
            for (triangle, depths, (which, writes, _), colour) in &scene {
                for (x, y) in span_pixels(triangle, &PixelRect::from(frame)) {
                    let (parts, sum) = areas(triangle, (y, x));
                    let depth = nearest((0..3).map(|v| parts[v] * i128::from(depths[v])).sum(), sum) as u16;
                    let index = (y + 3) as usize * 40 + (x - 2) as usize;
                    let kept = &mut expected_depths[index];
                    if [depth < *kept, depth <= *kept, true][*which] {
                        expected[index] = *colour;
                        if *writes {
                            *kept = depth;
                        }
                    }
                }
            }
            for rows in [false, true] {
                let (mut target, mut memory) = (Memory::new(frame, Rgb565::BLACK), vec![8; size]);
                let mut buffer = DepthBuffer::new(frame, 40, &mut memory).expect("large enough");
                for (triangle, depths, (_, _, test), colour) in &scene {
                    let tested = Affine::new(*triangle, [[], [], []]).shaded(|[]| *colour).depth_tested(*depths, *test);
                    if rows {
                        tested.draw_on(&mut target, &mut buffer);
                    } else {
                        tested.draw(&mut target, &mut buffer).expect("infallible");
                    }
                }
                if target.pixels != expected || memory != expected_depths {
                    return Err(format!("rows {rows}: {scene:?}"));
                }
            }
            Ok(1)
        });
    }

    /// A buffer of a part of the target, and of another stride: nothing outside is drawn, nor a depth between the rows.
    #[test]
    fn what_the_buffer_does_not_know_is_left_alone() {
        let frame = Rectangle::new(Point::zero(), Size::new(40, 30));
        let part = Rectangle::new(Point::new(11, -5), Size::new(13, 20));
        let triangle = Triangle::new(Point::new(-5, -5), Point::new(90, -5), Point::new(-5, 90));
        for rows in [false, true] {
            let (mut target, mut memory) = (Memory::new(frame, Rgb565::BLACK), vec![u16::MAX; 17 * 20]);
            let mut buffer = DepthBuffer::new(part, 17, &mut memory).expect("large enough");
            let white = Affine::new(triangle, [[], [], []]).shaded(|[]| Rgb565::WHITE);
            let tested = white.depth_tested([5; 3], DepthTest::LESS);
            if rows {
                tested.draw_on(&mut target, &mut buffer);
            } else {
                tested.draw(&mut target, &mut buffer).expect("infallible");
            }
            for point in frame.points() {
                assert_eq!(target.at(point) == Rgb565::WHITE, part.contains(point), "{point}");
            }
            for (index, depth) in memory.into_iter().enumerate() {
                // Rows above the target are not drawn.
                assert_eq!(depth == 5, index % 17 < 13 && index / 17 >= 5, "{index}");
            }
        }
    }

    #[test]
    fn tests_are_what_they_say() {
        for (test, passing) in
            [(DepthTest::LESS, [4, 5, 5]), (DepthTest::LESS_OR_EQUAL, [4, 5, 5]), (DepthTest::ALWAYS, [4, 5, 6])]
        {
            for (depth, after) in [4, 5, 6].into_iter().zip(passing) {
                let mut kept = 5;
                let passes = test.passes(depth, &mut kept);
                assert_eq!(kept, after);
                let expected = depth < 5 || test == DepthTest::ALWAYS || test == DepthTest::LESS_OR_EQUAL && depth == 5;
                assert_eq!(passes, expected);
                let mut kept = 5;
                assert_eq!(test.without_writing().passes(depth, &mut kept), expected);
                assert_eq!(kept, 5);
            }
        }
    }
}

mod texture {
    use super::*;

    type Picture =
        Framebuffer<Gray8, embedded_graphics::pixelcolor::raw::RawU8, BigEndian, 3, 2, { buffer_size::<Gray8>(3, 2) }>;

    fn picture() -> Picture {
        let mut picture = Picture::new();
        let pixels = (0..6).map(|index| Pixel(Point::new(index % 3, index / 3), Gray8::new(40 * index as u8)));
        picture.draw_iter(pixels).expect("infallible");
        picture
    }

    #[test]
    fn nearest_wraps_and_clamps_everywhere() {
        let (repeat, clamp) = (
            Texture::new(picture(), Wrap::Repeat, Filter::Nearest).unwrap(),
            Texture::new(picture(), Wrap::Clamp, Filter::Nearest).unwrap(),
        );
        for s in (-9 * 256..9 * 256).step_by(64).chain([i32::MIN, i32::MAX]) {
            for t in (-9 * 256..9 * 256).step_by(128).chain([i32::MIN, i32::MAX]) {
                let (x, y) = (s.div_euclid(256), t.div_euclid(256));
                let repeated = 40 * (x.rem_euclid(3) + 3 * y.rem_euclid(2));
                let clamped = 40 * (x.clamp(0, 2) + 3 * y.clamp(0, 1));
                assert_eq!(repeat.texel([s, t]), Some(Gray8::new(repeated as u8)));
                assert_eq!(clamp.sample([s, t]), Some(Gray8::new(clamped as u8)));
            }
        }
    }

    #[test]
    fn bilinear_is_within_a_level_of_the_exact_mix() {
        let texture = Texture::new(picture(), Wrap::Repeat, Filter::Bilinear).unwrap();
        for s in (-1000..1000).step_by(7) {
            for t in (-1000..1000).step_by(13) {
                let texel = |x: i32, y: i32| f64::from(40 * (x.rem_euclid(3) + 3 * y.rem_euclid(2)));
                let (x, y) = ((s - 128_i32).div_euclid(256), (t - 128_i32).div_euclid(256));
                let (u, v) = (f64::from((s - 128) - 256 * x) / 256.0, f64::from((t - 128) - 256 * y) / 256.0);
                let exact = (texel(x, y) * (1.0 - u) + texel(x + 1, y) * u) * (1.0 - v)
                    + (texel(x, y + 1) * (1.0 - u) + texel(x + 1, y + 1) * u) * v;
                let found = f64::from(texture.sample([s, t]).unwrap().luma());
                assert!((found - exact).abs() <= 1.6, "{found} in place of {exact} at {s} {t}");
            }
        }
    }

    /// A picture of a size and at a place of its own.
    struct Placed(Rectangle);

    impl Dimensions for Placed {
        fn bounding_box(&self) -> Rectangle {
            self.0
        }
    }

    impl embedded_graphics::image::GetPixel for Placed {
        type Color = Gray8;

        fn pixel(&self, point: Point) -> Option<Gray8> {
            let at = point - self.0.top_left;
            self.0.contains(point).then(|| Gray8::new((31 * at.x + 50 * at.y) as u8))
        }
    }

    /// Whatever its sides and wherever its corner: a mask, a division or an end of a row give the same.
    #[test]
    fn any_picture_is_wrapped_clamped_and_mixed() {
        for corner in [Point::zero(), Point::new(-5, 7), Point::new(0, 3)] {
            for (width, height) in [(4, 2), (3, 2), (4, 3), (1, 1), (8, 1)] {
                for wrap in [Wrap::Repeat, Wrap::Clamp] {
                    let picture = || Placed(Rectangle::new(corner, Size::new(width as u32, height as u32)));
                    let near = Texture::new(picture(), wrap, Filter::Nearest).unwrap();
                    let mixed = Texture::new(picture(), wrap, Filter::Bilinear).unwrap();
                    let of = |at: i32, side: i32| match wrap {
                        Wrap::Repeat => at.rem_euclid(side),
                        Wrap::Clamp => at.clamp(0, side - 1),
                    };
                    let texel = |x: i32, y: i32| 31 * of(x, width) + 50 * of(y, height);
                    for s in (-2600..2600).step_by(37) {
                        for t in (-1000..1000).step_by(41) {
                            let found = near.texel([s, t]).unwrap();
                            assert_eq!(i32::from(found.luma()), texel(s.div_euclid(256), t.div_euclid(256)));
                            let (x, y) = ((s - 128).div_euclid(256), (t - 128).div_euclid(256));
                            let (u, v) = (s - 128 - 256 * x, t - 128 - 256 * y);
                            let above = texel(x, y) * (256 - u) + texel(x + 1, y) * u;
                            let below = texel(x, y + 1) * (256 - u) + texel(x + 1, y + 1) * u;
                            let exact = f64::from(above * (256 - v) + below * v) / 65536.0;
                            let found = f64::from(mixed.sample([s, t]).unwrap().luma());
                            assert!((found - exact).abs() <= 1.6, "{found} in place of {exact} at {s} {t}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn no_size_is_an_error() {
        type Empty = Framebuffer<Gray8, embedded_graphics::pixelcolor::raw::RawU8, BigEndian, 0, 0, 0>;
        assert!(Texture::new(Empty::new(), Wrap::Repeat, Filter::Nearest).is_err());
    }
}

/// Pixels in memory, anywhere on the screen.
struct Memory<C> {
    area: Rectangle,
    pixels: Vec<C>,
}

impl<C: PixelColor> Memory<C> {
    fn new(area: Rectangle, colour: C) -> Self {
        Self { area, pixels: vec![colour; (area.size.width * area.size.height) as usize] }
    }

    fn at(&mut self, point: Point) -> C {
        self.row_from(point).expect("inside")[0]
    }
}

impl<C> Dimensions for Memory<C> {
    fn bounding_box(&self) -> Rectangle {
        self.area
    }
}

impl<C: PixelColor> PixelRows for Memory<C> {
    fn row_from(&mut self, start: Point) -> Option<&mut [C]> {
        if !self.area.contains(start) {
            return None;
        }
        let (at, width) = (start - self.area.top_left, self.area.size.width as usize);
        self.pixels.chunks_mut(width).nth(at.y as usize)?.get_mut(at.x as usize..)
    }
}

impl<C: PixelColor> DrawTarget for Memory<C> {
    type Color = C;
    type Error = std::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        for Pixel(point, colour) in pixels {
            self.row_from(point).expect("nothing is sent outside")[0] = colour;
        }
        Ok(())
    }
}
