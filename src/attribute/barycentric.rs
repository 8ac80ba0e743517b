//! Barycentric coordinates of a point, exactly.

use crate::{Triangle, Vertex};

/// A triangle to be asked about points.
///
/// Any coordinates; the answers are exact. The weights of a point are the areas of the triangles that it makes with
/// the sides, each over the area of the whole:
///
/// ```text
///        a
///       /|\        weight of a = area (p, b, c) / area (a, b, c)
///      / p \       at a itself 1, on the side bc 0, beyond it negative
///     b-----c
/// ```
///
/// # Cost
///
/// Six multiplications of 64 bits a point. No division.
///
/// # Examples
///
/// ```
/// use spanfill::{Barycentric, Triangle, Vertex};
///
/// let triangle = Triangle::new(Vertex::new(0, 0), Vertex::new(8, 0), Vertex::new(0, 8));
/// let triangle = Barycentric::new(&triangle).unwrap();
/// let weights = triangle.weights_at(Vertex::new(2, 4));
/// // 1/4, 1/4 and 1/2.
/// assert_eq!(weights.numerators.map(|n| 4 * n / weights.denominator), [1, 1, 2]);
/// assert_eq!(weights.mix([100, 200, 300]), 225);
/// assert!(triangle.contains(Vertex::new(2, 4)));
/// // A corner belongs to whoever lies to its right and below.
/// assert!(triangle.contains(Vertex::new(0, 0)) && !triangle.contains(Vertex::new(8, 0)));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Barycentric {
    vertices: [Vertex; 3],
    /// Twice the area, with the sign that makes it positive for the vertices in this order.
    area: i128,
}

/// The weights of a point: a numerator for each vertex, over one denominator. They add up to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Weights {
    /// For each vertex; negative where the point is beyond the opposite side.
    pub numerators: [i128; 3],
    /// Positive.
    pub denominator: i128,
}

impl Barycentric {
    /// None for a triangle without area.
    pub fn new(triangle: &Triangle) -> Option<Self> {
        let [a, b, c] = triangle.vertices;
        let area = cross(a, b, c);
        (area != 0).then_some(Self { vertices: [a, b, c], area })
    }

    /// Whether the triangle has the point, by the rule for pixel centres: on an outline, whatever lies to the right of
    /// it, or, on a horizontal one, below, has it.
    pub fn contains(&self, point: Vertex) -> bool {
        let [a, b, c] = self.vertices;
        let positive = self.area > 0;
        [(a, b), (b, c), (c, a)].into_iter().all(|(from, to)| {
            let (from, to) = if positive { (from, to) } else { (to, from) };
            match cross(from, to, point) {
                0 => {
                    // The value a step (+e, +e^2) further: of -dy e + dx e^2.
                    let (dx, dy) = (to.x.cmp(&from.x), to.y.cmp(&from.y));
                    dy.is_lt() || (dy.is_eq() && dx.is_gt())
                }
                distance => distance > 0,
            }
        })
    }

    /// The weights of a point, inside or outside.
    pub fn weights_at(&self, point: Vertex) -> Weights {
        let [a, b, c] = self.vertices;
        let sign = self.area.signum();
        let numerators = [cross(b, c, point), cross(c, a, point), cross(a, b, point)].map(|area| sign * area);
        Weights { numerators, denominator: sign * self.area }
    }
}

impl Weights {
    /// Whether the point is in the triangle or on its outline.
    pub fn are_inside(&self) -> bool {
        self.numerators.iter().all(|numerator| *numerator >= 0)
    }

    /// What the values of the vertices make at the point, to the nearest, halves upwards; outside, at the ends of
    /// `i32` at most.
    pub fn mix(&self, values: [i32; 3]) -> i32 {
        let [a, b, c] = self.numerators;
        let [va, vb, vc] = values.map(i128::from);
        let denominator = self.denominator.max(1);
        let doubled = 2 * (a * va + b * vb + c * vc) + denominator;
        let rounded = doubled.div_euclid(2 * denominator);
        i32::try_from(rounded).unwrap_or(if rounded > 0 { i32::MAX } else { i32::MIN })
    }
}

/// Twice the area of a triangle; positive where it turns clockwise on the screen. At most 2^65.
fn cross(a: Vertex, b: Vertex, c: Vertex) -> i128 {
    let coordinate = |bits: i32| i128::from(bits);
    let (ax, ay) = (coordinate(a.x.to_bits()), coordinate(a.y.to_bits()));
    let (bx, by) = (coordinate(b.x.to_bits()), coordinate(b.y.to_bits()));
    let (cx, cy) = (coordinate(c.x.to_bits()), coordinate(c.y.to_bits()));
    (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
}
