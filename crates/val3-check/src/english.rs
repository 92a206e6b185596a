//! English grammar for wordings: articles, lists and plurals.

use val3_analysis::problem::NameKind;
use val3_lang::foreign_names::remedy;

use crate::phrase::{did_you_mean, name_kind};

/// Formats the similar name as a question, or other advice without a similar name.
pub(crate) fn meant(name: &str, near: Option<&str>, otherwise: &str) -> String {
    match near {
        _ if remedy(name).is_some() => remedy(name).unwrap_or_default().to_owned(),
        None => otherwise.to_owned(),
        Some(near) if near.eq_ignore_ascii_case(name) => {
            format!("{} Names are case-sensitive", did_you_mean(Some(near)))
        }
        near => did_you_mean(near),
    }
}

/// For example "`num`, `string` or `bool`".
pub(crate) fn one_of<T: AsRef<str>>(names: &[T]) -> String {
    let quoted: Vec<_> = names.iter().map(|name| format!("`{}`", name.as_ref())).collect();
    or(&quoted)
}

/// For example "1, 2 or 3": the parts without backticks.
pub(crate) fn or<T: AsRef<str>>(parts: &[T]) -> String {
    let parts: Vec<_> = parts.iter().map(AsRef::as_ref).collect();
    match parts.as_slice() {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [first @ .., last] => format!("{} or {last}", first.join(", ")),
    }
}

/// For example "1, 2 and 3": the parts without backticks.
pub(crate) fn and<T: AsRef<str>>(parts: &[T]) -> String {
    let parts: Vec<_> = parts.iter().map(AsRef::as_ref).collect();
    match parts.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => parts.concat(),
    }
}

/// For example "`a`, `b` and `c`". Of many names, only the first few are listed.
pub(crate) fn all_of<T: AsRef<str>>(names: &[T]) -> String {
    const SHOWN: usize = 5;
    let mut parts: Vec<_> = names.iter().take(SHOWN).map(|name| format!("`{}`", name.as_ref())).collect();
    if names.len() > SHOWN {
        parts.push(format!("{} more", names.len() - SHOWN));
    }
    and(&parts)
}

/// A name in backticks with its article: "a `num`", "an `aio`".
pub(crate) fn a(name: &str) -> String {
    format!("{} `{name}`", article(name))
}

/// A kind of name with its article: "a program". "Data" is a mass noun and has none.
pub(crate) fn a_name_kind(kind: NameKind) -> String {
    let noun = name_kind(kind);
    match kind {
        NameKind::Data => noun.to_owned(),
        _ => format!("{} {noun}", article(noun)),
    }
}

/// Indefinite article of a word. `mdesc` is pronounced "em-desc", so it needs "an".
fn article(word: &str) -> &'static str {
    let vowel = word.starts_with(['a', 'e', 'i', 'o', 'A', 'E', 'I', 'O']) || word == "mdesc";
    if vowel { "an" } else { "a" }
}

/// For example "1 argument", "3 arguments", "2 indexes".
pub(crate) fn count(number: usize, noun: &str) -> String {
    let plural = match number {
        1 => "",
        _ if noun.ends_with('x') => "es",
        _ => "s",
    };
    format!("{number} {noun}{plural}")
}

/// Describes the container in the text of a type, with an article: `num[]` is "a one-dimensional array".
pub(crate) fn container(ty: &str) -> &'static str {
    match ty.split_once('[').map(|(_, inside)| inside) {
        None => "a single value",
        Some("]") => "a one-dimensional array",
        Some(",]") => "a two-dimensional array",
        Some(",,]") => "a three-dimensional array",
        Some(_) => "a collection",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_difference_in_letter_case_is_pointed_out() {
        assert_eq!(meant("nA", Some("nB"), ""), "did you mean `nB`?");
        assert_eq!(meant("na", Some("nA"), ""), "did you mean `nA`? Names are case-sensitive");
        assert_eq!(meant("nA", None, "declare it"), "declare it");
    }

    #[test]
    fn lists_end_in_or() {
        assert_eq!(one_of(&["num"]), "`num`");
        assert_eq!(one_of(&["num", "string"]), "`num` or `string`");
        assert_eq!(or(&["1", "2", "3"]), "1, 2 or 3");
        assert_eq!(or::<&str>(&[]), "");
    }

    #[test]
    fn lists_end_in_and() {
        assert_eq!(all_of::<&str>(&[]), "");
        assert_eq!(all_of(&["a"]), "`a`");
        assert_eq!(all_of(&["a", "b"]), "`a` and `b`");
        assert_eq!(all_of(&["a", "b", "c", "d", "e", "f", "g"]), "`a`, `b`, `c`, `d`, `e` and 2 more");
    }

    #[test]
    fn articles_follow_the_sound() {
        assert_eq!(a("aio"), "an `aio`");
        assert_eq!(a("num"), "a `num`");
        assert_eq!(a("mdesc"), "an `mdesc`");
        assert_eq!(a_name_kind(NameKind::Instruction), "an instruction");
        assert_eq!(a_name_kind(NameKind::Data), "data");
    }

    #[test]
    fn counts_have_their_plural() {
        assert_eq!(count(0, "argument"), "0 arguments");
        assert_eq!(count(1, "index"), "1 index");
        assert_eq!(count(2, "index"), "2 indexes");
    }

    #[test]
    fn the_words_for_containers_are_those_of_the_manual() {
        assert_eq!(container("num"), "a single value");
        assert_eq!(container("num[,]"), "a two-dimensional array");
        assert_eq!(container("dio[\"\"]"), "a collection");
    }
}
