//! Sums in several lanes side by side: no addition waits for the one before, and the order does not
//! depend on the instruction set.

const LANES: usize = 8;

/// The sum of values.
#[inline(always)]
pub(crate) fn lane_sum(values: &[f64]) -> f64 {
    let (chunks, rest) = values.as_chunks::<LANES>();
    let mut lanes = [0.0; LANES];
    for chunk in chunks {
        for (lane, value) in lanes.iter_mut().zip(chunk) {
            *lane += value;
        }
    }
    lanes.iter().chain(rest).sum()
}

/// The sum of products, of as many values as the shorter of both has.
#[inline(always)]
pub(crate) fn lane_dot(a: &[f64], b: &[f64]) -> f64 {
    let count = a.len().min(b.len());
    let ((a, a_rest), (b, b_rest)) =
        (a[..count].as_chunks::<LANES>(), b[..count].as_chunks::<LANES>());
    let mut lanes = [0.0; LANES];
    for (a, b) in a.iter().zip(b) {
        for ((lane, a), b) in lanes.iter_mut().zip(a).zip(b) {
            *lane += a * b;
        }
    }
    lanes.iter().sum::<f64>() + a_rest.iter().zip(b_rest).map(|(a, b)| a * b).sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_one_value_after_the_other() {
        for count in [0, 1, 7, 8, 9, 100] {
            let values: Vec<f64> = (0..count).map(f64::from).collect();
            let ones = vec![2.0; values.len() + 3];
            let expected: f64 = values.iter().sum();
            assert_eq!(lane_sum(&values), expected);
            assert_eq!(lane_dot(&values, &ones), 2.0 * expected);
        }
    }
}
