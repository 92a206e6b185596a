//! The requests `val3/…`: motion, inputs and outputs, the pendant. docs/src/debugging.md describes them.

use serde_json::{Map, Value, json};
use val3_debug::Debugger;
use val3_geometry::IsometryMatrix3;
use val3_lang::enumerations;
use val3_machine::arm::{MotionMode, PathPiece};
use val3_machine::controller::{BlendPoint, CodeSource, Controller, MotionPiece, RecordedMove};
use val3_machine::io::Kind;
use val3_machine::script::Action;

use val3_view::{Operator, coordinates, direction, level, user_page};

/// The answer to a request.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) body: Value,
    /// Something was changed by hand, so that a new future begins.
    pub(crate) changes: bool,
}

/// Answers a request, or gives the reason why it fails.
pub(crate) fn answer(
    command: &str,
    arguments: Map<String, Value>,
    operator: &mut Operator,
    debugger: &mut Debugger,
) -> Result<Answer, String> {
    let seen = |body| Ok(Answer { body, changes: false });
    let controller = &mut debugger.controller;
    match command {
        "val3/motionMode" => {
            if let Some(mode) = arguments.get("mode") {
                debugger.set_motion_mode(motion_mode(mode)?);
            }
            let mode = match debugger.motion_mode() {
                MotionMode::Continuous => "continuous",
                MotionMode::Step => "step",
            };
            seen(json!({ "mode": mode }))
        }
        "val3/motionQueue" => seen(motion_queue(controller)),
        "val3/pose" => seen(sample(val3_machine::event::seconds(controller.now()), controller)),
        "val3/io" => seen(signals(controller)),
        "val3/userPage" => seen(user_page(controller)),
        "val3/ioForce" => act(force(&arguments)?, controller),
        "val3/jog" => act(chosen(&arguments, &["joints"], &[("joints", "jog")])?, controller),
        "val3/key" => act(chosen(&arguments, &["key", "keys"], &[])?, controller),
        "val3/operate" => act(arguments, controller),
        "val3/view" => operate_view(&arguments, operator, controller),
        _ => Err(format!("the request `{command}` is unknown")),
    }
}

/// The mode of the motion that a client names.
pub(crate) fn motion_mode(mode: &Value) -> Result<MotionMode, String> {
    match mode.as_str() {
        Some("continuous") => Ok(MotionMode::Continuous),
        Some("step") => Ok(MotionMode::Step),
        _ => Err(format!("the motion has no mode {mode}: write \"continuous\" or \"step\"")),
    }
}

fn act(keys: Map<String, Value>, controller: &mut Controller) -> Result<Answer, String> {
    let action = Action::from_json(keys).map_err(|error| error.to_string())?;
    controller.act(&action).map_err(|problems| problems.join("; "))?;
    Ok(Answer { body: json!({}), changes: true })
}

/// A command of the page that shows the run.
fn operate_view(
    arguments: &Map<String, Value>,
    operator: &mut Operator,
    controller: &mut Controller,
) -> Result<Answer, String> {
    match arguments.get("command").and_then(Value::as_str) {
        Some("pace" | "cycle") => Err("the debugger stops and continues the run".to_owned()),
        Some(command) => {
            let body = operator.execute(command, arguments, controller).map_err(|error| error.to_string())?;
            Ok(Answer { body: Value::Object(body), changes: true })
        }
        None => Err("`command` is the name of a command".to_owned()),
    }
}

/// Takes the known arguments, some by another name.
fn chosen(
    arguments: &Map<String, Value>,
    known: &[&str],
    renamed: &[(&str, &str)],
) -> Result<Map<String, Value>, String> {
    if arguments.is_empty() {
        return Err(format!("name {}", known.join(" or ")));
    }
    let key = |name: &String| {
        let other = renamed.iter().find(|(from, _)| from == name).map_or(name.as_str(), |(_, to)| to);
        known
            .contains(&name.as_str())
            .then(|| other.to_owned())
            .ok_or_else(|| format!("`{name}` is unknown: name {}", known.join(" or ")))
    };
    arguments.iter().map(|(name, value)| Ok((key(name)?, value.clone()))).collect()
}

/// `link` with `value`, `lock`, `simulate` or `protect` as the keys of a script.
fn force(arguments: &Map<String, Value>) -> Result<Map<String, Value>, String> {
    let Some(Value::String(link)) = arguments.get("link") else {
        return Err("name the signal in `link`, such as \"BasicIO-1\\\\%I0\"".to_owned());
    };
    let mut keys = Map::new();
    for (name, value) in arguments.iter().filter(|(name, _)| *name != "link") {
        let of_link = |value: &Value| json!({ link: value });
        match (name.as_str(), value) {
            ("value", _) => keys.insert("io".to_owned(), of_link(value)),
            ("lock", Value::Bool(false)) => keys.insert("unlock".to_owned(), json!(link)),
            ("lock", Value::Bool(true)) => match arguments.get("value") {
                Some(level) => keys.insert("lock".to_owned(), of_link(level)),
                None => keys.insert("lock".to_owned(), json!(link)),
            },
            ("simulate" | "protect", _) => keys.insert(name.clone(), of_link(value)),
            _ => {
                return Err(format!(
                    "`{name}` is unknown or has a wrong value: write value, lock, simulate or protect"
                ));
            }
        };
    }
    if keys.is_empty() { Err("write value, lock, simulate or protect".to_owned()) } else { Ok(keys) }
}

/// The arm at a time, in seconds.
pub(crate) fn sample(t: f64, controller: &Controller) -> Value {
    let arm = &controller.devices.state.arm;
    let sample = arm.sample();
    let moving = controller.motion_status().piece.and_then(|piece| piece.source);
    json!({
        "t": t,
        "joints": sample.joints.iter().take(arm.model().axes()).collect::<Vec<_>>(),
        "pose": pose(&sample.pose),
        "speed": sample.speed.0,
        "moveId": sample.id,
        "phase": sample.phase.word(),
        "source": source(moving.as_ref()),
    })
}

fn pose(position: &IsometryMatrix3<f64>) -> Value {
    json!(coordinates(position))
}

/// A piece of the motion.
pub(crate) fn piece(found: &MotionPiece) -> Value {
    let PathPiece { id, kind, end, joints, pose: position, .. } = &found.piece;
    json!({
        "moveId": id,
        "kind": kind.word(),
        "end": end.word(),
        "joints": joints,
        "pose": pose(position),
        "position": found.position,
        "source": source(found.source.as_ref()),
    })
}

/// The line that requested a move.
fn source(source: Option<&CodeSource>) -> Value {
    source.map_or(Value::Null, |CodeSource { instruction, program, line, file, .. }| {
        json!({ "instruction": instruction, "program": program, "line": line, "file": file })
    })
}

fn motion_queue(controller: &Controller) -> Value {
    let moves: Vec<Value> = controller.motion_queue().iter().map(recorded).collect();
    json!({ "moves": moves })
}

fn recorded(queued: &RecordedMove) -> Value {
    let corner = |corner: &BlendPoint| json!({ "distance": corner.distance.0, "joints": corner.joints, "pose": pose(&corner.pose) });
    let descriptor = queued.descriptor.as_ref().map(|found| {
        json!({
            "accel": found.accel, "vel": found.vel, "decel": found.decel, "tvel": found.tvel, "rvel": found.rvel,
            "blend": enumerations::blend_name(found.blend), "leave": found.leave, "reach": found.reach,
        })
    });
    json!({
        "id": queued.id,
        "type": queued.source.as_ref().map(|source| source.instruction),
        "phase": queued.stage.word(),
        "joints": queued.joints,
        "target": pose(&queued.target),
        "mdesc": descriptor,
        "leave": queued.leave.as_ref().map(corner),
        "reach": queued.reach.as_ref().map(corner),
        "blend": queued.blend,
        "source": source(queued.source.as_ref()),
    })
}

/// Every input and output.
fn signals(controller: &Controller) -> Value {
    let io = &controller.devices.state.io;
    let signals = io.signals().filter_map(|id| {
        let (signal, forcing) = io.signal(id).zip(io.forcing(id))?;
        Some(json!({
            "link": signal.path,
            "direction": direction(signal.direction),
            "value": level(io, id),
            "isDigital": matches!(signal.kind, Kind::Digital),
            "isLocked": forcing.is_locked,
            "isSimulated": forcing.is_simulated,
            "isProtected": signal.protected,
            "fault": forcing.fault.map(|fault| format!("{fault:?}")),
        }))
    });
    json!({ "signals": signals.collect::<Vec<_>>() })
}
