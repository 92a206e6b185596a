//! Converts global data to file content: values with attributes according to their types.

use val3_bytecode::DataDef;
use val3_data::{SavedContent, SavedData, SavedField, SavedValue};
use val3_lang::enumerations;
use val3_lang::fault::Result;
use val3_lang::memory::{
    ContainerShape, DetachedValue, KindBase, Lanes, LinkPlace, Memory, PartInit, Place, StoreId, ValueType, path_offset,
};
use val3_lang::types::{Arm, AttributeValue, BaseType, DefaultValue, ValueAttribute, attributes};
use val3_vm::Instance;

use super::links::{LinkPath, LoadedLinks, index};

/// Reader for an application's or library's data.
pub(super) struct Saver<'s> {
    pub(super) memory: &'s Memory,
    pub(super) instance: &'s Instance,
    pub(super) links: LoadedLinks<'s>,
    /// Spelling of numbers.
    pub(super) number_text: fn(f64) -> String,
}

/// Value within global data, as loaded.
#[derive(Clone)]
pub(super) struct LoadedValue<'l> {
    /// The data and the path from it through fields; `None` for a value that was not loaded.
    way: Option<(u32, Vec<(u32, u32)>)>,
    /// The container.
    init: Option<&'l PartInit>,
}

impl Saver<'_> {
    /// Returns all data. Data that no longer exist are omitted, so that the file keeps its text for them.
    pub(super) fn all(&self) -> Vec<SavedData> {
        let data = self.instance.image.data.iter().zip(self.instance.data.iter()).zip(0u32..);
        data.filter_map(|((data, store), number)| self.data(data, *store, number).ok()).collect()
    }

    /// Returns the values at these places, of data in files.
    pub(super) fn at(&self, places: &[Place]) -> Vec<SavedData> {
        let mut found = Vec::new();
        let places: Vec<Place> = places.iter().filter_map(|place| self.memory.present(*place).ok()).collect();
        for ((data, store), number) in self.instance.image.data.iter().zip(self.instance.data.iter()).zip(0u32..) {
            let Ok(known) = self.memory.store(*store) else { continue };
            let mut meant = keys(&known.shape);
            meant.retain(|(number, _)| places.contains(&known.place(*store, *number)));
            let meant: Vec<String> = meant.into_iter().map(|(_, key)| key).collect();
            if meant.is_empty() {
                continue;
            }
            let Ok(mut saved) = self.data(data, *store, number) else { continue };
            saved.values.retain(|value| meant.contains(&value.key));
            let defaults = meant.into_iter().filter(|key| !saved.values.iter().any(|value| value.key == *key));
            let defaults = defaults.map(|key| SavedValue { key, content: SavedContent::Attributes(Vec::new()) });
            let defaults: Vec<SavedValue> = defaults.collect();
            saved.values.extend(defaults);
            saved.is_part = true;
            found.push(saved);
        }
        found
    }

    /// Returns global data.
    pub(super) fn data(&self, data: &DataDef, store: StoreId, number: u32) -> Result<SavedData> {
        let loaded = LoadedValue { way: Some((number, Vec::new())), init: Some(&data.init) };
        self.container(&data.name, store, &loaded).map(|(saved, _)| saved)
    }

    /// Returns a container, and whether it is unchanged since it was loaded.
    pub(super) fn container(&self, name: &str, id: StoreId, loaded: &LoadedValue<'_>) -> Result<(SavedData, bool)> {
        let store = self.memory.store(id)?;
        let mut unchanged = loaded.init.is_some_and(|init| is_like(&init.shape, &store.shape));
        let mut values = Vec::new();
        for (number, key) in keys(&store.shape) {
            let place = store.place(id, number);
            let (content, same) = self.content(place, &store.kind, loaded, &key)?;
            unchanged &= same;
            let is_needed =
                content != SavedContent::Attributes(Vec::new()) || matches!(store.shape, ContainerShape::Collection(_));
            if is_needed {
                values.push(SavedValue { key, content });
            }
        }
        let shape = saved_shape(&store.shape);
        Ok((
            SavedData { name: name.into(), type_name: type_name(&store.kind).into(), shape, values, is_part: false },
            unchanged,
        ))
    }

    /// Returns a value, and whether it is unchanged since it was loaded.
    pub(super) fn content(
        &self,
        place: Place,
        kind: &ValueType,
        loaded: &LoadedValue<'_>,
        key: &str,
    ) -> Result<(SavedContent, bool)> {
        match kind.base {
            KindBase::Builtin(base, arm) => self.value(place, base, arm, kind, loaded, key),
            KindBase::User(_) => self.user_value(place, kind, loaded, key),
        }
    }

    fn value(
        &self,
        place: Place,
        base: BaseType,
        arm: Option<Arm>,
        kind: &ValueType,
        loaded: &LoadedValue<'_>,
        key: &str,
    ) -> Result<(SavedContent, bool)> {
        let (number, element) = loaded.value(kind, key);
        let spot = loaded.way(number);
        let mut written = Vec::new();
        for attribute in attributes(base, arm) {
            let Some(offset) = path_offset(base, arm, attribute.field) else { continue };
            let spot = spot.clone().map(|(data, way, number, _)| (data, way, number, offset.link));
            if let Some(text) = self.attribute(place.after(offset), base, attribute, spot.as_ref())? {
                written.push((attribute.name.into(), text));
            }
        }
        let same = self.is_same(place, kind.size, element)? && self.has_links(place, kind, spot, element)?;
        Ok((SavedContent::Attributes(written), same))
    }

    /// Returns an attribute as text; `None` if it has the default.
    fn attribute(
        &self,
        at: Place,
        base: BaseType,
        attribute: &ValueAttribute,
        spot: Option<&LinkPath>,
    ) -> Result<Option<String>> {
        let text = match attribute.value {
            AttributeValue::Text => self.memory.text(at)?.to_string(),
            AttributeValue::Father(_) => return Ok(self.links.text_at(spot, self.memory.link(at, 0)?, base)),
            AttributeValue::Link => {
                let port = if base.is_linkable() { base } else { BaseType::Dio };
                return Ok(self.links.text_at(spot, self.memory.link(at, 0)?, port));
            }
            AttributeValue::Truth => (self.memory.num(at, 0)? != 0.0).to_string(),
            AttributeValue::Number => {
                let number = self.memory.num(at, 0)?;
                if attribute.default == DefaultValue::Number(number) {
                    return Ok(None);
                }
                (self.number_text)(number)
            }
            AttributeValue::Choice(ty) => choice(ty, self.memory.num(at, 0)?).to_owned(),
        };
        let is_default = match attribute.default {
            DefaultValue::Enumerator(name) => text == name,
            DefaultValue::False => text == "false",
            DefaultValue::EmptyText => text.is_empty(),
            DefaultValue::Number(_) | DefaultValue::OfFields | DefaultValue::Unlinked => false,
        };
        Ok((!is_default).then_some(text))
    }

    fn user_value(
        &self,
        place: Place,
        kind: &ValueType,
        loaded: &LoadedValue<'_>,
        key: &str,
    ) -> Result<(SavedContent, bool)> {
        let (number, element) = loaded.value(kind, key);
        let (mut fields, mut unchanged) = (Vec::new(), true);
        for (field, at) in kind.fields.iter().zip(0u32..) {
            let init = element.parts.get(at as usize).unwrap_or(&field.init);
            let way = loaded.way(number).map(|(data, mut way, number, _)| {
                way.push((number, at));
                (data, way)
            });
            let (data, initial) =
                self.container(&field.name, self.memory.part(place, at)?, &LoadedValue { way, init: Some(init) })?;
            unchanged &= initial;
            fields.push(SavedField { initial, data });
        }
        Ok((SavedContent::Fields(fields), unchanged))
    }

    fn is_same(&self, place: Place, size: Lanes, element: &DetachedValue) -> Result<bool> {
        for (lane, number) in (0..size.num).zip(&element.nums) {
            if self.memory.num(place, lane)? != *number {
                return Ok(false);
            }
        }
        for (lane, text) in (0..size.text).zip(&element.texts) {
            if self.memory.text(place.after(Lanes::texts(lane)))? != text {
                return Ok(false);
            }
        }
        Ok(true)
    }

    fn has_links(
        &self,
        place: Place,
        kind: &ValueType,
        spot: Option<LinkPath>,
        element: &DetachedValue,
    ) -> Result<bool> {
        for lane in 0..kind.size.link {
            let own = element.links.get(lane as usize).copied().unwrap_or(LinkPlace::None);
            let spot = spot.clone().map(|(data, way, number, _)| (data, way, number, lane));
            if !self.links.is_loaded(spot.as_ref(), self.memory.link(place, lane)?, own) {
                return Ok(false);
            }
        }
        Ok(true)
    }
}

impl LoadedValue<'_> {
    /// A value that was not loaded.
    pub(super) const NONE: Self = Self { way: None, init: None };
}

impl<'l> LoadedValue<'l> {
    /// Global data with this number.
    pub(super) fn of_data(data: &'l DataDef, number: u32) -> Self {
        Self { way: Some((number, Vec::new())), init: Some(&data.init) }
    }

    /// Returns the number and value that were loaded under a key; a missing value is replaced by the default of `kind`.
    fn value<'k>(&self, kind: &'k ValueType, key: &str) -> (Option<u32>, &'k DetachedValue)
    where
        'l: 'k,
    {
        let number = self.init.and_then(|init| init.shape.number_of_text(key));
        let found = self.init.zip(number).and_then(|(init, number)| init.values.get(number as usize));
        (number, found.and_then(Option::as_ref).unwrap_or(&kind.default))
    }

    /// Returns the first link of the value with this number.
    fn way(&self, number: Option<u32>) -> Option<LinkPath> {
        let (data, way) = self.way.clone()?;
        Some((data, way, number?, 0))
    }
}

/// Returns a container's value numbers, each with the key as written in files: `7`, `2,1`, `home`.
pub(super) fn keys(shape: &ContainerShape) -> Vec<(u32, String)> {
    match shape {
        ContainerShape::Collection(keys) => keys.iter().map(|(key, number)| (*number, key.to_string())).collect(),
        ContainerShape::Array { dims, sizes } => {
            (0..shape.len()).map(|number| (number, index(*dims, *sizes, number))).collect()
        }
    }
}

pub(super) fn saved_shape(shape: &ContainerShape) -> val3_data::SavedContainer {
    match shape {
        ContainerShape::Collection(_) => val3_data::SavedContainer::Keys,
        ContainerShape::Array { dims, sizes } => {
            val3_data::SavedContainer::Sizes(sizes.iter().copied().take(usize::from(*dims)).collect())
        }
    }
}

/// Whether both have the same sizes, or the same keys.
fn is_like(one: &ContainerShape, other: &ContainerShape) -> bool {
    match (one, other) {
        (ContainerShape::Collection(one), ContainerShape::Collection(other)) => one.keys().eq(other.keys()),
        _ => one == other,
    }
}

pub(super) fn type_name(kind: &ValueType) -> String {
    match &kind.base {
        KindBase::Builtin(base, Some(arm)) => base.file_name(*arm),
        KindBase::Builtin(base, None) => base.name().to_owned(),
        KindBase::User(name) => name.clone(),
    }
}

/// Returns an enumerator in the spelling of files.
fn choice(ty: BaseType, number: f64) -> &'static str {
    let mut values = enumerations::values(ty).zip(0u32..);
    values.find(|(_, at)| f64::from(*at) == number).map_or("", |(value, _)| value.file_name)
}
