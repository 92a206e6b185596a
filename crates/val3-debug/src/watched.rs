//! Watched data: variables, elements, fields and signals that are looked up again after each line.

mod numbers;
mod table;

use std::sync::Arc;

use rustc_hash::FxHashSet;
use val3_bytecode::{FrameVariable, Program, Storage};
use val3_lang::memory::{
    ContainerShape, KindBase, Lanes, LinkPlace, Memory, Place, StoreId, ValueType, View, field_offset,
};
use val3_lang::ports::TaskNumber;
use val3_lang::types::{self, BaseType};
use val3_lang::values::{Text, printed};
use val3_machine::controller::Controller;
use val3_machine::devices::Devices;
use val3_machine::io::{self, IoTable, SignalId};
use val3_vm::{FragmentContext, Frame, FrameOwner, InstanceId, Space, Vm, WatchedValue};

use crate::reads::{ExecutedLine, Extent};
use crate::values;

pub use numbers::{DataForm, NumberSeries};
pub use table::{DataTable, TableRow};

/// A variable, element, field or signal that a data breakpoint watches. It is looked up by its name after each line, so
/// it stays valid while the run continues. A local variable no longer exists after its program has ended.
#[derive(Debug, Clone, PartialEq)]
pub struct WatchedData {
    root: WatchedRoot,
    steps: Vec<NestingStep>,
    id: String,
}

#[derive(Debug, Clone, PartialEq)]
enum WatchedRoot {
    /// Data in an application or library.
    Global { instance: InstanceId, name: String },
    /// Parameter or local of a program on a task's stack; `index` counts from the outermost stack frame.
    Local { task: TaskNumber, index: usize, frame: Frame, name: String },
    /// Input or output.
    Signal(SignalId),
}

/// Step from a value to a nested value.
#[derive(Debug, Clone, PartialEq, Eq)]
enum NestingStep {
    /// Indexes or a key, as data files write them.
    Subscript(String),
    /// Field name.
    Field(String),
}

/// Present location of a watched value.
enum ValueLocation {
    One(Arc<ValueType>, Place),
    All(View),
}

impl ValueLocation {
    /// Returns the container, or the stack.
    const fn store(&self) -> StoreId {
        match self {
            Self::One(_, place) => place.store,
            Self::All(view) => view.store,
        }
    }
}

/// Value of watched data, bit by bit.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Digest {
    bits: Vec<u64>,
    texts: Vec<Text>,
    links: Vec<LinkPlace>,
}

impl WatchedData {
    /// Resolves a data path in a context: `nCount`, `lib:nCount`, `aPoints[3].trsf.x`, `cParts["left"]`. Indexes and
    /// keys are literals. [`DebugValue::path`](crate::DebugValue::path) and [`Inside::expression`](crate::Inside::expression)
    /// return paths of this form.
    ///
    /// # Errors
    /// The reason why there is no such data, for users.
    pub fn new(controller: &mut Controller, context: FragmentContext, path: &str) -> Result<Self, String> {
        let (name, steps) = parse(path).ok_or_else(|| format!("`{path}` is not the name of data"))?;
        let vm = &controller.vm;
        let root = local(vm, context, &name).or_else(|| global(vm, context, &name));
        let root = root.ok_or_else(|| format!("there is no `{name}` here"))?;
        let id = id(vm, &root, path, &name);
        let watched = Self { root, steps, id };
        watched.digest(controller).ok_or_else(|| format!("`{path}` has no value"))?;
        Ok(watched)
    }

    /// Returns an input or output by its path, for example `Io\start`.
    ///
    /// # Errors
    /// There is no such signal.
    pub fn signal(controller: &Controller, path: &str) -> Result<Self, String> {
        let found = controller.devices.state.io.find(path);
        let signal = found.ok_or_else(|| format!("there is no signal `{path}`"))?;
        Ok(Self { root: WatchedRoot::Signal(signal), steps: Vec::new(), id: format!("io:{path}") })
    }

    /// Returns a text that identifies the data within this run: `app:nCount[3].x`, `io:Io\start`, and `main~/0/l_nSum`
    /// for a local of a task's outermost program.
    #[must_use]
    pub fn id(&self) -> &str {
        &self.id
    }

    /// Whether the data exist only until their program ends.
    #[must_use]
    pub const fn is_local(&self) -> bool {
        matches!(self.root, WatchedRoot::Local { .. })
    }

    /// Returns the input or output, if the data are one.
    pub(crate) const fn as_signal(&self) -> Option<SignalId> {
        match self.root {
            WatchedRoot::Signal(signal) => Some(signal),
            WatchedRoot::Global { .. } | WatchedRoot::Local { .. } => None,
        }
    }

    /// Returns the present value; `None` while it is not in memory.
    pub(crate) fn digest(&self, controller: &mut Controller) -> Option<Digest> {
        if let WatchedRoot::Signal(signal) = &self.root {
            let value = controller.devices.state.io.image(*signal)?;
            return Some(Digest { bits: vec![value.to_bits()], ..Digest::default() });
        }
        self.look(controller, |memory, devices, found| {
            let mut digest = Digest::default();
            match found {
                ValueLocation::One(kind, place) => digest.add(memory, devices, &kind, place),
                ValueLocation::All(view) => digest.add_all(memory, devices, view),
            }?;
            Some(digest)
        })
    }

    /// Returns the data for a comparison by the interpreter; `None` for signals, variables linked to signals, elements
    /// of collections, values of user types, and data that are not in memory.
    pub(crate) fn plain(&self, controller: &mut Controller) -> Option<WatchedValue> {
        let variable = Self { steps: Vec::new(), ..self.clone() };
        let store = variable.look(controller, |_, _, found| Some(found.store()))?;
        self.look(controller, |memory, _, found| {
            let container = match store {
                StoreId::STACK => None,
                id => Some((id, memory.store(id).ok()?.shape.clone())),
            };
            let is_collection = matches!(container, Some((_, ContainerShape::Collection(_))));
            if is_collection || found.store() != store {
                return None;
            }
            let (kind, place, count) = match found {
                ValueLocation::One(kind, place) => (kind, place, 1),
                ValueLocation::All(view) => {
                    let store = memory.store(view.store).ok()?;
                    let count = store.shape.len().checked_sub(view.start)?;
                    (Arc::clone(&store.kind), store.place(view.store, view.start), count)
                }
            };
            if matches!(kind.base, KindBase::Builtin(BaseType::Dio | BaseType::Aio, _)) {
                return None;
            }
            let Lanes { num, text, link, part: 0 } = kind.size else { return None };
            let bits = (0..num * count).map(|lane| memory.num(place, lane).ok().map(f64::to_bits));
            let texts = (0..text * count).map(|lane| memory.text(place.after(Lanes::texts(lane))).ok().copied());
            let links = (0..link * count).map(|lane| memory.link(place, lane).ok()).collect::<Option<_>>()?;
            let (bits, texts) = (bits.collect::<Option<_>>()?, texts.collect::<Option<_>>()?);
            Some(WatchedValue { owner: self.owner(), container, place, bits, texts, links })
        })
    }

    /// Whether the stack frame of a local variable exists; `true` for other data. The frame of another call of the program
    /// by the same line is equal.
    pub(crate) fn has_frame(&self, controller: &Controller) -> bool {
        let Some(FrameOwner { task, index, frame }) = self.owner() else { return true };
        let found = controller.vm.tasks().iter().find(|known| known.id == task);
        found.is_some_and(|task| task.thread.frames.get(index) == Some(&frame))
    }

    /// Returns the stack frame of a local variable.
    pub(crate) const fn owner(&self) -> Option<FrameOwner> {
        match self.root {
            WatchedRoot::Local { task, index, frame, .. } => Some(FrameOwner { task, index, frame }),
            WatchedRoot::Global { .. } | WatchedRoot::Signal(_) => None,
        }
    }

    /// Formats the present value.
    pub(crate) fn text(&self, controller: &mut Controller) -> String {
        if let WatchedRoot::Signal(signal) = &self.root {
            return signal_text(&controller.devices.state.io, *signal);
        }
        let text = self.look(controller, |memory, devices, found| {
            Some(match found {
                ValueLocation::One(kind, place) => {
                    values::text_of(memory, devices, &kind, place, values::DisplayFormat::EXACT)
                }
                ValueLocation::All(view) => values::text_of_all(memory, devices, view),
            })
        });
        text.unwrap_or_else(|| "not in memory".to_owned())
    }

    /// Returns the containers and lanes of the data; `None` while they are not in memory, and for a signal.
    fn extent(&self, controller: &mut Controller) -> Option<Extent> {
        self.look(controller, |memory, _, found| {
            let mut extent = Extent::default();
            match found {
                ValueLocation::One(kind, place) if place.store == StoreId::STACK => {
                    let start = Lanes { num: place.num, text: place.text, link: place.link, part: place.part };
                    extent = Extent::on_stack(start, kind.size);
                    for part in 0..kind.size.part {
                        add_stores(memory, memory.part(place, part).ok()?, &mut extent.stores);
                    }
                }
                ValueLocation::One(_, place) => add_stores(memory, place.store, &mut extent.stores),
                ValueLocation::All(view) => add_stores(memory, view.store, &mut extent.stores),
            }
            Some(extent)
        })
    }

    /// Returns the links of the data, by element, if they are inputs, outputs, serial lines or tools with a gripper
    /// output; otherwise an empty list.
    pub(crate) fn ports(&self, controller: &mut Controller) -> Vec<(BaseType, LinkPlace)> {
        let ports = self.look(controller, |memory, _, found| {
            Some(match found {
                ValueLocation::One(kind, place) => port_link(memory, &kind, place).into_iter().collect(),
                ValueLocation::All(view) => {
                    let store = memory.store(view.store).ok()?;
                    let numbers = store.shape.numbers().into_iter().skip(view.start as usize);
                    let places = numbers.map(|number| store.place(view.store, number));
                    places.filter_map(|place| port_link(memory, &store.kind, place)).collect()
                }
            })
        });
        ports.unwrap_or_default()
    }

    /// Whether a line that the task has executed reads the data.
    pub(crate) fn is_read(&self, controller: &mut Controller, task: TaskNumber, frame: Frame, op: u32) -> bool {
        let Some(extent) = self.extent(controller) else { return false };
        let vm = &mut controller.vm;
        let Some(instance) = vm.space.instance(frame.instance).cloned() else { return false };
        let Some(program) = instance.image.programs.get(usize::from(frame.program)) else { return false };
        let line = program.line_of(op).and_then(|line| program.lines.get(line)).map_or(op, |line| line.op);
        // The line before a closing keyword has already ended: its reads were found at the stop before the keyword.
        if program.closings.iter().any(|closing| closing.op == op) {
            return false;
        }
        // The next iteration in a `for` is a separate operation.
        let op = if program.code.get(op as usize).is_some_and(|step| step.mark.begins_line()) { op } else { line };
        let (instance, frame) = (&instance, &frame);
        let reads = |memory: &Memory| ExecutedLine { instance, program, frame, op, memory }.reads(&extent);
        vm.with_stack(task, |memory| reads(memory)).unwrap_or_else(|| reads(&vm.space.memory))
    }

    fn look<T>(
        &self,
        controller: &mut Controller,
        look: impl FnOnce(&Memory, &Devices, ValueLocation) -> Option<T>,
    ) -> Option<T> {
        let Controller { vm, devices, .. } = controller;
        match &self.root {
            WatchedRoot::Global { instance, name } => {
                let instance = vm.space.instance(*instance).filter(|instance| instance.loaded)?;
                let store = *instance.data.get(usize::from(instance.image.data(name)?))?;
                let memory = &vm.space.memory;
                let found = follow(memory, ValueLocation::All(View::whole(store)), &self.steps)?;
                look(memory, devices, found)
            }
            WatchedRoot::Local { task, index, frame, name } => {
                let thread = &vm.tasks().iter().find(|known| known.id == *task)?.thread;
                thread.frames.get(*index).filter(|known| *known == frame)?;
                let variable = variable(&vm.space, frame, name)?.clone();
                let looked = vm.with_stack(*task, |memory| {
                    let found = follow(memory, start(memory, frame, &variable)?, &self.steps)?;
                    look(memory, devices, found)
                });
                looked.flatten()
            }
            WatchedRoot::Signal(_) => None,
        }
    }
}

/// Adds a container and all containers within its values.
fn add_stores(memory: &Memory, id: StoreId, stores: &mut FxHashSet<StoreId>) {
    if let Ok(store) = memory.store(id)
        && stores.insert(id)
    {
        store.parts.iter().for_each(|part| add_stores(memory, *part, stores));
    }
}

fn global(vm: &Vm, context: FragmentContext, name: &str) -> Option<WatchedRoot> {
    let own = match context {
        FragmentContext::Frame(task, depth) => frame(vm, task, depth)?.1.instance,
        FragmentContext::Instance(instance) => instance,
    };
    let (instance, name) = match name.split_once(':') {
        None => (own, name),
        Some((alias, name)) => {
            let own = vm.space.instance(own)?;
            let at = own.image.libraries.iter().position(|library| library.alias == alias)?;
            ((*own.libraries.get(at)?)?, name)
        }
    };
    vm.space.instance(instance)?.image.data(name)?;
    Some(WatchedRoot::Global { instance, name: name.to_owned() })
}

fn local(vm: &Vm, context: FragmentContext, name: &str) -> Option<WatchedRoot> {
    let FragmentContext::Frame(task, depth) = context else { return None };
    let (index, frame) = frame(vm, task, depth)?;
    variable(&vm.space, &frame, name)?;
    Some(WatchedRoot::Local { task, index, frame, name: name.to_owned() })
}

fn frame(vm: &Vm, task: TaskNumber, depth: usize) -> Option<(usize, Frame)> {
    let frames = &vm.tasks().iter().find(|known| known.id == task)?.thread.frames;
    let index = frames.len().checked_sub(depth + 1)?;
    Some((index, *frames.get(index)?))
}

fn variable<'s>(space: &'s Space, frame: &Frame, name: &str) -> Option<&'s FrameVariable> {
    let program: &Program = space.instance(frame.instance)?.image.programs.get(usize::from(frame.program))?;
    program.variables.iter().find(|variable| variable.name == name)
}

fn id(vm: &Vm, root: &WatchedRoot, path: &str, name: &str) -> String {
    let steps = path.get(name.len()..).unwrap_or_default();
    match root {
        WatchedRoot::Global { instance, name } => {
            let owner = vm.space.instance(*instance).map_or("", |instance| &instance.image.name);
            format!("{owner}:{name}{steps}")
        }
        WatchedRoot::Local { task, index, name, .. } => {
            let known = vm.tasks().iter().find(|known| known.id == *task);
            format!("{}/{index}/{name}{steps}", known.map_or("", |known| &known.name))
        }
        WatchedRoot::Signal(_) => path.to_owned(),
    }
}

fn signal_text(table: &IoTable, signal: SignalId) -> String {
    let is_digital = table.signal(signal).is_some_and(|signal| matches!(signal.kind, io::SignalKind::Digital));
    match table.image(signal) {
        Some(value) if is_digital => printed::bool(value != 0.0).to_owned(),
        Some(value) => printed::num(value).to_string(),
        None => String::new(),
    }
}

/// Splits a data path into the name with its library, and the steps after it.
fn parse(path: &str) -> Option<(String, Vec<NestingStep>)> {
    let end = path.find(['.', '[']).unwrap_or(path.len());
    let (name, mut rest) = path.split_at_checked(end)?;
    let mut steps = Vec::new();
    while !rest.is_empty() {
        if let Some(field) = rest.strip_prefix('.') {
            let end = field.find(['.', '[']).unwrap_or(field.len());
            let (name, after) = field.split_at_checked(end)?;
            steps.push(NestingStep::Field(name.to_owned()));
            rest = after;
        } else {
            let (subscript, after) = subscript(rest.strip_prefix('[')?)?;
            steps.push(NestingStep::Subscript(subscript));
            rest = after;
        }
    }
    (!name.is_empty()).then(|| (name.to_owned(), steps))
}

/// Splits the text after `[` into the indexes or key, and the rest after the closing bracket.
fn subscript(text: &str) -> Option<(String, &str)> {
    if !text.starts_with('"') {
        let (indexes, rest) = text.split_once(']')?;
        return Some((indexes.to_owned(), rest));
    }
    let mut key = String::new();
    let mut rest = text;
    loop {
        let (part, after) = rest.strip_prefix('"')?.split_once('"')?;
        key.push_str(part);
        match (after.strip_prefix("+chr(34)+"), after.strip_prefix(']')) {
            (Some(more), _) => {
                key.push('"');
                rest = more;
            }
            (None, Some(after)) => return Some((key, after)),
            (None, None) => return None,
        }
    }
}

fn start(memory: &Memory, frame: &Frame, variable: &FrameVariable) -> Option<ValueLocation> {
    let stack = &memory.stack;
    let base = &frame.base;
    let one = |place| ValueLocation::One(Arc::clone(&variable.kind), place);
    match variable.storage {
        Storage::Value(lanes) => Some(one(frame.place(lanes))),
        Storage::Place(number) => stack.places.get(base.place as usize + usize::from(number)).copied().map(one),
        Storage::Part(number) => {
            let part = stack.parts.get(base.part as usize + usize::from(number)).copied();
            part.map(|part| ValueLocation::All(View::whole(part)))
        }
        Storage::View(number) => {
            stack.views.get(base.view as usize + usize::from(number)).copied().map(ValueLocation::All)
        }
    }
}

fn follow(memory: &Memory, start: ValueLocation, steps: &[NestingStep]) -> Option<ValueLocation> {
    steps.iter().try_fold(start, |found, step| match (found, step) {
        (ValueLocation::All(view), NestingStep::Subscript(at)) => {
            let store = memory.store(view.store).ok()?;
            let number = store.number_of_text(at)?.checked_add(view.start)?;
            let is_there = matches!(store.shape, ContainerShape::Collection(_)) || number < store.shape.len();
            is_there.then(|| ValueLocation::One(Arc::clone(&store.kind), store.place(view.store, number)))
        }
        (ValueLocation::All(view), NestingStep::Field(name)) => {
            let kind = Arc::clone(&memory.store(view.store).ok()?.kind);
            field(memory, &kind, memory.element(view, 0).ok()?, name)
        }
        (ValueLocation::One(kind, place), NestingStep::Field(name)) => field(memory, &kind, place, name),
        (ValueLocation::One(..), NestingStep::Subscript(_)) => None,
    })
}

fn field(memory: &Memory, kind: &ValueType, place: Place, name: &str) -> Option<ValueLocation> {
    match &kind.base {
        KindBase::User(_) => {
            let number = kind.fields.iter().position(|field| field.name == name)?;
            Some(ValueLocation::All(View::whole(memory.part(place, u32::try_from(number).ok()?).ok()?)))
        }
        KindBase::Builtin(base, arm) => {
            let field = types::field(*base, *arm, name)?;
            let offset = field_offset(*base, *arm, name)?;
            Some(ValueLocation::One(Arc::new(ValueType::builtin(field.ty, *arm)), place.after(offset)))
        }
    }
}

impl Digest {
    fn add(&mut self, memory: &Memory, devices: &Devices, kind: &ValueType, place: Place) -> Option<()> {
        for lane in 0..kind.size.num {
            self.bits.push(memory.num(place, lane).ok()?.to_bits());
        }
        for lane in 0..kind.size.text {
            self.texts.push(*memory.text(place.after(Lanes { text: lane, ..Default::default() })).ok()?);
        }
        for lane in 0..kind.size.link {
            let link = memory.link(place, lane).ok()?;
            self.links.push(link);
            self.bits.push(state(devices, kind, link));
        }
        for part in 0..kind.size.part {
            self.add_all(memory, devices, View::whole(memory.part(place, part).ok()?))?;
        }
        Some(())
    }

    fn add_all(&mut self, memory: &Memory, devices: &Devices, view: View) -> Option<()> {
        let store = memory.store(view.store).ok()?;
        self.bits.push(u64::from(store.shape.len()));
        match &store.shape {
            ContainerShape::Collection(keys) => {
                self.texts.extend(keys.keys().copied());
                keys.values()
                    .try_for_each(|number| self.add(memory, devices, &store.kind, store.place(view.store, *number)))
            }
            ContainerShape::Array { sizes, .. } => {
                self.bits.extend(sizes.map(u64::from));
                (view.start..store.shape.len())
                    .try_for_each(|number| self.add(memory, devices, &store.kind, store.place(view.store, number)))
            }
        }
    }
}

/// Returns the link of an input, output or serial line, or of a tool's gripper output; `None` for a value of any other
/// type.
fn port_link(memory: &Memory, kind: &ValueType, place: Place) -> Option<(BaseType, LinkPlace)> {
    match kind.base {
        KindBase::Builtin(base @ (BaseType::Dio | BaseType::Aio | BaseType::Sio), _) => {
            Some((base, memory.link(place, 0).ok()?))
        }
        KindBase::Builtin(base @ BaseType::Tool, arm) => {
            let field = types::fields(base, arm).iter().find(|field| field.ty == BaseType::Dio)?;
            let link = memory.link(place.after(field_offset(base, arm, field.name)?), 0).ok()?;
            Some((BaseType::Dio, link))
        }
        _ => None,
    }
}

/// Returns the state of the linked input or output, as bits.
fn state(devices: &Devices, kind: &ValueType, link: LinkPlace) -> u64 {
    let LinkPlace::Port(port) = link else { return 0 };
    match kind.base {
        KindBase::Builtin(BaseType::Dio, _) => devices.digital(port).map_or(u64::MAX, u64::from),
        KindBase::Builtin(BaseType::Aio, _) => devices.analog(port).map_or(u64::MAX, f64::to_bits),
        _ => 0,
    }
}
