//! Names of places: the variable to which a reference refers.

use std::sync::Arc;

use val3_bytecode::{Image, Storage};
use val3_lang::memory::{ContainerShape, KindBase, Lanes, Memory, Place, StoreId, ValueType, View, field_offset};
use val3_lang::ports::TaskNumber;
use val3_lang::types::fields;
use val3_vm::{FragmentContext, Frame, Instance, InstanceId, Vm};

use super::text::{index, key};

/// Largest number of containers within user types that are searched.
const SEARCHED: usize = 10_000;

/// Names by which a program accesses data and its task's variables.
#[derive(Debug, Default)]
pub(crate) struct AccessNames {
    /// Applications and libraries, each with the prefix for its data names.
    data: Vec<(String, Arc<Image>, Arc<[StoreId]>)>,
    /// Stack frames of the task, the innermost first.
    frames: Vec<(Frame, Arc<Image>)>,
}

impl AccessNames {
    /// Returns the names in a context, with the stack frames of a task.
    pub(super) fn of(vm: &Vm, task: Option<TaskNumber>, context: FragmentContext) -> Self {
        let found = task.and_then(|task| vm.tasks().iter().find(|known| known.id == task));
        let frames = found.into_iter().flat_map(|task| task.thread.frames.iter().rev());
        let frames: Vec<(Frame, Arc<Image>)> =
            frames.filter_map(|frame| Some((*frame, Arc::clone(&vm.space.instance(frame.instance)?.image)))).collect();
        let own = match context {
            FragmentContext::Frame(_, depth) => frames.get(depth).map(|(frame, _)| frame.instance),
            FragmentContext::Instance(instance) => Some(instance),
        };
        let loaded = vm.space.loaded();
        let data = loaded.map(|(id, instance)| {
            (prefix(vm, own, id, instance), Arc::clone(&instance.image), Arc::clone(&instance.data))
        });
        Self { data: data.collect(), frames }
    }

    /// Returns the name for a value with this type.
    pub(super) fn of_place(&self, memory: &Memory, place: Place, kind: &ValueType) -> Option<String> {
        if place.store == StoreId::STACK {
            return self.on_stack(place, kind);
        }
        let place = memory.present(place).ok()?;
        let store = memory.store(place.store).ok()?;
        let number = number_of(place, store.kind.size)?;
        let start = store.place(place.store, number);
        let field = field_path(&store.kind, lanes_between(start, place)?, kind)?;
        Some(self.of_container(memory, place.store)? + &subscript(&store.shape, number)? + &field)
    }

    /// Returns the name for a container, or for an array from an index on.
    pub(super) fn of_view(&self, memory: &Memory, view: View) -> Option<String> {
        let name = self.of_container(memory, view.store)?;
        Some(if view.start == 0 { name } else { format!("{name}[{}]", view.start) })
    }

    /// Returns the name of a frame, tool or other complete value.
    pub(super) fn of_value(&self, memory: &Memory, place: Place) -> Option<String> {
        let kind = Arc::clone(&memory.store(place.store).ok()?.kind);
        self.of_place(memory, place, &kind)
    }

    fn on_stack(&self, place: Place, kind: &ValueType) -> Option<String> {
        self.frames.iter().find_map(|(frame, image)| {
            let program = image.programs.get(usize::from(frame.program))?;
            program.variables.iter().find_map(|variable| {
                let Storage::Value(lanes) = variable.storage else { return None };
                let between = lanes_between(frame.place(lanes), place)?;
                Some(variable.name.clone() + &field_path(&variable.kind, between, kind)?)
            })
        })
    }

    fn of_container(&self, memory: &Memory, id: StoreId) -> Option<String> {
        match id {
            Memory::WORLD => return Some("world".to_owned()),
            Memory::FLANGE => return Some("flange".to_owned()),
            _ => {}
        }
        let mut left = SEARCHED;
        let all = || self.of_data().chain(self.of_frames(memory));
        let whole = all().find(|(_, store)| *store == id).map(|(name, _)| name);
        whole.or_else(|| all().find_map(|(name, store)| within(memory, name, store, id, &mut left)))
    }

    fn of_data(&self) -> impl Iterator<Item = (String, StoreId)> {
        self.data.iter().flat_map(|(prefix, image, stores)| {
            let named = image.data.iter().zip(stores.iter());
            named.map(move |(data, store)| (format!("{prefix}{}", data.name), *store))
        })
    }

    fn of_frames<'a>(&'a self, memory: &'a Memory) -> impl Iterator<Item = (String, StoreId)> + 'a {
        self.frames.iter().flat_map(move |(frame, image)| {
            let program = image.programs.get(usize::from(frame.program));
            let variables = program.into_iter().flat_map(|program| &program.variables);
            variables.filter_map(move |variable| {
                let Storage::Part(number) = variable.storage else { return None };
                let part = memory.stack.parts.get(frame.base.part as usize + usize::from(number));
                Some((variable.name.clone(), *part?))
            })
        })
    }
}

/// Returns the prefix with which `own` names data of an application or library: none for its own data, otherwise the
/// library identifier, or the library name if `own` does not use the library.
fn prefix(vm: &Vm, own: Option<InstanceId>, id: InstanceId, instance: &Instance) -> String {
    if own == Some(id) {
        return String::new();
    }
    let user = own.and_then(|own| vm.space.instance(own));
    let bound = user.map(|own| own.image.libraries.iter().zip(&own.libraries)).into_iter().flatten();
    let alias = bound.filter(|(_, loaded)| **loaded == Some(id)).map(|(library, _)| &library.alias).next();
    format!("{}:", alias.unwrap_or(&instance.image.name))
}

/// Returns the name of a container that is nested in the values of container `id`.
fn within(memory: &Memory, name: String, id: StoreId, wanted: StoreId, left: &mut usize) -> Option<String> {
    let store = memory.store(id).ok()?;
    let KindBase::User(_) = store.kind.base else { return None };
    let width = store.kind.fields.len();
    for (at, part) in store.parts.iter().enumerate() {
        *left = left.checked_sub(1)?;
        let field = store.kind.fields.get(at.checked_rem(width)?)?;
        let is_nested = matches!(field.init.kind.base, KindBase::User(_));
        if *part != wanted && !is_nested {
            continue;
        }
        let number = u32::try_from(at.checked_div(width)?).ok()?;
        let name = format!("{name}{}.{}", subscript(&store.shape, number)?, field.name);
        if *part == wanted {
            return Some(name);
        }
        if let Some(found) = within(memory, name, *part, wanted, left) {
            return Some(found);
        }
    }
    None
}

/// Returns the index or key in brackets for the container's value `number`; empty for an array with one value.
#[must_use]
pub fn subscript(shape: &ContainerShape, number: u32) -> Option<String> {
    match shape {
        ContainerShape::Array { .. } if shape.len() == 1 => Some(String::new()),
        ContainerShape::Array { dims, sizes } => Some(index(*dims, *sizes, number)),
        ContainerShape::Collection(keys) => keys.iter().find(|(_, at)| **at == number).map(|(text, _)| key(text)),
    }
}

/// Returns the number of the container's value that contains the place.
fn number_of(place: Place, size: Lanes) -> Option<u32> {
    let lanes = [(place.num, size.num), (place.text, size.text), (place.link, size.link), (place.part, size.part)];
    lanes.into_iter().find(|(_, size)| *size > 0).map(|(at, size)| at / size)
}

/// Returns the offset of `place` from `start`, in lanes.
fn lanes_between(start: Place, place: Place) -> Option<Lanes> {
    Some(Lanes {
        num: place.num.checked_sub(start.num)?,
        text: place.text.checked_sub(start.text)?,
        link: place.link.checked_sub(start.link)?,
        part: place.part.checked_sub(start.part)?,
    })
}

/// Returns the field path of a part with this type and offset: `.trsf.x`, or empty for the value itself.
fn field_path(kind: &ValueType, offset: Lanes, wanted: &ValueType) -> Option<String> {
    if offset == Lanes::default() && kind.suits(wanted) {
        return Some(String::new());
    }
    let KindBase::Builtin(base, arm) = kind.base else { return None };
    fields(base, arm).iter().find_map(|field| {
        let before = field_offset(base, arm, field.name)?;
        let rest = lanes_between(Place::on_stack(before), Place::on_stack(offset))?;
        let inner = field_path(&ValueType::builtin(field.ty, arm), rest, wanted)?;
        Some(format!(".{}{inner}", field.name))
    })
}
