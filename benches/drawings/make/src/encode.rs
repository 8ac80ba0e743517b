//! The format that `benches/drawings/mod.rs` describes and reads.

use crate::outline::Shape;

pub(crate) fn encode(shapes: &[Shape]) -> Vec<u8> {
    let mut bytes = b"DRW1".to_vec();
    for Shape { rgb, even_odd, contours } in shapes {
        let mut body = rgb.to_vec();
        body.push(u8::from(*even_odd));
        for contour in contours {
            put_contour(&mut body, contour);
        }
        put_number(&mut bytes, body.len() as u32);
        bytes.extend(body);
    }
    bytes
}

fn put_contour(bytes: &mut Vec<u8>, contour: &[[i32; 2]]) {
    let mut steps = Vec::new();
    let [mut x, mut y] = [0, 0];
    for &[next_x, next_y] in contour {
        put_signed(&mut steps, next_x - x);
        put_signed(&mut steps, next_y - y);
        [x, y] = [next_x, next_y];
    }
    put_number(bytes, contour.len() as u32);
    put_number(bytes, steps.len() as u32);
    bytes.extend(steps);
}

/// Zigzag: 0, -1, 1, -2, ... become 0, 1, 2, 3, ...
fn put_signed(bytes: &mut Vec<u8>, value: i32) {
    put_number(bytes, ((value << 1) ^ (value >> 31)) as u32);
}

/// LEB128: seven bits a byte, the lowest first; the eighth says that there are more.
fn put_number(bytes: &mut Vec<u8>, mut value: u32) {
    while value >= 0x80 {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8);
}
