//! The rim of an orthographic view in closed form (JLS Eqs. 2.45-2.48).

use std::f64::consts::PI;

use nalgebra::Vector3;

use crate::math::signed_power;
use crate::shape::Superellipsoid;

/// The point of the rim at the longitude `omega`, in the model's frame, for a direction of view in
/// that frame whose z is not 0 (JLS Eqs. 2.46, 2.48, signed powers).
///
/// The latitude's tangent t is kept in place of the latitude, whose cosine near the poles has no
/// digits left. Domain: exponents below 2. Where `view.z` is 0 the rim is two meridians, those of
/// [`orthographic_rim_meridians`], and this is a pole or not a number.
pub fn orthographic_rim_point(
    shape: &Superellipsoid,
    view: &Vector3<f64>,
    omega: f64,
) -> Vector3<f64> {
    let [a1, a2, a3] = shape.size();
    let [e1, e2] = shape.exponents();
    let (sin, cos) = omega.sin_cos();
    let equatorial =
        view.x / a1 * signed_power(cos, 2.0 - e2) + view.y / a2 * signed_power(sin, 2.0 - e2);
    let tangent = signed_power(-a3 / view.z * equatorial, 1.0 / (2.0 - e1));
    let (parallel, height) = powers_of_cosine_and_sine(tangent, e1);
    Vector3::new(
        a1 * parallel * signed_power(cos, e2),
        a2 * parallel * signed_power(sin, e2),
        a3 * height,
    )
}

/// `cos(eta)^e` and `sin(eta)^e` of a latitude by its tangent, of any magnitude.
fn powers_of_cosine_and_sine(tangent: f64, e: f64) -> (f64, f64) {
    let magnitude = tangent.abs();
    if magnitude <= 1.0 {
        let cosine = (1.0 + magnitude * magnitude).sqrt().recip();
        (cosine.powf(e), signed_power(tangent * cosine, e))
    } else {
        let cotangent = magnitude.recip();
        let sine = (1.0 + cotangent * cotangent).sqrt().recip();
        ((cotangent * sine).powf(e), signed_power(sine.copysign(tangent), e))
    }
}

/// The longitudes, in (-pi, pi], of the two meridians that are the rim for a direction of view with
/// `view.z = 0` in the model's frame (the case a_z = 0 that JLS Eq. 2.46 leaves out). Domain: `e2`
/// below 2.
pub fn orthographic_rim_meridians(shape: &Superellipsoid, view: &Vector3<f64>) -> [f64; 2] {
    let [a1, a2, _] = shape.size();
    let power = 1.0 / (2.0 - shape.exponents()[1]);
    let (along_x, along_y) = (view.x / a1, view.y / a2);
    // Only the ratio counts; scaled so that no power overflows.
    let greatest = along_x.abs().max(along_y.abs());
    let sin = signed_power(along_x / greatest, power);
    let cos = signed_power(-along_y / greatest, power);
    let omega = sin.atan2(cos);
    [omega, if omega > 0.0 { omega - PI } else { omega + PI }]
}
