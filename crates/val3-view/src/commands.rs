//! Commands of pages.

use std::collections::BTreeSet;

use serde::Serialize;
use serde_json::{Map, Value};
use val3_geometry::{Trsf, chain};
use val3_lang::call::{FrameRef, PointRef};
use val3_lang::memory::Place;
use val3_lang::references::{self, Chain};
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_machine::devices::SavedValues;
use val3_machine::event::EventKind;
use val3_machine::files::FileFault;
use val3_machine::script::ScriptAction;

use crate::positions::{self, GlobalValue};
use crate::wire::{
    Arguments as _, CommandError, ElementKey, Operate, PageChoice, PointName, Save, Saved, SetPoint, Teach,
    UnsavedMessage, UserPage,
};

/// Operators of a run. All pages share the changes that were not saved.
#[derive(Debug, Default)]
pub struct Operator {
    /// Points with new values.
    changed: BTreeSet<PointName>,
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
            "operate" => operate(Operate::read(arguments)?, controller)?,
            "setPoint" => {
                let point_set = SetPoint::read(arguments)?;
                let local = point_set.trsf();
                let point = point(&point_set.name, point_set.key, controller)?;
                self.change(point, |point| write(point, &local, controller))?;
            }
            "teach" => {
                let Teach { name, key } = Teach::read(arguments)?;
                self.change(point(&name, key, controller)?, |point| teach(point, controller))?;
            }
            "save" => return Ok(response(&self.save(&Save::read(arguments)?, controller)?)),
            "userPage" => user_page(&UserPage::read(arguments)?, controller),
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
    pub fn unsaved(&self) -> UnsavedMessage {
        UnsavedMessage { points: self.changed.iter().cloned().collect() }
    }

    /// Writes the changed points to copies of their files, next to them: `main.dtx.unsaved`. Returns the names of the
    /// copies.
    ///
    /// # Errors
    /// A file cannot be read or written, or belongs to an encrypted library.
    pub fn save_copies(&self, controller: &mut Controller) -> Result<Vec<String>, CommandError> {
        let places = self.changed_places(controller);
        controller.devices.save_copies(&controller.vm.space, &places).map_err(not_saved)
    }

    /// Copies the unsaved values to a controller that has loaded the application again. Points that no longer exist are
    /// no longer unsaved; their names are returned.
    pub fn carry(&mut self, from: &Controller, to: &mut Controller) -> Vec<PointName> {
        let changed: Vec<GlobalValue> =
            positions::data(from).into_iter().filter(|datum| self.has_changed(datum)).collect();
        let loaded = positions::data(to);
        let mut kept = BTreeSet::new();
        for old in &changed {
            let new = loaded.iter().find(|new| (&new.name, &new.key, new.base) == (&old.name, &old.key, old.base));
            if new.is_some_and(|new| copy_numbers((old, from), (new, to)).is_some()) {
                kept.insert(PointName { name: old.name.clone(), key: old.key.clone() });
            }
        }
        let before = std::mem::replace(&mut self.changed, kept);
        before.difference(&self.changed).cloned().collect()
    }

    /// Places of the changed points, without points that the program has removed meanwhile.
    fn changed_places(&self, controller: &Controller) -> Vec<Place> {
        let data = positions::data(controller).into_iter();
        data.filter(|datum| self.has_changed(datum)).map(|datum| datum.place).collect()
    }

    fn change(
        &mut self,
        point: GlobalValue,
        write: impl FnOnce(&GlobalValue) -> Result<(), CommandError>,
    ) -> Result<(), CommandError> {
        write(&point)?;
        self.changed.insert(PointName { name: point.name, key: point.key });
        Ok(())
    }

    /// Whether a value is a changed point.
    fn has_changed(&self, datum: &GlobalValue) -> bool {
        datum.base == BaseType::Point
            && self.changed.contains(&PointName { name: datum.name.clone(), key: datum.key.clone() })
    }

    /// Writes the changed points to their files.
    fn save(&mut self, save: &Save, controller: &mut Controller) -> Result<Saved, CommandError> {
        let places = self.changed_places(controller);
        let saved = controller.devices.save_values(&controller.vm.space, &places, save.overwrite);
        Ok(match saved.map_err(not_saved)? {
            SavedValues::Conflict(files) => Saved::Conflict(files),
            SavedValues::Written(files) => {
                self.changed.clear();
                Saved::Files(files)
            }
        })
    }
}

/// Copies all numbers of a value, with its configuration; `None` if their counts differ.
fn copy_numbers((old, from): (&GlobalValue, &Controller), (new, to): (&GlobalValue, &mut Controller)) -> Option<()> {
    let (from, to) = (&from.vm.space.memory, &mut to.vm.space.memory);
    let count = from.store(old.place.store).ok()?.kind.size.num;
    if to.store(new.place.store).ok()?.kind.size.num != count {
        return None;
    }
    (0..count).try_for_each(|lane| to.set_num(new.place, lane, from.num(old.place, lane).ok()?).ok())
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
fn user_page(page: &UserPage, controller: &mut Controller) {
    let pendant = &mut controller.devices.state.pendant;
    match page.to {
        PageChoice::Next => pendant.show_next(),
        PageChoice::Previous => pendant.show_previous(),
        PageChoice::First => pendant.show_first(),
        PageChoice::Last => pendant.show_last(),
    }
}

fn operate(operate: Operate, controller: &mut Controller) -> Result<(), CommandError> {
    let action = ScriptAction::from_json(operate.keys).map_err(|error| CommandError(error.to_string()))?;
    controller.act(&action).map_err(|problems| CommandError(problems.join("; ")))
}

/// Keys of a response to a command.
#[must_use]
pub fn response(response: &impl Serialize) -> Map<String, Value> {
    match serde_json::to_value(response) {
        Ok(Value::Object(keys)) => keys,
        _ => Map::new(),
    }
}

/// Finds the point that a command names.
fn point(name: &str, key: Option<ElementKey>, controller: &Controller) -> Result<GlobalValue, CommandError> {
    let key = key.map(ElementKey::into_text);
    let mut points = positions::data(controller).into_iter().filter(|datum| datum.base == BaseType::Point);
    let found = points.find(|point| point.name == name && point.key == key);
    found.ok_or_else(|| {
        CommandError(match key {
            Some(key) => format!("there is no point `{name}[{key}]`"),
            None => format!("there is no point `{name}` with a single value"),
        })
    })
}

/// Sets a point to the current pose of the tool centre point, relative to the point's father. Its configuration is
/// unchanged.
fn teach(point: &GlobalValue, controller: &mut Controller) -> Result<(), CommandError> {
    let here = Trsf::from(controller.arm().sample().pose);
    let memory = &controller.vm.space.memory;
    let frame = references::frame_of(memory, PointRef(point.place));
    let frame = frame.and_then(|FrameRef(frame)| references::of_frame(memory, FrameRef(frame)));
    let frame = frame.map_err(|fault| CommandError(format!("the point has no frame (error {})", fault.0)))?;
    let local = chain::position(&Chain::from_iter([here]), &frame);
    write(point, &local, controller)
}

fn write(point: &GlobalValue, local: &Trsf, controller: &mut Controller) -> Result<(), CommandError> {
    let memory = &mut controller.vm.space.memory;
    let numbers = crate::numbers(local);
    let written = (0..).zip(numbers).try_for_each(|(lane, number)| memory.set_num(point.place, lane, number));
    written.map_err(|fault| CommandError(format!("the point cannot be changed (error {})", fault.0)))
}

#[cfg(test)]
mod tests;
