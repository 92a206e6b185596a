//! Conditions in a task's current line, with their values: the reason why the task waits or its loop continues.

use std::ops::RangeInclusive;

use val3_analysis::body::{Body, Expr, ExprId, Stmt, StmtKind, body};
use val3_analysis::db::File;
use val3_debug::{DisplayFormat, frames};
use val3_lang::ports::TaskNumber;
use val3_lines::LineIndex;
use val3_machine::controller::Controller;
use val3_syntax::{TextRange, TextSlice, decode_entities};
use val3_vm::FragmentContext;

use super::target::EvaluationContext;
use super::{FrameEvaluator, Purpose};

/// Limit of values that are read for a condition.
const VALUES: usize = 8;

/// A condition for the continuation of a task.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LineCondition {
    /// Line in the file, from 1.
    pub line: u32,
    /// Code of the line.
    pub text: String,
    /// Non-constant expressions in the condition, each with its value.
    pub values: Vec<(String, String)>,
}

/// A condition in the code.
struct WrittenCondition {
    /// Line of the file, from 1.
    line: u32,
    code: String,
    candidates: Vec<DisplayCandidate>,
}

/// An expression whose value may be displayed.
struct DisplayCandidate {
    text: String,
    /// Arguments of a call, whose values are displayed if the call itself cannot be evaluated.
    arguments: Vec<DisplayCandidate>,
}

impl FrameEvaluator {
    /// Conditions in a task's current line and of the loop that contains it. Conditions without values are omitted.
    pub fn conditions(&mut self, controller: &mut Controller, task: TaskNumber) -> Vec<LineCondition> {
        let context = FragmentContext::Frame(task, 0);
        let Some(row) = frames(&controller.vm, task).first().map(|frame| frame.row) else { return Vec::new() };
        let Ok(target) = self.targets.of_context(&controller.vm, context) else { return Vec::new() };
        let Some(file) = target.program else { return Vec::new() };
        let written = self.written(&target, file, row);
        let valued = written.into_iter().map(|WrittenCondition { line, code, candidates }| {
            let mut values = Vec::new();
            candidates.iter().for_each(|candidate| self.read(controller, context, candidate, &mut values));
            LineCondition { line, text: code, values }
        });
        valued.filter(|condition| !condition.values.is_empty()).collect()
    }

    /// Adds the expression's value, or its arguments' values.
    fn read(
        &mut self,
        controller: &mut Controller,
        context: FragmentContext,
        candidate: &DisplayCandidate,
        values: &mut Vec<(String, String)>,
    ) {
        let DisplayCandidate { text, arguments } = candidate;
        if values.len() >= VALUES || values.iter().any(|(known, _)| known == text) {
            return;
        }
        match self
            .evaluate(controller, context, text, Purpose::Watch, DisplayFormat::default())
            .map(|found| found.value)
        {
            // The name of a constant is its value.
            Ok(Some(value)) if value.shown == *text => {}
            Ok(Some(value)) => values.push((text.clone(), value.shown)),
            // It has a side effect, waits, or causes a run-time error.
            Ok(None) | Err(_) => {
                arguments.iter().for_each(|argument| self.read(controller, context, argument, values));
            }
        }
    }

    /// Conditions in the code at a row.
    fn written(&self, target: &EvaluationContext, file: File, row: u32) -> Vec<WrittenCondition> {
        let db = self.targets.application(target.application).db();
        let (text, body) = (file.text(db), body(db, file));
        let index = LineIndex::new(text);
        let stmts = body.stmts().into_iter().filter(|stmt| rows(&index, stmt.range).contains(&row));
        let stmts: Vec<&Stmt> = stmts.collect();
        let here = stmts.last().map(|stmt| parts(stmt)).unwrap_or_default();
        let here = here.into_iter().find(|id| rows(&index, body.range(*id)).contains(&row));
        let around = stmts.iter().rev().find_map(|stmt| loop_condition(stmt)).filter(|id| Some(*id) != here);
        let conditions = here.into_iter().chain(around).map(|id| {
            let line = *rows(&index, body.range(id)).start();
            WrittenCondition::new(body, text, id, line)
        });
        conditions.collect()
    }
}

/// Expressions of a statement, without its blocks.
fn parts(stmt: &Stmt) -> Vec<ExprId> {
    match &stmt.kind {
        StmtKind::If { arms, .. } => arms.iter().filter_map(|(condition, _)| *condition).collect(),
        StmtKind::Switch { selector, .. } => selector.iter().copied().collect(),
        StmtKind::Print(id) | StmtKind::Expr(id) | StmtKind::Call(id) | StmtKind::Assign { value: id, .. } => vec![*id],
        _ => loop_condition(stmt).into_iter().collect(),
    }
}

/// Lines of a range in the text, from 1.
fn rows(index: &LineIndex, range: TextRange) -> RangeInclusive<u32> {
    let [first, last] = [range.start(), range.end()].map(|offset| index.line(offset.into()) + 1);
    u32::try_from(first).unwrap_or(u32::MAX)..=u32::try_from(last).unwrap_or(u32::MAX)
}

impl WrittenCondition {
    fn new(body: &Body, text: &str, condition: ExprId, line: u32) -> Self {
        let code = text.lines().nth(line.saturating_sub(1) as usize).unwrap_or_default();
        let mut candidates = Vec::new();
        collect(body, text, condition, &mut candidates);
        Self { line, code: decode_entities(code.trim()).into_owned(), candidates }
    }
}

fn loop_condition(stmt: &Stmt) -> Option<ExprId> {
    match stmt.kind {
        StmtKind::While { condition, .. } | StmtKind::Do { condition, .. } => condition,
        _ => None,
    }
}

/// Collects the non-constant operands in an expression.
fn collect(body: &Body, text: &str, id: ExprId, found: &mut Vec<DisplayCandidate>) {
    match body.expr(id) {
        Expr::Paren(inner) | Expr::Unary(_, inner) => collect(body, text, *inner, found),
        Expr::Binary(_, left, right) | Expr::Assign(left, right) => {
            collect(body, text, *left, found);
            collect(body, text, *right, found);
        }
        Expr::Struct(parts) => parts.iter().flatten().for_each(|part| collect(body, text, *part, found)),
        Expr::Call(_, arguments) => found.push(DisplayCandidate::new(body, text, id, arguments)),
        Expr::Name(_) | Expr::Path { .. } | Expr::Index(..) | Expr::Field { .. } => {
            found.push(DisplayCandidate::new(body, text, id, &[]));
        }
        Expr::Missing | Expr::Number(_) | Expr::String(_) | Expr::Bool(_) => {}
    }
}

impl DisplayCandidate {
    /// Candidate for an expression, and the candidates in its arguments.
    fn new(body: &Body, text: &str, id: ExprId, arguments: &[ExprId]) -> Self {
        let mut inner = Vec::new();
        arguments.iter().for_each(|argument| collect(body, text, *argument, &mut inner));
        let range = body.range(id);
        let code = text.part(usize::from(range.start())..usize::from(range.end()));
        Self { text: decode_entities(code.trim()).into_owned(), arguments: inner }
    }
}
