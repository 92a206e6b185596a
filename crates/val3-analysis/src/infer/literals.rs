//! Inference of `{…}`: the values of a structure, whose type is given by the context (2.4.2).

use val3_lang::types::{self, BaseType};

use super::Infer;
use super::value::InferredValue;
use crate::body::ExprId;
use crate::problem::ProblemKind;
use crate::ty::Base;

impl Infer<'_> {
    /// Infers `{values}` where a value of type `expected` is needed.
    pub(super) fn literal(&mut self, id: ExprId, values: &[Option<ExprId>], expected: Option<Base>) -> InferredValue {
        let expected = expected.map(|base| base.on_arm(self.scope.arm()));
        let fields = match expected {
            Some(Base::Builtin(ty, arm)) => types::fields(ty, arm.or(self.scope.arm())),
            _ => &[],
        };
        match expected {
            Some(base @ Base::Builtin(ty, _)) if !fields.is_empty() => {
                self.fields_of(id, base, ty, fields, values);
                InferredValue::computed(base)
            }
            Some(base @ (Base::User(_) | Base::Unknown)) => {
                self.inner_values(values);
                InferredValue::computed(base)
            }
            other => {
                self.inner_values(values);
                let expected = other.map(|base| self.scope.show(base));
                self.report(id, ProblemKind::LiteralWithoutType { expected });
                InferredValue::UNKNOWN
            }
        }
    }

    /// Infers the values without an expected type.
    fn inner_values(&mut self, values: &[Option<ExprId>]) {
        for value in values.iter().flatten() {
            self.element_as(*value, Some(Base::Unknown));
        }
    }

    fn fields_of(&mut self, id: ExprId, base: Base, ty: BaseType, fields: &[types::Field], values: &[Option<ExprId>]) {
        if values.len() > fields.len() {
            self.inner_values(values);
            let (expected, found) = (fields.len(), values.len());
            return self.report(id, ProblemKind::LiteralFieldCount { ty: self.scope.show(base), expected, found });
        }
        for (field, value) in fields.iter().zip(values) {
            let Some(value) = *value else { continue };
            let wanted = Base::of(field.ty);
            let found = self.element_as(value, Some(wanted));
            // A tool accepts its valve in this way, although inputs and outputs cannot be assigned to each other.
            if !self.assignable(wanted, found) && !found.same_as(wanted) {
                let [expected, found] = self.scope.show_both([wanted, found]);
                let ty = ty.name().into();
                self.report(value, ProblemKind::LiteralFieldType { ty, field: field.name.into(), expected, found });
            }
        }
    }
}
