//! The message `state`: tasks, robot, queue of moves.

use serde_json::{Value, json};
use val3_geometry::Vector3;
use val3_machine::controller::{Activity, BlendPoint, Controller, RecordedMove, TaskPosition};
use val3_machine::event::seconds;
use val3_motion::Way;
use val3_vm::{Rate, Task, TaskState};

use crate::coordinates;

/// Pieces of the way ahead: nominal parts and blends.
const PIECES: usize = 60;

/// The way ahead is drawn within this distance of the real one, in mm.
const TOLERANCE: f64 = 0.2;

/// Its coordinates are multiples of this, in mm.
const PRECISION: f64 = 0.01;

/// The message, without its time.
pub(crate) fn message(controller: &Controller, mut number: impl FnMut(&RecordedMove) -> u16) -> Value {
    let state = &controller.devices.state;
    let (arm, robot) = (&state.arm, &state.robot);
    let queue = controller.motion_queue();
    let hold = arm.hold(robot.drive());
    let tasks = controller.vm.tasks().iter().zip(controller.task_positions());
    let way = if queue.is_empty() { Vec::new() } else { way_ahead(controller) };
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

/// The way of the tool centre point to the last destination, in mm, by pieces.
fn way_ahead(controller: &Controller) -> Vec<Value> {
    let pieces = controller.devices.state.arm.motion().way_ahead(PIECES);
    let piece = |Way { phase, points }: &Way| {
        let points: Vec<[f64; 3]> = simplified(points, TOLERANCE).iter().map(rounded).collect();
        json!({ "phase": phase.word(), "points": points })
    };
    pieces.iter().map(piece).collect()
}

fn rounded(point: &Vector3<f64>) -> [f64; 3] {
    point.map(|number| (number / PRECISION).round() * PRECISION).into()
}

/// The points of a curve without those that are near the straight line between the others, after Douglas and Peucker.
fn simplified(points: &[Vector3<f64>], tolerance: f64) -> Vec<Vector3<f64>> {
    let [first, inner @ .., last] = points else { return points.to_vec() };
    let along = last - first;
    let away = |point: &Vector3<f64>| {
        let share = ((point - first).dot(&along) / along.norm_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        (point - first - along * share).norm()
    };
    let widest = inner.iter().map(away).enumerate().max_by(|(_, one), (_, other)| one.total_cmp(other));
    match widest {
        Some((index, distance)) if distance > tolerance => {
            let (before, after) = (points.get(..=index + 1), points.get(index + 1..));
            let mut found = simplified(before.unwrap_or_default(), tolerance);
            found.pop();
            found.extend(simplified(after.unwrap_or_default(), tolerance));
            found
        }
        _ => vec![*first, *last],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_on_straight_lines_are_left_out() {
        let curve: Vec<Vector3<f64>> =
            (0..=20).map(|x| Vector3::new(f64::from(x), f64::from((x - 10).max(0)), 0.0)).collect();
        let kept = simplified(&curve, 0.1);
        assert_eq!(kept, [curve[0], curve[10], curve[20]]);
        let circle = [curve[0], curve[20], curve[0]];
        assert_eq!(simplified(&circle, 0.1), circle);
        assert_eq!(simplified(&curve[..1], 0.1), curve[..1]);
    }
}
