//! The setting `exclude`.

use std::borrow::Cow;

use camino::Utf8Path;
use globset::{Glob, GlobBuilder, GlobSet, GlobSetBuilder};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Serialize};

/// Patterns for folders and files. An excluded folder includes everything below it.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
#[serde(try_from = "Vec<String>", into = "Vec<String>")]
pub struct Exclude {
    patterns: Vec<String>,
    set: GlobSet,
}

impl Exclude {
    /// Whether nothing is excluded.
    pub fn is_empty(&self) -> bool {
        self.patterns.is_empty()
    }

    /// Whether `path`, relative to the folder of the configuration, or a folder around it matches.
    pub fn contains(&self, path: &Utf8Path) -> bool {
        let inside = |path: &&Utf8Path| !path.as_str().is_empty();
        !self.is_empty() && path.ancestors().take_while(inside).any(|path| self.set.is_match(path))
    }
}

impl PartialEq for Exclude {
    fn eq(&self, other: &Self) -> bool {
        self.patterns == other.patterns
    }
}

impl TryFrom<Vec<String>> for Exclude {
    type Error = String;

    fn try_from(patterns: Vec<String>) -> Result<Self, String> {
        let mut set = GlobSetBuilder::new();
        for pattern in &patterns {
            set.add(glob(pattern)?);
        }
        let set = set.build().map_err(|error| error.kind().to_string())?;
        Ok(Self { patterns, set })
    }
}

/// `old/**`, `old/` and `./old` mean the same: the folder and everything below it.
fn glob(pattern: &str) -> Result<Glob, String> {
    let path = pattern.strip_prefix("./").unwrap_or(pattern);
    let folder = path.strip_suffix("/**").unwrap_or(path).trim_end_matches('/');
    GlobBuilder::new(folder)
        .literal_separator(true)
        .case_insensitive(true)
        .build()
        .map_err(|error| format!("the pattern `{pattern}` cannot be read: {}", error.kind()))
}

impl From<Exclude> for Vec<String> {
    fn from(exclude: Exclude) -> Self {
        exclude.patterns
    }
}

impl JsonSchema for Exclude {
    fn schema_name() -> Cow<'static, str> {
        "Exclude".into()
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

    fn excludes(pattern: &str, path: &str) -> bool {
        Exclude::try_from(vec![pattern.to_owned()]).unwrap().contains(Utf8Path::new(path))
    }

    #[test]
    fn a_folder_is_excluded_with_its_files() {
        for pattern in ["old", "old/", "old/**", "./old", "OLD"] {
            assert!(excludes(pattern, "old"), "{pattern}");
            assert!(excludes(pattern, "old/a/a.pjx"), "{pattern}");
            assert!(!excludes(pattern, "older/a.pjx"), "{pattern}");
            assert!(!excludes(pattern, "a/old/a.pjx"), "{pattern}");
        }
    }

    #[test]
    fn stars_match_names() {
        assert!(excludes("**/backup", "a/b/backup/x.pjx"));
        assert!(excludes("**/backup", "backup/x.pjx"));
        assert!(excludes("a/gen_*.pgx", "a/gen_1.pgx"));
        assert!(!excludes("*.pgx", "a/b.pgx"));
        assert!(excludes("**/*.pgx", "a/b.pgx"));
    }

    #[test]
    fn a_wrong_pattern_is_reported() {
        let error = Exclude::try_from(vec!["a[".to_owned()]).unwrap_err();
        assert!(error.contains("`a[`"), "{error}");
    }
}
