//! The norm whose unit circle is a superellipse.

/// The norm `p(u, v; e) = (u^(2/e) + v^(2/e))^(e/2)` of two magnitudes, without overflow.
///
/// Domain: `u, v >= 0`; `e >= 0`, where `e = 0` is the limit `max(u, v)`.
pub(crate) fn superellipse_norm(u: f64, v: f64, e: f64) -> f64 {
    let (greatest, least) = if u >= v { (u, v) } else { (v, u) };
    if least == 0.0 || e == 0.0 {
        return greatest;
    }
    let power = (2.0 / e * (least / greatest).ln()).exp();
    greatest * (0.5 * e * power.ln_1p()).exp()
}
