//! What a sensor saw besides the points: where it stood, and which of its rays came through.

/// A sensor in the cloud's frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Sight {
    /// Where it stood, in the cloud's unit.
    pub viewpoint: [f64; 3],
    /// Its rays next to the object that came through: nothing is in their way. A few hundred
    /// around the object's outline are as good as all.
    pub free: Vec<SightLine>,
}

/// A ray of a sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SightLine {
    /// Its direction, of any length but zero.
    pub direction: [f64; 3],
    /// How far it came, in the cloud's unit; infinite where it met nothing.
    pub reach: f64,
}

impl Sight {
    /// The sensor whose only rays are those to the points.
    pub fn from_viewpoint(viewpoint: [f64; 3]) -> Self {
        Self { viewpoint, free: Vec::new() }
    }
}
