//! An `if` whose keywords are on their own lines, so that its lines can be indented again.

use val3_syntax::ast::{AstNode, Block, ElseClause, Expr, IfStmt, Stmt};
use val3_syntax::{SyntaxKind, TextRange, TextSize};

use super::context::Context;
use super::lines::{end_of_line, is_blank, whole_lines};

/// Parts of an `if` statement, as complete lines.
pub(super) struct IfLines {
    pub(super) condition: Expr,
    /// Lines after the condition, up to the line of `endIf`.
    pub(super) inner: TextRange,
    /// The line of `endIf`, including the line end.
    pub(super) last: TextRange,
}

impl IfLines {
    /// Finds the lines. `None` unless each keyword is on its own line.
    pub(super) fn of(context: &Context<'_>, stmt: &IfStmt) -> Option<Self> {
        let condition = stmt.condition()?;
        let start = end_of_line(context, condition.syntax().text_range().end())?;
        let last = whole_lines(context, stmt.end_if()?.text_range())?;
        (start <= last.start()).then(|| Self { condition, inner: TextRange::new(start, last.start()), last })
    }
}

/// Whether the `if` has no other branches.
pub(super) fn is_simple(stmt: &IfStmt) -> bool {
    stmt.else_clause().is_none() && stmt.else_if_clauses().next().is_none()
}

/// The only statement of a block, if it is an `if`.
pub(super) fn only_if(block: Option<Block>) -> Option<IfStmt> {
    let stmts: Vec<Stmt> = block?.stmts().collect();
    let [stmt] = stmts.as_slice() else { return None };
    IfStmt::cast(stmt.syntax().clone())
}

/// The `if` that is the only statement of the `else`, and the range of the keyword `else`.
pub(super) fn if_in_else(clause: &ElseClause) -> Option<(IfStmt, TextRange)> {
    let keyword = clause.syntax().first_token().filter(|token| token.kind() == SyntaxKind::ELSE_KW)?;
    Some((only_if(clause.block())?, keyword.text_range()))
}

/// Indents the lines by one level; blank lines are unchanged.
pub(super) fn deeper(lines: &str, level: &str) -> String {
    let deeper = |line: &str| if is_blank(line) { line.to_owned() } else { format!("{level}{line}") };
    lines.split_inclusive('\n').map(deeper).collect()
}

/// Removes the indentation that [`deeper`] adds.
pub(super) fn shallower(lines: &str, level: &str) -> String {
    let shallower = |line: &str| if is_blank(line) { line.to_owned() } else { without(line, level).to_owned() };
    lines.split_inclusive('\n').map(shallower).collect()
}

fn without<'l>(line: &'l str, level: &str) -> &'l str {
    line.strip_prefix(level).unwrap_or(line)
}

/// Indentation of the line at `inner` relative to the line at `outer`.
pub(super) fn step<'db>(context: &Context<'db>, outer: TextSize, inner: TextSize) -> &'db str {
    let (outer, inner) = (context.indentation(outer), context.indentation(inner));
    inner.strip_prefix(outer).unwrap_or("")
}
