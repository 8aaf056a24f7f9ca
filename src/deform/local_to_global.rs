//! Deformations that are known by their Jacobian only (B84 section 3; B81's angle-preserving
//! transformations).

use nalgebra::{Matrix3, Vector3};

use crate::math::{VectorIntegral, integrate};

/// Share of the step's fourth power that remains of a difference quotient's error: the step is
/// the root of the rounding error, in units of the length that a field varies over.
const STEP: f64 = 1e-3;

/// The curve into which a curve of tangent `x'(s)` is deformed by a Jacobian, at some stations:
/// `X(s) = X(s0) + int J(s) x'(s) ds` (B84 Eq. 3.1b).
///
/// `start` is the image of the first station; the error of every part between two stations is no
/// more than `tolerance`, unless the Jacobian has a pole.
pub fn deformed_curve(
    jacobian: impl Fn(f64) -> Matrix3<f64>,
    tangent: impl Fn(f64) -> Vector3<f64>,
    start: Vector3<f64>,
    stations: &[f64],
    tolerance: f64,
) -> Vec<Vector3<f64>> {
    let mut position = start;
    let parts = stations.windows(2).map(|ends| {
        let part = integrate(|s| jacobian(s) * tangent(s), [ends[0], ends[1]], tolerance);
        position += part.value;
        position
    });
    stations.first().map(|_| start).into_iter().chain(parts).collect()
}

/// A field of Jacobians over space, from which surfaces and solids are deformed by integration
/// along paths (B84 section 3.2).
///
/// Where the field is a Jacobian, the image of a point does not depend on the path; how far it is
/// from one is told by [`violation`](Self::violation).
#[derive(Debug, Clone)]
pub struct JacobianField<F> {
    jacobian: F,
    origin: Vector3<f64>,
    image: Vector3<f64>,
    tolerance: f64,
}

impl<F: Fn(&Vector3<f64>) -> Matrix3<f64>> JacobianField<F> {
    /// The field of a matrix at every point. `image` is where `origin` comes to, `tolerance` the
    /// error that an integral may have, in the unit of length.
    pub fn new(jacobian: F, origin: Vector3<f64>, image: Vector3<f64>, tolerance: f64) -> Self {
        Self { jacobian, origin, image, tolerance }
    }

    /// The image of a point, along the straight path from the origin, and a bound on its error.
    pub fn deformed(&self, x: &Vector3<f64>) -> VectorIntegral {
        self.deformed_along(&[*x])
    }

    /// The image of the last of some points, along the straight parts from the origin through
    /// them (B84 Eq. 3.2.1), and a bound on its error.
    pub fn deformed_along(&self, path: &[Vector3<f64>]) -> VectorIntegral {
        let mut image = VectorIntegral { value: self.image, error: 0.0 };
        let mut from = self.origin;
        for to in path {
            let part = self.along(&from, to, self.tolerance / path.len() as f64);
            image.value += part.value;
            image.error += part.error;
            from = *to;
        }
        image
    }

    /// How far the field is from a Jacobian at a point: the greatest length of `J_i,j - J_j,i`
    /// (B84 Eq. 3.2.2), in one over the unit of length; 0 for a Jacobian.
    ///
    /// By difference quotients of fourth order; `scale` is a length over which the field varies
    /// smoothly. For a rotation field with the angles' rates below lambda it is of order lambda
    /// (B81), and the images by two paths differ by no more than it times the area between.
    pub fn violation(&self, x: &Vector3<f64>, scale: f64) -> f64 {
        let slopes = [0, 1, 2].map(|axis| self.slope(x, axis, STEP * scale));
        let difference = |i: usize, j: usize| (slopes[j].column(i) - slopes[i].column(j)).norm();
        difference(0, 1).max(difference(0, 2)).max(difference(1, 2))
    }

    fn along(&self, from: &Vector3<f64>, to: &Vector3<f64>, tolerance: f64) -> VectorIntegral {
        let step = to - from;
        integrate(|t| (self.jacobian)(&(from + t * step)) * step, [0.0, 1.0], tolerance)
    }

    /// The derivative of the field along an axis.
    fn slope(&self, x: &Vector3<f64>, axis: usize, step: f64) -> Matrix3<f64> {
        let at = |steps: f64| (self.jacobian)(&(x + Vector3::ith(axis, steps * step)));
        (8.0 * (at(1.0) - at(-1.0)) - (at(2.0) - at(-2.0))) / (12.0 * step)
    }
}

/// B81's rotation of ZXZ Euler angles `[phi1, phi2, phi3]`, in radians:
/// `M = Rz(phi3) Rx(phi2) Rz(phi1)`; its columns are the tangent T and the two normals N1, N2 of
/// the transformation.
pub fn zxz_rotation([phi1, phi2, phi3]: [f64; 3]) -> Matrix3<f64> {
    rotation_z(phi3) * rotation_x(phi2) * rotation_z(phi1)
}

/// B81's Omega: the angular velocity of the frame `[T, N1, N2]` in its own axes, bending in three
/// perpendicular planes, from the ZXZ angles and their rates by arc length.
///
/// `Omega1 = N2 . N1'`, `Omega2 = T . N2'`, `Omega3 = N1 . T'`; the three expressions that B81
/// prints for ZXZ angles are the negative of the velocity in fixed axes.
pub fn zxz_curvatures([phi1, phi2, _]: [f64; 3], rates: [f64; 3]) -> Vector3<f64> {
    let (s1, c1) = phi1.sin_cos();
    let (s2, c2) = phi2.sin_cos();
    let [rate1, rate2, rate3] = rates;
    Vector3::new(s1 * s2 * rate3 + c1 * rate2, c1 * s2 * rate3 - s1 * rate2, rate1 + c2 * rate3)
}

/// The curvature `sqrt(Omega2^2 + Omega3^2)` of the curve along T (B81).
pub fn curve_curvature(curvatures: &Vector3<f64>) -> f64 {
    curvatures.y.hypot(curvatures.z)
}

fn rotation_z(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0)
}

fn rotation_x(angle: f64) -> Matrix3<f64> {
    let (s, c) = angle.sin_cos();
    Matrix3::new(1.0, 0.0, 0.0, 0.0, c, -s, 0.0, s, c)
}

#[cfg(test)]
mod tests;
