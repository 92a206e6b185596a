//! Event `stopped`, for each kind of stop.

use val3_debug::{Contact, DataChange, DataStop, MotionStop, Stop, TaskFrame, causes, frames};
use val3_lang::fault::Fault;
use val3_lang::ports::TaskNumber;
use val3_lang::runtime_errors;
use val3_machine::arm::ArmHold;
use val3_machine::controller::{CodeSource, Controller, MotionFault, TaskPosition};

use crate::assertions;
use crate::breakpoints::number;
use crate::notices::thread;
use crate::protocol::{ProcessEvent, ProcessEventStartMethod, StoppedEvent, StoppedEventReason};

/// Returns the event for a stop.
pub(crate) fn stopped(stop: &Stop, controller: &mut Controller) -> StoppedEvent {
    match stop {
        Stop::Breakpoints { task, ids, .. } if ids.contains(&assertions::ID) => StoppedEvent {
            description: Some("Paused on failed assertion".to_owned()),
            text: assertions::message(controller, *task),
            ..event(StoppedEventReason::Exception, Some(*task))
        },
        Stop::Breakpoints { task, ids, faults } => StoppedEvent {
            text: faults.first().map(|fault| format!("the condition cannot be evaluated: {}", fault.message)),
            hit_breakpoint_ids: Some(ids.iter().map(|id| number(*id)).collect()),
            ..event(StoppedEventReason::Breakpoint, Some(*task))
        },
        Stop::Step { task } => event(StoppedEventReason::Step, Some(*task)),
        Stop::Error { task, fault } => {
            let meaning = runtime_errors::find(fault.0).map_or("unknown run-time error", |error| error.short);
            StoppedEvent {
                description: Some("Paused on run-time error".to_owned()),
                text: Some(format!("error {}: {meaning}{}", fault.0, cause(*fault, *task, controller))),
                ..event(StoppedEventReason::Exception, Some(*task))
            }
        }
        Stop::CallEnded { task, fault, line } => StoppedEvent {
            description: Some("Paused after the call from the debug console".to_owned()),
            text: Some(call_end(*fault, line.as_deref())),
            ..event(StoppedEventReason::Pause, Some(*task))
        },
        Stop::PathFault(fault) => path_fault(fault, controller),
        Stop::Contacts(contacts) => contact(contacts, controller),
        Stop::Exit { task } => StoppedEvent {
            description: Some("Paused before the end of the application".to_owned()),
            text: Some("the last task is before its end; the next step or continue ends the run".to_owned()),
            ..event(StoppedEventReason::Pause, Some(*task))
        },
        Stop::Data(stop) => data(stop, controller),
        Stop::Pause { task } => event(StoppedEventReason::Pause, *task),
        Stop::Motion(stop) => motion(stop, controller),
        Stop::Beginning => {
            let task = first_task(controller);
            let is_whole = controller.now() == 0;
            let text = "the past that is kept begins here: where the debugger has attached, or as `pastSnapshots` and `pastMemory` limit it";
            StoppedEvent {
                description: Some("Paused at the beginning of the recorded past".to_owned()),
                text: Some(if is_whole { "the run begins here" } else { text }.to_owned()),
                ..event(StoppedEventReason::Entry, task)
            }
        }
    }
}

/// Describes how a call of the debug console has ended.
fn call_end(fault: Option<Fault>, line: Option<&TaskFrame>) -> String {
    let Some(Fault(number)) = fault else { return "the call from the debug console has ended".to_owned() };
    let meaning = runtime_errors::find(number).map_or("unknown run-time error", |error| error.short);
    let place = line.filter(|line| !line.is_console);
    let place = place.map(|line| format!(" ({}:{}(), line {})", line.application, line.program, line.row));
    format!("error {number} has ended the call from the debug console: {meaning}{}", place.unwrap_or_default())
}

/// Names the data with which a run-time error has stopped a task: ``: `diPart` has no link``. Empty for errors without
/// such data.
pub(crate) fn cause(fault: Fault, task: TaskNumber, controller: &mut Controller) -> String {
    let causes = causes(controller, task, fault);
    if causes.is_empty() { String::new() } else { format!(": {}", causes.join("; ")) }
}

/// Returns the event for a run in which no task can continue.
pub(crate) fn stuck(controller: &Controller) -> StoppedEvent {
    let remedy = arm_remedy(controller).map(|remedy| format!(". {remedy}")).unwrap_or_default();
    StoppedEvent {
        description: Some("Paused because no task can continue".to_owned()),
        text: Some(waits(controller).collect::<Vec<_>>().join("; ") + &remedy),
        ..event(StoppedEventReason::Pause, first_task(controller))
    }
}

/// Returns the event for a run that has ended, with failed tasks or without tasks.
pub(crate) fn ended(controller: &Controller) -> StoppedEvent {
    StoppedEvent {
        description: Some("Paused at the end of the run".to_owned()),
        text: Some("the run has ended: go back, or continue to end the session".to_owned()),
        ..event(StoppedEventReason::Pause, first_task(controller))
    }
}

/// Returns the event for a run at the end of the recording that it repeats.
pub(crate) fn recorded_end(controller: &Controller) -> StoppedEvent {
    StoppedEvent {
        description: Some("Paused at the end of the recording".to_owned()),
        text: Some("the recording ends here: go back, or continue to end the session".to_owned()),
        ..event(StoppedEventReason::Pause, first_task(controller))
    }
}

/// Returns the event for a run at its time limit.
pub(crate) fn time_limit(controller: &Controller) -> StoppedEvent {
    StoppedEvent {
        description: Some("Paused at the time limit of the run".to_owned()),
        text: Some("the run has reached the time `until`: go back, or continue to end the session".to_owned()),
        ..event(StoppedEventReason::Pause, first_task(controller))
    }
}

/// Returns the event for a run that is at its previous moment, because the client has cancelled a search.
pub(crate) fn cancelled(controller: &Controller) -> StoppedEvent {
    StoppedEvent {
        description: Some("Paused where the search has begun".to_owned()),
        text: Some("the search was cancelled".to_owned()),
        ..event(StoppedEventReason::Pause, first_task(controller))
    }
}

/// Describes what each task does or waits for: ``task `main~` waits for a condition at start() line 5``.
pub(crate) fn waits(controller: &Controller) -> impl Iterator<Item = String> {
    let positions = controller.task_positions().into_iter();
    positions.map(|TaskPosition { name, activity, program, line, .. }| {
        let cause = activity.hold().map(|hold| format!(": {},", hold.cause())).unwrap_or_default();
        let awaited = activity.awaited_thing().map(|thing| format!("waits for {thing}{cause}"));
        format!("task `{name}` {} at {program}() line {line}", awaited.unwrap_or_else(|| activity.to_string()))
    })
}

/// Returns why the awaited arm does not move, and the action of the operator that moves it; `None` if no task waits for
/// a held arm.
pub(crate) fn arm_remedy(controller: &Controller) -> Option<&'static str> {
    controller.task_positions().iter().find_map(|task| task.activity.hold()).map(ArmHold::operator_text)
}

/// Describes what a task waits for, like [`waits`].
pub(crate) fn wait_of(task: TaskNumber, controller: &Controller) -> Option<String> {
    let index = controller.vm.tasks().iter().position(|known| known.id == task)?;
    waits(controller).nth(index)
}

fn first_task(controller: &Controller) -> Option<TaskNumber> {
    controller.vm.tasks().first().map(|task| task.id)
}

fn data(stop: &DataStop, controller: &Controller) -> StoppedEvent {
    let changes: Vec<String> = stop.changes.iter().map(described).collect();
    let line = stop.line.as_ref().map(|line| format!(" ({}:{}(), line {})", line.application, line.program, line.row));
    StoppedEvent {
        hit_breakpoint_ids: Some(stop.changes.iter().map(|change| number(change.id)).collect()),
        text: Some(changes.join("; ") + &line.unwrap_or_default()),
        ..event(StoppedEventReason::DataBreakpoint, stop.task.or_else(|| first_task(controller)))
    }
}

/// Returns the event for the end of a motion in step mode. The reason is `step`, which every client supports.
fn motion(stop: &MotionStop, controller: &Controller) -> StoppedEvent {
    let place = stop.piece.as_ref().map(|found| {
        let source = found.source.as_ref();
        let line = source.map(|source| format!(" of {}() line {}", source.program, source.line)).unwrap_or_default();
        format!("the arm is at the {} point of move {}{line}", found.piece.end.word(), found.piece.id)
    });
    let text = match stop.hold {
        Some(hold) => hold.operator_text().to_owned(),
        None => place.unwrap_or_else(|| "no motion is determined".to_owned()),
    };
    StoppedEvent {
        description: Some("Paused on motion".to_owned()),
        text: Some(text),
        ..event(
            StoppedEventReason::Step,
            stop.task.or_else(|| mover(stop, controller)).or_else(|| first_task(controller)),
        )
    }
}

/// Returns the event for an arm that has come to rest before a path that it cannot follow.
fn path_fault(fault: &MotionFault, controller: &Controller) -> StoppedEvent {
    let place = fault.source.as_ref().map(|source| {
        let CodeSource { instruction, program, line, .. } = source;
        format!(" of this {instruction} ({program}() line {line})")
    });
    let task = fault.source.as_ref().and_then(|source| task_in(source, controller));
    StoppedEvent {
        description: Some("Paused on motion error".to_owned()),
        text: Some(format!("the arm cannot follow the path{}: {}", place.unwrap_or_default(), fault.text)),
        ..event(StoppedEventReason::Exception, task.or_else(|| first_task(controller)))
    }
}

/// Returns the event for contacts of the arm, or of a thing that it carries.
fn contact(contacts: &[Contact], controller: &Controller) -> StoppedEvent {
    let text: Vec<String> = contacts.iter().map(Contact::to_string).collect();
    StoppedEvent {
        description: Some("Paused on contact".to_owned()),
        text: Some(text.join("; ")),
        ..event(StoppedEventReason::Exception, first_task(controller))
    }
}

/// Describes an access to watched data: the old and new value, or the value that was read.
fn described(change: &DataChange) -> String {
    if let Some(fault) = &change.fault {
        return format!("the condition cannot be evaluated: {fault}");
    }
    if change.is_write { format!("{} -> {}", change.old, change.new) } else { format!("read: {}", change.new) }
}

/// Returns a task that is in the program of the move.
fn mover(stop: &MotionStop, controller: &Controller) -> Option<TaskNumber> {
    task_in(stop.piece.as_ref()?.source.as_ref()?, controller)
}

/// Returns a task that is in the program of a line.
fn task_in(source: &CodeSource, controller: &Controller) -> Option<TaskNumber> {
    let mut tasks = controller.vm.tasks().iter().map(|task| task.id);
    tasks.find(|task| frames(&controller.vm, *task).iter().any(|frame| frame.file == source.file))
}

/// Returns the event that presents the run as a process of this machine.
pub(crate) fn process(controller: &Controller, is_attach: bool) -> ProcessEvent {
    let first = controller.vm.space.loaded().next();
    let start = if is_attach { ProcessEventStartMethod::Attach } else { ProcessEventStartMethod::Launch };
    ProcessEvent {
        name: first.map(|(_, application)| application.image.name.clone()).unwrap_or_default(),
        is_local_process: Some(true),
        start_method: Some(start),
        ..ProcessEvent::default()
    }
}

/// Returns an event for a stop of all tasks.
pub(crate) fn event(reason: StoppedEventReason, task: Option<TaskNumber>) -> StoppedEvent {
    StoppedEvent {
        reason,
        all_threads_stopped: Some(true),
        description: None,
        hit_breakpoint_ids: None,
        preserve_focus_hint: None,
        text: None,
        thread_id: task.map(thread),
    }
}
