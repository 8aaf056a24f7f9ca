//! What a sample of the points shows before anything is fitted.

use nalgebra::Vector3;

use super::clutter::{Clutter, is_hinted_at, seen_area};
use super::evidence::{Evidence, Facing, FreeSpace, SeenArea, Support};
use super::mixture::Room;
use super::neighbours::{MOST_POINTS, Neighbourhood, neighbourhoods, some_neighbourhoods};
use super::normalization::Moments;
use super::options::FitOptions;
use super::sight::Sight;
use super::subset::Subset;
use crate::cloud::PointColumns;

/// Most points of the sample.
const SAMPLE: usize = 3_000;
const _: () = assert!(SAMPLE <= MOST_POINTS);

/// Points of the sample that tell at a glance whether there is anything besides a surface.
const GLANCED_AT: usize = 256;

/// Most rays to points of the sample that are looked along.
const RAYS_TO_POINTS: usize = 100;

/// A sample of the points, and what their neighbours say of them.
#[derive(Debug, Clone)]
pub(crate) struct Survey {
    /// The sample.
    pub points: Subset,
    /// What is not of the surface, if there is any.
    pub clutter: Option<Clutter>,
    /// Where surface and strays lie, in normalised units.
    pub room: Room,
}

impl Survey {
    /// Of the points of a cloud with these moments.
    pub fn of(points: PointColumns, moments: &Moments, seed: u64) -> Self {
        let points = Subset::stratified(points, SAMPLE, seed);
        let normalized = Subset::normalized(points.columns(), &moments.normalization);
        let (clutter, area) = clutter_and_area(normalized.columns());
        let volume = box_volume(normalized.columns(), moments);
        Self { points, clutter, room: Room { area, volume } }
    }

    /// What it tells of the shape, with what the caller knows.
    pub fn evidence(&self, moments: &Moments, options: &FitOptions) -> Evidence {
        let normalization = &moments.normalization;
        let is_area = self.room.area.is_finite() && self.room.area > 0.0;
        // Among clutter a ray may end on a stray.
        let most = if self.clutter.is_some() { 0 } else { RAYS_TO_POINTS };
        let hits = Subset::stratified(self.points.columns(), most, options.seed);
        let sampled = self.points.columns()[0].len();
        let surface_points = self.clutter.as_ref().map_or(sampled, |c| c.surface().len()) as f64;
        // Nor does a stray face the sensor.
        let facing = |sight: &Sight| {
            let points = self.points.columns();
            let is_clean = self.clutter.is_none();
            is_clean.then(|| Facing::from_viewpoint(sight.viewpoint, points, normalization))
        };
        let free_space = |sight: &Sight| FreeSpace::new(sight, hits.columns(), normalization);
        Evidence {
            seen_area: is_area.then_some(SeenArea { area: self.room.area, points: surface_points }),
            facing: options.sight.as_ref().and_then(facing),
            free_space: options.sight.as_ref().map(free_space),
            support: options.support.map(|plane| Support::new(&plane, normalization)),
        }
    }
}

/// What is not of the surface, if there is any, and the area on which the others lie: at a glance,
/// if some of the points do not hint at anything.
fn clutter_and_area(points: PointColumns) -> (Option<Clutter>, f64) {
    let count = points[0].len();
    let every = count / GLANCED_AT;
    if every > 1 {
        let reaches = reaches(&some_neighbourhoods(points, every));
        if !is_hinted_at(&reaches) {
            let area = seen_area(&reaches, &vec![1.0; reaches.len()]);
            return (None, area * count as f64 / reaches.len() as f64);
        }
    }
    let neighbourhoods = neighbourhoods(points);
    match Clutter::find(points, &neighbourhoods) {
        None => (None, seen_area(&reaches(&neighbourhoods), &vec![1.0; count])),
        Some(clutter) => {
            let clutter = clutter.looked_at_again(points);
            let area = clutter.surface_area;
            (Some(clutter), area)
        }
    }
}

fn reaches(neighbourhoods: &[Neighbourhood]) -> Vec<f64> {
    neighbourhoods.iter().map(Neighbourhood::reach).collect()
}

/// The volume of the points' box along the cloud's principal axes.
fn box_volume([xs, ys, zs]: PointColumns, moments: &Moments) -> f64 {
    /// Least side: a flat cloud's strays, too, have room.
    const LEAST_SIDE: f64 = 1e-3;
    let (mut low, mut high) = (Vector3::repeat(f64::INFINITY), Vector3::repeat(f64::NEG_INFINITY));
    for ((x, y), z) in xs.iter().zip(ys).zip(zs) {
        let along = moments.axes.inverse_transform_vector(&Vector3::new(*x, *y, *z));
        (low, high) = (low.inf(&along), high.sup(&along));
    }
    (high - low).map(|side| side.max(LEAST_SIDE)).product()
}
