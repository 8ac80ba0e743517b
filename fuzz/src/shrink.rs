//! Makes a case that fails smaller, as long as it still does.

use spanfill::{Circle, Line, PixelRect, Triangle, Vertex};

use crate::{
    case::{Case, Figure},
    oracle::Outline,
};

/// A case that fails is tried at most so often.
const TRIES: usize = 20_000;

/// The smallest case that was found to fail, too.
pub(crate) fn shrunk(case: Case, fails: impl Fn(&Case) -> bool) -> Case {
    let mut best = case;
    let mut tries = 0;
    loop {
        let mut is_better = false;
        let mut index = 0;
        // Candidates are numbered anew after each success, as there are fewer.
        while let Some(candidate) = candidate(&best, index) {
            if tries == TRIES {
                return best;
            }
            index += 1;
            if size(&candidate) < size(&best) {
                tries += 1;
                if fails(&candidate) {
                    best = candidate;
                    is_better = true;
                    index = index.saturating_sub(1);
                }
            }
        }
        if !is_better {
            return best;
        }
    }
}

/// The fewer digits, the simpler.
fn size_of(bits: i64) -> u64 {
    let digits = u64::from(64 - bits.unsigned_abs().leading_zeros());
    4 * digits + 8_u64.saturating_sub(bits.trailing_zeros().into()) + u64::from(bits < 0)
}

fn vertices(figure: &Figure) -> Vec<Vertex> {
    match figure {
        Figure::Outline(outline) => outline.contours.concat(),
        Figure::Triangle(triangle) => triangle.vertices.to_vec(),
        Figure::Line(line) => vec![line.start, line.end],
        Figure::Circle(circle) => vec![circle.center, Vertex { x: circle.radius, y: circle.radius }],
    }
}

/// What is to become less.
fn size(case: &Case) -> (usize, usize, u64, u64) {
    let vertices = vertices(&case.figure);
    let contours = if let Figure::Outline(outline) = &case.figure { outline.contours.len() } else { 0 };
    let coordinates = vertices.iter().flat_map(|v| [v.x, v.y]).map(|at| size_of(at.to_bits().into())).sum();
    let PixelRect { rows, columns } = &case.window;
    let cuts = [case.column, case.row, rows.start, columns.start].map(|at| size_of(at.into())).iter().sum::<u64>();
    let seen = (rows.len() * columns.len()) as u64;
    (vertices.len(), contours, coordinates, 64 * seen + cuts + case.more as u64 + u64::from(255 - case.opacity))
}

/// The case with one thing made simpler; none if there are no more ways to.
fn candidate(case: &Case, index: usize) -> Option<Case> {
    let vertices = vertices(&case.figure);
    let count = vertices.len();
    let mut index = index;
    let mut take = |ways: usize| {
        let mine = (index < ways).then_some(index);
        index = index.wrapping_sub(if mine.is_some() { 0 } else { ways });
        mine
    };
    let outline = if let Figure::Outline(outline) = &case.figure { Some(outline) } else { None };
    if let Some(outline) = outline {
        if let Some(contour) = take(outline.contours.len()) {
            let mut contours = outline.contours.clone();
            contours.remove(contour);
            return Some(with_contours(case, outline, contours));
        }
        // Runs of vertices, long ones first.
        for length in [16, 4, 1] {
            if let Some(first) = take(count.div_ceil(length)) {
                return Some(without(case, outline, first * length, length));
            }
        }
        // The same from the other rule is as simple: not tried.
    }
    if let Some(way) = take(2 * SHIFTS.len()) {
        return moved(case, way);
    }
    if let Some(way) = take(2 * count * ROUNDINGS.len()) {
        let (vertex, way) = (way / (2 * ROUNDINGS.len()), way % (2 * ROUNDINGS.len()));
        let (is_y, rounding) = (way % 2 == 1, ROUNDINGS[way / 2]);
        let mut at = 0;
        return Some(with_vertices(case, |mut v| {
            if at == vertex {
                let part = if is_y { &mut v.y } else { &mut v.x };
                *part = spanfill::I24F8::from_bits(rounding(part.to_bits()));
            }
            at += 1;
            v
        }));
    }
    let way = take(12)?;
    let mut smaller = case.clone();
    let PixelRect { rows, columns } = &mut smaller.window;
    let (height, width) = (rows.len() as i32, columns.len() as i32);
    match way {
        0 => rows.start += height / 2,
        1 => rows.end -= height / 2,
        2 => columns.start += width / 2,
        3 => columns.end -= width / 2,
        4 => rows.start += i32::from(height > 1),
        5 => rows.end -= i32::from(height > 1),
        6 => columns.start += i32::from(width > 1),
        7 => columns.end -= i32::from(width > 1),
        8 => smaller.row = rows.end,
        9 => smaller.column = columns.end,
        10 => smaller.more = 0,
        _ => smaller.opacity = 255,
    }
    smaller.row = smaller.row.clamp(smaller.window.rows.start, smaller.window.rows.end);
    smaller.column = smaller.column.clamp(smaller.window.columns.start, smaller.window.columns.end);
    Some(smaller)
}

/// Simpler coordinates.
const ROUNDINGS: [fn(i32) -> i32; 7] = [
    |_| 0,
    |bits| bits / 2,
    |bits| bits & !0xFFF,
    |bits| bits & !0xFF,
    |bits| bits & !0x7F,
    |bits| bits & !0xF,
    |bits| bits - bits.signum(),
];

/// By how many pixels everything is moved at once, as a part of where the window is.
const SHIFTS: [i32; 3] = [1, 2, 16];

fn moved(case: &Case, way: usize) -> Option<Case> {
    let (is_y, part) = (way % 2 == 1, SHIFTS[way / 2]);
    let start = if is_y { case.window.rows.start } else { case.window.columns.start };
    let by = -start / part;
    let bits = by.checked_mul(256)?;
    let mut fits = true;
    let mut moved = |at: spanfill::I24F8| {
        let moved = at.to_bits().checked_add(bits);
        fits &= moved.is_some();
        spanfill::I24F8::from_bits(moved.unwrap_or_default())
    };
    let is_circle = matches!(case.figure, Figure::Circle(_));
    let mut index = 0;
    let mut smaller = with_vertices(case, |v| {
        index += 1;
        match (is_circle && index == 2, is_y) {
            (true, _) => v,
            (_, true) => Vertex { y: moved(v.y), ..v },
            (_, false) => Vertex { x: moved(v.x), ..v },
        }
    });
    let shifted = |range: &std::ops::Range<i32>| range.start + by..range.end + by;
    if is_y {
        smaller.window.rows = shifted(&case.window.rows);
        smaller.row += by;
    } else {
        smaller.window.columns = shifted(&case.window.columns);
        smaller.column += by;
    }
    fits.then_some(smaller)
}

fn with_contours(case: &Case, outline: &Outline, contours: Vec<Vec<Vertex>>) -> Case {
    Case { figure: Figure::Outline(Outline::new(contours, outline.fill_rule)), ..case.clone() }
}

/// Without some of the vertices, counted through all contours.
fn without(case: &Case, outline: &Outline, first: usize, length: usize) -> Case {
    let mut at = 0;
    let mut contours = outline.contours.clone();
    for contour in &mut contours {
        contour.retain(|_| {
            at += 1;
            !(first + 1..first + 1 + length).contains(&at)
        });
    }
    with_contours(case, outline, contours)
}

fn with_vertices(case: &Case, mut change: impl FnMut(Vertex) -> Vertex) -> Case {
    let figure = match &case.figure {
        Figure::Outline(outline) => {
            let mut contours = outline.contours.clone();
            contours.iter_mut().flatten().for_each(|v| *v = change(*v));
            Figure::Outline(Outline::new(contours, outline.fill_rule))
        }
        Figure::Triangle(triangle) => Figure::Triangle(Triangle::from_vertices(triangle.vertices.map(&mut change))),
        Figure::Line(line) => {
            let start = change(line.start);
            Figure::Line(Line::new(start, change(line.end)))
        }
        Figure::Circle(circle) => {
            let center = change(circle.center);
            let radius = change(Vertex { x: circle.radius, y: circle.radius }).x;
            Figure::Circle(Circle::from_bits(center, radius.to_bits()))
        }
    };
    Case { figure, ..case.clone() }
}

#[cfg(test)]
mod tests {
    use spanfill::FillRule;

    use super::*;

    /// What fails is a vertex below and to the right of (1000, 300), seen in the window.
    #[test]
    fn what_fails_becomes_one_vertex_in_one_pixel() {
        let contour =
            |from: i32| (0..20).map(|index| Vertex::from_bits(from + 77 * index, 3 * index * index)).collect();
        let case = Case {
            figure: Figure::Outline(Outline::new(vec![contour(-50), contour(0), contour(99)], FillRule::EvenOdd)),
            window: PixelRect { rows: -3..9, columns: 0..12 },
            column: 4,
            row: 2,
            more: 3,
            opacity: 7,
        };
        let is_bad = |v: &Vertex| v.x.to_bits() > 1000 && v.y.to_bits() > 300;
        let fails = |case: &Case| vertices(&case.figure).iter().any(is_bad) && case.window.columns.contains(&3);
        assert!(fails(&case));
        let smallest = shrunk(case, fails);
        let found = vertices(&smallest.figure);
        assert!(matches!(&found[..], [vertex] if is_bad(vertex)), "{}", smallest.code());
        assert_eq!((smallest.window.rows.len(), smallest.window.columns), (1, 3..4));
        assert_eq!((smallest.more, smallest.opacity), (0, 255));
    }
}
