//! Parsing of entire texts, and results of parsing.

#[cfg(test)]
mod linear;
mod lines;
mod merge;
mod reparse;
mod statement_run;

use std::sync::Arc;
use std::thread;

use rowan::{GreenNode, TextRange};

use crate::error::SyntaxError;
use crate::grammar;
use crate::kind::SyntaxNode;
use crate::lexer::lex;
use crate::parser::{Input, Parser, build_tree};
use crate::tree::SourceTree;
use crate::view::View;

/// Length in bytes from which every phase of parsing needs noticeable time.
const LONG: usize = 8 << 10;

/// Text of a file with its tree and errors. Cheap to clone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parse {
    tree: Arc<SourceTree>,
    errors: Arc<[SyntaxError]>,
    odd_keywords: Arc<[TextRange]>,
}

/// Parses a `.pjx`, `.dtx` or `.pgx` file of either dialect. Takes linear time. The text must be shorter than 4 GiB.
pub fn parse(text: &str) -> Parse {
    parse_shared(text.into())
}

/// Like [`parse`], for a text that the tree may share.
pub fn parse_shared(text: Arc<str>) -> Parse {
    parse_within(text, 0)
}

/// Parses a text inside `depth` elements.
fn parse_within(text: Arc<str>, depth: u32) -> Parse {
    let lexed = lex(&text);
    let_others_go_first(&text);
    let input = Input::new(&text, &lexed);
    let mut parser = Parser::new(&input, depth);
    grammar::file(&mut parser);
    let (events, errors) = parser.finish();
    let_others_go_first(&text);
    let errors = merge::merge(&text, lexed.errors, errors).into();
    let tree = Arc::new(build_tree(Arc::clone(&text), &lexed.tokens, events));
    let_others_go_first(&text);
    Parse { tree, errors, odd_keywords: lexed.odd_keywords.into() }
}

/// Yields the core to a waiting thread. Server threads that only forward messages would otherwise wait several
/// milliseconds until the scheduler interrupts the parser.
fn let_others_go_first(text: &str) {
    if text.len() >= LONG {
        thread::yield_now();
    }
}

impl Parse {
    /// Returns the root of the tree as a view, which can be walked downwards.
    pub fn view(&self) -> View<'_> {
        View::new(self.tree.root())
    }

    /// Returns the root of the tree as a node, which can be walked in every direction.
    pub fn root(&self) -> SyntaxNode {
        SyntaxNode::new_root(self.green().clone())
    }

    /// Returns the tree without positions, which is cheap to clone and can be shared between threads.
    pub fn green(&self) -> &GreenNode {
        self.tree.green()
    }

    /// Returns the syntax errors, sorted by position.
    pub fn errors(&self) -> &[SyntaxError] {
        &self.errors
    }

    /// Returns keywords in unusual letter case, sorted by position.
    pub fn odd_keywords(&self) -> &[TextRange] {
        &self.odd_keywords
    }
}
