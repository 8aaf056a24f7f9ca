//! What of a box a plane cuts off.

/// Share of the greatest slope below which one counts as none: the formula divides by all.
const LEAST_SHARE: f64 = 1e-3;

/// Bound on the error of [`share_below`] by rounding.
pub(crate) const SHARE_ROUNDING: f64 = 1e-8;

/// The share of the box `|y_i| <= 1` in which `slopes . y <= level`, slopes much smaller than the
/// greatest counting as none: the level is then as good as [`left_out`] tells.
///
/// By inclusion and exclusion of the corners. Domain: finite numbers.
pub(crate) fn share_below(slopes: &[f64; 3], level: f64) -> f64 {
    let slopes = counted(slopes);
    let count = slopes.len();
    let sum: f64 = slopes.iter().sum();
    if sum == 0.0 {
        return if level >= 0.0 { 1.0 } else { 0.0 };
    }
    // In units of the greatest sum, from the lowest corner.
    let above = (level + sum) / (2.0 * sum);
    if above <= 0.0 {
        return 0.0;
    }
    if above >= 1.0 {
        return 1.0;
    }
    let corner = |set: usize| {
        let chosen = (0..count).filter(|i| set >> i & 1 == 1);
        let (parity, height) =
            chosen.fold((1.0, 0.0), |(parity, height), i| (-parity, height + slopes[i] / sum));
        parity * (above - height).max(0.0).powi(count as i32)
    };
    let corners: f64 = (0..1 << count).map(corner).sum();
    let product: f64 = slopes.iter().map(|slope| slope / sum).product();
    let factorial = [1.0, 1.0, 2.0, 6.0][count];
    (corners / (factorial * product)).clamp(0.0, 1.0)
}

/// The sum of the slopes that [`share_below`] counts as none.
pub(crate) fn left_out(slopes: &[f64; 3]) -> f64 {
    let least = least_counted(slopes);
    slopes.iter().map(|slope| slope.abs()).filter(|&slope| slope <= least).sum()
}

/// The magnitudes that count.
fn counted(slopes: &[f64; 3]) -> Vec<f64> {
    let least = least_counted(slopes);
    slopes.iter().map(|slope| slope.abs()).filter(|&slope| slope > least).collect()
}

/// The magnitude above which a slope counts.
fn least_counted(slopes: &[f64; 3]) -> f64 {
    LEAST_SHARE * slopes.iter().fold(0.0_f64, |greatest, slope| greatest.max(slope.abs()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_those_counted_on_a_grid() {
        let grid: Vec<f64> = (0..60).map(|i| (f64::from(i) + 0.5) / 30.0 - 1.0).collect();
        for slopes in [[1.0, 0.5, -0.3], [0.2, 0.0, 1.0], [0.0, -2.0, 0.0], [1.0, 2e-3, 1e-3]] {
            for level in [-1.2, -0.4, 0.0, 0.3, 0.9, 5.0] {
                let mut below = 0;
                for x in &grid {
                    for y in &grid {
                        let at = |z: &&f64| slopes[0] * x + slopes[1] * y + slopes[2] * **z;
                        below += grid.iter().filter(|z| at(z) <= level).count();
                    }
                }
                let counted = below as f64 / 60_f64.powi(3);
                let found = share_below(&slopes, level);
                // Half of a layer of the grid.
                assert!((found - counted).abs() < 1.0 / 60.0, "{slopes:?} {level} {found}");
            }
        }
    }

    #[test]
    fn shares_on_both_sides_add_up_to_one() {
        for slopes in [[1.0, 0.7, 0.4], [1.0, 2e-3, 1.5e-3], [1.0, 1.0, 1e-9]] {
            for level in [-1.0, -0.3, 0.0, 0.2, 1.1] {
                let sum = share_below(&slopes, level) + share_below(&slopes, -level);
                assert!((sum - 1.0).abs() < SHARE_ROUNDING, "{slopes:?} {level} {sum}");
            }
        }
        assert_eq!(left_out(&[1.0, 1e-4, -2.0]), 1e-4);
    }
}
