//! FB81 Fig. 5: a cuboid by raw parametric and by explicit sampling.

use nalgebra::Vector3;
use superquadric::shape::Superellipsoid;
use superquadric::surface::Parameterization;

use crate::picture::{INK, Panel, Picture};
use crate::shading::{self, View};

const SIDE: usize = 270;
const HALF_WIDTH: f64 = 1.75;

/// Steps of a quarter, as in the figure's latitudes and longitudes of 5 degrees.
const STEPS: usize = 18;

/// Share of the half width by which a line may lie behind the surface seen and still be drawn.
const SLACK: f64 = 0.04;

/// Greatest cosine of a normal and the line of sight at which a line is drawn: a net's lines do not
/// follow the outline, and end a little beyond it.
const GRAZING: f64 = 0.2;

/// Both samplings as nets of lines, hidden ones left out.
pub fn parametric_and_explicit() -> Picture {
    let shape = Superellipsoid::new([1.0; 3], [0.2, 0.2]).expect("a valid shape");
    let mut picture = Picture::new(2 * SIDE as u32, SIDE as u32);
    let samplings = [Parameterization::Trigonometric, Parameterization::Explicit];
    for (panel, sampling) in Panel::grid(2, 1, SIDE).iter().zip(samplings) {
        draw_net(&mut picture, panel, &shape, &sampling.superellipsoid(&shape, STEPS));
    }
    picture
}

fn draw_net(
    picture: &mut Picture,
    panel: &Panel,
    shape: &Superellipsoid,
    rows: &[Vec<Vector3<f64>>],
) {
    let camera_from_model = shading::from_above();
    let view = View { shape, camera_from_model, half_width: HALF_WIDTH, color: [1.0; 3] };
    let (buffer, _) = shading::sampled(&view, panel.side);
    let is_seen = |x_model: &Vector3<f64>| {
        let x = camera_from_model * x_model;
        let pixel = [x.x, x.y].map(|c| (0.5 * panel.side as f64 * (1.0 + c / HALF_WIDTH)) as isize);
        let depth = buffer.index(pixel).map_or(f32::INFINITY, |index| buffer.depths()[index]);
        x.z <= f64::from(depth) + SLACK * HALF_WIDTH
            && (camera_from_model * shape.gauge_gradient(x_model)).normalize().z <= GRAZING
    };
    let place = |x_model: &Vector3<f64>| {
        let x = camera_from_model * x_model / HALF_WIDTH;
        panel.place([x.x, -x.y])
    };
    let along = rows.iter().flat_map(|row| row.iter().zip(row.iter().cycle().skip(1)));
    let across = rows.windows(2).flat_map(|pair| pair[0].iter().zip(&pair[1]));
    for (from, to) in along.chain(across) {
        if is_seen(from) && is_seen(to) {
            picture.line(&[place(from), place(to)], 0.8, INK);
        }
    }
}
