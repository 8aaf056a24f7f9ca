//! Points with what is known of each, as a table.

use std::io::{self, Write};
use std::path::Path;

use thiserror::Error;

/// Numbers in named columns, a row a point.
#[derive(Debug, Clone, PartialEq)]
pub struct PointTable {
    columns: Vec<&'static str>,
    /// Row by row.
    values: Vec<f64>,
}

/// A file format for tables of points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointTableFormat {
    /// A line of names, then a line a point; text that reads back as the same doubles.
    Csv,
    /// Binary little-endian PLY (Turk 1994) of vertices whose properties are the columns, doubles.
    Ply,
}

/// A file name that does not say which format is meant.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{path}: the extension of a file of points must be csv or ply")]
pub struct UnknownPointTableFormat {
    /// The file name.
    pub path: String,
}

impl PointTableFormat {
    /// The format of a file, from its extension in upper or lower case.
    ///
    /// # Errors
    /// If the extension is neither `csv` nor `ply`.
    pub fn from_extension(path: impl AsRef<Path>) -> Result<Self, UnknownPointTableFormat> {
        let path = path.as_ref();
        let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("csv") => Ok(Self::Csv),
            Some("ply") => Ok(Self::Ply),
            _ => Err(UnknownPointTableFormat { path: path.display().to_string() }),
        }
    }
}

impl PointTable {
    /// The table of columns and of values, row by row: as many for each row as there are columns.
    pub(super) fn new(columns: Vec<&'static str>, values: Vec<f64>) -> Self {
        Self { columns, values }
    }

    /// The names of the columns.
    pub fn columns(&self) -> &[&'static str] {
        &self.columns
    }

    /// The rows, each with a number a column.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.values.chunks_exact(self.columns.len())
    }

    /// Writes the table.
    ///
    /// # Errors
    /// If `writer` fails.
    pub fn write(
        &self,
        format: PointTableFormat,
        writer: &mut (impl Write + ?Sized),
    ) -> io::Result<()> {
        match format {
            PointTableFormat::Csv => self.write_csv(writer),
            PointTableFormat::Ply => self.write_ply(writer),
        }
    }

    fn write_csv(&self, writer: &mut (impl Write + ?Sized)) -> io::Result<()> {
        writeln!(writer, "{}", self.columns.join(","))?;
        for row in self.rows() {
            for (column, value) in row.iter().enumerate() {
                let comma = if column == 0 { "" } else { "," };
                write!(writer, "{comma}{value:?}")?;
            }
            writeln!(writer)?;
        }
        Ok(())
    }

    fn write_ply(&self, writer: &mut (impl Write + ?Sized)) -> io::Result<()> {
        writeln!(writer, "ply\nformat binary_little_endian 1.0")?;
        writeln!(writer, "element vertex {}", self.rows().len())?;
        for column in &self.columns {
            writeln!(writer, "property double {column}")?;
        }
        writeln!(writer, "end_header")?;
        self.values.iter().try_for_each(|value| writer.write_all(&value.to_le_bytes()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::{PointCloud, read_stream};
    use ply_rs_bw::parser::Parser;
    use ply_rs_bw::ply::{DefaultElement, Property};

    fn table() -> PointTable {
        let values = vec![1.0, -2.5, 1e-300, f64::NAN, 0.1, 1e22, -0.0, f64::INFINITY];
        PointTable::new(vec!["x", "y", "z", "k"], values)
    }

    #[test]
    fn both_formats_are_read_as_the_same_points() {
        let points = PointCloud::from_rows([[1.0, -2.5, 1e-300], [0.1, 1e22, -0.0]]);
        for format in [PointTableFormat::Csv, PointTableFormat::Ply] {
            let mut bytes = Vec::new();
            table().write(format, &mut bytes).unwrap();
            assert_eq!(read_stream("written", &bytes[..]).unwrap(), points, "{format:?}");
        }
    }

    #[test]
    fn the_other_columns_are_there_too() {
        let mut bytes = Vec::new();
        table().write(PointTableFormat::Csv, &mut bytes).unwrap();
        let text = String::from_utf8(bytes).unwrap();
        assert_eq!(text, "x,y,z,k\n1.0,-2.5,1e-300,NaN\n0.1,1e22,-0.0,inf\n");

        let mut bytes = Vec::new();
        table().write(PointTableFormat::Ply, &mut bytes).unwrap();
        let ply = Parser::<DefaultElement>::new().read_ply(&mut &bytes[..]).unwrap();
        let last = &ply.payload["vertex"][1];
        assert_eq!(last["k"], Property::Double(f64::INFINITY));
    }

    #[test]
    fn formats_are_told_by_extension() {
        assert_eq!(PointTableFormat::from_extension("a.PLY"), Ok(PointTableFormat::Ply));
        let error = PointTableFormat::from_extension("a.txt").unwrap_err();
        assert!(error.to_string().starts_with("a.txt: "));
    }
}
