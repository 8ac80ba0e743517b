//! Spheres within spheres, in 13 bits.

/// A sphere in space, in units of the model's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Sphere {
    /// x, y and z.
    pub centre: [i32; 3],
    /// At most 2^26.
    pub radius: i32,
}

/// How many codes there are.
pub const SPHERE_CODES: u16 = CODES.1;

/// A code's radius and its places along the axes, four bits each.
static TABLE: [u16; 8192] = CODES.0;

const CODES: ([u16; 8192], u16) = codes();
const _: () = assert!(SPHERE_CODES == 7621);

/// Spheres of radius `k/13` at places `(k + 2i)/13 - 1`, for `i` in `0..=13 - k`, that can meet the parent's surface or inside:
/// `|c| <= 1 + sqrt 3 R`.
#[allow(clippy::indexing_slicing, reason = "run by the compiler, which would fail")]
const fn codes() -> ([u16; 8192], u16) {
    let mut table = [0; 8192];
    let mut count = 0_u16;
    let mut k = 1_i32;
    while k <= 13 {
        let side = 14 - k;
        let mut index = 0;
        while index < side * side * side {
            let (x, y, z) = (index / (side * side), index / side % side, index % side);
            let (cx, cy, cz) = (k + 2 * x - 13, k + 2 * y - 13, k + 2 * z - 13);
            // `|c|^2 <= (13 + sqrt 3 k)^2`, without a root.
            let beyond = cx * cx + cy * cy + cz * cz - 169 - 3 * k * k;
            if beyond <= 0 || beyond * beyond <= 26 * 26 * 3 * k * k {
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "13 at most, each")]
                let entry = (k << 12 | x << 8 | y << 4 | z) as u16;
                table[count as usize] = entry;
                count += 1;
            }
            index += 1;
        }
        k += 1;
    }
    (table, count)
}

impl Sphere {
    /// The sphere that a code says within this one; none for a code that says nothing.
    ///
    /// Its radius is `k/13` of this one's, its centre at `(k + 2i)/13 - 1` of it along each axis:
    ///
    /// ```text
    ///   k 5      [#####        ]   i 0
    ///            [ #####       ]   i 1
    ///            [        #####]   i 8
    /// ```
    #[inline]
    pub fn child(&self, code: u16) -> Option<Self> {
        if code >= SPHERE_CODES {
            return None;
        }
        let entry = i32::from(*TABLE.get(usize::from(code))?);
        let k = entry >> 12;
        let radius = self.radius;
        let place = |centre: i32, i: i32| centre.wrapping_add((k + 2 * (i & 15) - 13).wrapping_mul(radius) / 13);
        let [x, y, z] = self.centre;
        let centre = [place(x, entry >> 8), place(y, entry >> 4), place(z, entry)];
        Some(Self { centre, radius: k.wrapping_mul(radius) / 13 })
    }

    /// The code of a small sphere within this one that encloses another, which must lie within this one.
    ///
    /// For what builds models.
    pub fn encode(&self, inner: &Self) -> Option<u16> {
        let encloses = |outer: &Self| {
            let slack = i64::from(outer.radius) - i64::from(inner.radius);
            let mut square = 0;
            for (a, b) in outer.centre.iter().zip(inner.centre) {
                square += (i64::from(*a) - i64::from(b)).pow(2);
            }
            slack >= 0 && square <= slack * slack
        };
        // Codes are in the order of radii; for each, only the nearest places can be the best.
        let mut code = 0;
        while code < SPHERE_CODES {
            let k = TABLE.get(usize::from(code)).copied()? >> 12;
            let rest = TABLE.get(usize::from(code)..usize::from(SPHERE_CODES))?;
            let next = code + u16::try_from(rest.partition_point(|entry| entry >> 12 <= k)).ok()?;
            if i64::from(k) * i64::from(self.radius) >= 13 * i64::from(inner.radius) {
                let k = i32::from(k);
                let mut entry = k << 12;
                for (shift, (outer, inner)) in [8, 4, 0].into_iter().zip(self.centre.iter().zip(inner.centre)) {
                    let offset = i64::from(inner) - i64::from(*outer);
                    // `i = ((offset / radius + 1) 13 - k) / 2`, to the nearest.
                    let radius = i64::from(self.radius.max(1));
                    let i = (26 * offset + (26 - 2 * i64::from(k) + 2) * radius).div_euclid(4 * radius);
                    let last = i64::from(13 - k);
                    entry |= i32::try_from(if i < 0 { 0 } else { i.min(last) }).ok()? << shift;
                }
                let entry = u16::try_from(entry).ok()?;
                let same = TABLE.get(usize::from(code)..usize::from(next))?;
                if let Ok(index) = same.binary_search(&entry) {
                    let code = code + u16::try_from(index).ok()?;
                    if self.child(code).is_some_and(|sphere| encloses(&sphere)) {
                        return Some(code);
                    }
                }
            }
            code = next;
        }
        None
    }
}
