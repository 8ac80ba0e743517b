//! Keeps a document's figures those of a run.

use std::{fs, path::Path};

use crate::save;

/// Two lines of a document, each of which is there once, and what stands between them is replaced.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Markers {
    begin: &'static str,
    end: &'static str,
}

/// Around the table without anti-aliasing.
pub(crate) const ALIASED: Markers = Markers { begin: "<!-- bench:begin -->", end: "<!-- bench:end -->" };

/// Around the tables with it.
pub(crate) const ANTI_ALIASED: Markers = Markers { begin: "<!-- bench-aa:begin -->", end: "<!-- bench-aa:end -->" };

/// Around the tables of real drawings.
pub(crate) const DRAWINGS: Markers =
    Markers { begin: "<!-- bench-drawings:begin -->", end: "<!-- bench-drawings:end -->" };

/// A file whose figures are to be replaced.
#[derive(Debug)]
pub(crate) struct Document<'a> {
    path: &'a Path,
    text: String,
    markers: &'a [Markers],
}

impl<'a> Document<'a> {
    /// Finds the markers, too, so that what is missing is known before the minutes of measuring.
    pub(crate) fn read(path: &'a Path, markers: &'a [Markers]) -> Result<Self, String> {
        let text = fs::read_to_string(path).map_err(|error| format!("{}: {error}", path.display()))?;
        let document = Self { path, text, markers };
        document.with_figures(&vec![""; markers.len()])?;
        Ok(document)
    }

    fn with_figures(&self, figures: &[&str]) -> Result<String, String> {
        let replaced = self
            .markers
            .iter()
            .zip(figures)
            .try_fold(self.text.clone(), |text, (markers, figures)| markers.replace(&text, figures));
        replaced.map_err(|error| format!("{}: {error}", self.path.display()))
    }

    /// As many figures as there are markers.
    pub(crate) fn save(self, figures: &[&str]) -> Result<(), String> {
        save(self.path, self.with_figures(figures)?)
    }
}

impl Markers {
    /// The text with `figures` between the markers.
    pub(crate) fn replace(self, readme: &str, figures: &str) -> Result<String, String> {
        let Self { begin, end } = self;
        let missing = || format!("needs one line {begin} and, below, one line {end}");
        let (before, rest) = readme.split_once(begin).ok_or_else(missing)?;
        let (old, after) = rest.split_once(end).ok_or_else(missing)?;
        if [before, old, after].iter().any(|part| part.contains(begin) || part.contains(end)) {
            return Err(missing());
        }
        Ok(format!("{before}{begin}\n\n{}\n\n{end}{after}", figures.trim()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_between_the_markers_changes() {
        for markers in [ALIASED, ANTI_ALIASED] {
            let Markers { begin, end } = markers;
            let readme = format!("above\n{begin}\nold\n{end}\nbelow\n");
            let expected = format!("above\n{begin}\n\nnew\n\n{end}\nbelow\n");
            assert_eq!(markers.replace(&readme, "new\n"), Ok(expected.clone()));
            assert_eq!(markers.replace(&expected, "new"), Ok(expected));
        }
    }

    #[test]
    fn markers_that_are_missing_or_in_disorder_are_an_error() {
        let Markers { begin, end } = ALIASED;
        for readme in ["", begin, end, &format!("{end}{begin}"), &format!("{begin}{begin}{end}")] {
            assert!(ALIASED.replace(readme, "new").is_err(), "{readme}");
        }
        assert!(ANTI_ALIASED.replace(&format!("{begin}{end}"), "new").is_err());
    }
}
