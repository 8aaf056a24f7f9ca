//! Plane curves: FB81 Figs. 3 and 4, JLS Fig. 2.3.

use superquadric::shape::Superellipse;
use superquadric::surface::Parameterization;

use crate::picture::{BLUE, INK, Panel, Picture};

/// Exponents of FB81 Figs. 3 and 4.
const EXPONENTS: [f64; 9] = [10.0, 6.0, 4.0, 3.0, 2.0, 1.0, 0.4, 0.2, 0.1];

/// Half the side of a panel, less its margin.
const SCALE: f64 = 0.9;

/// FB81 Fig. 3: superellipses of nine exponents.
pub fn nine_superellipses() -> Picture {
    let mut picture = Picture::new(420, 420);
    let panel = Panel { corner: [0, 0], side: 420 };
    panel.axes(&mut picture);
    for e in EXPONENTS {
        draw_closed(&mut picture, &panel, &points(Parameterization::EqualDistance, e, 64), 1.5);
    }
    picture
}

/// FB81 Fig. 4: 36 points of equal steps of the angle on each of them.
pub fn equal_steps_of_the_angle() -> Picture {
    let mut picture = Picture::new(540, 540);
    for (panel, e) in Panel::grid(3, 3, 180).iter().zip(EXPONENTS) {
        let points = points(Parameterization::Trigonometric, e, 9);
        draw_closed(&mut picture, panel, &points, 1.0);
        points.iter().for_each(|&x| picture.dot(panel.place(x), 2.5, BLUE));
    }
    picture
}

fn points(parameterization: Parameterization, e: f64, steps: usize) -> Vec<[f64; 2]> {
    let figure = Superellipse::new([SCALE, SCALE], e).expect("a valid superellipse");
    parameterization.superellipse(&figure, steps).into_iter().map(Into::into).collect()
}

fn draw_closed(picture: &mut Picture, panel: &Panel, points: &[[f64; 2]], width: f32) {
    let mut places = panel.places(points);
    places.extend(places.first().copied());
    picture.line(&places, width, INK);
}

/// Exponents `m = p/q` of the nine kinds of Lame curves, JLS Fig. 2.3 a to i.
const LAME: [[i32; 2]; 9] =
    [[8, 3], [2, 3], [5, 2], [3, 4], [5, 3], [3, 5], [-4, 3], [-3, 2], [-5, 3]];

/// JLS Fig. 2.3: Lame curves `x^m + y^m = 1`, all real roots being taken.
pub fn lame_curves() -> Picture {
    let mut picture = Picture::new(540, 540);
    for (panel, m) in Panel::grid(3, 3, 180).iter().zip(LAME) {
        panel.axes(&mut picture);
        for sign in [1.0, -1.0] {
            for branch in lame_branches(m, sign) {
                picture.line(&panel.places(&branch), 1.5, INK);
                let mirrored: Vec<_> = branch.iter().map(|&[x, y]| [y, x]).collect();
                picture.line(&panel.places(&mirrored), 1.5, INK);
            }
        }
    }
    picture
}

/// Half the width of the window that JLS Fig. 2.3's curves are seen through.
const WINDOW: f64 = 2.5;

/// Stretches of `y^m = 1 - x^m` with `|y| <= |x|`; the rest is their reflection.
///
/// A root of even degree has both signs: of y where p is even, of `x^m` where q is.
fn lame_branches([p, q]: [i32; 2], sign: f64) -> Vec<Vec<[f64; 2]>> {
    let steps = 6000;
    let mut branches = vec![Vec::new()];
    for i in -steps..=steps {
        let x = WINDOW * f64::from(i) / f64::from(steps);
        let power = real_power(x, p, q).map(|power| if q % 2 == 0 { sign * power } else { power });
        let y = power.and_then(|power| match q % 2 {
            0 => real_power((1.0 - power).abs(), q, p),
            _ => real_power(1.0 - power, q, p),
        });
        let y = y.map(|y| if p % 2 == 0 { sign * y } else { y });
        match y.filter(|y| y.abs() <= x.abs() * (1.0 + 1e-9)) {
            Some(y) => {
                if let Some(branch) = branches.last_mut() {
                    branch.push([SCALE * x / WINDOW, SCALE * y / WINDOW]);
                }
            }
            None => branches.push(Vec::new()),
        }
    }
    branches
}

/// The real number `x^(p/q)`, if there is one: of odd q, the root has the sign of x.
fn real_power(x: f64, p: i32, q: i32) -> Option<f64> {
    let [numerator, denominator] = if q < 0 { [-p, -q] } else { [p, q] };
    if x < 0.0 && denominator % 2 == 0 || x == 0.0 && numerator < 0 {
        return None;
    }
    let size = x.abs().powf(f64::from(numerator) / f64::from(denominator));
    let is_negative = x < 0.0 && numerator % 2 != 0;
    Some(if is_negative { -size } else { size })
}
