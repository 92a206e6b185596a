//! Ranges of the keywords that close blocks: `endWhile`, `endFor`, `break`, and the `end` of the program.

use rustc_hash::FxHashMap;
use val3_analysis::db::{Db, File};
use val3_analysis::items::parse;
use val3_analysis::items::program;
use val3_syntax::SyntaxKind::{self, BREAK_KW, CASE_CLAUSE, DEFAULT_CLAUSE, END_FOR_KW, END_KW, END_WHILE_KW};
use val3_syntax::TextRange;
use val3_syntax::view::View;

use crate::code_form::CodeForm;

/// Closing keywords of a program.
#[derive(Debug, Default)]
pub(crate) struct Closings {
    /// `endWhile` or `endFor`, by the range of the loop.
    loops: FxHashMap<TextRange, TextRange>,
    /// The `break` of each clause, by the range of the `switch`.
    breaks: FxHashMap<TextRange, Vec<Option<TextRange>>>,
    /// `end`.
    pub(crate) end: Option<TextRange>,
}

impl Closings {
    /// Collects the keywords of the program in a file. Keywords of loops are collected only for a debugger, because
    /// they cost an operation in each iteration.
    pub(crate) fn of(db: &dyn Db, file: File, form: CodeForm) -> Self {
        let parse = parse(db, file);
        let Some(code) = program::code(parse.view()) else { return Self::default() };
        let mut closings = Self { end: range_of(code, END_KW), ..Self::default() };
        closings.collect(code, form);
        closings
    }

    /// Collects the keywords inside of a node.
    fn collect(&mut self, node: View<'_>, form: CodeForm) {
        if form == CodeForm::Debugged {
            let closing = range_of(node, END_WHILE_KW).or_else(|| range_of(node, END_FOR_KW));
            self.loops.extend(closing.map(|closing| (node.range(), closing)));
        }
        let clauses = node.children().filter(|child| matches!(child.kind(), CASE_CLAUSE | DEFAULT_CLAUSE));
        let breaks: Vec<_> = clauses.map(|clause| range_of(clause, BREAK_KW)).collect();
        if !breaks.is_empty() {
            self.breaks.insert(node.range(), breaks);
        }
        node.children().for_each(|child| self.collect(child, form));
    }

    /// Returns the keyword that closes the loop with this range.
    pub(crate) fn of_loop(&self, range: TextRange) -> Option<TextRange> {
        self.loops.get(&range).copied()
    }

    /// Returns the `break` of clause `number` in the `switch` with this range.
    pub(crate) fn of_case(&self, range: TextRange, number: usize) -> Option<TextRange> {
        *self.breaks.get(&range)?.get(number)?
    }
}

fn range_of(node: View<'_>, keyword: SyntaxKind) -> Option<TextRange> {
    node.token(keyword).map(|token| token.range())
}
