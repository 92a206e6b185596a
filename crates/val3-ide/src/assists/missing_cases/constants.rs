//! Data that programs use as named constants.

use std::collections::{BTreeMap, BTreeSet};

use smol_str::SmolStr;
use val3_analysis::body::{Body, Expr, ExprId, StmtKind, body};
use val3_analysis::items::data::single_numbers;
use val3_analysis::items::project::{data_files, program_files};

use super::super::context::Context;

/// Data with a single number to which no program of the project assigns.
pub(super) struct Constants(BTreeMap<SmolStr, f64>);

impl Constants {
    pub(super) fn of(context: &Context<'_>) -> Self {
        let db = context.db;
        let files = data_files(db, context.project);
        let numbers = files.iter().flat_map(|file| single_numbers(db, *file));
        let programs = program_files(db, context.project).iter();
        let written: BTreeSet<SmolStr> = programs.flat_map(|file| written(body(db, *file))).collect();
        let constants = numbers.filter(|(name, ..)| !written.contains(name));
        Self(constants.map(|(name, number, _)| (name, number)).collect())
    }

    /// Number of a named constant.
    pub(super) fn number(&self, name: &str) -> Option<f64> {
        self.0.get(name).copied()
    }

    /// Constants whose names continue `prefix` with a new word.
    pub(super) fn group(&self, prefix: &str) -> impl Iterator<Item = (&SmolStr, f64)> {
        let own = self.0.iter().filter(move |(name, _)| starts_word(name, prefix));
        own.map(|(name, number)| (name, *number))
    }
}

/// Longest prefix after which each name begins a new word; `None` if there is no such prefix or fewer than two names.
pub(super) fn common_prefix<'n>(names: &[&'n str]) -> Option<&'n str> {
    let [first, _, ..] = names else { return None };
    let prefixes = (1..first.len()).rev().filter_map(|len| first.get(..len));
    let mut common = prefixes.filter(|prefix| names.iter().all(|name| starts_word(name, prefix)));
    common.next()
}

fn starts_word(name: &str, prefix: &str) -> bool {
    let rest = name.strip_prefix(prefix).and_then(|rest| rest.chars().next());
    rest.is_some_and(|letter| letter.is_uppercase() || prefix.ends_with('_') && letter != '_')
}

/// Names of assigned variables.
fn written(body: &Body) -> Vec<SmolStr> {
    let in_stmts = body.stmts().into_iter().filter_map(|stmt| match &stmt.kind {
        StmtKind::Assign { target, .. } => Some(*target),
        StmtKind::For { counter, .. } => *counter,
        _ => None,
    });
    let chained = body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Assign(target, _) => Some(*target),
        _ => None,
    });
    let targets: Vec<ExprId> = in_stmts.chain(chained).collect();
    targets.into_iter().filter_map(|target| variable_name(body, target)).cloned().collect()
}

/// Name of a variable or of an array whose element is assigned.
fn variable_name(body: &Body, target: ExprId) -> Option<&SmolStr> {
    let root = if let Expr::Index(base, _) = body.expr(target) { *base } else { target };
    match body.expr(root) {
        Expr::Name(name) => Some(name),
        _ => None,
    }
}
