//! External state in tests: a list of tasks.

use std::collections::BTreeMap;

use val3_kinematics::Arm;

use crate::fault::{Fault, Result};
use crate::memory::View;
use crate::ports::{CodePlace, MoveRequest, Origin, Ports, RuntimeRequest, TaskChange, TaskNumber, Tasks};
use crate::runtime_errors::{NO_TASK, TaskStatusCode};
use crate::types::BaseType;

/// Ports with only an arm; the tested handlers require nothing else.
pub(crate) struct NoController {
    pub(crate) arm: Arm,
    /// Recorded moves.
    pub(crate) moves: Vec<MoveRequest>,
    /// Start of the next move as set by `resetMotion`.
    pub(crate) start: Option<[f64; 6]>,
}

impl Default for NoController {
    fn default() -> Self {
        Self { arm: Arm::by_name("TX2-90").unwrap(), moves: Vec::new(), start: None }
    }
}

impl Ports for NoController {
    fn origin(&mut self, _: Origin) {}

    fn task(&mut self, _: TaskNumber, _: &str, _: TaskChange, _: Option<CodePlace>) {}

    fn port(&mut self, _: BaseType, _: &str) -> Option<u32> {
        None
    }
}

/// Tasks by name, and data for `getData`.
#[derive(Debug, Default)]
pub(crate) struct TaskList {
    pub(crate) states: BTreeMap<String, TaskStatusCode>,
    pub(crate) data: BTreeMap<String, View>,
    /// Library identifiers.
    pub(crate) libraries: Vec<&'static str>,
}

impl TaskList {
    fn state(&mut self, name: &str) -> Result<&mut TaskStatusCode> {
        self.states.get_mut(name).ok_or(Fault(NO_TASK))
    }
}

impl Tasks for TaskList {
    fn status(&self, name: &str) -> i16 {
        self.states.get(name).map_or(TaskStatusCode::Absent, |state| *state).number()
    }

    fn suspend(&mut self, name: &str) -> Result<()> {
        *self.state(name)? = TaskStatusCode::Halted;
        Ok(())
    }

    fn resume(&mut self, name: &str, _: f64) -> Result<()> {
        *self.state(name)? = TaskStatusCode::Running;
        Ok(())
    }

    fn kill(&mut self, name: &str) {
        self.states.remove(name);
    }

    fn data(&self, name: &str) -> std::result::Result<View, i16> {
        let is_known = name.split_once(':').is_none_or(|(library, _)| self.libraries.contains(&library));
        self.data.get(name).copied().ok_or(if is_known { -1 } else { -2 })
    }

    fn request(&mut self, _: RuntimeRequest) {}

    fn path(&self, _: Option<u16>) -> String {
        String::new()
    }

    fn exports(&self, _: u16, _: &str) -> bool {
        false
    }
}
