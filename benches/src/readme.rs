//! Keeps a README's figures those of a run.

/// Two lines of a README, each of which is there once, and what stands between them is replaced.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Markers {
    begin: &'static str,
    end: &'static str,
}

/// Around the table without anti-aliasing.
pub(crate) const ALIASED: Markers = Markers { begin: "<!-- bench:begin -->", end: "<!-- bench:end -->" };

/// Around the tables with it.
pub(crate) const ANTI_ALIASED: Markers = Markers { begin: "<!-- bench-aa:begin -->", end: "<!-- bench-aa:end -->" };

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
