//! Contours as rings of corners, in the caller's slots.

use crate::methods::polygon::{Contours, Plane};

/// A corner of a contour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Corner<T> {
    at: [T; 2],
    next: usize,
    previous: usize,
    /// The first corner of its ring.
    ring: usize,
    /// What its ring is of the area: of a ring's first corner; of all of them where that is nothing.
    role: Role,
}

/// What a ring is of the area that is filled.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    /// The same lies to both of its sides.
    Nothing,
    /// The outline of a piece.
    Outline,
    /// A hole in the piece with this outline.
    HoleIn(usize),
}

impl<T: Plane> Corner<T> {
    /// What to make slots of.
    pub const EMPTY: Self = Self { at: [T::ORIGIN; 2], next: 0, previous: 0, ring: 0, role: Role::Nothing };
}

/// Rings of corners, each a name for where it stands.
pub(super) struct Rings<'s, T> {
    slots: &'s mut [Corner<T>],
    length: usize,
}

impl<'s, T: Plane> Rings<'s, T> {
    pub(super) fn new(slots: &'s mut [Corner<T>]) -> Self {
        Self { slots, length: 0 }
    }

    /// A ring for each contour.
    pub(super) fn load(&mut self, contours: &(impl Contours<T> + ?Sized)) {
        for contour in 0..contours.contours() {
            let first = self.length;
            for index in 0..contours.vertices(contour) {
                let Some(at) = contours.vertex(contour, index) else { break };
                if let Some(corner) = self.add(at) {
                    self.link(corner.saturating_sub(1).max(first), corner);
                    self.link(corner, first);
                }
            }
        }
    }

    pub(super) fn len(&self) -> usize {
        self.length
    }

    /// A new corner, alone; none when the slots are used up.
    pub(super) fn add(&mut self, at: [T; 2]) -> Option<usize> {
        let corner = self.length;
        *self.slots.get_mut(corner)? = Corner { at, next: corner, previous: corner, ring: corner, role: Role::Outline };
        self.length += 1;
        Some(corner)
    }

    /// Makes a new corner one of a ring's.
    pub(super) fn join_ring(&mut self, corner: usize, member: usize) {
        let ring = self.ring(member);
        if let Some(corner) = self.slots.get_mut(corner) {
            corner.ring = ring;
        }
    }

    /// Whether so many corners more have room.
    pub(super) fn has_room_for(&self, corners: usize) -> bool {
        self.slots.len() - self.length >= corners
    }

    fn get(&self, corner: usize) -> Option<&Corner<T>> {
        self.slots.get(corner)
    }

    pub(super) fn at(&self, corner: usize) -> [T; 2] {
        self.get(corner).map_or([T::ORIGIN; 2], |corner| corner.at)
    }

    pub(super) fn next(&self, corner: usize) -> usize {
        self.get(corner).map_or(corner, |corner| corner.next)
    }

    pub(super) fn previous(&self, corner: usize) -> usize {
        self.get(corner).map_or(corner, |corner| corner.previous)
    }

    pub(super) fn ring(&self, corner: usize) -> usize {
        self.get(corner).map_or(corner, |corner| corner.ring)
    }

    pub(super) fn role(&self, ring: usize) -> Role {
        self.get(ring).map_or(Role::Nothing, |corner| corner.role)
    }

    pub(super) fn set_role(&mut self, ring: usize, role: Role) {
        if let Some(corner) = self.slots.get_mut(ring) {
            corner.role = role;
        }
    }

    /// Makes a ring nothing, which it stays when rings get new names.
    pub(super) fn remove(&mut self, ring: usize) {
        let mut corner = ring;
        for _ in 0..self.length {
            self.set_role(corner, Role::Nothing);
            corner = self.next(corner);
            if corner == ring {
                return;
            }
        }
    }

    pub(super) fn link(&mut self, corner: usize, next: usize) {
        if let Some(corner) = self.slots.get_mut(corner) {
            corner.next = next;
        }
        if let Some(next) = self.slots.get_mut(next) {
            next.previous = corner;
        }
    }

    /// Goes on where the other does, and the other where this one did: one ring becomes two, or two one.
    pub(super) fn change_partners(&mut self, a: usize, b: usize) {
        let (after_a, after_b) = (self.next(a), self.next(b));
        self.link(a, after_b);
        self.link(b, after_a);
    }

    /// The corners of a ring, from one of them.
    pub(super) fn around(&self, first: usize) -> impl Iterator<Item = usize> {
        let mut corner = Some(first);
        // No more than there are.
        (0..self.length).map_while(move |_| {
            let this = corner?;
            let next = self.next(this);
            corner = (next != first).then_some(next);
            Some(this)
        })
    }

    /// Names every ring that is something by its first corner.
    pub(super) fn name_rings(&mut self) {
        self.slots.iter_mut().for_each(|corner| corner.ring = usize::MAX);
        for first in 0..self.length {
            let mut corner = first;
            let is_new = |slot: &&mut Corner<T>| slot.ring == usize::MAX && slot.role != Role::Nothing;
            while let Some(slot) = self.slots.get_mut(corner).filter(is_new) {
                slot.ring = first;
                corner = slot.next;
            }
        }
    }

    /// The first corners of all rings.
    pub(super) fn rings(&self) -> impl Iterator<Item = usize> {
        (0..self.length).filter(|corner| self.ring(*corner) == *corner)
    }

    /// The first ring after one.
    pub(super) fn ring_from(&self, corner: usize) -> Option<usize> {
        (corner..self.length).find(|corner| self.ring(*corner) == *corner)
    }

    pub(super) fn reverse(&mut self, first: usize) {
        let mut corner = first;
        for _ in 0..self.length {
            let Some(slot) = self.slots.get_mut(corner) else { return };
            let next = slot.next;
            (slot.next, slot.previous) = (slot.previous, next);
            corner = next;
            if corner == first {
                return;
            }
        }
    }

    /// Whether a point lies to the right of the way through a corner.
    pub(super) fn is_right_of(&self, corner: usize, point: [T; 2]) -> bool {
        let (before, at, after) = (self.at(self.previous(corner)), self.at(corner), self.at(self.next(corner)));
        let (of_first, of_second) = (T::turn(before, at, point) > 0, T::turn(at, after, point) > 0);
        if T::turn(before, at, after) > 0 { of_first && of_second } else { of_first || of_second }
    }
}
