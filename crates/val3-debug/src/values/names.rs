//! Names of places: which variable a reference refers to.

use std::sync::Arc;

use val3_bytecode::{Image, Storage};
use val3_lang::memory::{Kind, KindBase, Lanes, Memory, Place, Shape, StoreId, View, field_offset};
use val3_lang::ports::TaskNumber;
use val3_lang::types::fields;
use val3_vm::{FragmentContext, Frame, Instance, Vm};

use super::text::{index, key};

/// The containers within user types that are searched at most.
const SEARCHED: usize = 10_000;

/// The names that a program has for data and for the variables of its task.
#[derive(Debug, Default)]
pub(crate) struct Names {
    /// Applications and libraries, with what precedes the names of their data.
    data: Vec<(String, Arc<Image>, Arc<[StoreId]>)>,
    /// The frames of the task, the innermost first.
    frames: Vec<(Frame, Arc<Image>)>,
}

impl Names {
    /// The names in a context. The frames are those of a task.
    pub(super) fn of(vm: &Vm, task: Option<TaskNumber>, context: FragmentContext) -> Self {
        let found = task.and_then(|task| vm.tasks().iter().find(|known| known.id == task));
        let frames = found.into_iter().flat_map(|task| task.thread.frames.iter().rev());
        let frames: Vec<(Frame, Arc<Image>)> =
            frames.filter_map(|frame| Some((*frame, Arc::clone(&vm.space.instance(frame.instance)?.image)))).collect();
        let own = match context {
            FragmentContext::Frame(_, depth) => frames.get(depth).map(|(frame, _)| frame.instance),
            FragmentContext::Instance(instance) => Some(instance),
        };
        let aliases = own.and_then(|own| vm.space.instance(own));
        let prefix = |(id, instance): (_, &Instance)| {
            let loaded = aliases.map(|own| own.image.libraries.iter().zip(&own.libraries)).into_iter().flatten();
            let alias = loaded.filter(|(_, loaded)| **loaded == Some(id)).map(|(library, _)| &library.alias).next();
            let prefix =
                if own == Some(id) { String::new() } else { format!("{}:", alias.unwrap_or(&instance.image.name)) };
            (prefix, Arc::clone(&instance.image), Arc::clone(&instance.data))
        };
        Self { data: vm.space.loaded().map(prefix).collect(), frames }
    }

    /// The name of a value of this type.
    pub(super) fn of_place(&self, memory: &Memory, place: Place, kind: &Kind) -> Option<String> {
        if place.store == StoreId::STACK {
            return self.on_stack(place, kind);
        }
        let store = memory.store(place.store).ok()?;
        let number = number_of(place, store.kind.size)?;
        let start = store.place(place.store, number);
        let field = field_path(&store.kind, lanes_between(start, place)?, kind)?;
        Some(self.of_container(memory, place.store)? + &subscript(&store.shape, number)? + &field)
    }

    /// The name of a container, an array from an index on.
    pub(super) fn of_view(&self, memory: &Memory, view: View) -> Option<String> {
        let name = self.of_container(memory, view.store)?;
        Some(if view.start == 0 { name } else { format!("{name}[{}]", view.start) })
    }

    /// The name of a frame, a tool or another whole value.
    pub(super) fn of_value(&self, memory: &Memory, place: Place) -> Option<String> {
        let kind = Arc::clone(&memory.store(place.store).ok()?.kind);
        self.of_place(memory, place, &kind)
    }

    fn on_stack(&self, place: Place, kind: &Kind) -> Option<String> {
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
        whole.or_else(|| all().find_map(|(name, store)| within(memory, (name, store), id, &mut left)))
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

/// The name of a container within the values of another one.
fn within(memory: &Memory, (name, id): (String, StoreId), wanted: StoreId, left: &mut usize) -> Option<String> {
    let store = memory.store(id).ok()?;
    let KindBase::User(_) = store.kind.base else { return None };
    let width = store.kind.fields.len();
    for (at, part) in store.parts.iter().enumerate() {
        *left = left.checked_sub(1)?;
        let field = store.kind.fields.get(at.checked_rem(width)?)?;
        let found = || {
            let number = u32::try_from(at.checked_div(width)?).ok()?;
            Some(format!("{name}{}.{}", subscript(&store.shape, number)?, field.name))
        };
        if *part == wanted {
            return found();
        }
        if let KindBase::User(_) = field.init.kind.base
            && let Some(found) = within(memory, (found()?, *part), wanted, left)
        {
            return Some(found);
        }
    }
    None
}

/// The subscript of a value by its number among all; empty for a single value.
/// The index or key of a value of data in brackets; empty for an array of one value.
#[must_use]
pub fn subscript(shape: &Shape, number: u32) -> Option<String> {
    match shape {
        Shape::Array { .. } if shape.len() == 1 => Some(String::new()),
        Shape::Array { dims, sizes } => Some(index(*dims, *sizes, number)),
        Shape::Collection(keys) => keys.iter().find(|(_, at)| **at == number).map(|(text, _)| key(text)),
    }
}

/// The number of the value of a container that holds a place.
fn number_of(place: Place, size: Lanes) -> Option<u32> {
    let lanes = [(place.num, size.num), (place.text, size.text), (place.link, size.link), (place.part, size.part)];
    lanes.into_iter().find(|(_, size)| *size > 0).map(|(at, size)| at / size)
}

/// The lanes of a place after another one.
fn lanes_between(start: Place, place: Place) -> Option<Lanes> {
    Some(Lanes {
        num: place.num.checked_sub(start.num)?,
        text: place.text.checked_sub(start.text)?,
        link: place.link.checked_sub(start.link)?,
        part: place.part.checked_sub(start.part)?,
    })
}

/// The way to a part of this type within a value: `.trsf.x`, or nothing for the value itself.
fn field_path(kind: &Kind, offset: Lanes, wanted: &Kind) -> Option<String> {
    if offset == Lanes::default() && kind.suits(wanted) {
        return Some(String::new());
    }
    let KindBase::Builtin(base, arm) = kind.base else { return None };
    fields(base, arm).iter().find_map(|field| {
        let before = field_offset(base, arm, field.name)?;
        let rest = lanes_between(Place::on_stack(before), Place::on_stack(offset))?;
        let inner = field_path(&Kind::builtin(field.ty, arm), rest, wanted)?;
        Some(format!(".{}{inner}", field.name))
    })
}
