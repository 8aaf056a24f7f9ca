//! Models that go to other programs and come back are the same solids, and damage does no harm.

mod common;

use common::Scene;
use nalgebra::Vector3;
use proptest::prelude::*;
use superquadric::exchange::{ExportError, ExportFormat, ImportFormat};
use superquadric::model::Model;
use superquadric::pose::Pose;
use superquadric::shape::{
    Shape, Superellipsoid, SuperhyperboloidOneSheet, Supertoroid, ThreeExponent,
};
use superquadric::surface::format::MeshFormat;
use superquadric::surface::{Resolution, tessellate};

/// What is written as what it is read as.
const BOTH_WAYS: [(ExportFormat, ImportFormat); 6] = [
    (ExportFormat::Ovito, ImportFormat::Ovito),
    (ExportFormat::Liggghts, ImportFormat::Liggghts),
    (ExportFormat::Lammps, ImportFormat::Lammps),
    (ExportFormat::Mercury, ImportFormat::Mercury),
    (ExportFormat::Ems, ImportFormat::Ems),
    (ExportFormat::SuperCompose, ImportFormat::SuperCompose),
];

/// Programs for contacts of convex, smooth particles.
const CONTACT_SOLVERS: [ExportFormat; 3] =
    [ExportFormat::Liggghts, ExportFormat::Lammps, ExportFormat::Mercury];

/// Rotations where one or another form of them is worst determined.
fn awkward_rotations() -> Vec<[f64; 3]> {
    use std::f64::consts::{FRAC_PI_2, PI};
    let mut all = vec![[0.3, 1.1, -0.8], [3.0, 1e-9, -3.0]];
    for phi in [0.0, FRAC_PI_2, PI, -0.7] {
        for theta in [0.0, FRAC_PI_2, FRAC_PI_2 - 1e-9, PI] {
            all.extend([0.0, FRAC_PI_2, PI].map(|psi| [phi, theta, psi]));
        }
    }
    all
}

fn models() -> Vec<Model> {
    let sizes = [[1.0, 2.0, 3.0], [1.0, 0.01, 0.3], [1e-6, 3e-6, 2e-6], [4e3, 1e3, 9e3]];
    let exponents = [[0.1, 0.1], [0.05, 1.0], [0.3, 0.7], [1.0, 1.0], [1.3, 0.4], [2.0, 2.0]];
    let mut models = Vec::new();
    for (i, euler) in awkward_rotations().into_iter().enumerate() {
        let size = sizes[i % sizes.len()];
        let centre = Vector3::new(1.5, -0.25, 7.0) * size[0];
        models.extend(exponents.map(|exponents| Model {
            shape: Superellipsoid::new(size, exponents).unwrap(),
            pose: Pose::from_euler_zyz(euler, centre),
        }));
    }
    models
}

/// Compares the inside-outside functions of two models at points in and around them.
fn assert_same_solid(a: &Model, b: &Model, scene: &mut Scene) {
    let [a1, a2, a3] = a.shape.size();
    for _ in 0..50 {
        let x_model = Vector3::from([a1, a2, a3].map(|a| a * scene.uniform(-1.5, 1.5)));
        let x_world = a.pose.world_from_model(&x_model);
        let [expected, found] = [a, b].map(|model| model.inside_outside(&x_world));
        assert!((found - expected).abs() <= 1e-12 * expected.max(1.0), "{a:?}\n{b:?}");
    }
}

#[test]
fn what_is_written_and_read_is_the_same_solid() {
    let mut scene = Scene::new(5);
    let mut compared = 0;
    for model in models() {
        for (to, from) in BOTH_WAYS {
            let is_round = model.shape.exponents().iter().all(|&e| e <= 1.0);
            if CONTACT_SOLVERS.contains(&to) && !is_round {
                continue;
            }
            let text = to.text(model).unwrap();
            let read = from.models(&text).unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(read.len(), 1);
            assert_same_solid(&model, &read[0], &mut scene);
            compared += 1;
        }
    }
    // Four exponents of six for the contact solvers.
    assert_eq!(compared, awkward_rotations().len() * (3 * 6 + 3 * 4));
}

#[test]
fn shapes_that_a_program_cannot_express_are_named_errors() {
    let model = |exponents| Model {
        shape: Superellipsoid::new([1.0, 2.0, 3.0], exponents).unwrap(),
        pose: Pose::identity(),
    };
    for (programs, exponents, index, range) in [
        (&CONTACT_SOLVERS[..], [1.0, 1.0 + 1e-9], 1, "exponents from 0 to 1"),
        (&CONTACT_SOLVERS[..], [1.5, 0.3], 0, "exponents from 0 to 1"),
        (&[ExportFormat::Pov][..], [0.099, 0.3], 0, "exponents from 0.1"),
    ] {
        for program in programs {
            let error = program.text(model(exponents)).unwrap_err();
            assert!(error.to_string().contains(range), "{error}");
            let ExportError::Exponent { index: found, value, .. } = error else {
                panic!("{error}");
            };
            assert_eq!((found, value), (index, exponents[index]));
        }
    }
    for program in ExportFormat::ALL {
        assert!(program.text(model([0.1, 1.0])).is_ok());
    }
}

#[test]
fn other_families_are_named_errors_but_for_what_vtk_has() {
    let hyperboloid = SuperhyperboloidOneSheet::new([1.0; 3], [1.0; 2], 1.0).unwrap();
    let toroid = |ring| Supertoroid::new([1.0, 0.7, 0.4], [0.4, 1.3], ring).unwrap();
    let three = ThreeExponent::new([1.0; 3], [2.0; 3]).unwrap();
    let posed = |shape| Model { shape, pose: Pose::identity() };
    for program in ExportFormat::ALL {
        for shape in [Shape::from(hyperboloid), three.into(), toroid(2.5).into()] {
            let is_known = program == ExportFormat::Vtk && matches!(shape, Shape::Supertoroid(_));
            match program.text(posed(shape)) {
                Ok(text) => assert!(is_known && text.contains("RING = 2.5"), "{text}"),
                Err(error) => assert!(
                    !is_known && error.to_string().contains(shape.family()),
                    "{program:?}: {error}"
                ),
            }
        }
    }
    let error = ExportFormat::Vtk.text(posed(toroid(1.1e4).into())).unwrap_err();
    assert!(error.to_string().contains("rings up to 10000, found ring = 11000"), "{error}");
}

#[test]
fn files_as_the_programs_write_them_are_read() {
    // A particle of size 1, 2, 3 at (4, 5, 6), turned by a right angle about z, of e = 0.5, 0.25.
    let liggghts_dump = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\n\
        ITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n\
        ITEM: ATOMS id type x y z\n1 1 0 0 0\n\
        ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n1\n\
        ITEM: BOX BOUNDS ff ff ff\n0 9\n0 9\n0 9\n\
        ITEM: ATOMS id type mass x y z shapex shapey shapez quat1 quat2 quat3 quat4 \
        blockiness1 blockiness2\n\
        7 1 0.5 4 5 6 1 2 3 0.707106781186547 0 0 0.707106781186547 4 8\n";
    let liggghts = "atom_style superquadric\ncreate_atoms 1 single 0 0 0\n\
        create_atoms 1 single 4 5 6 units box\nset atom 1 type 2 shape 1 1 1\n\
        set atom 2 type 2 shape 1 2 3 blockiness 4 8 density 2500 vz 0.1 quat 0 0 1 90 # about z\n";
    let ovito = "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\n\
        ITEM: BOX BOUNDS abc origin ff ff ff\n10 0 0 0\n0 10 0 0\n0 0 10 0\n\
        ITEM: ATOMS id type x y z c_shape[1] c_shape[2] c_shape[3] quati quatj quatk quatw \
        SuperquadricRoundnessPhi SuperquadricRoundnessTheta\n\
        1 1 4 5 6 1 2 3 0 0 1 1 0.25 0.5\n";
    let lammps = "LAMMPS data file via write_data, Ellipsoids and Atoms\n\n1 atoms\n1 ellipsoids\n\n\
        0 9 xlo xhi\n\nMasses\n\n1 1\n\nAtoms # ellipsoid\n\n5 1 1 2500 4 5 6 0 0 0\n\n\
        Velocities\n\n5 0 0 0 0 0 0\n\nEllipsoids\n\n5 2 4 6 1 0 0 1 4 8\n";
    let mercury = "restart_version 1.0 name Example\nParticles 1\n\
        SuperQuadricParticle id 3 indSpecies 0 position 4 5 6 orientation 1 0 0 1 \
        velocity 0 0 0 angularVelocity 0 0 0 0 force 0 0 0 torque 0 0 0 radius 4 \
        invMass 1 axes 1 2 3 exp1 0.5 exp2 0.25\nInteractions 0\n";
    let ems = "[[0.5, 0.25, 1, 2, 3, 1.5707963267948966, 0, 0, 4, 5, 6]]";
    let supercompose = r#"{"components": [{"scale": [1, 2, 3], "position": [4, 5, 6],
        "rotation": [[0, -1, 0], [1, 0, 0], [0, 0, 1]], "epsilon1": 0.5, "epsilon2": 0.25}]}"#;
    let turned = [0.0, 0.0, std::f64::consts::FRAC_PI_2];
    let expected = Model {
        shape: Superellipsoid::new([1.0, 2.0, 3.0], [0.5, 0.25]).unwrap(),
        pose: Pose::from_euler_zyz(turned, Vector3::new(4.0, 5.0, 6.0)),
    };
    let mut scene = Scene::new(6);
    for (format, text) in [
        (ImportFormat::Liggghts, liggghts_dump),
        (ImportFormat::Liggghts, liggghts),
        (ImportFormat::Ovito, ovito),
        (ImportFormat::Lammps, lammps),
        (ImportFormat::Mercury, mercury),
        (ImportFormat::Ems, ems),
        (ImportFormat::SuperCompose, supercompose),
    ] {
        let models = format.models(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert_same_solid(&expected, models.last().unwrap(), &mut scene);
    }
}

#[test]
fn what_is_wrong_is_named_with_its_line() {
    use ImportFormat::{Ems, Lammps, Liggghts, Mercury, Ovito, SuperCompose};
    let cases = [
        (Ems, "", "holds no superquadric: expected lines of eleven numbers"),
        (Ems, "1 1 1 2 3 0 0 0 0 0", "line 1: expected a number"),
        (Ems, "\n1 1 1 2 -3 0 0 0 0 0 0", "line 2: size[2] must be a positive number, found -3"),
        (Ems, "1 1 1 2 3 0 0 0 0 0 0 0.1 0.2", "no more than eleven numbers, found \"0.1\""),
        (Ems, "1 1 1 2 3 0 0 0 0 0 inf", "line 1: expected a number"),
        (SuperCompose, "{}", "missing field `components`"),
        (SuperCompose, r#"{"components": []}"#, "holds no superquadric"),
        (
            SuperCompose,
            r#"{"components": [{"scale": [1, 2, 3], "position": [4, 5, 6], "epsilon1": 0,
               "rotation": [[1, 0, 0], [0, 1, 0], [0, 0, 1]], "epsilon2": 1}]}"#,
            "components[0]: exponents[0]",
        ),
        (Lammps, "c\nAtoms\n1 1 1 1 0 0 0\n", "sections Atoms and Ellipsoids"),
        (Lammps, "c\nEllipsoids\n1 2 2 2 1 0 0 0\n", "line 3: expected the ID of one of the Atoms"),
        (
            Lammps,
            "c\nAtoms\n1 1 1 1 0 0 0\nEllipsoids\n1 2 2 2 0 0 0 0\n",
            "line 5: the rotation must be",
        ),
        (
            Lammps,
            "c\nAtoms\n1 1 1 1 0 0 0\nEllipsoids\n1 2 2 2 1 0 0 0 4\n",
            "line 5: expected a number (block), found \"the end of the line\"",
        ),
        (Liggghts, "run 1\n", "holds no superquadric"),
        (Liggghts, "set atom 1 shape 1 1 1\n", "line 1: expected the ID of an atom created before"),
        (
            Liggghts,
            "create_atoms 1 single 0 0 0\nset atom 1 blockiness ${n1} 2\n",
            "line 2: expected a number (blockiness), found \"${n1}\"",
        ),
        (Liggghts, "create_atoms 1 single 0 0 0\n", "line 1: size[0]"),
        (Liggghts, "ITEM: ATOMS id x y z\n", "line 1: expected a column shapex"),
        (Ovito, "ITEM: TIMESTEP\n0\n", "holds no superquadric: expected a dump"),
        (Ovito, "ITEM: ATOMS x y\n1 2\n1\n", "line 3: expected 2 columns as in line 1"),
        (Mercury, "SuperQuadricParticle id 0 axes 1 2\n", "line 1: expected a number (axes)"),
        (Mercury, "SuperQuadricParticle id 0\n", "line 1: expected axes"),
    ];
    for (format, text, expected) in cases {
        let message = format.models(text).unwrap_err().to_string();
        assert!(message.contains(expected), "{message:?} does not name {expected:?}");
    }
}

/// A text with some of its bytes changed, cut short, or repeated.
fn damaged(text: &str, changes: &[(usize, u8)], length: usize) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for &(place, byte) in changes {
        let place = place % bytes.len();
        bytes[place] = byte;
    }
    bytes.truncate(1 + length % bytes.len());
    String::from_utf8_lossy(&bytes).into_owned()
}

proptest! {
    #[test]
    fn damage_gives_models_or_an_error(
        changes in prop::collection::vec((any::<usize>(), any::<u8>()), 0..4),
        length in any::<usize>(),
    ) {
        let model = Model {
            shape: Superellipsoid::new([1.0, 2.0, 3.0], [0.3, 0.7]).unwrap(),
            pose: Pose::from_euler_zyz([0.3, 1.1, -0.8], Vector3::new(1.5, -0.25, 7.0)),
        };
        for (to, from) in BOTH_WAYS {
            let text = damaged(&to.text(model).unwrap(), &changes, length);
            if let Ok(models) = from.models(&text) {
                prop_assert!(!models.is_empty());
                for model in models {
                    prop_assert!(model.parameters().iter().all(|value| value.is_finite()));
                }
            }
        }
    }

    #[test]
    fn damaged_meshes_give_a_model_or_an_error(
        changes in prop::collection::vec((0_usize..2000, any::<u8>()), 0..4),
        length in 0_usize..4000,
    ) {
        let model = Model {
            shape: Superellipsoid::new([1.0, 2.0, 3.0], [0.3, 0.7]).unwrap(),
            pose: Pose::from_euler_zyz([0.3, 1.1, -0.8], Vector3::new(1.5, -0.25, 7.0)),
        };
        let mesh = tessellate(&model.shape, Resolution::new(2).unwrap());
        let model = model.into();
        for format in [MeshFormat::Ply, MeshFormat::Obj, MeshFormat::Stl, MeshFormat::Glb] {
            let mut bytes = Vec::new();
            format.write(&mesh, Some(&model), &mut bytes).unwrap();
            for &(place, byte) in &changes {
                let place = place % bytes.len();
                bytes[place] = byte;
            }
            bytes.truncate(length);
            if let Ok(model) = format.read_model(&mut &bytes[..]) {
                prop_assert!(model.bounding_box().iter().flatten().all(|bound| !bound.is_nan()));
            }
        }
    }
}
