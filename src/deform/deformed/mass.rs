//! Volume, inertia and surface area of a deformed shape, by quadrature over its surface.

use std::cell::Cell;

use nalgebra::{Matrix3, SVector, Vector3};
use rayon::prelude::*;

use super::Deformed;
use crate::deform::crease::Creases;
use crate::deform::map::Deform;
use crate::math::{VectorIntegral, increasing_root, integrate};
use crate::shape::{MassProperties, Patch, Patched};

/// Pieces that each parameter's range is cut into to begin with.
const PIECES: usize = 4;

/// Places along a line between which creases are looked for.
const PROBES: usize = 24;

/// Share of the tolerance that is left to integrals along one parameter.
const INNER_SHARE: f64 = 0.1;

/// Volume, first and second moments about a point of the solid, and surface area.
type Integrals = SVector<f64, 11>;

/// The masses of a deformed shape, and how far they have converged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassEstimate {
    /// Volume, centroid and second moments of unit density.
    pub properties: MassProperties,
    /// Area of the surface.
    pub surface_area: f64,
    /// A bound on the errors of volume, area and first and second moments, in units of the volume
    /// and of the area, and of powers of a length where there is one, the root of the area: what
    /// two rules of quadrature differ by, which is far above the true error where the
    /// deformations are smooth.
    pub error: f64,
}

impl<S: Patched> Deformed<S> {
    /// The masses, to a relative tolerance, 1e-6 say: by Gauss's and Kronrod's rules along both
    /// parameters of the surface, whose pieces are halved where they differ. Along each line they
    /// end where a bend ends or a profile has a knot.
    ///
    /// By the divergence theorem, with the vector area elements carried along by the normal
    /// transform: `V = 1/3 int X . N dA`, and likewise for `x_i` and `x_i x_j`.
    pub fn mass_estimate(&self, tolerance: f64) -> MassEstimate {
        let origin = Vector3::from(self.chain.forward_of([0.0; 3]));
        let patches = self.shape.patches();
        let integral = |units: &Integrals, tolerance: f64| {
            let share = tolerance / patches.len() as f64;
            let over = |patch: &Patch| self.over(patch, &origin, units, share);
            // Added up in their order, so that results do not depend on the threads.
            let parts: Vec<VectorIntegral<11>> = patches.par_iter().map(over).collect();
            let value: Integrals = parts.iter().map(|part| part.value).sum();
            (value, parts.iter().map(|part| part.error).sum())
        };
        let (rough, _) = integral(&Integrals::from_element(1.0), f64::INFINITY);
        let units = units(&rough);
        let (sums, error) = integral(&units, tolerance);
        let sums = sums.component_mul(&units);
        let properties = properties(&sums).moved(&origin);
        MassEstimate { properties, surface_area: sums[10], error }
    }

    /// The integrals over a patch, in some units.
    fn over(
        &self,
        patch: &Patch,
        origin: &Vector3<f64>,
        units: &Integrals,
        tolerance: f64,
    ) -> VectorIntegral<11> {
        let [range, inner_range] = patch.ranges();
        let length = range[1] - range[0];
        let creases = Creases::of(&self.chain);
        let offsets = &|s: f64, t: f64| creases.offsets(&patch.element(s, t).position);
        let worst = Cell::new(0.0_f64);
        let strip = |s: f64| {
            let integrand = |t: f64| self.integrands(patch, origin, s, t).component_div(units);
            let ends = with_even_ends(inner_range, roots(inner_range, |t| offsets(s, t)));
            let strip = in_pieces(integrand, &ends, INNER_SHARE * tolerance / length);
            worst.set(worst.get().max(strip.error));
            strip.value
        };
        // A crease that runs along the strips makes their integral jump.
        let [first, last] = inner_range;
        let lines = [first, 0.5 * (first + last), last];
        let along = lines.into_iter().flat_map(|t| roots(range, move |s| offsets(s, t)));
        let whole =
            in_pieces(strip, &with_even_ends(range, along), (1.0 - INNER_SHARE) * tolerance);
        VectorIntegral { error: whole.error + length * worst.get(), ..whole }
    }

    /// What the element at a pair of parameters adds.
    fn integrands(&self, patch: &Patch, origin: &Vector3<f64>, s: f64, t: f64) -> Integrals {
        let element = patch.element(s, t);
        if element.area == Vector3::zeros() {
            return Integrals::zeros();
        }
        let area = self.chain.normal_transform(&element.position) * element.area;
        let deformed = Vector3::from(self.chain.forward_of(element.position.into()));
        moments(&(deformed - origin), &area)
    }
}

/// Where offsets change their signs in a range, as far as probes tell.
fn roots(range: [f64; 2], offsets: impl Fn(f64) -> Vec<f64>) -> Vec<f64> {
    let mut roots = Vec::new();
    let mut last = offsets(range[0]);
    if last.is_empty() {
        return roots;
    }
    for i in 1..=PROBES {
        let bracket = [place(range, i - 1, PROBES), place(range, i, PROBES)];
        let next = offsets(bracket[1]);
        for (crease, (before, after)) in last.iter().zip(&next).enumerate() {
            if (*before < 0.0) != (*after < 0.0) {
                let sign = if *after < 0.0 { -1.0 } else { 1.0 };
                roots.push(increasing_root(|t| sign * offsets(t)[crease], bracket));
            }
        }
        last = next;
    }
    roots
}

/// The ends of a range's pieces, ascending: even ones, and others.
fn with_even_ends(range: [f64; 2], others: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let even = (0..=PIECES).map(|i| place(range, i, PIECES));
    let mut ends: Vec<f64> = even.chain(others).collect();
    ends.sort_by(f64::total_cmp);
    ends
}

/// The end of so many of the equal parts of a range.
fn place([from, to]: [f64; 2], number: usize, parts: usize) -> f64 {
    from + (to - from) * (number as f64 / parts as f64)
}

/// The integral over pieces between ascending ends.
fn in_pieces(
    function: impl Fn(f64) -> Integrals,
    ends: &[f64],
    tolerance: f64,
) -> VectorIntegral<11> {
    let share = tolerance / ends.len() as f64;
    let pieces = ends.windows(2).map(|ends| integrate(&function, [ends[0], ends[1]], share));
    let nothing = VectorIntegral { value: Integrals::zeros(), error: 0.0 };
    pieces.fold(nothing, |sum, piece| VectorIntegral {
        value: sum.value + piece.value,
        error: sum.error + piece.error,
    })
}

/// The volume and area, and the volume times powers of a length, that errors are measured in.
fn units(sums: &Integrals) -> Integrals {
    let (volume, area) = (sums[0].abs(), sums[10]);
    let length = area.sqrt();
    Integrals::from_fn(|i, _| match i {
        0 => volume,
        1..4 => volume * length,
        4..10 => volume * area,
        _ => area,
    })
}

/// The fluxes whose divergences are 1, `x_i` and `x_i x_j`, and the area.
fn moments(x: &Vector3<f64>, area: &Vector3<f64>) -> Integrals {
    let flux = x.dot(area);
    let (volume, first, second) = (flux / 3.0, flux / 4.0 * x, flux / 5.0 * x * x.transpose());
    Integrals::from([
        volume,
        first.x,
        first.y,
        first.z,
        second.m11,
        second.m22,
        second.m33,
        second.m12,
        second.m13,
        second.m23,
        area.norm(),
    ])
}

fn properties(sums: &Integrals) -> MassProperties {
    let first = Vector3::new(sums[1], sums[2], sums[3]);
    let second = Matrix3::new(
        sums[4], sums[7], sums[8], sums[7], sums[5], sums[9], sums[8], sums[9], sums[6],
    );
    MassProperties::of_integrals(sums[0], first, second)
}

#[cfg(test)]
mod tests;
