//! The deformations and chains that must obey the laws, and the points they are tried at.

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::deform::*;
use crate::math::Univariate;
use crate::pose::Pose;

/// Points a law is tried at, of every example.
pub(super) const POINTS: usize = 60;

/// A chain and the box of points that it is tried on.
pub(super) struct Example {
    pub name: &'static str,
    pub chain: Chain,
    half: Vector3<f64>,
}

impl Example {
    fn new(
        name: &'static str,
        stages: impl IntoIterator<Item = Deformation>,
        half: [f64; 3],
    ) -> Self {
        Self { name, chain: Chain::new(stages), half: half.into() }
    }

    /// Length that differences are measured against.
    pub fn unit(&self) -> f64 {
        self.half.max()
    }

    /// Points of the box, its centre and points on its axes and planes among them.
    pub fn points(&self) -> Vec<Vector3<f64>> {
        let mut rng = ChaCha8Rng::seed_from_u64(11);
        let mut draw = || 2.0 * rng.random::<f64>() - 1.0;
        let inside: Vec<_> = (0..POINTS).map(|_| Vector3::new(draw(), draw(), draw())).collect();
        let special = [[0.0, 0.0, 0.0], [0.9, 0.0, 0.0], [0.0, -0.9, 0.0], [0.0, 0.7, 0.9]];
        let all = inside.into_iter().chain(special.map(Vector3::from));
        all.map(|x| x.component_mul(&self.half)).collect()
    }
}

pub(super) fn polyline() -> Polyline {
    Polyline::new(vec![[-1.0, 1.3], [0.1, 1.0], [0.8, 0.4]]).unwrap()
}

fn spline(scale: f64) -> Spline {
    Spline::new(vec![[-scale, 0.2], [0.3 * scale, 1.7], [scale, 0.6]]).unwrap()
}

pub(super) fn line(at_zero: f64, slope: f64) -> Line {
    Line::new(at_zero, slope).unwrap()
}

pub(super) fn bend(rate: f64, center: f64, range: [f64; 2]) -> Bend {
    Bend::new(rate, center, range).unwrap()
}

fn frame() -> Pose {
    Pose::from_euler_zyz([0.4, 1.2, -0.7], Vector3::new(0.3, -0.2, 0.5))
}

fn taper_twist_bend() -> [Deformation; 3] {
    let along_y = Pose::from_euler_zyz([FRAC_PI_2, FRAC_PI_2, 0.0], Vector3::zeros());
    [
        Deformation::new(Taper::new(line(1.0, -0.3))),
        Deformation::about(Twist::new(line(0.2, 0.9)), Vector3::new(1.5, 0.0, 0.0), Vector3::z())
            .unwrap(),
        Deformation::in_frame(bend(0.2, 0.1, [-1.0, 1.2]), along_y),
    ]
}

pub(super) fn examples() -> Vec<Example> {
    let half = [0.8, 1.5, 0.7];
    let of = |name, kind: Kind| Example::new(name, [Deformation::new(kind)], half);
    vec![
        Example::new("no deformation", [], half),
        of("scale", Scale::new([0.2, 1.0, 30.0]).unwrap().into()),
        of("taper, straight", Taper::new(line(1.0, 0.7)).into()),
        of("taper, polyline", Taper::new(polyline()).into()),
        of("taper, spline", Taper::new(spline(0.5)).into()),
        of("twist, straight", Twist::new(line(0.3, 4.0)).into()),
        of("twist, polyline", Twist::new(polyline()).into()),
        of("twist, spline", Twist::new(spline(0.5)).into()),
        of("bend", bend(0.8, 0.1, [-0.7, 0.6]).into()),
        of("bend, k < 0", bend(-1.2, -0.3, [-1.0, 0.9]).into()),
        of("bend, 150 degrees on a side", bend(1.1, 0.0, [-2.4, 2.4]).into()),
        of("bend about a point outside its range", bend(0.9, 3.0, [-0.5, 0.8]).into()),
        of("bend, a whole turn", bend(TAU / 3.0, 0.0, [-1.5, 1.5]).into()).thinner(),
        of("bend, straight", bend(0.0, 0.0, [-1.0, 1.0]).into()),
        of("bend, nearly straight", bend(1e-12, 0.0, [-1.0, 1.0]).into()),
        Example::new(
            "bend, in any frame",
            [Deformation::in_frame(bend(0.5, 0.0, [-0.4, 0.7]), frame())],
            half,
        ),
        Example::new(
            "twist, about a line outside",
            [Deformation::about(
                Twist::new(spline(2.0)),
                Vector3::new(3.0, 1.0, 0.0),
                Vector3::new(1.0, 2.0, -0.5),
            )
            .unwrap()],
            half,
        ),
        Example::new(
            "taper, downwards",
            [Deformation::about(Taper::new(line(2.0, -0.4)), Vector3::zeros(), -Vector3::z())
                .unwrap()],
            half,
        ),
        Example::new("taper, twist and bend", taper_twist_bend(), half),
        Example::new(
            "the same in kilometres",
            taper_twist_bend().map(|stage| enlarged(&stage, 1e6)),
            half.map(|a| a * 1e6),
        ),
        Example::new(
            "the same in micrometres",
            taper_twist_bend().map(|stage| enlarged(&stage, 1e-6)),
            half.map(|a| a * 1e-6),
        ),
    ]
}

impl Example {
    /// The same on a thinner box, whose ends meet after a whole turn.
    fn thinner(mut self) -> Self {
        self.half.z = 0.3;
        self
    }
}

/// The deformation of an object that is `factor` times as large: straight profiles and bends.
fn enlarged(stage: &Deformation, factor: f64) -> Deformation {
    let profile = |profile: &Profile| line(profile.value(0.0), profile.slope(0.0) / factor);
    let kind: Kind = match stage.kind() {
        Kind::Taper(taper) => Taper::new(profile(taper.profile())).into(),
        Kind::Twist(twist) => Twist::new(profile(twist.profile())).into(),
        Kind::Bend(b) => {
            bend(b.rate() / factor, b.center() * factor, b.range().map(|y| y * factor)).into()
        }
        Kind::Scale(scale) => (*scale).into(),
    };
    let frame = stage.frame();
    Deformation::in_frame(kind, Pose::new(*frame.rotation(), frame.translation() * factor))
}
