//! Clutter by nearest neighbours: the points of a surface have nearer neighbours than those
//! strewn in space.
//!
//! Surface and clutter are two populations of distances, estimated together (S. Byers and A.
//! Raftery, Nearest-Neighbor Clutter Removal for Estimating Features in Spatial Point Processes,
//! JASA 93, 1998; here the feature is a surface).
//!
//! Sensors do not sample evenly: a thinly sampled side would pass for clutter. So it also counts
//! whether a point's neighbours lie in a plane.

mod populations;

use std::f64::consts::PI;

use populations::{LEAST_SHARE, Populations};

use super::neighbours::{NEIGHBOUR, Neighbourhood, neighbourhoods};
use super::radial::PARAMETERS;
use super::subset::Subset;
use crate::cloud::PointColumns;

/// The shape k of the Gamma variates.
const SHAPE: f64 = NEIGHBOUR as f64;

/// Distances that stand for all where densities are estimated.
const QUANTILES: usize = 128;

/// Rounds of expectation and maximisation.
const ROUNDS: usize = 40;

/// Least and greatest of what one point's neighbours say, as a ratio of densities.
const ODDS_BOUNDS: [f64; 2] = [0.02, 50.0];

/// The share of the points that is the densest, and their variation above which it says nothing.
const DENSEST_SHARE: f64 = 0.15;
const GREATEST_OF_SURFACE: f64 = 0.09;

/// Variation of the neighbours at which they are of a surface or strewn in space, equally likely,
/// and the difference that makes one e times likelier.
const MIDDLE_VARIATION: f64 = 0.06;
const VARIATION_SCALE: f64 = 0.015;

/// Reach, in that of the median point, up to which a point may have room to itself.
const GREATEST_REACH: f64 = 4.0;

/// Least points that make a surface.
const LEAST_SURFACE: f64 = 2.0 * PARAMETERS as f64;

/// Share of the points that is but a few, and the odds of a point that is far from all others to be
/// of the surface.
const FEW: f64 = 0.05;
const ISOLATED_ODDS: f64 = 1e-9;

/// Share of clutter from which on what is left of it may be worth another look.
const WORTH_ANOTHER_LOOK: f64 = 0.03;

/// What neighbours say of the points.
#[derive(Debug, Clone)]
pub(crate) struct Clutter {
    /// Probability of what is seen of each point's neighbours on the surface over that in clutter.
    pub odds: Vec<f64>,
    /// Share of clutter among the points.
    pub share: f64,
    /// The area on which the points of the surface lie: the sum of each one's own.
    pub surface_area: f64,
    /// Probability of each point to be of the surface.
    on_surface: Vec<f64>,
}

impl Clutter {
    /// Of points with these neighbours; none where one surface explains all.
    pub fn find(points: PointColumns, neighbourhoods: &[Neighbourhood]) -> Option<Self> {
        let reaches: Vec<f64> = neighbourhoods.iter().map(Neighbourhood::reach).collect();
        let is_isolated = isolated(&reaches);
        let populations = Populations::find(&quantiles(&reaches, QUANTILES));
        if populations.is_none() && !is_isolated.contains(&true) {
            return None;
        }
        let of_variation = odds_of_variation(points, neighbourhoods, &reaches);
        let of = |i: usize| match &populations {
            _ if is_isolated[i] => ISOLATED_ODDS,
            Some(populations) => populations.odds(reaches[i]) * of_variation[i],
            None => 1.0,
        };
        let odds: Vec<f64> = (0..reaches.len()).map(of).collect();
        let share = populations.map_or(FEW, |populations| populations.clutter_share);
        let (share, on_surface) = posterior(&odds, share);
        // The few strays that look like surface would count much: they have much room.
        let kept: Vec<f64> =
            on_surface.iter().map(|&near| f64::from(u8::from(near > 0.5))).collect();
        let surface_area = seen_area(&reaches, &kept);
        let surface = kept.iter().sum::<f64>();
        let is_both = surface >= LEAST_SURFACE && surface < kept.len() as f64;
        is_both.then_some(Self { odds, share, surface_area, on_surface })
    }

    /// What neighbours say of the points once those that are clutter have gone: what is left of it
    /// has fewer neighbours then.
    pub fn looked_at_again(mut self, points: PointColumns) -> Self {
        if self.share < WORTH_ANOTHER_LOOK {
            return self;
        }
        let kept = self.surface();
        let left = Subset::of(points, &kept);
        let Some(again) = Self::find(left.columns(), &neighbourhoods(left.columns())) else {
            return self;
        };
        for (place, &i) in kept.iter().enumerate() {
            self.odds[i] = self.odds[i].min(again.odds[place]);
            self.on_surface[i] = again.on_surface[place];
        }
        let share = 1.0 - (1.0 - self.share) * (1.0 - again.share);
        Self { share, surface_area: again.surface_area, ..self }
    }

    /// Indices of the points that are of the surface more likely than not.
    pub fn surface(&self) -> Vec<usize> {
        (0..self.on_surface.len()).filter(|&i| self.on_surface[i] > 0.5).collect()
    }
}

/// Whether the reaches of some of the points hint at clutter, so that all are worth a look.
pub(crate) fn is_hinted_at(reaches: &[f64]) -> bool {
    isolated(reaches).contains(&true) || Populations::are_hinted_at(&quantiles(reaches, QUANTILES))
}

/// Which points are far from all others, where these are but a few.
fn isolated(reaches: &[f64]) -> Vec<bool> {
    let most = GREATEST_REACH * quantile(reaches, 0.5);
    let is_far: Vec<bool> = reaches.iter().map(|&reach| reach > most).collect();
    let far = is_far.iter().filter(|is_far| **is_far).count();
    let are_few = (far as f64) < FEW * reaches.len() as f64;
    is_far.into_iter().map(|is_far| is_far && are_few).collect()
}

/// The share of clutter that the odds make most likely, from a first guess, and each point's
/// probability to be of the surface.
fn posterior(odds: &[f64], mut share: f64) -> (f64, Vec<f64>) {
    let mut on_surface = Vec::new();
    for _ in 0..ROUNDS {
        let of = |odds: &f64| odds * (1.0 - share) / (odds * (1.0 - share) + share);
        on_surface = odds.iter().map(of).collect();
        let near: f64 = on_surface.iter().sum();
        share = (1.0 - near / odds.len() as f64).clamp(LEAST_SHARE, 1.0 - LEAST_SHARE);
    }
    (share, on_surface)
}

/// How much likelier neighbours that vary like each point's are on a surface than in space. Where
/// points are nearer than their noise, those of a surface do not lie in planes either: then all
/// are equally likely.
fn odds_of_variation(
    points: PointColumns,
    neighbourhoods: &[Neighbourhood],
    reaches: &[f64],
) -> Vec<f64> {
    let [low, high] = ODDS_BOUNDS;
    let variations: Vec<f64> = neighbourhoods.iter().map(|one| one.variation(points)).collect();
    let densest = quantile(reaches, DENSEST_SHARE);
    let dense = variations.iter().zip(reaches).filter(|(_, reach)| **reach <= densest);
    let dense: Vec<f64> = dense.map(|(variation, _)| *variation).collect();
    if quantile(&dense, 0.5) > GREATEST_OF_SURFACE {
        return vec![1.0; variations.len()];
    }
    let odds =
        |variation: &f64| ((MIDDLE_VARIATION - variation) / VARIATION_SCALE).exp().clamp(low, high);
    variations.iter().map(odds).collect()
}

/// The area on which points lie: each has `pi D^2 / k` to itself, but none much more than most.
pub(crate) fn seen_area(distances: &[f64], weights: &[f64]) -> f64 {
    let most = GREATEST_REACH * quantile(distances, 0.5);
    let room = |(distance, weight): (&f64, &f64)| weight * distance.min(most).powi(2);
    PI / SHAPE * distances.iter().zip(weights).map(room).sum::<f64>()
}

/// The value that this share of the values does not exceed.
fn quantile(values: &[f64], share: f64) -> f64 {
    let mut values = values.to_vec();
    let place = (share * values.len() as f64) as usize;
    *values.select_nth_unstable_by(place, f64::total_cmp).1
}

/// As many values that stand for all, each for an equal share of them; all where they are fewer.
fn quantiles(values: &[f64], count: usize) -> Vec<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let count = count.min(sorted.len());
    (0..count).map(|i| sorted[(2 * i + 1) * sorted.len() / (2 * count)]).collect()
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::shape::Superellipsoid;
    use crate::surface::sample_surface;

    const SURFACE: usize = 1_000;

    /// Points of a sphere of radius 1, then strays in a cube of side 4.
    fn sphere_among(strays: usize) -> [Vec<f64>; 3] {
        let sphere = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let points = sample_surface(&sphere, SURFACE, 2);
        std::array::from_fn(|k| {
            let surface = points.iter().map(|point| point[k]);
            surface.chain((0..strays).map(|_| rng.random_range(-2.0..2.0))).collect()
        })
    }

    fn find(columns: &[Vec<f64>; 3]) -> Option<Clutter> {
        let points = [&columns[0][..], &columns[1], &columns[2]];
        Clutter::find(points, &neighbourhoods(points))
    }

    #[test]
    fn clutter_is_told_from_a_sphere_and_its_share_found() {
        for strays in [250, 1_000, 2_500] {
            let clutter = find(&sphere_among(strays)).expect("clutter");
            let share = strays as f64 / (SURFACE + strays) as f64;
            // Strays next to the surface have near neighbours too.
            assert!(clutter.share < share && clutter.share > share - 0.1, "{strays} {clutter:?}");
            let kept = clutter.surface();
            let right = kept.iter().filter(|&&i| i < SURFACE).count();
            assert!(right >= SURFACE * 9 / 10, "{right}");
            let most_wrong = strays / 5;
            assert!(kept.len() - right < most_wrong, "{strays}: {} kept", kept.len() - right);
        }
    }

    #[test]
    fn a_second_look_finds_more_of_the_clutter() {
        // One side of it.
        let mut columns = sphere_among(250);
        columns[0][..SURFACE].iter_mut().for_each(|x| *x = x.abs());
        let points = [&columns[0][..], &columns[1], &columns[2]];
        let clutter = find(&columns).expect("clutter");
        // Those next to the surface cannot be told from it, and do no harm.
        let is_far = |&i: &usize| {
            let square: f64 = columns.iter().map(|column| column[i].powi(2)).sum();
            (square.sqrt() - 1.0).abs() > 0.2
        };
        let wrong = |clutter: &Clutter| clutter.surface().into_iter().filter(is_far).count();
        let right = |clutter: &Clutter| clutter.surface().iter().filter(|&&i| i < SURFACE).count();
        let again = clutter.clone().looked_at_again(points);
        assert!(
            3 * wrong(&again) < 2 * wrong(&clutter),
            "{} of {}",
            wrong(&again),
            wrong(&clutter)
        );
        assert!(right(&again) >= SURFACE * 9 / 10, "{}", right(&again));
        assert!(again.share > clutter.share && again.share < 0.2, "{}", again.share);
    }

    #[test]
    fn a_sphere_alone_has_no_clutter_and_its_area_is_seen() {
        let columns = sphere_among(0);
        assert!(find(&columns).is_none());
        let points = [&columns[0][..], &columns[1], &columns[2]];
        let reaches: Vec<f64> = neighbourhoods(points).iter().map(Neighbourhood::reach).collect();
        let area = seen_area(&reaches, &vec![1.0; SURFACE]);
        assert!((area / (4.0 * PI) - 1.0).abs() < 0.05, "{area}");
    }

    #[test]
    fn a_thinly_sampled_side_is_no_clutter() {
        let columns = sphere_among(0);
        let is_kept = |i: &usize| columns[2][*i] > 0.0 || i.is_multiple_of(20);
        let kept: Vec<usize> = (0..SURFACE).filter(is_kept).collect();
        let thinned = columns.each_ref().map(|column| kept.iter().map(|&i| column[i]).collect());
        assert!(find(&thinned).is_none_or(|clutter| clutter.share < 0.05));
    }
}
