use super::*;
use crate::cloud::PointCloud;

fn read_bytes(bytes: &[u8]) -> Result<PointCloud, String> {
    let clouds = [Some(bytes.len() as u64), None]
        .map(|size| read(&mut Input::new(bytes, size)).map_err(|error| error.to_string()));
    let [known, unknown] = clouds;
    if known != unknown {
        // Only where a file ends may be told in two ways.
        assert!(known.is_err() && unknown.is_err(), "{known:?} {unknown:?}");
    }
    known
}

const FIELDS: &str = "FIELDS _ z label X y\nSIZE 1 4 2 8 4\nTYPE U F I F F\nCOUNT 2 1 3 1 1\n";
const ROWS: [[f64; 3]; 2] = [[1.0, 2.0, 3.0], [4.5, -5.0, 6.0]];

fn file(fields: &str, points: &str, data: &str, bytes: &[u8]) -> Vec<u8> {
    let header = format!("# .PCD v.7\nVERSION .7\n{fields}{points}DATA {data}\n");
    [header.as_bytes(), bytes].concat()
}

/// The bytes of each field of each of the two points.
fn fields_of([x, y, z]: [f64; 3]) -> [Vec<u8>; 5] {
    [
        vec![9; 2],
        (z as f32).to_le_bytes().to_vec(),
        vec![9; 6],
        x.to_le_bytes().to_vec(),
        (y as f32).to_le_bytes().to_vec(),
    ]
}

fn binary() -> Vec<u8> {
    ROWS.iter().flat_map(|row| fields_of(*row)).flatten().collect()
}

/// The data field by field, compressed, behind their sizes.
fn compressed() -> Vec<u8> {
    let [first, second] = ROWS.map(fields_of);
    let block: Vec<u8> = first.into_iter().zip(second).flat_map(|(a, b)| [a, b].concat()).collect();
    let compressed = literal_lzf(&block);
    let sizes = [compressed.len() as u32, block.len() as u32].map(u32::to_le_bytes).concat();
    [sizes, compressed].concat()
}

/// LZF without a single back reference.
fn literal_lzf(bytes: &[u8]) -> Vec<u8> {
    let chunks = bytes.chunks(32);
    chunks.flat_map(|chunk| [&[chunk.len() as u8 - 1], chunk].concat()).collect()
}

#[test]
fn every_encoding_reads_the_same() {
    let expected = Ok(PointCloud::from_rows(ROWS));
    let points = "WIDTH 1\nHEIGHT 2\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS 2\n";
    let text = b"9 9 3 9 9 9 1 2\n\n9 9 6\t9 9 9 4.5 -5\r\n";
    assert_eq!(read_bytes(&file(FIELDS, points, "ascii", text)), expected);
    assert_eq!(read_bytes(&file(FIELDS, points, "binary", &binary())), expected);
    assert_eq!(read_bytes(&file(FIELDS, points, "binary_compressed", &compressed())), expected);
}

#[test]
fn the_number_of_points_may_be_told_in_any_way_that_agrees() {
    for points in ["POINTS 2\n", "WIDTH 2\n", "WIDTH 2\nHEIGHT 1\n", "WIDTH 2\nPOINTS 2\n"] {
        assert!(read_bytes(&file(FIELDS, points, "binary", &binary())).is_ok(), "{points}");
    }
    let error = read_bytes(&file(FIELDS, "WIDTH 2\nHEIGHT 2\nPOINTS 2\n", "binary", &binary()));
    assert!(error.unwrap_err().contains("expected POINTS 4, as WIDTH times HEIGHT, found `2`"));
}

#[test]
fn line_ends_of_any_kind_are_told_from_data() {
    let mut data = binary();
    data[0] = b'\n';
    let header = file(FIELDS, "POINTS 2\n", "binary", b"");
    for line_end in ["\r\n", "\r"] {
        let header = String::from_utf8_lossy(&header).replace('\n', line_end);
        let cloud = read_bytes(&[header.as_bytes(), &data].concat());
        assert_eq!(cloud, Ok(PointCloud::from_rows(ROWS)));
    }
}

#[test]
fn malformed_headers_are_refused() {
    for (from, to, message) in [
        ("VERSION .7", "VERSION 0.8", "expected VERSION .5, .6 or .7, found `0.8`"),
        ("FIELDS _ z", "FIELDS _ x", "expected one field z"),
        ("label", "y", "expected one field y"),
        ("FIELDS", "FEELDS", "line 3: expected a PCD header line"),
        ("SIZE 1 4 2 8 4\n", "", "expected a line `SIZE`"),
        ("SIZE 1 4", "SIZE 1", "expected 5 values in SIZE"),
        ("SIZE 1 4", "SIZE 1 2", "expected TYPE and SIZE of"),
        ("COUNT 2 1", "COUNT 2 2", "expected COUNT 1 for `z`"),
        ("COUNT 2", "COUNT -2", "expected a whole number in COUNT"),
        ("COUNT 2", "COUNT 18446744073709551615", "expected points of at most"),
        ("POINTS 2", "POINTS 2.0", "expected one whole number below 2^64 in POINTS"),
        ("POINTS 2", "POINTS 0", "holds no points"),
        ("POINTS 2\n", "", "expected a line `POINTS`"),
        ("POINTS 2", "POINTS 2\nPOINTS 2", "line 8: expected one line `POINTS`"),
        ("DATA binary", "DATA binery", "expected DATA ascii, binary or binary_compressed"),
        ("DATA binary\n", "", "line 8: expected the header line `DATA`"),
    ] {
        let header = file(FIELDS, "POINTS 2\n", "binary", b"");
        let header = String::from_utf8_lossy(&header).replace(from, to);
        let error = read_bytes(header.as_bytes()).unwrap_err();
        assert!(error.contains(message), "{error}");
    }
}

#[test]
fn data_that_end_early_or_go_on_are_refused() {
    let points = "POINTS 2\n";
    let whole = binary();
    let error = read_bytes(&file(FIELDS, points, "binary", &whole[..30])).unwrap_err();
    assert!(error.starts_with("point row 1 (byte "), "{error}");
    assert!(read_bytes(&file(FIELDS, points, "binary", &[&whole[..], &[0; 64]].concat())).is_ok());
    assert!(read_bytes(&file(FIELDS, points, "binary", &[&whole[..], b"x"].concat())).is_err());
    let huge = "POINTS 18446744073709551615\n";
    for data in ["ascii", "binary", "binary_compressed"] {
        assert!(read_bytes(&file(FIELDS, huge, data, &whole)).is_err(), "{data}");
    }
}

#[test]
fn compressed_data_that_lie_are_refused() {
    let read = |data: &[u8]| read_bytes(&file(FIELDS, "POINTS 2\n", "binary_compressed", data));
    let good = compressed();
    for length in 0..good.len() {
        assert!(read(&good[..length]).is_err(), "{length}");
    }
    let with = |index: usize, byte: u8| {
        let mut data = good.clone();
        data[index] = byte;
        read(&data).unwrap_err()
    };
    assert!(with(4, 49).contains("expected 48 bytes of data, as the header says"));
    assert!(with(0, 0).contains("the size of what decompresses to 48 bytes"));
    assert!(with(8, 0xff).contains("data compressed with LZF"));
    assert!(with(0, 33).contains("data that decompress to 48 bytes"));
}
