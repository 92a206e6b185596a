//! Known values of a `switch` selector.

use std::collections::BTreeMap;

use val3_analysis::body::{Body, Constant, Expr, ExprId, StmtKind, body};
use val3_analysis::items::program::header;
use val3_analysis::items::project::program_files;
use val3_lang::enumerations;
use val3_lang::operators::BinaryOp;
use val3_lang::results::result_codes;
use val3_lang::types::BaseType;
use val3_syntax::ast::{AstNode, CaseClause};

use super::super::context::Context;
use super::constants::{Constants, common_prefix};
use crate::variables::declares_variable;

/// Values in order, with their source texts. A named constant and a literal with the same number are one value.
#[derive(Default)]
struct CaseValues(BTreeMap<CaseKey, String>);

#[derive(PartialEq, Eq, PartialOrd, Ord)]
enum CaseKey {
    /// Bits of a number, mapped so that their order is the numeric order.
    Number(u64),
    /// Enumerator index, or the text for other values.
    Other(usize, String),
}

/// Texts of the known values without a case, unescaped.
pub(super) fn missing(
    context: &Context<'_>,
    constants: &Constants,
    selector: ExprId,
    cases: &[CaseClause],
) -> Vec<String> {
    let own = context.body();
    let labels: Vec<ExprId> = cases
        .iter()
        .flat_map(CaseClause::values)
        .filter_map(|value| context.expr_at(value.syntax().text_range()))
        .collect();
    let mut search = CaseSearch { constants, found: CaseValues::default() };
    match context.inference().ty(selector).base.builtin() {
        Some(BaseType::Bool) => ["false", "true"].into_iter().for_each(|value| search.found.add_other(0, value)),
        Some(ty) if ty.is_enumeration() => {
            (0..).zip(enumerations::values(ty)).for_each(|(at, value)| search.found.add_other(at, value.name));
        }
        Some(BaseType::Num | BaseType::String) => {
            search.result(own, selector);
            search.uses(context, selector);
            search.group(context, &labels);
        }
        _ => {}
    }
    let mut known = CaseSearch { constants, found: CaseValues::default() };
    labels.iter().for_each(|label| known.label(own, *label));
    search.found.0.into_iter().filter(|(key, _)| !known.found.contains(key)).map(|(_, text)| text).collect()
}

impl CaseValues {
    fn add_number(&mut self, number: f64, text: String) {
        let bits = number.to_bits();
        // Negative numbers sort first, in reverse bit order.
        let order = if number.is_sign_negative() { !bits } else { bits | 1 << 63 };
        self.0.entry(CaseKey::Number(if number == 0.0 { 1 << 63 } else { order })).or_insert(text);
    }

    fn add_other(&mut self, at: usize, text: &str) {
        self.0.insert(CaseKey::Other(at, text.to_owned()), text.to_owned());
    }

    fn contains(&self, key: &CaseKey) -> bool {
        match key {
            CaseKey::Other(_, text) => {
                self.0.keys().any(|other| matches!(other, CaseKey::Other(_, known) if known == text))
            }
            number => self.0.contains_key(number),
        }
    }
}

struct CaseSearch<'c> {
    constants: &'c Constants,
    found: CaseValues,
}

impl CaseSearch<'_> {
    /// Adds a constant, or the name of a constant.
    fn label(&mut self, body: &Body, id: ExprId) {
        match body.constant(id) {
            Some(Constant::Number(number)) => self.found.add_number(number, number.to_string()),
            Some(Constant::Bool(value)) => self.found.add_other(0, &value.to_string()),
            // A string with a quote or backslash would have to be escaped.
            Some(Constant::String(text)) if !text.contains(['"', '\\']) => {
                self.found.add_other(0, &format!("\"{text}\""));
            }
            _ => {
                let Expr::Name(name) = body.expr(body.without_parentheses(id)) else { return };
                match self.constants.number(name) {
                    Some(number) => self.found.add_number(number, name.to_string()),
                    None if enumerations::find(name).is_some() => self.found.add_other(0, name),
                    None => {}
                }
            }
        }
    }

    /// Adds an assigned value: a constant, or an instruction's result codes.
    fn value(&mut self, body: &Body, id: ExprId) {
        match body.expr(body.without_parentheses(id)) {
            Expr::Call(..) => self.result(body, id),
            Expr::Assign(_, value) => self.value(body, *value),
            _ => self.label(body, id),
        }
    }

    /// Adds an instruction's result codes.
    fn result(&mut self, body: &Body, id: ExprId) {
        let Expr::Call(callee, _) = body.expr(body.without_parentheses(id)) else { return };
        let (Expr::Name(name) | Expr::Path { item: name, .. }) = body.expr(*callee) else { return };
        let codes = result_codes(name).into_iter();
        codes.for_each(|code| self.found.add_number(code.into(), code.to_string()));
    }

    /// Adds the values that programs assign to the same variable or compare with it.
    fn uses(&mut self, context: &Context<'_>, selector: ExprId) {
        let Some(place) = place(context.body(), selector) else { return };
        let root = place.split('.').next().unwrap_or("");
        let declares = |file| declares_variable(header(context.db, file), root);
        let programs = program_files(context.db, context.project).iter().copied();
        let files = match declares(context.file) {
            true => vec![context.file],
            false => programs.filter(|file| !declares(*file)).collect(),
        };
        files.into_iter().for_each(|file| self.uses_in(body(context.db, file), &place));
    }

    fn uses_in(&mut self, body: &Body, wanted: &str) {
        let uses = |id: ExprId| place(body, id).is_some_and(|found| found == wanted);
        for stmt in body.stmts() {
            match &stmt.kind {
                StmtKind::Assign { target, value } if uses(*target) => self.value(body, *value),
                StmtKind::Switch { selector: Some(selector), cases } if uses(*selector) => {
                    cases.iter().flat_map(|(values, _)| values).for_each(|value| self.label(body, *value));
                }
                _ => {}
            }
        }
        for (_, expr, _) in body.exprs() {
            match expr {
                Expr::Assign(target, value) if uses(*target) => self.value(body, *value),
                Expr::Binary(BinaryOp::Equal | BinaryOp::NotEqual, left, right) => {
                    if uses(*left) {
                        self.label(body, *right);
                    }
                    if uses(*right) {
                        self.label(body, *left);
                    }
                }
                _ => {}
            }
        }
    }

    /// Adds the constants whose names have the common prefix of the cases. The type prefix of the naming convention
    /// does not count.
    fn group(&mut self, context: &Context<'_>, labels: &[ExprId]) {
        let names = labels.iter().filter_map(|label| match context.body().expr(*label) {
            Expr::Name(name) => self.constants.number(name).map(|_| name.as_str()),
            _ => None,
        });
        let names: Vec<&str> = names.collect();
        let options = context.options();
        let prefix = common_prefix(&names).filter(|prefix| options.prefixes.get("num").is_none_or(|num| num != prefix));
        let Some(prefix) = prefix else { return };
        let constants = self.constants;
        constants.group(prefix).for_each(|(name, number)| self.found.add_number(number, name.to_string()));
    }
}

/// A variable with its fields, without indexes.
fn place(body: &Body, id: ExprId) -> Option<String> {
    match body.expr(id) {
        Expr::Name(name) => Some(name.to_string()),
        Expr::Path { library, item } => Some(format!("{library}:{item}")),
        Expr::Index(base, _) | Expr::Paren(base) => place(body, *base),
        Expr::Field { base, field, .. } => Some(format!("{}.{field}", place(body, *base)?)),
        _ => None,
    }
}
