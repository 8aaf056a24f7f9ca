//! Reading the corpus of files that readers get wrong.

use std::path::PathBuf;

use superquadric::cloud::{read, read_rows};

/// What a file of the corpus should read as.
enum Expected {
    /// This many points and this many skipped rows.
    Points(usize, usize),
    /// An error whose message contains this.
    Error(&'static str),
}
use Expected::{Error, Points};

const CORPUS: &[(&str, Expected)] = &[
    ("reports/01_count_u32max_no_data.ply", Error("vertex row 0 (byte 124)")),
    ("reports/03_count_20digits.ply", Error("line 3: expected `element NAME COUNT`")),
    ("reports/05_count_negative.ply", Error("line 3: expected `element NAME COUNT`")),
    ("reports/07_list_count_255_truncated.ply", Error("no element `vertex`")),
    ("reports/09_short_ascii_20_vs_19.ply", Error("vertex row 19")),
    ("reports/11_short_binary_midvalue.ply", Error("vertex row 2")),
    ("reports/13_duplicate_property_x.ply", Error("line 5: expected a name not taken")),
    ("reports/15_format_no_args_cr.ply", Error("line 2: expected one `format")),
    ("reports/17_bare_property.ply", Error("line 4: expected `property")),
    ("reports/19_truncated_type_name.ply", Error("line 4: expected `property")),
    ("reports/21_header_line_1MiB.ply", Error("line 3: expected a line of fewer than")),
    ("reports/23_zero_stride_element_2p40.ply", Error("vertex row 0 (byte 141)")),
    ("reports/25_nan_inf_ascii.ply", Points(1, 5)),
    ("reports/27_locale_comma.ply", Error("vertex row 0")),
    ("reports/29_list_before_xyz.ply", Points(2, 0)),
    ("reports/31_list_typed_x.ply", Error("a number x for each vertex, found a list")),
    ("reports/33_zyx_order_extra.ply", Points(1, 0)),
    ("reports/35_count_float.ply", Error("line 3: expected `element NAME COUNT`")),
    ("reports/37_utf8_bom.ply", Points(1, 0)),
    ("reports/39_nul_in_header.ply", Error("line 3: expected text without the control")),
    ("reports/41_no_final_newline.ply", Points(1, 0)),
    ("reports/43_blank_lines_between_rows.ply", Points(2, 0)),
    ("reports/45_crlf_all_ascii.ply", Points(2, 0)),
    ("reports/47_crlf_header_bin_data_starts_lf.ply", Points(1, 0)),
    ("reports/49_cr_header_bin_data_starts_lf.ply", Points(1, 0)),
    ("reports/51_format_version_2.ply", Error("line 2: expected version 1.0")),
    ("reports/53_gzip_magic.ply", Error("gzip")),
    ("reports/55_face_index_out_of_range.ply", Points(3, 0)),
    ("reports/57_all_identical_points.ply", Points(50, 0)),
    ("reports/59_coplanar_points.ply", Points(100, 0)),
    ("upstream/assimp/cube.ply", Points(8, 0)),
    ("upstream/assimp/cube_binary_header_with_RN_newline.ply", Points(8, 0)),
    ("upstream/assimp/empty.ply", Error("is empty")),
    // The list of a vertex is declared but absent from its row.
    ("upstream/assimp/issue623.ply", Error("vertex row 0")),
    ("upstream/draco/Box.ply", Points(24, 0)),
    ("upstream/draco/float_inf_point_cloud.ply", Points(13, 3)),
    ("upstream/draco/int_point_cloud.ply", Points(16, 0)),
    ("upstream/happly/platonic_shelf_ascii.ply", Points(50, 0)),
    ("upstream/happly/platonic_shelf_big_endian.ply", Points(50, 0)),
    ("upstream/pcl/curve_close.pcd", Points(110, 0)),
    ("upstream/pcl/milk.pcd", Points(13704, 0)),
    ("upstream/pcl/octants.pcd", Points(8, 0)),
    ("upstream/pdal/issue_2421.ply", Points(1, 0)),
    ("upstream/pdal/missingheader.pcd", Error("a PCD header, as the extension says")),
    ("upstream/pdal/no_vertex.ply", Error("holds no points")),
    ("upstream/pdal/simple_text.ply", Points(3, 0)),
    ("upstream/pdal/utm17_space.pcd", Points(10, 0)),
    ("upstream/trimesh/ply_empty_header.ply", Error("holds no points")),
    ("upstream/trimesh/points_ascii_with_lists.ply", Points(5, 0)),
    ("upstream/trimesh/points_bin.ply", Points(5, 0)),
];

/// The folder of files shared beside the project, or `None` with a word of it.
fn shared(folder: &str) -> Option<PathBuf> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../shared")).join(folder);
    if !path.is_dir() {
        println!("skipped: ../shared/{folder} is absent");
        return None;
    }
    Some(path)
}

#[test]
fn each_file_of_the_corpus_reads_as_it_should() {
    let Some(corpus) = shared("plycorpus") else { return };
    let mut failures = Vec::new();
    for (name, expected) in CORPUS {
        let result = read(&corpus.join(name));
        let is_right = match (&result, expected) {
            (Ok(cloud), Points(points, skipped)) => {
                (cloud.len(), cloud.skipped_rows().len()) == (*points, *skipped)
            }
            (Err(error), Error(message)) => error.to_string().contains(message),
            _ => false,
        };
        if !is_right {
            let found = result.map(|cloud| (cloud.len(), cloud.skipped_rows().len()));
            failures.push(format!("{name}: {found:?}"));
            continue;
        }
        match (result, read_rows(&corpus.join(name))) {
            (Ok(cloud), Ok(rows)) => {
                assert!(rows.points.iter().copied().eq(cloud.points()), "{name}");
                assert_eq!(rows.skipped_rows, cloud.skipped_rows(), "{name}");
            }
            (cloud, rows) => assert_eq!(
                cloud.err().map(|error| error.to_string()),
                rows.err().map(|error| error.to_string()),
            ),
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn coordinates_of_the_corpus_are_right() {
    let Some(corpus) = shared("plycorpus") else { return };
    let first = |name: &str| read(&corpus.join(name)).unwrap().point(0);
    assert_eq!(first("reports/33_zyx_order_extra.ply"), [1.0, 2.0, 3.0]);
    assert_eq!(first("reports/29_list_before_xyz.ply"), [1.0, 2.0, 3.0]);
    let odd = f64::from(f32::from_le_bytes([0x0a, 0, 0, 0x3f]));
    for name in ["47_crlf_header_bin_data_starts_lf", "49_cr_header_bin_data_starts_lf"] {
        assert_eq!(first(&format!("reports/{name}.ply"))[0], odd, "{name}");
    }
    assert_eq!(first("upstream/pdal/issue_2421.ply"), [1.23457, 12345.67890, 1234567890.12345]);
    assert_eq!(first("upstream/pdal/utm17_space.pcd"), [289814.15, 4320978.61, 170.76]);
    let shelf = |kind| read(&corpus.join(format!("upstream/happly/platonic_shelf_{kind}.ply")));
    let (ascii, binary) = (shelf("ascii").unwrap(), shelf("big_endian").unwrap());
    for (a, b) in ascii.points().flatten().zip(binary.points().flatten()) {
        assert!((a - b).abs() < 1e-4, "{a} {b}");
    }
    let cube = read(&corpus.join("upstream/assimp/cube_binary_header_with_RN_newline.ply"));
    assert!(cube.unwrap().points().flatten().all(|value| value == 0.0 || value == 1.0));
}

#[test]
fn real_range_data_are_read_whole() {
    let Some(data) = shared("data") else { return };
    let mut read_files = 0;
    for folder in data.read_dir().unwrap().map(|entry| entry.unwrap().path()) {
        for file in folder.read_dir().into_iter().flatten().map(|entry| entry.unwrap().path()) {
            let extension = file.extension().unwrap_or_default().to_string_lossy().into_owned();
            if ["ply", "xyz", "txt"].contains(&&*extension) {
                let cloud = read(&file).unwrap_or_else(|error| panic!("{error}"));
                assert!(!cloud.is_empty(), "{}", file.display());
                read_files += 1;
            }
        }
    }
    assert!(read_files > 0);
}
