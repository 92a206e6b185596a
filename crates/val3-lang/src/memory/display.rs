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
        let numbers = self.store(id)?.shape.numbers();
        let shown = |number| self.shown(&kind, self.element(View::whole(id), number)?);
        if let [number] = *numbers {
            return shown(number);
        }
        let values: Result<Vec<String>> = numbers.into_iter().map(shown).collect();
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use crate::memory::{ContainerShape, FieldKind, Memory, PartInit, Place, ValueType};
    use crate::types::BaseType;
    use crate::values::Text;

    #[test]
    fn a_field_shows_the_values_of_its_keys() {
        let init = |kind, shape| PartInit { kind: Arc::new(kind), shape, values: Vec::new() };
        let keyed = init(ValueType::builtin(BaseType::Num, None), ContainerShape::Collection(Default::default()));
        let kind = ValueType::user("T".to_owned(), vec![FieldKind { name: "nKeyed".to_owned(), init: keyed }]);
        let mut memory = Memory::new();
        let value = Place::first(memory.create(&init(kind.clone(), ContainerShape::ELEMENT)).unwrap());
        let keyed = memory.part(value, 0).unwrap();
        for (key, number) in [("a", 1.0), ("b", 2.0), ("c", 3.0)] {
            memory.insert_key(keyed, Text::from(key), None).unwrap();
            let store = memory.store(keyed).unwrap();
            let place = store.place(keyed, store.number_of(&Text::from(key)).unwrap());
            memory.set_num(place, 0, number).unwrap();
        }
        memory.delete_key(keyed, &Text::from("a")).unwrap();
        assert_eq!(memory.shown(&kind, value).as_deref(), Ok("{{2,3}}"));
    }
}
