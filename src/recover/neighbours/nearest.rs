//! The one nearest neighbour, among few points: by trying all pairs.

use super::{INDEX, Key, NONE, key};
use crate::cloud::PointColumns;
use crate::machine::{Products, vectorized};

/// Which other point is the nearest to each, of a few hundred points; none where there is no other.
pub(crate) fn nearest_others(points: PointColumns) -> Vec<Option<usize>> {
    vectorized::run(NearestOfAll(points))
}

struct NearestOfAll<'a>(PointColumns<'a>);

impl vectorized::Kernel for NearestOfAll<'_> {
    type Output = Vec<Option<usize>>;

    #[inline(always)]
    fn run<const FMA: bool, P: Products>(self) -> Self::Output {
        let count = self.0[0].len();
        let mut all = Vec::with_capacity(count);
        for here in 0..count {
            let least = least_key(self.0, here);
            all.push((least < NONE).then_some((least & INDEX) as usize));
        }
        all
    }
}

#[inline(always)]
fn least_key([xs, ys, zs]: PointColumns, here: usize) -> Key {
    let [x, y, z] = [xs[here], ys[here], zs[here]];
    let mut least = NONE;
    for (i, ((other_x, other_y), other_z)) in xs.iter().zip(ys).zip(zs).enumerate() {
        let [dx, dy, dz] = [other_x - x, other_y - y, other_z - z];
        let other = key(dx * dx + dy * dy + dz * dz, i as u64);
        least = least.min(if i == here { NONE } else { other });
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recover::neighbours::neighbourhoods;

    #[test]
    fn is_the_first_of_all_neighbours() {
        let column =
            |step: f64| -> Vec<f64> { (0..200).map(|i| (step * f64::from(i)).fract()).collect() };
        let columns = [column(0.618), column(0.414), column(0.732)];
        let points = [&columns[0][..], &columns[1], &columns[2]];
        let first = neighbourhoods(points).into_iter().map(|one| one.indices().next());
        assert!(first.eq(nearest_others(points)));
    }

    #[test]
    fn one_point_has_none_and_twins_have_each_other() {
        assert_eq!(nearest_others([&[1.0]; 3]), [None]);
        assert_eq!(nearest_others([&[1.0, 1.0]; 3]), [Some(1), Some(0)]);
    }
}
