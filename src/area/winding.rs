//! The winding to the left of what comes next, for every height of a row of pixels.
//!
//! Where all chains so far cross the whole row, it is one number. Where one begins or ends within the row it changes with
//! the height, until the chain that begins or ends with it has been passed: mostly the next.
//!
//! ```text
//!      0 |  \          \      |     0 to the left of both, 1 between them below the top at h
//!      h |   \    /\    \     |     levels: up to h the winding is 1, from there on 2, then 1 again
//!        |    \  /  \    \    |
//! ```

use crate::area::source::FINE_ONE;

/// More levels than most outlines ever need; what has more is swept as a whole (see `sweep`). 8 bytes of stack each.
///
/// The same everywhere: what is swept may be rounded another way, and hosts have a board's bits.
const CAPACITY: usize = 24;

/// Heights up to `end`, and the winding there.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Level {
    pub(crate) end: i32,
    pub(crate) winding: i32,
}

/// There are more levels than there is room for.
#[derive(Debug)]
pub(crate) struct TooManyLevels;

/// From the top of the row to its bottom; always one at least.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Winding {
    levels: [Level; CAPACITY],
    count: usize,
}

impl Winding {
    pub(crate) const fn new(winding: i32) -> Self {
        Self { levels: [Level { end: FINE_ONE, winding }; CAPACITY], count: 1 }
    }

    /// Of no height yet.
    pub(crate) const fn empty() -> Self {
        Self { count: 0, ..Self::new(0) }
    }

    /// Goes on down to `end`.
    #[inline]
    pub(crate) fn append(&mut self, end: i32, winding: i32) -> Result<(), TooManyLevels> {
        if let Some(last) = self.count.checked_sub(1).and_then(|last| self.levels.get_mut(last))
            && last.winding == winding
        {
            last.end = end;
            return Ok(());
        }
        *self.levels.get_mut(self.count).ok_or(TooManyLevels)? = Level { end, winding };
        self.count += 1;
        Ok(())
    }

    #[inline]
    pub(crate) fn levels(&self) -> &[Level] {
        self.levels.get(..self.count).unwrap_or_default()
    }

    /// The winding of all heights, if it is one.
    #[inline]
    pub(crate) fn flat(&self) -> Option<i32> {
        match (self.count, &self.levels) {
            (1, [first, ..]) => Some(first.winding),
            _ => None,
        }
    }

    #[inline]
    pub(crate) fn set_flat(&mut self, winding: i32) {
        self.count = 1;
        let [first, ..] = &mut self.levels;
        *first = Level { end: FINE_ONE, winding };
    }

    /// Passes a chain between two heights. Each piece of it with another winding to its left is handed over before.
    #[inline(never)]
    pub(crate) fn pass(
        &mut self,
        top: i32,
        bottom: i32,
        direction: i32,
        piece: &mut dyn FnMut(i32, i32, i32),
    ) -> Result<(), TooManyLevels> {
        self.split(top)?;
        self.split(bottom)?;
        let mut start = 0;
        for level in self.levels.get_mut(..self.count).unwrap_or_default() {
            if start >= top && start < bottom {
                piece(start, level.end, level.winding);
                level.winding += direction;
            }
            start = level.end;
        }
        self.join();
        Ok(())
    }

    /// Makes a level end at `height`.
    fn split(&mut self, height: i32) -> Result<(), TooManyLevels> {
        let place = self.levels().iter().position(|level| level.end >= height).unwrap_or(0);
        if height == 0 || self.levels.get(place).is_some_and(|level| level.end == height) {
            return Ok(());
        }
        if self.count == CAPACITY {
            return Err(TooManyLevels);
        }
        self.count += 1;
        // What ends at `height` comes before what it is split off.
        let mut moved =
            self.levels.get(place).map_or(Level { end: height, winding: 0 }, |level| Level { end: height, ..*level });
        for level in self.levels.get_mut(place..self.count).unwrap_or_default() {
            core::mem::swap(level, &mut moved);
        }
        Ok(())
    }

    /// Neighbours with the same winding become one.
    fn join(&mut self) {
        let mut kept = 0;
        for index in 1..self.count {
            let Some(&level) = self.levels.get(index) else { break };
            match self.levels.get_mut(kept) {
                Some(last) if last.winding == level.winding => last.end = level.end,
                _ => {
                    kept += 1;
                    if let Some(next) = self.levels.get_mut(kept) {
                        *next = level;
                    }
                }
            }
        }
        self.count = kept + 1;
    }
}
