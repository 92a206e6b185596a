//! `val3 status --soap`: what a controller does now.

mod document;

use val3_soap::v0::{CartesianPosition, GetRobotJntCartPos, GetRobots, GetSoapServerVersion, Kinematic};
use val3_soap::v1::{GetApplications, ListedApplication};
use val3_soap::v2::{GetTasks, TaskState, TaskStatus};

use crate::controller::soap_client::{SoapClient, SoapTarget};
use crate::user_error::UserError;

pub(super) use document::document;

/// Index of the linear axis of a SCARA arm.
const LINEAR_AXIS: usize = 2;

/// State of a controller.
#[derive(Debug)]
pub(super) struct LiveState {
    /// Host and port.
    pub(super) place: String,
    /// Version of the interface.
    interface: String,
    arms: Vec<LiveArm>,
    applications: Vec<ListedApplication>,
    tasks: Vec<TaskStatus>,
}

#[derive(Debug)]
struct LiveArm {
    name: String,
    /// Joints, in degrees or mm.
    joints: Vec<f64>,
    /// Flange in `world`: x, y and z in mm, then rx, ry and rz in degrees.
    flange: [f64; 6],
}

impl LiveState {
    /// Reads the state in one session. Nothing is changed on the controller.
    ///
    /// # Errors
    /// The controller cannot be reached, rejects the login, or does not answer a request.
    pub(super) fn read(target: &SoapTarget) -> Result<Self, UserError> {
        let mut client = SoapClient::login(target)?;
        let state = Self::read_with(&mut client, target.place());
        let closed = client.logout();
        let state = state?;
        closed?;
        Ok(state)
    }

    fn read_with(client: &mut SoapClient, place: String) -> Result<Self, UserError> {
        let identity = GetSoapServerVersion {
            client_name: Some("val3".to_owned()),
            client_version: Some(env!("CARGO_PKG_VERSION").to_owned()),
        };
        let interface = client.call(&identity)?.server.version.unwrap_or_default();
        let mut arms = Vec::new();
        for (robot, described) in (0..).zip(client.call(&GetRobots {})?.robots) {
            let position = client.call(&GetRobotJntCartPos { robot, tool: None, frame: None })?;
            let is_linear = |axis| described.kinematic == Kinematic::Scara && axis == LINEAR_AXIS;
            let unit = |(axis, joint): (usize, f64)| if is_linear(axis) { joint * 1000.0 } else { joint.to_degrees() };
            arms.push(LiveArm {
                name: described.arm.unwrap_or_default(),
                joints: position.joints.into_iter().enumerate().map(unit).collect(),
                flange: shown_position(&position.position),
            });
        }
        let applications = client.call(&GetApplications {})?.applications;
        let tasks = client.call(&GetTasks {})?.tasks;
        Ok(Self { place, interface, arms, applications, tasks })
    }

    /// The state for people.
    pub(super) fn lines(&self) -> Vec<String> {
        let mut lines = vec![format!("{}: interface {}", self.place, self.interface)];
        for (index, LiveArm { name, joints, flange }) in self.arms.iter().enumerate() {
            lines.push(format!("arm {index}: {name}"));
            lines.push(format!("  joints  {}", numbers(joints)));
            lines.push(format!("  flange  {} in world", numbers(flange)));
        }
        let loaded: Vec<&str> = self
            .applications
            .iter()
            .filter(|application| application.loaded)
            .filter_map(|application| application.name.as_deref())
            .collect();
        lines.push(match loaded[..] {
            [] => "no application is in memory".to_owned(),
            _ => format!("in memory: {}", loaded.join(", ")),
        });
        if self.tasks.is_empty() {
            lines.push("no tasks".to_owned());
        }
        lines.extend(self.tasks.iter().map(task_line));
        lines
    }
}

fn task_line(task: &TaskStatus) -> String {
    let text = |text: &Option<String>| text.clone().unwrap_or_default();
    let error = match task.error {
        0 => String::new(),
        code => format!(", error {code} {}", text(&task.error_description)),
    };
    let line = &task.line;
    let (name, state) = (text(&task.name), state_word(task.state));
    let (program, number, code) = (text(&line.program), line.number, text(&line.content));
    format!("task {name}: {state}{error}, {program} line {number}: {}", code.trim())
}

/// State of a task for people and documents.
const fn state_word(state: TaskState) -> &'static str {
    match state {
        TaskState::Idle => "idle",
        TaskState::Transition => "in transition",
        TaskState::Running => "running",
        TaskState::Stepping => "stepping",
        TaskState::Stopped => "stopped",
    }
}

fn shown_position(position: &CartesianPosition) -> [f64; 6] {
    let CartesianPosition { x, y, z, rx, ry, rz } = position;
    [x * 1000.0, y * 1000.0, z * 1000.0, rx.to_degrees(), ry.to_degrees(), rz.to_degrees()]
}

fn numbers(values: &[f64]) -> String {
    values.iter().map(|value| format!("{value:.3}")).collect::<Vec<_>>().join(" ")
}
