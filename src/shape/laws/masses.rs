//! Volume, centroid, inertia and area.

use std::f64::consts::PI;

use nalgebra::{Matrix3, Vector3};

use super::*;

/// Points counted of each box.
const COUNT: u32 = 20_000;

/// Points spread evenly over a box (Roberts 2018, "The unreasonable effectiveness of
/// quasirandom sequences").
fn spread([min, max]: [Vector3<f64>; 2]) -> impl Iterator<Item = Vector3<f64>> {
    const STEPS: [f64; 3] =
        [0.819_172_513_396_164_5, 0.671_043_606_703_789_3, 0.549_700_477_901_96];
    (1..=COUNT).map(move |i| {
        let shares = Vector3::from(STEPS.map(|step| (0.5 + f64::from(i) * step).fract()));
        min + shares.component_mul(&(max - min))
    })
}

#[test]
fn volume_centroid_and_moments_are_those_counted() {
    try_on_all(36, |Example { shape, .. }| {
        let corners = shape.bounding_box();
        let extent = corners[1] - corners[0];
        let inside: Vec<_> = spread(corners).filter(|x| shape.contains(x)).collect();
        let (total, count) = (f64::from(COUNT), inside.len() as f64);
        let mass = shape.mass_properties();

        // Five standard errors of independent points; these are spread more evenly.
        let error = 5.0 * ((total - count) / (total * count)).sqrt();
        let counted = extent.product() * count / total;
        assert!(
            (counted / mass.volume() - 1.0).abs() < error,
            "{shape:?} {counted} {}",
            mass.volume()
        );

        let centroid = inside.iter().sum::<Vector3<f64>>() / count;
        let moments = inside.iter().map(|x| x * x.transpose()).sum::<Matrix3<f64>>() / count;
        let found = mass.second_moments() / mass.volume();
        let error = 5.0 / count.sqrt();
        for i in 0..3 {
            assert!((centroid - mass.centroid())[i].abs() < error * 0.5 * extent[i], "{shape:?}");
            for j in 0..3 {
                let scale = 0.25 * extent[i] * extent[j];
                let difference = (moments - found)[(i, j)].abs();
                assert!(difference < error * scale, "{shape:?} {moments} {found}");
            }
        }
        1
    });
}

#[test]
fn everything_scales_with_powers_of_the_length() {
    for factor in [1e-6, 1e3] {
        for exponents in EXPONENTS.map(|e| [e, 1.3]) {
            for (before, after) in families(SIZE, exponents)
                .into_iter()
                .zip(families(SIZE.map(|a| a * factor), exponents))
            {
                let [before, after] = [before.shape, after.shape];
                let [mass, scaled] = [before, after].map(|shape| shape.mass_properties());
                let x = 1.1 * before.position(0.2, 0.3);
                let n = Vector3::new(0.3, -0.4, 0.5);
                let ratios = [
                    scaled.volume() / mass.volume() / factor.powi(3),
                    scaled.inertia().norm() / mass.inertia().norm() / factor.powi(5),
                    after.surface_area() / before.surface_area() / factor.powi(2),
                    after.support(&n) / before.support(&n) / factor,
                    after.radial_distance(&(factor * x)) / before.radial_distance(&x) / factor,
                    after.inside_outside(&(factor * x)) / before.inside_outside(&x),
                ];
                let is_one = |ratio: &f64| (ratio - 1.0).abs() < 1e-11;
                assert!(ratios.iter().all(is_one), "{after:?} {ratios:?}");
            }
        }
    }
}

/// A function's closed form, what was found, and where it comes from.
fn assert_closed_forms(cases: &[(&str, f64, f64)]) {
    for (name, found, expected) in cases {
        assert!((found / expected - 1.0).abs() < 1e-10, "{name}: {found} {expected}");
    }
}

#[test]
fn a_torus_has_the_textbooks_masses() {
    let (r, ring) = (0.7, 2.1);
    let torus = Supertoroid::new([r; 3], [1.0, 1.0], ring / r).unwrap();
    let volume = 2.0 * PI * PI * ring * r * r;
    let inertia = torus.mass_properties().inertia();
    assert_closed_forms(&[
        ("volume", torus.volume(), volume),
        ("area", torus.surface_area(), 4.0 * PI * PI * ring * r),
        ("about z", inertia[(2, 2)], volume * (ring * ring + 0.75 * r * r)),
        ("about x", inertia[(0, 0)], volume * (0.5 * ring * ring + 0.625 * r * r)),
    ]);
}

#[test]
fn a_square_ring_of_square_section_is_the_difference_of_boxes() {
    let ring = Supertoroid::new([1.0, 2.0, 0.5], [1e-5, 1e-5], 3.0).unwrap();
    let volume = (8.0 * 16.0 - 4.0 * 8.0) * 1.0;
    assert!((ring.volume() / volume - 1.0).abs() < 1e-8);
    let faces = 2.0 * volume + 2.0 * (8.0 + 16.0) + 2.0 * (4.0 + 8.0);
    // Of exponent 1e-5 in place of 0 the edges take a share of that order.
    assert!((ring.surface_area() / faces - 1.0).abs() < 1e-4);
}

#[test]
fn quadric_hyperboloids_have_the_textbooks_masses() {
    let (a, c, h) = (1.5_f64, 2.0_f64, 3.0_f64);
    let tower = SuperhyperboloidOneSheet::new([a, a, c], [1.0, 1.0], h).unwrap();
    let rim = a * a * (1.0 + h * h / (c * c));
    let side = {
        // 2 pi times the integral of a sqrt(1 + k z^2).
        let k = (a * a + c * c) / c.powi(4);
        let root = (1.0 + k * h * h).sqrt();
        2.0 * PI * a * (h * root + (k.sqrt() * h).asinh() / k.sqrt())
    };
    let bowls = SuperhyperboloidTwoSheets::new([c, a, a], [1.0, 1.0], h).unwrap();
    let cap = a * a * (h * h / (c * c) - 1.0);
    let bowl = {
        // 2 pi times the integral of b sqrt(k x^2 - 1) from c on.
        let k = (a * a + c * c) / c.powi(4);
        let integral = |x: f64| {
            let root = (k * x * x - 1.0).sqrt();
            0.5 * (x * root - (k.sqrt() * x + root).ln() / k.sqrt())
        };
        2.0 * PI * a * (integral(h) - integral(c))
    };
    assert_closed_forms(&[
        ("tower's volume", tower.volume(), 2.0 * PI * a * a * (h + h.powi(3) / (3.0 * c * c))),
        ("tower's area", tower.surface_area(), side + 2.0 * PI * rim),
        (
            "bowls' volume",
            bowls.volume(),
            2.0 * PI * a * a * ((h.powi(3) - c.powi(3)) / (3.0 * c * c) - (h - c)),
        ),
        ("bowls' area", bowls.surface_area(), 2.0 * (bowl + PI * cap)),
    ]);
}

#[test]
fn bevelled_hyperboloids_have_plane_faces() {
    // |x| + |y| - |z| = 1 up to z = 1: frusta of squares with corners at 1 and 2.
    let tower = SuperhyperboloidOneSheet::new([1.0; 3], [2.0, 2.0], 1.0).unwrap();
    // |x| - |y| - |z| = 1 up to x = 2: pyramids.
    let bowls = SuperhyperboloidTwoSheets::new([1.0; 3], [2.0, 2.0], 2.0).unwrap();
    let root3 = 3.0_f64.sqrt();
    assert_closed_forms(&[
        ("tower's volume", tower.volume(), 2.0 * (2.0 + 8.0 + 4.0) / 3.0),
        ("tower's area", tower.surface_area(), 2.0 * (8.0 - 2.0) * root3 + 2.0 * 8.0),
        ("pyramids' volume", bowls.volume(), 2.0 * 2.0 / 3.0),
        ("pyramids' area", bowls.surface_area(), 2.0 * (2.0 + 2.0 * root3)),
    ]);
}

#[test]
fn exponents_one_and_twice_two_make_paraboloids() {
    let (radius, height) = (1.5_f64, 2.0_f64);
    let solid = ThreeExponent::new([height, radius, radius], [1.0, 2.0, 2.0]).unwrap();
    let slant = (radius * radius + 4.0 * height * height).powf(1.5) - radius.powi(3);
    assert_closed_forms(&[
        ("volume", solid.volume(), PI * radius * radius * height),
        ("area", solid.surface_area(), 2.0 * PI * radius / (6.0 * height * height) * slant),
    ]);
}

#[test]
fn equal_exponents_make_a_superellipsoid_of_three() {
    for e in EXPONENTS {
        let three = ThreeExponent::new(SIZE, [2.0 / e; 3]).unwrap();
        let two = Superellipsoid::new(SIZE, [e, e]).unwrap();
        let [a, b] = [three.mass_properties(), two.mass_properties()];
        assert_closed_forms(&[
            ("volume", a.volume(), b.volume()),
            ("moments", a.second_moments().norm(), b.second_moments().norm()),
            ("area", three.surface_area(), two.surface_area()),
        ]);
    }
}
