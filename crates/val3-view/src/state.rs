//! Message `state`: tasks and robot.

use val3_debug::TaskFrame;
use val3_lang::values::ConfigValue;
use val3_machine::arm::ArmHold;
use val3_machine::controller::{Activity, Controller, TaskPosition};
use val3_machine::controller_state::WorkingMode;
use val3_machine::event::seconds;
use val3_motion::SpeedLimit;
use val3_vm::{Rate, Task};

use crate::configuration;
use crate::lines::Lines;
use crate::wire::{CallingLine, StateMessage, TaskState};

/// Maximum number of callers in the state of a task. Recursion may have many more.
const CALLERS: usize = 16;

/// Creates the message at a time in seconds.
pub(crate) fn message(t: f64, controller: &Controller, lines: &mut Lines) -> StateMessage {
    let state = &controller.devices.state;
    let (arm, robot) = (&state.arm, &state.robot);
    let hold = state.arm_hold();
    let positions = controller.task_positions();
    let awaited_hold = positions.iter().find_map(|position| position.activity.hold());
    let text = |hold| operator_text(hold, robot.working_mode());
    let tasks = controller.vm.tasks().iter().zip(positions);
    let emergency_stop = match robot.es_status() as u8 {
        0 => "none",
        1 => "released",
        _ => "open",
    };
    StateMessage {
        t,
        tasks: tasks.map(|(task, position)| described(task, position, callers(task, controller), lines)).collect(),
        power: robot.is_powered(),
        mode: robot.working_mode().name().to_owned(),
        emergency_stop: emergency_stop.to_owned(),
        is_held: !robot.lets_programs_move(),
        held_because: hold.map(text),
        awaited_hold: awaited_hold.map(text),
        awaits_next_move: arm.speed_limit() == SpeedLimit::NextMove,
        monitor_speed: robot.monitor_speed(),
        config: configuration::words(&ConfigValue::at(arm.model(), &arm.joint()), arm.model().is_scara()),
    }
}

/// Returns the reason why the arm does not move, and the action that helps in this working mode.
fn operator_text(hold: ArmHold, mode: WorkingMode) -> String {
    match (hold, mode) {
        (ArmHold::Held, WorkingMode::Remote) => "The arm is held. Press Move.".to_owned(),
        (ArmHold::Held, mode) => {
            format!("Held in {} mode. Press Move, or choose remote mode.", mode.name())
        }
        (hold, _) => hold.operator_text().to_owned(),
    }
}

/// Returns the calling lines of a task, the innermost first.
fn callers(task: &Task, controller: &Controller) -> Vec<CallingLine> {
    let frames = val3_debug::frames(&controller.vm, task.id).into_iter().skip(1);
    let frames = frames.filter(|frame| !frame.is_console).take(CALLERS);
    frames.map(|TaskFrame { program, file, row, .. }| CallingLine { program, line: row, file }).collect()
}

fn described(task: &Task, position: TaskPosition, callers: Vec<CallingLine>, lines: &mut Lines) -> TaskState {
    let (priority, period, overruns) = match task.rate {
        Rate::Priority(lines) => (Some(lines), None, 0),
        Rate::Period { period, overruns, .. } => (None, Some(seconds(period)), overruns),
    };
    let error = match position.activity {
        Activity::Failed(code) => Some(code),
        _ => None,
    };
    let waits = position.activity.awaited();
    let is_at_rest = waits.is_some() || error.is_some();
    TaskState {
        state: position.activity.word().to_owned(),
        callers,
        priority,
        period,
        overruns,
        waits,
        awaits: position.activity.awaited_thing(),
        error,
        line_code: if is_at_rest { lines.code(&position.file, position.line) } else { None },
        name: position.name,
        program: position.program,
        line: position.line,
        file: position.file,
    }
}
