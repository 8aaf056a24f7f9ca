//! A part of the points, spread evenly over their order, for the coarse stages.

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::normalization::Normalization;
use crate::cloud::PointColumns;

/// Some points, as owned columns.
#[derive(Debug, Clone)]
pub(crate) struct Subset([Vec<f64>; 3]);

impl Subset {
    /// At most `count` points: one at random from each of as many equal runs of the points.
    ///
    /// Runs, and not a fixed stride, so that the rows of a depth map do not beat with it.
    pub fn stratified(points: PointColumns, count: usize, seed: u64) -> Self {
        let total = points[0].len();
        if total <= count {
            return Self(points.map(<[f64]>::to_vec));
        }
        Self::of(points, &one_of_each_run(total, count, seed))
    }

    /// As [`stratified`](Self::stratified), of the points at some indices.
    pub fn stratified_of(points: PointColumns, indices: &[usize], count: usize, seed: u64) -> Self {
        let total = indices.len();
        if total <= count {
            return Self::of(points, indices);
        }
        let places = one_of_each_run(total, count, seed);
        let chosen: Vec<usize> = places.into_iter().map(|place| indices[place]).collect();
        Self::of(points, &chosen)
    }

    /// The points at some indices.
    pub fn of(points: PointColumns, indices: &[usize]) -> Self {
        Self(points.map(|column| indices.iter().map(|&i| column[i]).collect()))
    }

    /// All points, in normalised coordinates.
    pub fn normalized(points: PointColumns, normalization: &Normalization) -> Self {
        let Normalization { centroid, inverse_radius, .. } = normalization;
        let normalize = |k: usize| -> Vec<f64> {
            points[k].iter().map(|x| (x - centroid[k]) * inverse_radius).collect()
        };
        Self([0, 1, 2].map(normalize))
    }

    /// The columns.
    pub fn columns(&self) -> PointColumns<'_> {
        [&self.0[0], &self.0[1], &self.0[2]]
    }
}

impl FromIterator<Vector3<f64>> for Subset {
    fn from_iter<I: IntoIterator<Item = Vector3<f64>>>(points: I) -> Self {
        let points = points.into_iter();
        let (least, _) = points.size_hint();
        let mut columns = [0, 1, 2].map(|_| Vec::with_capacity(least));
        for point in points {
            columns.iter_mut().zip(&point).for_each(|(column, x)| column.push(*x));
        }
        Self(columns)
    }
}

/// One number at random from each of `count` equal runs of the first `total` ones.
fn one_of_each_run(total: usize, count: usize, seed: u64) -> Vec<usize> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    (0..count).map(|run| rng.random_range(run * total / count..(run + 1) * total / count)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn takes_one_point_of_each_run_and_the_same_for_the_same_seed() {
        let column: Vec<f64> = (0..1003).map(f64::from).collect();
        let points = [&column[..], &column[..], &column[..]];
        let subset = Subset::stratified(points, 100, 7);
        let [x, y, z] = subset.columns();
        assert!((x.len(), x, x) == (100, y, z));
        for (run, value) in x.iter().enumerate() {
            let range = (run * 1003 / 100) as f64..((run + 1) * 1003 / 100) as f64;
            assert!(range.contains(value));
        }
        assert_eq!(subset.columns(), Subset::stratified(points, 100, 7).columns());
        assert_ne!(subset.columns(), Subset::stratified(points, 100, 8).columns());
    }

    #[test]
    fn takes_of_the_points_at_some_indices_as_of_all_of_them() {
        let column: Vec<f64> = (0..1003).map(f64::from).collect();
        let even: Vec<usize> = (0..1003).step_by(2).collect();
        let kept = Subset::of([&column; 3], &even);
        for count in [100, 1003] {
            let subset = Subset::stratified_of([&column; 3], &even, count, 7);
            let expected = Subset::stratified(kept.columns(), count, 7);
            assert_eq!(subset.columns(), expected.columns());
        }
    }

    #[test]
    fn takes_all_points_where_there_are_no_more() {
        let column = [1.0, 2.0, 3.0];
        let subset = Subset::stratified([&column, &column, &column], 3, 0);
        assert_eq!(subset.columns(), [&column, &column, &column]);
    }
}
