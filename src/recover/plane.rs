//! Planes with a side.

use nalgebra::Vector3;

/// The plane `n.x + delta = 0`, in the cloud's frame and unit; the normal n points to the side on
/// which the object is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Plane {
    normal: Vector3<f64>,
    offset: f64,
}

impl Plane {
    /// The plane of `normal.x + offset = 0`, whatever the normal's length. None if that is zero or
    /// not finite, or the offset is not.
    pub fn new(normal: [f64; 3], offset: f64) -> Option<Self> {
        let normal = Vector3::from(normal);
        let scale = normal.amax();
        if !scale.is_normal() || !scale.recip().is_normal() || !offset.is_finite() {
            return None;
        }
        // Divided by the greatest first, so that no square overflows.
        let unit = normal / scale;
        let length = unit.norm();
        let plane = Self { normal: unit / length, offset: offset / scale / length };
        (plane.normal.iter().all(|n| n.is_finite()) && plane.offset.is_finite()).then_some(plane)
    }

    /// The unit normal.
    pub fn normal(&self) -> [f64; 3] {
        self.normal.into()
    }

    /// The offset delta, with the unit normal.
    pub fn offset(&self) -> f64 {
        self.offset
    }

    /// How far a point is from the plane; positive on the object's side.
    pub fn height(&self, point: [f64; 3]) -> f64 {
        self.normal.dot(&Vector3::from(point)) + self.offset
    }

    /// The same plane with its other side.
    pub fn flipped(&self) -> Self {
        Self { normal: -self.normal, offset: -self.offset }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_normal_is_made_a_unit_and_heights_are_signed() {
        let plane = Plane::new([0.0, 3e200, 4e200], 5e200).unwrap();
        assert!((plane.normal()[1] - 0.6).abs() < 1e-15 && (plane.offset() - 1.0).abs() < 1e-15);
        assert!((plane.height([7.0, 1.0, 1.0]) - 2.4).abs() < 1e-15);
        assert!((plane.flipped().height([7.0, 1.0, 1.0]) + 2.4).abs() < 1e-15);
    }

    #[test]
    fn what_is_no_plane_is_refused() {
        for (normal, offset) in [
            ([0.0; 3], 1.0),
            ([f64::NAN, 0.0, 1.0], 0.0),
            ([f64::INFINITY, 0.0, 0.0], 0.0),
            ([1.0, 0.0, 0.0], f64::NAN),
        ] {
            assert_eq!(Plane::new(normal, offset), None);
        }
    }
}
