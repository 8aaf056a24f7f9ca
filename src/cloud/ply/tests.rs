use super::*;
use crate::cloud::PointCloud;

const XYZ: &str = "property float x\nproperty float y\nproperty float z\n";

fn read_bytes(bytes: &[u8]) -> Result<PointCloud, String> {
    let of_known_size = read(&mut Input::new(bytes, Some(bytes.len() as u64)));
    let of_unknown_size = read(&mut Input::new(bytes, None));
    let [known, unknown] =
        [of_known_size, of_unknown_size].map(|cloud| cloud.map_err(|error| error.to_string()));
    assert_eq!(known, unknown);
    known
}

/// A file of the given encoding, element lines and data.
fn file(encoding: &str, elements: &str, data: &[u8]) -> Vec<u8> {
    let header = format!("ply\nformat {encoding} 1.0\n{elements}end_header\n");
    [header.as_bytes(), data].concat()
}

fn ascii(elements: &str, data: &str) -> Result<PointCloud, String> {
    read_bytes(&file("ascii", elements, data.as_bytes()))
}

fn little(elements: &str, data: &[u8]) -> Result<PointCloud, String> {
    read_bytes(&file("binary_little_endian", elements, data))
}

fn floats(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

fn cloud(rows: &[[f64; 3]]) -> Result<PointCloud, String> {
    Ok(PointCloud::from_rows(rows.iter().copied()))
}

#[test]
fn properties_may_stand_in_any_order_among_others() {
    let vertex = "element vertex 1\nproperty float z\nproperty list uchar int l\n\
        property double y\nproperty uchar red\nproperty short x\n";
    assert_eq!(ascii(vertex, "3 2 8 9 2 255 1"), cloud(&[[1.0, 2.0, 3.0]]));
    let mut data = floats(&[3.0]);
    data.extend([2, 8, 0, 0, 0, 9, 0, 0, 0]);
    data.extend(2_f64.to_le_bytes());
    data.extend([255, 1, 0]);
    assert_eq!(little(vertex, &data), cloud(&[[1.0, 2.0, 3.0]]));
}

#[test]
fn upper_case_coordinates_serve_where_lower_case_ones_are_absent() {
    let vertex = "element vertex 1\nproperty float X\nproperty float Y\nproperty float Z\n";
    assert_eq!(ascii(vertex, "1 2 3"), cloud(&[[1.0, 2.0, 3.0]]));
    assert_eq!(ascii(&format!("{vertex}{XYZ}"), "9 9 9 1 2 3"), cloud(&[[1.0, 2.0, 3.0]]));
}

#[test]
fn other_elements_before_and_after_are_passed_over() {
    let elements = format!(
        "element grid 2\nproperty list int double v\nelement camera 1\nproperty double f\n\
         element empty 1099511627776\nelement vertex 1\n{XYZ}element face 1\n\
         property list uchar int vertex_indices\n"
    );
    let text = "2 0.5 0.5\n0\n35\n1 2 3\n3 0 1 99999999\n";
    assert_eq!(ascii(&elements, text), cloud(&[[1.0, 2.0, 3.0]]));
    let mut data = [&2_i32.to_le_bytes()[..], &[7; 16], &0_i32.to_le_bytes(), &[7; 8]].concat();
    data.extend(floats(&[1.0, 2.0, 3.0]));
    data.extend([1, 0, 0, 0, 0]);
    assert_eq!(little(&elements, &data), cloud(&[[1.0, 2.0, 3.0]]));
    let last = data.len() - 1;
    assert!(little(&elements, &data[..last]).unwrap_err().starts_with("face row 0"));
    assert!(ascii(&elements, "0\n0\n35\n1 2 3\n").unwrap_err().starts_with("face row 0"));
}

#[test]
fn every_type_is_read_exactly_in_both_orders() {
    macro_rules! check {
        ($type:ty, $($name:literal)*) => {$(
            let (low, high) = (<$type>::MIN, <$type>::MAX);
            let name = $name;
            let vertex =
                format!("element vertex 1\nproperty {name} x\nproperty {name} y\nproperty {name} z\n");
            let expected = cloud(&[[low as f64, high as f64, 1.0]]);
            let values = [low, high, 1 as $type];
            assert_eq!(little(&vertex, &values.map(<$type>::to_le_bytes).concat()), expected);
            let big = file("binary_big_endian", &vertex, &values.map(<$type>::to_be_bytes).concat());
            assert_eq!(read_bytes(&big), expected);
        )*};
    }
    check!(i8, "char" "int8");
    check!(u8, "uchar" "uint8");
    check!(i16, "short" "int16");
    check!(u16, "ushort" "uint16");
    check!(i32, "int" "int32");
    check!(u32, "uint" "uint32");
    check!(f32, "float" "float32");
    check!(f64, "double" "float64");
}

#[test]
fn the_line_end_before_binary_data_is_told_from_the_data() {
    let data = [b'\n', 0, 0, 0x3f, 0, 0, 0, 0, 0, 0, 0, 0];
    let expected = cloud(&[[f64::from(f32::from_le_bytes([b'\n', 0, 0, 0x3f])), 0.0, 0.0]]);
    let text =
        String::from_utf8(file("binary_little_endian", &format!("element vertex 1\n{XYZ}"), b""));
    let text = text.unwrap();
    for line_end in ["\n", "\r\n", "\r"] {
        let header = text.replace('\n', line_end);
        assert_eq!(read_bytes(&[header.as_bytes(), &data].concat()), expected);
    }
    let header = text.replace("end_header\n", "end_header\r\n");
    assert_eq!(read_bytes(&[header.as_bytes(), &data].concat()), expected);
}

#[test]
fn lists_in_vertices_are_bounded_by_the_data() {
    let vertex = format!("element vertex 1\nproperty list uint double l\n{XYZ}");
    let error = little(&vertex, &[255; 20]).unwrap_err();
    assert!(error.contains("expected a list of 4294967295 values"), "{error}");
    let vertex = format!("element vertex 1\nproperty list char char l\n{XYZ}");
    let error = little(&vertex, &[255; 20]).unwrap_err();
    assert!(error.contains("expected the length of a list, found -1"), "{error}");
    let vertex = format!("element vertex 1\nproperty list float char l\n{XYZ}");
    assert!(little(&vertex, &[0; 20]).unwrap_err().contains("whole-number lengths"));
}

#[test]
fn binary_data_that_end_early_are_named_by_row_and_byte() {
    let error = little(&format!("element vertex 3\n{XYZ}"), &[0; 26]).unwrap_err();
    assert!(error.starts_with("vertex row 2 (byte "), "{error}");
    for count in [1_u64 << 32, u64::MAX] {
        let error = little(&format!("element vertex {count}\n{XYZ}"), b"").unwrap_err();
        assert!(error.starts_with("vertex row 0 "), "{error}");
        let error = ascii(&format!("element vertex {count}\n{XYZ}"), "1 2 3").unwrap_err();
        assert!(error.starts_with("vertex row 1 (line 9)"), "{error}");
    }
}

#[test]
fn headers_without_coordinates_are_refused() {
    for (elements, message) in [
        ("", "holds no points"),
        ("element face 1\nproperty list uchar int v\n", "holds no points"),
        (&format!("element vertex 0\n{XYZ}"), "holds no points"),
        ("element vertex 1\nproperty float x\nproperty float y\n", "a number z for each vertex"),
        ("element vertex 9\n", "a number x for each vertex, found no such property"),
        (
            &format!("element vertex 1\n{XYZ}").replace("float x", "list uchar float x"),
            "a number x for each vertex, found a list",
        ),
    ] {
        let error = ascii(elements, "1 2 3").unwrap_err();
        assert!(error.contains(message), "{error}");
    }
}

#[test]
fn only_padding_may_follow_the_data() {
    let vertex = format!("element vertex 1\n{XYZ}");
    assert!(ascii(&vertex, "1 2 3\n\n \r\n").is_ok());
    assert!(ascii(&vertex, "1 2 3\n4 5 6\n").unwrap_err().contains("the end of the data"));
    assert!(little(&vertex, &[0; 4096]).is_ok());
    assert!(little(&vertex, &[[0; 12], [1; 12]].concat()).is_err());
}
