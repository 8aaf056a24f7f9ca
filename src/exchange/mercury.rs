//! MercuryDPM: the particles of a restart file.
//!
//! Semi-axes, `exp1 = e1`, `exp2 = e2`, which it asserts to be at most 1; quaternions are w x y z.

use super::error::ImportError;
use super::line::{Line, lines};
use super::particle::{Particle, quaternion_wxyz, spaced};
use crate::model::Model;
use crate::shape::{Superellipsoid, superellipse_norm};

pub(super) const EXPECTED: &str = "lines `SuperQuadricParticle .. position .. orientation .. \
                                   axes .. exp1 .. exp2 ..`";

const NAME: &str = "SuperQuadricParticle";

/// Domain: exponents up to 1.
pub(super) fn write(model: &Model) -> String {
    let [e1, e2] = model.shape.exponents();
    format!(
        "Particles 1\n\
         {NAME} id 0 indSpecies 0 position {} orientation {} velocity 0 0 0 \
         angularVelocity 0 0 0 force 0 0 0 torque 0 0 0 radius {:?} invMass {:?} axes {} \
         exp1 {e1:?} exp2 {e2:?}\n",
        spaced(model.pose.translation().as_slice()),
        spaced(&quaternion_wxyz(model)),
        circumscribed_radius(&model.shape),
        model.shape.volume().recip(),
        spaced(&model.shape.size()),
    )
}

/// Radius of the least sphere about the centre that holds the solid, which MercuryDPM reads and
/// does not calculate: by Hoelder's inequality for the squares of the coordinates.
///
/// Domain: exponents up to 1.
fn circumscribed_radius(shape: &Superellipsoid) -> f64 {
    let [a1, a2, a3] = shape.size();
    let [e1, e2] = shape.exponents();
    superellipse_norm(superellipse_norm(a1, a2, 1.0 - e2), a3, 1.0 - e1)
}

pub(super) fn read(text: &str) -> Result<Vec<Model>, ImportError> {
    lines(text, '#').filter(|line| line.words[0] == NAME).map(|line| particle(&line)).collect()
}

fn particle(line: &Line<'_>) -> Result<Model, ImportError> {
    let particle = Particle {
        semi_axes: required(line, "axes")?,
        exponents: [required(line, "exp1").map(first)?, required(line, "exp2").map(first)?],
        quaternion_wxyz: required(line, "orientation")?,
        centre: required(line, "position")?,
    };
    particle.model(line)
}

fn first([number]: [f64; 1]) -> f64 {
    number
}

fn required<const N: usize>(line: &Line<'_>, keyword: &str) -> Result<[f64; N], ImportError> {
    line.after(keyword)?.ok_or_else(|| line.unexpected(usize::MAX, keyword))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_circumscribed_sphere_holds_the_surface_and_touches_it() {
        let sizes = [[1.0, 1.0, 1.0], [1.0, 2.0, 3.0], [3.0, 1.0, 0.03]];
        let exponents = [[0.1, 0.1], [0.3, 1.0], [1.0, 0.2], [0.99, 0.5], [1.0, 1.0]];
        for (size, exponents) in sizes.into_iter().flat_map(|s| exponents.map(|e| (s, e))) {
            let shape = Superellipsoid::new(size, exponents).unwrap();
            let radius = circumscribed_radius(&shape);
            let steps = || (0..=400).map(|i| f64::from(i) / 400.0 * std::f64::consts::FRAC_PI_2);
            let farthest = steps()
                .flat_map(|eta| steps().map(move |omega| (eta, omega)))
                .map(|(eta, omega)| shape.position(eta, omega).norm())
                .fold(0.0, f64::max);
            assert!(farthest <= radius * (1.0 + 1e-12), "{shape:?}: {farthest} {radius}");
            // Half a step of 0.004 off the top loses its square, times the exponents' bend.
            assert!(farthest > radius * (1.0 - 1e-3), "{shape:?}: {farthest} {radius}");
        }
    }
}
