//! Path patterns of the settings `exclude` and `test.applications`.

use std::borrow::Cow;

use camino::Utf8Path;
use globset::{ErrorKind, Glob, GlobBuilder, GlobSet, GlobSetBuilder};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

/// Patterns for folders and files. A folder includes everything below it.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
#[serde(try_from = "Vec<String>", into = "Vec<String>")]
pub struct Patterns {
    patterns: Vec<String>,
    set: GlobSet,
}

impl Patterns {
    /// Whether there are no patterns, so that no path matches.
    pub fn is_empty(&self) -> bool {
        self.patterns.is_empty()
    }

    /// Whether `path`, relative to the folder of the configuration, or a parent folder matches.
    pub fn contains(&self, path: &Utf8Path) -> bool {
        let inside = |path: &&Utf8Path| !path.as_str().is_empty();
        !self.is_empty() && path.ancestors().take_while(inside).any(|path| self.set.is_match(path))
    }
}

impl PartialEq for Patterns {
    fn eq(&self, other: &Self) -> bool {
        self.patterns == other.patterns
    }
}

impl TryFrom<Vec<String>> for Patterns {
    type Error = String;

    fn try_from(patterns: Vec<String>) -> Result<Self, String> {
        let mut set = GlobSetBuilder::new();
        for pattern in &patterns {
            set.add(glob(pattern)?);
        }
        let set = set.build().map_err(|error| reason(error.kind()))?;
        Ok(Self { patterns, set })
    }
}

/// Compiles a pattern. `old/**`, `old/` and `./old` are equivalent: the folder and everything below it.
fn glob(pattern: &str) -> Result<Glob, String> {
    let path = pattern.strip_prefix("./").unwrap_or(pattern);
    let folder = path.strip_suffix("/**").unwrap_or(path).trim_end_matches('/');
    GlobBuilder::new(folder)
        .literal_separator(true)
        .case_insensitive(true)
        .build()
        .map_err(|error| format!("the pattern `{pattern}` cannot be read: {}", reason(error.kind())))
}

fn reason(fault: &ErrorKind) -> String {
    match fault {
        ErrorKind::UnclosedClass => "`[` has no `]`".to_owned(),
        ErrorKind::UnclosedAlternates => "`{` has no `}`; a brace in a name is written `[{]`".to_owned(),
        ErrorKind::UnopenedAlternates => "`}` has no `{`; a brace in a name is written `[}]`".to_owned(),
        ErrorKind::InvalidRange(first, last) => format!("the range `{first}-{last}` is descending"),
        ErrorKind::DanglingEscape => "nothing follows the last `\\`".to_owned(),
        _ => "it is too complex".to_owned(),
    }
}

impl From<Patterns> for Vec<String> {
    fn from(patterns: Patterns) -> Self {
        patterns.patterns
    }
}

impl JsonSchema for Patterns {
    fn schema_name() -> Cow<'static, str> {
        "Patterns".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        Vec::<String>::json_schema(generator)
    }

    fn inline_schema() -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn matches(pattern: &str, path: &str) -> bool {
        Patterns::try_from(vec![pattern.to_owned()]).unwrap().contains(Utf8Path::new(path))
    }

    #[test]
    fn a_folder_matches_with_its_files() {
        for pattern in ["old", "old/", "old/**", "./old", "OLD"] {
            assert!(matches(pattern, "old"), "{pattern}");
            assert!(matches(pattern, "old/a/a.pjx"), "{pattern}");
            assert!(!matches(pattern, "older/a.pjx"), "{pattern}");
            assert!(!matches(pattern, "a/old/a.pjx"), "{pattern}");
        }
    }

    #[test]
    fn stars_match_names() {
        assert!(matches("**/backup", "a/b/backup/x.pjx"));
        assert!(matches("**/backup", "backup/x.pjx"));
        assert!(matches("a/gen_*.pgx", "a/gen_1.pgx"));
        assert!(!matches("*.pgx", "a/b.pgx"));
        assert!(matches("**/*.pgx", "a/b.pgx"));
    }

    #[test]
    fn a_wrong_pattern_is_reported() {
        for (pattern, reason) in [
            ("a[", "`[` has no `]`"),
            ("a{b", "`{` has no `}`; a brace in a name is written `[{]`"),
            ("a}", "`}` has no `{`; a brace in a name is written `[}]`"),
            ("[z-a]", "the range `z-a` is descending"),
        ] {
            let error = Patterns::try_from(vec![pattern.to_owned()]).unwrap_err();
            assert_eq!(error, format!("the pattern `{pattern}` cannot be read: {reason}"));
        }
    }
}
