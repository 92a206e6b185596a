//! Reads values from the memory.

use std::ops::Range;
use std::sync::Arc;

use val3_bytecode::{FrameVariable, Storage};
use val3_lang::call::Argument;
use val3_lang::fault::Result;
use val3_lang::memory::{ContainerShape, KindBase, Memory, Place, StoreId, ValueType, View, field_offset};
use val3_lang::ports::TaskNumber;
use val3_lang::types::{NumberUnit, fields};
use val3_machine::devices::Devices;
use val3_vm::Frame;

use super::names::AccessNames;
use super::text::{DisplayFormat, index, key, radians, shown, sizes, type_name};
use super::{DebugValue, Inside, ValueNode, ValuePath, positions};

/// Values of a page, by their location in memory.
pub(super) enum ItemRange {
    /// Variables of a stack frame.
    Variables(Frame, Vec<FrameVariable>),
    /// Data: name, whether the program of the page can name it, and values.
    Data(Vec<(String, bool, View)>),
    /// Array or collection elements.
    Values(View, Range<usize>),
    /// Fields of a value.
    Fields(Arc<ValueType>, Place, Range<usize>),
}

/// Reader of values while the stack of a task is in the memory.
#[derive(Clone, Copy)]
pub(super) struct Look<'a> {
    pub(super) task: Option<TaskNumber>,
    /// Path of the enclosing value.
    pub(super) path: &'a ValuePath,
    pub(super) names: &'a AccessNames,
    pub(super) devices: &'a Devices,
    pub(super) format: DisplayFormat,
}

impl Look<'_> {
    /// Reads the values of a page.
    pub(super) fn page(self, memory: &mut Memory, page: ItemRange) -> Vec<DebugValue> {
        match page {
            ItemRange::Variables(frame, variables) => {
                variables.iter().map(|variable| self.variable(memory, &frame, variable)).collect()
            }
            ItemRange::Data(data) => {
                let values = data.into_iter().map(|(name, is_seen, view)| {
                    let value = self.container(memory, name, view);
                    if is_seen { value } else { unseen(value) }
                });
                values.collect()
            }
            ItemRange::Values(view, range) => self.elements(memory, view, range),
            ItemRange::Fields(kind, place, range) => {
                range.filter_map(|number| self.field(memory, &kind, place, number)).collect()
            }
        }
    }

    /// Reads an expression's value.
    pub(super) fn argument(self, memory: &Memory, name: &str, argument: Argument, kind: &Arc<ValueType>) -> DebugValue {
        // The path is the value's own, not the enclosing value's.
        let path = ValuePath { text: Some(String::new()), ..self.path.clone() };
        let look = Look { path: &path, ..self };
        let (value, refers_to) = match argument {
            Argument::Value(place, _) | Argument::UserValue(place) => {
                (look.single(memory, name.to_owned(), kind, place), look.names.of_place(memory, place, kind))
            }
            Argument::View(view) => (look.container(memory, name.to_owned(), view), look.names.of_view(memory, view)),
            Argument::Slot(_) | Argument::Library(_) => return gone(name.to_owned()),
        };
        DebugValue { refers_to: refers_to.filter(|found| found != name), ..value }
    }

    /// Reads all nested values of a result, because a result does not remain on the stack.
    pub(super) fn complete(self, memory: &Memory, value: DebugValue) -> DebugValue {
        let Some(Inside { node: ValueNode::Fields(kind, place), path, .. }) = &value.inside else { return value };
        if place.store != StoreId::STACK {
            return value;
        }
        let path = path.computed();
        let look = Look { path: &path, ..self };
        let children = (0..fields_of(kind, *place)).filter_map(|number| look.field(memory, kind, *place, number));
        let inside = Inside::listed(children.map(|child| look.complete(memory, child)).collect());
        DebugValue { inside, ..value }
    }

    fn elements(self, memory: &Memory, view: View, range: Range<usize>) -> Vec<DebugValue> {
        let Ok(store) = memory.store(view.store) else { return Vec::new() };
        let kind = Arc::clone(&store.kind);
        let places = element_places(memory, view, range).into_iter();
        places.map(|(name, place)| self.single(memory, name, &kind, place)).collect()
    }

    fn variable(self, memory: &Memory, frame: &Frame, variable: &FrameVariable) -> DebugValue {
        let (name, base) = (variable.name.clone(), &frame.base);
        let part = |number: u16| memory.stack.parts.get(base.part as usize + usize::from(number)).copied();
        match variable.storage {
            Storage::Value(lanes) => self.single(memory, name, &variable.kind, frame.place(lanes)),
            Storage::Part(number) => self.optional(memory, name, part(number).map(View::whole)),
            Storage::Place(number) => {
                let place = memory.stack.places.get(base.place as usize + usize::from(number)).copied();
                let Some(place) = place else { return gone(name) };
                let refers_to = self.names.of_place(memory, place, &variable.kind);
                DebugValue { refers_to, ..self.single(memory, name, &variable.kind, place) }
            }
            Storage::View(number) => {
                let view = memory.stack.views.get(base.view as usize + usize::from(number)).copied();
                let refers_to = view.and_then(|view| self.names.of_view(memory, view));
                DebugValue { refers_to, ..self.optional(memory, name, view) }
            }
        }
    }

    fn optional(self, memory: &Memory, name: String, view: Option<View>) -> DebugValue {
        match view {
            Some(view) => self.container(memory, name, view),
            None => gone(name),
        }
    }

    /// Reads an array or collection, or its only element.
    pub(super) fn container(self, memory: &Memory, name: String, view: View) -> DebugValue {
        or_gone(name, |name| {
            let store = memory.store(view.store)?;
            let (kind, count) = (Arc::clone(&store.kind), memory.len(view)?);
            if count == 1 && matches!(store.shape, ContainerShape::Array { .. }) {
                return Ok(self.single(memory, name, &kind, memory.element(view, 0)?));
            }
            let shown = if count == 1 { "1 value".to_owned() } else { format!("{count} values") };
            let type_name = type_name(&kind) + &sizes(&store.shape, count);
            Ok(self.value(name, type_name, shown, (count > 0).then_some(ValueNode::Values(view))))
        })
    }

    /// Reads a single value.
    pub(super) fn single(self, memory: &Memory, name: String, kind: &Arc<ValueType>, place: Place) -> DebugValue {
        or_gone(name, |name| {
            let has_fields = match &kind.base {
                KindBase::User(_) => !kind.fields.is_empty(),
                KindBase::Builtin(base, _) => base.is_structured(),
            };
            let shown = shown(memory, self.devices, kind, place, self.format)?;
            let node = has_fields.then(|| ValueNode::Fields(Arc::clone(kind), place));
            Ok(self.value(name, type_name(kind), shown, node))
        })
    }

    fn value(self, name: String, type_name: String, shown: String, node: Option<ValueNode>) -> DebugValue {
        let path = self.path.child(&name);
        let expression = path.expression();
        let inside = node.map(|node| Inside { task: self.task, path, node });
        DebugValue { name, type_name, shown, path: expression, refers_to: None, inside }
    }

    pub(super) fn field(self, memory: &Memory, kind: &ValueType, place: Place, number: usize) -> Option<DebugValue> {
        match &kind.base {
            KindBase::User(_) => {
                let name = kind.fields.get(number)?.name.clone();
                let part = memory.part(place, u32::try_from(number).ok()?);
                Some(or_gone(name, |name| Ok(self.container(memory, name, View::whole(part?)))))
            }
            KindBase::Builtin(base, arm) => {
                let Some(field) = fields(*base, *arm).get(number) else {
                    let number = number - fields(*base, *arm).len();
                    return positions::part(self, memory, *base, place, number);
                };
                let kind = Arc::new(ValueType::builtin(field.ty, *arm));
                let place = place.after(field_offset(*base, *arm, field.name)?);
                let value = self.single(memory, field.name.to_owned(), &kind, place);
                let is_angle = self.format.radians && field.unit == NumberUnit::Degrees;
                let angle = memory.num(place, 0).ok().filter(|_| is_angle);
                Some(angle.map(radians).map_or(value.clone(), |shown| DebugValue { shown, ..value }))
            }
        }
    }
}

/// Returns the names and places of a range of elements: `[3]`, `["left"]`.
pub(crate) fn element_places(memory: &Memory, view: View, range: Range<usize>) -> Vec<(String, Place)> {
    let Ok(store) = memory.store(view.store) else { return Vec::new() };
    let place = |number| store.place(view.store, number);
    match &store.shape {
        ContainerShape::Collection(keys) => {
            let page = keys.iter().skip(range.start).take(range.len());
            page.map(|(text, number)| (key(text), place(*number))).collect()
        }
        ContainerShape::Array { dims, sizes } => {
            let numbers = range.filter_map(|number| u32::try_from(number).ok());
            numbers.map(|number| (index(*dims, *sizes, number), place(number + view.start))).collect()
        }
    }
}

/// Returns the number of fields and computed parts of a value.
pub(super) fn fields_of(kind: &ValueType, place: Place) -> usize {
    match &kind.base {
        KindBase::User(_) => kind.fields.len(),
        KindBase::Builtin(base, arm) => fields(*base, *arm).len() + positions::count(*base, place),
    }
}

/// Returns the value, or a text for a value that no longer exists because its library was unloaded or its task has
/// ended.
fn or_gone(name: String, value: impl FnOnce(String) -> Result<DebugValue>) -> DebugValue {
    value(name.clone()).unwrap_or_else(|_| gone(name))
}

pub(super) fn gone(name: String) -> DebugValue {
    let shown = "not in memory".to_owned();
    DebugValue { name, type_name: String::new(), shown, path: None, refers_to: None, inside: None }
}

/// Removes the paths from a value, because the program of the stack frame cannot name it.
fn unseen(value: DebugValue) -> DebugValue {
    let hide = |inside: Inside| Inside { path: ValuePath { prefix: None, ..inside.path }, ..inside };
    DebugValue { path: None, inside: value.inside.map(hide), ..value }
}
