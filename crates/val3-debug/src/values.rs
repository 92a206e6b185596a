//! Variables and their nested values, page by page.

mod look;
mod names;
mod positions;
mod text;

use std::ops::Range;
use std::sync::Arc;

use val3_bytecode::{DataDef, Fragment, FrameVariable, Program};
use val3_lang::call::{Argument, StoredValue as _};
use val3_lang::memory::{ContainerShape, Memory, Place, ValueType, View};
use val3_lang::ports::TaskNumber;
use val3_lang::types::BaseType;
use val3_lang::values::Text;
use val3_machine::controller::Controller;
use val3_machine::devices::Devices;
use val3_vm::{FragmentContext, Frame, InstanceId, Vm};

pub(crate) use look::element_places;
use look::{ItemRange, Look};
use names::AccessNames;
pub use names::subscript;

pub use text::DisplayFormat;
pub(crate) use text::type_name;

/// A variable, a field, or an array or collection element.
#[derive(Debug, Clone, PartialEq)]
pub struct DebugValue {
    /// Name, for example `nCount`, `x`, `[3]`, `["left"]`.
    pub name: String,
    /// Type, including array sizes: `point[4]`.
    pub type_name: String,
    /// Value as VAL 3 writes it; abbreviated for arrays, collections and user types. Inputs, outputs and channels show
    /// their state and link: `true (Io\start)`.
    pub shown: String,
    /// Expression with this value in the scope's stack frame: `aPoints[3].trsf.x`, `lib:nTotal`. `None` if there is no
    /// such expression: for a library's private variable, a global variable hidden by a local one, and computed parts.
    pub path: Option<String>,
    /// Variable to which a parameter by reference refers. For an expression, its variable with constant indexes:
    /// `nMany[3]` for `nMany[nIndex]`.
    pub refers_to: Option<String>,
    /// Handle of the nested values; `None` if there are none.
    pub inside: Option<Inside>,
}

/// Handle of the nested values of a scope or value. It is valid until the controller continues.
#[derive(Debug, Clone, PartialEq)]
pub struct Inside {
    /// Task whose stack may contain the value.
    task: Option<TaskNumber>,
    path: ValuePath,
    node: ValueNode,
}

/// Expression of a value.
#[derive(Debug, Clone, PartialEq)]
struct ValuePath {
    /// Context in which the expression is evaluated.
    context: FragmentContext,
    /// The expression within the context; empty for a scope, `None` for a computed part.
    text: Option<String>,
    /// Prefix with which the text is valid in the stack frame; `None` if the frame cannot name the value.
    prefix: Option<String>,
}

#[derive(Debug, Clone, PartialEq)]
enum ValueNode {
    /// Variables of a stack frame: its parameters, or its locals.
    Frame { depth: usize, are_parameters: bool },
    /// Data of the application or library, as visible to the program in a stack frame: all data, or the data with these
    /// positions in the image.
    Data { owner: InstanceId, of_frame: Option<(TaskNumber, usize)>, chosen: Option<Arc<[usize]>> },
    /// Array or collection elements.
    Values(View),
    /// Fields of a value, and its computed parts.
    Fields(Arc<ValueType>, Place),
    /// Values that were already read.
    Listed(Arc<[DebugValue]>),
}

impl Inside {
    /// Whether the nested values are array or collection elements.
    #[must_use]
    pub const fn is_indexed(&self) -> bool {
        matches!(self.node, ValueNode::Values(_))
    }

    /// Returns the expression of the nested value `name`, and its context. `None` for a computed part, to which nothing
    /// can be assigned.
    #[must_use]
    pub fn expression(&self, name: &str) -> Option<(FragmentContext, String)> {
        let path = self.path.child(name);
        Some((path.context, path.text?))
    }

    /// Application or library whose data a scope contains.
    pub(crate) fn owner(&self) -> Option<InstanceId> {
        match self.node {
            ValueNode::Data { owner, .. } => Some(owner),
            _ => None,
        }
    }

    /// Restricts a scope of data to the data with these positions in the image.
    pub(crate) fn choose(mut self, positions: Arc<[usize]>) -> Self {
        if let ValueNode::Data { chosen, .. } = &mut self.node {
            *chosen = Some(positions);
        }
        self
    }

    /// Returns a handle of the parameters or the locals in a stack frame.
    fn of_frame(task: TaskNumber, depth: usize, are_parameters: bool) -> Self {
        let path = ValuePath {
            context: FragmentContext::Frame(task, depth),
            text: Some(String::new()),
            prefix: Some(String::new()),
        };
        Self { task: Some(task), path, node: ValueNode::Frame { depth, are_parameters } }
    }

    /// Returns a handle of values that were already read.
    fn listed(values: Vec<DebugValue>) -> Option<Self> {
        let path = ValuePath { context: FragmentContext::Instance(InstanceId(0)), text: None, prefix: None };
        (!values.is_empty()).then(|| Self { task: None, path, node: ValueNode::Listed(values.into()) })
    }
}

impl ValuePath {
    /// Returns the path of a nested value.
    fn child(&self, name: &str) -> Self {
        let text = self.text.as_ref().map(|text| match name {
            name if text.is_empty() || name.starts_with('[') => format!("{text}{name}"),
            name => format!("{text}.{name}"),
        });
        Self { text, ..self.clone() }
    }

    /// Returns the expression within the stack frame.
    fn expression(&self) -> Option<String> {
        Some(format!("{}{}", self.prefix.as_ref()?, self.text.as_ref()?))
    }

    /// Returns the path of a computed part.
    fn computed(&self) -> Self {
        Self { text: None, ..self.clone() }
    }
}

/// Variables visible to a program.
#[derive(Debug, Clone)]
pub struct Scope {
    /// Kind of scope.
    pub kind: ScopeKind,
    /// Handle of the variables.
    pub inside: Inside,
}

/// Kinds of scopes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ScopeKind {
    /// Parameters of the program.
    Parameters,
    /// Locals of the program.
    Locals,
    /// Data of the program's application or library.
    Globals,
    /// Data of a library, by its identifier.
    Library(String),
}

/// Returns the scopes of a stack frame; empty if there is no such frame. `depth` 0 is the innermost frame.
#[must_use]
pub fn scopes(vm: &Vm, task: TaskNumber, depth: usize) -> Vec<Scope> {
    let Some(frame) = frame(vm, task, depth) else { return Vec::new() };
    let mut scopes = vec![
        Scope { kind: ScopeKind::Parameters, inside: Inside::of_frame(task, depth, true) },
        Scope { kind: ScopeKind::Locals, inside: Inside::of_frame(task, depth, false) },
        Scope { kind: ScopeKind::Globals, inside: globals(frame.instance, Some((task, depth)), String::new()) },
    ];
    if let Some(instance) = vm.space.instance(frame.instance) {
        let libraries = instance.image.libraries.iter().zip(&instance.libraries);
        scopes.extend(libraries.filter_map(|(library, loaded)| {
            let inside = globals((*loaded)?, None, format!("{}:", library.alias));
            Some(Scope { kind: ScopeKind::Library(library.alias.clone()), inside })
        }));
    }
    scopes
}

/// Returns the data of this application or library, for example if no task exists any more.
#[must_use]
pub fn data(instance: InstanceId) -> Inside {
    globals(instance, None, String::new())
}

fn globals(owner: InstanceId, of_frame: Option<(TaskNumber, usize)>, prefix: String) -> Inside {
    let path = ValuePath { context: FragmentContext::Instance(owner), text: Some(String::new()), prefix: Some(prefix) };
    Inside { task: None, path, node: ValueNode::Data { owner, of_frame, chosen: None } }
}

/// Returns the number of nested values; 0 if they no longer exist.
pub fn count(vm: &mut Vm, inside: &Inside) -> usize {
    match &inside.node {
        ValueNode::Frame { depth, are_parameters } => {
            let program = inside.task.and_then(|task| program(vm, &frame(vm, task, *depth)?));
            program.map_or(0, |program| variables(program, *are_parameters).count())
        }
        ValueNode::Data { chosen: Some(chosen), .. } => chosen.len(),
        ValueNode::Data { owner, .. } => vm.space.instance(*owner).map_or(0, |instance| instance.data.len()),
        ValueNode::Values(view) => vm.space.memory.len(*view).map_or(0, |len| len as usize),
        ValueNode::Fields(kind, place) => look::fields_of(kind, *place),
        ValueNode::Listed(values) => values.len(),
    }
}

/// Returns a range of the nested values.
pub fn values(
    controller: &mut Controller,
    inside: &Inside,
    range: Range<usize>,
    format: DisplayFormat,
) -> Vec<DebugValue> {
    let range = range.start..range.end.min(count(&mut controller.vm, inside));
    let vm = &controller.vm;
    let page = match &inside.node {
        ValueNode::Listed(values) => return values.get(range).unwrap_or_default().to_vec(),
        ValueNode::Frame { depth, are_parameters } => {
            let found = inside.task.and_then(|task| frame(vm, task, *depth));
            let Some((frame, program)) = found.and_then(|frame| Some((frame, program(vm, &frame)?))) else {
                return Vec::new();
            };
            let shown = variables(program, *are_parameters).skip(range.start).take(range.len());
            ItemRange::Variables(frame, shown.cloned().collect())
        }
        ValueNode::Data { owner, of_frame, chosen } => {
            let Some(instance) = vm.space.instance(*owner) else { return Vec::new() };
            let positions = range.map(|number| chosen.as_ref().map_or(Some(number), |all| all.get(number).copied()));
            let shown = positions.filter_map(|at| instance.image.data.get(at?).zip(instance.data.get(at?)));
            let items = shown.map(|(data, id)| (data.name.clone(), is_visible(vm, data, *of_frame), View::whole(*id)));
            ItemRange::Data(items.collect())
        }
        ValueNode::Values(view) => ItemRange::Values(*view, range),
        ValueNode::Fields(kind, place) => ItemRange::Fields(Arc::clone(kind), *place, range),
    };
    let names = AccessNames::of(vm, inside.task, inside.path.context);
    on_stack(controller, inside.task, |memory, devices| {
        let look = Look { task: inside.task, path: &inside.path, names: &names, devices, format };
        look.page(memory, page)
    })
}

/// Compiled code with its text.
#[derive(Clone, Copy)]
pub struct NamedFragment<'f> {
    /// The code.
    pub fragment: &'f Fragment,
    /// Name of the value.
    pub text: &'f str,
}

/// Returns the value of an evaluated expression while it is in memory. If the expression is not a variable, its value
/// is read with all nested values.
pub(crate) fn evaluated(
    memory: &mut Memory,
    devices: &Devices,
    names: &AccessNames,
    context: FragmentContext,
    argument: Argument,
    NamedFragment { fragment, text }: NamedFragment<'_>,
    format: DisplayFormat,
) -> DebugValue {
    let path = ValuePath { context, text: Some(text.to_owned()), prefix: Some(String::new()) };
    let look = Look { task: context.task(), path: &path, names, devices, format };
    let Some(value) = &fragment.value else { return look::gone(text.to_owned()) };
    let shown = look.argument(memory, text, argument, &value.kind);
    if value.is_result() { look.complete(memory, shown) } else { shown }
}

/// Returns the names that a context has for places.
pub(crate) fn names(vm: &Vm, context: FragmentContext) -> AccessNames {
    AccessNames::of(vm, context.task(), context)
}

/// Formats a value.
pub(crate) fn text_of(
    memory: &Memory,
    devices: &Devices,
    kind: &ValueType,
    place: Place,
    format: DisplayFormat,
) -> String {
    text::shown(memory, devices, kind, place, format).unwrap_or_else(|_| "not in memory".to_owned())
}

/// Number of elements that the text for an array or collection shows.
const SHOWN_VALUES: u32 = 8;

/// Formats the first elements of a container in the format [`DisplayFormat::EXACT`].
pub(crate) fn text_of_all(memory: &Memory, devices: &Devices, view: View) -> String {
    let (Ok(store), Ok(count)) = (memory.store(view.store), memory.len(view)) else { return String::new() };
    let numbers: Vec<u32> = match &store.shape {
        ContainerShape::Collection(keys) => keys.values().copied().take(SHOWN_VALUES as usize).collect(),
        ContainerShape::Array { .. } => (view.start..view.start + count.min(SHOWN_VALUES)).collect(),
    };
    let places = numbers.into_iter().map(|number| store.place(view.store, number));
    let texts = places.map(|place| text_of(memory, devices, &store.kind, place, DisplayFormat::EXACT));
    listed(&texts.collect::<Vec<String>>(), count)
}

/// Formats the type of a container, with its sizes: `num[4]`. The type of an array with one element has no size.
pub(crate) fn type_of_all(memory: &Memory, view: View) -> Option<String> {
    let (store, count) = (memory.store(view.store).ok()?, memory.len(view).ok()?);
    let is_single = count == 1 && matches!(store.shape, ContainerShape::Array { .. });
    let sizes = if is_single { String::new() } else { text::sizes(&store.shape, count) };
    Some(type_name(&store.kind) + &sizes)
}

/// Joins the first of `count` elements, given as texts.
fn listed(texts: &[String], count: u32) -> String {
    match (texts, count > SHOWN_VALUES) {
        ([one], false) => one.clone(),
        (some, false) => format!("{{{}}}", some.join(", ")),
        (some, true) => format!("{{{}, …}} of {count} values", some.join(", ")),
    }
}

/// Formats the elements with this first index in a global array, in the application's `instance`: one element, or a row
/// if the array has several dimensions. `None` if there is no such array or row.
#[must_use]
pub fn row_of_data(controller: &Controller, instance: InstanceId, name: &str, row: u32) -> Option<String> {
    let space = &controller.vm.space;
    let instance = space.instance(instance)?;
    let id = *instance.data.get(usize::from(instance.image.data(name)?))?;
    let store = space.memory.store(id).ok()?;
    let ContainerShape::Array { sizes: [rows, second, third], .. } = store.shape else { return None };
    let width = second.saturating_mul(third);
    let first = row.checked_mul(width).filter(|_| row < rows)?;
    let format = DisplayFormat::default();
    let text = |number| text_of(&space.memory, &controller.devices, &store.kind, store.place(id, number), format);
    let texts: Vec<String> = (first..first + width.min(SHOWN_VALUES)).map(text).collect();
    Some(listed(&texts, width))
}

/// Returns the first element of a global string array. `None` if the application `instance` has no string data of this
/// name.
#[must_use]
pub fn string_of_data(controller: &Controller, instance: InstanceId, name: &str) -> Option<String> {
    let space = &controller.vm.space;
    let instance = space.instance(instance)?;
    let id = *instance.data.get(usize::from(instance.image.data(name)?))?;
    let store = space.memory.store(id).ok().filter(|store| store.kind.base_type() == Some(BaseType::String))?;
    Text::read(&space.memory, store.place(id, 0)).ok().map(|text| text.as_str().to_owned())
}

/// Calls a function with the memory while it contains the stack of a task.
fn on_stack<T: Default>(
    controller: &mut Controller,
    task: Option<TaskNumber>,
    look: impl FnOnce(&mut Memory, &Devices) -> T,
) -> T {
    let Controller { vm, devices, .. } = controller;
    match task {
        Some(task) => vm.with_stack(task, |memory| look(memory, devices)).unwrap_or_default(),
        None => look(&mut vm.space.memory, devices),
    }
}

/// Whether the program of a stack frame can name data of its application or library, which a parameter or local may
/// hide. Without a stack frame: whether the data are public.
fn is_visible(vm: &Vm, data: &DataDef, of_frame: Option<(TaskNumber, usize)>) -> bool {
    let Some((task, depth)) = of_frame else { return data.public };
    let program = frame(vm, task, depth).and_then(|frame| program(vm, &frame));
    !program.is_some_and(|program| program.variables.iter().any(|variable| variable.name == data.name))
}

fn frame(vm: &Vm, task: TaskNumber, depth: usize) -> Option<Frame> {
    vm.tasks().iter().find(|known| known.id == task)?.thread.frames.iter().rev().nth(depth).copied()
}

fn program<'v>(vm: &'v Vm, frame: &Frame) -> Option<&'v Program> {
    vm.space.instance(frame.instance)?.image.programs.get(usize::from(frame.program))
}

/// Returns the parameters of a program, or its locals.
fn variables(program: &Program, are_parameters: bool) -> impl Iterator<Item = &FrameVariable> {
    program.variables.iter().filter(move |variable| is_parameter(program, variable) == are_parameters)
}

fn is_parameter(program: &Program, variable: &FrameVariable) -> bool {
    program.params.iter().any(|param| param.name == variable.name)
}
