//! Body names, and the names that a cell file defines.

use std::collections::BTreeSet;

use crate::error::CellError;

/// Returns the names of all bodies: the base, the links, and these things and parts.
pub(crate) fn body_names<'n>(things: impl Iterator<Item = &'n str>, axes: usize) -> impl Iterator<Item = String> {
    let links = (1..=axes).map(|link| format!("link{link}"));
    std::iter::once("base".to_owned()).chain(links).chain(things.map(str::to_owned))
}

/// Returns the number of the link with a name such as `link2`; `None` for any other name.
pub(crate) fn link_number(name: &str) -> Option<usize> {
    name.strip_prefix("link")?.parse().ok().filter(|_| name.len() == "link".len() + 1)
}

/// Names of the checked entries.
#[derive(Debug, Default)]
pub(crate) struct GivenNames(BTreeSet<String>);

impl GivenNames {
    /// Checks the name of the entry `kind[index]`, and adds it.
    pub(crate) fn add(&mut self, name: &str, kind: &str, index: usize) -> Result<(), CellError> {
        let fault = |message: String, help: &str| Err(CellError::new(format!("{kind}[{index}].name"), message, help));
        if name.is_empty() {
            return fault(format!("{kind} {} has no name", index + 1), "add `name = \"…\"`: messages use it");
        }
        let is_letter = |letter: char| letter.is_ascii_alphanumeric() || letter == '_' || letter == ' ';
        let is_first = |letter: char| letter.is_ascii_alphabetic() || letter == '_';
        if !name.starts_with(is_first) || !name.chars().all(is_letter) {
            let help = "a name has letters, digits, `_` and blanks, and begins with a letter";
            return fault(format!("`{name}` is no name"), help);
        }
        if matches!(name, "world" | "base" | "flange" | "arm") || link_number(name).is_some() {
            return fault(format!("`{name}` is a part of the robot"), "choose another name");
        }
        if !self.0.insert(name.to_owned()) {
            return fault(format!("two things have the name `{name}`"), "rename one of them");
        }
        Ok(())
    }
}
