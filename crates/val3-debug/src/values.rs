//! Variables and what is inside them, page by page.

mod look;
mod names;
mod positions;
mod text;

use std::ops::Range;
use std::sync::Arc;

use val3_bytecode::{DataDef, Fragment, Program, Variable};
use val3_lang::call::{Argument, StoredValue as _};
use val3_lang::memory::{Kind, Memory, Place, Shape, View};
use val3_lang::ports::TaskNumber;
use val3_lang::types::BaseType;
use val3_lang::values::Text;
use val3_machine::controller::Controller;
use val3_machine::devices::Devices;
use val3_vm::{FragmentContext, Frame, InstanceId, Vm};

use look::{Look, Page};
use names::Names;
pub use names::subscript;

pub use text::Format;

/// A variable, a field, or a value of an array or collection.
#[derive(Debug, Clone, PartialEq)]
pub struct Value {
    /// `nCount`, `x`, `[3]`, `["left"]`.
    pub name: String,
    /// Its type, with the sizes of an array: `point[4]`.
    pub type_name: String,
    /// Its value as VAL 3 writes it. Of an array, a collection and a user type in short. Inputs, outputs and lines have
    /// their state and their link: `true (Io\start)`.
    pub shown: String,
    /// The expression that yields it in the frame of its scope: `aPoints[3].trsf.x`, `lib:nTotal`. `None` where there is
    /// none: a private variable of a library, a global variable that a local one hides, a part that is computed.
    pub path: Option<String>,
    /// The variable that a parameter by reference refers to. Of an expression the variable that it names in another way:
    /// `nMany[3]` for `nMany[nIndex]`.
    pub refers_to: Option<String>,
    /// How to look inside; `None` where there is nothing inside.
    pub inside: Option<Inside>,
}

/// How to look inside of a scope or a value. It holds until the controller runs on.
#[derive(Debug, Clone, PartialEq)]
pub struct Inside {
    /// The task on whose stack the value may be.
    task: Option<TaskNumber>,
    path: Path,
    node: Node,
}

/// The way to a value.
#[derive(Debug, Clone, PartialEq)]
struct Path {
    /// Where it is evaluated.
    context: FragmentContext,
    /// The expression in the context; empty for a scope, `None` for a part that is computed.
    text: Option<String>,
    /// The prefix for an expression of the frame; `None` if the frame cannot name it.
    prefix: Option<String>,
}

#[derive(Debug, Clone, PartialEq)]
enum Node {
    /// The variables of a frame: its parameters, or its locals.
    Frame { depth: usize, are_parameters: bool },
    /// The data of an application or library, as the program of a frame sees them.
    Data(InstanceId, Option<(TaskNumber, usize)>),
    /// The values of an array or collection.
    Values(View),
    /// The fields of a value, and what is computed of it.
    Fields(Arc<Kind>, Place),
    /// Values that are listed already.
    Listed(Arc<[Value]>),
}

impl Inside {
    /// Whether the values are those of an array or collection.
    #[must_use]
    pub const fn is_indexed(&self) -> bool {
        matches!(self.node, Node::Values(_))
    }

    /// The expression that yields the child called `name`, and the context in which it does. `None` for a part that is
    /// computed, which cannot be assigned to.
    #[must_use]
    pub fn expression(&self, name: &str) -> Option<(FragmentContext, String)> {
        let path = self.path.child(name);
        Some((path.context, path.text?))
    }

    /// The values inside of something that is read already.
    fn listed(values: Vec<Value>) -> Option<Self> {
        let path = Path { context: FragmentContext::Instance(InstanceId(0)), text: None, prefix: None };
        (!values.is_empty()).then(|| Self { task: None, path, node: Node::Listed(values.into()) })
    }
}

impl Path {
    /// The path of a value inside of this one.
    fn child(&self, name: &str) -> Self {
        let text = self.text.as_ref().map(|text| match name {
            name if text.is_empty() || name.starts_with('[') => format!("{text}{name}"),
            name => format!("{text}.{name}"),
        });
        Self { text, ..self.clone() }
    }

    /// The expression that the frame has for it.
    fn expression(&self) -> Option<String> {
        Some(format!("{}{}", self.prefix.as_ref()?, self.text.as_ref()?))
    }

    /// A part that is computed.
    fn computed(&self) -> Self {
        Self { text: None, ..self.clone() }
    }
}

/// Variables that a program sees.
#[derive(Debug, Clone)]
pub struct Scope {
    /// The kind.
    pub kind: ScopeKind,
    /// The variables.
    pub inside: Inside,
}

/// The variables of a scope.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ScopeKind {
    /// Parameters of the program.
    Parameters,
    /// Its locals.
    Locals,
    /// The data of its application or library.
    Globals,
    /// The data of a library, by its identifier.
    Library(String),
}

/// The scopes of a frame; 0 is the innermost. None if there is no such frame.
#[must_use]
pub fn scopes(vm: &Vm, task: TaskNumber, depth: usize) -> Vec<Scope> {
    let Some(frame) = frame(vm, task, depth) else { return Vec::new() };
    let of_frame = |are_parameters| {
        let path = Path {
            context: FragmentContext::Frame(task, depth),
            text: Some(String::new()),
            prefix: Some(String::new()),
        };
        Inside { task: Some(task), path, node: Node::Frame { depth, are_parameters } }
    };
    let mut scopes = vec![
        Scope { kind: ScopeKind::Parameters, inside: of_frame(true) },
        Scope { kind: ScopeKind::Locals, inside: of_frame(false) },
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

/// The data of an application or library, for example where no task is left.
#[must_use]
pub fn data(instance: InstanceId) -> Inside {
    globals(instance, None, String::new())
}

fn globals(instance: InstanceId, frame: Option<(TaskNumber, usize)>, prefix: String) -> Inside {
    let path = Path { context: FragmentContext::Instance(instance), text: Some(String::new()), prefix: Some(prefix) };
    Inside { task: None, path, node: Node::Data(instance, frame) }
}

/// How many values are inside; 0 where they are gone.
pub fn count(vm: &mut Vm, inside: &Inside) -> usize {
    match &inside.node {
        Node::Frame { depth, are_parameters } => {
            let program = inside.task.and_then(|task| program(vm, &frame(vm, task, *depth)?));
            program.map_or(0, |program| variables(program, *are_parameters).count())
        }
        Node::Data(instance, _) => vm.space.instance(*instance).map_or(0, |instance| instance.data.len()),
        Node::Values(view) => vm.space.memory.len(*view).map_or(0, |len| len as usize),
        Node::Fields(kind, place) => look::fields_of(kind, *place),
        Node::Listed(values) => values.len(),
    }
}

/// The values inside, from a range of their numbers.
pub fn values(controller: &mut Controller, inside: &Inside, range: Range<usize>, format: Format) -> Vec<Value> {
    let range = range.start..range.end.min(count(&mut controller.vm, inside));
    let vm = &controller.vm;
    let page = match &inside.node {
        Node::Listed(values) => return values.get(range).unwrap_or_default().to_vec(),
        Node::Frame { depth, are_parameters } => {
            let found = inside.task.and_then(|task| frame(vm, task, *depth));
            let Some((frame, program)) = found.and_then(|frame| Some((frame, program(vm, &frame)?))) else {
                return Vec::new();
            };
            let shown = variables(program, *are_parameters).skip(range.start).take(range.len());
            Page::Variables(frame, shown.cloned().collect())
        }
        Node::Data(instance, of_frame) => {
            let Some(instance) = vm.space.instance(*instance) else { return Vec::new() };
            let hidden = of_frame.and_then(|(task, depth)| program(vm, &frame(vm, task, depth)?));
            let is_hidden = |name: &str| {
                hidden.is_some_and(|program| program.variables.iter().any(|variable| variable.name == name))
            };
            let is_seen = |data: &DataDef| if of_frame.is_some() { !is_hidden(&data.name) } else { data.public };
            let shown = instance.image.data.iter().zip(instance.data.iter()).skip(range.start).take(range.len());
            Page::Data(shown.map(|(data, id)| (data.name.clone(), is_seen(data), View::whole(*id))).collect())
        }
        Node::Values(view) => Page::Values(*view, range),
        Node::Fields(kind, place) => Page::Fields(Arc::clone(kind), *place, range),
    };
    let names = Names::of(vm, inside.task, inside.path.context);
    on_stack(controller, inside.task, |memory, devices| {
        let look = Look { task: inside.task, path: &inside.path, names: &names, devices, format };
        look.page(memory, page)
    })
}

/// The value of an expression that was evaluated in a context, while it is in the memory. One that is no variable is read
/// with all that is inside.
pub(crate) fn evaluated(
    (memory, devices): (&mut Memory, &Devices),
    (names, context): (&Names, FragmentContext),
    (argument, fragment): (Argument, &Fragment),
    (text, format): (&str, Format),
) -> Value {
    let path = Path { context, text: Some(text.to_owned()), prefix: Some(String::new()) };
    let look = Look { task: context.task(), path: &path, names, devices, format };
    let Some(value) = &fragment.value else { return look::gone(text.to_owned()) };
    let shown = look.argument(memory, text, argument, &value.kind);
    if value.is_result() { look.complete(memory, shown) } else { shown }
}

/// The names that a context has for places.
pub(crate) fn names(vm: &Vm, context: FragmentContext) -> Names {
    Names::of(vm, context.task(), context)
}

/// A value as text.
pub(crate) fn text_of(memory: &Memory, devices: &Devices, kind: &Kind, place: Place) -> String {
    text::shown(memory, devices, (kind, place), Format::default()).unwrap_or_else(|_| "not in memory".to_owned())
}

/// Values that the text of an array or collection shows.
const SHOWN_VALUES: u32 = 8;

/// The values of a container as text: the first ones of several.
pub(crate) fn text_of_all(memory: &Memory, devices: &Devices, view: View) -> String {
    let (Ok(store), Ok(count)) = (memory.store(view.store), memory.len(view)) else { return String::new() };
    let numbers: Vec<u32> = match &store.shape {
        Shape::Collection(keys) => keys.values().copied().take(SHOWN_VALUES as usize).collect(),
        Shape::Array { .. } => (view.start..view.start + count.min(SHOWN_VALUES)).collect(),
    };
    let text = |number: u32| text_of(memory, devices, &store.kind, store.place(view.store, number));
    listed(&numbers.into_iter().map(text).collect::<Vec<String>>(), count)
}

/// The first of `count` values as one text.
fn listed(texts: &[String], count: u32) -> String {
    match (texts, count > SHOWN_VALUES) {
        ([one], false) => one.clone(),
        (some, false) => format!("{{{}}}", some.join(", ")),
        (some, true) => format!("{{{}, …}} of {count} values", some.join(", ")),
    }
}

/// The values with this first index of a global array as text, as a program of the application `instance` sees them: one
/// value, or those of a row of an array with several dimensions. `None` if there is no such array or row.
#[must_use]
pub fn row_of_data(controller: &Controller, instance: InstanceId, name: &str, row: u32) -> Option<String> {
    let space = &controller.vm.space;
    let instance = space.instance(instance)?;
    let id = *instance.data.get(usize::from(instance.image.data(name)?))?;
    let store = space.memory.store(id).ok()?;
    let Shape::Array { sizes: [rows, second, third], .. } = store.shape else { return None };
    let width = second.saturating_mul(third);
    let first = row.checked_mul(width).filter(|_| row < rows)?;
    let text = |number| text_of(&space.memory, &controller.devices, &store.kind, store.place(id, number));
    let texts: Vec<String> = (first..first + width.min(SHOWN_VALUES)).map(text).collect();
    Some(listed(&texts, width))
}

/// The first value of a global array of strings. `None` if the application `instance` has none of this name.
#[must_use]
pub fn string_of_data(controller: &Controller, instance: InstanceId, name: &str) -> Option<String> {
    let space = &controller.vm.space;
    let instance = space.instance(instance)?;
    let id = *instance.data.get(usize::from(instance.image.data(name)?))?;
    let store = space.memory.store(id).ok().filter(|store| store.kind.base_type() == Some(BaseType::String))?;
    Text::read(&space.memory, store.place(id, 0)).ok().map(|text| text.as_str().to_owned())
}

/// Looks at the memory with the stack of a task in it.
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

fn frame(vm: &Vm, task: TaskNumber, depth: usize) -> Option<Frame> {
    vm.tasks().iter().find(|known| known.id == task)?.thread.frames.iter().rev().nth(depth).copied()
}

fn program<'v>(vm: &'v Vm, frame: &Frame) -> Option<&'v Program> {
    vm.space.instance(frame.instance)?.image.programs.get(usize::from(frame.program))
}

/// The parameters of a program, or its locals.
fn variables(program: &Program, are_parameters: bool) -> impl Iterator<Item = &Variable> {
    let is_parameter = |variable: &Variable| program.params.iter().any(|param| param.name == variable.name);
    program.variables.iter().filter(move |variable| is_parameter(variable) == are_parameters)
}
