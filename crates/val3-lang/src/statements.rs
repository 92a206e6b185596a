//! Pages of the statements: everything in the language apart from instructions (2.2.5, 3.1.2, 5.10).

mod pages;

pub use pages::STATEMENTS;

/// A statement or another part of the language that has a page.
#[derive(Debug)]
pub struct Statement {
    /// The word by which a reader asks for it: `if`, `?`, `//`.
    pub name: &'static str,
    /// Every keyword that belongs to it.
    pub keywords: &'static [&'static str],
    /// Section of the manual; empty for what it does not describe.
    pub section: &'static str,
    /// The page in Markdown, one leading blank a line. [`crate::page`] cuts it into its parts.
    pub page: &'static str,
}

/// Prints a value (undocumented).
pub const PRINT: &str = "?";

/// The statement that this word belongs to, in any letter case: `endIf` gives `if`.
#[must_use]
pub fn find(word: &str) -> Option<&'static Statement> {
    STATEMENTS.iter().find(|statement| {
        statement.name.eq_ignore_ascii_case(word)
            || statement.keywords.iter().any(|keyword| keyword.eq_ignore_ascii_case(word))
    })
}

#[cfg(test)]
mod tests {
    use super::{STATEMENTS, find};
    use crate::{keywords, page};

    #[test]
    fn every_keyword_has_a_page() {
        for keyword in keywords::KEYWORDS {
            let known = find(keyword).is_some() || crate::instructions::find(keyword).is_some();
            assert!(known, "{keyword}");
        }
    }

    #[test]
    fn every_page_has_a_sentence_and_an_example() {
        for statement in STATEMENTS {
            assert!(page::summary(statement.page).ends_with('.'), "{}", statement.name);
            assert!(!page::examples(statement.page).is_empty(), "{}", statement.name);
        }
    }
}
