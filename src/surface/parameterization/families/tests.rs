use super::*;
use crate::shape::{LevelSet, Parametric, Superellipsoid, ThreeExponent};
use std::f64::consts::{FRAC_PI_2, PI};

const SIZE: [f64; 3] = [2.0, 0.7, 1.3];

/// Ratios of the clips to the waist that are steep and that are hardly any.
const TOPS: [f64; 3] = [1.001, 1.75, 50.0];

fn exponents() -> impl Iterator<Item = [f64; 2]> {
    let exponents = [0.05, 0.1, 0.5, 1.0, 1.5, 2.0, 3.0];
    exponents.into_iter().flat_map(move |e1| exponents.into_iter().map(move |e2| [e1, e2]))
}

fn towers_and_tubes() -> impl Iterator<Item = Shape> {
    exponents().filter(|e| e.iter().all(|e| (0.1..=2.0).contains(e))).flat_map(|e| {
        [
            SuperhyperboloidOneSheet::new(SIZE, e, 2.2).unwrap().into(),
            Supertoroid::new(SIZE, e, 1.6).unwrap().into(),
        ]
    })
}

fn bowls() -> impl Iterator<Item = SuperhyperboloidTwoSheets> {
    exponents().flat_map(|e| {
        TOPS.map(|top| SuperhyperboloidTwoSheets::new(SIZE, e, top * SIZE[0]).unwrap())
    })
}

fn solids_of_three() -> impl Iterator<Item = ThreeExponent> {
    let exponents = [0.7, 1.0, 2.0, 5.0, 40.0];
    let of = move |n1, n2| exponents.map(|n3| ThreeExponent::new(SIZE, [n1, n2, n3]).unwrap());
    exponents.into_iter().flat_map(move |n1| exponents.into_iter().flat_map(move |n2| of(n1, n2)))
}

#[test]
fn rows_are_on_the_surface_and_begin_and_end_where_they_should() {
    for shape in towers_and_tubes() {
        for parameterization in Parameterization::ALL {
            let rows = parameterization.shape(&shape, 8);
            let is_torus = matches!(shape, Shape::Supertoroid(_));
            assert_eq!((rows.len(), rows[0].len()), (if is_torus { 32 } else { 17 }, 32));
            for x in rows.iter().flatten() {
                let level = shape.level((*x).into());
                assert!((level - 1.0).abs() < 1e-12, "{parameterization:?} {shape:?} {x}");
            }
            if is_torus {
                assert!((rows[0][0] - Vector3::new(2.6 * 2.0, 0.0, 0.0)).norm() < 1e-14);
            } else {
                assert_eq!((rows[0][3].z, rows[16][3].z), (-2.2, 2.2));
                assert_eq!(rows[8][0], Vector3::new(2.0, 0.0, 0.0));
            }
            let heights = rows.iter().map(|row| row[0].z).collect::<Vec<_>>();
            assert!(is_torus || heights.windows(2).all(|pair| pair[0] < pair[1]));
        }
    }
}

#[test]
fn rows_of_two_sheets_lead_from_rim_to_rim_on_either() {
    for shape in bowls() {
        for parameterization in Parameterization::ALL {
            let rows = parameterization.shape(&shape.into(), 8);
            assert_eq!((rows.len(), rows[0].len()), (34, 17));
            for (row, other) in rows[..17].iter().zip(&rows[17..]) {
                for (x, y) in row.iter().zip(other) {
                    // The level is 1 on a bowl and its cap.
                    let level = shape.level((*x).into());
                    assert!(
                        (level - 1.0).abs() < 1e-12 * x.x,
                        "{parameterization:?} {shape:?} {x}"
                    );
                    assert!(x.x <= shape.clip() * (1.0 + 1e-14));
                    assert_eq!((x.z, *y), (row[0].z, Vector3::new(-x.x, -x.y, x.z)));
                }
                assert_eq!(row[8].y, 0.0);
                // Where the rim is nearly as low as the row, rounding moves the ends the most.
                for end in [row[0], row[16]] {
                    let defect = (end.x / shape.clip() - 1.0).abs();
                    assert!(defect < 1e-13, "{parameterization:?} {shape:?} {defect:e}");
                }
                assert!(row.windows(2).all(|pair| pair[0].y <= pair[1].y));
            }
            assert_eq!(rows[8][8], Vector3::new(SIZE[0], 0.0, 0.0));
            assert!(rows[..17].windows(2).all(|pair| pair[0][0].z < pair[1][0].z));
            let lowest = &rows[0];
            assert!(lowest.iter().all(|x| *x == lowest[0]));
        }
    }
}

#[test]
fn trigonometric_rows_are_at_even_steps_of_latitude_and_longitude() {
    for shape in bowls() {
        let rows = Parameterization::Trigonometric.shape(&shape.into(), 8);
        let [[south, north], [_, east]] = shape.domain();
        assert_eq!(south, -north);
        for (i, share) in [(9, 0.125), (12, 0.5), (6, -0.25)] {
            // The middle row of the sheet is as long as any, the others end sooner.
            assert!(
                (rows[8][i] - shape.position(0.0, (i as f64 / 8.0 - 1.0) * east)).norm() < 1e-11
            );
            let x = shape.position(share * north, 0.0);
            assert!((rows[(8.0 + 8.0 * share) as usize][8] - x).norm() < 1e-11 * x.norm());
        }
    }
    for shape in solids_of_three() {
        let rows = Parameterization::Trigonometric.shape(&shape.into(), 8);
        for (j, row) in rows.iter().enumerate() {
            for (i, x) in row.iter().enumerate() {
                let eta = FRAC_PI_2 * (j as f64 / 8.0 - 1.0);
                let expected = shape.position(eta, PI * i as f64 / 16.0);
                // Powers of cosines at a right angle, which are no zeros.
                let slack = 1e-11 + 3.0 * 1e-16_f64.powf(2.0 / 40.0) * f64::from(i % 8 == 0);
                let is_pole = j == 0 || j == 16;
                assert!(is_pole || (x - expected).amax() < slack, "{shape:?} {x} {expected}");
            }
        }
    }
}

#[test]
fn rows_of_three_exponents_are_on_the_surface_from_pole_to_pole() {
    for shape in solids_of_three() {
        for parameterization in Parameterization::ALL {
            let rows = parameterization.shape(&shape.into(), 8);
            assert_eq!((rows.len(), rows[0].len()), (17, 32));
            assert!(rows[0].iter().all(|x| *x == Vector3::new(0.0, 0.0, -1.3)));
            assert!(rows[16].iter().all(|x| *x == Vector3::new(0.0, 0.0, 1.3)));
            assert_eq!((rows[8][0], rows[8][8]), (Vector3::x() * 2.0, Vector3::y() * 0.7));
            for x in rows.iter().flatten() {
                let f = shape.level((*x).into());
                assert!((f - 1.0).abs() < 1e-12, "{parameterization:?} {shape:?} {x} {f}");
            }
            if parameterization != Parameterization::AngleCentre {
                assert!(rows.iter().flatten().all(|x| x.iter().all(|c| c.is_finite())));
                assert!(rows.iter().all(|row| row.iter().all(|x| x.z == row[0].z)));
            }
        }
    }
}

#[test]
fn equal_exponents_have_the_rows_of_the_superellipsoid() {
    for n in [1.0, 2.0, 5.0, 40.0] {
        for size in [SIZE, [0.7, 2.0, 1.3]] {
            let three = ThreeExponent::new(size, [n; 3]).unwrap();
            let shape = Superellipsoid::new(size, [2.0 / n; 2]).unwrap();
            for parameterization in Parameterization::ALL {
                let [found, expected] =
                    [three.into(), shape.into()].map(|shape| parameterization.shape(&shape, 8));
                for (x, y) in found.iter().flatten().zip(expected.iter().flatten()) {
                    assert!((x - y).norm() < 1e-11, "{parameterization:?} {n} {x} {y}");
                }
            }
        }
    }
}

/// The lengths of the steps along a row.
fn steps(row: &[[f64; 2]]) -> Vec<f64> {
    row.windows(2).map(|pair| (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1])).collect()
}

/// Chords around a bend fall short of arcs; none is longer.
fn are_equal(steps: &[f64]) -> bool {
    let mean = steps.iter().sum::<f64>() / steps.len() as f64;
    steps.iter().all(|step| (0.65..1.04).contains(&(step / mean)))
}

#[test]
fn equal_distances_along_a_profile_and_a_tube_are_equal() {
    for shape in towers_and_tubes() {
        let rows = Parameterization::EqualDistance.shape(&shape, 64);
        // The copy towards the ring's corner is as wide as any, but for its exponent.
        let [a1, a2, _] = SIZE;
        let place = |row: &Vec<Vector3<f64>>| [row[0].x / a1 * a1.hypot(a2), row[0].z];
        let places: Vec<[f64; 2]> = rows.iter().map(place).collect();
        assert!(are_equal(&steps(&places)), "{shape:?}");
    }
}

#[test]
fn equal_distances_along_rows_of_two_sheets_and_of_three_exponents_are_equal() {
    let of_bowls = bowls().step_by(5).map(Shape::from);
    for shape in of_bowls.chain(solids_of_three().step_by(3).map(Shape::from)) {
        let rows = Parameterization::EqualDistance.shape(&shape, 64);
        for row in rows[1..128].iter().step_by(16) {
            let places: Vec<[f64; 2]> = row.iter().map(|x| [x.x, x.y]).collect();
            assert!(are_equal(&steps(&places)), "{shape:?} {}", row[0].z);
        }
    }
    for shape in bowls().step_by(5) {
        let rows = Parameterization::EqualDistance.shape(&shape.into(), 64);
        let places: Vec<[f64; 2]> = rows[..129].iter().map(|row| [row[64].x, row[64].z]).collect();
        assert!(are_equal(&steps(&places)), "{shape:?}");
    }
}

#[test]
fn equal_angles_of_superhyperbolas_are_those_of_rays_from_the_centre() {
    let tower = SuperhyperboloidOneSheet::new(SIZE, [0.6, 1.0], 2.2).unwrap();
    let rows = Parameterization::AngleCentre.shape(&tower.into(), 8);
    let width = f64::hypot(2.0, 0.7);
    let profile = rows.iter().map(|row| row[0].z.atan2(row[0].x / 2.0 * width));

    let bowls = SuperhyperboloidTwoSheets::new(SIZE, [0.6, 1.4], 3.5).unwrap();
    let rows = Parameterization::AngleCentre.shape(&bowls.into(), 8);
    let meridian = rows[..17].iter().map(|row| row[8].z.atan2(row[8].x));
    let row = rows[11].iter().map(|x| x.y.atan2(x.x));
    let curves: [Vec<f64>; 3] = [profile.collect(), meridian.collect(), row.collect()];
    for angles in curves {
        let step = angles[16] / 8.0;
        assert!(angles.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() < 1e-12));
    }
}

#[test]
fn explicit_steps_are_those_of_one_coordinate_on_each_side_of_a_diagonal() {
    let bowls = SuperhyperboloidTwoSheets::new(SIZE, [0.6, 1.4], 3.5).unwrap();
    let rows = Parameterization::Explicit.shape(&bowls.into(), 8);
    let are_even = |values: Vec<f64>| {
        let step = (values[values.len() - 1] - values[0]) / (values.len() - 1) as f64;
        values.windows(2).all(|pair| (pair[1] - pair[0] - step).abs() < 1e-14)
    };
    assert!(are_even(rows[..17].iter().map(|row| row[0].z).collect()));
    assert!(rows[..17].iter().all(|row| are_even(row.iter().map(|x| x.y).collect())));

    for shape in solids_of_three() {
        for row in &Parameterization::Explicit.shape(&shape.into(), 8)[1..16] {
            let ratios = [row[0].x, row[8].y];
            let quarter: Vec<[f64; 2]> =
                row[..=8].iter().map(|x| [x.x / ratios[0], x.y / ratios[1]]).collect();
            assert!((quarter[4][0] - quarter[4][1]).abs() < 1e-14);
            assert!(are_even(quarter[..=4].iter().map(|u| u[1]).collect()));
            assert!(are_even(quarter[4..].iter().map(|u| u[0]).collect()));
        }
    }
}

#[test]
fn rays_to_three_exponents_are_at_equal_angles() {
    let shape = ThreeExponent::new(SIZE, [1.5, 2.0, 5.0]).unwrap();
    for (j, row) in Parameterization::AngleCentre.shape(&shape.into(), 8).iter().enumerate() {
        for (i, x) in row.iter().enumerate().filter(|_| j % 16 != 0) {
            let latitude = x.z.atan2(x.xy().norm());
            assert!((latitude - FRAC_PI_2 * (j as f64 / 8.0 - 1.0)).abs() < 1e-12);
            let longitude = x.y.atan2(x.x).rem_euclid(2.0 * PI);
            assert!((longitude - PI * i as f64 / 16.0).abs() < 1e-12);
        }
    }
}

#[test]
fn no_steps_make_no_rows() {
    for shape in towers_and_tubes().take(2).chain(bowls().take(1).map(Shape::from)) {
        assert!(Parameterization::ALL.iter().all(|p| p.shape(&shape, 0).is_empty()));
    }
}
