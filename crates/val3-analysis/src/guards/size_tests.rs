//! Guards that test the size of an array, on which the existence of an element depends.

use std::collections::BTreeSet;

use smol_str::SmolStr;
use val3_lang::instruction::ArgumentForm;
use val3_lang::instructions::{self, SIZE};

use super::{Guard, Guards, KnownValues};
use crate::body::{Body, Constant, Expr, ExprId, StmtKind};

/// An array whose size never changes.
#[derive(Debug, Clone, Copy)]
pub struct FixedArray<'a> {
    /// The array without an index.
    pub array: ExprId,
    /// Number of elements in each dimension.
    pub sizes: &'a [u32],
}

impl Guards {
    /// Whether the expression at `id`, which fails because the array is too small, is possibly never evaluated: a guard
    /// is not met by an array of this size, or tests the array in a way that is not computed here.
    pub fn protect(&self, body: &Body, id: ExprId, fixed: FixedArray<'_>) -> bool {
        let array = body.normal_form(fixed.array);
        let known = |id: ExprId| size(body, id, &array, fixed.sizes);
        let known: KnownValues<'_> = &known;
        let guards: Vec<&Guard> = self.of(id).collect();
        if guards.is_empty() {
            return false;
        }
        let mut tests = SizeTests::new(body, &array);
        guards.iter().for_each(|guard| tests.add_counter(guard));
        guards.into_iter().any(|guard| match guard.is_met(body, known) {
            Some(is_met) => !is_met,
            None => guard.exprs().into_iter().any(|id| tests.contain(id)),
        })
    }
}

/// Returns the value of `size(array)` for an array with this normal form and one dimension.
fn size(body: &Body, id: ExprId, array: &str, sizes: &[u32]) -> Option<Constant> {
    let (Expr::Call(callee, arguments), [size]) = (body.expr(id), sizes) else { return None };
    let is_size = matches!(body.expr(*callee), Expr::Name(name) if name == SIZE);
    let [measured] = **arguments else { return None };
    (is_size && body.normal_form(measured) == array).then(|| Constant::Number(f64::from(*size)))
}

/// Expressions whose value depends on the size of an array.
struct SizeTests<'b> {
    body: &'b Body,
    array: &'b str,
    /// Variables that the program computes from the size.
    variables: BTreeSet<SmolStr>,
}

impl<'b> SizeTests<'b> {
    fn new(body: &'b Body, array: &'b str) -> Self {
        let mut tests = Self { body, array, variables: BTreeSet::new() };
        let assignments = assignments(body);
        // A variable may be computed from a variable that a later line sets.
        loop {
            let computed = assignments.iter().filter(|(_, value)| tests.contain(*value));
            let variables: BTreeSet<SmolStr> = computed.filter_map(|(target, _)| variable(body, *target)).collect();
            if variables.len() == tests.variables.len() {
                return tests;
            }
            tests.variables = variables;
        }
    }

    /// Adds the counter of a loop around the line, if the size limits it.
    fn add_counter(&mut self, guard: &Guard) {
        if let Guard::Loop { counter: Some(counter), bounds } = guard
            && bounds.iter().flatten().any(|bound| self.contain(*bound))
        {
            self.variables.extend(variable(self.body, *counter));
        }
    }

    /// Whether a part of the expression depends on the size.
    fn contain(&self, id: ExprId) -> bool {
        self.body.within(id).any(|part| match self.body.expr(part) {
            Expr::Name(name) => self.variables.contains(name),
            Expr::Call(callee, arguments) => self.is_test(*callee, arguments),
            _ => false,
        })
    }

    /// Whether a call receives the array, as `size` does, or an element that may not exist, as `isDefined` does.
    fn is_test(&self, callee: ExprId, arguments: &[ExprId]) -> bool {
        let Expr::Name(name) = self.body.expr(callee) else { return false };
        arguments
            .iter()
            .enumerate()
            .any(|(position, argument)| self.is_of_array(*argument) && !takes_value(name, position))
    }

    fn is_of_array(&self, argument: ExprId) -> bool {
        let argument = self.body.without_parentheses(argument);
        let array = match self.body.expr(argument) {
            Expr::Index(array, _) => *array,
            _ => argument,
        };
        self.body.normal_form(array) == self.array
    }
}

/// Whether all forms of an instruction take a single value at this position.
fn takes_value(instruction: &str, position: usize) -> bool {
    let forms = instructions::find(instruction).into_iter().flat_map(|instruction| instruction.overloads);
    forms.filter_map(|form| form.params.get(position)).all(|param| param.shape == ArgumentForm::Value)
}

/// Returns the targets and values of all assignments.
fn assignments(body: &Body) -> Vec<(ExprId, ExprId)> {
    let assignments = body.stmts().into_iter().filter_map(|stmt| match stmt.kind {
        StmtKind::Assign { target, value } => Some((target, value)),
        _ => None,
    });
    assignments.collect()
}

/// Returns the variable that an assignment changes, entirely or partly.
fn variable(body: &Body, target: ExprId) -> Option<SmolStr> {
    match body.expr(target) {
        Expr::Name(name) => Some(name.clone()),
        Expr::Index(base, _) | Expr::Field { base, .. } | Expr::Paren(base) => variable(body, *base),
        _ => None,
    }
}
