//! Known errors, in small text files: what is counted now must be what was counted then.

use std::{fs, path::Path};

/// Compares with `tests/methods/<name>.txt`, or writes it where `BLESS=1`.
pub(crate) fn compare(name: &str, text: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/methods").join(name).with_extension("txt");
    if std::env::var("BLESS").is_ok_and(|bless| bless == "1") {
        fs::write(&path, text).unwrap();
        return;
    }
    let recorded = fs::read_to_string(&path).unwrap_or_default();
    for (number, (then, now)) in recorded.lines().zip(text.lines()).enumerate() {
        assert_eq!(
            then,
            now,
            "{}:{}: a method has become better or worse; BLESS=1 accepts it",
            path.display(),
            number + 1
        );
    }
    assert_eq!(recorded.lines().count(), text.lines().count(), "{}: BLESS=1 accepts it", path.display());
}

/// A table with columns as wide as they need to be.
#[derive(Default)]
pub(crate) struct Table(Vec<Vec<String>>);

impl Table {
    pub(crate) fn new(head: &[&str]) -> Self {
        Self(vec![head.iter().map(|cell| (*cell).to_owned()).collect()])
    }

    pub(crate) fn row(&mut self, cells: Vec<String>) {
        self.0.push(cells);
    }

    pub(crate) fn text(&self) -> String {
        let count = self.0.iter().map(Vec::len).max().unwrap_or(0);
        let width =
            |column: usize| self.0.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max();
        let widths: Vec<usize> = (0..count).map(|column| width(column).unwrap_or(0)).collect();
        let mut text = String::new();
        for row in &self.0 {
            let mut line = String::new();
            for (column, cell) in row.iter().enumerate() {
                let width = widths[column];
                // Names to the left, numbers to the right.
                line += &if column < 2 { format!("{cell:<width$}  ") } else { format!("{cell:>width$}  ") };
            }
            text += line.trim_end();
            text.push('\n');
        }
        text
    }
}
