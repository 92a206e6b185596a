//! The cell for people: inputs and outputs, the robot, the queue of its moves.

use val3_geometry::Trsf;
use val3_machine::controller::{BlendPoint, Controller, MovePhase, RecordedMove};
use val3_machine::io::{Direction, Kind, SignalId};

use crate::custom::blend_word;

/// A property with the properties inside of it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Property {
    pub(crate) name: String,
    pub(crate) value: String,
    pub(crate) inside: Vec<Property>,
}

impl Property {
    fn new(name: impl Into<String>, value: impl Into<String>) -> Self {
        Self { name: name.into(), value: value.into(), inside: Vec::new() }
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
        let property = Property::new(address, level(controller, id));
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

/// The value of a signal, and what holds it.
fn level(controller: &Controller, id: SignalId) -> String {
    let io = &controller.devices.state.io;
    let Some((signal, forcing)) = io.signal(id).zip(io.forcing(id)) else { return String::new() };
    let number = match signal.direction {
        Direction::Input => io.hardware(id),
        Direction::Output => io.image(id),
    };
    let number = number.unwrap_or_default();
    let value = match signal.kind {
        Kind::Digital => (number != 0.0).to_string(),
        Kind::Analog(_) => number.to_string(),
    };
    let marks = [
        (forcing.is_locked, "locked"),
        (forcing.is_simulated, "simulated"),
        (signal.protected, "protected"),
        (forcing.fault.is_some(), "faulty"),
    ];
    let marks: Vec<&str> = marks.into_iter().filter_map(|(holds, mark)| holds.then_some(mark)).collect();
    let direction = if signal.direction == Direction::Input { "input" } else { "output" };
    format!("{value} ({})", [&[direction][..], &marks].concat().join(", "))
}

/// The arm, its power and its speed.
fn robot(controller: &Controller) -> Vec<Property> {
    let state = &controller.devices.state;
    let (arm, robot) = (&state.arm, &state.robot);
    let sample = arm.sample();
    let axes = arm.model().axes();
    let joints: Vec<f64> = arm.joint().into_iter().take(axes).collect();
    let named = |(number, joint): (usize, &f64)| Property::new(format!("j{number}"), format!("{joint:.6}"));
    let trsf = Trsf::from(sample.pose);
    let power = if robot.is_powered() { "on" } else { "off" };
    let mut properties = vec![
        Property::new("arm", arm.model().name()),
        Property::group("joints", list(&joints), (1..).zip(&joints).map(named).collect()),
        Property::group("pose", list(&lengths(&trsf)), pose(&trsf)),
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

fn lengths(trsf: &Trsf) -> [f64; 6] {
    [trsf.x, trsf.y, trsf.z, trsf.rx, trsf.ry, trsf.rz]
}

fn pose(trsf: &Trsf) -> Vec<Property> {
    let names = ["x", "y", "z", "rx", "ry", "rz"];
    names.into_iter().zip(lengths(trsf)).map(|(name, value)| Property::new(name, format!("{value:.6}"))).collect()
}

fn list(numbers: &[f64]) -> String {
    let shown: Vec<String> = numbers.iter().map(|number| format!("{number:.3}")).collect();
    format!("{{{}}}", shown.join(", "))
}

/// The recorded moves that are not done.
fn queue(controller: &Controller) -> Vec<Property> {
    controller.motion_queue().iter().map(queued).collect()
}

fn queued(queued: &RecordedMove) -> Property {
    let phase = match queued.phase {
        MovePhase::Waiting => "waiting",
        MovePhase::Nominal => "nominal",
        MovePhase::Blend => "blend",
    };
    let target = Trsf::from(queued.target);
    let mut inside =
        vec![Property::new("phase", phase), Property::group("target", list(&lengths(&target)), pose(&target))];
    if let Some(mdesc) = &queued.descriptor {
        let number = |name, value: f64| Property::new(name, value.to_string());
        let parts = vec![
            number("accel", mdesc.accel),
            number("vel", mdesc.vel),
            number("decel", mdesc.decel),
            number("tvel", mdesc.tvel),
            number("rvel", mdesc.rvel),
            Property::new("blend", blend_word(mdesc.blend)),
            number("leave", mdesc.leave),
            number("reach", mdesc.reach),
        ];
        inside.push(Property::group("mdesc", format!("blend={}", blend_word(mdesc.blend)), parts));
    }
    let corners = [("leave", &queued.leave), ("reach", &queued.reach)];
    inside.extend(corners.into_iter().filter_map(|(name, corner)| {
        let BlendPoint { distance, pose: position, .. } = corner.as_ref()?;
        let trsf = Trsf::from(*position);
        let shown = format!("{:.3} mm from the target, {}", distance.0, list(&lengths(&trsf)));
        Some(Property::group(name, shown, pose(&trsf)))
    }));
    let source = queued.source.as_ref();
    if let Some(source) = source {
        inside.push(Property::new("program", source.program.clone()));
        inside.push(Property::new("line", source.line.to_string()));
    }
    let instruction = source.map_or("move", |source| source.instruction);
    Property::group(format!("move {}", queued.id), format!("{instruction}, {phase}"), inside)
}
