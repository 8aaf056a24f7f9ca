//! A deformation about or along any axis.

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::bend::Bend;
use super::error::DeformError;
use super::map::Deform;
use super::scale::Scale;
use super::taper::Taper;
use super::twist::Twist;
use crate::math::{Interval, Scalar};
use crate::pose::Pose;

/// The kind of a deformation, in the deformation's own frame: scaling along its axes, taper
/// along and twist about its z axis, bend of its y axis towards z.
#[derive(Debug, Clone, PartialEq)]
pub enum Kind {
    /// B84 section 2.1.
    Scale(Scale),
    /// B84 section 2.2.
    Taper(Taper),
    /// B84 section 2.3.
    Twist(Twist),
    /// B84 section 2.4.
    Bend(Bend),
}

impl Kind {
    /// The deformation's name in tables.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Scale(_) => "scaled",
            Self::Taper(_) => "tapered",
            Self::Twist(_) => "twisted",
            Self::Bend(_) => "bent",
        }
    }
}

macro_rules! kinds {
    ($($kind:ident),*) => {
        $(impl From<$kind> for Kind {
            fn from(deformation: $kind) -> Self {
                Self::$kind(deformation)
            }
        })*

        impl Deform for Kind {
            fn forward_of<S: Scalar>(&self, x: [S; 3]) -> [S; 3] {
                match self { $(Self::$kind(kind) => kind.forward_of(x)),* }
            }

            fn inverse_of<S: Scalar>(&self, x: [S; 3]) -> [S; 3] {
                match self { $(Self::$kind(kind) => kind.inverse_of(x)),* }
            }

            fn check(&self, region: [Interval; 3]) -> Result<(), DeformError> {
                match self { $(Self::$kind(kind) => kind.check(region)),* }
            }

            fn jacobian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
                match self { $(Self::$kind(kind) => kind.jacobian(x)),* }
            }

            fn determinant(&self, x: &Vector3<f64>) -> f64 {
                match self { $(Self::$kind(kind) => kind.determinant(x)),* }
            }

            fn normal_transform(&self, x: &Vector3<f64>) -> Matrix3<f64> {
                match self { $(Self::$kind(kind) => kind.normal_transform(x)),* }
            }
        }
    };
}

kinds!(Scale, Taper, Twist, Bend);

/// A deformation in a frame of its own, which stands anywhere in the object's frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Deformation {
    kind: Kind,
    object_from_own: Pose,
}

impl Deformation {
    /// The deformation along the axes of the object.
    pub fn new(kind: impl Into<Kind>) -> Self {
        Self::in_frame(kind, Pose::identity())
    }

    /// The deformation in a frame of its own: `object_from_own` takes it to the object's.
    pub fn in_frame(kind: impl Into<Kind>, object_from_own: Pose) -> Self {
        Self { kind: kind.into(), object_from_own }
    }

    /// The deformation whose z axis passes through `origin` along `direction`, in the object's
    /// frame: a taper along, or a twist about, any line inside or outside the object.
    ///
    /// # Errors
    /// If the direction has no length, or a coordinate is not finite.
    pub fn about(
        kind: impl Into<Kind>,
        origin: Vector3<f64>,
        direction: Vector3<f64>,
    ) -> Result<Self, DeformError> {
        let length = direction.norm();
        if !(length > 0.0 && length.is_finite() && origin.norm().is_finite()) {
            let (what, expected) = ("the length of an axis", "a positive number");
            return Err(DeformError::Parameter { what, expected, found: length });
        }
        let axis = direction / length;
        let rotation = Rotation3::rotation_between(&Vector3::z(), &axis).unwrap_or_else(|| {
            Rotation3::from_axis_angle(&Vector3::x_axis(), std::f64::consts::PI)
        });
        Ok(Self::in_frame(kind, Pose::new(rotation, origin)))
    }

    /// The kind of the deformation.
    pub fn kind(&self) -> &Kind {
        &self.kind
    }

    /// The motion from the deformation's own frame to the object's.
    pub fn frame(&self) -> &Pose {
        &self.object_from_own
    }

    fn own_from_object(&self, x: &Vector3<f64>) -> Vector3<f64> {
        self.object_from_own.model_from_world(x)
    }

    /// A matrix of the own frame in the object's.
    fn turned(&self, matrix: Matrix3<f64>) -> Matrix3<f64> {
        let rotation = self.object_from_own.rotation().matrix();
        rotation * matrix * rotation.transpose()
    }
}

impl Deform for Deformation {
    fn forward_of<S: Scalar>(&self, x: [S; 3]) -> [S; 3] {
        let own = self.object_from_own.model_from_world_of(x);
        self.object_from_own.world_from_model_of(self.kind.forward_of(own))
    }

    fn inverse_of<S: Scalar>(&self, x_deformed: [S; 3]) -> [S; 3] {
        let own = self.object_from_own.model_from_world_of(x_deformed);
        self.object_from_own.world_from_model_of(self.kind.inverse_of(own))
    }

    fn check(&self, region: [Interval; 3]) -> Result<(), DeformError> {
        self.kind.check(self.object_from_own.model_from_world_of(region))
    }

    fn jacobian(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        self.turned(self.kind.jacobian(&self.own_from_object(x)))
    }

    fn determinant(&self, x: &Vector3<f64>) -> f64 {
        self.kind.determinant(&self.own_from_object(x))
    }

    fn normal_transform(&self, x: &Vector3<f64>) -> Matrix3<f64> {
        self.turned(self.kind.normal_transform(&self.own_from_object(x)))
    }
}
