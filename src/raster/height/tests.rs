use nalgebra::Vector3;

use super::*;

const EXPONENTS: [f64; 7] = [0.05, 0.1, 0.5, 1.0, 1.5, 2.0, 3.0];

/// Points of the surface that the buffer's pixels stand for, with the depth of each.
fn assert_is_surface(buffer: &ZBuffer, shape: &Superellipsoid, placement: &Placement) -> usize {
    let [columns, rows] = buffer.size();
    let centre = placement.centre.map(|c| (2.0 * c).round() / 2.0);
    let mut filled = 0;
    for row in 0..rows {
        for column in 0..columns {
            let depth = f64::from(buffer.depths()[row * columns + column]);
            let [x, y] = [column as f64 - centre[0], row as f64 - centre[1]]
                .map(|steps| steps * placement.pixel);
            let is_in_outline = shape.gauge(&Vector3::new(x, y, 0.0)) < 1.0;
            assert_eq!(depth.is_finite(), is_in_outline, "{shape:?} {column} {row}");
            if is_in_outline {
                let point = Vector3::new(x, y, placement.depth - depth);
                let greatest = shape.size().into_iter().fold(placement.depth.abs(), f64::max);
                // Logarithm, exponential and depth of 24 bits each.
                let gradient = shape.gauge_gradient(&point).norm();
                let distance = (shape.gauge(&point) - 1.0).abs() / gradient;
                assert!(distance <= 3e-7 * greatest, "{shape:?} {point} {distance:e}");
                filled += 1;
            }
        }
    }
    filled
}

#[test]
fn every_pixel_of_the_outline_has_the_depth_of_the_surface() {
    let mut filled = 0;
    for e1 in EXPONENTS {
        for e2 in EXPONENTS {
            for size in [[1.0, 1.0, 1.0], [2.0, 0.7, 0.1], [0.3, 1.0, 10.0]] {
                for centre in [[20.0, 15.5], [17.5, 16.0], [19.8, 15.7]] {
                    let shape = Superellipsoid::new(size, [e1, e2]).unwrap();
                    let mut buffer = ZBuffer::new(41, 32).unwrap();
                    let placement = Placement { centre, depth: 3.0, pixel: 0.1 };
                    write_heights(&mut buffer, &shape, &placement);
                    filled += assert_is_surface(&buffer, &shape, &placement);
                }
            }
        }
    }
    assert!(filled > 10_000, "{filled}");
}

#[test]
fn nothing_depends_on_the_unit() {
    for unit in [1e-6, 1e3] {
        let shape = Superellipsoid::new([2.0 * unit, unit, 0.5 * unit], [0.3, 0.8]).unwrap();
        let mut buffer = ZBuffer::new(50, 50).unwrap();
        let placement = Placement { centre: [25.0, 25.0], depth: 0.0, pixel: 0.1 * unit };
        write_heights(&mut buffer, &shape, &placement);
        assert!(assert_is_surface(&buffer, &shape, &placement) > 500);
    }
}

#[test]
fn what_is_beside_the_buffer_is_cut_off() {
    let shape = Superellipsoid::new([2.0, 2.0, 1.0], [1.0, 0.5]).unwrap();
    let mut filled = 0;
    for column in [-18.0, -3.5, 0.0, 29.0, 33.5, 48.0, 1e9] {
        for row in [-18.0, -0.5, 12.0, 30.0, f64::MAX] {
            let mut buffer = ZBuffer::new(30, 20).unwrap();
            let placement = Placement { centre: [column, row], depth: 0.0, pixel: 0.1 };
            write_heights(&mut buffer, &shape, &placement);
            filled += assert_is_surface(&buffer, &shape, &placement);
        }
    }
    assert!(filled > 500, "{filled}");
}

#[test]
fn of_two_shapes_the_nearer_is_seen() {
    let near = Superellipsoid::new([1.0, 1.0, 1.0], [1.0, 1.0]).unwrap();
    let far = Superellipsoid::new([2.0, 2.0, 1.0], [0.2, 0.2]).unwrap();
    let at = |depth| Placement { centre: [25.0, 25.0], depth, pixel: 0.1 };
    let both = |order: [(&Superellipsoid, f64); 2]| {
        let mut buffer = ZBuffer::new(51, 51).unwrap();
        order.iter().for_each(|(shape, depth)| write_heights(&mut buffer, shape, &at(*depth)));
        buffer
    };
    let buffer = both([(&near, 3.0), (&far, 4.5)]);
    assert_eq!(buffer, both([(&far, 4.5), (&near, 3.0)]));
    let depth = |[column, row]: [usize; 2]| buffer.depths()[row * 51 + column];
    assert_eq!(depth([25, 25]), 2.0);
    let height = (1.0 - 0.85_f32.powi(10)).powf(0.1);
    assert!((depth([42, 25]) - (4.5 - height)).abs() < 1e-6);
    assert!(depth([0, 0]).is_infinite());
}
