//! A stroke as contours, one for each line or curve, with the corner that follows it.
//!
//! `n` is the normal, the direction turned clockwise; the contour goes forward along `+n` and back along `-n`:
//!
//! ```text
//!      a-n ---------------------- b-n
//!       |                          |              y grows downwards, so the path turns clockwise here: the
//!       a  ------ direction -----> b              corner opens on the side of -n, and closes with
//!       |                          |              b, b - n', join, b - n
//!      a+n ---------------------- b+n
//! ```
//!
//! A curve is one contour, too: the sum of the rectangles on its chords and of the sectors between them, whose common
//! edges cancel. What remains of them on the inner side of a turn is a spike from `-n` to the vertex and back to
//! `-n'`, and where neighbours are longer than they overlap, not even that: the triangle that is lost lies within
//! both. Where the curve is tighter than the stroke, the spikes make it reach to the evolute.

use crate::{
    outline::{Curve, CurveSink, FinePoint, OutlineSink, Vector},
    stroke::{
        Cap, Join, StrokeStyle,
        fan::fan,
        normal::{UNIT_BITS, Unit},
    },
};

/// A line, or a part of a curve, with its normals at both ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Run {
    pub(super) from: FinePoint,
    pub(super) to: FinePoint,
    pub(super) normals: [Unit; 2],
    /// The curve, and its vertices between the ends: after so many chords to after so many, or fewer.
    pub(super) curve: Option<(Curve, u32, u32)>,
}

impl Run {
    /// A line; none where it has no length.
    pub(super) fn line(from: FinePoint, to: FinePoint) -> Option<Self> {
        let normal = Unit::along(Vector::between(from, to))?.turned();
        Some(Self { from, to, normals: [normal, normal], curve: None })
    }

    /// A curve; none where it has no length.
    pub(super) fn curve(curve: &Curve) -> Option<Self> {
        let start = Unit::along(curve.start_direction()?)?.turned();
        let end = Unit::along(curve.reversed().start_direction()?)?.turned_back();
        Some(Self {
            from: curve.from(),
            to: curve.to(),
            normals: [start, end],
            curve: Some((*curve, 1, curve.chords().saturating_sub(1))),
        })
    }

    /// The same backwards.
    fn reversed(&self) -> Self {
        let Self { from, to, normals: [start, end], curve } = *self;
        let curve = curve.map(|(curve, first, last)| {
            let chords = curve.chords();
            (curve.reversed(), chords.saturating_sub(last), chords.saturating_sub(first))
        });
        Self { from: to, to: from, normals: [end.opposite(), start.opposite()], curve }
    }
}

/// Makes contours of the stroke's parts.
#[derive(Debug)]
pub(super) struct Pieces<'s, S> {
    sink: &'s mut S,
    radius: i64,
    cap: Cap,
    join: Join,
    at: FinePoint,
    /// Where the subpath starts, and with which normal.
    first: Option<(FinePoint, Unit)>,
    /// The last one, whose corner is not known yet.
    pending: Option<Run>,
}

impl<'s, S: OutlineSink> Pieces<'s, S> {
    pub(super) fn new(sink: &'s mut S, style: &StrokeStyle<'_>) -> Self {
        let (cap, join, radius) = (style.cap, style.join, style.radius());
        Self { sink, radius, cap, join, at: FinePoint::default(), first: None, pending: None }
    }

    /// A part starts here, cut off from what was before.
    pub(super) fn begin(&mut self, at: FinePoint) {
        self.at = at;
        self.first = None;
        self.pending = None;
    }

    /// The part goes on.
    pub(super) fn push(&mut self, run: Run) {
        self.at = run.to;
        let [normal, _] = run.normals;
        match self.pending.replace(run) {
            Some(before) => self.emit(&before, Some(normal)),
            None => self.first = Some((run.from, normal)),
        }
    }

    /// The part ends, with a cap at either end.
    pub(super) fn finish(&mut self) {
        if let (Some(last), Some((start, normal))) = (self.pending.take(), self.first.take()) {
            self.emit(&last, None);
            self.cap(start, normal.opposite());
        }
    }

    /// The part ends where it started.
    pub(super) fn join_up(&mut self) {
        if let (Some(last), Some((_, normal))) = (self.pending.take(), self.first.take()) {
            self.emit(&last, Some(normal));
        }
    }

    /// A part of no length, with its normal.
    pub(super) fn dot(&mut self, at: FinePoint, normal: Unit) {
        if self.cap != Cap::Butt {
            self.cap(at, normal);
            self.cap(at, normal.opposite());
        }
    }

    fn point(&mut self, FinePoint { x, y }: FinePoint) {
        self.sink.point(x.into(), y.into());
    }

    fn offset(&mut self, at: FinePoint, normal: Unit) {
        self.point(normal.from(at, self.radius));
    }

    /// A contour of its own.
    fn cap(&mut self, at: FinePoint, normal: Unit) {
        if self.cap == Cap::Butt {
            return;
        }
        self.offset(at, normal);
        self.cap_points(at, normal);
        self.offset(at, normal.opposite());
        self.sink.close();
    }

    /// From `+n` to `-n` around an end.
    fn cap_points(&mut self, at: FinePoint, normal: Unit) {
        match self.cap {
            Cap::Butt => {}
            Cap::Round => fan(self.sink, at, self.radius, normal, normal.opposite()),
            Cap::Square => {
                let (across, ahead) = (normal.times(self.radius), normal.turned_back().times(self.radius));
                self.point(across.plus(ahead).from(at));
                self.point(ahead.minus(across).from(at));
            }
        }
    }

    /// The contour of a run, with the corner to what follows, or a cap.
    fn emit(&mut self, run: &Run, next: Option<Unit>) {
        self.side(run);
        let [_, normal] = run.normals;
        match next {
            None => self.cap_points(run.to, normal),
            Some(next) if next == normal => {}
            // Anticlockwise: the corner opens on this side.
            Some(next) if normal.cross(next) < 0 => {
                self.join_points(run.to, normal, next);
                self.offset(run.to, next);
                self.point(run.to);
            }
            Some(next) => {
                self.point(run.to);
                self.offset(run.to, next.opposite());
                self.join_points(run.to, next.opposite(), normal.opposite());
            }
        }
        self.side(&run.reversed());
        self.sink.close();
    }

    /// Between the sides of a corner, anticlockwise.
    fn join_points(&mut self, at: FinePoint, from: Unit, to: Unit) {
        match self.join {
            Join::Bevel => {}
            Join::Round => fan(self.sink, at, self.radius, from, to),
            Join::Miter { limit } => {
                let sum = from.0.plus(to.0);
                // |n + n'| is 2 cos(phi / 2), and the tip is 1 / cos(phi / 2) away: within the limit where
                // 4 <= limit^2 |n + n'|^2.
                let square = u128::from((sum.x * sum.x + sum.y * sum.y).unsigned_abs());
                let is_within =
                    square > 0 && 4 << (2 * UNIT_BITS + 16) <= u128::from(limit) * u128::from(limit) * square;
                // A limit of exactly 1 holds where there is no corner only.
                if is_within {
                    let part = |part: i64| {
                        let product = (i128::from(part) * i128::from(2 * self.radius)) << UNIT_BITS;
                        // At most the radius times the limit, or that of a root of a unit.
                        let tip = crate::outline::divide_half_even(product, square.cast_signed());
                        i64::try_from(tip).unwrap_or(if tip < 0 { i64::MIN / 4 } else { i64::MAX / 4 })
                    };
                    let tip = Vector::new(part(sum.x), part(sum.y));
                    self.point(tip.from(at));
                }
            }
        }
    }

    /// Forward along `+n`, from the first end to the last.
    fn side(&mut self, run: &Run) {
        let [start, end] = run.normals;
        self.offset(run.from, start);
        let mut side = Side { at: run.from, normal: start, length: END };
        if let Some((curve, first, last)) = run.curve {
            let count = usize::try_from((last + 1).saturating_sub(first)).unwrap_or(0);
            for point in curve.points_after(first.saturating_sub(1)).take(count) {
                self.chord(&mut side, point);
            }
            self.chord(&mut side, run.to);
            self.turn(&side, end, END);
        } else {
            self.offset(run.to, end);
        }
    }

    /// One chord further.
    fn chord(&mut self, side: &mut Side, to: FinePoint) {
        let vector = Vector::between(side.at, to);
        let Some(direction) = Unit::along(vector) else { return };
        let (normal, length) = (direction.turned(), vector.length_at_most());
        self.turn(side, normal, length);
        self.offset(to, normal);
        *side = Side { at: to, normal, length };
    }

    /// From one normal to the next, the first left out.
    fn turn(&mut self, side: &Side, next: Unit, length: u64) {
        if side.normal == next {
            return;
        }
        let cross = side.normal.cross(next);
        if cross < 0 || (cross == 0 && side.normal.dot(next) < 0) {
            fan(self.sink, side.at, self.radius, side.normal, next);
        } else {
            let between = next.0.minus(side.normal.0).length_at_most();
            // Overlapping by at most r |n' - n|; lengths are up to an eighth too large.
            let overlap = (u128::from(between) * u128::from(self.radius.unsigned_abs())) >> (UNIT_BITS - 1);
            if overlap > u128::from(side.length.min(length)) {
                self.point(side.at);
            }
        }
        self.offset(side.at, next);
    }
}

/// Where a side has got to.
struct Side {
    at: FinePoint,
    normal: Unit,
    /// Of the chord before, at most an eighth too large.
    length: u64,
}

/// In place of a length beyond the ends of a curve. The outermost chords are turned from the curve's own direction by
/// a little, and their corners on the inner side lie behind the cap: a spike would leave them there, without one they
/// are cut off. Only where a chord is shorter than that, because the curve is tighter than the stroke, is there a
/// spike.
const END: u64 = u64::MAX;

impl<S: OutlineSink> CurveSink for Pieces<'_, S> {
    fn start(&mut self, at: FinePoint) {
        self.begin(at);
    }

    fn line(&mut self, to: FinePoint) {
        if let Some(run) = Run::line(self.at, to) {
            self.push(run);
        }
    }

    fn curve(&mut self, curve: &Curve) {
        if let Some(run) = Run::curve(curve) {
            self.push(run);
        }
    }

    fn end(&mut self, is_closed: bool) {
        let Some((start, _)) = self.first else { return self.dot(self.at, Unit::RIGHT.turned()) };
        if is_closed {
            self.line(start);
            self.join_up();
        } else {
            self.finish();
        }
    }
}
