//! How colours are mixed, and what a target sees of it: exact channels, runs in as few calls as there can be, nothing
//! outside the bounding box, nothing read where nothing shows through.

mod oracle;

use std::fmt::Debug;

use embedded_graphics::{
    Drawable as _, Pixel,
    draw_target::DrawTarget,
    framebuffer::{Framebuffer, buffer_size},
    geometry::{Dimensions, Point, Size},
    image::GetPixel,
    mock_display::MockDisplay,
    pixelcolor::{
        Bgr555, Bgr565, Bgr666, Bgr888, BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb555, Rgb565, Rgb666, Rgb888,
        raw::LittleEndian,
    },
    prelude::{GrayColor, PointsIter as _, RgbColor},
    primitives::Rectangle,
};
use oracle::{cases, for_each_case, random};
use spanfill::{
    AntiAlias as _, Blend, Circle, Cover, CoverageSink, Dither, Linear, Mix, MixLinear, Over, PixelRect, ReadBack, Span,
};

// --- Mixing ----------------------------------------------------------------------------------------------------------

/// A colour by its channels.
trait Channels: Mix + MixLinear + Debug + PartialEq {
    /// The last step of each.
    const LAST: [u8; 3];

    fn of(channels: [u8; 3]) -> Self;

    fn channels(self) -> [u8; 3];
}

macro_rules! impl_channels {
    ($($colour:ident)+) => {
        $(impl Channels for $colour {
            const LAST: [u8; 3] = [Self::MAX_R, Self::MAX_G, Self::MAX_B];

            fn of([r, g, b]: [u8; 3]) -> Self {
                Self::new(r, g, b)
            }

            fn channels(self) -> [u8; 3] {
                [self.r(), self.g(), self.b()]
            }
        })+
    };
    ($($colour:ident $last:literal)+) => {
        $(impl Channels for $colour {
            /// One channel, said three times.
            const LAST: [u8; 3] = [$last; 3];

            fn of([luma, ..]: [u8; 3]) -> Self {
                Self::new(luma)
            }

            fn channels(self) -> [u8; 3] {
                [self.luma(); 3]
            }
        })+
    };
}

impl_channels!(Rgb555 Bgr555 Rgb565 Bgr565 Rgb666 Bgr666 Rgb888 Bgr888);
impl_channels!(Gray2 3 Gray4 15 Gray8 255);

/// The nearest step, told by its distance from the exact mix, in 510ths of a step: there are no ties.
fn assert_nearest(mixed: u8, top: u8, bottom: u8, alpha: u8) {
    let [mixed, top, bottom, alpha] = [mixed, top, bottom, alpha].map(i32::from);
    let distance = 2 * (255 * mixed - top * alpha - bottom * (255 - alpha));
    assert!(distance.abs() < 255, "{top} over {bottom} by {alpha} is not {mixed}");
}

/// All pairs of steps in each channel with all alphas. Beside it, channels of its depth have the same pair, the middle
/// one reversed, and those of another are at both ends.
fn check_all_mixes<C: Channels>() {
    let last = C::LAST;
    for index in 0..if last[0] == last[1] && last[1] == last[2] { 1 } else { 3 } {
        for top in 0..=last[index] {
            for bottom in 0..=last[index] {
                let beside = [0, u8::MAX][usize::from((top ^ bottom) & 1)];
                let (mut tops, mut bottoms) = (last.map(|last| beside & last), last.map(|last| !beside & last));
                for shift in 0..3 {
                    if last[shift] == last[index] {
                        (tops[shift], bottoms[shift]) = if shift == 1 { (bottom, top) } else { (top, bottom) };
                    }
                }
                let (above, below) = (C::of(tops), C::of(bottoms));
                for alpha in 0..=255 {
                    let mixed = above.over(below, alpha).channels();
                    for (channel, mixed) in mixed.into_iter().enumerate() {
                        assert_nearest(mixed, above.channels()[channel], below.channels()[channel], alpha);
                    }
                }
            }
        }
    }
}

/// Channels that have nothing to do with each other: none runs over into the next.
fn check_random_mixes<C: Channels>(seed: u64) {
    for_each_case(seed, cases(200_000), |rng| {
        let mut colour = || C::of(C::LAST.map(|last| rng.int(0..=i64::from(last)) as u8));
        let (top, bottom) = (colour(), colour());
        let alpha = rng.int(0..=255) as u8;
        for (channel, mixed) in top.over(bottom, alpha).channels().into_iter().enumerate() {
            assert_nearest(mixed, top.channels()[channel], bottom.channels()[channel], alpha);
        }
        Ok(0)
    });
}

#[test]
fn every_channel_is_mixed_to_the_nearest_step() {
    check_all_mixes::<Gray2>();
    check_all_mixes::<Gray4>();
    check_all_mixes::<Gray8>();
    check_all_mixes::<Rgb555>();
    check_all_mixes::<Bgr555>();
    check_all_mixes::<Rgb565>();
    check_all_mixes::<Bgr565>();
    check_all_mixes::<Rgb666>();
    check_all_mixes::<Bgr666>();
    check_all_mixes::<Rgb888>();
    check_all_mixes::<Bgr888>();
}

#[test]
fn channels_do_not_touch_each_other() {
    check_random_mixes::<Rgb555>(90);
    check_random_mixes::<Bgr555>(91);
    check_random_mixes::<Rgb565>(92);
    check_random_mixes::<Bgr565>(93);
    check_random_mixes::<Rgb666>(94);
    check_random_mixes::<Bgr666>(95);
    check_random_mixes::<Rgb888>(96);
    check_random_mixes::<Bgr888>(97);
}

#[test]
fn two_colours_change_at_half() {
    for alpha in 0..=255 {
        for top in [BinaryColor::Off, BinaryColor::On] {
            let expected = if f64::from(alpha) / 255.0 > 0.5 { top } else { top.invert() };
            assert_eq!(top.over(top.invert(), alpha), expected);
            assert_eq!(top.over_linear(top.invert(), alpha), expected);
            assert_eq!(top.over(top, alpha), top);
        }
    }
}

// --- Linear light ----------------------------------------------------------------------------------------------------

/// The light of each step by IEC 61966-2-1, from 0 to 1.
fn light(last: u8) -> Vec<f64> {
    let curve = |c: f64| if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
    (0..=last).map(|step| curve(f64::from(step) / f64::from(last))).collect()
}

/// What the tables' rounding may do to a light and to the mix it is compared with.
const TABLE: f64 = 2.0 / 65535.0;

/// The steps above and below are not nearer to the exact mix.
fn assert_nearest_light(light: &[f64], mixed: u8, top: u8, bottom: u8, alpha: u8) {
    let share = f64::from(alpha) / 255.0;
    let exact = light[usize::from(top)] * share + light[usize::from(bottom)] * (1.0 - share);
    let distance = |step: usize| light.get(step).map_or(f64::MAX, |light| (light - exact).abs());
    let step = usize::from(mixed);
    let (here, beside) = (distance(step), distance(step + 1).min(distance(step.wrapping_sub(1))));
    assert!(here <= beside + TABLE, "{top} over {bottom} by {alpha} in linear light is not {mixed} of {}", light.len());
}

/// All pairs of steps of a grey with all alphas.
fn check_all_linear_mixes<C: Channels>() {
    let light = light(C::LAST[0]);
    let grey = |luma: u8| C::of([luma; 3]);
    for top in 0..=C::LAST[0] {
        for bottom in 0..=C::LAST[0] {
            let mut before = bottom;
            for alpha in 0..=255 {
                let [mixed, ..] = grey(top).over_linear(grey(bottom), alpha).channels();
                assert_nearest_light(&light, mixed, top, bottom, alpha);
                let between = if bottom <= top { before..=top } else { top..=before };
                assert!(between.contains(&mixed), "{top} over {bottom} turns back at {alpha}");
                before = mixed;
            }
            assert_eq!(grey(top).over_linear(grey(bottom), 0), grey(bottom));
            assert_eq!(before, top);
        }
    }
}

/// Each channel by its own depth, and none by another's.
fn check_random_linear_mixes<C: Channels>(seed: u64) {
    let light = C::LAST.map(light);
    for_each_case(seed, cases(20_000), |rng| {
        let mut channels = || C::LAST.map(|last| rng.int(0..=i64::from(last)) as u8);
        let (tops, bottoms) = (channels(), channels());
        let alpha = rng.int(0..=255) as u8;
        let mixed = C::of(tops).over_linear(C::of(bottoms), alpha).channels();
        for channel in 0..3 {
            assert_nearest_light(&light[channel], mixed[channel], tops[channel], bottoms[channel], alpha);
        }
        Ok(0)
    });
}

#[test]
fn linear_light_is_the_nearest_step_to_the_curve() {
    check_all_linear_mixes::<Gray2>();
    check_all_linear_mixes::<Gray4>();
    check_all_linear_mixes::<Gray8>();
    // Every channel of five and of six bits.
    check_all_linear_mixes::<Rgb555>();
    check_all_linear_mixes::<Rgb666>();
    check_random_linear_mixes::<Bgr555>(100);
    check_random_linear_mixes::<Rgb565>(101);
    check_random_linear_mixes::<Bgr565>(102);
    check_random_linear_mixes::<Bgr666>(103);
    check_random_linear_mixes::<Rgb888>(104);
    check_random_linear_mixes::<Bgr888>(105);
}

#[test]
fn linear_light_is_as_the_documentation_says() {
    let steps = [0, 64, 128, 191, 255].map(|alpha| Gray8::WHITE.over_linear(Gray8::BLACK, alpha).luma());
    assert_eq!(steps, [0, 137, 188, 224, 255]);
}

// --- What a target sees ----------------------------------------------------------------------------------------------

/// Coverage as it is written down, cut to the clip.
#[derive(Debug, Clone)]
enum Piece {
    Run(i32, i32, Vec<u8>),
    Span(i32, i32, i32, u8),
}

#[derive(Debug, Clone)]
struct Pieces(Vec<Piece>);

impl Cover for Pieces {
    fn touched(&self) -> PixelRect {
        PixelRect { rows: i32::MIN..i32::MAX, columns: i32::MIN..i32::MAX }
    }

    fn coverage<S: CoverageSink>(&self, clip: &PixelRect, sink: &mut S) -> Result<(), S::Error> {
        for piece in &self.0 {
            match *piece {
                Piece::Run(row, column, ref coverage) => {
                    assert!(clip.rows.contains(&row), "the test's own mistake");
                    sink.run(row, column, coverage)?;
                }
                Piece::Span(row, start, end, coverage) => sink.span(Span { row, columns: start..end }, coverage)?,
            }
        }
        Ok(())
    }
}

#[derive(Debug, Clone, PartialEq)]
enum Call<C> {
    Pixels(Vec<(Point, C)>),
    Contiguous(Rectangle, Vec<C>),
    Solid(Rectangle, C),
}

/// Write-only; records what it is told, takes nothing outside, and can fail.
#[derive(Debug, Clone)]
struct Recorder<C> {
    bounds: Rectangle,
    calls: Vec<Call<C>>,
    fails_at: usize,
}

impl<C> Recorder<C> {
    fn new(bounds: Rectangle) -> Self {
        Self { bounds, calls: Vec::new(), fails_at: usize::MAX }
    }

    fn take(&mut self, call: Call<C>) -> Result<(), usize> {
        if self.calls.len() == self.fails_at {
            return Err(self.fails_at);
        }
        self.calls.push(call);
        Ok(())
    }

    fn assert_inside(&self, area: &Rectangle) {
        assert!(!area.is_zero_sized() && area.intersection(&self.bounds) == *area, "{area:?} in {:?}", self.bounds);
    }
}

impl<C: Copy> Recorder<C> {
    /// What was drawn, pixel by pixel, in the order it came.
    fn pixels(&self) -> Vec<(Point, C)> {
        let pixels = |call: &Call<C>| match call {
            Call::Pixels(pixels) => pixels.clone(),
            Call::Contiguous(area, colours) => area.points().zip(colours.iter().copied()).collect(),
            Call::Solid(area, colour) => area.points().map(|point| (point, *colour)).collect(),
        };
        self.calls.iter().flat_map(pixels).collect()
    }
}

impl<C> Dimensions for Recorder<C> {
    fn bounding_box(&self) -> Rectangle {
        self.bounds
    }
}

impl<C: PixelColor> DrawTarget for Recorder<C> {
    type Color = C;
    type Error = usize;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), usize> {
        let pixels: Vec<_> = pixels.into_iter().map(|Pixel(point, colour)| (point, colour)).collect();
        assert!(!pixels.is_empty(), "a call for nothing");
        for (point, _) in &pixels {
            self.assert_inside(&Rectangle::new(*point, Size::new(1, 1)));
        }
        self.take(Call::Pixels(pixels))
    }

    fn fill_contiguous<I: IntoIterator<Item = C>>(&mut self, area: &Rectangle, colors: I) -> Result<(), usize> {
        self.assert_inside(area);
        let colors: Vec<_> = colors.into_iter().collect();
        assert_eq!(colors.len(), (area.size.width * area.size.height) as usize);
        self.take(Call::Contiguous(*area, colors))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), usize> {
        self.assert_inside(area);
        self.take(Call::Solid(*area, color))
    }
}

/// A recorder that shows one colour wherever it is read, if it may be.
#[derive(Debug, Clone)]
struct Readable<C> {
    recorder: Recorder<C>,
    shows: Option<C>,
}

impl<C> Dimensions for Readable<C> {
    fn bounding_box(&self) -> Rectangle {
        self.recorder.bounds
    }
}

impl<C: PixelColor> DrawTarget for Readable<C> {
    type Color = C;
    type Error = usize;

    fn draw_iter<I: IntoIterator<Item = Pixel<C>>>(&mut self, pixels: I) -> Result<(), usize> {
        self.recorder.draw_iter(pixels)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: C) -> Result<(), usize> {
        self.recorder.fill_solid(area, color)
    }
}

impl<C: PixelColor> GetPixel for Readable<C> {
    type Color = C;

    fn pixel(&self, point: Point) -> Option<C> {
        assert!(self.recorder.bounds.contains(point), "{point:?} was read");
        Some(self.shows.expect("read where nothing shows through"))
    }
}

fn row(x: i32, y: i32, width: u32) -> Rectangle {
    Rectangle::new(Point::new(x, y), Size::new(width, 1))
}

const SCREEN: Rectangle = Rectangle::new(Point::new(-50, -20), Size::new(400, 60));

#[test]
fn a_run_is_one_window_and_what_is_alike_one_rectangle() {
    let long: Vec<u8> = (1..=255).chain((1..=70).rev()).collect();
    let shape = Pieces(vec![
        Piece::Run(-20, -50, vec![7]),
        Piece::Span(-20, -49, -20, 255),
        Piece::Run(3, 10, vec![9, 255]),
        Piece::Span(4, 0, 5, 100),
        Piece::Run(5, -2, long.clone()),
    ]);
    let grey = |alpha: u8| Gray8::WHITE.over(Gray8::new(20), alpha);
    let mut display = Recorder::new(SCREEN);
    shape.antialiased(Gray8::WHITE, Over(Gray8::new(20))).draw(&mut display).unwrap();
    assert_eq!(
        display.calls,
        [
            Call::Pixels(vec![(Point::new(-50, -20), grey(7))]),
            Call::Solid(row(-49, -20, 29), Gray8::WHITE),
            Call::Contiguous(row(10, 3, 2), vec![grey(9), Gray8::WHITE]),
            Call::Solid(row(0, 4, 5), grey(100)),
            Call::Contiguous(row(-2, 5, 325), long.into_iter().map(grey).collect()),
        ]
    );
}

#[test]
fn wholly_covered_pixels_are_the_colour_itself_and_never_read() {
    let shape = Pieces(vec![Piece::Span(0, -3, 90, 255), Piece::Span(1, 5, 6, 255)]);
    let expected = [Call::Solid(row(-3, 0, 93), Rgb565::CYAN), Call::Solid(row(5, 1, 1), Rgb565::CYAN)];
    let mut unread = Readable { recorder: Recorder::new(SCREEN), shows: None };
    shape.clone().antialiased(Rgb565::CYAN, ReadBack).draw_on(&mut unread).unwrap();
    shape.clone().antialiased(Rgb565::CYAN, Linear(ReadBack)).draw_on(&mut unread).unwrap();
    shape.antialiased(Rgb565::CYAN, Dither).draw_on(&mut unread).unwrap();
    assert_eq!(unread.recorder.calls, [expected.clone(), expected.clone(), expected].concat());
}

#[test]
fn opacity_scales_coverage_to_the_nearest_255th() {
    let coverage: Vec<u8> = (1..=255).collect();
    for opacity in 0..=255 {
        // White over black has the alpha itself for its luma.
        let shape =
            Pieces(vec![Piece::Run(0, 0, coverage.clone()), Piece::Span(1, 0, 3, 255), Piece::Span(2, 0, 2, 77)]);
        let mut display = Recorder::new(SCREEN);
        shape.antialiased(Gray8::WHITE, Over(Gray8::BLACK)).opacity(opacity).draw(&mut display).unwrap();
        if opacity == 0 {
            assert_eq!(display.calls, []);
            continue;
        }
        let expected = |coverage: u8| (f64::from(coverage) * f64::from(opacity) / 255.0).round() as u8;
        // Runs that are longer than those of the crate's own shapes are let through in pieces.
        let [runs @ .., Call::Solid(_, whole), Call::Solid(_, part)] = &display.calls[..] else {
            panic!("{:?}", display.calls);
        };
        assert_eq!(runs.len(), if opacity == 255 { 1 } else { coverage.len().div_ceil(32) });
        let drawn: Vec<_> = runs
            .iter()
            .flat_map(|call| match call {
                Call::Contiguous(_, run) => run.clone(),
                other => panic!("{other:?}"),
            })
            .collect();
        assert_eq!(drawn.len(), coverage.len());
        for (coverage, drawn) in coverage.iter().zip(drawn) {
            assert_eq!(drawn.luma(), expected(*coverage), "{coverage} by {opacity}");
        }
        assert_eq!([whole.luma(), part.luma()], [opacity, expected(77)]);
    }
}

/// Draws shapes of every kind in windows of every kind: nothing may come outside, and a failure ends the drawing.
fn check_kept_inside<B: Blend<Readable<Rgb565>> + Sync>(seed: u64, blend: B) {
    let drawn = for_each_case(seed, cases(3_000), |rng| {
        let (triangle, window) = random::triangle(rng);
        let mut drawn = check_within(&triangle, &window, blend);
        let (line, window) = random::line(rng);
        drawn += check_within(&line, &window, blend);
        let (circle, window) = random::circle(rng);
        drawn += check_within(&circle, &window, blend);
        Ok(drawn)
    });
    assert!(drawn > cases(3_000), "{drawn} calls: the windows see next to nothing");
}

fn check_within<B: Blend<Readable<Rgb565>>>(shape: &(impl Cover + Clone), window: &PixelRect, blend: B) -> u64 {
    // The recorder panics on whatever lies outside.
    let target = Readable { recorder: Recorder::new(window.clone().into()), shows: Some(Rgb565::BLUE) };
    let drawable = shape.clone().antialiased(Rgb565::RED, blend).opacity(200);
    let mut whole = target.clone();
    drawable.draw_on(&mut whole).unwrap();
    let calls = whole.recorder.calls.len();
    if calls > 0 {
        let mut failing = target;
        failing.recorder.fails_at = calls / 2;
        assert_eq!(drawable.draw_on(&mut failing), Err(calls / 2));
        assert_eq!(failing.recorder.calls, whole.recorder.calls[..calls / 2], "drawn on after the error");
    }
    calls as u64
}

#[test]
fn nothing_is_sent_outside_and_errors_end_the_drawing() {
    check_kept_inside(110, Over(Rgb565::GREEN));
    check_kept_inside(111, ReadBack);
    check_kept_inside(112, Dither);
    check_kept_inside(113, Linear(Over(Rgb565::GREEN)));
    check_kept_inside(114, Linear(ReadBack));
}

#[test]
fn pixels_that_cannot_be_read_stay() {
    /// Every second column is missing.
    struct Sieve(Recorder<Gray8>);

    impl Dimensions for Sieve {
        fn bounding_box(&self) -> Rectangle {
            self.0.bounds
        }
    }

    impl DrawTarget for Sieve {
        type Color = Gray8;
        type Error = usize;

        fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, pixels: I) -> Result<(), usize> {
            self.0.draw_iter(pixels)
        }
    }

    impl GetPixel for Sieve {
        type Color = Gray8;

        fn pixel(&self, point: Point) -> Option<Gray8> {
            (point.x % 2 == 0).then_some(Gray8::BLACK)
        }
    }

    let mut sieve = Sieve(Recorder::new(SCREEN));
    let shape = Pieces(vec![Piece::Run(2, 3, vec![10, 20, 30, 40]), Piece::Span(3, 1, 4, 50)]);
    shape.antialiased(Gray8::WHITE, ReadBack).draw_on(&mut sieve).unwrap();
    let expected = [(4, 2, 20), (6, 2, 40), (2, 3, 50)].map(|(x, y, luma)| (Point::new(x, y), Gray8::new(luma)));
    assert_eq!(sieve.0.pixels(), expected);
}

// --- Dithering -------------------------------------------------------------------------------------------------------

/// Bayer's matrix by its blocks: four copies of the one before, spread.
fn bayer(side: usize) -> Vec<Vec<u32>> {
    if side == 1 {
        return vec![vec![0]];
    }
    let half = bayer(side / 2);
    let spread = [[0, 2], [3, 1]];
    let number = |x: usize, y: usize| 4 * half[y % (side / 2)][x % (side / 2)] + spread[y / (side / 2)][x / (side / 2)];
    (0..side).map(|y| (0..side).map(|x| number(x, y)).collect()).collect()
}

/// Whether a pixel is drawn, from the sentence in the documentation.
fn dithered(matrix: &[Vec<u32>], point: Point, alpha: u8) -> bool {
    let number = matrix[point.y.rem_euclid(8) as usize][point.x.rem_euclid(8) as usize];
    f64::from(alpha) / 255.0 > (f64::from(number) + 0.5) / 64.0
}

#[test]
fn of_each_tile_as_many_pixels_are_drawn_as_alpha_says() {
    let matrix = bayer(8);
    assert_eq!(matrix[0], [0, 32, 8, 40, 2, 34, 10, 42]);
    for (left, top) in [(0, 0), (-8, -16), (32, -8), (-40, 16)] {
        let mut before = Vec::new();
        for alpha in 0..=255 {
            let tile = (top..top + 8).map(|row| Piece::Span(row, left, left + 8, 255)).collect();
            let mut display = Recorder::new(SCREEN);
            Pieces(tile).antialiased(BinaryColor::On, Dither).opacity(alpha).draw(&mut display).unwrap();
            let drawn: Vec<_> = display.pixels().into_iter().map(|(point, _)| point).collect();
            assert_eq!(drawn.len(), (64.0 * f64::from(alpha) / 255.0).round() as usize, "alpha {alpha}");
            assert!(drawn.iter().all(|point| dithered(&matrix, *point, alpha)));
            assert!(before.iter().all(|point| drawn.contains(point)), "alpha {alpha} loses a pixel");
            before = drawn;
        }
        assert_eq!(before.len(), 64);
    }
}

#[test]
fn dithered_runs_come_in_pieces_of_one_rectangle() {
    let matrix = bayer(8);
    for_each_case(120, cases(20_000), |rng| {
        let alphas: Vec<u8> = (0..rng.int(1..=40)).map(|_| rng.int(0..=511).clamp(1, 255) as u8).collect();
        let start = Point::new(rng.int(-50..=300) as i32, rng.int(-20..=39) as i32);
        let mut display = Recorder::new(SCREEN);
        let run = Piece::Run(start.y, start.x, alphas.clone());
        Pieces(vec![run]).antialiased(Gray2::WHITE, Dither).draw(&mut display).unwrap();
        let drawn: Vec<Point> = (start.x..)
            .map(|x| Point::new(x, start.y))
            .zip(alphas)
            .filter_map(|(point, alpha)| dithered(&matrix, point, alpha).then_some(point))
            .collect();
        assert_eq!(display.pixels(), drawn.iter().map(|point| (*point, Gray2::WHITE)).collect::<Vec<_>>());
        let pieces = drawn.chunk_by(|a, b| a.x + 1 == b.x).count();
        assert_eq!(display.calls.len(), pieces, "{:?}", display.calls);
        Ok(0)
    });
}

#[test]
fn a_dithered_ramp_looks_like_this() {
    let ramp = |row: i32| Piece::Run(row, 0, (1..=32).map(|column| (255 * column / 32) as u8).collect());
    let mut display = MockDisplay::new();
    Pieces((0..8).map(ramp).collect()).antialiased(BinaryColor::On, Dither).draw(&mut display).unwrap();
    display.assert_pattern(&[
        "#   # # # # # # ### ############",
        "         #   # # # # # ### #####",
        "  #   # # # # # # ### ##########",
        "           #   # # # # # ### ###",
        "    # # # # # # ### ############",
        "         #   # # # # # # # #####",
        "      # # # # # # ### ##########",
        "           #   # # # # # # # ###",
    ]);
}

// --- Every colour, every target --------------------------------------------------------------------------------------

const WIDTH: usize = 24;
const HEIGHT: usize = 20;

/// On a target filled with a colour, mixing with that colour and with what is read is the same; so is what a write-only
/// display is sent.
macro_rules! check_colour {
    ($($colour:ident $top:expr, $bottom:expr;)+) => {
        $({
            type Frame = Framebuffer<
                $colour,
                <$colour as PixelColor>::Raw,
                LittleEndian,
                WIDTH,
                HEIGHT,
                { buffer_size::<$colour>(WIDTH, HEIGHT) },
            >;
            let (top, bottom): ($colour, $colour) = ($top, $bottom);
            let bounds = Frame::new().bounding_box();
            // It leaves the frame on the right and below.
            let disc = Circle::new(Point::new(15, 12), 9.3);
            for opacity in [255, 128, 1] {
                let filled = || {
                    let mut frame = Frame::new();
                    let Ok(()) = frame.clear(bottom);
                    frame
                };
                let sent = |pixels: &[(Point, $colour)]| {
                    let mut frame = filled();
                    let Ok(()) = frame.draw_iter(pixels.iter().map(|(point, colour)| Pixel(*point, *colour)));
                    frame
                };
                let (mut over, mut read, mut display) = (filled(), filled(), Recorder::new(bounds));
                let Ok(()) = disc.antialiased(top, Over(bottom)).opacity(opacity).draw(&mut over);
                let Ok(()) = disc.antialiased(top, ReadBack).opacity(opacity).draw_on(&mut read);
                disc.antialiased(top, Over(bottom)).opacity(opacity).draw(&mut display).unwrap();
                assert!(over == read, "{}: ReadBack differs from Over", stringify!($colour));
                assert!(over == sent(&display.pixels()), "{}: a display differs", stringify!($colour));
                // The middle is the mix by the opacity itself.
                assert_eq!(read.pixel(Point::new(15, 12)), Some(top.over(bottom, opacity)));
                assert_eq!(read.pixel(Point::new(1, 1)), Some(bottom));

                let (mut over, mut read, mut display) = (filled(), filled(), Recorder::new(bounds));
                let Ok(()) = disc.antialiased(top, Linear(Over(bottom))).opacity(opacity).draw(&mut over);
                let Ok(()) = disc.antialiased(top, Linear(ReadBack)).opacity(opacity).draw_on(&mut read);
                disc.antialiased(top, Linear(Over(bottom))).opacity(opacity).draw(&mut display).unwrap();
                assert!(over == read, "{}: linear ReadBack differs from Over", stringify!($colour));
                assert!(over == sent(&display.pixels()), "{}: a display differs in linear light", stringify!($colour));
                assert_eq!(read.pixel(Point::new(15, 12)), Some(top.over_linear(bottom, opacity)));

                let (mut frame, mut display) = (filled(), Recorder::new(bounds));
                let Ok(()) = disc.antialiased(top, Dither).opacity(opacity).draw(&mut frame);
                disc.antialiased(top, Dither).opacity(opacity).draw(&mut display).unwrap();
                assert!(frame == sent(&display.pixels()), "{}: a dithered display differs", stringify!($colour));
                assert!(display.pixels().iter().all(|(_, colour)| *colour == top));

                // In full colour on top, nothing of it is left.
                let Ok(()) = disc.antialiased(top, ReadBack).draw_on(&mut frame);
                assert_eq!(frame.pixel(Point::new(15, 12)), Some(top));
            }
        })+
    };
}

#[test]
fn every_colour_is_drawn_alike_on_displays_and_framebuffers() {
    check_colour! {
        Rgb555 Rgb555::new(31, 3, 17), Rgb555::new(2, 30, 9);
        Bgr555 Bgr555::new(31, 3, 17), Bgr555::new(2, 30, 9);
        Rgb565 Rgb565::new(31, 3, 17), Rgb565::new(2, 60, 9);
        Bgr565 Bgr565::new(31, 3, 17), Bgr565::new(2, 60, 9);
        Rgb666 Rgb666::new(61, 3, 17), Rgb666::new(2, 60, 9);
        Bgr666 Bgr666::new(61, 3, 17), Bgr666::new(2, 60, 9);
        Rgb888 Rgb888::new(251, 3, 17), Rgb888::new(2, 240, 99);
        Bgr888 Bgr888::new(251, 3, 17), Bgr888::new(2, 240, 99);
        Gray2 Gray2::new(3), Gray2::new(1);
        Gray4 Gray4::new(2), Gray4::new(13);
        Gray8 Gray8::new(201), Gray8::new(7);
        BinaryColor BinaryColor::On, BinaryColor::Off;
    }
}
