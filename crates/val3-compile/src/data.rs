//! Initial values of data, in both file dialects (s5 to s8).

mod fathers;
mod loaded;
mod values;

use std::borrow::Cow;
use std::collections::BTreeMap;

use val3_analysis::ty::Base;
use val3_analysis::xml::XmlElement as Xml;
use val3_bytecode::FatherLink;
use val3_lang::memory::{ContainerShape, DetachedValue, MEMORY, PartInit, ValueType, bytes_of};
use val3_lang::types::Container;
use val3_lang::values::Text;

use crate::error::{CompileLimit, Result};
use crate::kinds::Kinds;

pub(crate) use fathers::detach_fathers;
pub(crate) use loaded::{Loaded, LoadedLink};

impl Kinds<'_> {
    /// Reads a `<Data>` or `<Field>`, or the corresponding elements of the old dialect.
    pub(crate) fn load(&mut self, element: Xml<'_>, container: Container, sizes: &[u32], base: Base) -> Result<Loaded> {
        let base = base.on_arm(self.arm);
        let kind = self.kind(base)?;
        let (shape, written) = placed(element, container, sizes);
        let count = shape.len();
        let mut loaded = Loaded { init: PartInit { kind: kind.clone(), shape, values: Vec::new() }, links: Vec::new() };
        let unwritten = values::unwritten(base, &kind);
        let last = if unwritten.is_some() {
            count
        } else {
            written.iter().map(|(at, _)| at.saturating_add(1)).max().unwrap_or(0)
        };
        fits(loaded.init.bytes().saturating_add(bytes_of::<Option<DetachedValue>>(last as usize)))?;
        if let Some(value) = unwritten {
            loaded.init.values = vec![Some(value); count as usize];
        }
        let mut overridden = vec![false; if kind.fields.is_empty() { 0 } else { count as usize }];
        let father = fathers::of_all_values(element);
        for (number, value) in written.into_iter().filter(|(number, _)| *number < count) {
            let read = self.value(value, father.as_ref(), base, &kind, number, &mut loaded.links)?;
            put(&mut loaded.init.values, number, read);
            overridden.get_mut(number as usize).into_iter().for_each(|slot| *slot = true);
        }
        self.inherit(base, &overridden, &mut loaded.links)?;
        Ok(loaded)
    }

    fn value(
        &mut self,
        value: Xml<'_>,
        father: Option<&FatherLink>,
        base: Base,
        kind: &ValueType,
        number: u32,
        links: &mut Vec<LoadedLink>,
    ) -> Result<DetachedValue> {
        match base {
            Base::Builtin(base, arm) => Ok(values::read(value, father, base, arm, kind, number, links)),
            Base::User(_) => self.user_value(value, base, kind, number, links),
            Base::Unknown => Err(CompileLimit::Unclear),
        }
    }

    /// Reads the fields that a value contains, matched by name. Other fields have the type's initial values.
    fn user_value(
        &mut self,
        value: Xml<'_>,
        base: Base,
        kind: &ValueType,
        number: u32,
        links: &mut Vec<LoadedLink>,
    ) -> Result<DetachedValue> {
        let (bases, inherited) = (self.field_bases(base)?, self.links(base)?);
        let mut parts = Vec::with_capacity(kind.fields.len());
        for ((field, base), at) in kind.fields.iter().zip(bases).zip(0u32..) {
            let named = |element: &Xml<'_>| element.value("name").is_some_and(|name| name == field.name.as_str());
            if let Some(element) = value.elements().find(named) {
                let declared = val3_analysis::items::data::shape(element);
                let loaded = self.load(element, declared.container, &declared.sizes, base)?;
                links.extend(loaded.links.iter().map(|found| found.within(number, at)));
                parts.push(loaded.init);
            } else {
                let own = inherited.iter().filter(|(field, _)| *field == at);
                links.extend(own.map(|(_, found)| found.within(number, at)));
                parts.push(field.init.clone());
            }
        }
        Ok(DetachedValue { parts, ..DetachedValue::default() })
    }

    /// Adds the type's links for values that the file does not contain.
    fn inherit(&mut self, base: Base, overridden: &[bool], links: &mut Vec<LoadedLink>) -> Result<()> {
        let inherited = self.links(base)?;
        for (number, _) in (0u32..).zip(overridden).filter(|(_, overridden)| !**overridden) {
            links.extend(inherited.iter().map(|(field, found)| found.within(number, *field)));
        }
        Ok(())
    }
}

/// Checks that data with this size can be in memory.
pub(crate) fn fits(bytes: u64) -> Result<()> {
    if bytes > MEMORY { Err(CompileLimit::Memory) } else { Ok(()) }
}

/// Returns the container's shape, and the elements of the values with their numbers.
fn placed<'g>(element: Xml<'g>, container: Container, sizes: &[u32]) -> (ContainerShape, Vec<(u32, Xml<'g>)>) {
    let key = |value: &Xml<'g>| value.value("key").or_else(|| value.value("index"));
    let values = element.elements().filter(|value| value.name().to_ascii_lowercase().starts_with("value"));
    if container == Container::Collection {
        let mut keys = BTreeMap::new();
        let mut written = Vec::new();
        for value in values {
            let Some(key) = key(&value) else { continue };
            let number = u32::try_from(keys.len()).unwrap_or(u32::MAX);
            written.push((*keys.entry(Text::from(key.as_ref())).or_insert(number), value));
        }
        return (ContainerShape::Collection(keys), written);
    }
    let shape = shape(container, sizes);
    let written = values.filter_map(|value| Some((number(&shape, key(&value)?)?, value))).collect();
    (shape, written)
}

/// Returns the number of the value with an index as in data files: `7`, `2,1`.
fn number(shape: &ContainerShape, key: Cow<'_, str>) -> Option<u32> {
    let ContainerShape::Array { dims, sizes } = shape else { return None };
    let indexes: Vec<u32> = key.split(',').map(|index| index.trim().parse().ok()).collect::<Option<_>>()?;
    let inside = indexes.len() == usize::from(*dims) && indexes.iter().zip(sizes).all(|(index, size)| index < size);
    inside.then(|| {
        indexes
            .iter()
            .zip(sizes)
            .fold(0u32, |number, (index, size)| number.saturating_mul(*size).saturating_add(*index))
    })
}

fn put(values: &mut Vec<Option<DetachedValue>>, number: u32, value: DetachedValue) {
    let at = number as usize;
    if values.len() <= at {
        values.resize(at + 1, None);
    }
    if let Some(slot) = values.get_mut(at) {
        *slot = Some(value);
    }
}

/// Returns the shape of a container with these sizes, or of a collection without keys.
pub(crate) fn shape(container: Container, sizes: &[u32]) -> ContainerShape {
    if container == Container::Collection {
        return ContainerShape::Collection(BTreeMap::new());
    }
    let mut all = [1; 3];
    all.iter_mut().zip(sizes).for_each(|(to, size)| *to = *size);
    ContainerShape::Array { dims: u8::try_from(sizes.len()).unwrap_or(1).max(1), sizes: all }
}
