//! Exceptions in a cell file: pairs of bodies that may touch, and the patterns for body names.

use globset::{GlobBuilder, GlobMatcher};

use crate::error::CellError;
use crate::file::AllowedPair;
use crate::names::body_names;

/// Pairs of bodies that may touch.
#[derive(Debug, Clone, Default)]
pub(crate) struct Allowed(Vec<[GlobMatcher; 2]>);

impl Allowed {
    /// Builds the pairs. `bodies` are the names of all things and parts in the file.
    pub(crate) fn build(entries: &[AllowedPair], bodies: &[String], axes: usize) -> Result<Self, CellError> {
        let names = AllNames::new(bodies, axes);
        let pairs = entries.iter().enumerate().map(|(index, AllowedPair { names: pair, .. })| {
            let matcher = |name: &String| names.matcher(name, &format!("allow[{index}]"));
            let [first, second] = pair;
            Ok([matcher(first)?, matcher(second)?])
        });
        pairs.collect::<Result<_, _>>().map(Self)
    }

    /// Whether two bodies, in any order, may touch.
    pub(crate) fn contains(&self, first: &str, second: &str) -> bool {
        self.0.iter().any(|[one, other]| {
            let are = |first: &str, second: &str| is_named(one, first) && is_named(other, second);
            are(first, second) || are(second, first)
        })
    }
}

/// Names of all bodies, against which the patterns of a file are checked.
pub(crate) struct AllNames(Vec<String>);

impl AllNames {
    /// Collects the names of the arm's links and of all things and parts in the file.
    pub(crate) fn new(bodies: &[String], axes: usize) -> Self {
        Self(body_names(bodies.iter().map(String::as_str), axes).collect())
    }

    /// Returns the matcher for a name, or an error if it matches no body.
    pub(crate) fn matcher(&self, name: &str, key: &str) -> Result<GlobMatcher, CellError> {
        let matcher = pattern(name).ok_or_else(|| CellError::new(key, format!("`{name}` is no name"), ""))?;
        if self.0.iter().any(|body| is_named(&matcher, body)) {
            return Ok(matcher);
        }
        let known: Vec<String> = self.0.iter().map(|name| format!("`{name}`")).collect();
        let help = format!("it has {}", known.join(", "));
        Err(CellError::new(key, format!("the cell has nothing with the name `{name}`"), help))
    }
}

/// Returns the matcher for a name, in which `*` is the only wildcard.
fn pattern(name: &str) -> Option<GlobMatcher> {
    let literal = |letter: char| if letter == '*' { letter.to_string() } else { globset::escape(&letter.to_string()) };
    let text: String = name.chars().map(literal).collect();
    Some(GlobBuilder::new(&text).build().ok()?.compile_matcher())
}

/// Whether a pattern matches a body's name. `arm` matches the base and all links.
pub(crate) fn is_named(matcher: &GlobMatcher, body: &str) -> bool {
    matcher.is_match(body) || (matcher.is_match("arm") && (body == "base" || body.starts_with("link")))
}
