//! An `if` whose parts have lines of their own, as text that can be laid out anew.

use val3_syntax::ast::{AstNode, Block, ElseClause, Expr, IfStmt, Stmt};
use val3_syntax::{SyntaxKind, TextRange, TextSize};

use super::context::Context;
use super::lines::{end_of_line, is_blank, whole_lines};

/// The lines of an `if` between its head and its end.
pub(super) struct IfLines {
    pub(super) condition: Expr,
    /// The lines after the condition, up to the line of `endIf`.
    pub(super) inner: TextRange,
    /// The line of `endIf` with its end.
    pub(super) last: TextRange,
}

impl IfLines {
    /// `None` unless each word of the statement has a line of its own.
    pub(super) fn of(context: &Context<'_>, stmt: &IfStmt) -> Option<Self> {
        let condition = stmt.condition()?;
        let start = end_of_line(context, condition.syntax().text_range().end())?;
        let last = whole_lines(context, stmt.end_if()?.text_range())?;
        (start <= last.start()).then(|| Self { condition, inner: TextRange::new(start, last.start()), last })
    }
}

/// The `if` has no further branches.
pub(super) fn is_simple(stmt: &IfStmt) -> bool {
    stmt.else_clause().is_none() && stmt.else_if_clauses().next().is_none()
}

/// The only statement of a block, if it is an `if`.
pub(super) fn only_if(block: Option<Block>) -> Option<IfStmt> {
    let stmts: Vec<Stmt> = block?.stmts().collect();
    let [stmt] = stmts.as_slice() else { return None };
    IfStmt::cast(stmt.syntax().clone())
}

/// The `if` that is all that `else` does, and the range of the keyword `else`.
pub(super) fn if_in_else(clause: &ElseClause) -> Option<(IfStmt, TextRange)> {
    let keyword = clause.syntax().first_token().filter(|token| token.kind() == SyntaxKind::ELSE_KW)?;
    Some((only_if(clause.block())?, keyword.text_range()))
}

/// The lines one level deeper; blank lines stay blank.
pub(super) fn deeper(lines: &str, level: &str) -> String {
    let deeper = |line: &str| if is_blank(line) { line.to_owned() } else { format!("{level}{line}") };
    lines.split_inclusive('\n').map(deeper).collect()
}

/// The lines without the blanks that [`deeper`] adds.
pub(super) fn shallower(lines: &str, level: &str) -> String {
    let shallower = |line: &str| if is_blank(line) { line.to_owned() } else { without(line, level).to_owned() };
    lines.split_inclusive('\n').map(shallower).collect()
}

fn without<'l>(line: &'l str, level: &str) -> &'l str {
    line.strip_prefix(level).unwrap_or(line)
}

/// The blanks by which the line of `inner` is deeper than that of `outer`.
pub(super) fn step<'db>(context: &Context<'db>, outer: TextSize, inner: TextSize) -> &'db str {
    let (outer, inner) = (context.indentation(outer), context.indentation(inner));
    inner.strip_prefix(outer).unwrap_or("")
}
