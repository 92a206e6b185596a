//! Strings in a TOML file with their byte ranges, for features that edit or resolve names in them.

use std::ops::Range;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A string of a TOML file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TableString {
    /// Path of the key, for example `object[2].in`.
    pub key: String,
    /// The string.
    pub text: String,
    /// Byte range between the quotes.
    pub range: Range<usize>,
}

/// Returns the strings of a TOML file in source order. The file may be incomplete. Strings with escapes or several
/// lines are omitted, because offsets in their values do not match offsets in the file.
pub fn table_strings(text: &str) -> Vec<TableString> {
    let (table, _) = DeTable::parse_recoverable(text);
    let mut strings = TableStrings { text, found: Vec::new() };
    strings.add_table(table.get_ref(), "");
    strings.found.sort_by_key(|string| string.range.start);
    strings.found
}

/// Strings found so far in a text.
struct TableStrings<'t> {
    text: &'t str,
    found: Vec<TableString>,
}

impl TableStrings<'_> {
    fn add_table(&mut self, table: &DeTable<'_>, path: &str) {
        for (key, value) in table {
            let name = key.get_ref();
            let path = if path.is_empty() { name.to_string() } else { format!("{path}.{name}") };
            self.add_value(value, &path);
        }
    }

    fn add_value(&mut self, value: &Spanned<DeValue<'_>>, path: &str) {
        match value.get_ref() {
            DeValue::Table(table) => self.add_table(table, path),
            DeValue::Array(entries) => {
                for (index, entry) in entries.iter().enumerate() {
                    self.add_value(entry, &format!("{path}[{index}]"));
                }
            }
            DeValue::String(string) => {
                let Range { start, end } = value.span();
                let range = start.saturating_add(1)..end.saturating_sub(1);
                if self.text.get(range.clone()).is_some_and(|inside| inside == string) {
                    self.found.push(TableString { key: path.to_owned(), text: string.to_string(), range });
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<String> {
        let shown = |string: TableString| {
            assert_eq!(text[string.range], string.text);
            format!("{} {}", string.key, string.text)
        };
        table_strings(text).into_iter().map(shown).collect()
    }

    #[test]
    fn strings_have_keys_and_places() {
        let text = "a = \"x\"\n[[object]]\nname = 'b c'\n[[object]]\nin = \"fé\"\nshapes = [{ mesh = \"m\" }]\n";
        assert_eq!(shown(text), ["a x", "object[0].name b c", "object[1].in fé", "object[1].shapes[0].mesh m"]);
    }

    #[test]
    fn strings_without_a_place_are_omitted() {
        assert_eq!(shown("a = \"x\\ty\"\nb = \"\"\"z\"\"\"\nc = ''\n"), ["c "]);
    }

    #[test]
    fn incomplete_files_have_strings() {
        assert_eq!(
            shown("[[object]]\nname = \"a\"\nin =\n[[object]]\nin = \"fA\"\nbox = [1,"),
            ["object[0].name a", "object[1].in fA"]
        );
    }
}
