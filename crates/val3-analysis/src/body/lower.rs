//! Lowering from the tree to the body: statements here, expressions in a submodule.

mod expressions;

use rowan::{NodeOrToken, TextRange};
use smallvec::SmallVec;
use val3_syntax::SyntaxKind::{self, *};
use val3_syntax::view::{TokenView, View};

use self::expressions::is_expr;
use super::{Body, Expr, ExprId, Stmt, StmtKind};
use crate::items::program;

/// Lowers the code of the first program in a `.pgx`.
pub(super) fn lower(file: View<'_>) -> Body {
    let Some(code) = program::code(file) else { return Body::default() };
    let escaped = !code.children_with_tokens().any(|child| kind_of(&child) == CDATA_OPEN);
    // Exact capacity, because a growing list would be copied repeatedly.
    let exprs = Vec::with_capacity(code.count(is_expr));
    let mut lowering = Lowering { exprs, escaped };
    let block = lowering.block(code);
    Body { exprs: lowering.exprs, block }
}

fn kind_of(child: &NodeOrToken<View<'_>, TokenView<'_>>) -> SyntaxKind {
    match child {
        NodeOrToken::Node(node) => node.kind(),
        NodeOrToken::Token(token) => token.kind(),
    }
}

/// Collects a list of unknown length, so that the final list is allocated once with its exact length.
type ShortList<T> = SmallVec<[T; 8]>;

struct Lowering {
    exprs: Vec<(Expr, TextRange)>,
    /// Whether the code is escaped text, so that strings contain entity references.
    escaped: bool,
}

impl Lowering {
    /// Lowers the statements of the `BLOCK` below `parent`.
    fn block(&mut self, parent: View<'_>) -> Vec<Stmt> {
        let Some(block) = parent.child(BLOCK) else { return Vec::new() };
        let mut stmts = Vec::with_capacity(block.children().count());
        stmts.extend(block.children().filter_map(|child| self.stmt(child)));
        stmts
    }

    fn stmt(&mut self, view: View<'_>) -> Option<Stmt> {
        let kind = match view.kind() {
            IF_STMT => self.if_stmt(view),
            WHILE_STMT => StmtKind::While { condition: self.first_expr(view), block: self.block(view) },
            DO_STMT => StmtKind::Do { block: self.block(view), condition: self.first_expr(view) },
            FOR_STMT => self.for_stmt(view),
            SWITCH_STMT => self.switch_stmt(view),
            RETURN_STMT => StmtKind::Return,
            CALL_STMT => self.first_expr(view).map_or(StmtKind::Error, StmtKind::Call),
            TASK_CREATE_STMT => self.task_create(view),
            PRINT_STMT => self.first_expr(view).map_or(StmtKind::Error, StmtKind::Print),
            ASSIGN_STMT => self.assign_stmt(view),
            EXPR_STMT => self.first_expr(view).map_or(StmtKind::Error, StmtKind::Expr),
            ERROR => StmtKind::Error,
            _ => return None,
        };
        Some(Stmt { kind, range: view.range() })
    }

    fn if_stmt(&mut self, view: View<'_>) -> StmtKind {
        let mut arms = vec![(self.first_expr(view), self.block(view))];
        let mut otherwise = None;
        for clause in view.children() {
            match clause.kind() {
                ELSE_IF_CLAUSE => arms.push((self.first_expr(clause), self.block(clause))),
                ELSE_CLAUSE => otherwise = Some(self.block(clause)),
                _ => {}
            }
        }
        StmtKind::If { arms, otherwise }
    }

    /// Lowers `for`. Its parts are distinguished by the preceding tokens, because any part may be missing.
    fn for_stmt(&mut self, view: View<'_>) -> StmtKind {
        let [mut counter, mut start, mut stop, mut step] = [None; 4];
        let mut after = FOR_KW;
        for child in view.children_with_tokens() {
            match child {
                NodeOrToken::Token(token) if matches!(token.kind(), EQ | TO_KW | STEP_KW) => after = token.kind(),
                NodeOrToken::Token(_) => {}
                NodeOrToken::Node(node) => {
                    let Some(id) = self.expr(node) else { continue };
                    match after {
                        EQ => start = Some(id),
                        TO_KW => stop = Some(id),
                        STEP_KW => step = Some(id),
                        _ => counter = Some(id),
                    }
                }
            }
        }
        StmtKind::For { counter, start, stop, step, block: self.block(view) }
    }

    fn switch_stmt(&mut self, view: View<'_>) -> StmtKind {
        let selector = self.first_expr(view);
        let mut cases = Vec::new();
        for clause in view.children() {
            match clause.kind() {
                CASE_CLAUSE | DEFAULT_CLAUSE => {
                    let values = self.exprs_of(clause).into_vec();
                    cases.push((values, self.block(clause)));
                }
                _ => {
                    // A line after `break` belongs to no case.
                    let stray = self.stmt(clause);
                    cases.extend(stray.map(|stmt| (Vec::new(), vec![stmt])));
                }
            }
        }
        StmtKind::Switch { selector, cases }
    }

    fn task_create(&mut self, view: View<'_>) -> StmtKind {
        let synchronous = view.token(TASK_CREATE_SYNC_KW).is_some();
        StmtKind::TaskCreate { synchronous, arguments: self.exprs_of(view).into_vec() }
    }

    fn assign_stmt(&mut self, view: View<'_>) -> StmtKind {
        let mut parts = view.children();
        let target = parts.find_map(|part| self.expr(part));
        match (target, parts.find_map(|part| self.expr(part))) {
            (Some(target), Some(value)) => StmtKind::Assign { target, value },
            _ => StmtKind::Error,
        }
    }

    fn exprs_of(&mut self, view: View<'_>) -> ShortList<ExprId> {
        view.children().filter_map(|child| self.expr(child)).collect()
    }

    fn first_expr(&mut self, view: View<'_>) -> Option<ExprId> {
        view.children().find_map(|child| self.expr(child))
    }
}
