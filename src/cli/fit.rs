//! `superquadric fit`: a cloud in, a model out.

use std::path::Path;
use std::time::Instant;

use super::args::FitArgs;
use super::error::CliError;
use super::fit_many;
use super::input::{is_stream, name};
use super::output::{print, write_inliers, write_mesh, write_text};
use super::scene::Scene;
use super::{DONE, UNTRUSTED};
use crate::cloud::PointCloud;
use crate::recover::{Fit, FitOptions, fit};
use crate::report::{FitDocument, fit_table};
use crate::surface::format::MeshFormat;
use crate::surface::tessellate;

/// A fit, the points it was made from, and the time that took.
pub(super) struct Fitted {
    pub fit: Fit,
    pub cloud: PointCloud,
    pub seconds: f64,
}

pub(super) fn run(args: &FitArgs) -> Result<u8, CliError> {
    match &args.clouds[..] {
        [cloud] if !cloud.is_dir() => run_one(args, cloud),
        _ => fit_many::run(args),
    }
}

fn run_one(args: &FitArgs, path: &Path) -> Result<u8, CliError> {
    if let Some(mesh) = &args.mesh {
        // Refused before the work rather than after it.
        MeshFormat::from_extension(mesh)?;
    }
    let options = args.search.options(args.threads);
    let Fitted { fit, cloud, seconds } = fit_file(args, path, options)?;

    if let Some(mesh) = &args.mesh {
        let surface = tessellate(&fit.model.shape, args.resolution).transformed(&fit.model.pose);
        write_mesh(mesh, &surface, Some(&fit.model.into()))?;
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

/// The fit of one file.
pub(super) fn fit_file(
    args: &FitArgs,
    path: &Path,
    options: FitOptions,
) -> Result<Fitted, CliError> {
    let Scene { cloud, sight, support } = Scene::read(path, &args.sensor, args.search.seed)?;
    let options = FitOptions { sight, support, constraints: args.shape.constraints(), ..options };
    let start = Instant::now();
    let fit = fit(&cloud, &options).map_err(|source| CliError::Fit { name: name(path), source })?;
    Ok(Fitted { fit, cloud, seconds: start.elapsed().as_secs_f64() })
}
