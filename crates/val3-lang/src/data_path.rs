//! Paths of data as data files, rules and editor features write them: `lib:fTable[0].trsf`.

use std::fmt;

/// Path of data, for example `tSlots[1,2].pPlace[0]` or `part:sNames["a"]`. Any text is a path; its parts may not
/// exist.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct DataPath<'t>(&'t str);

/// Name in a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct DataPathStep<'t> {
    /// Byte offset of the name in the path.
    pub offset: usize,
    /// Name of the variable or field, without an index.
    pub name: &'t str,
}

impl<'t> DataPath<'t> {
    /// The path with this text.
    #[must_use]
    pub const fn new(text: &'t str) -> Self {
        Self(text)
    }

    /// Text of the path.
    #[must_use]
    pub const fn text(self) -> &'t str {
        self.0
    }

    /// Identifier of the library before the colon; `None` for data of the application itself.
    #[must_use]
    pub fn library(self) -> Option<&'t str> {
        self.split_library().map(|(library, _)| library)
    }

    /// Identifier of the library, and the path in the library. A colon in an index separates nothing.
    #[must_use]
    pub fn split_library(self) -> Option<(&'t str, DataPath<'t>)> {
        let (library, rest) = self.0.split_once(':')?;
        (!library.contains(['[', '.', '"', '&'])).then_some((library, Self(rest)))
    }

    /// Name of the variable at the beginning, without library, indexes and fields.
    #[must_use]
    pub fn root(self) -> &'t str {
        let path = self.split_library().map_or(self.0, |(_, path)| path.0);
        path.split(['[', '.', ':']).next().unwrap_or(path)
    }

    /// Text before the first index: the container whose value or element the path names.
    #[must_use]
    pub fn before_index(self) -> &'t str {
        self.0.split('[').next().unwrap_or(self.0)
    }

    /// Names of a path without a library: the variable, then the fields. Indexes are no names.
    pub fn steps(self) -> impl Iterator<Item = DataPathStep<'t>> {
        let mut rest = Some(self.0);
        std::iter::from_fn(move || {
            let text = rest?;
            let (name, tail) = text.split_at(text.find(['[', '.']).unwrap_or(text.len()));
            rest = match tail.chars().next() {
                Some('.') => tail.get(1..),
                _ => tail.find("].").and_then(|end| tail.get(end + 2..)),
            };
            Some(DataPathStep { offset: self.0.len() - text.len(), name })
        })
    }

    /// The path without its indexes: `tSlots.pPlace` for `tSlots[1,2].pPlace[0]`.
    #[must_use]
    pub fn without_indexes(self) -> String {
        self.0.split('[').map(|part| part.split_once(']').map_or(part, |(_, rest)| rest)).collect()
    }

    /// The path as in programs: `tSlots[1,2].pPlace` for `tSlots[1,2].pPlace[0]`, `pPick["near"]` for `pPick[near]`.
    #[must_use]
    pub fn in_code(self) -> String {
        let mut shown = String::new();
        for part in self.0.split('[') {
            match part.split_once(']') {
                None => shown.push_str(part),
                Some(("0", rest)) => shown.push_str(rest),
                Some((key, rest)) => {
                    let is_index = key.bytes().all(|byte| byte.is_ascii_digit() || byte == b',');
                    let quote = if is_index { "" } else { "\"" };
                    shown.extend(["[", quote, key, quote, "]", rest]);
                }
            }
        }
        shown
    }
}

impl fmt::Display for DataPath<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.0)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::DataPath;

    fn steps(path: &str) -> Vec<String> {
        DataPath::new(path).steps().map(|step| format!("{}{}", step.offset, step.name)).collect()
    }

    #[test]
    fn a_path_consists_of_names() {
        assert_eq!(steps("fTable"), ["0fTable"]);
        assert_eq!(steps("tSlot[&quot;a.b&quot;].fFrame[0]"), ["0tSlot", "23fFrame"]);
        assert_eq!(steps("a.b[0].c"), ["0a", "2b", "7c"]);
    }

    #[test]
    fn the_root_is_the_variable() {
        let paths = ["fTable", "lib:fTable[0].trsf", "tSlots.pPlace", "sNames[\"a:b\"]", ""];
        assert_eq!(paths.map(|path| DataPath::new(path).root()), ["fTable", "fTable", "tSlots", "sNames", ""]);
        let libraries = [None, Some("lib"), None, None, None];
        assert_eq!(paths.map(|path| DataPath::new(path).library()), libraries);
    }

    #[test]
    fn the_container_is_before_the_first_index() {
        let paths = ["tSlots.pPlace[2]", "lib:fTable[0].trsf", "nCount"];
        assert_eq!(paths.map(|path| DataPath::new(path).before_index()), ["tSlots.pPlace", "lib:fTable", "nCount"]);
    }

    #[test]
    fn code_names_no_first_element() {
        let shown = |path| DataPath::new(path).in_code();
        assert_eq!(shown("tSlots[1,2].pPlace[0]"), "tSlots[1,2].pPlace");
        assert_eq!(shown("pPick[near]"), "pPick[\"near\"]");
        assert_eq!(shown("fTable"), "fTable");
    }

    fn name() -> impl Strategy<Value = String> {
        "[a-z][A-Za-z0-9_]{0,8}"
    }

    fn part() -> impl Strategy<Value = (String, Option<String>)> {
        (name(), prop::option::of("[0-9]{1,3}(,[0-9]{1,3}){0,2}"))
    }

    fn step_text(step: &(String, Option<String>)) -> String {
        let (name, index) = step;
        index.as_ref().map_or_else(|| name.clone(), |index| format!("{name}[{index}]"))
    }

    proptest! {
        #[test]
        fn a_path_contains_the_parts_that_it_was_built_of(
            library in prop::option::of(name()),
            parts in prop::collection::vec(part(), 1..5),
        ) {
            let inside = parts.iter().map(step_text).collect::<Vec<_>>().join(".");
            let text = library.as_ref().map_or(inside.clone(), |library| format!("{library}:{inside}"));
            let path = DataPath::new(&text);
            let names: Vec<&str> = parts.iter().map(|(name, _)| name.as_str()).collect();
            prop_assert_eq!(path.to_string(), &*text);
            prop_assert_eq!(path.library(), library.as_deref());
            prop_assert_eq!(path.root(), names[0]);
            let inner = path.split_library().map_or(path, |(_, inner)| inner);
            prop_assert_eq!(inner.text(), &*inside);
            prop_assert_eq!(inner.without_indexes(), names.join("."));
            for (step, name) in inner.steps().zip(&names) {
                prop_assert_eq!(step.name, *name);
                prop_assert!(inside[step.offset..].starts_with(name));
            }
            prop_assert_eq!(inner.steps().count(), names.len());
        }

        #[test]
        fn any_text_is_a_path(text in "\\PC{0,20}") {
            let path = DataPath::new(&text);
            prop_assert!(text.contains(path.root()));
            prop_assert!(path.steps().all(|step| text[step.offset..].starts_with(step.name)));
            let _ = (path.in_code(), path.without_indexes(), path.library());
        }
    }
}
