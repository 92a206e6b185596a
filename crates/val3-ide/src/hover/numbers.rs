//! Hover for numbers: run-time errors, key codes, and return codes of library instructions.

use val3_analysis::body::{Body, Expr, ExprId, StmtKind, body};
use val3_analysis::db::{Db, Project};
use val3_analysis::infer::{Inference, infer};
use val3_lang::instruction::{Family, Instruction};
use val3_lang::instructions::{HELP, IS_KEY_PRESSED, READ_KEYS, TASK_STATUS};
use val3_lang::keys::KEYS;
use val3_lang::library_errors::LIBRARY_ERRORS;
use val3_lang::runtime_errors::{RUNTIME_ERRORS, TaskStatusCode};
use val3_lang::types::BaseType;

use super::text::Hover;
use crate::FilePosition;
use crate::markdown::fenced;

/// Meaning of the number at a position.
pub(super) fn hover(db: &dyn Db, project: Project, at: FilePosition) -> Option<Hover> {
    let (body, inference) = (body(db, at.file), infer(db, project, at.file));
    let holds = |id: ExprId| body.range(id).contains_inclusive(at.offset);
    let (id, ..) = body.exprs().find(|(id, expr, _)| matches!(expr, Expr::Number(_)) && holds(*id))?;
    let id = signed(body, id);
    let number = body.number(id)?;
    let markdown = meaning(Numbers { body, inference }.origin(id)?, number)?;
    Some(Hover { range: body.range(id), markdown })
}

/// The number including its sign.
fn signed(body: &Body, id: ExprId) -> ExprId {
    let sign = body.exprs().find(|(_, expr, _)| matches!(expr, Expr::Unary(_, inner) if *inner == id));
    sign.map_or(id, |(sign, ..)| sign)
}

fn meaning(origin: &'static Instruction, number: f64) -> Option<String> {
    let is = |known: u16| f64::from(known) == number;
    if origin.name == TASK_STATUS || origin.name == HELP {
        return RUNTIME_ERRORS
            .iter()
            .find(|row| is(row.number))
            .map(|row| fenced(&format!("{} {}", row.number, row.short)) + "\nrun-time error. " + row.long)
            .or_else(|| task_state(number));
    }
    if READ_KEYS.contains(&origin.name) || origin.name == IS_KEY_PRESSED {
        let key = KEYS.iter().find(|key| is(key.code))?;
        return Some(fenced(&format!("{} {}", key.code, key.name)) + "\nkey of the pendant");
    }
    let gives_code =
        origin.family == Family::Libraries && origin.overloads.iter().any(|form| form.result == Some(BaseType::Num));
    let row = LIBRARY_ERRORS.iter().find(|row| gives_code && is(row.number))?;
    Some(fenced(&format!("{} {}", row.number, row.short)) + "\n" + row.long)
}

fn task_state(number: f64) -> Option<String> {
    let states = [
        (TaskStatusCode::Absent, "there is no task of this name"),
        (TaskStatusCode::Halted, "the task is halted"),
        (TaskStatusCode::Running, "the task runs or waits"),
    ];
    let (state, about) = states.into_iter().find(|(state, _)| f64::from(state.number()) == number)?;
    Some(fenced(&format!("{} {about}", state.number())) + "\nstate of a task")
}

struct Numbers<'db> {
    body: &'db Body,
    inference: &'db Inference,
}

impl Numbers<'_> {
    /// Instruction with whose result the number is compared, or whose argument it is.
    fn origin(&self, number: ExprId) -> Option<&'static Instruction> {
        let equals = |id: &ExprId| self.body.without_parentheses(*id) == number;
        self.body
            .exprs()
            .find_map(|(id, expr, _)| match expr {
                Expr::Binary(_, left, right) if equals(left) => self.source(*right),
                Expr::Binary(_, left, right) if equals(right) => self.source(*left),
                Expr::Call(_, arguments) if arguments.iter().any(equals) => self.called(id),
                _ => None,
            })
            .or_else(|| self.selector(number).and_then(|selector| self.source(selector)))
    }

    fn called(&self, id: ExprId) -> Option<&'static Instruction> {
        self.inference.call(id).map(|call| call.instruction)
    }

    /// Selector of the `switch` that has the number as a case.
    fn selector(&self, number: ExprId) -> Option<ExprId> {
        self.body.stmts().into_iter().find_map(|stmt| match &stmt.kind {
            StmtKind::Switch { selector, cases } => {
                let has = cases
                    .iter()
                    .any(|(values, _)| values.iter().any(|value| self.body.without_parentheses(*value) == number));
                selector.filter(|_| has)
            }
            _ => None,
        })
    }

    /// Instruction that yields a value, directly or through a variable that is assigned somewhere in the program.
    fn source(&self, id: ExprId) -> Option<&'static Instruction> {
        let id = self.body.without_parentheses(id);
        match self.body.expr(id) {
            Expr::Call(..) => self.called(id),
            Expr::Name(name) => self.body.stmts().into_iter().find_map(|stmt| match &stmt.kind {
                StmtKind::Assign { target, value } if matches!(self.body.expr(*target), Expr::Name(other) if other == name) => {
                    self.called(self.body.without_parentheses(*value))
                }
                _ => None,
            }),
            _ => None,
        }
    }
}
