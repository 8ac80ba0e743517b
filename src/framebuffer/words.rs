//! Filling bytes by whole words.
//!
//! A word here is four bytes that begin anywhere: one store where the processor allows that, four where it does not.

use core::hint::black_box;

/// Fills with a pattern of one, two or four bytes, of which `word` holds as many as it has room for. As many bytes as the
/// pattern's length times any number.
///
/// Short pieces are filled from both ends, without a loop; what is in the middle may be written twice.
///
/// ```text
///   bytes       |----------------------|
///   first 16    [----------------]
///   last 16           [----------------]
/// ```
///
/// Out of line: it is in a program once, whatever the colours and the shapes, and needs no more registers than a call may
/// use without saving any.
#[cfg_attr(target_os = "none", inline(never))]
#[cfg_attr(not(target_os = "none"), inline(always))]
pub(super) fn fill(bytes: &mut [u8], word: u32) {
    if bytes.len() > 32 {
        fill_long(bytes, word);
    } else if let Some(last) = bytes.last_chunk_mut() {
        fill_chunk::<16>(last, word);
        if let Some(first) = bytes.first_chunk_mut() {
            fill_chunk::<16>(first, word);
        }
    } else if let Some(last) = bytes.last_chunk_mut() {
        fill_chunk::<8>(last, word);
        if let Some(first) = bytes.first_chunk_mut() {
            fill_chunk::<8>(first, word);
        }
    } else if let Some(last) = bytes.last_chunk_mut() {
        *last = word.to_ne_bytes();
        if let Some(first) = bytes.first_chunk_mut() {
            *first = word.to_ne_bytes();
        }
    } else {
        let [a, b, c, _] = word.to_ne_bytes();
        match bytes {
            [first] => *first = a,
            [first, second] => [*first, *second] = [a, b],
            [first, second, third] => [*first, *second, *third] = [a, b, c],
            _ => {}
        }
    }
}

#[inline(always)]
fn fill_chunk<const N: usize>(bytes: &mut [u8; N], word: u32) {
    for four in bytes.as_chunks_mut().0 {
        *four = word.to_ne_bytes();
    }
}

/// More than 32 bytes: the last 16, and all before by 128 and by 16.
#[inline(always)]
fn fill_long(bytes: &mut [u8], word: u32) {
    if let Some(last) = bytes.last_chunk_mut() {
        fill_chunk::<16>(last, word);
    }
    let (many, rest) = bytes.as_chunks_mut::<128>();
    for piece in many {
        fill_chunk(piece, word);
    }
    for piece in rest.as_chunks_mut::<16>().0 {
        black_box(());
        fill_chunk(piece, word);
    }
}

/// Fills with a pattern of three bytes; as many bytes as three times any number.
#[inline(always)]
pub(super) fn fill_threes(bytes: &mut [u8], [a, b, c]: [u8; 3]) {
    let twelve = [a, b, c, a, b, c, a, b, c, a, b, c];
    if let Some(last) = bytes.last_chunk_mut() {
        *last = twelve;
        for piece in bytes.as_chunks_mut().0 {
            *piece = twelve;
        }
    } else {
        for pixel in bytes.as_chunks_mut().0 {
            *pixel = [a, b, c];
        }
    }
}

/// Fills the bits of a mask in every byte, which `word` holds four times.
#[inline(always)]
pub(super) fn fill_masked(bytes: &mut [u8], mask: u8, word: u32) {
    if mask == 0xFF {
        return fill(bytes, word);
    }
    let masks = u32::from_ne_bytes([mask; 4]);
    let word = word & masks;
    let (fours, rest) = bytes.as_chunks_mut();
    for four in fours {
        *four = (u32::from_ne_bytes(*four) & !masks | word).to_ne_bytes();
    }
    let [byte, ..] = word.to_ne_bytes();
    for left in rest {
        *left = *left & !mask | byte;
    }
}
