//! Pieces of sides that leave the range of positions, `-2^63..2^63`: they are cut at its ends.
//!
//! ```text
//!     |              /|                |              | |
//!     |            /  |    becomes     |              | |   both parts to the right of every pixel, and the
//!     |          /    |/               |            /   |   lower one as it was
//! ```
//!
//! What lies beyond the left end is wholly to the left of every pixel, wherever it is, and what lies beyond the right end is
//! wholly to the right: a vertical piece at that end leaves the same areas.

use crate::coverage::Steepness;

/// Hands on a piece between two positions, in up to three.
pub(crate) fn send_within_range(from: i128, to: i128, height: u32, piece: &mut impl FnMut(i64, i64, u32, Steepness)) {
    if let (Ok(from), Ok(to)) = (i64::try_from(from), i64::try_from(to)) {
        return piece(from, to, height, Steepness::of_positions(height, to.abs_diff(from)));
    }
    let (left, right) = (from.min(to), from.max(to));
    let (least, most) = (i128::from(i64::MIN), i128::from(i64::MAX));
    if right <= least || left >= most {
        let end = if right <= least { i64::MIN } else { i64::MAX };
        return piece(end, end, height, Steepness::NONE);
    }
    let cut_left = part_of_height(height, left, right, left.max(least));
    let cut_right = part_of_height(height, left, right, right.min(most));
    let (before, inside, after) = (cut_left, cut_right.saturating_sub(cut_left), height.saturating_sub(cut_right));
    let mut send = |from: i64, to: i64, height: u32| {
        if height > 0 {
            piece(from, to, height, Steepness::of_positions(height, to.abs_diff(from)));
        }
    };
    send(i64::MIN, i64::MIN, before);
    let clamped = |position: i128| i64::try_from(position.clamp(least, most)).unwrap_or(0);
    send(clamped(left), clamped(right), inside);
    send(i64::MAX, i64::MAX, after);
}

/// How much of the height lies to the left of a cut between the ends.
fn part_of_height(height: u32, left: i128, right: i128, cut: i128) -> u32 {
    // Of a difference, 64 bits are enough, and the product then fits.
    let (part, whole) = (cut.abs_diff(left), right.abs_diff(left));
    let excess = 64_u32.saturating_sub(whole.leading_zeros());
    let part = ((part >> excess) * u128::from(height)) / (whole >> excess).max(1);
    u32::try_from(part).unwrap_or(height).min(height)
}
