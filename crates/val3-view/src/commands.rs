//! Commands of pages.

use std::collections::BTreeSet;
use std::fmt;

use serde_json::{Map, Value, json};
use val3_geometry::{Trsf, chain};
use val3_lang::call::{FrameRef, PointRef};
use val3_lang::references::{self, Chain};
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_machine::devices::SavedValues;
use val3_machine::event::EventKind;
use val3_machine::files::FileFault;
use val3_machine::script::Action;

use crate::positions::{self, Datum};

/// Reason why a command was not executed, for users.
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

/// Operators of a run. All pages share the changes that were not saved.
#[derive(Debug, Default)]
pub struct Operator {
    /// Points with new values: names with indexes or keys.
    changed: BTreeSet<(String, Option<String>)>,
}

impl Operator {
    /// Executes a command between two cycles: `operate`, `setPoint`, `teach`, `save`, `userPage`. Returns the keys of
    /// its response.
    ///
    /// # Errors
    /// The command is unknown, its arguments are invalid, or the controller rejects it.
    pub fn execute(
        &mut self,
        name: &str,
        arguments: &Map<String, Value>,
        controller: &mut Controller,
    ) -> Result<Map<String, Value>, CommandError> {
        match name {
            "operate" => operate(arguments, controller)?,
            "setPoint" => {
                let local = trsf(arguments.get("local")).ok_or("`local` has six numbers: x, y, z, rx, ry, rz")?;
                self.change(point(arguments, controller)?, |point| write(point, &local, controller))?;
            }
            "teach" => self.change(point(arguments, controller)?, |point| teach(point, controller))?,
            "save" => return self.save(arguments.get("overwrite") == Some(&Value::Bool(true)), controller),
            "userPage" => user_page(arguments, controller)?,
            _ => return Err(CommandError(format!("`{name}` is not a command"))),
        }
        // `operate` with the keys of a script is recorded elsewhere.
        if name != "operate" {
            let keys = Map::from_iter([(name.to_owned(), Value::Object(arguments.clone()))]);
            controller.devices.record_outside(controller.now(), EventKind::Act { keys });
        }
        Ok(Map::new())
    }

    /// Message `unsaved`: the points with unsaved changes.
    #[must_use]
    pub fn unsaved(&self) -> Value {
        let points = self.changed.iter().map(|(name, key)| json!({ "name": name, "key": key }));
        json!({ "kind": "unsaved", "points": points.collect::<Vec<_>>() })
    }

    fn change(
        &mut self,
        point: Datum,
        write: impl FnOnce(&Datum) -> Result<(), CommandError>,
    ) -> Result<(), CommandError> {
        write(&point)?;
        self.changed.insert((point.name, point.key));
        Ok(())
    }

    /// Writes the changed points to their files, without points that the program has removed meanwhile.
    fn save(&mut self, overwrite: bool, controller: &mut Controller) -> Result<Map<String, Value>, CommandError> {
        let is_changed = |datum: &Datum| {
            datum.base == BaseType::Point && self.changed.contains(&(datum.name.clone(), datum.key.clone()))
        };
        let places: Vec<_> =
            positions::data(controller).into_iter().filter(is_changed).map(|datum| datum.place).collect();
        let saved = controller.devices.save_values(&controller.vm.space, &places, overwrite);
        let (key, files) = match saved.map_err(not_saved)? {
            SavedValues::Conflict(files) => ("conflict", files),
            SavedValues::Written(files) => {
                self.changed.clear();
                ("files", files)
            }
        };
        Ok(Map::from_iter([(key.to_owned(), json!(files))]))
    }
}

fn not_saved(fault: FileFault) -> CommandError {
    CommandError(match fault {
        FileFault::ReadOnly => "the file is write-protected, or belongs to an encrypted library".to_owned(),
        FileFault::WriteProtected => "the medium is write-protected".to_owned(),
        FileFault::DiskFull => "no room is left on the medium".to_owned(),
        FileFault::NotFound => "the application has no files".to_owned(),
        fault => format!("the files cannot be written (error {} of `libSave`)", fault.code()),
    })
}

/// Shows another user page, as the keys User-Up and User-Down do (4.2).
fn user_page(arguments: &Map<String, Value>, controller: &mut Controller) -> Result<(), CommandError> {
    let pendant = &mut controller.devices.state.pendant;
    match arguments.get("to").and_then(Value::as_str) {
        Some("next") => pendant.show_next(),
        Some("previous") => pendant.show_previous(),
        Some("first") => pendant.show_first(),
        Some("last") => pendant.show_last(),
        _ => return Err("`to` is \"next\", \"previous\", \"first\" or \"last\"".into()),
    }
    Ok(())
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

/// Finds the point that a command names.
fn point(arguments: &Map<String, Value>, controller: &Controller) -> Result<Datum, CommandError> {
    let name = arguments.get("name").and_then(Value::as_str).ok_or("`name` is that of a point")?;
    let key = key(arguments.get("key"))?;
    let is_meant = |datum: &Datum| datum.base == BaseType::Point && datum.name == name && datum.key == key;
    let found = positions::data(controller).into_iter().find(is_meant);
    found.ok_or_else(|| {
        CommandError(match key {
            Some(key) => format!("there is no point `{name}[{key}]`"),
            None => format!("there is no point `{name}` with a single value"),
        })
    })
}

/// Element index or key as text; `None` for data with a single value.
fn key(value: Option<&Value>) -> Result<Option<String>, CommandError> {
    match value {
        None | Some(Value::Null) => Ok(None),
        Some(Value::String(key)) => Ok(Some(key.clone())),
        Some(Value::Number(index)) if index.is_u64() => Ok(Some(index.to_string())),
        Some(_) => Err("`key` is a whole number from 0, or a text: \"1\", \"1,2\" or the key of a collection".into()),
    }
}

/// Sets a point to the current pose of the tool centre point, relative to the point's father. Its configuration is
/// unchanged.
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
