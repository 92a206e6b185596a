//! The tokens of the grammar: how a quoted literal is called in `SyntaxKind` and in accessors.

use anyhow::Context;

use super::names;

/// Literals that are no words, with the name of their kind.
const PUNCTUATION: &[(&str, &str)] = &[
    ("(", "L_PAREN"),
    (")", "R_PAREN"),
    ("[", "L_BRACK"),
    ("]", "R_BRACK"),
    ("{", "L_CURLY"),
    ("}", "R_CURLY"),
    (",", "COMMA"),
    (".", "DOT"),
    (":", "COLON"),
    ("?", "QUESTION"),
    ("=", "EQ"),
    ("==", "EQ2"),
    ("!=", "NEQ"),
    ("<", "LT"),
    ("<=", "LE"),
    (">", "GT"),
    (">=", "GE"),
    ("+", "PLUS"),
    ("-", "MINUS"),
    ("*", "STAR"),
    ("/", "SLASH"),
    ("%", "PERCENT"),
    ("!", "BANG"),
];

/// Literals that are other tokens in XML than in code.
const XML_PUNCTUATION: &[(&str, &str)] =
    &[("<", "L_ANGLE"), ("</", "L_ANGLE_SLASH"), (">", "R_ANGLE"), ("/>", "SLASH_R_ANGLE")];

/// The language a rule describes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Language {
    /// The code of a program.
    Code,
    /// The XML around it.
    Xml,
}

/// One token of the grammar.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Token {
    /// As the grammar spells it: `(`, `endIf`, `#ident`.
    pub(super) literal: String,
    /// The variant of `SyntaxKind`: `L_PAREN`, `END_IF_KW`, `IDENT`.
    pub(super) kind: String,
    /// The accessor: `l_paren_token`, `end_if_token`, `ident_token`.
    pub(super) accessor: String,
}

impl Token {
    /// The token of a literal: a keyword, `#` with the name of a kind of token, or punctuation.
    pub(super) fn of(literal: &str, language: Language) -> anyhow::Result<Self> {
        let (kind, accessor) = match literal.strip_prefix('#') {
            Some(name) => (names::screaming(name), names::snake(name)),
            None if is_word(literal) => (format!("{}_KW", names::screaming(literal)), names::snake(literal)),
            None => punctuation(literal, language)?,
        };
        Ok(Self { literal: literal.to_owned(), kind, accessor: format!("{accessor}_token") })
    }
}

fn is_word(literal: &str) -> bool {
    literal.chars().all(|letter| letter.is_ascii_alphabetic())
}

fn punctuation(literal: &str, language: Language) -> anyhow::Result<(String, String)> {
    let table = match language {
        Language::Code => PUNCTUATION,
        Language::Xml => XML_PUNCTUATION,
    };
    let (_, kind) = table
        .iter()
        .find(|(spelling, _)| *spelling == literal)
        .with_context(|| format!("codegen/tokens.rs has no kind for the token '{literal}'"))?;
    Ok(((*kind).to_owned(), kind.to_ascii_lowercase()))
}
