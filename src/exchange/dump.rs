//! Dumps: snapshots as LAMMPS writes them in text, which LIGGGHTS and OVITO do too.

use super::error::ImportError;
use super::line::{Line, lines};
use super::particle::spaced;
use crate::model::Model;

/// What every snapshot begins its table with.
const ATOMS: [&str; 2] = ["ITEM:", "ATOMS"];

/// The snapshot of one particle in its bounding box.
pub(super) fn write(model: &Model, columns: &str, values: &[f64]) -> String {
    let [least, greatest] = model.bounding_box();
    let bounds: String = (0..3).map(|i| spaced(&[least[i], greatest[i]]) + "\n").collect();
    format!(
        "ITEM: TIMESTEP\n0\n\
         ITEM: NUMBER OF ATOMS\n1\n\
         ITEM: BOX BOUNDS ff ff ff\n{bounds}\
         ITEM: ATOMS id type {columns}\n\
         1 1 {}\n",
        spaced(values)
    )
}

/// The particles of one snapshot.
pub(super) struct Table<'a> {
    header: Line<'a>,
    /// A line a particle, of as many words as there are columns.
    pub rows: Vec<Line<'a>>,
}

/// Whether a text is a dump.
pub(super) fn is_dump(text: &str) -> bool {
    text.trim_start().starts_with(ATOMS[0])
}

/// The last snapshot of a dump.
pub(super) fn last_snapshot<'a>(
    text: &'a str,
    expected: &'static str,
) -> Result<Table<'a>, ImportError> {
    let mut table: Option<Table<'a>> = None;
    let mut is_in_table = false;
    for line in lines(text, '#') {
        if line.words[0] == ATOMS[0] {
            is_in_table = line.words.get(1) == Some(&ATOMS[1]);
            if is_in_table {
                table = Some(Table { header: line, rows: Vec::new() });
            }
        } else if is_in_table && let Some(table) = &mut table {
            table.push(line)?;
        }
    }
    table.ok_or(ImportError::None(expected))
}

impl<'a> Table<'a> {
    fn push(&mut self, line: Line<'a>) -> Result<(), ImportError> {
        let columns = self.header.words.len() - ATOMS.len();
        if line.words.len() != columns {
            let expected = format!("{columns} columns as in line {}", self.header.number);
            return Err(line.unexpected(columns.min(line.words.len()), &expected));
        }
        self.rows.push(line);
        Ok(())
    }

    /// The places of columns, each by the first of its names that there is.
    pub fn columns<const N: usize>(&self, names: [&[&str]; N]) -> Result<[usize; N], ImportError> {
        let columns = &self.header.words[ATOMS.len()..];
        let mut places = [0; N];
        for (place, names) in places.iter_mut().zip(names) {
            let found = names.iter().find_map(|name| columns.iter().position(|c| c == name));
            let expected = || format!("a column {}", names.join(" or "));
            *place = found.ok_or_else(|| self.header.unexpected(usize::MAX, &expected()))?;
        }
        Ok(places)
    }

    /// The numbers of a row in columns.
    pub fn numbers<const N: usize>(
        &self,
        row: &Line<'_>,
        columns: [usize; N],
    ) -> Result<[f64; N], ImportError> {
        let mut numbers = [0.0; N];
        for (number, column) in numbers.iter_mut().zip(columns) {
            *number = row.number_at(column, self.header.words[ATOMS.len() + column])?;
        }
        Ok(numbers)
    }
}
