//! What the PLY header means for the data: where in each row of an element which value is.

use ply_rs_bw::ply::{ElementDef, Header, PropertyType, ScalarType};

use crate::cloud::error::{Place, Problem};
use crate::cloud::scalar::Scalar;
use crate::cloud::text_rows::AXES;

/// A property of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Property {
    /// A number; that of a coordinate of a vertex has its axis, 0, 1 or 2.
    Scalar { scalar: Scalar, axis: Option<usize> },
    /// A length and as many items.
    List { length: Scalar, item: Scalar },
}

/// An element: `count` rows of the same properties.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Element {
    pub name: String,
    pub count: u64,
    pub properties: Vec<Property>,
    pub is_vertex: bool,
}

impl Element {
    /// The bytes of a row in binary data, or `None` if they vary from row to row.
    pub fn stride(&self) -> Option<u64> {
        let size = |property: &Property| match property {
            Property::Scalar { scalar, .. } => Some(scalar.size() as u64),
            Property::List { .. } => None,
        };
        self.properties.iter().map(size).sum()
    }

    /// The fewest bytes of a row in binary data.
    pub fn least_stride(&self) -> u64 {
        let size = |property: &Property| match property {
            Property::Scalar { scalar: first, .. } | Property::List { length: first, .. } => {
                first.size() as u64
            }
        };
        self.properties.iter().map(size).sum()
    }
}

/// The bytes that the binary data of all elements take, or `None` if the header does not tell.
pub(super) fn data_bytes(elements: &[Element]) -> Option<u64> {
    elements.iter().try_fold(0_u64, |sum, element| match element.count {
        0 => Some(sum),
        count => sum.checked_add(count.checked_mul(element.stride()?)?),
    })
}

/// The elements in the order of their data; one of them holds the vertices.
///
/// # Errors
/// There are no vertices or one of their coordinates is not declared as a number, or the length
/// of a list is not a whole number. `place` is the end of the header.
pub(super) fn elements(header: &Header, place: &Place) -> Result<Vec<Element>, Problem> {
    match header.elements.get("vertex") {
        None => return Err(Problem::NoPoints("the header declares no element `vertex`")),
        Some(vertex) if vertex.count == 0 => {
            return Err(Problem::NoPoints("the header declares 0 vertices"));
        }
        Some(_) => {}
    }
    header.elements.values().map(|element| convert(element, place)).collect()
}

fn convert(element: &ElementDef, place: &Place) -> Result<Element, Problem> {
    let is_vertex = element.name == "vertex";
    let axes = if is_vertex { axis_indices(element, place)?.map(Some) } else { [None; 3] };
    let convert = |(index, kind): (usize, &PropertyType)| match kind {
        PropertyType::Scalar(kind) => {
            let axis = axes.iter().position(|axis| *axis == Some(index));
            Ok(Property::Scalar { scalar: scalar(kind), axis })
        }
        PropertyType::List(length, item) => {
            let (length, item) = (scalar(length), scalar(item));
            if !length.is_integer() {
                return Err(Problem::malformed(
                    place.clone(),
                    format!("lists of element `{}` with whole-number lengths", element.name),
                    "lengths declared float or double",
                ));
            }
            Ok(Property::List { length, item })
        }
    };
    let kinds = element.properties.values().map(|property| &property.data_type);
    Ok(Element {
        name: element.name.clone(),
        count: element.count as u64,
        properties: kinds.enumerate().map(convert).collect::<Result<_, _>>()?,
        is_vertex,
    })
}

/// The indices of the properties x, y and z, or X, Y and Z, of the vertices.
fn axis_indices(vertex: &ElementDef, place: &Place) -> Result<[usize; 3], Problem> {
    let mut indices = [0; 3];
    for (index, axis) in indices.iter_mut().zip(AXES) {
        let found = vertex.properties.get_full(axis);
        let found = found.or_else(|| vertex.properties.get_full(&axis.to_ascii_uppercase()));
        *index = match found {
            Some((index, _, property)) if is_scalar(&property.data_type) => index,
            other => {
                return Err(Problem::malformed(
                    place.clone(),
                    format!("a header that declares a number {axis} for each vertex"),
                    if other.is_some() { "a list" } else { "no such property" },
                ));
            }
        };
    }
    Ok(indices)
}

fn is_scalar(kind: &PropertyType) -> bool {
    matches!(kind, PropertyType::Scalar(_))
}

fn scalar(kind: &ScalarType) -> Scalar {
    match kind {
        ScalarType::Char => Scalar::I8,
        ScalarType::UChar => Scalar::U8,
        ScalarType::Short => Scalar::I16,
        ScalarType::UShort => Scalar::U16,
        ScalarType::Int => Scalar::I32,
        ScalarType::UInt => Scalar::U32,
        ScalarType::Float => Scalar::F32,
        ScalarType::Double => Scalar::F64,
    }
}
