//! The JSON form of deformations; its schema stands in `schema/model-1.schema.json`.

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use super::model_document::{DocumentError, PoseDocument};
use crate::deform::{
    Bend, DeformError, Deformation, Kind, Line, Polyline, Profile, Scale, Spline, Taper, Twist,
};
use crate::math::Univariate;
use crate::pose::Pose;

/// A deformation: its kind and parameters, and the frame that it acts in.
///
/// `frame` is a pose from the deformation's own frame to the shape's, `axis` a line in the
/// shape's frame that its z axis lies on; without both its frame is the shape's.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct DeformationDocument {
    #[serde(flatten)]
    kind: KindDocument,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    frame: Option<PoseDocument>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    axis: Option<AxisDocument>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
enum KindDocument {
    Scale { factors: [f64; 3] },
    Taper { profile: ProfileDocument },
    Twist { profile: ProfileDocument },
    Bend { rate: f64, center: f64, range: [f64; 2] },
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "form", rename_all = "lowercase")]
enum ProfileDocument {
    Line { at_zero: f64, slope: f64 },
    Polyline { knots: Vec<[f64; 2]> },
    Spline { knots: Vec<[f64; 2]> },
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct AxisDocument {
    #[serde(default)]
    origin: [f64; 3],
    direction: [f64; 3],
}

impl DeformationDocument {
    /// The document of a deformation.
    ///
    /// # Errors
    /// If its profile is a function that has no document.
    pub fn new(deformation: &Deformation) -> Result<Self, DocumentError> {
        let is_upright = *deformation.frame() == Pose::identity();
        Ok(Self {
            kind: KindDocument::new(deformation.kind())?,
            frame: (!is_upright).then(|| deformation.frame().into()),
            axis: None,
        })
    }

    /// The deformation that is meant.
    ///
    /// # Errors
    /// If it has both a frame and an axis, or parameters outside their domain.
    pub fn to_deformation(&self) -> Result<Deformation, DocumentError> {
        let kind = self.kind.to_kind()?;
        match (&self.frame, &self.axis) {
            (Some(_), Some(_)) => Err(DocumentError::TwoFrames),
            (Some(frame), None) => Ok(Deformation::in_frame(kind, frame.to_pose()?)),
            (None, Some(AxisDocument { origin, direction })) => {
                let [origin, direction] = [origin, direction].map(|v| Vector3::from(*v));
                Ok(Deformation::about(kind, origin, direction)?)
            }
            (None, None) => Ok(Deformation::new(kind)),
        }
    }
}

impl KindDocument {
    fn new(kind: &Kind) -> Result<Self, DocumentError> {
        Ok(match kind {
            Kind::Scale(scale) => Self::Scale { factors: scale.factors() },
            Kind::Taper(taper) => Self::Taper { profile: ProfileDocument::new(taper.profile())? },
            Kind::Twist(twist) => Self::Twist { profile: ProfileDocument::new(twist.profile())? },
            Kind::Bend(bend) => {
                Self::Bend { rate: bend.rate(), center: bend.center(), range: bend.range() }
            }
        })
    }

    fn to_kind(&self) -> Result<Kind, DeformError> {
        Ok(match self {
            Self::Scale { factors } => Scale::new(*factors)?.into(),
            Self::Taper { profile } => Taper::new(profile.to_profile()?).into(),
            Self::Twist { profile } => Twist::new(profile.to_profile()?).into(),
            Self::Bend { rate, center, range } => Bend::new(*rate, *center, *range)?.into(),
        })
    }
}

impl ProfileDocument {
    fn new(profile: &Profile) -> Result<Self, DocumentError> {
        match profile {
            Profile::Line(line) => {
                Ok(Self::Line { at_zero: line.at_zero(), slope: line.slope(0.0) })
            }
            Profile::Polyline(polyline) => Ok(Self::Polyline { knots: polyline.knots().to_vec() }),
            Profile::Spline(spline) => Ok(Self::Spline { knots: spline.knots().to_vec() }),
            Profile::Function(_) => Err(DocumentError::Function),
        }
    }

    fn to_profile(&self) -> Result<Profile, DeformError> {
        Ok(match self {
            Self::Line { at_zero, slope } => Line::new(*at_zero, *slope)?.into(),
            Self::Polyline { knots } => Polyline::new(knots.clone())?.into(),
            Self::Spline { knots } => Spline::new(knots.clone())?.into(),
        })
    }
}
