//! The integer lattice on the surface of a cube: its points, numbered, and its squares.

/// The points `[i, j, k]`, `0 <= i, j, k <= n`, that have a coordinate 0 or n.
///
/// Faces that meet share the points of their edge, so whatever is built on the numbers is
/// closed.
#[derive(Debug, Clone, Copy)]
pub(super) struct CubeLattice {
    n: usize,
}

impl CubeLattice {
    /// The lattice of `n >= 1` squares along every edge of the cube.
    pub fn new(n: usize) -> Self {
        Self { n }
    }

    /// Every point, in the order of its number.
    pub fn points(self) -> impl Iterator<Item = [usize; 3]> {
        let n = self.n;
        (0..=n).flat_map(move |k| {
            let is_lid = k == 0 || k == n;
            let layer: Box<dyn Iterator<Item = [usize; 2]>> = if is_lid {
                Box::new((0..=n).flat_map(move |j| (0..=n).map(move |i| [i, j])))
            } else {
                Box::new(self.ring())
            };
            layer.map(move |[i, j]| [i, j, k])
        })
    }

    /// Once around a layer between the lids, counter-clockwise from the corner `[0, 0]`.
    fn ring(self) -> impl Iterator<Item = [usize; 2]> {
        let n = self.n;
        let south = (0..n).map(|i| [i, 0]);
        let east = (0..n).map(move |j| [n, j]);
        let north = (0..n).map(move |i| [n - i, n]);
        let west = (0..n).map(move |j| [0, n - j]);
        south.chain(east).chain(north).chain(west)
    }

    /// The number of a point of the lattice.
    pub fn number(self, [i, j, k]: [usize; 3]) -> usize {
        let n = self.n;
        let lid = (n + 1) * (n + 1);
        if k == 0 {
            return j * (n + 1) + i;
        }
        if k == n {
            return lid + (n - 1) * 4 * n + j * (n + 1) + i;
        }
        let around = match [i, j] {
            [i, 0] if i < n => i,
            [i, j] if i == n && j < n => n + j,
            [i, j] if j == n && i > 0 => 2 * n + (n - i),
            [_, j] => 3 * n + (n - j),
        };
        lid + (k - 1) * 4 * n + around
    }

    /// The corners of every square, counter-clockwise as seen from outside the cube.
    pub fn squares(self) -> impl Iterator<Item = [[usize; 3]; 4]> {
        let n = self.n;
        (0..3).flat_map(move |axis| {
            [0, n].into_iter().flat_map(move |level| {
                (0..n * n).map(move |cell| Self::square(axis, level, [cell % n, cell / n]))
            })
        })
    }

    /// The square of lowest corner `[u, v]` on the face where coordinate `axis` is `level`.
    fn square(axis: usize, level: usize, [u, v]: [usize; 2]) -> [[usize; 3]; 4] {
        let corner = |u: usize, v: usize| {
            let mut point = [level; 3];
            point[(axis + 1) % 3] = u;
            point[(axis + 2) % 3] = v;
            point
        };
        let mut corners = [corner(u, v), corner(u + 1, v), corner(u + 1, v + 1), corner(u, v + 1)];
        if level == 0 {
            corners.reverse();
        }
        corners
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_come_in_the_order_of_their_number() {
        for n in [1, 2, 5] {
            let lattice = CubeLattice::new(n);
            let numbers: Vec<usize> = lattice.points().map(|point| lattice.number(point)).collect();
            assert_eq!(numbers, (0..6 * n * n + 2).collect::<Vec<_>>());
            assert!(lattice.points().all(|point| point.iter().any(|&c| c == 0 || c == n)));
        }
    }

    #[test]
    fn squares_cover_six_faces() {
        for n in [1, 2, 5] {
            assert_eq!(CubeLattice::new(n).squares().count(), 6 * n * n);
        }
    }
}
