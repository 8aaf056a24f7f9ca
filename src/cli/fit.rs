//! `superquadric fit`: a cloud in, a model out.

use std::time::Instant;

use super::args::FitArgs;
use super::error::CliError;
use super::input::{is_stream, name};
use super::output::{print, write_inliers, write_mesh, write_text};
use super::scene::Scene;
use super::{DONE, UNTRUSTED};
use crate::recover::{FitOptions, fit};
use crate::report::{FitDocument, fit_table};
use crate::surface::format::MeshFormat;

pub(super) fn run(args: &FitArgs) -> Result<u8, CliError> {
    if let Some(mesh) = &args.mesh {
        // Refused before the work rather than after it.
        MeshFormat::from_extension(mesh)?;
    }
    let Scene { cloud, sight, support } = Scene::read(&args.cloud, &args.sensor, args.search.seed)?;
    let constraints = args.shape.constraints();
    let options = FitOptions { sight, support, constraints, ..args.search.options(args.threads) };
    let start = Instant::now();
    let fit = fit(&cloud, &options)
        .map_err(|source| CliError::Fit { name: name(&args.cloud), source })?;
    let seconds = start.elapsed().as_secs_f64();

    if let Some(mesh) = &args.mesh {
        write_mesh(mesh, &fit.model, args.resolution)?;
    }
    if let Some(inliers) = &args.inliers {
        write_inliers(inliers, &cloud, &fit.is_inlier)?;
    }
    if let Some(output) = &args.output {
        write_text(output, &FitDocument::new(&fit, seconds).to_json())?;
    }
    if args.output.as_deref().is_none_or(|output| !is_stream(output)) {
        print(&fit_table(&fit, seconds))?;
    }
    Ok(if fit.is_trusted() { DONE } else { UNTRUSTED })
}
