//! The 80 bytes before the triangles of a binary STL, with the model's parameters in them.
//!
//! Eleven doubles are 88 bytes. Size, exponents and centre are kept as they are; the rotation,
//! as axis times angle, to 32 bits a component, finer by far than the floats of the triangles.

use std::f64::consts::PI;
use std::io::Read;

use nalgebra::{Rotation3, Vector3};

use super::inscription::InscriptionError;
use crate::error::ModelError;
use crate::model::Model;
use crate::pose::Pose;
use crate::shape::{Shape, Superellipsoid};

/// Neither this nor [`PLAIN`] may begin like a text STL: "solid".
const MAGIC: [u8; 4] = *b"SQE1";
const PLAIN: &[u8] = b"binary STL";

const BYTES: usize = 80;

/// A whole component of the rotation vector, half a turn, in the units that are written.
const HALF_TURN: f64 = i32::MAX as f64;

/// The header of a file, with the parameters of a superellipsoid; others have no room.
pub(super) fn header(model: Option<&Model<Shape>>) -> [u8; BYTES] {
    let mut header = [0_u8; BYTES];
    let mut rest = &mut header[..];
    let mut put = |bytes: &[u8]| {
        let (head, tail) = std::mem::take(&mut rest).split_at_mut(bytes.len());
        head.copy_from_slice(bytes);
        rest = tail;
    };
    let Some(&Model { shape: Shape::Superellipsoid(shape), pose }) = model else {
        put(PLAIN);
        return header;
    };
    let [a1, a2, a3, e1, e2, _, _, _, px, py, pz] = Model { shape, pose }.parameters();
    put(&MAGIC);
    [a1, a2, a3, e1, e2, px, py, pz].iter().for_each(|value| put(&value.to_le_bytes()));
    for component in &pose.rotation().scaled_axis() {
        put(&((component / PI * HALF_TURN).round() as i32).to_le_bytes());
    }
    header
}

/// The model in the header of a file.
pub(super) fn read_model(
    reader: &mut (impl Read + ?Sized),
) -> Result<Model<Shape>, InscriptionError> {
    let mut header = [0_u8; BYTES];
    reader.read_exact(&mut header)?;
    let Some(parameters) = header.strip_prefix(&MAGIC) else {
        return Err(InscriptionError::Missing("a header that begins with SQE1"));
    };
    let double = |i: usize| f64::from_le_bytes(parameters.as_chunks().0[i]);
    let shape = Superellipsoid::new([double(0), double(1), double(2)], [double(3), double(4)])?;
    let centre = Vector3::new(double(5), double(6), double(7));
    if !centre.iter().all(|coordinate| coordinate.is_finite()) {
        return Err(ModelError::NotFinite { what: "the centre's coordinates" }.into());
    }
    let integer = |i: usize| i32::from_le_bytes(parameters.as_chunks().0[16 + i]);
    let axis_angle = Vector3::from_fn(|i, _| f64::from(integer(i)) / HALF_TURN * PI);
    Ok(Model { shape: shape.into(), pose: Pose::new(Rotation3::new(axis_angle), centre) })
}
