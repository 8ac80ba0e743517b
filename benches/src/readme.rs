//! Keeps a README's figures those of a run.

const BEGIN: &str = "<!-- bench:begin -->";
const END: &str = "<!-- bench:end -->";

/// The text with `figures` in place of what stands between the two markers, each of which is there once.
pub(crate) fn with_figures(readme: &str, figures: &str) -> Result<String, String> {
    let missing = || format!("needs one line {BEGIN} and, below, one line {END}");
    let (before, rest) = readme.split_once(BEGIN).ok_or_else(missing)?;
    let (old, after) = rest.split_once(END).ok_or_else(missing)?;
    if [before, old, after].iter().any(|part| part.contains(BEGIN) || part.contains(END)) {
        return Err(missing());
    }
    Ok(format!("{before}{BEGIN}\n\n{}\n\n{END}{after}", figures.trim()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_between_the_markers_changes() {
        let readme = format!("above\n{BEGIN}\nold\n{END}\nbelow\n");
        let expected = format!("above\n{BEGIN}\n\nnew\n\n{END}\nbelow\n");
        assert_eq!(with_figures(&readme, "new\n"), Ok(expected.clone()));
        assert_eq!(with_figures(&expected, "new"), Ok(expected));
    }

    #[test]
    fn markers_that_are_missing_or_in_disorder_are_an_error() {
        for readme in ["", BEGIN, END, &format!("{END}{BEGIN}"), &format!("{BEGIN}{BEGIN}{END}")] {
            assert!(with_figures(readme, "new").is_err(), "{readme}");
        }
    }
}
