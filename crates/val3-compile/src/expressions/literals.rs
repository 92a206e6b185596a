//! `{…}`: values of a structure. Omitted values are 0 (2.4.2).

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::ty::Base;
use val3_lang::memory::{Lanes, ValueType, field_offset};
use val3_lang::types::{Arm, BaseType, Field, fields};

use crate::error::{CompileLimit, Result};
use crate::expressions::Expressions;
use crate::frame::narrow;
use crate::location::{CompiledValue, ValueLocator};

/// Values between braces.
type BracedValues = [Option<ExprId>];

impl Expressions<'_, '_> {
    /// Compiles `{values}` as a value of type `base`.
    pub(crate) fn literal(&mut self, base: Base, values: &BracedValues) -> Result<CompiledValue> {
        let Base::Builtin(builtin, arm) = base else {
            let (_, own) = self.out.own_container(base)?;
            self.user_literal(own, values)?;
            return Ok(own);
        };
        let kind = self.out.kind(base)?;
        let arm = arm.or(self.out.unit().items.arm);
        if let Some(nums) = self.constants(builtin, arm, values) {
            return self.constant_literal(base, &kind, nums);
        }
        // The link lanes must stay empty, so they are not shared with temporaries.
        let lanes = if kind.size.link > 0 {
            self.out.frame_mut().lasting(&kind)?
        } else {
            self.out.frame_mut().value(kind.size)?
        };
        self.fill(lanes, builtin, arm, values)?;
        Ok(CompiledValue { location: ValueLocator::Frame(lanes), base })
    }

    /// Stores a constant structure in the frame's initial values.
    fn constant_literal(&mut self, base: Base, kind: &ValueType, nums: Vec<f64>) -> Result<CompiledValue> {
        let mut kind = kind.clone();
        let length = kind.default.nums.len();
        kind.default.nums = nums;
        kind.default.nums.resize(length, 0.0);
        let lanes = self.out.frame_mut().lasting(&kind)?;
        Ok(CompiledValue { location: ValueLocator::Frame(lanes), base })
    }

    /// Returns the structure's numbers if all values are constants.
    fn constants(&self, base: BaseType, arm: Option<Arm>, values: &BracedValues) -> Option<Vec<f64>> {
        let mut nums = Vec::new();
        for (at, field) in fields(base, arm).iter().enumerate() {
            let value = values.get(at).copied().flatten();
            let inner = value.map(|id| self.body.expr(self.body.without_parentheses(id)));
            match (inner, value) {
                (Some(Expr::Struct(inner)), _) => nums.extend(self.constants(field.ty, arm, inner)?),
                (_, Some(id)) => nums.push(self.constant(id)?.1),
                (_, None) => nums.extend(zeros(field, arm)),
            }
        }
        Some(nums)
    }

    /// Writes all numbers of a structure on the frame.
    fn fill(&mut self, lanes: Lanes, base: BaseType, arm: Option<Arm>, values: &BracedValues) -> Result<()> {
        let mut end = 0;
        for (at, field) in fields(base, arm).iter().enumerate() {
            let offset = field_offset(base, arm, field.name).ok_or(CompileLimit::Unclear)?;
            let to =
                CompiledValue { location: ValueLocator::Frame(lanes + offset), base: Base::Builtin(field.ty, arm) };
            end = offset.num + self.out.kind(to.base)?.size.num;
            let value = values.get(at).copied().flatten();
            match value.map(|id| (id, self.body.expr(self.body.without_parentheses(id)))) {
                Some((_, Expr::Struct(inner))) => self.fill(lanes + offset, field.ty, arm, inner)?,
                Some((id, _)) => {
                    let value = self.value(id, to.location.lanes())?;
                    self.out.copy(to, value)?;
                }
                None => self.clear(lanes.num + offset.num, lanes.num + end)?,
            }
        }
        let size = self.out.kind(Base::Builtin(base, arm))?.size.num;
        self.clear(lanes.num + end, lanes.num + size)
    }

    fn clear(&mut self, from: u32, to: u32) -> Result<()> {
        let zero = self.out.frame_mut().constant(0.0)?;
        (from..to).for_each(|lane| self.out.move_num(narrow(lane), zero));
        Ok(())
    }

    /// Compiles `variable = {values}`. A frame, tool or point keeps its links (9.4 to 9.6).
    pub(crate) fn literal_to(&mut self, to: CompiledValue, values: &BracedValues) -> Result<()> {
        let Base::Builtin(base, arm) = to.base else { return self.user_literal(to, values) };
        let from = self.literal(to.base, values)?;
        if self.out.kind(to.base)?.size.link == 0 {
            return self.out.copy(to, from);
        }
        let arm = arm.or(self.out.unit().items.arm);
        for (at, field) in fields(base, arm).iter().enumerate() {
            let given = values.get(at).copied().flatten().is_some();
            if field.ty.is_linkable() && !given {
                continue;
            }
            let offset = field_offset(base, arm, field.name).ok_or(CompileLimit::Unclear)?;
            let field = Base::Builtin(field.ty, arm);
            let [to, from] = [self.out.after(to.location, offset)?, self.out.after(from.location, offset)?];
            self.out
                .copy(CompiledValue { location: to, base: field }, CompiledValue { location: from, base: field })?;
        }
        Ok(())
    }

    /// Writes the fields of a user type, in the order of its data. Omitted fields keep their values.
    fn user_literal(&mut self, to: CompiledValue, values: &BracedValues) -> Result<()> {
        let (kind, bases) = (self.out.kind(to.base)?, self.out.unit_mut().kinds.field_bases(to.base)?);
        for (number, (value, base)) in values.iter().zip(bases).enumerate().take(kind.fields.len()) {
            let Some(id) = *value else { continue };
            let value = self.value_as(id, base)?;
            let field = self.out.first_of_field(to, number)?;
            self.out.copy(CompiledValue { location: field, base }, value)?;
        }
        Ok(())
    }
}

fn zeros(field: &Field, arm: Option<Arm>) -> Vec<f64> {
    let size = ValueType::builtin(field.ty, arm).size.num;
    vec![0.0; size as usize]
}
