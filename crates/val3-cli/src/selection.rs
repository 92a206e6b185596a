//! Which findings are wanted: `--select` and `--ignore`.

use std::collections::BTreeSet;

use val3_check::rule::Rule;

use crate::similar::{question, similar};
use crate::user_error::UserError;

/// The rules whose findings are shown.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Selection {
    codes: BTreeSet<&'static str>,
    switched_on: Vec<&'static Rule>,
}

impl Selection {
    /// Chooses from `rules`: those that an entry of `select` means (if it is empty, all that are not off by default) without those that an entry of
    /// `ignore` means. An entry is a code, the beginning of one or a name, in any letter case; one that means no rule
    /// is an error.
    pub(crate) fn new(rules: &[&'static Rule], select: &[String], ignore: &[String]) -> Result<Self, UserError> {
        let mut codes = match select {
            [] => rules.iter().filter(|rule| !rule.off).map(|rule| rule.code).collect(),
            entries => codes(rules, entries, "--select")?,
        };
        for code in self::codes(rules, ignore, "--ignore")? {
            codes.remove(code);
        }
        let switched_on = rules.iter().copied().filter(|rule| rule.off && codes.contains(rule.code)).collect();
        Ok(Self { codes, switched_on })
    }

    /// Rules that are off by default and were asked for.
    pub(crate) fn switched_on(&self) -> &[&'static Rule] {
        &self.switched_on
    }

    /// Whether findings of a rule are shown.
    pub(crate) fn contains(&self, rule: &Rule) -> bool {
        self.codes.contains(rule.code)
    }
}

fn codes(rules: &[&'static Rule], entries: &[String], option: &str) -> Result<BTreeSet<&'static str>, UserError> {
    let mut codes = BTreeSet::new();
    for entry in entries.iter().map(|entry| entry.trim()) {
        let meant: Vec<_> = rules.iter().filter(|rule| means(entry, rule)).collect();
        if meant.is_empty() {
            return Err(unknown(rules, entry, option));
        }
        codes.extend(meant.iter().map(|rule| rule.code));
    }
    Ok(codes)
}

fn means(entry: &str, rule: &Rule) -> bool {
    let beginning = rule.code.get(..entry.len()).filter(|beginning| !beginning.is_empty());
    let is_beginning = beginning.is_some_and(|beginning| beginning.eq_ignore_ascii_case(entry));
    is_beginning || rule.name.eq_ignore_ascii_case(entry)
}

fn unknown(rules: &[&'static Rule], entry: &str, option: &str) -> UserError {
    let words = rules.iter().flat_map(|rule| [rule.code, rule.name]);
    let help =
        question(&similar(entry, words)).unwrap_or_else(|| "`val3 explain` lists all codes and names".to_owned());
    UserError::new(format!("{option}: no finding has the code or name `{entry}`")).with_help(help)
}

#[cfg(test)]
mod tests {
    use val3_check::rules::find;

    use super::*;

    /// Three rules that are on, and one that is off by default.
    fn some_rules() -> Vec<&'static Rule> {
        ["V0101", "V0203", "V0204", "V0710"].iter().filter_map(|code| find(code)).collect()
    }

    fn selected(select: &[&str], ignore: &[&str]) -> Result<Vec<&'static str>, UserError> {
        let owned = |words: &[&str]| words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>();
        let rules = some_rules();
        let selection = Selection::new(&rules, &owned(select), &owned(ignore))?;
        let rules = rules.iter().filter(|rule| selection.contains(rule));
        Ok(rules.map(|rule| rule.code).collect())
    }

    #[test]
    fn without_words_everything_is_selected_that_is_not_off() {
        assert_eq!(selected(&[], &[]).unwrap(), ["V0101", "V0203", "V0204"]);
        assert_eq!(selected(&["V0710"], &[]).unwrap(), ["V0710"]);
    }

    #[test]
    fn codes_beginnings_and_names() {
        assert_eq!(selected(&["V02"], &[]).unwrap(), ["V0203", "V0204"]);
        assert_eq!(selected(&["v0101", " Argument-Count"], &[]).unwrap(), ["V0101", "V0204"]);
        assert_eq!(selected(&["V0"], &["V0203"]).unwrap(), ["V0101", "V0204", "V0710"]);
    }

    #[test]
    fn an_unknown_word_is_an_error_with_a_proposal() {
        let error = selected(&[], &["argument-typ"]).unwrap_err().to_string();
        assert!(error.contains("--ignore") && error.contains("did you mean `argument-type`"), "{error}");
        let error = selected(&["sql"], &[]).unwrap_err().to_string();
        assert!(error.contains("val3 explain"), "{error}");
        assert!(selected(&[""], &[]).is_err());
    }
}
