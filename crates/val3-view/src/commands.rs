//! Commands of pages.

use std::fmt;

use serde_json::{Map, Value};
use val3_geometry::{Trsf, chain};
use val3_lang::call::{FrameRef, PointRef};
use val3_lang::references::{self, Chain};
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_machine::script::Action;

use crate::positions::{self, Datum};

/// The reason why a command was not executed, for users.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CommandError(String);

impl fmt::Display for CommandError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for CommandError {}

impl From<&str> for CommandError {
    fn from(text: &str) -> Self {
        Self(text.to_owned())
    }
}

/// Executes a command between two cycles: `operate`, `setPoint`, `teach`.
///
/// # Errors
/// The command is unknown, its arguments are wrong, or the controller refuses it.
pub fn execute(name: &str, arguments: &Map<String, Value>, controller: &mut Controller) -> Result<(), CommandError> {
    match name {
        "operate" => operate(arguments, controller),
        "setPoint" => {
            let local = trsf(arguments.get("local")).ok_or("`local` has six numbers: x, y, z, rx, ry, rz")?;
            write(&point(arguments, controller)?, &local, controller)
        }
        "teach" => teach(&point(arguments, controller)?, controller),
        _ => Err(CommandError(format!("`{name}` is not a command"))),
    }
}

fn operate(arguments: &Map<String, Value>, controller: &mut Controller) -> Result<(), CommandError> {
    let Some(Value::Object(keys)) = arguments.get("keys") else {
        return Err("`keys` is an object with the keys of a script".into());
    };
    let action = Action::from_json(keys.clone()).map_err(|error| CommandError(error.to_string()))?;
    controller.act(&action).map_err(|problems| CommandError(problems.join("; ")))
}

fn trsf(value: Option<&Value>) -> Option<Trsf> {
    let numbers: Vec<f64> = value?.as_array()?.iter().map(Value::as_f64).collect::<Option<_>>()?;
    match numbers.as_slice() {
        &[x, y, z, rx, ry, rz] => Some(Trsf { x, y, z, rx, ry, rz }),
        _ => None,
    }
}

/// The point that a command names.
fn point(arguments: &Map<String, Value>, controller: &Controller) -> Result<Datum, CommandError> {
    let name = arguments.get("name").and_then(Value::as_str).ok_or("`name` is that of a point")?;
    let key = arguments.get("key").and_then(Value::as_str);
    let is_meant = |datum: &Datum| datum.base == BaseType::Point && datum.name == name && datum.key.as_deref() == key;
    let found = positions::data(controller).into_iter().find(is_meant);
    found.ok_or_else(|| CommandError(format!("there is no point `{name}` with this index")))
}

/// Writes where the tool centre point is into a point, seen from the point's frame. Its configuration stays.
fn teach(point: &Datum, controller: &mut Controller) -> Result<(), CommandError> {
    let here = Trsf::from(controller.devices.state.arm.sample().pose);
    let memory = &controller.vm.space.memory;
    let frame = references::frame_of(memory, PointRef(point.place));
    let frame = frame.and_then(|FrameRef(frame)| references::of_frame(memory, FrameRef(frame)));
    let frame = frame.map_err(|fault| CommandError(format!("the point has no frame (error {})", fault.0)))?;
    let local = chain::position(&Chain::from_iter([here]), &frame);
    write(point, &local, controller)
}

fn write(point: &Datum, local: &Trsf, controller: &mut Controller) -> Result<(), CommandError> {
    let memory = &mut controller.vm.space.memory;
    let numbers = crate::numbers(local);
    let written = (0..).zip(numbers).try_for_each(|(lane, number)| memory.set_num(point.place, lane, number));
    written.map_err(|fault| CommandError(format!("the point cannot be changed (error {})", fault.0)))
}

#[cfg(test)]
mod tests;
