//! Points with whether each is of the surface, as PLY.

use std::io::{self, Write};

use super::PointCloud;

/// Writes the points kept as binary little-endian PLY (Turk 1994), coordinates as doubles, each
/// with `inlier`: 1 on the surface, 0 for strays.
///
/// # Errors
/// If `writer` fails.
///
/// # Panics
/// If there are not as many answers as points.
pub fn write_inliers(
    cloud: &PointCloud,
    is_inlier: &[bool],
    writer: &mut (impl Write + ?Sized),
) -> io::Result<()> {
    assert_eq!(cloud.len(), is_inlier.len());
    write!(
        writer,
        "ply\n\
         format binary_little_endian 1.0\n\
         element vertex {}\n\
         property double x\n\
         property double y\n\
         property double z\n\
         property uchar inlier\n\
         end_header\n",
        cloud.len(),
    )?;
    for (point, is_inlier) in cloud.points().zip(is_inlier) {
        point.iter().try_for_each(|coordinate| writer.write_all(&coordinate.to_le_bytes()))?;
        writer.write_all(&[u8::from(*is_inlier)])?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use ply_rs_bw::parser::Parser;
    use ply_rs_bw::ply::{DefaultElement, Property};

    use super::*;
    use crate::cloud::read_stream;

    #[test]
    fn another_reader_finds_the_answers_and_ours_the_points() {
        let cloud = PointCloud::from_rows([[1.0, 2.5, -3.0], [0.1, 1e300, 4.0]]);
        let mut bytes = Vec::new();
        write_inliers(&cloud, &[true, false], &mut bytes).unwrap();
        let ply = Parser::<DefaultElement>::new().read_ply(&mut &bytes[..]).unwrap();
        let answers: Vec<&Property> =
            ply.payload["vertex"].iter().map(|vertex| &vertex["inlier"]).collect();
        assert_eq!(answers, [&Property::UChar(1), &Property::UChar(0)]);
        assert_eq!(read_stream("written", &bytes[..]).unwrap(), cloud);
    }
}
