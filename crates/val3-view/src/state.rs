//! Message `state`: tasks and robot.

use serde_json::{Value, json};
use val3_machine::arm::ArmHold;
use val3_machine::controller::{Activity, Controller, TaskPosition};
use val3_machine::event::seconds;
use val3_vm::{Rate, Task, TaskState};

/// Creates the message, without its time.
pub(crate) fn message(controller: &Controller) -> Value {
    let state = &controller.devices.state;
    let (arm, robot) = (&state.arm, &state.robot);
    let hold = arm.hold(robot.drive());
    let positions = controller.task_positions();
    let awaited_hold = positions.iter().find_map(|position| position.activity.hold());
    let tasks = controller.vm.tasks().iter().zip(positions);
    json!({
        "kind": "state",
        "tasks": tasks.map(|(task, position)| described(task, &position)).collect::<Vec<_>>(),
        "power": robot.is_powered(),
        "mode": robot.working_mode().name(),
        "emergencyStop": match robot.es_status() as u8 { 0 => "none", 1 => "released", _ => "open" },
        "isHeld": hold.is_some(),
        "heldBecause": hold.map(|hold| hold.text()),
        "awaitedHold": awaited_hold.map(ArmHold::operator_text),
        "monitorSpeed": robot.monitor_speed(),
    })
}

fn described(task: &Task, position: &TaskPosition) -> Value {
    let (priority, period, overruns) = match task.rate {
        Rate::Priority(lines) => (Some(lines), None, 0),
        Rate::Period { period, overruns, .. } => (None, Some(seconds(period)), overruns),
    };
    let error = match position.activity {
        Activity::Failed(code) => Some(code),
        _ => None,
    };
    json!({
        "name": position.name,
        "state": if task.state == TaskState::Running { position.activity.word() } else { "suspended" },
        "program": position.program,
        "line": position.line,
        "file": position.file,
        "priority": priority,
        "period": period,
        "overruns": overruns,
        "waits": position.activity.awaited(),
        "awaits": position.activity.awaited_thing(),
        "error": error,
    })
}
