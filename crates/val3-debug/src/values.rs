//! Variables and what is inside them, page by page.

use std::ops::Range;
use std::sync::Arc;

use val3_bytecode::{Program, Storage, Variable};
use val3_lang::fault::{Fault, Result};
use val3_lang::memory::{Kind, KindBase, Memory, Place, Shape, View, field_offset};
use val3_lang::ports::TaskNumber;
use val3_lang::types::fields;
use val3_vm::{Frame, InstanceId, Vm};

/// Fields that the text of a value of a user type shows.
const SHOWN_FIELDS: usize = 4;

/// A variable, a field, or a value of an array or collection.
#[derive(Debug, Clone)]
pub struct Value {
    /// `nCount`, `x`, `[3]`, `["left"]`.
    pub name: String,
    /// Its type, with the sizes of an array: `point[4]`.
    pub type_name: String,
    /// Its value as VAL 3 writes it. Of an array, a collection and a user type in short.
    pub shown: String,
    /// How to look inside; `None` where there is nothing inside.
    pub inside: Option<Inside>,
}

/// How to look inside of a scope or a value. It holds until the controller runs on.
#[derive(Debug, Clone)]
pub struct Inside {
    /// The task on whose stack the value may be.
    task: Option<TaskNumber>,
    node: Node,
}

#[derive(Debug, Clone)]
enum Node {
    /// The variables of a frame: its parameters, or its locals.
    Frame { depth: usize, are_parameters: bool },
    /// The data of an application or library.
    Data(InstanceId),
    /// The values of an array or collection.
    Values(View),
    /// The fields of a value.
    Fields(Arc<Kind>, Place),
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
    let of_frame = |are_parameters| Inside { task: Some(task), node: Node::Frame { depth, are_parameters } };
    let data = |instance| Inside { task: None, node: Node::Data(instance) };
    let mut scopes = vec![
        Scope { kind: ScopeKind::Parameters, inside: of_frame(true) },
        Scope { kind: ScopeKind::Locals, inside: of_frame(false) },
        Scope { kind: ScopeKind::Globals, inside: data(frame.instance) },
    ];
    if let Some(instance) = vm.space.instance(frame.instance) {
        let libraries = instance.image.libraries.iter().zip(&instance.libraries);
        scopes.extend(libraries.filter_map(|(library, loaded)| {
            Some(Scope { kind: ScopeKind::Library(library.alias.clone()), inside: data((*loaded)?) })
        }));
    }
    scopes
}

/// How many values are inside; 0 where they are gone.
pub fn count(vm: &mut Vm, inside: &Inside) -> usize {
    match &inside.node {
        Node::Frame { depth, are_parameters } => {
            let program = inside.task.and_then(|task| program(vm, &frame(vm, task, *depth)?));
            program.map_or(0, |program| variables(program, *are_parameters).count())
        }
        Node::Data(instance) => vm.space.instance(*instance).map_or(0, |instance| instance.data.len()),
        Node::Values(view) => vm.space.memory.len(*view).map_or(0, |len| len as usize),
        Node::Fields(kind, _) => match &kind.base {
            KindBase::User(_) => kind.fields.len(),
            KindBase::Builtin(base, arm) => fields(*base, *arm).len(),
        },
    }
}

/// The values inside, from a range of their numbers.
pub fn values(vm: &mut Vm, inside: &Inside, range: Range<usize>) -> Vec<Value> {
    let range = range.start..range.end.min(count(vm, inside));
    let seen = match &inside.node {
        Node::Frame { depth, are_parameters } => {
            return frame_values(vm, inside.task, (*depth, *are_parameters), range);
        }
        Node::Data(instance) => {
            let Some(instance) = vm.space.instance(*instance) else { return Vec::new() };
            let (image, data) = (Arc::clone(&instance.image), Arc::clone(&instance.data));
            let named = image.data.iter().map(|data| data.name.clone()).zip(data.iter().map(|id| View::whole(*id)));
            Seen::Containers(named.skip(range.start).take(range.len()).collect())
        }
        Node::Values(view) => Seen::Values(*view, range),
        Node::Fields(kind, place) => Seen::Fields(Arc::clone(kind), *place, range),
    };
    let look = Look { task: inside.task };
    let on_stack = |memory: &mut Memory| look.values(memory, seen);
    match inside.task {
        Some(task) => vm.with_stack(task, on_stack).unwrap_or_default(),
        None => on_stack(&mut vm.space.memory),
    }
}

/// The values of a page, where the memory has them.
enum Seen {
    Containers(Vec<(String, View)>),
    Values(View, Range<usize>),
    Fields(Arc<Kind>, Place, Range<usize>),
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

fn frame_values(
    vm: &mut Vm,
    task: Option<TaskNumber>,
    (depth, are_parameters): (usize, bool),
    range: Range<usize>,
) -> Vec<Value> {
    let Some((task, frame)) = task.and_then(|task| Some((task, frame(vm, task, depth)?))) else { return Vec::new() };
    let Some(program) = program(vm, &frame) else { return Vec::new() };
    let shown: Vec<Variable> =
        variables(program, are_parameters).skip(range.start).take(range.len()).cloned().collect();
    let look = Look { task: Some(task) };
    let values = |memory: &mut Memory| shown.iter().map(|variable| look.variable(memory, &frame, variable)).collect();
    vm.with_stack(task, values).unwrap_or_default()
}

/// Looks at values while the stack of a task is in the memory.
#[derive(Clone, Copy)]
struct Look {
    task: Option<TaskNumber>,
}

impl Look {
    fn values(self, memory: &mut Memory, seen: Seen) -> Vec<Value> {
        match seen {
            Seen::Containers(containers) => {
                containers.into_iter().map(|(name, view)| self.container(memory, name, view)).collect()
            }
            Seen::Values(view, range) => {
                let named = range.map(|number| (number, name_of(memory, view, number)));
                named.map(|(number, name)| or_gone(name, |name| self.element(memory, view, number, name))).collect()
            }
            Seen::Fields(kind, place, range) => {
                range.filter_map(|number| self.field(memory, &kind, place, number)).collect()
            }
        }
    }

    fn variable(self, memory: &Memory, frame: &Frame, variable: &Variable) -> Value {
        let name = variable.name.clone();
        let base = &frame.base;
        let view = |number: u32| memory.stack.parts.get(number as usize).copied().map(View::whole);
        match variable.storage {
            Storage::Value(lanes) => self.single(memory, name, &variable.kind, frame.place(lanes)),
            Storage::Place(number) => {
                let place = memory.stack.places.get(base.place as usize + usize::from(number)).copied();
                place.map_or_else(
                    || gone(name.clone()),
                    |place| self.single(memory, name.clone(), &variable.kind, place),
                )
            }
            Storage::Part(number) => self.optional(memory, name, view(base.part + u32::from(number))),
            Storage::View(number) => {
                let view = memory.stack.views.get(base.view as usize + usize::from(number)).copied();
                self.optional(memory, name, view)
            }
        }
    }

    fn optional(self, memory: &Memory, name: String, view: Option<View>) -> Value {
        view.map_or_else(|| gone(name.clone()), |view| self.container(memory, name.clone(), view))
    }

    /// An array or collection, or its value if there is no more than one.
    fn container(self, memory: &Memory, name: String, view: View) -> Value {
        or_gone(name, |name| {
            let store = memory.store(view.store)?;
            let (kind, count) = (Arc::clone(&store.kind), memory.len(view)?);
            if count == 1 && matches!(store.shape, Shape::Array { .. }) {
                return Ok(self.single(memory, name, &kind, memory.element(view, 0)?));
            }
            Ok(Value {
                name,
                type_name: type_name(&kind) + &sizes(&store.shape),
                shown: if count == 1 { "1 value".to_owned() } else { format!("{count} values") },
                inside: (count > 0).then_some(Inside { task: self.task, node: Node::Values(view) }),
            })
        })
    }

    fn element(self, memory: &Memory, view: View, number: usize, name: String) -> Result<Value> {
        let kind = Arc::clone(&memory.store(view.store)?.kind);
        let number = u32::try_from(number).unwrap_or(u32::MAX);
        let number = match &memory.store(view.store)?.shape {
            Shape::Collection(keys) => keys.values().nth(number as usize).copied().ok_or(Fault::INTERPRETER)?,
            Shape::Array { .. } => number,
        };
        Ok(self.single(memory, name, &kind, memory.element(view, number)?))
    }

    /// One value.
    fn single(self, memory: &Memory, name: String, kind: &Arc<Kind>, place: Place) -> Value {
        or_gone(name, |name| {
            let has_fields = match &kind.base {
                KindBase::User(_) => !kind.fields.is_empty(),
                KindBase::Builtin(base, _) => base.is_structured(),
            };
            Ok(Value {
                name,
                type_name: type_name(kind),
                shown: shown(memory, kind, place)?,
                inside: has_fields.then(|| Inside { task: self.task, node: Node::Fields(Arc::clone(kind), place) }),
            })
        })
    }

    fn field(self, memory: &Memory, kind: &Kind, place: Place, number: usize) -> Option<Value> {
        match &kind.base {
            KindBase::User(_) => {
                let name = kind.fields.get(number)?.name.clone();
                let part = memory.part(place, u32::try_from(number).ok()?);
                Some(or_gone(name, |name| Ok(self.container(memory, name, View::whole(part?)))))
            }
            KindBase::Builtin(base, arm) => {
                let field = fields(*base, *arm).get(number)?;
                let kind = Arc::new(Kind::builtin(field.ty, *arm));
                let place = place.after(field_offset(*base, *arm, field.name)?);
                Some(self.single(memory, field.name.to_owned(), &kind, place))
            }
        }
    }
}

/// The value, or that it is gone: a library that was unloaded, a task that has ended.
fn or_gone(name: String, value: impl FnOnce(String) -> Result<Value>) -> Value {
    value(name.clone()).unwrap_or_else(|_| gone(name))
}

fn gone(name: String) -> Value {
    Value { name, type_name: String::new(), shown: "not in memory".to_owned(), inside: None }
}

/// The name of a value of a container: its indexes, or its key.
fn name_of(memory: &Memory, view: View, number: usize) -> String {
    let number = u32::try_from(number).unwrap_or(u32::MAX);
    match memory.store(view.store).map(|store| &store.shape) {
        Ok(Shape::Collection(keys)) => {
            keys.keys().nth(number as usize).map_or_else(String::new, |key| format!("[\"{key}\"]"))
        }
        Ok(Shape::Array { dims, sizes: [_, rows, columns] }) => {
            let (row, column) = (number / columns, number % columns);
            match dims {
                2 => format!("[{},{}]", row / rows, row % rows),
                3 => format!("[{},{},{column}]", row / rows, row % rows),
                _ => format!("[{number}]"),
            }
        }
        Err(_) => String::new(),
    }
}

fn type_name(kind: &Kind) -> String {
    match &kind.base {
        KindBase::User(name) => name.clone(),
        KindBase::Builtin(base, _) => base.name().to_owned(),
    }
}

fn sizes(shape: &Shape) -> String {
    match shape {
        Shape::Collection(_) => "[\"\"]".to_owned(),
        Shape::Array { dims, sizes } => {
            let sizes: Vec<String> = sizes.iter().take(usize::from(*dims)).map(ToString::to_string).collect();
            format!("[{}]", sizes.join(","))
        }
    }
}

/// A value as text; the first fields of a user type.
fn shown(memory: &Memory, kind: &Kind, place: Place) -> Result<String> {
    let KindBase::User(_) = &kind.base else { return memory.shown(kind, place) };
    let mut texts = Vec::new();
    for (lane, field) in (0..).zip(&kind.fields).take(SHOWN_FIELDS) {
        let view = View::whole(memory.part(place, lane)?);
        let text = match &field.init.kind.base {
            KindBase::Builtin(..) if memory.len(view)? == 1 => {
                memory.shown(&field.init.kind, memory.element(view, 0)?)?
            }
            _ => "…".to_owned(),
        };
        texts.push(format!("{}={text}", field.name));
    }
    if kind.fields.len() > SHOWN_FIELDS {
        texts.push("…".to_owned());
    }
    Ok(format!("{{{}}}", texts.join(", ")))
}
