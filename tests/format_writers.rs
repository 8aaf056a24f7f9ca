//! One cloud written in every format reads back bit for bit, and damage to it does no harm.

use std::fmt::Write;

use ply_rs_bw::ply::{
    Addable, DefaultElement, ElementDef, Encoding, Ply, Property, PropertyDef, PropertyType,
    ScalarType,
};
use ply_rs_bw::writer::Writer;
use proptest::prelude::*;
use superquadric::cloud::{PointCloud, read_stream};

type Rows = Vec<[f64; 3]>;

/// The rows as `ply-rs-bw` writes them, with a property and an element of no concern.
fn ply(rows: &Rows, encoding: Encoding) -> Vec<u8> {
    let mut ply = Ply::<DefaultElement>::new();
    ply.header.encoding = encoding;
    ply.header.comments.push("a comment".into());
    let mut vertex = ElementDef::new("vertex".into());
    for name in ["x", "y", "z"] {
        let kind = PropertyType::Scalar(ScalarType::Double);
        vertex.properties.add(PropertyDef::new(name.into(), kind));
    }
    let kind = PropertyType::Scalar(ScalarType::UChar);
    vertex.properties.add(PropertyDef::new("red".into(), kind));
    ply.header.elements.add(vertex);
    let mut face = ElementDef::new("face".into());
    let kind = PropertyType::List(ScalarType::UChar, ScalarType::Int);
    face.properties.add(PropertyDef::new("vertex_indices".into(), kind));
    ply.header.elements.add(face);
    let vertices = rows.iter().map(|row| {
        let mut vertex = DefaultElement::new();
        for (name, value) in ["x", "y", "z"].into_iter().zip(row) {
            vertex.insert(name.into(), Property::Double(*value));
        }
        vertex.insert("red".into(), Property::UChar(7));
        vertex
    });
    ply.payload.insert("vertex".into(), vertices.collect());
    let mut face = DefaultElement::new();
    face.insert("vertex_indices".into(), Property::ListInt(vec![0, 1, -2]));
    ply.payload.insert("face".into(), vec![face]);
    let mut bytes = Vec::new();
    Writer::new().write_ply(&mut bytes, &mut ply).unwrap();
    bytes
}

fn columns(rows: &Rows) -> Vec<f64> {
    (0..3).flat_map(|axis| rows.iter().map(move |row| row[axis])).collect()
}

fn little(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn pcd(rows: &Rows, data: &str) -> Vec<u8> {
    let body = match data {
        "ascii" => text(rows, " ").into_bytes(),
        "binary" => little(&rows.concat()),
        _ => {
            let block = little(&columns(rows));
            // Zeros make sure that the block can be compressed at all.
            let compressed = lzf::compress(&block).unwrap();
            let sizes = [compressed.len(), block.len()].map(|size| (size as u32).to_le_bytes());
            [sizes.concat(), compressed].concat()
        }
    };
    let header = format!(
        "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\nFIELDS x y z\nSIZE 8 8 8\n\
         TYPE F F F\nCOUNT 1 1 1\nWIDTH {0}\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS {0}\n\
         DATA {data}\n",
        rows.len()
    );
    [header.into_bytes(), body].concat()
}

fn npy(rows: &Rows, order: &str, is_fortran_order: bool) -> Vec<u8> {
    let fortran = if is_fortran_order { "True" } else { "False" };
    let header = format!(
        "{{'descr': '{order}f8', 'fortran_order': {fortran}, 'shape': ({}, 3), }}\n",
        rows.len()
    );
    let values = if is_fortran_order { columns(rows) } else { rows.concat() };
    let data = match order {
        ">" => values.iter().flat_map(|value| value.to_be_bytes()).collect(),
        _ => little(&values),
    };
    let length = (header.len() as u16).to_le_bytes();
    [&b"\x93NUMPY\x01\0"[..], &length, header.as_bytes(), &data].concat()
}

fn text(rows: &Rows, separator: &str) -> String {
    rows.iter().fold(String::new(), |mut text, [x, y, z]| {
        writeln!(text, "{x:?}{separator}{y:?}{separator}{z:?}").unwrap();
        text
    })
}

/// The rows in every format.
fn files(rows: &Rows) -> Vec<(&'static str, Vec<u8>)> {
    vec![
        ("ascii.ply", ply(rows, Encoding::Ascii)),
        ("little.ply", ply(rows, Encoding::BinaryLittleEndian)),
        ("big.ply", ply(rows, Encoding::BinaryBigEndian)),
        ("ascii.pcd", pcd(rows, "ascii")),
        ("binary.pcd", pcd(rows, "binary")),
        ("compressed.pcd", pcd(rows, "binary_compressed")),
        ("c.npy", npy(rows, "<", false)),
        ("fortran.npy", npy(rows, ">", true)),
        ("blanks.xyz", text(rows, " ").into_bytes()),
        ("commas.csv", ["x,y,z\n", &text(rows, ", ")].concat().into_bytes()),
        ("tabs.tsv", text(rows, "\t").replace('\n', "\tlabel\r\n").into_bytes()),
        ("semicolons.txt", format!("{}\n{}", rows.len(), text(rows, ";")).into_bytes()),
    ]
}

/// Some rows of any finite numbers, and some of zeros.
fn rows() -> impl Strategy<Value = Rows> {
    let number = prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO;
    prop::collection::vec([number, number, number], 1..40).prop_map(|mut rows| {
        rows.extend([[0.0; 3]; 20]);
        rows
    })
}

fn bits(cloud: &PointCloud) -> Vec<[u64; 3]> {
    cloud.points().map(|point| point.map(f64::to_bits)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn every_format_reads_back_bit_for_bit(rows in rows()) {
        let expected = bits(&PointCloud::from_rows(rows.iter().copied()));
        for (name, bytes) in files(&rows) {
            let cloud = read_stream(name, &bytes[..]).unwrap();
            prop_assert_eq!(bits(&cloud), &expected[..], "{}", name);
        }
    }

    #[test]
    fn damaged_files_are_read_or_refused_but_never_blown_up(
        rows in rows(),
        damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        length in any::<prop::sample::Index>(),
        is_cut in any::<bool>(),
    ) {
        for (name, mut bytes) in files(&rows) {
            for (index, byte) in &damage {
                let index = index.index(bytes.len());
                bytes[index] = *byte;
            }
            if is_cut {
                bytes.truncate(length.index(bytes.len()));
            }
            for name in [name, "-"] {
                match read_stream(name, &bytes[..]) {
                    // LZF makes at most 88 bytes of one.
                    Ok(cloud) => prop_assert!(cloud.rows() <= 88 * bytes.len(), "{}", name),
                    Err(error) => prop_assert!(error.to_string().len() < 1000, "{}", error),
                }
            }
        }
    }

    #[test]
    fn any_bytes_behind_any_magic_are_read_or_refused(
        magic in prop::sample::select(vec![
            &b""[..],
            b"ply\n",
            b"ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n\
              property float y\nproperty float z\n",
            b"# .PCD v.7\n",
            b"\x93NUMPY\x01\0",
        ]),
        bytes in prop::collection::vec(any::<u8>(), 0..300),
    ) {
        let bytes = [magic, &bytes].concat();
        if let Ok(cloud) = read_stream("-", &bytes[..]) {
            prop_assert!(cloud.rows() <= bytes.len());
        }
    }
}
