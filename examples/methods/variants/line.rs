//! Lines between whole pixels, `[[x1, y1], [x2, y2]]`.

use core::convert::Infallible;

use spanfill::{
    Cover, CoverageSink, Fragment, FragmentSink, Line, PixelRect, Shape, Span, SpanSink, Vertex,
    methods::line::{
        bresenham::{self, East},
        by_transformation,
        dda::{self, Conversion},
        directly::{self, Ties},
        gupta_sproull::{self, Root},
        slope_intercept::{self, Last, Rounding},
        wu::{self, Ends},
    },
};

use crate::variants;
use crate::variants::Outcome;

/// What the crate's own shapes send, as fragments.
pub struct Fragments<'s, S>(pub &'s mut S);

impl<S: FragmentSink> SpanSink for Fragments<'_, S> {
    type Error = S::Error;

    #[inline(always)]
    fn span(&mut self, span: Span) -> Result<(), S::Error> {
        span.columns.into_iter().try_for_each(|x| self.0.fragment(Fragment::pixel(x, span.row)))
    }
}

impl<S: FragmentSink> CoverageSink for Fragments<'_, S> {
    type Error = S::Error;

    #[inline(always)]
    fn span(&mut self, span: Span, coverage: u8) -> Result<(), S::Error> {
        span.columns.into_iter().try_for_each(|x| self.0.fragment(Fragment::covered(x, span.row, coverage)))
    }

    #[inline(always)]
    fn run(&mut self, row: i32, column: i32, coverage: &[u8]) -> Result<(), S::Error> {
        let pixels = (column..).zip(coverage);
        pixels.into_iter().try_for_each(|(x, coverage)| self.0.fragment(Fragment::covered(x, row, *coverage)))
    }
}

/// What cannot fail has not failed.
pub fn drawn(result: Result<(), Infallible>) -> Outcome {
    result.map_err(|never| match never {})
}

/// The crate's line between the centres of two pixels.
pub fn shipped([start, end]: [[i32; 2]; 2]) -> Line {
    Line::new(Vertex::pixel(start[0], start[1]), Vertex::pixel(end[0], end[1]))
}

fn everywhere<S: FragmentSink<Error = Infallible>>(
    line: [[i32; 2]; 2],
    rounding: Rounding,
    clip: &PixelRect,
    sink: &mut S,
) -> Outcome {
    drawn(by_transformation::line(line, clip, sink, |line, clip, sink| {
        slope_intercept::line(line, rounding, Last::Drawn, clip, sink)
    }))
}

fn transformed<S: FragmentSink<Error = Infallible>>(
    line: [[i32; 2]; 2],
    east: East,
    clip: &PixelRect,
    sink: &mut S,
) -> Outcome {
    drawn(by_transformation::line(line, clip, sink, |line, clip, sink| bresenham::line(line, east, clip, sink)))
}

fn wu<S: FragmentSink<Error = Infallible>>(line: [[i32; 2]; 2], from: Ends, clip: &PixelRect, sink: &mut S) -> Outcome {
    drawn(by_transformation::line(line, clip, sink, |line, clip, sink| wu::line(line, from, clip, sink)))
}

fn gupta_sproull<S: FragmentSink<Error = Infallible>>(
    line: [[i32; 2]; 2],
    root: Root,
    clip: &PixelRect,
    sink: &mut S,
) -> Outcome {
    drawn(by_transformation::line(line, clip, sink, |line, clip, sink| gupta_sproull::line(line, root, clip, sink)))
}

variants! {
    LINES: [[i32; 2]; 2];
    "line", "y = mx + b", "floor, xi < dx" => |line, clip, sink|
        drawn(slope_intercept::line(*line, Rounding::Floor, Last::Dropped, clip, sink));
    "line", "y = mx + b", "floor, xi <= dx" => |line, clip, sink|
        drawn(slope_intercept::line(*line, Rounding::Floor, Last::Drawn, clip, sink));
    "line", "y = mx + b", "nearest, xi < dx" => |line, clip, sink|
        drawn(slope_intercept::line(*line, Rounding::Nearest, Last::Dropped, clip, sink));
    "line", "y = mx + b", "nearest, xi <= dx" => |line, clip, sink|
        drawn(slope_intercept::line(*line, Rounding::Nearest, Last::Drawn, clip, sink));
    "line", "y = mx + b", "floor, all octants" => |line, clip, sink| everywhere(*line, Rounding::Floor, clip, sink);
    "line", "y = mx + b", "nearest, all octants" => |line, clip, sink| everywhere(*line, Rounding::Nearest, clip, sink);
    "line", "DDA", "as printed" => |line, clip, sink| drawn(dda::as_printed(*line, clip, sink));
    "line", "DDA", "truncated" => |line, clip, sink| drawn(dda::line(*line, Conversion::Truncated, clip, sink));
    "line", "DDA", "nearest" => |line, clip, sink| drawn(dda::line(*line, Conversion::Nearest, clip, sink));
    "line", "DDA", "16 fraction bits" => |line, clip, sink| drawn(dda::fixed(*line, clip, sink));
    "line", "Bresenham", "d <= 0" => |line, clip, sink| drawn(bresenham::line(*line, East::AtZero, clip, sink));
    "line", "Bresenham", "d < 0" => |line, clip, sink| drawn(bresenham::line(*line, East::BelowZero, clip, sink));
    "line", "Bresenham, by transformation", "d <= 0" => |line, clip, sink| transformed(*line, East::AtZero, clip, sink);
    "line", "Bresenham, by transformation", "d < 0" => |line, clip, sink| transformed(*line, East::BelowZero, clip, sink);
    "line", "Bresenham, directly", "d < 0" => |line, clip, sink|
        drawn(directly::line(*line, Ties::Diagonal, clip, sink));
    "line", "Bresenham, directly", "ties down and right" => |line, clip, sink|
        drawn(directly::line(*line, Ties::DownAndRight, clip, sink));
    "line", "Wu", "16 bits, from both ends" => |line, clip, sink| wu(*line, Ends::Both, clip, sink);
    "line", "Wu", "16 bits, from one end" => |line, clip, sink| wu(*line, Ends::Start, clip, sink);
    "line", "Wu", "f32, ends between pixels" => |line, clip, sink|
        drawn(wu::between_pixels(line.map(|end| end.map(|at| at as f32)), clip, sink));
    "line", "Gupta-Sproull", "libm's root" => |line, clip, sink| gupta_sproull(*line, Root::Libm, clip, sink);
    "line", "Gupta-Sproull", "micromath's root" => |line, clip, sink| gupta_sproull(*line, Root::Micromath, clip, sink);
    "line", "spanfill", "exact coverage" => |line, clip, sink| drawn(shipped(*line).coverage(clip, &mut Fragments(sink)));
    "line", "spanfill", "" => |line, clip, sink| drawn(shipped(*line).spans(clip, &mut Fragments(sink)));
}
