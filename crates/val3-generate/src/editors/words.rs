//! Words of the language as regular expressions.

use val3_lang::enumerations::ENUMERATORS;
use val3_lang::instruction::Family;
use val3_lang::{builtins, instructions, keywords};

/// Returns the words that open, divide or close a block.
pub(crate) fn control() -> String {
    let others = operators().chain(truths()).collect::<Vec<_>>();
    let control = keywords::KEYWORDS.into_iter().filter(|keyword| !others.contains(keyword));
    any_case(control)
}

/// Returns `and`, `or`, `xor`.
pub(crate) fn word_operators() -> String {
    any_case(operators())
}

/// Returns `true`, `false`.
pub(crate) fn truth_values() -> String {
    any_case(truths())
}

fn operators() -> impl Iterator<Item = &'static str> {
    ["and", "or", "xor"].into_iter()
}

fn truths() -> impl Iterator<Item = &'static str> {
    ["true", "false"].into_iter()
}

/// Returns the values of fields: `off`, `lefty`.
pub(crate) fn enumerators() -> String {
    one_of(ENUMERATORS.iter().flat_map(|row| [row.name, row.file_name]))
}

/// Returns `world`, `flange`.
pub(crate) fn built_in_variables() -> String {
    one_of(builtins::BUILTINS.iter().filter(|row| row.is_variable).map(|row| row.name))
}

/// Returns the instruction families by the names that themes use, with their instructions that begin with a letter.
pub(crate) fn instruction_families() -> Vec<(String, String)> {
    let mut families: Vec<Family> = instructions::all().iter().map(|row| row.family).collect();
    families.sort();
    families.dedup();
    let named = families.into_iter().map(|family| (format!("{family:?}").to_lowercase(), instruction_words(family)));
    named.filter(|(_, words)| words != NOTHING).collect()
}

/// Matches the instructions of a family that begin with a letter.
fn instruction_words(family: Family) -> String {
    let names = instructions::all().iter().filter(|row| row.family == family).map(|row| row.name);
    one_of(names.filter(|name| name.starts_with(|first: char| first.is_ascii_alphabetic())))
}

/// Matches no text.
const NOTHING: &str = "(?!)";

fn any_case<'a>(words: impl Iterator<Item = &'a str>) -> String {
    format!("(?i){}", one_of(words))
}

/// Matches any of these words, only as a complete word. Long words precede short ones, because the first matching
/// alternative counts.
fn one_of<'a>(words: impl Iterator<Item = &'a str>) -> String {
    let mut words: Vec<&str> = words.collect();
    words.sort_by_key(|word| (std::cmp::Reverse(word.len()), *word));
    words.dedup();
    if words.is_empty() {
        return NOTHING.to_owned();
    }
    format!("\\b(?:{})\\b", words.join("|"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_keyword_has_one_kind() {
        let all = [control(), word_operators(), truth_values()].concat();
        for keyword in keywords::KEYWORDS {
            let word = |found: &&str| *found == keyword;
            assert_eq!(all.split(|c: char| !c.is_ascii_alphabetic()).filter(word).count(), 1, "{keyword}");
        }
    }

    #[test]
    fn every_plain_instruction_has_a_family() {
        let all: String = instruction_families().into_iter().map(|(_, words)| words).collect();
        let words: Vec<&str> = all.split(|c: char| !c.is_ascii_alphanumeric()).collect();
        assert!(words.contains(&"movej") && words.contains(&"waitEndMove") && words.contains(&"size"));
    }
}
