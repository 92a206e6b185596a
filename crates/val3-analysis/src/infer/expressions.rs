//! Inference of expressions: one function for each kind returns the value and reports mismatches.

use smol_str::SmolStr;
use val3_lang::operators::{self, BinaryOp, UnaryOp};
use val3_lang::types::BaseType;

use super::Infer;
use super::scope::Unresolved;
use super::value::InferredValue;
use crate::body::{Expr, ExprId};
use crate::problem::{ProblemKind, RelatedRole};
use crate::ty::{Base, STRING_LIMIT};

impl Infer<'_> {
    /// Infers an expression without an expected type.
    pub(super) fn expr(&mut self, id: ExprId) -> InferredValue {
        self.expr_as(id, None)
    }

    /// Infers an expression where a value of type `expected` is needed, which becomes the type of `{…}`.
    pub(super) fn expr_as(&mut self, id: ExprId, expected: Option<Base>) -> InferredValue {
        let body = self.body;
        let value = match body.expr(id) {
            Expr::Missing => InferredValue::UNKNOWN,
            Expr::Number(_) => InferredValue::of(BaseType::Num),
            Expr::Bool(_) => InferredValue::of(BaseType::Bool),
            Expr::String(text) => self.string(id, text),
            Expr::Name(name) => self.named(id, self.scope.value(name)),
            Expr::Path { library, item } => self.named(id, self.scope.library_value(library, item)),
            Expr::Paren(inner) => InferredValue::computed(self.element_as(*inner, expected)),
            Expr::Unary(op, operand) => self.unary(id, *op, *operand, expected),
            Expr::Binary(op, left, right) => self.binary(id, *op, [*left, *right], expected),
            Expr::Assign(target, value) => InferredValue::computed(self.assign(*target, *value)),
            Expr::Index(base, indexes) => self.index(*base, indexes),
            Expr::Field { base, field, range } => self.field(*base, field, *range),
            Expr::Call(callee, args) => self.call_value(id, *callee, args),
            Expr::Struct(values) => self.literal(id, values, expected),
        };
        self.table.set_type(id, value.ty());
        value
    }

    fn named(&mut self, id: ExprId, found: Result<InferredValue, Unresolved>) -> InferredValue {
        self.resolved(id, found).unwrap_or(InferredValue::UNKNOWN)
    }

    /// Infers an expression that is read as a single value. Returns its type.
    pub(super) fn element(&mut self, id: ExprId) -> Base {
        self.element_as(id, None)
    }

    /// Like [`Infer::element`], with the expected type.
    pub(super) fn element_as(&mut self, id: ExprId, expected: Option<Base>) -> Base {
        let value = self.expr_as(id, expected);
        if value.lacks_index() {
            self.index_missing(id, &value);
            return Base::Unknown;
        }
        value.base
    }

    pub(super) fn index_missing(&mut self, id: ExprId, value: &InferredValue) {
        let name = self.text(id);
        let declared = self.scope.declaration(value, &name);
        let ty = value.ty().display(self.scope.db());
        self.sink.report_with(id, ProblemKind::IndexMissing { name, ty }, RelatedRole::Declared, declared);
    }

    fn string(&mut self, id: ExprId, text: &str) -> InferredValue {
        if text.len() > STRING_LIMIT {
            self.report(id, ProblemKind::StringTooLong(text.len()));
        }
        InferredValue::of(BaseType::String)
    }

    fn unary(&mut self, id: ExprId, op: UnaryOp, operand: ExprId, expected: Option<Base>) -> InferredValue {
        let base = self.element_as(operand, expected);
        match base {
            Base::Unknown => InferredValue::UNKNOWN,
            Base::Builtin(ty, arm) if operators::unary(op, ty).is_some() => {
                let result = operators::unary(op, ty).map_or(Base::Unknown, |ty| Base::Builtin(ty, arm));
                InferredValue::computed(result)
            }
            _ => {
                let (op, right) = (SmolStr::new_static(op.symbol()), self.scope.show(base));
                self.report(id, ProblemKind::OperatorType { op, left: None, right });
                InferredValue::UNKNOWN
            }
        }
    }

    fn binary(
        &mut self,
        id: ExprId,
        op: BinaryOp,
        [left, right]: [ExprId; 2],
        expected: Option<Base>,
    ) -> InferredValue {
        let between_braces = || operators::structure(op).filter(|_| self.is_literal(left) && self.is_literal(right));
        let expected = expected.filter(|_| is_arithmetic(op)).or_else(|| between_braces().map(Base::of));
        let (left_base, right_base) = self.operands(left, right, expected);
        let result = match (left_base, right_base) {
            (Base::Unknown, _) | (_, Base::Unknown) => return unknown_result(op),
            (Base::Builtin(a, arm), Base::Builtin(b, _)) if a != b || left_base.same_as(right_base) => {
                operators::binary(op, a, b).map(|ty| Base::Builtin(ty, arm.filter(|_| ty.depends_on_arm())))
            }
            // Whether user types can be compared is not documented, so the comparison is accepted.
            (Base::User(a), Base::User(b)) if a == b && is_equality(op) => Some(Base::of(BaseType::Bool)),
            _ => None,
        };
        let wrong_arm =
            result.is_none() && left_base.builtin().is_some() && left_base.builtin() == right_base.builtin();
        if wrong_arm && !left_base.same_as(right_base) {
            let [expected, found] = self.scope.show_both([left_base, right_base]);
            self.report(right, ProblemKind::WrongArm { found, expected });
            return unknown_result(op);
        }
        if let Some(base) = result {
            return InferredValue::computed(base);
        }
        let [found_left, found_right] = self.scope.show_both([left_base, right_base]);
        let op_text = SmolStr::new_static(op.symbol());
        self.report(id, ProblemKind::OperatorType { op: op_text, left: Some(found_left), right: found_right });
        unknown_result(op)
    }

    /// Returns the operand types. A `{…}` on one side has the type of the other side; on both sides, the `expected`
    /// type.
    fn operands(&mut self, left: ExprId, right: ExprId, expected: Option<Base>) -> (Base, Base) {
        if self.is_literal(left) {
            let right = self.element_as(right, expected);
            return (self.element_as(left, Some(right)), right);
        }
        let left = self.element_as(left, expected);
        let expected = if self.is_literal(right) { Some(left) } else { expected };
        (left, self.element_as(right, expected))
    }

    /// Whether the expression is a `{…}`.
    pub(super) fn is_literal(&self, id: ExprId) -> bool {
        matches!(self.body.expr(self.body.without_parentheses(id)), Expr::Struct(_))
    }

    /// Checks `target = value` and returns its type as a value.
    pub(super) fn assign(&mut self, target: ExprId, value: ExprId) -> Base {
        let place = self.expr(target);
        if !place.is_variable() || place.lacks_index() {
            self.element_as(value, Some(Base::Unknown));
            self.not_assignable(target, &place);
            return Base::Unknown;
        }
        let base = self.element_as(value, Some(place.base));
        if !self.assignable(place.base, base) {
            let [target, found] = self.scope.show_both([place.base, base]);
            let kind = match (place.base, base) {
                (Base::Builtin(a, _), Base::Builtin(b, _)) if a == b && !place.base.same_as(base) => {
                    ProblemKind::WrongArm { found, expected: target }
                }
                _ => ProblemKind::AssignmentType { target, value: found },
            };
            self.report(value, kind);
            return Base::Unknown;
        }
        match (place.base, base) {
            (Base::Builtin(target, arm), Base::Builtin(value, _)) => {
                Base::Builtin(operators::assigned(target, value), arm)
            }
            (Base::Builtin(target, _), Base::Unknown) if target.is_linkable() => Base::Unknown,
            (target, _) => target,
        }
    }

    fn not_assignable(&mut self, target: ExprId, place: &InferredValue) {
        if place.is_variable() {
            self.index_missing(target, place);
        } else {
            self.report(target, ProblemKind::NotAssignable);
        }
    }

    /// Whether a value of type `value` may be assigned to a variable of type `target`.
    pub(super) fn assignable(&self, target: Base, value: Base) -> bool {
        match (target, value) {
            (Base::Unknown, _) | (_, Base::Unknown) => true,
            (Base::Builtin(BaseType::Dio, _), Base::Builtin(BaseType::Dio, _)) => self.scope.assigns_dio_to_dio(),
            (Base::Builtin(a, _), Base::Builtin(b, _)) if a != b => operators::assignment(a, b),
            (Base::Builtin(a, _), Base::Builtin(b, _)) if !operators::assignment(a, b) => false,
            _ => target.same_as(value),
        }
    }

    /// Returns a variable as written in the code, without indexes.
    pub(super) fn text(&self, id: ExprId) -> SmolStr {
        match self.body.expr(id) {
            Expr::Name(name) => name.clone(),
            Expr::Path { library, item } => smol_str::format_smolstr!("{library}:{item}"),
            Expr::Field { base, field, .. } => smol_str::format_smolstr!("{}.{field}", self.text(*base)),
            Expr::Index(base, _) | Expr::Paren(base) | Expr::Call(base, _) => self.text(*base),
            _ => SmolStr::default(),
        }
    }
}

fn is_equality(op: BinaryOp) -> bool {
    matches!(op, BinaryOp::Equal | BinaryOp::NotEqual)
}

/// Whether the result has the type of the operands.
fn is_arithmetic(op: BinaryOp) -> bool {
    use BinaryOp::{Add, Divide, Multiply, Remainder, Subtract};
    matches!(op, Add | Subtract | Multiply | Divide | Remainder)
}

/// Returns the result if an operand is unknown: comparisons and logic always return `bool`.
fn unknown_result(op: BinaryOp) -> InferredValue {
    if is_arithmetic(op) { InferredValue::UNKNOWN } else { InferredValue::of(BaseType::Bool) }
}
