//! Values in place of instructions of add-ons (`run.add-ons` in `val3.toml`).

use val3_analysis::body::{Expr, ExprId};
use val3_analysis::ty::Base;
use val3_config::StandInValue;
use val3_lang::types::BaseType;

use crate::error::Result;
use crate::expressions::Expressions;
use crate::location::{Location, Value};

impl Expressions<'_, '_> {
    /// The value that stands in for the instruction of an add-on that `call` calls.
    pub(crate) fn stand_in(&self, call: ExprId) -> Option<StandInValue> {
        let Expr::Call(callee, _) = self.body.expr(call) else { return None };
        let Expr::Name(name) = self.body.expr(*callee) else { return None };
        let unit = self.unit();
        unit.project.config(unit.db)?.run.add_ons.get(name.as_str()).cloned()
    }

    /// A stand-in as a constant. A `string` is converted to no other type, nor are numbers and truth values to each other:
    /// the type of the value is that of the call.
    pub(crate) fn stand_in_value(&mut self, stand_in: &StandInValue) -> Result<Value> {
        let mut number = |ty, number| Ok(Value::num(ty, self.out.frame_mut().constant(number)?));
        match stand_in {
            StandInValue::Bool(value) => number(BaseType::Bool, f64::from(u8::from(*value))),
            StandInValue::Number(value) => number(BaseType::Num, *value),
            StandInValue::Text(text) => {
                let location = Location::Constant(self.out.code().text(&text.as_str().into())?);
                Ok(Value { location, base: Base::of(BaseType::String) })
            }
        }
    }
}
