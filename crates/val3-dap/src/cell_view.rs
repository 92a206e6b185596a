//! Scopes of the cell for users: inputs and outputs, the robot, the motion queue.

use val3_geometry::IsometryMatrix3;
use val3_lang::enumerations::blend_name;
use val3_machine::controller::{BlendPoint, Controller, RecordedMove};
use val3_machine::io::{IoTable, SignalId, SignalKind};
use val3_view::{coordinates, direction};

/// A property with its nested properties.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Property {
    pub(crate) name: String,
    pub(crate) value: String,
    pub(crate) inside: Vec<Property>,
    /// Path of the shown input or output.
    pub(crate) signal: Option<String>,
}

impl Property {
    fn new(name: impl Into<String>, value: impl Into<String>) -> Self {
        Self { name: name.into(), value: value.into(), inside: Vec::new(), signal: None }
    }

    fn group(name: impl Into<String>, value: impl Into<String>, inside: Vec<Self>) -> Self {
        Self { inside, ..Self::new(name, value) }
    }
}

/// The scopes of the cell.
pub(crate) fn scopes(controller: &Controller) -> [(&'static str, Vec<Property>); 3] {
    [("I/O", boards(controller)), ("Robot", robot(controller)), ("Motion queue", queue(controller))]
}

/// Inputs and outputs by board.
fn boards(controller: &Controller) -> Vec<Property> {
    let io = &controller.devices.state.io;
    let mut boards: Vec<Property> = Vec::new();
    for id in io.signals() {
        let Some(signal) = io.signal(id) else { continue };
        let (board, address) = signal.path.rsplit_once('\\').unwrap_or(("other", &signal.path));
        let path = Some(signal.path.clone());
        let property = Property { signal: path, ..Property::new(address, self::signal(io, id)) };
        match boards.iter_mut().find(|known| known.name == board) {
            Some(board) => board.inside.push(property),
            None => boards.push(Property::group(board, "", vec![property])),
        }
    }
    for board in &mut boards {
        board.value = format!("{} signals", board.inside.len());
    }
    boards
}

/// Value and state of the signal with this path.
pub(crate) fn signal_at(controller: &Controller, path: &str) -> String {
    let io = &controller.devices.state.io;
    io.find(path).map(|id| signal(io, id)).unwrap_or_default()
}

/// Signal value with direction, lock, simulation, protection and fault.
fn signal(io: &IoTable, id: SignalId) -> String {
    let Some((signal, forcing)) = io.signal(id).zip(io.forcing(id)) else { return String::new() };
    let number = io.next_image(id).unwrap_or_default();
    let value = match signal.kind {
        SignalKind::Digital => (number != 0.0).to_string(),
        SignalKind::Analog(_) => number.to_string(),
    };
    let marks = [
        (true, direction(signal.direction)),
        (forcing.is_locked, "locked"),
        (forcing.is_simulated, "simulated"),
        (signal.protected, "protected"),
        (forcing.fault.is_some(), "faulty"),
    ];
    let marks: Vec<&str> = marks.into_iter().filter_map(|(holds, mark)| holds.then_some(mark)).collect();
    format!("{value} ({})", marks.join(", "))
}

/// The arm, its power and its speed.
fn robot(controller: &Controller) -> Vec<Property> {
    let state = &controller.devices.state;
    let (arm, robot) = (&state.arm, &state.robot);
    let sample = arm.sample();
    let axes = arm.model().axes();
    let joints: Vec<f64> = arm.joint().into_iter().take(axes).collect();
    let named = |(number, joint): (usize, &f64)| Property::new(format!("j{number}"), format!("{joint:.6}"));
    let power = if robot.is_powered() { "on" } else { "off" };
    let mut properties = vec![
        Property::new("arm", arm.model().name()),
        Property::group("joints", list(&joints), (1..).zip(&joints).map(named).collect()),
        pose("pose", "", &sample.pose),
        Property::new("configuration", configuration(controller)),
        pose("tool", "", &(arm.model().flange(&sample.joints).inverse() * sample.pose)),
        Property::new("speed", format!("{:.3} mm/s", sample.speed.0)),
        Property::new("monitorSpeed", format!("{} %", robot.monitor_speed())),
        Property::new("power", power),
        Property::new("workingMode", robot.working_mode().name()),
        Property::new("emergencyStop", format!("{:?}", robot.es_status()).to_lowercase()),
        Property::new("moveId", sample.id.to_string()),
        Property::new("motion", sample.phase.word()),
    ];
    if let Some(hold) = arm.hold(robot.drive()) {
        properties.push(Property::new("heldBecause", hold.text()));
    }
    properties
}

/// Returns the configuration of the joint position, in the words of the type `config`.
fn configuration(controller: &Controller) -> String {
    let arm = controller.arm();
    let found = arm.model().configuration(&arm.joint());
    let text = match arm.model().is_scara() {
        true => format!("{:?}", found.shoulder),
        false => format!("{:?}, e{:?}, w{:?}", found.shoulder, found.elbow, found.wrist),
    };
    text.to_lowercase()
}

/// Returns a pose with its coordinates as nested properties.
fn pose(name: &str, before: &str, position: &IsometryMatrix3<f64>) -> Property {
    let numbers = coordinates(position);
    let named = ["x", "y", "z", "rx", "ry", "rz"].into_iter().zip(numbers);
    let inside = named.map(|(name, value)| Property::new(name, format!("{value:.6}"))).collect();
    Property::group(name, format!("{before}{}", list(&numbers)), inside)
}

fn list(numbers: &[f64]) -> String {
    let shown: Vec<String> = numbers.iter().map(|number| format!("{number:.3}")).collect();
    format!("{{{}}}", shown.join(", "))
}

/// Returns the recorded moves that are not done.
fn queue(controller: &Controller) -> Vec<Property> {
    controller.motion_queue().iter().map(queued).collect()
}

fn queued(queued: &RecordedMove) -> Property {
    let phase = queued.stage.word();
    let mut inside = vec![Property::new("phase", phase), pose("target", "", &queued.target)];
    if let Some(mdesc) = &queued.descriptor {
        let number = |name, value: f64| Property::new(name, value.to_string());
        let parts = vec![
            number("accel", mdesc.accel),
            number("vel", mdesc.vel),
            number("decel", mdesc.decel),
            number("tvel", mdesc.tvel),
            number("rvel", mdesc.rvel),
            Property::new("blend", blend_name(mdesc.blend)),
            number("leave", mdesc.leave),
            number("reach", mdesc.reach),
        ];
        inside.push(Property::group("mdesc", format!("blend={}", blend_name(mdesc.blend)), parts));
    }
    let corners = [("leave", &queued.leave), ("reach", &queued.reach)];
    inside.extend(corners.into_iter().filter_map(|(name, corner)| {
        let BlendPoint { distance, pose: position, .. } = corner.as_ref()?;
        Some(pose(name, &format!("{:.3} mm from the target, ", distance.0), position))
    }));
    if let Some(note) = queued.blend.note() {
        inside.push(Property::new("blendCutShort", note));
    }
    let source = queued.source.as_ref();
    if let Some(source) = source {
        inside.push(Property::new("program", source.program.clone()));
        inside.push(Property::new("line", source.line.to_string()));
    }
    let instruction = source.map_or("move", |source| source.instruction);
    Property::group(format!("move {}", queued.id), format!("{instruction}, {phase}"), inside)
}
