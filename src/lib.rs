//! Superquadrics: recovery from range points, and their geometry.
//!
//! ```
//! use superquadric::cloud::PointCloud;
//! use superquadric::recover::{FitOptions, fit};
//! use superquadric::shape::Superellipsoid;
//! use superquadric::surface::sample_surface;
//!
//! let truth = Superellipsoid::new([1.0, 2.0, 3.0], [0.3, 1.2])?;
//! let cloud: PointCloud =
//!     sample_surface(&truth, 1000, 0).iter().map(|point| (*point).into()).collect();
//! let fit = fit(&cloud, &FitOptions::default())?;
//! assert!(fit.is_trusted());
//! assert!((fit.model.shape.volume() / truth.volume() - 1.0).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Notation
//!
//! | symbol | meaning |
//! | --- | --- |
//! | `a1 a2 a3` | semi-axes, in the model's or cloud's own unit |
//! | `e1 e2` | exponents: north-south, east-west |
//! | `eta omega` | latitude and longitude on the surface |
//! | `phi theta psi` | Euler angles ZYZ in radians: `R = Rz(phi) Ry(theta) Rz(psi)` |
//! | `p` | the model's centre in the world: `x_world = R x_model + p` |
//! | `F` | inside-outside function (JLS Eq. 2.16) |
//! | `a4` | a supertoroid's ring, in units of a1 along x and of a2 along y |
//! | `n1 n2 n3` | exponents of the solid of three: 2 is round |
//! | `H = F^(e1/2)` | gauge: homogeneous of degree one, 1 on the surface |
//! | `d` | signed radial Euclidean distance (JLS Eq. 2.43), negative inside |
//!
//! Sources are cited by short name and equation: B81 (Barr 1981), FB81 (Franklin and Barr 1981),
//! B84 (Barr 1984), JLS (Jaklic, Leonardis and Solina 2000, chapter 2).
//!
//! # Modules, in the order in which data flows
//!
//! [`math`] -> [`shape`] and [`pose`] -> [`model`], [`deform`] -> [`solid`] -> [`surface`] -> [`raster`],
//! [`compare`]; [`cloud`] and [`view`] -> [`recover`], [`ray`] -> [`outline`] -> [`report`] and [`batch`] -> [`output`] and
//! the command line. Nothing below the command line
//! prints or exits.

pub mod batch;
mod canonical;
#[cfg(feature = "cli")]
pub mod cli;
pub mod cloud;
pub mod compare;
pub mod deform;
pub mod error;
pub mod exchange;
pub mod machine;
pub mod math;
pub mod model;
pub mod outline;
pub mod output;
pub mod pose;
#[cfg(feature = "python")]
mod python;
pub mod raster;
pub mod ray;
pub mod recover;
pub mod report;
pub mod shape;
pub mod solid;
pub mod surface;
pub mod view;
