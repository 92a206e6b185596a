//! Selection of rules: `--select`, `--extend-select` and `--ignore`.

use val3_check::rule::Rule;
use val3_check::rules;
use val3_check::settings::{Exactness, RuleSelection, meant_by};
use val3_lang::suggest::{proposals, question};

use crate::user_error::UserError;

/// Parses the selection: the rules in `select` (all if it is empty) and the rules in `extend`, which may be off by
/// default, without the rules in `ignore`. An entry is a code, a code prefix, a name or `all`, in upper or lower case.
/// An entry without a matching rule is an error.
pub(crate) fn read(select: &[String], extend: &[String], ignore: &[String]) -> Result<RuleSelection, UserError> {
    let mut selection = RuleSelection::default();
    for (rule, exactness) in meant(select, "--select")? {
        selection.only.get_or_insert_default().insert(rule.code);
        if exactness == Exactness::Exact {
            selection.named.insert(rule.code);
        }
    }
    let more: Vec<&str> = meant(extend, "--extend-select")?.into_iter().map(|(rule, _)| rule.code).collect();
    selection.only.iter_mut().for_each(|only| only.extend(&more));
    selection.named.extend(more);
    selection.never = meant(ignore, "--ignore")?.into_iter().map(|(rule, _)| rule.code).collect();
    Ok(selection)
}

fn meant(entries: &[String], option: &str) -> Result<Vec<(&'static Rule, Exactness)>, UserError> {
    let mut all = Vec::new();
    for entry in entries.iter().map(|entry| entry.trim()) {
        let meant = meant_by(entry);
        if meant.is_empty() {
            return Err(unknown(entry, option));
        }
        all.extend(meant);
    }
    Ok(all)
}

fn unknown(entry: &str, option: &str) -> UserError {
    let words = rules::all().iter().flat_map(|rule| [rule.code, rule.name]);
    let help =
        question(proposals(entry, words)).unwrap_or_else(|| "`val3 explain` lists all codes and names".to_owned());
    UserError::new(format!("{option}: no rule has the code or name `{entry}`")).with_help(help)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn selected(select: &[&str], ignore: &[&str]) -> Result<RuleSelection, UserError> {
        let owned = |words: &[&str]| words.iter().map(|&word| word.to_owned()).collect::<Vec<_>>();
        read(&owned(select), &[], &owned(ignore))
    }

    #[test]
    fn words_can_extend_the_default_selection() {
        let owned = |word: &str| vec![word.to_owned()];
        let more = read(&[], &owned("V0101"), &[]).unwrap();
        assert_eq!((more.only, more.named), (None, ["V0101"].into()));
        let both = read(&owned("V0203"), &owned("unknown-name"), &owned("V0203")).unwrap();
        assert_eq!((both.only, both.named), (Some(["V0101", "V0203"].into()), ["V0101", "V0203"].into()));
        let family = read(&[], &owned("V07"), &[]).unwrap();
        assert!(family.named.len() > 5, "{family:?}");
        assert!(read(&[], &owned("sql"), &[]).unwrap_err().to_string().contains("--extend-select"));
    }

    #[test]
    fn without_words_every_rule_is_selected() {
        assert_eq!(selected(&[], &[]).unwrap(), RuleSelection::default());
    }

    #[test]
    fn rules_are_selected_by_code_prefix_or_name() {
        let selection = selected(&["v0101", " Argument-Count"], &["V0203"]).unwrap();
        assert_eq!(selection.only, Some(["V0101", "V0204"].into()));
        assert_eq!((selection.named, selection.never), (["V0101", "V0204"].into(), ["V0203"].into()));
        let family = selected(&["V02"], &[]).unwrap();
        let only = family.only.unwrap();
        assert!(only.contains("V0203") && only.iter().all(|code| code.starts_with("V02")));
        assert!(family.named.is_empty());
        assert_eq!(selected(&["all"], &[]).unwrap().only.unwrap().len(), rules::all().len());
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
