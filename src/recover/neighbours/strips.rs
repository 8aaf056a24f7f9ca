//! Points in strips, for the search of what is near.

use std::ops::Range;

use super::{INDEX, Key, key};
use crate::cloud::PointColumns;

/// Points in a strip for each strip there would be of as many points: the wider, the fewer strips
/// are near, and the more points are looked at in vain.
const WIDTH: usize = 3;

/// Points in strips across their widest coordinate, in each in the order of the next one. By rank,
/// not by width: a few far points do not crowd the others together.
#[derive(Debug)]
pub(super) struct Strips {
    /// The points' coordinates, the widest first, by place.
    x: [Vec<f64>; 3],
    /// Whose they are, by place.
    indices: Vec<u64>,
    /// Points in a strip; the last may have fewer.
    width: usize,
    /// Least and greatest first coordinate of each strip.
    ranges: Vec<[f64; 2]>,
}

impl Strips {
    pub(super) fn of(points: PointColumns) -> Self {
        let widest = widest_column(points);
        let [first, second, _] = [0, 1, 2].map(|k| points[(widest + k) % 3]);
        let mut order: Vec<u64> = (0..first.len() as u64).collect();
        let width = WIDTH * first.len().isqrt().max(1);
        sort_by(&mut order, first);
        let mut ranges = Vec::with_capacity(first.len().div_ceil(width));
        for strip in order.chunks_mut(width) {
            ranges.push([strip[0], strip[strip.len() - 1]].map(|i| first[i as usize]));
            sort_by(strip, second);
        }
        let column = |k: usize| -> Vec<f64> {
            let column = points[(widest + k) % 3];
            order.iter().map(|&i| column[i as usize]).collect()
        };
        Self { x: [0, 1, 2].map(column), indices: order, width, ranges }
    }

    /// The number of points.
    pub(super) fn points(&self) -> usize {
        self.indices.len()
    }

    /// The number of strips.
    pub(super) fn count(&self) -> usize {
        self.ranges.len()
    }

    /// The places of a strip's points.
    pub(super) fn places(&self, strip: usize) -> Range<usize> {
        strip * self.width..self.points().min((strip + 1) * self.width)
    }

    /// The index of the point at a place.
    #[inline(always)]
    pub(super) fn index(&self, place: usize) -> u64 {
        self.indices[place]
    }

    /// The squared distance between the points at two places.
    #[inline(always)]
    pub(super) fn square_between(&self, place: usize, other: usize) -> f64 {
        let [dx, dy, dz] = [0, 1, 2].map(|k| self.x[k][other] - self.x[k][place]);
        dx * dx + dy * dy + dz * dz
    }

    /// How far the point at a place is from the range of a strip.
    #[inline(always)]
    pub(super) fn distance_to(&self, place: usize, strip: usize) -> f64 {
        let [low, high] = self.ranges[strip];
        let x = self.x[0][place];
        (low - x).max(x - high)
    }

    /// Writes the keys of the points at other places, by their distance from one.
    #[inline(always)]
    pub(super) fn write_keys(&self, place: usize, others: Range<usize>, keys: &mut [Key]) {
        let here = [0, 1, 2].map(|k| self.x[k][place]);
        let [x, y, z] = [0, 1, 2].map(|k| &self.x[k][others.clone()]);
        let indices = &self.indices[others];
        for (i, entry) in keys.iter_mut().enumerate().take(indices.len()) {
            let [dx, dy, dz] = [x[i] - here[0], y[i] - here[1], z[i] - here[2]];
            *entry = key(dx * dx + dy * dy + dz * dz, indices[i]);
        }
    }

    /// Windows at the beginning of each strip.
    pub(super) fn windows(&self) -> Windows {
        Windows((0..self.count()).map(|strip| self.places(strip).start).map(|at| [at; 2]).collect())
    }
}

/// For each strip the places that were last looked at. Along a strip windows move little, so the
/// next one is found from the last.
pub(super) struct Windows(Vec<[usize; 2]>);

impl Windows {
    /// The places of a strip whose second coordinate differs by no more than `reach` from that at
    /// a place.
    #[inline(always)]
    pub(super) fn around(
        &mut self,
        strips: &Strips,
        strip: usize,
        place: usize,
        reach: f64,
    ) -> Range<usize> {
        let y = &strips.x[1];
        let (here, places) = (y[place], strips.places(strip));
        let [start, end] = self.0[strip];
        let start = moved(start, &places, |other| here - y[other] > reach);
        let end = moved(end, &places, |other| y[other] - here <= reach);
        self.0[strip] = [start, end];
        start..end
    }
}

/// The first place that is not before a bound, from a place near it.
#[inline(always)]
fn moved(mut at: usize, places: &Range<usize>, is_before: impl Fn(usize) -> bool) -> usize {
    while at > places.start && !is_before(at - 1) {
        at -= 1;
    }
    while at < places.end && is_before(at) {
        at += 1;
    }
    at
}

/// Sorts indices by a column, whose numbers count to eleven digits: both together are one key.
fn sort_by(indices: &mut [u64], column: &[f64]) {
    for index in indices.iter_mut() {
        *index |= ordered_bits(column[*index as usize]) & !INDEX;
    }
    indices.sort_unstable();
    indices.iter_mut().for_each(|key| *key &= INDEX);
}

/// Bits that are in the order of the number, whatever its sign.
fn ordered_bits(x: f64) -> u64 {
    let bits = x.to_bits();
    if x.is_sign_negative() { !bits } else { bits | 1 << 63 }
}

fn widest_column(points: PointColumns) -> usize {
    let width = |column: &[f64]| {
        let low = column.iter().copied().fold(f64::INFINITY, f64::min);
        column.iter().copied().fold(f64::NEG_INFINITY, f64::max) - low
    };
    let widths = points.map(width);
    (0..3).fold(0, |widest, k| if widths[k] > widths[widest] { k } else { widest })
}
