//! Masses and area of the superhyperboloid of two sheets.

use super::SuperhyperboloidTwoSheets;
use crate::math::integral_in_pieces;
use crate::shape::mass::MassProperties;

impl SuperhyperboloidTwoSheets {
    /// Sums of columns between surface and caps, by quadrature: relative error below 1e-8 for
    /// exponents from 0.05 to 3 and clips from 1.01 to 100 a1.
    pub(super) fn masses(&self) -> MassProperties {
        let [a1, a2, a3] = self.size;
        let box_volume = a1 * a2 * a3;
        let top = self.top();
        let column = |v: f64, w: f64| top - self.height(v, w);
        let x_squares = |v: f64, w: f64| (top.powi(3) - self.height(v, w).powi(3)) / 3.0;
        let squares = [
            a1 * a1 * self.over_caps(x_squares),
            a2 * a2 * self.over_caps(|v, w| v * v * column(v, w)),
            a3 * a3 * self.over_caps(|v, w| w * w * column(v, w)),
        ];
        let volume = box_volume * self.over_caps(column);
        MassProperties::of_symmetric(volume, squares.map(|s| box_volume * s))
    }

    /// Area of the whole boundary, to the accuracy of the masses.
    pub(super) fn area_of_bowls_and_caps(&self) -> f64 {
        self.over_caps(|v, w| self.bowl(v, w).area.norm() + self.cap(v, w).area.norm())
    }

    /// The integral over both caps of a function of `v >= 0` and `w >= 0`.
    fn over_caps(&self, f: impl Fn(f64, f64) -> f64) -> f64 {
        let strip =
            |w: f64| integral_in_pieces(|v| f(v, w), [0.0, self.greatest_v(w)], &[self.waist(w)]);
        8.0 * integral_in_pieces(strip, [0.0, self.greatest_vw()[1]], &self.cuts_of_w())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Equal exponents make y and z alike, but they are integrated over in turn, by other cuts.
    #[test]
    fn quadrature_is_as_accurate_as_stated() {
        for e in [0.05, 0.1, 0.5, 1.0, 1.5, 2.0, 3.0] {
            for clip in [1.01, 1.5, 2.0, 100.0] {
                let bowls =
                    |size: [f64; 3]| SuperhyperboloidTwoSheets::new(size, [e, e], clip).unwrap();
                let moments = bowls([1.0; 3]).masses().second_moments();
                let [y, z] = [moments[(1, 1)], moments[(2, 2)]];
                assert!((y / z - 1.0).abs() < 1e-8, "{e} {clip} {y} {z}");
                let [wide, high] = [[1.0, 0.3, 2.0], [1.0, 2.0, 0.3]]
                    .map(|size| bowls(size).area_of_bowls_and_caps());
                assert!((wide / high - 1.0).abs() < 1e-8, "{e} {clip} {wide} {high}");
            }
        }
    }
}
