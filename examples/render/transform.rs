//! What a transform does to lengths.

use kurbo::Affine;

/// A transform of usvg in double precision.
pub(crate) fn affine(transform: usvg::Transform) -> Affine {
    let usvg::Transform { sx, ky, kx, sy, tx, ty } = transform;
    Affine::new([sx, ky, kx, sy, tx, ty].map(f64::from))
}

/// Half the axes of the ellipse that the unit circle becomes, the longer one first: the greatest and the least
/// factor that a length is multiplied by.
pub(crate) fn stretches(transform: Affine) -> (f64, f64) {
    let [a, b, c, d, _, _] = transform.as_coeffs();
    // A linear map of the plane is a similarity plus a mirrored similarity (in complex numbers, z -> pz + q*conj(z)):
    // where both pull the same way lengths grow by |p| + |q|, across that by their difference.
    let turning = (a + d).hypot(b - c) / 2.0;
    let mirroring = (a - d).hypot(b + c) / 2.0;
    (turning + mirroring, (turning - mirroring).abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stretches_are_those_of_the_axes_however_turned() {
        let squeeze = Affine::rotate(0.3) * Affine::scale_non_uniform(-5.0, 2.0) * Affine::rotate(1.1);
        let (long, short) = stretches(squeeze);
        assert!((long - 5.0).abs() < 1e-12 && (short - 2.0).abs() < 1e-12, "{long} {short}");
        assert_eq!(stretches(Affine::translate((7.0, 8.0))), (1.0, 1.0));
        assert_eq!(stretches(Affine::new([1.0, 2.0, 2.0, 4.0, 0.0, 0.0])), (5.0, 0.0));
    }
}
