//! Values as text for `?`, `val3 eval` and debuggers.

use super::{KindBase, Memory, Place, ValueType, View, field_offset};
use crate::enumerations;
use crate::fault::Result;
use crate::types::{Arm, BaseType, fields};
use crate::values::printed;

impl Memory {
    /// Formats a value in VAL 3 notation: strings in quotes, `{…}` for structures. Inputs, outputs and screens have no
    /// value.
    ///
    /// # Errors
    /// 20 if it does not exist.
    pub fn shown(&self, kind: &ValueType, at: Place) -> Result<String> {
        match &kind.base {
            KindBase::Builtin(base, arm) => self.shown_builtin(*base, *arm, at),
            KindBase::User(_) => {
                let parts: Result<Vec<String>> = (0..kind.size.part).map(|lane| self.shown_field(at, lane)).collect();
                Ok(printed::structure(&parts?))
            }
        }
    }

    /// Formats a field of a user type: one value, or the elements of an array.
    fn shown_field(&self, at: Place, lane: u32) -> Result<String> {
        let id = self.part(at, lane)?;
        let kind = self.store(id)?.kind.clone();
        let count = self.len(View::whole(id))?;
        if count == 1 {
            return self.shown(&kind, self.element(View::whole(id), 0)?);
        }
        let values: Result<Vec<String>> =
            (0..count).map(|number| self.shown(&kind, self.element(View::whole(id), number)?)).collect();
        Ok(printed::structure(&values?))
    }

    fn shown_builtin(&self, base: BaseType, arm: Option<Arm>, at: Place) -> Result<String> {
        Ok(match base {
            BaseType::Bool => printed::bool(self.num(at, 0)? != 0.0).to_owned(),
            BaseType::Num => printed::num(self.num(at, 0)?).to_string(),
            BaseType::String => printed::string(self.text(at)?),
            _ if base.is_enumeration() => enumerator_name(base, self.num(at, 0)?).to_owned(),
            _ if base.is_structured() => {
                let parts = fields(base, arm).iter().map(|field| {
                    let offset = field_offset(base, arm, field.name).unwrap_or_default();
                    self.shown_builtin(field.ty, arm, at.after(offset))
                });
                printed::structure(&parts.collect::<Result<Vec<String>>>()?)
            }
            _ => String::new(),
        })
    }
}

fn enumerator_name(base: BaseType, number: f64) -> &'static str {
    let mut values = enumerations::values(base).zip(0u32..);
    values.find(|(_, at)| f64::from(*at) == number).map_or("", |(value, _)| value.name)
}
