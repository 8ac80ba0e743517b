//! A stack of few entries that drops what it has no room for, and looks for it afterwards.

use super::{
    Canvas, Entry, Touch,
    spans::{Stack, cast, start},
};
use crate::{
    fragment::{Fragment, FragmentSink},
    geometry::PixelRect,
};

/// What filled pixels are told apart from the boundary by.
#[derive(Debug)]
pub enum Marker<'c, 'w> {
    /// A colour that nothing else has: closed in this canvas.
    Colour(&'c mut Canvas<'w>),
    /// Nothing: what is closed may have been filled. Where an open pixel outside of the outline touches that, the
    /// fill gets out.
    Nothing,
}

/// Heckbert's fill, neighbours by sides. When the stack is empty and something was dropped, the box of what was
/// filled is searched for an open pixel next to a filled one, and the fill goes on from there. Each search finds a
/// pixel or is the last.
///
/// # Errors
///
/// The sink's.
///
/// # Cost
///
/// A pass over the box for each search: as many as the region has branches, if the stack holds one entry.
pub fn by_spans_with_rescan<S: FragmentSink>(
    canvas: &mut Canvas<'_>,
    seed: [i32; 2],
    mut marker: Marker<'_, '_>,
    stack: &mut [Entry],
    sink: &mut S,
) -> Result<(), S::Error> {
    canvas.send(sink)?;
    let mut stack = Stack::new(stack);
    let mut from = Some(seed).filter(|[x, y]| canvas.look(*x, *y, sink));
    let mut filled = PixelRect { rows: 0..0, columns: 0..0 };
    while let Some(seed) = from {
        let mut marking = Marking { marker: &mut marker, filled: &mut filled, sink: &mut *sink };
        let mut all = start(canvas, seed, &mut stack, &mut marking)?;
        while let Some(entry) = stack.pop() {
            all &= cast(canvas, entry, Touch::Sides, &mut stack, &mut marking)?;
        }
        from = if all { None } else { search(canvas, &marker, &filled, sink) };
    }
    Ok(())
}

/// An open pixel next to one that was filled.
fn search<S: FragmentSink>(
    canvas: &Canvas<'_>,
    marker: &Marker<'_, '_>,
    filled: &PixelRect,
    sink: &mut S,
) -> Option<[i32; 2]> {
    let is_filled = |x: i32, y: i32| match marker {
        Marker::Colour(marked) => {
            marked.clip.columns.contains(&x) && marked.clip.rows.contains(&y) && !marked.is_open(x, y)
        }
        Marker::Nothing => canvas.clip.columns.contains(&x) && canvas.clip.rows.contains(&y) && !canvas.is_open(x, y),
    };
    for y in filled.rows.start.saturating_sub(1)..filled.rows.end.saturating_add(1) {
        for x in filled.columns.start.saturating_sub(1)..filled.columns.end.saturating_add(1) {
            let touches = |(dx, dy)| is_filled(x.wrapping_add(dx), y.wrapping_add(dy));
            if canvas.look(x, y, sink) && [(1, 0), (0, 1), (-1, 0), (0, -1)].into_iter().any(touches) {
                return Some([x, y]);
            }
        }
    }
    None
}

/// Marks what is filled, and measures its box.
struct Marking<'m, 'c, 'w, S> {
    marker: &'m mut Marker<'c, 'w>,
    filled: &'m mut PixelRect,
    sink: &'m mut S,
}

impl<S: FragmentSink> FragmentSink for Marking<'_, '_, '_, S> {
    type Error = S::Error;

    fn fragment(&mut self, fragment: Fragment) -> Result<(), S::Error> {
        let (x, y) = (fragment.x, fragment.y);
        if let Marker::Colour(marked) = self.marker {
            marked.close(x, y);
        }
        if self.filled.rows.is_empty() {
            *self.filled = PixelRect { rows: y..y, columns: x..x };
        }
        let (rows, columns) = (&mut self.filled.rows, &mut self.filled.columns);
        *rows = rows.start.min(y)..rows.end.max(y.saturating_add(1));
        *columns = columns.start.min(x)..columns.end.max(x.saturating_add(1));
        self.sink.fragment(fragment)
    }

    fn visit(&mut self, x: i32, y: i32) {
        self.sink.visit(x, y);
    }
}
