//! Inference of indexes and fields.

use rowan::TextRange;
use smol_str::SmolStr;
use val3_lang::types::{BaseType, Container};

use super::Infer;
use super::value::{DeclaredVariable, Form, InferredValue, VariableOrigin};
use crate::body::ExprId;
use crate::guards::{FixedArray, guards};
use crate::problem::{ProblemKind, RelatedRole};
use crate::ty::Base;

/// A dimension of an array variable.
struct ArrayDimension<'v> {
    array: ExprId,
    variable: &'v DeclaredVariable,
    /// Name of the variable as written.
    name: &'v SmolStr,
    /// Position of the dimension, from 0.
    position: usize,
}

impl Infer<'_> {
    /// `base[indexes]`
    pub(super) fn index(&mut self, base: ExprId, indexes: &[ExprId]) -> InferredValue {
        let value = self.expr(base);
        let found: Vec<Base> = indexes.iter().map(|index| self.element(*index)).collect();
        if value.is_unknown() {
            return InferredValue::UNKNOWN;
        }
        let Form::Whole(variable) = &value.form else {
            return self.index_not_allowed(base, &value);
        };
        match variable.container {
            Container::Element => return self.index_not_allowed(base, &value),
            Container::Array { dims } if indexes.len() != usize::from(dims) => {
                return self.index_count(base, &value, usize::from(dims), indexes.len());
            }
            Container::Array { .. } => self.array_index(base, variable, indexes, &found),
            Container::Collection => self.key(base, &value, indexes, &found),
        }
        InferredValue { base: value.base, form: Form::Indexed { of: variable.container } }
    }

    fn index_not_allowed(&mut self, base: ExprId, value: &InferredValue) -> InferredValue {
        let (name, ty) = (self.text(base), value.ty().display(self.scope.db()));
        let declared = self.scope.declaration(value, &name);
        self.sink.report_with(
            base,
            ProblemKind::IndexNotAllowed { name, ty, callee: None },
            RelatedRole::Declared,
            declared,
        );
        InferredValue::UNKNOWN
    }

    fn index_count(&mut self, base: ExprId, value: &InferredValue, expected: usize, found: usize) -> InferredValue {
        let name = self.text(base);
        let declared = self.scope.declaration(value, &name);
        let kind = ProblemKind::IndexCount { name, expected, found };
        self.sink.report_with(base, kind, RelatedRole::Declared, declared);
        InferredValue::UNKNOWN
    }

    fn array_index(&mut self, base: ExprId, variable: &DeclaredVariable, indexes: &[ExprId], found: &[Base]) {
        let name = self.text(base);
        for (position, (&index, &found)) in indexes.iter().zip(found).enumerate() {
            if !found.same_as(Base::of(BaseType::Num)) {
                self.wrong_index(index, &name, "num", found);
            } else if let Some(number) = self.body.number(index) {
                self.bounds(index, number, ArrayDimension { array: base, variable, name: &name, position });
            }
        }
    }

    /// Checks a constant index. A negative index is always wrong, an index above the size only if the size cannot
    /// change. Neither is wrong if the value may be absent, as for `isDefined`, or if the line is never executed. An
    /// index above the size is not wrong after a condition that tests the size.
    fn bounds(&mut self, id: ExprId, number: f64, dimension: ArrayDimension<'_>) {
        let ArrayDimension { array, variable, name, position } = dimension;
        // Indexes are rounded to the nearest whole number (2.5.3).
        let index = (number + 0.5).floor() as i64;
        let sizes = self.scope.sizes(variable, name).unwrap_or(&[]);
        let size = sizes.get(position).copied();
        let is_outside = index < 0 || size.is_some_and(|size| index >= i64::from(size));
        if self.may_be_absent || !is_outside {
            return;
        }
        let guards = guards(self.scope.db(), self.file);
        let is_protected = index >= 0 && guards.protect(self.body, id, FixedArray { array, sizes });
        if is_protected || guards.is_never_evaluated(id) {
            return;
        }
        let size = size.map_or(0, |size| size as usize);
        let kind = ProblemKind::IndexOutOfBounds { name: name.clone(), index, size };
        match &variable.origin {
            VariableOrigin::Data(_, name) if index >= 0 => self.sink.report_unless_resized(id, name.clone(), kind),
            _ => self.report(id, kind),
        }
    }

    fn key(&mut self, base: ExprId, value: &InferredValue, indexes: &[ExprId], found: &[Base]) {
        let name = self.text(base);
        match (indexes, found) {
            ([key], [base]) => {
                if !base.same_as(Base::of(BaseType::String)) {
                    self.wrong_index(*key, &name, "string", *base);
                }
            }
            _ => {
                self.index_count(base, value, 1, indexes.len());
            }
        }
    }

    fn wrong_index(&mut self, id: ExprId, name: &SmolStr, expected: &'static str, found: Base) {
        let found = self.scope.show(found);
        let kind = ProblemKind::IndexType { name: name.clone(), expected: SmolStr::new_static(expected), found };
        self.report(id, kind);
    }

    /// `base.field`
    pub(super) fn field(&mut self, base: ExprId, field: &SmolStr, range: TextRange) -> InferredValue {
        let value = self.expr(base);
        if value.lacks_index() {
            self.index_missing(base, &value);
            return InferredValue::UNKNOWN;
        }
        match value.base {
            Base::Unknown => InferredValue::UNKNOWN,
            Base::User(project) => {
                let found = self.scope.user_field(project, field);
                self.resolved_at(range, found).unwrap_or(InferredValue::UNKNOWN)
            }
            Base::Builtin(ty, arm) => {
                let found = self.scope.builtin_field(ty, arm, field);
                self.resolved_at(range, found).map_or(InferredValue::UNKNOWN, |base| part(&value, base))
            }
        }
    }
}

/// Returns a field of a built-in type: a part of a variable or of a computed value.
fn part(whole: &InferredValue, base: Base) -> InferredValue {
    match whole.form {
        Form::Computed => InferredValue::computed(base),
        _ => InferredValue { base, form: Form::Indexed { of: Container::Element } },
    }
}
