//! Common indentation of the lines in a listing.

/// Removes the common indentation of all non-blank lines; the number of lines is unchanged.
pub(crate) fn dedent(text: &str) -> String {
    let shared = text.lines().filter(|line| !line.trim().is_empty()).map(indentation).min().unwrap_or(0);
    text.lines().map(|line| line.get(shared..).unwrap_or("")).collect::<Vec<_>>().join("\n")
}

fn indentation(line: &str) -> usize {
    line.len() - line.trim_start_matches(' ').len()
}

#[cfg(test)]
mod tests {
    use super::dedent;

    #[test]
    fn only_shared_blanks_are_removed() {
        assert_eq!(dedent("\n    a\n\n      b\n  "), "\na\n\n  b\n");
    }
}
