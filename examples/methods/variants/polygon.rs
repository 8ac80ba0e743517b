//! The variants of `polygon`.

use core::convert::Infallible;

use spanfill::{
    ActiveEdge, FillRule, FillSegment, Fragment, FragmentSink, PixelRect, Polygon, Shape, Span, SpanSink, Vertex,
    methods::polygon::{
        Contours, Failure, Plane,
        ear::{self, Corner},
        fan::{self, Ties},
        scan_line::{self, Closed, Crossing, Edge, Exact, Fixed, Float},
        seed::{self, Canvas, Entry, Marker, Return, Touch},
    },
};

use super::{HEIGHT, Outcome, WIDTH};

/// Closed contours of vertices in 1/256 pixel, and the rule for what is inside.
#[derive(Debug, Clone, Copy)]
pub struct Outline {
    pub contours: &'static [&'static [[i32; 2]]],
    /// Else non-zero.
    pub even_odd: bool,
}

impl Outline {
    fn rule(&self) -> FillRule {
        if self.even_odd { FillRule::EvenOdd } else { FillRule::NonZero }
    }

    fn len(&self) -> usize {
        self.contours.iter().map(|contour| contour.len()).sum()
    }

    /// The pixels that hold the vertices, and one more to all sides, in a clip.
    fn bounds(&self, clip: &PixelRect) -> PixelRect {
        let range = |axis: usize, clip: &core::ops::Range<i32>| {
            let pixels = || self.contours.iter().flat_map(|contour| contour.iter()).map(|vertex| vertex[axis] >> 8);
            let (low, high) = (pixels().min().unwrap_or(0), pixels().max().unwrap_or(-2));
            (low - 1).max(clip.start)..(high + 2).min(clip.end)
        };
        PixelRect { rows: range(1, &clip.rows), columns: range(0, &clip.columns) }
    }
}

/// An outline in the numbers of a method.
struct Converted<'o, N> {
    outline: &'o Outline,
    convert: fn(i32) -> N,
}

impl<N: Copy> Contours<N> for Converted<'_, N> {
    fn contours(&self) -> usize {
        self.outline.contours.len()
    }

    fn vertices(&self, contour: usize) -> usize {
        self.outline.contours[contour].len()
    }

    fn vertex(&self, contour: usize, index: usize) -> Option<[N; 2]> {
        Some(self.outline.contours[contour].get(index)?.map(self.convert))
    }
}

/// To pixels.
fn to_float(subpixels: i32) -> f32 {
    subpixels as f32 / 256.0
}

/// To the centre of the pixel, in pixels.
fn to_pixel_centre(subpixels: i32) -> f32 {
    (subpixels >> 8) as f32 + 0.5
}

/// To F bits behind the binary point, rounded to the nearest; more than there is room for wraps.
fn to_fixed<const F: u32>(subpixels: i32) -> i32 {
    if F >= 8 { subpixels.wrapping_shl(F - 8) } else { subpixels.saturating_add(1 << (7 - F)) >> (8 - F) }
}

/// Lends slots from the stack, about as many as asked for: what is not used is not cleared either.
fn with_slots<T: Copy, R>(wanted: usize, empty: T, use_slots: impl FnOnce(&mut [T]) -> R) -> R {
    match wanted {
        0..=64 => lend::<64, T, R>(empty, use_slots),
        65..=1024 => lend::<1024, T, R>(empty, use_slots),
        1025..=8192 => lend::<8192, T, R>(empty, use_slots),
        _ => lend::<MOST_SLOTS, T, R>(empty, use_slots),
    }
}

/// What any method gets at most.
const MOST_SLOTS: usize = 16384;

#[inline(never)]
fn lend<const N: usize, T: Copy, R>(empty: T, use_slots: impl FnOnce(&mut [T]) -> R) -> R {
    use_slots(&mut [empty; N])
}

fn outcome(result: Result<(), Failure<Infallible>>) -> Outcome {
    match result {
        Ok(()) => Ok(()),
        Err(Failure::TooLittleScratch { .. }) => Err("more scratch than there is"),
    }
}

fn scan_line<X: Crossing>(
    outline: &Outline,
    convert: fn(i32) -> X::Number,
    clip: &PixelRect,
    sink: &mut impl FragmentSink<Error = Infallible>,
) -> Outcome {
    let contours = Converted { outline, convert };
    outcome(with_slots(outline.len(), Edge::<X>::EMPTY, |slots| {
        scan_line::fill(&contours, outline.rule(), clip, slots, sink)
    }))
}

fn fan(outline: &Outline, ties: Ties, clip: &PixelRect, sink: &mut impl FragmentSink<Error = Infallible>) -> Outcome {
    let Ok(()) = fan::fill(outline.contours, ties, clip, sink);
    Ok(())
}

fn ears<T: Plane>(
    outline: &Outline,
    convert: fn(i32) -> T,
    clip: &PixelRect,
    sink: &mut impl FragmentSink<Error = Infallible>,
) -> Outcome {
    let contours = Converted { outline, convert };
    let mut wanted = outline.len() + 2 * outline.contours.len();
    // Once with what a simple polygon needs, then with what was asked for.
    loop {
        let result =
            with_slots(wanted, Corner::<T>::EMPTY, |slots| ear::fill(&contours, outline.rule(), clip, slots, sink));
        match result {
            Err(Failure::TooLittleScratch { needed, available }) if available < MOST_SLOTS && needed <= MOST_SLOTS => {
                wanted = needed;
            }
            result => return outcome(result),
        }
    }
}

const SCREEN_WORDS: usize = (WIDTH / 32 * HEIGHT) as usize;

/// Draws an outline on a canvas, its clip not wider than the screen, and fills from a seed.
fn fill_from_seed<S: FragmentSink<Error = Infallible>>(
    outline: &Outline,
    against: Touch,
    clip: &PixelRect,
    sink: &mut S,
    fill: impl FnOnce(&mut Canvas<'_>, [i32; 2], &mut S) -> Result<(), Failure<Infallible>>,
) -> Outcome {
    let mut words = [0; SCREEN_WORDS];
    outcome(Canvas::new(clip, &mut words).and_then(|mut canvas| {
        seed::draw(outline.contours, against, &mut canvas);
        match seed::seed(outline.contours, outline.rule(), clip) {
            Some(seed) => fill(&mut canvas, seed, sink),
            None => canvas.send(sink).map_err(Failure::Sink),
        }
    }))
}

/// Smith's recursion by sides or corners.
fn by_pixels<S: FragmentSink<Error = Infallible>>(
    outline: &Outline,
    (against, touch): (Touch, Touch),
    clip: &PixelRect,
    sink: &mut S,
) -> Outcome {
    fill_from_seed(outline, against, clip, sink, |canvas, seed, sink| {
        let pixels = clip.rows.len() * clip.columns.len();
        let mut fill = |stack: &mut [Return]| seed::by_pixels(canvas, seed, touch, stack, sink);
        if pixels <= MOST_SLOTS {
            with_slots(pixels, Return::default(), fill)
        } else {
            lend::<{ (WIDTH * HEIGHT) as usize }, _, _>(Return::default(), &mut fill)
        }
    })
}

/// A fill with a stack of unknown size.
fn by_spans<S: FragmentSink<Error = Infallible>>(
    outline: &Outline,
    against: Touch,
    clip: &PixelRect,
    sink: &mut S,
    fill: impl Fn(&mut Canvas<'_>, [i32; 2], &mut [Entry], &mut S) -> Result<(), Failure<Infallible>>,
) -> Outcome {
    fill_from_seed(outline, against, clip, sink, |canvas, seed, sink| {
        let few = lend::<1024, _, _>(Entry::EMPTY, |stack| fill(canvas, seed, stack, sink));
        match few {
            Err(Failure::TooLittleScratch { needed, .. }) => {
                with_slots(needed, Entry::EMPTY, |stack| fill(canvas, seed, stack, sink))
            }
            result => result,
        }
    })
}

fn with_rescan<const ENTRIES: usize>(
    outline: &Outline,
    clip: &PixelRect,
    sink: &mut impl FragmentSink<Error = Infallible>,
) -> Outcome {
    fill_from_seed(outline, Touch::Sides, clip, sink, |canvas, seed, sink| {
        let mut words = [0; SCREEN_WORDS];
        let mut marked = Canvas::new(clip, &mut words)?;
        let (marker, mut stack) = (Marker::Colour(&mut marked), [Entry::EMPTY; ENTRIES]);
        seed::by_spans_with_rescan(canvas, seed, marker, &mut stack, sink).map_err(Failure::Sink)
    })
}

fn with_walk<const ENTRIES: usize>(
    outline: &Outline,
    clip: &PixelRect,
    sink: &mut impl FragmentSink<Error = Infallible>,
) -> Outcome {
    fill_from_seed(outline, Touch::Sides, clip, sink, |canvas, seed, sink| {
        let mut stack = [FillSegment::EMPTY; ENTRIES];
        seed::by_spans_with_walk(canvas, seed, Touch::Sides, &mut stack, sink).map_err(Failure::Sink)
    })
}

/// The crate's own.
fn shipped(outline: &Outline, clip: &PixelRect, sink: &mut impl FragmentSink<Error = Infallible>) -> Outcome {
    let most = "more scratch than there is";
    with_slots(outline.len(), Vertex::default(), |vertices| {
        let points = outline.contours.iter().flat_map(|contour| contour.iter());
        vertices.iter_mut().zip(points).for_each(|(vertex, [x, y])| *vertex = Vertex::from_bits(*x, *y));
        let mut rest = vertices.get(..outline.len()).ok_or(most)?;
        with_slots(outline.contours.len(), rest, |contours| {
            for (contour, points) in contours.iter_mut().zip(outline.contours) {
                (*contour, rest) = rest.split_at(points.len());
            }
            let contours = contours.get(..outline.contours.len()).ok_or(most)?;
            let polygon = Polygon::with_contours(contours).fill_rule(outline.rule());
            with_slots(polygon.active_edges_at_most(), ActiveEdge::EMPTY, |slots| {
                let Ok(()) = polygon.in_scratch(slots).map_err(|_| most)?.spans(clip, &mut Pixels(sink));
                Ok(())
            })
        })
    })
}

/// Spans to fragments.
struct Pixels<'s, S>(&'s mut S);

impl<S: FragmentSink> SpanSink for Pixels<'_, S> {
    type Error = S::Error;

    fn span(&mut self, span: Span) -> Result<(), S::Error> {
        for x in span.columns {
            self.0.visit(x, span.row);
            self.0.fragment(Fragment::pixel(x, span.row))?;
        }
        Ok(())
    }
}

const SIDES: (Touch, Touch) = (Touch::Sides, Touch::Sides);
const CORNERS: (Touch, Touch) = (Touch::Corners, Touch::Corners);
/// The outline has gaps for the fill.
const LEAKY: (Touch, Touch) = (Touch::Sides, Touch::Corners);

crate::variants! { POLYGONS: Outline;
    "polygon", "scan line", "f32" => |outline, clip, sink| scan_line::<Float>(outline, to_float, clip, sink);
    "polygon", "scan line", "fixed 4" => |outline, clip, sink| scan_line::<Fixed<4>>(outline, to_fixed::<4>, clip, sink);
    "polygon", "scan line", "fixed 8" => |outline, clip, sink| scan_line::<Fixed<8>>(outline, to_fixed::<8>, clip, sink);
    "polygon", "scan line", "fixed 12" => |outline, clip, sink| scan_line::<Fixed<12>>(outline, to_fixed::<12>, clip, sink);
    "polygon", "scan line", "fixed 16" => |outline, clip, sink| scan_line::<Fixed<16>>(outline, to_fixed::<16>, clip, sink);
    "polygon", "scan line", "exact" => |outline, clip, sink| scan_line::<Exact>(outline, |x| x, clip, sink);
    "polygon", "scan line", "whole pixels" => |outline, clip, sink| scan_line::<Float>(outline, to_pixel_centre, clip, sink);
    "polygon", "scan line", "whole pixels, Ymax kept" => |outline, clip, sink| {
        scan_line::<Closed>(outline, to_pixel_centre, clip, sink)
    };
    "polygon", "convex fan", "top-left rule" => |outline, clip, sink| fan(outline, Ties::TopLeft, clip, sink);
    "polygon", "convex fan", "no tie rule" => |outline, clip, sink| fan(outline, Ties::Both, clip, sink);
    "polygon", "ear clipping", "f32" => |outline, clip, sink| ears(outline, to_float, clip, sink);
    "polygon", "ear clipping", "fixed" => |outline, clip, sink| ears(outline, |x| x, clip, sink);
    "polygon", "seed fill by pixels", "4-connected" => |outline, clip, sink| {
        by_pixels(outline, SIDES, &outline.bounds(clip), sink)
    };
    "polygon", "seed fill by pixels", "8-connected" => |outline, clip, sink| {
        by_pixels(outline, CORNERS, &outline.bounds(clip), sink)
    };
    "polygon", "seed fill by pixels", "8-connected, thin outline" => |outline, clip, sink| {
        by_pixels(outline, LEAKY, clip, sink)
    };
    "polygon", "seed fill by spans", "Smith" => |outline, clip, sink| {
        by_spans(outline, Touch::Sides, &outline.bounds(clip), sink, seed::by_seeds)
    };
    "polygon", "seed fill by spans", "Heckbert" => |outline, clip, sink| {
        by_spans(outline, Touch::Sides, &outline.bounds(clip), sink, |canvas, seed, stack, sink| {
            seed::by_spans(canvas, seed, Touch::Sides, stack, sink)
        })
    };
    "polygon", "seed fill by spans", "Heckbert, 8-connected" => |outline, clip, sink| {
        by_spans(outline, Touch::Corners, &outline.bounds(clip), sink, |canvas, seed, stack, sink| {
            seed::by_spans(canvas, seed, Touch::Corners, stack, sink)
        })
    };
    "polygon", "seed fill with rescan", "1 entry" => |outline, clip, sink| {
        with_rescan::<1>(outline, &outline.bounds(clip), sink)
    };
    "polygon", "seed fill with rescan", "4 entries" => |outline, clip, sink| {
        with_rescan::<4>(outline, &outline.bounds(clip), sink)
    };
    "polygon", "seed fill with rescan", "16 entries" => |outline, clip, sink| {
        with_rescan::<16>(outline, &outline.bounds(clip), sink)
    };
    "polygon", "seed fill with rescan", "1 entry, no marker" => |outline, clip, sink| {
        fill_from_seed(outline, Touch::Sides, &outline.bounds(clip), sink, |canvas, seed, sink| {
            let mut stack = [Entry::EMPTY; 1];
            seed::by_spans_with_rescan(canvas, seed, Marker::Nothing, &mut stack, sink).map_err(Failure::Sink)
        })
    };
    "polygon", "seed fill with walk", "no entry" => |outline, clip, sink| {
        with_walk::<0>(outline, &outline.bounds(clip), sink)
    };
    "polygon", "seed fill with walk", "1 entry" => |outline, clip, sink| {
        with_walk::<1>(outline, &outline.bounds(clip), sink)
    };
    "polygon", "seed fill with walk", "16 entries" => |outline, clip, sink| {
        with_walk::<16>(outline, &outline.bounds(clip), sink)
    };
    "polygon", "spanfill", "" => |outline, clip, sink| shipped(outline, clip, sink);
}
