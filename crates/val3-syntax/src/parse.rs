//! From text to tree, whole or in part.

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
use crate::tree::Tree;
use crate::view::View;

/// Bytes of a text each phase of whose parsing takes a while.
const LONG: usize = 8 << 10;

/// The text of a file, its tree, and what is wrong with it. Cheap to clone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Parse {
    tree: Arc<Tree>,
    errors: Arc<[SyntaxError]>,
    odd_keywords: Arc<[TextRange]>,
}

/// Parses a `.pjx`, `.dtx` or `.pgx` file of either dialect. Takes time in proportion to the text, which must be
/// shorter than 4 GiB.
pub fn parse(text: &str) -> Parse {
    parse_shared(text.into())
}

/// As [`parse`], for a text that the tree may share.
pub fn parse_shared(text: Arc<str>) -> Parse {
    parse_within(text, 0)
}

/// Parses a text inside of `depth` elements.
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

/// Gives the core to a thread that waits for one. A server has threads that only pass on messages, and they would wait
/// until the scheduler interrupts the one that parses, which is a matter of milliseconds.
fn let_others_go_first(text: &str) {
    if text.len() >= LONG {
        thread::yield_now();
    }
}

impl Parse {
    /// The root of the tree, to walk down from.
    pub fn view(&self) -> View<'_> {
        View::new(self.tree.root())
    }

    /// The root of the tree, to walk from in every direction.
    pub fn root(&self) -> SyntaxNode {
        SyntaxNode::new_root(self.green().clone())
    }

    /// The tree without positions; cheap to clone, may be shared between threads.
    pub fn green(&self) -> &GreenNode {
        self.tree.green()
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
