//! The model's parameters in a binary STL: in the 80 bytes before the triangles, and in attributes of
//! the first of them.
//!
//! The header has four letters for the family and nine doubles: size, exponents, ring or clip where
//! there is one, centre. No room is left for the rotation, as axis times angle: its bits are the
//! attributes, otherwise 0, of fifteen triangles, fifteen each. Their highest bit, with which some
//! programs mark a colour, stays 0.

use std::io::Read;

use nalgebra::{Rotation3, UnitQuaternion, Vector3};

use super::inscription::InscriptionError;
use crate::error::ModelError;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::{
    Shape, Superellipsoid, SuperhyperboloidOneSheet, SuperhyperboloidTwoSheets, Supertoroid,
    ThreeExponent,
};

/// What a file without a model begins with. Neither this nor a family's letters may begin like a
/// text STL: "solid".
const PLAIN: &[u8] = b"binary STL";

const BYTES: usize = 80;

/// Bits of an attribute that are used.
const ATTRIBUTE_BITS: usize = 15;

/// Attributes that hold a double.
const TO_A_DOUBLE: usize = 5;

/// How many triangles have an attribute.
const ATTRIBUTES: usize = 3 * TO_A_DOUBLE;

/// Bytes of the count of triangles, of a triangle, and of its vectors before the attribute.
const COUNT_BYTES: usize = 4;
const TRIANGLE_BYTES: usize = 50;
const VECTOR_BYTES: usize = 48;

/// What a file holds of its model.
pub(super) struct Parameters {
    /// The bytes before the count of triangles.
    pub header: [u8; BYTES],
    /// The attributes of the first triangles.
    pub attributes: [u16; ATTRIBUTES],
}

impl Parameters {
    /// The parameters of a model, for a mesh of so many triangles; none where these are too few.
    pub fn new(model: Option<&Model<Shape>>, triangles: usize) -> Self {
        let mut parameters = Self { header: [0; BYTES], attributes: [0; ATTRIBUTES] };
        let Some(Model { shape, pose }) = model.filter(|_| triangles >= ATTRIBUTES) else {
            parameters.header[..PLAIN.len()].copy_from_slice(PLAIN);
            return parameters;
        };
        let (letters, [a, b, c, d, e, f]) = letters_and_numbers(shape);
        let [x, y, z] = (*pose.translation()).into();
        let doubles = [a, b, c, d, e, f, x, y, z].map(f64::to_le_bytes);
        let written = letters.iter().chain(doubles.as_flattened());
        parameters.header.iter_mut().zip(written).for_each(|(to, from)| *to = *from);
        // By its quaternion, a rotation by next to nothing or half a turn has its axis too.
        let axis_angle = UnitQuaternion::from_rotation_matrix(pose.rotation()).scaled_axis();
        for (component, attributes) in
            axis_angle.iter().zip(parameters.attributes.chunks_mut(TO_A_DOUBLE))
        {
            attributes.copy_from_slice(&split(*component));
        }
        parameters
    }
}

/// The family's letters, and size, exponents and what else a shape has.
fn letters_and_numbers(shape: &Shape) -> (&'static [u8; 4], [f64; 6]) {
    let with = |[a1, a2, a3]: [f64; 3], [e1, e2]: [f64; 2], other| [a1, a2, a3, e1, e2, other];
    match shape {
        Shape::Superellipsoid(s) => (b"SQE1", with(s.size(), s.exponents(), 0.0)),
        Shape::SuperhyperboloidOneSheet(s) => (b"SQO1", with(s.size(), s.exponents(), s.clip())),
        Shape::SuperhyperboloidTwoSheets(s) => (b"SQT1", with(s.size(), s.exponents(), s.clip())),
        Shape::Supertoroid(s) => (b"SQR1", with(s.size(), s.exponents(), s.ring())),
        Shape::ThreeExponent(s) => {
            let [n1, n2, n3] = s.exponents();
            (b"SQN1", with(s.size(), [n1, n2], n3))
        }
    }
}

/// The shape of a family's letters and of six numbers.
fn shape_of(
    letters: [u8; 4],
    [a1, a2, a3, e1, e2, other]: [f64; 6],
) -> Result<Shape, InscriptionError> {
    let (size, e) = ([a1, a2, a3], [e1, e2]);
    Ok(match &letters {
        b"SQE1" => Superellipsoid::new(size, e)?.into(),
        b"SQO1" => SuperhyperboloidOneSheet::new(size, e, other)?.into(),
        b"SQT1" => SuperhyperboloidTwoSheets::new(size, e, other)?.into(),
        b"SQR1" => Supertoroid::new(size, e, other)?.into(),
        b"SQN1" => ThreeExponent::new(size, [e1, e2, other])?.into(),
        _ => {
            let expected = "a header that begins with SQE1, SQO1, SQT1, SQR1 or SQN1";
            return Err(InscriptionError::Missing(expected));
        }
    })
}

/// The bits of a double, the highest first.
fn split(value: f64) -> [u16; TO_A_DOUBLE] {
    let mask = (1 << ATTRIBUTE_BITS) - 1;
    std::array::from_fn(|i| {
        (value.to_bits() >> (ATTRIBUTE_BITS * (TO_A_DOUBLE - 1 - i)) & mask) as u16
    })
}

/// The double of such bits.
fn joined(attributes: &[u16]) -> f64 {
    let join = |bits: u64, attribute: &u16| bits << ATTRIBUTE_BITS | u64::from(*attribute);
    f64::from_bits(attributes.iter().fold(0, join))
}

/// The model in a file's header and its first triangles.
pub(super) fn read_model(
    reader: &mut (impl Read + ?Sized),
) -> Result<Model<Shape>, InscriptionError> {
    let mut header = [0_u8; BYTES];
    reader.read_exact(&mut header)?;
    let (letters, rest) = header.split_at(4);
    let double = |i: usize| f64::from_le_bytes(rest.as_chunks().0[i]);
    let shape = shape_of([0, 1, 2, 3].map(|i| letters[i]), [0, 1, 2, 3, 4, 5].map(double))?;
    let centre = Vector3::new(double(6), double(7), double(8));
    if !centre.iter().all(|coordinate| coordinate.is_finite()) {
        return Err(ModelError::NotFinite { what: "the centre's coordinates" }.into());
    }
    let attributes = read_attributes(reader)?;
    let axis_angle = Vector3::from_iterator(attributes.chunks(TO_A_DOUBLE).map(joined));
    if !axis_angle.norm().is_finite() {
        return Err(ModelError::NotFinite { what: "the rotation's axis and angle" }.into());
    }
    Ok(Model { shape, pose: Pose::new(Rotation3::new(axis_angle), centre) })
}

/// The attributes of the first triangles.
fn read_attributes(
    reader: &mut (impl Read + ?Sized),
) -> Result<[u16; ATTRIBUTES], InscriptionError> {
    let mut triangles = [0; COUNT_BYTES + ATTRIBUTES * TRIANGLE_BYTES];
    reader.read_exact(&mut triangles)?;
    Ok(std::array::from_fn(|i| {
        let place = COUNT_BYTES + i * TRIANGLE_BYTES + VECTOR_BYTES;
        u16::from_le_bytes([triangles[place], triangles[place + 1]])
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    #[test]
    fn doubles_come_back_from_their_bits_and_none_marks_a_colour() {
        for value in [0.0, -0.0, 1.0 / 3.0, -PI, 1e-300, f64::MIN_POSITIVE, f64::NAN] {
            let attributes = split(value);
            assert!(attributes.iter().all(|attribute| *attribute < 1 << ATTRIBUTE_BITS));
            assert_eq!(joined(&attributes).to_bits(), value.to_bits());
        }
    }

    #[test]
    fn rotations_come_back_whatever_their_angle() {
        let shape = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap();
        for angle in [0.0, 1e-12, 1e-6, 1.0, PI - 1e-6, PI - 1e-12, PI] {
            for axis in [Vector3::x(), Vector3::new(0.6, -0.8, 0.0), Vector3::new(1.0, 1.0, -1.0)] {
                let rotation = Rotation3::new(axis.normalize() * angle);
                let pose = Pose::new(rotation, Vector3::zeros());
                let model = Model { shape: shape.into(), pose };
                let parameters = Parameters::new(Some(&model), ATTRIBUTES);
                let mut file = [&parameters.header[..], &[0; COUNT_BYTES]].concat();
                for attribute in parameters.attributes {
                    file.extend([0; VECTOR_BYTES]);
                    file.extend(attribute.to_le_bytes());
                }
                let read = read_model(&mut &file[..]).unwrap();
                let difference = read.pose.rotation().matrix() - rotation.matrix();
                // The rounding of a matrix made of an axis and an angle.
                assert!(difference.amax() < 2e-15, "{angle} {axis} {}", difference.amax());
            }
        }
    }

    #[test]
    fn a_mesh_of_few_triangles_keeps_no_model() {
        let shape = Superellipsoid::new([1.0; 3], [1.0; 2]).unwrap().into();
        let model = Model { shape, pose: Pose::identity() };
        let parameters = Parameters::new(Some(&model), ATTRIBUTES - 1);
        assert!(parameters.header.starts_with(PLAIN) && parameters.attributes == [0; ATTRIBUTES]);
    }
}
