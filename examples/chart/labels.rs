//! Places for names beside marks, so that none covers another.

/// The names of marks, placed one after the other.
#[derive(Debug)]
pub(crate) struct Labels {
    least: (i32, i32),
    most: (i32, i32),
    taken: Vec<Place>,
    placed: Vec<(usize, Place)>,
}

/// Where a name is.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Place {
    pub(crate) left: i32,
    top: i32,
    right: i32,
    bottom: i32,
    /// So far that a line has to lead there.
    pub(crate) is_far: bool,
}

const HEIGHT: i32 = 14;

impl Labels {
    pub(crate) fn new(least: (i32, i32), most: (i32, i32)) -> Self {
        Self { least, most, taken: Vec::new(), placed: Vec::new() }
    }

    /// Keeps the place of a mark free.
    pub(crate) fn occupy(&mut self, (x, y): (i32, i32), radius: i32) {
        let place = Place { left: x - radius, top: y - radius, right: x + radius, bottom: y + radius, is_far: false };
        self.taken.push(place);
    }

    /// Keeps an upright or level line free.
    pub(crate) fn keep_off(&mut self, from: (i32, i32), to: (i32, i32)) {
        let (left, right) = (from.0.min(to.0) - 3, from.0.max(to.0) + 3);
        let (top, bottom) = (from.1.min(to.1) - 2, from.1.max(to.1) + 2);
        self.taken.push(Place { left, top, right, bottom, is_far: false });
    }

    /// Finds the nearest free place for a name.
    pub(crate) fn add(&mut self, index: usize, at: (i32, i32), width: i32) {
        let mut places = candidates(at, width);
        places.sort_by_key(|(_, distance)| *distance);
        let free = places.iter().map(|(place, _)| *place).find(|place| self.is_free(place));
        let place = free.unwrap_or(places[0].0);
        self.taken.push(place);
        self.placed.push((index, place));
    }

    pub(crate) fn places(&self) -> impl Iterator<Item = (usize, Place)> + '_ {
        self.placed.iter().copied()
    }

    fn is_free(&self, place: &Place) -> bool {
        let is_inside = place.left >= self.least.0
            && place.right <= self.most.0
            && place.top >= self.least.1
            && place.bottom <= self.most.1;
        is_inside && !self.taken.iter().any(|other| place.overlaps(other))
    }
}

/// Places around a mark, with what speaks against each.
fn candidates((x, y): (i32, i32), width: i32) -> Vec<(Place, i32)> {
    let mut places = Vec::new();
    for step in -30..=30_i32 {
        for shift in 0..=12_i32 {
            let dy = step * 8;
            for is_left in [false, true] {
                let gap = 12 + shift * 16;
                let left = if is_left { x - gap - width } else { x + gap };
                let is_far = step.abs() > 1 || shift > 0;
                let top = y + dy - HEIGHT / 2;
                let place = Place { left, top, right: left + width, bottom: top + HEIGHT, is_far };
                places.push((
                    place,
                    dy.abs() * 2 + (gap - 12) * 2 + if is_left { 7 } else { 0 } + if is_far { 12 } else { 0 },
                ));
            }
        }
        // Above and below, in the middle.
        if step.abs() >= 2 {
            let (left, top) = (x - width / 2, y + step * 8 - HEIGHT / 2);
            let place = Place { left, top, right: left + width, bottom: top + HEIGHT, is_far: step.abs() > 2 };
            places.push((place, step.abs() * 16 + 10));
        }
    }
    places
}

impl Place {
    fn overlaps(&self, other: &Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }

    pub(crate) fn middle(&self) -> i32 {
        (self.top + self.bottom) / 2
    }

    /// Where a line from the mark ends.
    pub(crate) fn nearest_to(&self, (x, y): (i32, i32)) -> (i32, i32) {
        let beside = if x <= self.left { self.left - 2 } else { self.right + 2 };
        if (self.left..self.right).contains(&x) {
            (x, if y < self.top { self.top } else { self.bottom })
        } else {
            (beside, self.middle())
        }
    }
}
