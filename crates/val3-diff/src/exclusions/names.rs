//! Patterns of data names.

use std::fmt::{self, Display};
use std::str::FromStr;

use globset::{GlobBuilder, GlobMatcher};

/// A pattern such as `n*Count` or `tState.n*`: `*` matches any characters, `?` one character, `[ab]` one of several
/// characters.
#[derive(Debug, Clone)]
pub struct NamePattern {
    text: String,
    matcher: GlobMatcher,
}

impl NamePattern {
    /// Whether data or a field matches, without indexes: `tState.nCount` for `tState[3].nCount`.
    pub(crate) fn matches(&self, path: &str) -> bool {
        let mut name = String::with_capacity(path.len());
        let mut rest = path;
        while let Some((before, key)) = rest.split_once('[') {
            name.push_str(before);
            rest = key.split_once(']').map_or("", |(_, after)| after);
        }
        self.matcher.is_match(name + rest)
    }
}

impl Display for NamePattern {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl FromStr for NamePattern {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let glob = GlobBuilder::new(text).build();
        let glob = glob.map_err(|error| format!("the pattern `{text}` cannot be read: {}", error.kind()))?;
        Ok(Self { text: text.to_owned(), matcher: glob.compile_matcher() })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_match_names_without_indexes() {
        let matches = |pattern: &str, path: &str| pattern.parse::<NamePattern>().unwrap().matches(path);
        assert!(matches("n*Count", "nPartCount") && matches("n*Count", "nPartCount[3]"));
        assert!(matches("tState.n?", "tState[\"a\"].nA[2]") && matches("t*", "tState[0,1].nA"));
        assert!(!matches("n*Count", "NPartCount") && !matches("nA", "nAB") && !matches("nCount", "tState.nCount"));
        assert!("n[".parse::<NamePattern>().unwrap_err().contains("`n[` cannot be read"));
    }
}
