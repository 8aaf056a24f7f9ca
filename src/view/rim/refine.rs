//! A closed curve by as many points as it takes.

use std::f64::consts::TAU;

/// Points that every curve has.
const FEWEST: u32 = 64;

/// Halvings of the angle between two of these, at most: corners are then cut by less than any
/// picture shows.
const HALVINGS: u32 = 40;

/// A point of a closed curve and its parameter, which goes once around in 2 pi.
#[derive(Debug, Clone, Copy)]
pub(in crate::view) struct Sample<P> {
    pub theta: f64,
    pub point: P,
}

/// Points in order around a closed curve: no neighbours, of which the last and the first are two as
/// well, are coarse, unless their parameters can hardly be halved further.
pub(in crate::view) fn refine<P: Clone, E>(
    solve: impl Fn(f64) -> Result<P, E>,
    is_coarse: impl Fn(&P, &P) -> bool,
) -> Result<Vec<Sample<P>>, E> {
    let step = TAU / f64::from(FEWEST);
    let mut samples = Vec::new();
    let mut start = Sample { theta: 0.0, point: solve(0.0)? };
    for i in 1..=FEWEST {
        let theta = step * f64::from(i);
        let end = if i == FEWEST { samples_start(&samples, &start) } else { solve(theta)? };
        // Ends of what lies ahead, nearest last.
        let mut ahead = vec![(Sample { theta, point: end }, 0)];
        while let Some((end, halved)) = ahead.last() {
            if *halved < HALVINGS && is_coarse(&start.point, &end.point) {
                let theta = 0.5 * (start.theta + end.theta);
                let halved = halved + 1;
                let middle = Sample { theta, point: solve(theta)? };
                if let Some(end) = ahead.last_mut() {
                    end.1 = halved;
                }
                ahead.push((middle, halved));
            } else if let Some((end, _)) = ahead.pop() {
                samples.push(std::mem::replace(&mut start, end));
            }
        }
    }
    Ok(samples)
}

/// The first point of all, where the curve closes.
fn samples_start<P: Clone>(samples: &[Sample<P>], start: &Sample<P>) -> P {
    samples.first().unwrap_or(start).point.clone()
}
