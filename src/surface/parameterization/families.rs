//! Parameterisations of the other spherical products: of the tube and its ring, and of the tower.

use nalgebra::Vector3;
use thiserror::Error;

use super::equal_distance::evenly_spread;
use super::{Parameterization, around, rows};
use crate::shape::{Shape, SuperhyperboloidOneSheet, Supertoroid};

/// A shape whose surface has no rows of points.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
#[error(
    "rows of points are those of a superellipsoid, a supertoroid or a superhyperboloid_one_sheet, \
     found a {family}"
)]
pub struct NoRows {
    /// The family's name.
    pub family: &'static str,
}

/// Chords of the table from which equal distances along a tower's profile are read.
const TABLE_STEPS: usize = 4096;

impl Parameterization {
    /// Points of a shape in the model's frame, in rows of `4 n` around z from the x axis on: those of
    /// [`superellipsoid`](Self::superellipsoid); `4 n` rows around a supertoroid's tube, beginning
    /// on its outside; `2 n + 1` rows from the lower rim of a superhyperboloid of one sheet to the
    /// upper one.
    ///
    /// The profile of that is a superhyperbola, whose height changes faster than its radius; its
    /// points at equal angles are so at the centre.
    ///
    /// # Errors
    /// If the shape is of another family: two sheets end at no row, and the solid of three exponents
    /// is no spherical product.
    pub fn shape(self, shape: &Shape, n: usize) -> Result<Vec<Vec<Vector3<f64>>>, NoRows> {
        match shape {
            Shape::Superellipsoid(shape) => Ok(self.superellipsoid(shape, n)),
            Shape::Supertoroid(torus) => Ok(self.supertoroid(torus, n)),
            Shape::SuperhyperboloidOneSheet(tower) => Ok(self.tower(tower, n)),
            other => Err(NoRows { family: other.family() }),
        }
    }

    fn supertoroid(self, torus: &Supertoroid, n: usize) -> Vec<Vec<Vector3<f64>>> {
        let [a1, a2, a3] = torus.size();
        let [e1, e2] = torus.exponents();
        // Distances along the tube are those of its widest copy.
        let width = a1.hypot(a2);
        let tube = around(&self.quarter([width, a3], e1, n))
            .map(|[across, z]| [torus.ring() + across / width, z])
            .collect::<Vec<_>>();
        let ring: Vec<[f64; 2]> = around(&self.quarter([a1, a2], e2, n)).collect();
        rows(&tube, &ring)
    }

    fn tower(self, tower: &SuperhyperboloidOneSheet, n: usize) -> Vec<Vec<Vector3<f64>>> {
        let [a1, a2, a3] = tower.size();
        let upper = self.profile(tower, n);
        let upper: Vec<[f64; 2]> = upper.iter().map(|w| [tower.radius(*w), a3 * w]).collect();
        let lower = upper.iter().skip(1).rev().map(|&[scale, z]| [scale, -z]);
        let meridian: Vec<[f64; 2]> = lower.chain(upper.iter().copied()).collect();
        let equator = self.quarter([a1, a2], tower.exponents()[1], n);
        rows(&meridian, &around(&equator).collect::<Vec<_>>())
    }

    /// Heights from the waist to the rim, in units of a3.
    fn profile(self, tower: &SuperhyperboloidOneSheet, n: usize) -> Vec<f64> {
        let [a1, a2, a3] = tower.size();
        let (e, top, width) = (tower.exponents()[0], tower.top(), a1.hypot(a2));
        let share = |i: usize| i as f64 / n as f64;
        let inner: Vec<f64> = match self {
            Self::Trigonometric => {
                let north = top.powf(e.recip()).atan();
                (1..n).map(|i| (north * share(i)).tan().powf(e)).collect()
            }
            Self::Explicit => (1..n).map(|i| top * share(i)).collect(),
            Self::AngleCentre => {
                let steepest = (a3 * top).atan2(width * tower.radius(top));
                let slope = |i: usize| (steepest * share(i)).tan() * width / a3;
                // On the ray w = slope r, (1 - slope^(2/e)) r^(2/e) = 1.
                (1..n).map(slope).map(|s| s * (1.0 - s.powf(2.0 / e)).powf(-0.5 * e)).collect()
            }
            Self::EqualDistance => {
                let height = |share: f64| top * share;
                let point = |share: f64| [width * tower.radius(height(share)), a3 * height(share)];
                evenly_spread(point, TABLE_STEPS, n).map(height).collect()
            }
        };
        std::iter::once(0.0).chain(inner).chain(std::iter::once(top)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::{LevelSet, ThreeExponent};

    const EXPONENTS: [f64; 5] = [0.1, 0.5, 1.0, 1.5, 2.0];

    fn shapes() -> impl Iterator<Item = Shape> {
        let size = [2.0, 0.7, 1.3];
        EXPONENTS.into_iter().flat_map(move |e1| {
            EXPONENTS.into_iter().flat_map(move |e2| {
                [
                    SuperhyperboloidOneSheet::new(size, [e1, e2], 2.2).unwrap().into(),
                    Supertoroid::new(size, [e1, e2], 1.6).unwrap().into(),
                ]
            })
        })
    }

    #[test]
    fn rows_are_on_the_surface_and_begin_and_end_where_they_should() {
        for shape in shapes() {
            for parameterization in Parameterization::ALL {
                let rows = parameterization.shape(&shape, 8).unwrap();
                let is_torus = matches!(shape, Shape::Supertoroid(_));
                assert_eq!((rows.len(), rows[0].len()), (if is_torus { 32 } else { 17 }, 32));
                for x in rows.iter().flatten() {
                    let level = shape.level((*x).into());
                    assert!((level - 1.0).abs() < 1e-12, "{parameterization:?} {shape:?} {x}");
                }
                if is_torus {
                    assert!((rows[0][0] - Vector3::new(2.6 * 2.0, 0.0, 0.0)).norm() < 1e-14);
                } else {
                    assert_eq!((rows[0][3].z, rows[16][3].z), (-2.2, 2.2));
                    assert_eq!(rows[8][0], Vector3::new(2.0, 0.0, 0.0));
                }
                let heights = rows.iter().map(|row| row[0].z).collect::<Vec<_>>();
                assert!(is_torus || heights.windows(2).all(|pair| pair[0] < pair[1]));
            }
        }
    }

    #[test]
    fn equal_distances_along_a_profile_and_a_tube_are_equal() {
        for shape in shapes() {
            let rows = Parameterization::EqualDistance.shape(&shape, 64).unwrap();
            // The copy towards the ring's corner is as wide as any, but for its exponent.
            let [a1, a2] = [2.0, 0.7];
            let width = f64::hypot(a1, a2);
            let place = |row: &Vec<Vector3<f64>>| [row[0].x / a1 * width, row[0].z];
            let places: Vec<[f64; 2]> = rows.iter().map(place).collect();
            let steps: Vec<f64> = places
                .windows(2)
                .map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]))
                .collect();
            let mean = steps.iter().sum::<f64>() / steps.len() as f64;
            // Chords around a bend fall short of arcs.
            assert!(steps.iter().all(|step| (0.65..1.03).contains(&(step / mean))), "{shape:?}");
        }
    }

    #[test]
    fn equal_angles_of_a_profile_are_those_of_rays_from_the_centre() {
        let tower = SuperhyperboloidOneSheet::new([2.0, 0.7, 1.3], [0.6, 1.0], 2.2).unwrap();
        let rows = Parameterization::AngleCentre.shape(&tower.into(), 8).unwrap();
        let width = f64::hypot(2.0, 0.7);
        let angles: Vec<f64> =
            rows.iter().map(|row| row[0].z.atan2(row[0].x / 2.0 * width)).collect();
        let step = angles[16] / 8.0;
        assert!(angles.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() < 1e-12));
    }

    #[test]
    fn families_without_rows_are_refused_by_name() {
        let three = ThreeExponent::new([1.0; 3], [2.0; 3]).unwrap().into();
        let refused = Parameterization::Explicit.shape(&three, 4).unwrap_err();
        assert!(refused.to_string().ends_with("found a three_exponent"));
    }
}
