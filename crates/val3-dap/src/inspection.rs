//! Tasks, frames, scopes and variables for the client.

mod libraries;

use val3_debug::{
    DebugValue, DisplayFormat, Inside, ScopeKind, TaskFrame, VariableFilter, count, frames, scopes, values,
};
use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors;
use val3_machine::controller::{Activity, Controller};
use val3_machine::event::seconds;
use val3_view::FileReader;
use val3_vm::{Rate, Task, TaskState};

use crate::assertions;
use crate::cell_view::{self, Property};
use crate::columns::Columns;
use crate::conventions::Conventions;
use crate::inspection::libraries::{LibraryData, are_grouped};
use crate::notices::{module_id, task, thread};
use crate::protocol::{
    Scope, ScopePresentationHint, Source, SourcePresentationHint, StackFrame, StackFramePresentationHint,
    StackTraceArguments, StackTraceResponse, Thread, Variable, VariablePresentationHint,
    VariablePresentationHintAttributes, VariablesArguments, VariablesFilter,
};

/// Handles of stack frames and of values with nested values. They are valid while the run is stopped.
#[derive(Debug, Default)]
pub(crate) struct Handles {
    /// `None` for a frame whose task has continued while other tasks are stopped.
    frames: Vec<Option<FrameHandle>>,
    nodes: Vec<InspectedItem>,
}

/// A stack frame of a task.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct FrameHandle {
    pub(crate) task: TaskNumber,
    /// 0 is the innermost.
    pub(crate) depth: usize,
}

/// Item with nested values.
#[derive(Debug, Clone)]
pub(crate) enum InspectedItem {
    /// Variables of programs.
    Values(Inside),
    /// Properties of the controller that are not data of programs.
    Properties(Vec<Property>),
    /// The scope of several libraries.
    Libraries(Vec<LibraryData>),
}

/// Largest number of global variables, or of data of a library, that clients read at each stop without a request of the user.
const CHEAP_GLOBALS: usize = 300;

impl Handles {
    /// Invalidates all handles, because the run continues.
    pub(crate) fn clear(&mut self) {
        self.frames.clear();
        self.nodes.clear();
    }

    /// Invalidates the handles of a task's stack frames, because the task continues.
    pub(crate) fn forget_frames(&mut self, task: TaskNumber) {
        for frame in &mut self.frames {
            *frame = frame.filter(|frame| frame.task != task);
        }
    }

    /// Adds an item, and returns its handle.
    pub(crate) fn add(&mut self, node: InspectedItem) -> i32 {
        self.nodes.push(node);
        i32::try_from(self.nodes.len()).unwrap_or_default()
    }

    pub(crate) fn node(&self, reference: i32) -> Option<&InspectedItem> {
        self.nodes.get(usize::try_from(reference).ok()?.checked_sub(1)?)
    }

    fn add_frame(&mut self, frame: FrameHandle) -> i32 {
        let known = self.frames.iter().position(|known| *known == Some(frame));
        let index = known.unwrap_or_else(|| {
            self.frames.push(Some(frame));
            self.frames.len() - 1
        });
        i32::try_from(index + 1).unwrap_or_default()
    }

    pub(crate) fn frame(&self, id: i32) -> Option<FrameHandle> {
        *self.frames.get(usize::try_from(id).ok()?.checked_sub(1)?)?
    }

    /// Returns the requested page of a task's stack frames; `None` if there is no such task.
    pub(crate) fn stack_trace(
        &mut self,
        arguments: &StackTraceArguments,
        controller: &Controller,
        conventions: &Conventions,
        files: FileReader,
    ) -> Option<StackTraceResponse> {
        let task = task(arguments.thread_id)?;
        if !controller.vm.tasks().iter().any(|known| known.id == task) {
            return None;
        }
        let all = frames(&controller.vm, task);
        let start = arguments.start_frame.unwrap_or_default() as usize;
        let levels = arguments.levels.filter(|levels| *levels > 0).map_or(usize::MAX, |levels| levels as usize);
        // Frames of the assertion library are de-emphasised, so that clients show the line of the test first.
        let has_failed = assertions::has_failed(&all);
        let shows_line = arguments.format.as_ref().is_some_and(|format| format.line == Some(true));
        let page = all.iter().enumerate().skip(start).take(levels).map(|(depth, frame)| {
            let id = self.add_frame(FrameHandle { task, depth });
            if frame.is_console {
                return label(id, frame);
            }
            let image = controller.vm.space.instance(frame.instance).map(|instance| &instance.image);
            let module_id = image.map(|image| module_id(&image.path));
            let columns = files(&frame.file).and_then(|text| Columns::of(&text, frame.row, frame.code.clone()));
            let shown = StackFrame { module_id, ..stack_frame(id, frame, shows_line, columns, conventions) };
            if has_failed && assertions::is_of_library(frame) { in_background(shown) } else { shown }
        });
        let stack_frames = page.collect();
        Some(StackTraceResponse { stack_frames, total_frames: u32::try_from(all.len()).ok() })
    }

    /// Returns the scopes of a stack frame and of the cell. The filter restricts the global variables.
    pub(crate) fn scopes(
        &mut self,
        frame: FrameHandle,
        controller: &mut Controller,
        filter: Option<&VariableFilter>,
    ) -> Vec<Scope> {
        let all = scopes(&controller.vm, frame.task, frame.depth);
        let found = match filter {
            Some(filter) => filter.restrict(&controller.vm, all),
            None => all,
        };
        let is_grouped = are_grouped(&found);
        let mut libraries = Vec::new();
        let mut shown: Vec<Scope> = Vec::new();
        for scope in found {
            let named = count(&mut controller.vm, &scope.inside);
            let (name, hint) = match scope.kind {
                ScopeKind::Parameters => ("Parameters".to_owned(), Some(ScopePresentationHint::Arguments)),
                ScopeKind::Locals => ("Locals".to_owned(), Some(ScopePresentationHint::Locals)),
                ScopeKind::Globals => ("Globals".to_owned(), None),
                ScopeKind::Library(alias) if is_grouped => {
                    libraries.push(LibraryData { alias, size: named, inside: scope.inside });
                    continue;
                }
                ScopeKind::Library(alias) => (format!("Library {alias}"), None),
            };
            shown.push(Scope {
                name,
                // Programs have few parameters and locals.
                expensive: hint.is_none() && named > CHEAP_GLOBALS,
                variables_reference: self.add(InspectedItem::Values(scope.inside)),
                named_variables: i32::try_from(named).ok(),
                presentation_hint: hint,
                ..Scope::default()
            });
        }
        shown.extend(is_grouped.then(|| self.libraries_scope(libraries)));
        for (name, properties) in cell_view::scopes(controller) {
            shown.push(Scope {
                name: name.to_owned(),
                expensive: true,
                variables_reference: self.add(InspectedItem::Properties(properties)),
                ..Scope::default()
            });
        }
        shown
    }

    /// Returns the values nested in an item.
    pub(crate) fn variables(
        &mut self,
        arguments: &VariablesArguments,
        controller: &mut Controller,
        format: DisplayFormat,
    ) -> Option<Vec<Variable>> {
        let start = arguments.start.unwrap_or_default() as usize;
        let most = arguments.count.filter(|count| *count > 0).map_or(usize::MAX, |count| count as usize);
        let range = start..start.saturating_add(most);
        match self.node(arguments.variables_reference)?.clone() {
            InspectedItem::Values(inside) if is_filtered_out(arguments.filter.as_ref(), inside.is_indexed()) => {
                Some(Vec::new())
            }
            InspectedItem::Properties(_) | InspectedItem::Libraries(_)
                if is_filtered_out(arguments.filter.as_ref(), false) =>
            {
                Some(Vec::new())
            }
            InspectedItem::Values(inside) => {
                let found = values(controller, &inside, range, format);
                Some(found.into_iter().map(|value| self.variable(value, controller)).collect())
            }
            InspectedItem::Properties(properties) => {
                let page = properties.into_iter().skip(start).take(most);
                Some(page.map(|property| self.property(property, controller)).collect())
            }
            InspectedItem::Libraries(libraries) => {
                let page = libraries.into_iter().skip(start).take(most);
                Some(page.map(|library| self.library(library)).collect())
            }
        }
    }

    /// Converts a value for the client.
    pub(crate) fn variable(&mut self, value: DebugValue, controller: &mut Controller) -> Variable {
        let DebugValue { name, type_name, shown, path, refers_to, inside } = value;
        let size = inside.as_ref().map(|inside| count(&mut controller.vm, inside));
        let size = size.and_then(|size| i32::try_from(size).ok());
        let is_array = inside.as_ref().is_some_and(Inside::is_indexed);
        let refers_to = refers_to.map(|other| format!(" (refers to {other})")).unwrap_or_default();
        Variable {
            name,
            value: shown + &refers_to,
            r#type: Some(type_name).filter(|name| !name.is_empty()),
            evaluate_name: path,
            indexed_variables: size.filter(|_| is_array),
            named_variables: size.filter(|_| !is_array),
            variables_reference: inside.map_or(0, |inside| self.add(InspectedItem::Values(inside))),
            ..Variable::default()
        }
    }

    fn property(&mut self, property: Property, controller: &Controller) -> Variable {
        let Property { name, value, inside, signal } = property;
        // The signal may have been forced since the scope was requested.
        let value = signal.as_ref().map_or(value, |path| cell_view::signal_at(controller, path));
        let attributes = signal.is_none().then(|| vec![VariablePresentationHintAttributes::ReadOnly]);
        Variable {
            name,
            value,
            named_variables: (!inside.is_empty()).then(|| i32::try_from(inside.len()).unwrap_or(i32::MAX)),
            variables_reference: if inside.is_empty() { 0 } else { self.add(InspectedItem::Properties(inside)) },
            presentation_hint: attributes.map(|attributes| VariablePresentationHint {
                attributes: Some(attributes),
                ..VariablePresentationHint::default()
            }),
            ..Variable::default()
        }
    }
}

/// Whether the client requests the other kind of children.
fn is_filtered_out(filter: Option<&VariablesFilter>, are_indexed: bool) -> bool {
    match filter {
        Some(VariablesFilter::Indexed) => !are_indexed,
        Some(VariablesFilter::Named) => are_indexed,
        None => false,
    }
}

fn stack_frame(
    id: i32,
    frame: &TaskFrame,
    shows_line: bool,
    columns: Option<Columns>,
    conventions: &Conventions,
) -> StackFrame {
    let line = if shows_line { format!(", line {}", frame.row) } else { String::new() };
    StackFrame {
        id,
        name: format!("{}:{}(){line}", frame.application, frame.program),
        line: conventions.line(frame.row),
        column: conventions.column(columns.map_or(1, |columns| columns.first)),
        end_line: columns.map(|_| conventions.line(frame.row)),
        end_column: columns.map(|columns| conventions.column(columns.end)),
        source: Some(conventions.source(&frame.file)),
        can_restart: Some(true),
        ..StackFrame::default()
    }
}

/// Returns the frame of statements of the debug console: a label without a source.
fn label(id: i32, frame: &TaskFrame) -> StackFrame {
    StackFrame {
        id,
        name: frame.program.clone(),
        presentation_hint: Some(StackFramePresentationHint::Label),
        can_restart: Some(false),
        ..StackFrame::default()
    }
}

/// De-emphasises a stack frame, so that clients show another frame first.
fn in_background(frame: StackFrame) -> StackFrame {
    let hint = Some(SourcePresentationHint::Deemphasize);
    StackFrame {
        source: frame.source.map(|source| Source { presentation_hint: hint, ..source }),
        presentation_hint: Some(StackFramePresentationHint::Subtle),
        ..frame
    }
}

/// Returns the tasks.
pub(crate) fn threads(controller: &Controller) -> Vec<Thread> {
    let positions = controller.task_positions();
    let tasks = controller.vm.tasks().iter().zip(positions);
    tasks.map(|(task, position)| Thread { id: thread(task.id), name: task_name(task, &position.activity) }).collect()
}

/// Formats a task with its priority or period, and its state if it does not run.
fn task_name(task: &Task, activity: &Activity) -> String {
    let rate = match task.rate {
        Rate::Priority(priority) => format!("priority {priority}"),
        Rate::Period { period, .. } => format!("every {} ms", seconds(period) * 1e3),
    };
    let held = if task.is_held { ", held by the debugger" } else { "" };
    let state = match (task.state, activity.awaited_thing()) {
        (TaskState::Failed(fault), _) => {
            let short = runtime_errors::find(fault.0).map_or("unknown run-time error", |error| error.short);
            format!(", error {}: {short}", fault.0)
        }
        (TaskState::Halted, _) => ", suspended".to_owned(),
        (_, Some(awaited)) => {
            let cause = activity.hold().map(|hold| format!(": {}", hold.cause())).unwrap_or_default();
            format!(", waits for {awaited}{cause}")
        }
        _ => String::new(),
    };
    format!("{} ({rate}{state}{held})", task.name)
}
