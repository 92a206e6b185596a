//! From text to tree, whole or in part.

#[cfg(test)]
mod linear;
mod lines;
mod merge;
mod reparse;

use std::sync::Arc;

use rowan::{GreenNode, TextRange};

use crate::error::SyntaxError;
use crate::grammar;
use crate::kind::SyntaxNode;
use crate::lexer::lex;
use crate::parser::{Input, Parser, build_tree};

pub use reparse::Edit;

/// The tree of a file and what is wrong with its text. Cheap to clone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parse {
    green: GreenNode,
    errors: Arc<[SyntaxError]>,
    odd_keywords: Arc<[TextRange]>,
}

/// Parses a `.pjx`, `.dtx` or `.pgx` file of either dialect. Takes time in proportion to the text, which must be
/// shorter than 4 GiB.
pub fn parse(text: &str) -> Parse {
    parse_within(text, 0)
}

/// Parses a text that stands inside of `depth` elements.
fn parse_within(text: &str, depth: u32) -> Parse {
    let lexed = lex(text);
    let input = Input::new(text, &lexed);
    let mut parser = Parser::new(&input, depth);
    grammar::file(&mut parser);
    let (events, errors) = parser.finish();
    let green = build_tree(text, &lexed.tokens, events);
    let errors = merge::merge(text, lexed.errors, errors).into();
    Parse { green, errors, odd_keywords: lexed.odd_keywords.into() }
}

impl Parse {
    /// The root of the tree.
    pub fn root(&self) -> SyntaxNode {
        SyntaxNode::new_root(self.green.clone())
    }

    /// The tree without positions; cheap to clone, may be shared between threads.
    pub fn green(&self) -> &GreenNode {
        &self.green
    }

    /// The faults of the text, by position.
    pub fn errors(&self) -> &[SyntaxError] {
        &self.errors
    }

    /// Keywords that are not written in their usual letter case, by position.
    pub fn odd_keywords(&self) -> &[TextRange] {
        &self.odd_keywords
    }
}
