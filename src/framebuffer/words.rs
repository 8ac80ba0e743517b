//! Filling bytes by whole words.
//!
//! A word here is four bytes that begin anywhere: one store where the processor allows that, four where it does not.

/// Fills with a pattern of one, two or four bytes, of which `word` holds as many as it has room for. As many bytes as the
/// pattern's length times any number.
///
/// Short and long alike, without a loop over what is left: the last sixteen bytes (below that the last eight or four) are
/// written first, and what follows may overlap them.
///
/// ```text
///   bytes     |----------------------------------------------|
///   sixteens  [--------------][--------------]
///   last                                  [------------------]
/// ```
#[inline(always)]
pub(super) fn fill(bytes: &mut [u8], word: u32) {
    if let Some(last) = bytes.last_chunk_mut() {
        fill_sixteen(last, word);
        fill_sixteens(bytes, word);
    } else if let Some(last) = bytes.last_chunk_mut() {
        fill_eight(last, word);
        if let Some(first) = bytes.first_chunk_mut() {
            fill_eight(first, word);
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
fn fill_eight(bytes: &mut [u8; 8], word: u32) {
    for four in bytes.as_chunks_mut().0 {
        *four = word.to_ne_bytes();
    }
}

#[inline(always)]
fn fill_sixteen(bytes: &mut [u8; 16], word: u32) {
    for four in bytes.as_chunks_mut().0 {
        *four = word.to_ne_bytes();
    }
}

/// All sixteens from the start on; out of line for all that is long, where it makes no difference, and once in a program.
#[inline(always)]
fn fill_sixteens(bytes: &mut [u8], word: u32) {
    let (many, rest) = bytes.as_chunks_mut::<128>();
    for piece in many {
        for sixteen in piece.as_chunks_mut().0 {
            fill_sixteen(sixteen, word);
        }
    }
    for sixteen in rest.as_chunks_mut().0 {
        core::hint::black_box(());
        fill_sixteen(sixteen, word);
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
