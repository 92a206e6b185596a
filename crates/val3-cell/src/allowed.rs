//! Pairs of things that may touch.

use globset::{GlobBuilder, GlobMatcher};

use crate::error::CellError;
use crate::file::{AllowedPair, ObjectEntry};
use crate::names::body_names;

/// Pairs that may touch.
#[derive(Debug, Clone, Default)]
pub(crate) struct Allowed(Vec<[GlobMatcher; 2]>);

impl Allowed {
    pub(crate) fn build(entries: &[AllowedPair], objects: &[ObjectEntry], axes: usize) -> Result<Self, CellError> {
        let names: Vec<String> = body_names(objects.iter().map(|object| object.name.as_str()), axes).collect();
        let pairs = entries.iter().enumerate().map(|(index, AllowedPair { names: pair, .. })| {
            let matcher = |name: &String| {
                let key = format!("allow[{index}]");
                let matcher = pattern(name).ok_or_else(|| CellError::new(&key, format!("`{name}` is no name"), ""))?;
                if names.iter().any(|body| is_named(&matcher, body)) {
                    return Ok(matcher);
                }
                let help =
                    format!("it has {}", names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "));
                Err(CellError::new(key, format!("the cell has nothing with the name `{name}`"), help))
            };
            let [first, second] = pair;
            Ok([matcher(first)?, matcher(second)?])
        });
        pairs.collect::<Result<_, _>>().map(Self)
    }

    pub(crate) fn contains(&self, first: &str, second: &str) -> bool {
        self.0.iter().any(|[one, other]| {
            let are = |first: &str, second: &str| is_named(one, first) && is_named(other, second);
            are(first, second) || are(second, first)
        })
    }
}

/// Returns the matcher for a name, in which only `*` has a meaning.
fn pattern(name: &str) -> Option<GlobMatcher> {
    let literal = |letter: char| if letter == '*' { letter.to_string() } else { globset::escape(&letter.to_string()) };
    let text: String = name.chars().map(literal).collect();
    Some(GlobBuilder::new(&text).build().ok()?.compile_matcher())
}

fn is_named(matcher: &GlobMatcher, body: &str) -> bool {
    matcher.is_match(body) || (matcher.is_match("arm") && (body == "base" || body.starts_with("link")))
}
