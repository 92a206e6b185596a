//! The message `state`: tasks, robot, queue of moves.

use serde_json::{Value, json};
use val3_kinematics::Joints;
use val3_machine::controller::{Activity, BlendPoint, Controller, RecordedMove, TaskPosition};
use val3_machine::event::seconds;
use val3_motion::Shape;
use val3_vm::{Rate, Task, TaskState};

use crate::coordinates;

/// Parts of a joint move in the way ahead.
const PARTS: u32 = 12;

/// Moves of the way ahead.
const MOVES: usize = 30;

/// The message, without its time.
pub(crate) fn message(controller: &Controller, mut number: impl FnMut(&RecordedMove) -> u16) -> Value {
    let state = &controller.devices.state;
    let (arm, robot) = (&state.arm, &state.robot);
    let queue = controller.motion_queue();
    let hold = arm.hold(robot.drive());
    let tasks = controller.vm.tasks().iter().zip(controller.task_positions());
    let way = if queue.is_empty() { Vec::new() } else { way_ahead(controller, &queue) };
    json!({
        "kind": "state",
        "tasks": tasks.map(|(task, position)| described(task, &position)).collect::<Vec<_>>(),
        "power": robot.is_powered(),
        "mode": robot.working_mode().name(),
        "emergencyStop": match robot.es_status() as u8 { 0 => "none", 1 => "released", _ => "open" },
        "isHeld": hold.is_some(),
        "heldBecause": hold.map(|hold| hold.text()),
        "monitorSpeed": robot.monitor_speed(),
        "queue": queue.iter().map(|queued| recorded(queued, number(queued))).collect::<Vec<_>>(),
        "path": way,
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
        "error": error,
    })
}

fn recorded(queued: &RecordedMove, source: u16) -> Value {
    let pose = |corner: &BlendPoint| coordinates(&corner.pose);
    let distance = |corner: &BlendPoint| corner.distance.0;
    json!({
        "id": queued.id,
        "type": queued.source.as_ref().map(|source| source.instruction),
        "source": source,
        "phase": queued.phase.word(),
        "target": coordinates(&queued.target),
        "leave": queued.leave.as_ref().map(pose),
        "reach": queued.reach.as_ref().map(pose),
        "leaveDistance": queued.leave.as_ref().map(distance),
        "reachDistance": queued.reach.as_ref().map(distance),
    })
}

/// The way of the tool centre point through the targets of the recorded moves, in mm. Circles are drawn as chords, and
/// corners are not rounded.
fn way_ahead(controller: &Controller, queue: &[RecordedMove]) -> Vec<[f64; 3]> {
    let arm = &controller.devices.state.arm;
    let sample = arm.sample();
    let mut way = vec![sample.pose.translation.vector.into()];
    let mut from = sample.joints;
    for queued in queue.iter().take(MOVES) {
        if queued.shape == Shape::Joint {
            let tool = arm.model().flange(&queued.joints).inverse() * queued.target;
            way.extend((1..PARTS).map(|part| {
                let joints = between(&from, &queued.joints, f64::from(part) / f64::from(PARTS));
                let place: [f64; 3] = (arm.model().flange(&joints) * tool).translation.vector.into();
                place
            }));
        }
        way.push(queued.target.translation.vector.into());
        from = queued.joints;
    }
    way
}

fn between(from: &Joints, to: &Joints, part: f64) -> Joints {
    let mut joints = *from;
    joints.iter_mut().zip(to).for_each(|(joint, to)| *joint += (to - *joint) * part);
    joints
}
