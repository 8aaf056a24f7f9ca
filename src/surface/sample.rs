//! Random points, uniform by area on the surface or by volume in the solid.

use nalgebra::Vector3;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::math::GammaVariate;
use crate::shape::{Superellipsoid, superellipse_norm};

/// `count` independent points of the surface, uniform by area, in the model's frame; the same
/// for the same seed.
///
/// Of the cones from the centre to patches of the surface, volume and area are in the ratio
/// `dV / dA = x . n / 3 = 1 / (3 |grad H|)`, with H the gauge. So the radial projection of a
/// uniform point of the solid is kept with a probability proportional to `|grad H|`; more than
/// one in six are. Domain: exponents up to 2, beyond which `|grad H|` has no bound and points
/// next to cusps are drawn too rarely.
pub fn sample_surface(shape: &Superellipsoid, count: usize, seed: u64) -> Vec<Vector3<f64>> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    // In units of its greatest semi-axis no shape's slopes overflow or vanish.
    let unit = shape.size().into_iter().fold(0.0, f64::max);
    let shape = shape.scaled(unit.recip());
    let cone = ConeMeasure::new(&shape);
    let bound = greatest_slope(&shape);
    let mut draw = || loop {
        let x = cone.draw(&mut rng);
        let is_refused = rng.random::<f64>() * bound > shape.gauge_gradient(&x).norm();
        if !is_refused {
            return x * unit;
        }
    };
    (0..count).map(|_| draw()).collect()
}

/// `count` independent points of the solid, uniform by volume, in the model's frame; the same
/// for the same seed.
pub fn sample_solid(shape: &Superellipsoid, count: usize, seed: u64) -> Vec<Vector3<f64>> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let cone = ConeMeasure::new(shape);
    (0..count).map(|_| cone.draw(&mut rng) * rng.random::<f64>().cbrt()).collect()
}

/// A bound on `|grad H|`, which is one over the distance of a tangent plane from the centre: no
/// plane that touches a solid passes through a body in it.
///
/// That body is the ellipsoid of the semi-axes for exponents up to 1, and the octahedron up to
/// 2.
fn greatest_slope(shape: &Superellipsoid) -> f64 {
    let inverse = Vector3::from(shape.size().map(|a| 1.0 / a));
    let holds_ellipsoid = shape.exponents().iter().all(|&e| e <= 1.0);
    if holds_ellipsoid { inverse.max() } else { inverse.norm() }
}

/// The distribution on the surface by the volume of cones from the centre.
///
/// Powers of gamma variates, `x = G^(e/2)` with G of shape parameter e/2, have joint densities
/// that depend on `x^(2/e) + y^(2/e)` alone; what remains is in the ratio of uniform points
/// (Barthe, Guedon, Mendelson and Naor 2005). The superellipsoid nests two such norms, the outer
/// one of a radius, with its Jacobian, and a height: shape parameters e1 and e1/2.
struct ConeMeasure<'a> {
    shape: &'a Superellipsoid,
    equator: GammaPower,
    radius: GammaPower,
    height: GammaPower,
}

impl<'a> ConeMeasure<'a> {
    fn new(shape: &'a Superellipsoid) -> Self {
        let [e1, e2] = shape.exponents();
        Self {
            shape,
            equator: GammaPower::new(0.5 * e2, 0.5 * e2),
            radius: GammaPower::new(e1, 0.5 * e1),
            height: GammaPower::new(0.5 * e1, 0.5 * e1),
        }
    }

    /// A point of the surface.
    fn draw(&self, rng: &mut impl Rng) -> Vector3<f64> {
        let e2 = self.shape.exponents()[1];
        let [x, y] = [(); 2].map(|()| self.equator.draw(rng));
        let scale = self.radius.draw(rng) / superellipse_norm(x, y, e2);
        let direction = Vector3::new(x * scale, y * scale, self.height.draw(rng));
        let size = Vector3::from(self.shape.size());
        let signed = direction.component_mul(&size).map(|c| if rng.random() { c } else { -c });
        self.shape.radial_projection(&signed)
    }
}

/// The power `G^p` of a gamma variate of shape parameter k, drawn without underflow as
/// `U^(p/k) G'^p`, with U uniform and G' of shape parameter k + 1.
struct GammaPower {
    gamma: GammaVariate,
    power: f64,
    uniform_power: f64,
}

impl GammaPower {
    fn new(k: f64, power: f64) -> Self {
        Self { gamma: GammaVariate::new(k + 1.0), power, uniform_power: power / k }
    }

    /// A positive number.
    fn draw(&self, rng: &mut impl Rng) -> f64 {
        let uniform = 1.0 - rng.random::<f64>();
        uniform.powf(self.uniform_power) * self.gamma.draw(rng).powf(self.power)
    }
}

#[cfg(test)]
mod tests;
