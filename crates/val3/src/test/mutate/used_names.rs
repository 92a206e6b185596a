//! The names that a test uses: those in the lines that it executes, and in its own file.

use std::collections::BTreeSet;

/// Names in texts. Names in comments and strings count as well, which costs trials but hides nothing.
#[derive(Debug, Default)]
pub(super) struct UsedNames(BTreeSet<String>);

impl UsedNames {
    /// Adds the names of a text.
    pub(super) fn add(&mut self, text: &str) {
        let words = text.split(|character: char| !(character.is_ascii_alphanumeric() || character == '_'));
        for word in words.filter(|word| word.starts_with(|first: char| first.is_ascii_alphabetic())) {
            if !self.0.contains(word) {
                self.0.insert(word.to_owned());
            }
        }
    }

    /// Adds the fathers of used variables, and their fathers.
    pub(super) fn add_fathers<'v>(&mut self, variables: &[(&'v str, &'v [String])]) {
        loop {
            let used = variables.iter().filter(|(name, _)| self.0.contains(*name));
            let new: Vec<String> =
                used.flat_map(|(_, fathers)| *fathers).filter(|father| !self.0.contains(*father)).cloned().collect();
            if new.is_empty() {
                return;
            }
            self.0.extend(new);
        }
    }

    /// Whether the test uses a variable of this name.
    pub(super) fn contains(&self, name: &str) -> bool {
        self.0.contains(name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fathers_of_used_variables_are_used() {
        let mut used = UsedNames::default();
        used.add("movej(pPick, tGrip[n2], pal:mFast)");
        let (tray, cell) = (["fTray".to_owned()], ["fCell".to_owned()]);
        used.add_fathers(&[("fTray", &cell), ("pPick", &tray), ("pPlace", &["fOther".to_owned()])]);
        for name in ["pPick", "tGrip", "n2", "pal", "mFast", "fTray", "fCell"] {
            assert!(used.contains(name), "{name}");
        }
        assert!(!used.contains("fOther") && !used.contains("pPlace"));
    }
}
