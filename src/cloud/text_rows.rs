//! Rows of values parted by blanks, one row a line, as PLY and PCD write them in ASCII.

use super::error::{Mismatch, Place, Problem, excerpt, not_a_number};
use super::input::Input;
use super::number::{parse, parse_count, tokens};
use super::points::Points;

/// Names of the axes in messages.
pub(super) const AXES: [&str; 3] = ["x", "y", "z"];

/// What a value in a row stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Value {
    /// The coordinate on the axis 0, 1 or 2.
    Coordinate(usize),
    /// Something else.
    Other,
    /// A length, and as many further values.
    List,
}

/// The rows of an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct TextRows<'n> {
    /// What the rows are called in messages.
    pub element: &'n str,
    /// The values of a row.
    pub values: Vec<Value>,
}

impl TextRows<'_> {
    /// Reads `count` rows, leaving out empty lines; those of points are handed on.
    ///
    /// # Errors
    /// The input cannot be read or ends too early; a row has too few or too many values, or a
    /// coordinate or the length of a list is not a number.
    pub fn read(
        &self,
        input: &mut Input<'_>,
        count: u64,
        mut points: Option<&mut impl Points>,
    ) -> Result<(), Problem> {
        let mut row = 0;
        while row < count && !self.values.is_empty() {
            let line_number = input.line_number() + 1;
            let place = || Place::TextRow { element: self.element.into(), row, line: line_number };
            let Some(line) = input.line()? else {
                let rows = format!("{count} rows");
                return Err(Problem::malformed(place(), rows, "the end of the file"));
            };
            if line.trim_ascii().is_empty() {
                continue;
            }
            let point = self.parse(line).map_err(|mismatch| mismatch.at(place()))?;
            if let Some(points) = points.as_deref_mut() {
                points.push(point);
            }
            row += 1;
        }
        Ok(())
    }

    /// The coordinates in a row; zero on an axis of which there is no value.
    fn parse(&self, line: &[u8]) -> Result<[f64; 3], Mismatch> {
        let mut point = [0.0; 3];
        let mut tokens = tokens(line);
        for (index, value) in self.values.iter().enumerate() {
            let token = tokens.next().ok_or_else(|| self.too_few(index, line))?;
            match *value {
                Value::Other => {}
                Value::Coordinate(axis) => {
                    point[axis] = parse(token).ok_or_else(|| {
                        Mismatch::new(format!("a number for {}", AXES[axis]), not_a_number(token))
                    })?;
                }
                Value::List => {
                    let length = parse_count(token)
                        .ok_or_else(|| Mismatch::new("the length of a list", excerpt(token)))?;
                    for found in 0..length {
                        tokens.next().ok_or_else(|| {
                            let expected = format!("a list of {length} values");
                            Mismatch::new(expected, format!("{found} in {}", excerpt(line)))
                        })?;
                    }
                }
            }
        }
        match tokens.next() {
            None => Ok(point),
            Some(token) => Err(Mismatch::new("the end of the row", excerpt(token))),
        }
    }

    fn too_few(&self, found: usize, line: &[u8]) -> Mismatch {
        let expected = format!("{} values", self.values.len());
        Mismatch::new(expected, format!("{found} in {}", excerpt(line)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::PointCloud;

    fn read(values: &[Value], count: u64, text: &str) -> Result<PointCloud, String> {
        let rows = TextRows { element: "vertex", values: values.to_vec() };
        let mut cloud = PointCloud::new();
        let mut input = Input::new(text.as_bytes(), None);
        match rows.read(&mut input, count, Some(&mut cloud)) {
            Ok(()) => Ok(cloud),
            Err(problem) => Err(problem.to_string()),
        }
    }

    const XYZ: [Value; 3] = [Value::Coordinate(0), Value::Coordinate(1), Value::Coordinate(2)];
    const LIST_THEN_ZX: [Value; 3] = [Value::List, Value::Coordinate(2), Value::Coordinate(0)];

    #[test]
    fn values_are_found_in_any_order_behind_lists_and_empty_lines() {
        let cloud = read(&LIST_THEN_ZX, 2, "2 7 8 3 1\n \r\n0\t6 4").unwrap();
        assert_eq!(cloud.columns(), [&[1.0, 4.0], &[0.0, 0.0], &[3.0, 6.0]]);
    }

    #[test]
    fn values_that_are_not_finite_skip_the_row() {
        let cloud = read(&XYZ, 3, "nan 0 0\n1 2 3\n-1.#IND 0 1e999").unwrap();
        assert_eq!((cloud.len(), cloud.skipped_rows()), (1, &[0, 2][..]));
    }

    #[test]
    fn a_row_that_does_not_fit_is_named() {
        for (values, text, message) in [
            (XYZ, "1 2 3\n4 5", "row 1 (line 2): expected 3 values, found 2 in `4 5`"),
            (XYZ, "1 2 3 4", "row 0 (line 1): expected the end of the row, found `4`"),
            (XYZ, "1 2 3", "row 1 (line 2): expected 2 rows, found the end of the file"),
            (XYZ, "1 2 x", "row 0 (line 1): expected a number for z, found `x`"),
            (LIST_THEN_ZX, "-1 2 3", "row 0 (line 1): expected the length of a list, found `-1`"),
            (LIST_THEN_ZX, "9 1", "row 0 (line 1): expected a list of 9 values, found 1 in `9 1`"),
        ] {
            assert_eq!(read(&values, 2, text), Err(format!("vertex {message}")));
        }
        let error = read(&XYZ, 1, "1,5 2,5 3,5").unwrap_err();
        assert!(error.contains("row 0") && error.contains("decimal point"), "{error}");
    }

    #[test]
    fn rows_without_values_take_no_time() {
        assert!(read(&[], u64::MAX, "").unwrap().is_empty());
    }
}
