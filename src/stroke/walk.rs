//! The vertices of a stroke by number.
//!
//! An open subpath, or a dash, is one contour: along one side, around the end, and back along the other. A closed one is
//! two, its sides. Both have the winding of the sum of the convex pieces that they are made of (a rectangle for each
//! line, a sector or another piece for each outer corner): edges that two pieces have in common cancel.
//!
//! ```text
//!      .--------<---------.-.          index: line or curve from the subpath's start | side | corner | vertex
//!      |                  |  \
//!      a ---------------- b   \        a curve has a corner where it starts, one between any two chords and one
//!      |              .   |    \       where it ends; then comes that to what follows it. A line has the last alone.
//!      '------->----------'     ^
//! ```

use crate::{
    outline::{Curves, FinePoint, INDEX_BITS, KEPT_VERTICES, Kept, Step, Vertices},
    stroke::{
        Align, Cap, Join, StrokeStyle,
        corner::{Corner, Kind},
        dash::Dashes,
        fan::{MOST_HALVINGS, halved_bend},
        normal::Unit,
        piece::Piece,
        run::Run,
    },
};

/// See the module.
pub(super) struct Walk<'a> {
    curves: &'a dyn Curves,
    dashes: Option<Dashes<'a>>,
    radius: i64,
    cap: Cap,
    join: Join,
    align: Align,
    corner_bits: u32,
    vertex_bits: u32,
    most_halvings: u32,
    pieces: Kept<Piece, PIECES>,
    corners: Kept<Corner, CORNERS>,
    /// With the index of the next.
    vertices: Kept<(FinePoint, u32), KEPT_VERTICES>,
}

/// A vertex of a contour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Place {
    /// The number of the line or curve, from the start of the subpath or dash.
    run: u32,
    is_back: bool,
    corner: u32,
    vertex: u32,
}

const PIECES: usize = if cfg!(target_pointer_width = "64") { 16 } else { 4 };
const CORNERS: usize = if cfg!(target_pointer_width = "64") { 64 } else { 8 };

/// What a contour is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Contour {
    /// Both sides of an open subpath.
    Open,
    /// One side of a closed one.
    Side { is_back: bool },
    /// A subpath of no length.
    Dot,
}

/// Contours of a subpath that are numbered one after the other.
const PARTS: u32 = 3;

/// The number of a vertex in its corner.
const fn place_vertex(index: u32, vertex_bits: u32) -> u32 {
    index & ((1 << vertex_bits) - 1)
}

impl<'a> Walk<'a> {
    pub(super) fn new(curves: &'a dyn Curves, style: &StrokeStyle<'a>, is_clockwise: bool) -> Self {
        let dashes = Dashes::new(curves, style);
        let align = if dashes.is_some() { Align::Center } else { style.align };
        let radius = match align {
            Align::Center => style.radius(),
            Align::Inside | Align::Outside => 2 * style.radius(),
        };
        let mut chords = crate::outline::most_chords(curves);
        if dashes.is_some() {
            chords = chords.saturating_mul(4);
        }
        let is_straight = chords == 0 && style.cap != Cap::Round && style.join != Join::Round;
        let corner_bits = if chords == 0 { 0 } else { u32::BITS - (chords + 1).leading_zeros() };
        let most =
            if is_straight { 1 } else { halved_bend(radius, Unit::RIGHT, Unit::RIGHT.opposite(), MOST_HALVINGS).0 };
        // The numbers of the lines and curves come first: round corners may have fewer vertices than they should.
        let run_bits = u32::BITS - curves.steps().leading_zeros();
        let vertex_bits = (most + 1).max(2).min(INDEX_BITS.saturating_sub(1 + corner_bits + run_bits).max(2));
        let most_halvings = most.min(vertex_bits - 1);
        Self {
            curves,
            dashes,
            radius,
            cap: style.cap,
            join: style.join,
            align: if align == Align::Center || is_clockwise { align } else { align.opposite() },
            corner_bits,
            vertex_bits,
            most_halvings,
            pieces: Kept::new(Piece::NOTHING),
            corners: Kept::new(Corner::NOTHING),
            vertices: Kept::new((FinePoint::default(), 0)),
        }
    }

    fn place(&self, index: u32) -> Place {
        let low = |value: u32, bits: u32| value & ((1 << bits) - 1);
        let rest = index >> self.vertex_bits;
        let side = rest >> self.corner_bits;
        Place {
            run: side >> 1,
            is_back: side & 1 == 1,
            corner: low(rest, self.corner_bits),
            vertex: low(index, self.vertex_bits),
        }
    }

    fn index(&self, Place { run, is_back, corner, vertex }: Place) -> u32 {
        (((run << 1 | u32::from(is_back)) << self.corner_bits) | corner) << self.vertex_bits | vertex
    }

    /// The step of the path, if it is of the subpath that begins before it.
    fn step(&self, index: u32) -> Option<Step> {
        if index >= self.curves.steps() {
            return None;
        }
        Some(self.curves.step(index)).filter(|step| !matches!(step, Step::Move(_)))
    }

    #[inline]
    fn piece(&self, contour: u32, run: u32) -> Piece {
        match &self.dashes {
            None => {
                let index = contour / PARTS + run;
                self.pieces.get(index.into(), || {
                    let step = self.step(index);
                    Piece {
                        is_over: step.is_none(),
                        is_last: matches!(step, Some(Step::Close(..))),
                        run: step.and_then(|step| Run::of(&step)),
                    }
                })
            }
            Some(dashes) => self.pieces.get(u64::from(contour) << 32 | u64::from(run), || dashes.piece(contour, run)),
        }
    }

    /// A line or curve of a contour; none where there is none, or it has no length.
    #[inline]
    fn run(&self, contour: u32, run: u32) -> Option<Run> {
        if run == 0 { None } else { self.piece(contour, run).run }
    }

    /// Whether a contour's lines and curves end with this one.
    #[inline]
    fn is_last(&self, contour: u32, run: u32) -> bool {
        run > 0 && self.piece(contour, run).is_last || self.piece(contour, run + 1).is_over
    }

    /// The next with a length, or the one before.
    fn neighbour(&self, contour: u32, mut run: u32, is_back: bool) -> Option<u32> {
        loop {
            if is_back {
                run = run.checked_sub(1).filter(|&run| run > 0)?;
            } else {
                if self.is_last(contour, run) {
                    return None;
                }
                run += 1;
            }
            if self.run(contour, run).is_some() {
                return Some(run);
            }
        }
    }

    /// The last with a length, or the first, of a contour that has one.
    fn end(&self, contour: u32, is_back: bool) -> u32 {
        if !is_back {
            return self.neighbour(contour, 0, false).unwrap_or(0);
        }
        let mut run = 0;
        while let Some(next) = self.neighbour(contour, run, false) {
            run = next;
        }
        run
    }

    /// The chords of what is stroked.
    pub(super) fn each_chord(&self, found: &mut dyn FnMut(FinePoint, FinePoint)) {
        for contour in 0..self.contours() {
            match self.contour(contour) {
                Some(Contour::Open | Contour::Side { is_back: false }) => {}
                Some(Contour::Dot) => {
                    let (at, _) = self.dot(contour);
                    found(at, at);
                    continue;
                }
                _ => continue,
            }
            let mut next = self.neighbour(contour, 0, false);
            while let Some(number) = next {
                if let Some(run) = self.run(contour, number) {
                    for chord in 0..run.chords() {
                        found(run.point(chord, false), run.point(chord + 1, false));
                    }
                }
                next = self.neighbour(contour, number, false);
            }
        }
    }

    /// What a contour is of, if it is there.
    fn contour(&self, contour: u32) -> Option<Contour> {
        if let Some(dashes) = &self.dashes {
            return Some(if dashes.is_dot(contour) { Contour::Dot } else { Contour::Open });
        }
        let (start, part) = (contour / PARTS, contour % PARTS);
        match self.curves.step(start) {
            Step::Move(_) | Step::Close(..) => {}
            _ => return None,
        }
        let mut last = start + 1;
        let is_closed = loop {
            match self.step(last) {
                None => break false,
                Some(Step::Close(..)) => break true,
                Some(_) => last += 1,
            }
        };
        if !is_closed && last == start + 1 {
            return None;
        }
        let is_dot = self.neighbour(contour, 0, false).is_none();
        match (self.align, part) {
            (Align::Center, 0) if is_dot => Some(Contour::Dot).filter(|_| self.cap != Cap::Butt),
            _ if is_dot => None,
            (Align::Center, 0 | 1) if is_closed => Some(Contour::Side { is_back: part == 1 }),
            (Align::Center, 2) if !is_closed => Some(Contour::Open),
            (Align::Inside, 0..3) if is_closed => Some(Contour::Side { is_back: part == 0 }),
            (Align::Outside, 0..3) if is_closed => Some(Contour::Side { is_back: part != 0 }),
            _ => None,
        }
    }

    const fn is_open(&self, contour: u32) -> bool {
        self.dashes.is_some() || contour % PARTS == 2 && matches!(self.align, Align::Center)
    }

    const fn radius(&self, contour: u32) -> i64 {
        if !matches!(self.align, Align::Center) && contour.is_multiple_of(PARTS) { 0 } else { self.radius }
    }

    fn corners(&self, contour: u32, run: u32) -> u32 {
        match self.run(contour, run) {
            Some(run) if run.curve.is_some() => run.chords() + 2,
            _ => 1,
        }
    }

    #[inline]
    fn corner(&self, contour: u32, place: Place) -> Corner {
        let number = u64::from(contour) << 32 | u64::from(self.index(place) >> self.vertex_bits);
        self.corners.get(number, || self.make_corner(contour, place))
    }

    fn make_corner(&self, contour: u32, Place { run: number, is_back, corner, .. }: Place) -> Corner {
        let radius = self.radius(contour);
        let make = |at, normals, kind, has_from, shorter| {
            Corner::new(at, radius, normals, kind, has_from, shorter, self.most_halvings)
        };
        let Some(run) = self.run(contour, number) else {
            let (at, normal) = self.dot(contour);
            let normal = if is_back { normal.opposite() } else { normal };
            return make(at, [normal, normal.opposite()], Kind::Cap(self.cap), false, 0);
        };
        let [start, end] = run.ends(is_back);
        let chords = run.chords();
        if run.curve.is_some() && corner <= chords {
            let at = run.point(corner, is_back);
            let before = corner.checked_sub(1).map_or((start, u128::MAX), |before| run.chord(before, is_back));
            // The outermost chords are turned from the curve's own direction by a little, and their corners on the inner
            // side lie behind the cap: a spike would leave them there, without one they are cut off.
            let after = if corner < chords { run.chord(corner, is_back) } else { (end, u128::MAX) };
            return make(at, [before.0, after.0], Kind::Bend, corner > 0, before.1.min(after.1));
        }
        let at = run.point(chords, is_back);
        let has_from = run.curve.is_none();
        let next = match self.neighbour(contour, number, is_back) {
            None if self.is_open(contour) => {
                return make(at, [end, end.opposite()], Kind::Cap(self.cap), has_from, 0);
            }
            None => self.end(contour, is_back),
            Some(next) => next,
        };
        let next = self.run(contour, next).unwrap_or(run);
        // Where a curve is, its chords may be shorter than anything.
        let shorter = if run.curve.is_none() && next.curve.is_none() {
            run.chord(0, false).1.min(next.chord(0, false).1)
        } else {
            0
        };
        make(at, [end, next.ends(is_back)[0]], Kind::Join(self.join), has_from, shorter)
    }

    fn dot(&self, contour: u32) -> (FinePoint, Unit) {
        match &self.dashes {
            Some(dashes) => dashes.dot(contour),
            None => (self.curves.step(contour / PARTS).end(), Unit::RIGHT.turned()),
        }
    }

    /// A vertex, and the index of the next.
    #[inline]
    fn known(&self, contour: u32, index: u32) -> (FinePoint, u32) {
        let number = u64::from(contour) << 32 | u64::from(index);
        self.vertices.find(number).unwrap_or_else(|| self.find_out(contour, index, number))
    }

    /// All vertices of a corner, if they are not too many.
    #[inline(never)]
    fn find_out(&self, contour: u32, index: u32, number: u64) -> (FinePoint, u32) {
        let mut place = self.place(index);
        let corner = self.corner(contour, place);
        let mut next = index + 1;
        if place.vertex + 1 == corner.count {
            place = self.beside(contour, place, true);
            while self.corner(contour, place).count == 0 {
                place = self.beside(contour, place, true);
            }
            next = self.index(place);
        }
        let known = (corner.vertex(place_vertex(index, self.vertex_bits)), next);
        self.vertices.keep(number, known);
        let first = index - place_vertex(index, self.vertex_bits);
        corner.fan(&mut |vertex, point| {
            let index = first + vertex;
            self.vertices.keep(u64::from(contour) << 32 | u64::from(index), (point, index + 1));
        });
        known
    }

    /// The corner that follows along the contour, or comes before.
    fn beside(&self, contour: u32, mut place: Place, is_forward: bool) -> Place {
        place.vertex = 0;
        let corners = self.corners(contour, place.run);
        if is_forward && place.corner + 1 < corners {
            place.corner += 1;
            return place;
        }
        if !is_forward && place.corner > 0 {
            place.corner -= 1;
            return place;
        }
        match self.neighbour(contour, place.run, place.is_back == is_forward) {
            // The two halves of a dot, too.
            _ if place.run == 0 => place.is_back = !place.is_back,
            Some(run) => place.run = run,
            None if self.is_open(contour) => place.is_back = !place.is_back,
            None => place.run = self.end(contour, place.is_back == is_forward),
        }
        place.corner = if is_forward { 0 } else { self.corners(contour, place.run).saturating_sub(1) };
        place
    }
}

impl Vertices for Walk<'_> {
    fn contours(&self) -> u32 {
        match &self.dashes {
            _ if self.radius == 0 => 0,
            Some(dashes) => dashes.count(),
            None => self.curves.steps().saturating_mul(PARTS),
        }
    }

    fn first(&self, contour: u32) -> Option<u32> {
        let (run, is_back) = match self.contour(contour)? {
            Contour::Dot => (0, false),
            Contour::Open => (self.end(contour, false), false),
            Contour::Side { is_back } => (self.end(contour, is_back), is_back),
        };
        let start = Place { run, is_back, corner: 0, vertex: 0 };
        let mut place = start;
        while self.corner(contour, place).count == 0 {
            place = self.beside(contour, place, true);
            if place == start {
                return None;
            }
        }
        Some(self.index(place))
    }

    fn next(&self, contour: u32, index: u32, is_forward: bool) -> u32 {
        let mut place = self.place(index);
        if is_forward {
            return self.known(contour, index).1;
        }
        if place.vertex > 0 {
            return index - 1;
        }
        loop {
            place = self.beside(contour, place, false);
            let count = self.corner(contour, place).count;
            if count > 0 {
                place.vertex = count - 1;
                return self.index(place);
            }
        }
    }

    #[inline]
    fn vertex(&self, contour: u32, index: u32) -> FinePoint {
        self.known(contour, index).0
    }
}
