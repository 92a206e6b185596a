//! Selectors of rules: `all`, code prefixes, codes and names.

use val3_config::{ConfigError, ConfigFile};
use val3_lang::suggest::{nearest, question};

use crate::rule::Rule;
use crate::rules;

/// Exactness of a selector; a more exact selector has precedence.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Exactness {
    /// The selector `all`.
    All,
    /// A code prefix with this number of characters: `V03`.
    Family(usize),
    /// A code or a name.
    Exact,
}

/// Rules that a selector names, in upper or lower case.
pub fn meant_by(word: &str) -> Vec<(&'static Rule, Exactness)> {
    let word = word.trim();
    rules::all().iter().filter_map(|rule| Some((*rule, exactness(word, rule)?))).collect()
}

fn exactness(word: &str, rule: &Rule) -> Option<Exactness> {
    if word.eq_ignore_ascii_case("all") {
        return Some(Exactness::All);
    }
    if rule.code.eq_ignore_ascii_case(word) || rule.name.eq_ignore_ascii_case(word) {
        return Some(Exactness::Exact);
    }
    let beginning = rule.code.get(..word.len()).filter(|beginning| !beginning.is_empty())?;
    beginning.eq_ignore_ascii_case(word).then_some(Exactness::Family(word.len()))
}

/// Error for a key of `[rules]` that names no rule.
pub(super) fn unknown(file: &ConfigFile, key: &str) -> ConfigError {
    let words = rules::all().iter().flat_map(|rule| [rule.code, rule.name]);
    let help = question(nearest(key, words)).unwrap_or_else(|| {
        "write a code (V0203), a prefix of codes (V02), a name, or all; `val3 explain` lists them".to_owned()
    });
    file.fault(&format!("rules.{key}"), format!("no rule has the code or name `{key}`"), help)
}

/// Error for two keys of `[rules]` that name the same rule.
pub(super) fn twice(file: &ConfigFile, key: &str, other: &str) -> ConfigError {
    file.fault(
        &format!("rules.{key}"),
        format!("`{key}` and `{other}` mean the same findings"),
        "keep one of the two lines".to_owned(),
    )
}
