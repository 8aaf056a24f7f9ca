//! Text: a row a line, in whatever dialect of XYZ, CSV or TSV.

mod separator;

use self::separator::Separator;
use super::error::{Mismatch, Place, Problem, excerpt, not_a_number};
use super::input::Input;
use super::number::{parse, parse_count};
use super::points::Points;
use super::text_rows::AXES;

/// Reads the coordinates of each row: the columns that a first line names x, y and z, or else the
/// first three.
///
/// Empty lines and those that begin with `#`, `//` or `%` are left out. A first line of one whole
/// number is the number of rows that follow.
///
/// # Errors
/// The input cannot be read, a row has too few columns or a coordinate that is not a number, there
/// are no rows or not as many as the first line says.
pub(super) fn read<P: Points>(input: &mut Input<'_>) -> Result<P, Problem> {
    let mut points = P::with_capacity(0);
    let mut declared = None;
    let mut columns = None;
    let mut separator = None;
    loop {
        let number = input.line_number() + 1;
        let Some(line) = input.line()? else { break };
        if is_comment(line) {
            continue;
        }
        let row = points.rows() as u64;
        let is_first = row == 0 && columns.is_none();
        if is_first && declared.is_none() && parse_count(line.trim_ascii()).is_some() {
            declared = parse_count(line.trim_ascii()).map(|count| (count, number));
            continue;
        }
        if is_first && is_header(line) {
            columns = Some(named_columns(line).map_err(|error| error.at(Place::Line(number)))?);
            continue;
        }
        let separator = *separator.get_or_insert_with(|| Separator::of(line));
        let columns = *columns.get_or_insert([0, 1, 2]);
        let point = parse_row(line, separator, columns).map_err(|mismatch| {
            mismatch.at(Place::TextRow { element: "point".into(), row, line: number })
        })?;
        points.push(point);
    }
    let rows = points.rows() as u64;
    match declared {
        Some((count, line)) if count != rows => Err(Problem::malformed(
            Place::Line(line),
            format!("the number of rows that follow, {rows}"),
            format!("`{count}`"),
        )),
        _ if rows == 0 => Err(Problem::NoPoints("there are no rows of numbers")),
        _ => Ok(points),
    }
}

fn is_comment(line: &[u8]) -> bool {
    let line = line.trim_ascii();
    line.is_empty() || [&b"#"[..], b"//", b"%"].iter().any(|mark| line.starts_with(mark))
}

/// Whether a line names columns: three or more fields, none a number, the first a word.
fn is_header(line: &[u8]) -> bool {
    let fields = || Separator::of(line).fields(line);
    let is_word_start = |byte: &u8| byte.is_ascii_alphabetic() || *byte == b'_' || *byte >= 0x80;
    fields().count() >= 3
        && fields().all(|field| parse(field).is_none())
        && fields().next().is_some_and(|field| field.first().is_some_and(is_word_start))
}

/// The columns named x, y and z, or the first three if none is.
fn named_columns(line: &[u8]) -> Result<[usize; 3], Mismatch> {
    let mut columns = [None; 3];
    for (index, field) in Separator::of(line).fields(line).enumerate() {
        let axis = AXES.iter().position(|axis| field.eq_ignore_ascii_case(axis.as_bytes()));
        let Some(axis) = axis else { continue };
        if columns[axis].replace(index).is_some() {
            let expected = format!("one column named {}", AXES[axis]);
            return Err(Mismatch::new(expected, excerpt(line)));
        }
    }
    match columns {
        [None, None, None] => Ok([0, 1, 2]),
        [Some(x), Some(y), Some(z)] => Ok([x, y, z]),
        _ => Err(Mismatch::new("columns named x, y and z, or none of them", excerpt(line))),
    }
}

fn parse_row(line: &[u8], separator: Separator, columns: [usize; 3]) -> Result<[f64; 3], Mismatch> {
    let [x, y, z] = columns;
    let needed = x.max(y).max(z) + 1;
    let mut point = [0.0; 3];
    let mut found = 0;
    for (index, field) in separator.fields(line).take(needed).enumerate() {
        found += 1;
        if let Some(axis) = columns.iter().position(|column| *column == index) {
            point[axis] = parse(field).ok_or_else(|| {
                let has_blank = field.iter().any(u8::is_ascii_whitespace);
                let shown = if has_blank { line } else { field };
                Mismatch::new(format!("a number for {}", AXES[axis]), not_a_number(shown))
            })?;
        }
    }
    if found < needed {
        let found = format!("{found} in {}", excerpt(line));
        return Err(Mismatch::new(format!("{needed} columns"), found));
    }
    Ok(point)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::PointCloud;

    fn cloud(text: &str) -> Result<PointCloud, String> {
        read(&mut Input::new(text.as_bytes(), None)).map_err(|problem| problem.to_string())
    }

    #[test]
    fn every_dialect_reads_the_same() {
        let expected = PointCloud::from_rows([[1.0, 2.0, 3.0], [-4.5, 5e-1, 6.0]]);
        for text in [
            "1 2 3\n-4.5 .5 6\n",
            "1,2,3\r\n-4.5,.5,6",
            "1;2;3\r-4.5; .5 ;6\r",
            "1\t2\t3\ta label\n-4.5\t.5\t6",
            "  1   2 3 255 n/a\n\n-4.5 .5 6 \n",
            "# a\n// b\n% c\n1 2 3\n#d\n-4.5 .5 6\n",
            "2\n1 2 3\n-4.5 .5 6\n",
            "x,y,z\n1,2,3\n-4.5,.5,6\n",
            "x, y, z\n1 2 3\n-4.5 .5 6\n",
            "\"Z\";\"label\";\"X\";\"Y\"\n3;\"a;b\";1;2\n6;;-4.5;.5\n",
            "Easting Northing Height\n1 2 3\n-4.5 .5 6\n",
            "id\tx\ty\tz\nfirst\t1\t2\t3\n\t-4.5\t.5\t6\n",
            "\"1\",\"2\",\"3\"\n\"-4.5\",\"0.5\",\"6\"",
        ] {
            assert_eq!(cloud(text).as_ref(), Ok(&expected), "{text:?}");
        }
    }

    #[test]
    fn rows_that_are_not_finite_are_skipped_even_if_all_are() {
        let cloud = cloud("nan nan nan\n1 2 inf\n").unwrap();
        assert_eq!((cloud.len(), cloud.rows()), (0, 2));
    }

    #[test]
    fn what_does_not_fit_is_named_by_its_line() {
        for (text, message) in [
            ("1 2 3\n\n4 5\n", "point row 1 (line 3): expected 3 columns, found 2 in `4 5`"),
            ("1,2,3\n4,,6\n", "point row 1 (line 2): expected a number for y, found ``"),
            ("3\n1 2 3\n", "line 1: expected the number of rows that follow, 1, found `3`"),
            ("1\n1 2 3\n4 5 6\n", "line 1: expected the number of rows that follow, 2"),
            ("x,y,w\n1,2,3\n", "line 1: expected columns named x, y and z"),
            ("x,y,z,X\n1,2,3,4\n", "line 1: expected one column named x"),
            ("1 2 a\n", "point row 0 (line 1): expected a number for z, found `a`"),
            ("hello\n", "point row 0 (line 1): expected a number for x"),
            ("1 2 3\n4 5 \0\n", r"point row 1 (line 2): expected a number for z, found `\0`"),
        ] {
            let error = cloud(text).unwrap_err();
            assert!(error.starts_with(message), "{error}");
        }
    }

    #[test]
    fn decimal_commas_are_told() {
        for text in ["1,5;2,5;3,5\n", "1,5 2,5 3,5\n", "1,5\t2,5\t3,5\n", "1;2;3\n1;2;3,5\n"] {
            let error = cloud(text).unwrap_err();
            assert!(error.contains("decimal point"), "{text:?}: {error}");
        }
    }

    #[test]
    fn text_without_rows_holds_no_points() {
        for text in ["\n", "# nothing\n", "x y z\n", "0\n"] {
            assert!(cloud(text).unwrap_err().starts_with("holds no points"), "{text:?}");
        }
    }
}
