//! What every surface with a latitude and a longitude can be asked.

use nalgebra::Vector3;

/// A surface in its own frame, over a latitude eta and a longitude omega in radians.
pub trait Parametric {
    /// The natural ranges `[[eta_min, eta_max], [omega_min, omega_max]]`. Of a surface of two
    /// sheets that of the first; half a turn of omega leads to the second.
    fn domain(&self) -> [[f64; 2]; 2];

    /// The surface point, in the unit of the shape's size.
    fn position(&self, eta: f64, omega: f64) -> Vector3<f64>;

    /// The tangents `[r_eta, r_omega]`. On planes of symmetry powers of sine and cosine stand
    /// still or run infinitely fast: components are then 0 or infinite.
    fn tangents(&self, eta: f64, omega: f64) -> [Vector3<f64>; 2];

    /// The second derivatives `[r_eta_eta, r_eta_omega, r_omega_omega]`.
    fn second_derivatives(&self, eta: f64, omega: f64) -> [Vector3<f64>; 3];

    /// The outward unit normal. Where several meet, one of them or a mean.
    fn normal(&self, eta: f64, omega: f64) -> Vector3<f64>;
}

/// The unit vector along components that may be infinite: those that are outweigh the others.
pub(crate) fn direction(components: [f64; 3]) -> Vector3<f64> {
    let greatest = components.iter().fold(0.0, |greatest: f64, c| greatest.max(c.abs()));
    let scaled = if greatest.is_infinite() {
        components.map(|c| if c.is_infinite() { c.signum() } else { 0.0 })
    } else {
        components.map(|c| c / greatest)
    };
    Vector3::from(scaled).normalize()
}
