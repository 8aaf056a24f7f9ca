//! Adaptive quadrature of vectors along a line.

use nalgebra::SVector;

/// Nodes of Kronrod's rule of 15 points on [0, 1) of [-1, 1], from the outermost to the middle
/// (QUADPACK's QK15).
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_46,
    0.0,
];

/// Their weights.
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_56,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_82,
];

/// The weights of Gauss's rule of 7 points, which are every other of them.
const GAUSS: [f64; 4] = [
    0.129_484_966_168_869_7,
    0.279_705_391_489_276_64,
    0.381_830_050_505_118_9,
    0.417_959_183_673_469_4,
];

/// Most pieces that a line is cut into.
const MOST_PIECES: usize = 10_000;

/// An integral, and a bound on its error.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct VectorIntegral<const N: usize = 3> {
    /// The integral.
    pub value: SVector<f64, N>,
    /// QUADPACK's estimate by what the two rules differ by on every piece, or what a piece differs
    /// by from its two halves, added up: above the true error where the function is smooth. Not a
    /// number where the function has a pole.
    pub error: f64,
}

/// The integral of a vector over `[from, to]`, by Gauss's and Kronrod's rules on pieces that are
/// halved, the worst first, until their differences add up to no more than `tolerance`, or as
/// many as 10,000 have been.
pub fn integrate<const N: usize>(
    function: impl Fn(f64) -> SVector<f64, N>,
    [from, to]: [f64; 2],
    tolerance: f64,
) -> VectorIntegral<N> {
    let mut pieces = vec![Piece::new(&function, from, to)];
    loop {
        let error: f64 = pieces.iter().map(|piece| piece.error).sum();
        // Written so that an error that is not a number ends it, too.
        let goes_on = error > tolerance && pieces.len() < MOST_PIECES;
        let worst = (0..pieces.len()).max_by(|&a, &b| pieces[a].error.total_cmp(&pieces[b].error));
        let Some(worst) = worst.filter(|_| goes_on) else {
            let value = pieces.iter().map(|piece| piece.value).sum();
            return VectorIntegral { value, error };
        };
        let [first, second] = pieces[worst].halves(&function);
        pieces[worst] = first;
        pieces.insert(worst + 1, second);
    }
}

/// A part of the line.
struct Piece<const N: usize> {
    from: f64,
    to: f64,
    value: SVector<f64, N>,
    error: f64,
}

impl<const N: usize> Piece<N> {
    fn new(function: &impl Fn(f64) -> SVector<f64, N>, from: f64, to: f64) -> Self {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let (mut kronrod, mut gauss) = (SVector::zeros(), SVector::zeros());
        let mut values = [(0.0, SVector::zeros()); 2 * NODES.len() - 1];
        for (i, (node, weight)) in NODES.into_iter().zip(KRONROD).enumerate() {
            let ends = [function(middle - half * node), function(middle + half * node)];
            let sum = if node == 0.0 { ends[0] } else { ends[0] + ends[1] };
            kronrod += weight * sum;
            if i % 2 == 1 {
                gauss += GAUSS[i / 2] * sum;
            }
            values[i] = (weight, ends[0]);
            values[2 * NODES.len() - 2 - i] = (weight, ends[1]);
        }
        let mean = 0.5 * kronrod;
        let spread: f64 = values.iter().map(|(weight, value)| weight * (value - mean).norm()).sum();
        let error = scaled_error((half * (kronrod - gauss)).norm(), half.abs() * spread);
        Self { from, to, value: half * kronrod, error }
    }

    /// Both halves. Next to a jump the rules may agree by chance: the error is then taken from
    /// what halving has changed.
    fn halves(&self, function: &impl Fn(f64) -> SVector<f64, N>) -> [Self; 2] {
        let middle = 0.5 * (self.from + self.to);
        let [first, second] = [[self.from, middle], [middle, self.to]]
            .map(|[from, to]| Self::new(function, from, to));
        let change = 0.5 * (first.value + second.value - self.value).norm();
        [first, second].map(|half| Self { error: half.error.max(change), ..half })
    }
}

/// QUADPACK's estimate of the error of Kronrod's rule, by what the two rules differ by: of an
/// integrand that deviates little from the one they agree on, far less than that.
fn scaled_error(difference: f64, spread: f64) -> f64 {
    // Written so that a difference that is not a number stays one.
    let is_small = 200.0 * difference < spread;
    if is_small { difference * (200.0 * difference / spread).sqrt() } else { difference }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Vector3;

    #[test]
    fn smooth_kinked_and_singular_functions_to_the_tolerance() {
        let function = |t: f64| Vector3::new(t.exp(), (t - 0.3).abs(), t.sqrt());
        let expected = Vector3::new(1.0_f64.exp() - 1.0, 0.5 * (0.09 + 0.49), 2.0 / 3.0);
        for tolerance in [1e-3, 1e-6, 1e-10] {
            let integral = integrate(function, [0.0, 1.0], tolerance);
            assert!(integral.error <= tolerance);
            assert!((integral.value - expected).norm() <= tolerance);
        }
    }

    #[test]
    fn polynomials_of_degree_22_are_exact_and_a_pole_is_not_waited_for() {
        let power = |t: f64| Vector3::new(t.powi(22), 0.0, 0.0);
        let integral = integrate(power, [0.0, 1.0], f64::INFINITY);
        assert!((integral.value.x - 1.0 / 23.0).abs() < 1e-15);
        let pole = integrate(|t| Vector3::new(t.recip(), 0.0, 0.0), [0.0, 1.0], 1e-9);
        assert!(pole.error.is_nan());
    }
}
