//! Curvatures (B81): of a parametric surface by its fundamental forms, and of a level surface by
//! the derivatives of its function.

use nalgebra::{Matrix2, Matrix3, Vector3};

use super::parametric::Parametric;

/// The first and second fundamental forms of a surface (B81).
///
/// A curve `(eta(t), omega(t))` on it has the squared speed `E eta'^2 + 2 F eta' omega' + G
/// omega'^2`, and its normal curvature is `D eta'^2 + 2 D1 eta' omega' + D2 omega'^2` over that.
/// Curvatures are positive where the surface bends away from the outward normal, as a sphere does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FundamentalForms {
    /// `[E, F, G]`, in squares of the unit of length.
    pub first: [f64; 3],
    /// `[D, D1, D2]`, in the unit of length.
    pub second: [f64; 3],
}

impl FundamentalForms {
    /// Those of a surface at a latitude and longitude. Domain: where both tangents are finite and
    /// not parallel.
    pub fn at(surface: &impl Parametric, eta: f64, omega: f64) -> Self {
        let [r_eta, r_omega] = surface.tangents(eta, omega);
        let inward = -surface.normal(eta, omega);
        Self {
            first: [r_eta.norm_squared(), r_eta.dot(&r_omega), r_omega.norm_squared()],
            second: surface.second_derivatives(eta, omega).map(|r| inward.dot(&r)),
        }
    }

    /// The normal curvature of curves in the direction `[eta', omega']`, in one over the unit of
    /// length.
    pub fn normal_curvature(&self, direction: [f64; 2]) -> f64 {
        let quadratic = |[a, b, c]: [f64; 3]| {
            let [eta, omega] = direction;
            a * eta * eta + 2.0 * b * eta * omega + c * omega * omega
        };
        quadratic(self.second) / quadratic(self.first)
    }

    /// The principal curvatures.
    pub fn curvatures(&self) -> Curvatures {
        let [e, f, g] = self.first;
        // An orthonormal basis of the tangent plane: along r_eta, and across.
        let across = (g - f * f / e).sqrt();
        let along = e.sqrt();
        let [d, d1, d2] = self.second;
        let tilt = f / e;
        let [straight, mixed, cross] = [
            d / e,
            (d1 - tilt * d) / (along * across),
            (d2 - 2.0 * tilt * d1 + tilt * tilt * d) / (across * across),
        ];
        Curvatures::of_shape_operator(&Matrix2::new(straight, mixed, mixed, cross))
    }
}

/// The principal curvatures of a surface at a point, in one over the unit of length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curvatures {
    /// The greater and the lesser.
    pub principal: [f64; 2],
}

impl Curvatures {
    /// Those of the level surface of a function with this gradient, which points outwards, and
    /// these second derivatives: the eigenvalues of the Hessian on the tangent plane over the
    /// length of the gradient. NaN where the gradient vanishes.
    pub fn of_level_surface(gradient: &Vector3<f64>, hessian: &Matrix3<f64>) -> Self {
        let normal = gradient.normalize();
        let helper = Vector3::ith(normal.iamin(), 1.0);
        let u = normal.cross(&helper).normalize();
        let v = normal.cross(&u);
        let on_plane = |a: &Vector3<f64>, b: &Vector3<f64>| a.dot(&(hessian * b)) / gradient.norm();
        let mixed = on_plane(&u, &v);
        Self::of_shape_operator(&Matrix2::new(on_plane(&u, &u), mixed, mixed, on_plane(&v, &v)))
    }

    /// Eigenvalues of a symmetric matrix.
    fn of_shape_operator(operator: &Matrix2<f64>) -> Self {
        let mean = 0.5 * operator.trace();
        let spread = (0.5 * (operator[(0, 0)] - operator[(1, 1)])).hypot(operator[(0, 1)]);
        Self { principal: [mean + spread, mean - spread] }
    }

    /// The product of the principal curvatures.
    pub fn gaussian(&self) -> f64 {
        self.principal[0] * self.principal[1]
    }

    /// Half of the sum of the principal curvatures.
    pub fn mean(&self) -> f64 {
        0.5 * (self.principal[0] + self.principal[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{Superellipsoid, Supertoroid};

    #[test]
    fn an_ellipsoid_has_its_closed_forms_at_the_ends_of_its_axes() {
        let ellipsoid = Superellipsoid::new([3.0, 2.0, 1.5], [1.0, 1.0]).unwrap();
        let forms = FundamentalForms::at(&ellipsoid, 0.0, 0.0);
        // At (a, 0, 0): a/b^2 and a/c^2.
        let [greater, lesser] = forms.curvatures().principal;
        assert!((greater - 3.0 / 2.25).abs() < 1e-14 && (lesser - 0.75).abs() < 1e-14);
        assert!((forms.normal_curvature([1.0, 0.0]) - greater).abs() < 1e-14);
        assert!((forms.normal_curvature([0.0, -2.0]) - lesser).abs() < 1e-14);
    }

    #[test]
    fn a_torus_is_a_saddle_inside_and_a_dome_outside() {
        // Tube of radius 1 at radius 3.
        let torus = Supertoroid::new([1.0; 3], [1.0, 1.0], 3.0).unwrap();
        for eta in [-3.0_f64, -1.0, 0.0, 0.7, 2.5] {
            let curvatures = FundamentalForms::at(&torus, eta, 0.4).curvatures();
            let around = eta.cos() / (3.0 + eta.cos());
            assert!((curvatures.gaussian() - around).abs() < 1e-14);
            assert!((curvatures.mean() - 0.5 * (1.0 + around)).abs() < 1e-14);
        }
    }
}
