//! Values as they are typed.

use crate::surface::Resolution;

/// Numbers between commas.
pub(super) fn vector<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let expected = || format!("expected {N} numbers with commas between them");
    let numbers: Result<Vec<f64>, _> =
        text.split(',').map(|number| number.trim().parse::<f64>()).collect();
    let numbers: [f64; N] = numbers.map_err(|_| expected())?.try_into().map_err(|_| expected())?;
    let is_finite = numbers.iter().all(|number| number.is_finite());
    if is_finite { Ok(numbers) } else { Err("expected finite numbers".to_owned()) }
}

/// A number above 0.
pub(super) fn positive(text: &str) -> Result<f64, String> {
    let number = text.parse::<f64>().ok().filter(|number| number.is_finite() && *number > 0.0);
    number.ok_or_else(|| "expected a positive number".to_owned())
}

/// Segments of a mesh.
pub(super) fn resolution(text: &str) -> Result<Resolution, String> {
    let segments = text.parse().map_err(|_| "expected a whole number".to_owned())?;
    Resolution::new(segments).map_err(|error| error.to_string())
}
