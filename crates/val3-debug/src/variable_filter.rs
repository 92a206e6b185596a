//! Filter of global variables by their names.

use std::fmt;
use std::str::FromStr;
use std::sync::Arc;

use globset::{GlobBuilder, GlobMatcher};
use val3_vm::Vm;

use crate::values::{Scope, ScopeKind};

/// Filter of global variables: a variable is shown if one of the patterns matches.
#[derive(Debug, Clone)]
pub struct VariableFilter {
    text: String,
    patterns: Vec<VariablePattern>,
}

/// Pattern for variable names, without regard to letter case.
#[derive(Debug, Clone)]
struct VariablePattern {
    /// Library identifier, or application name; `None` for the variables of all applications and libraries.
    owner: Option<GlobMatcher>,
    name: GlobMatcher,
}

impl PartialEq for VariableFilter {
    fn eq(&self, other: &Self) -> bool {
        self.text == other.text
    }
}

impl Eq for VariableFilter {}

/// Reason why a text is no [`VariableFilter`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InvalidVariableFilter(String);

impl fmt::Display for InvalidVariableFilter {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "this is no filter of variables: {}; write a filter such as `traj`, `nPush*` or `io:di*`", self.0)
    }
}

impl FromStr for VariableFilter {
    type Err = InvalidVariableFilter;

    /// Parses patterns, separated by commas or blanks: `nPush*`, `library:n*`, `library:`. `*` stands for any text, `?`
    /// for one character, `[ab]` for one of several characters. A name without them matches anywhere in a name.
    fn from_str(text: &str) -> Result<Self, InvalidVariableFilter> {
        let words = text.split([',', ' ', '\t']).filter(|word| !word.is_empty());
        let patterns: Vec<VariablePattern> = words.map(VariablePattern::parse).collect::<Result<_, _>>()?;
        if patterns.is_empty() {
            return Err(InvalidVariableFilter("it is empty".to_owned()));
        }
        Ok(Self { text: text.trim().to_owned(), patterns })
    }
}

impl VariablePattern {
    fn parse(word: &str) -> Result<Self, InvalidVariableFilter> {
        let (owner, name) = match word.split_once(':') {
            Some((owner, name)) => (Some(owner), name),
            None => (None, word),
        };
        let owner = owner.map(matcher).transpose()?;
        let has_wildcard = name.contains(['*', '?', '[']);
        let name = if has_wildcard { matcher(name)? } else { matcher(&format!("*{}*", globset::escape(name)))? };
        Ok(Self { owner, name })
    }
}

/// Compiles the pattern of a name.
fn matcher(pattern: &str) -> Result<GlobMatcher, InvalidVariableFilter> {
    let glob = GlobBuilder::new(pattern).case_insensitive(true).build();
    Ok(glob.map_err(|error| InvalidVariableFilter(error.to_string()))?.compile_matcher())
}

impl VariableFilter {
    /// The filter in the user's spelling.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.text
    }

    /// Restricts the global variables in scopes. Libraries without a matching variable are removed.
    #[must_use]
    pub fn restrict(&self, vm: &Vm, scopes: Vec<Scope>) -> Vec<Scope> {
        scopes.into_iter().filter_map(|scope| self.restrict_scope(vm, scope)).collect()
    }

    fn restrict_scope(&self, vm: &Vm, Scope { kind, inside }: Scope) -> Option<Scope> {
        let Some(instance) = inside.owner().and_then(|owner| vm.space.instance(owner)) else {
            return Some(Scope { kind, inside });
        };
        let image = &instance.image;
        let owner = match &kind {
            ScopeKind::Library(alias) => alias.as_str(),
            _ => &image.name,
        };
        let names = image.data.iter().enumerate().filter(|(_, data)| self.shows(owner, &data.name));
        let positions: Arc<[usize]> = names.map(|(position, _)| position).collect();
        let is_empty_library = positions.is_empty() && matches!(kind, ScopeKind::Library(_));
        (!is_empty_library).then(|| Scope { kind, inside: inside.choose(positions) })
    }

    fn shows(&self, owner: &str, name: &str) -> bool {
        self.patterns.iter().any(|pattern| {
            pattern.owner.as_ref().is_none_or(|pattern| pattern.is_match(owner)) && pattern.name.is_match(name)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_select_names() {
        for (filter, owner, name) in [
            ("traj", "main", "qTrajBuffer"),
            ("qTraj*", "main", "qTrajBuffer"),
            ("nPush, nPop", "main", "nPop"),
            ("io:di*", "io", "diClamp"),
            ("io:", "IO", "nAny"),
            ("n?", "main", "nA"),
            ("{", "main", "n{"),
        ] {
            assert!(filter.parse::<VariableFilter>().unwrap().shows(owner, name), "{filter} {owner}:{name}");
        }
        for (filter, owner, name) in [
            ("Traj*", "main", "qTrajBuffer"),
            ("io:di*", "main", "diClamp"),
            ("n?", "main", "nAB"),
            ("x y", "main", "z"),
        ] {
            assert!(!filter.parse::<VariableFilter>().unwrap().shows(owner, name), "{filter} {owner}:{name}");
        }
    }

    #[test]
    fn unusable_filters_are_rejected() {
        for filter in ["", " , ", "n[", "a[:n"] {
            let reason = filter.parse::<VariableFilter>().unwrap_err().to_string();
            assert!(reason.contains("write a filter such as"), "{reason}");
        }
    }
}
