//! Pages of the statements and other parts of the language that are no instructions (2.2.5, 3.1.2, 5.10).

mod pages;

pub use pages::STATEMENTS;

/// A statement or another part of the language with a page.
#[derive(Debug)]
pub struct Statement {
    /// Name of the page: `if`, `?`, `//`.
    pub name: &'static str,
    /// Keywords of the statement.
    pub keywords: &'static [&'static str],
    /// Section of the manual; empty if the manual does not describe it.
    pub section: &'static str,
    /// Page in Markdown, with one leading blank per line. [`crate::page`] splits it into parts.
    pub page: &'static str,
}

/// Prints a value (undocumented).
pub const PRINT: &str = "?";

/// Finds the statement of a word, in upper or lower case: `endIf` belongs to `if`.
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
