//! Commands of pages.

mod edits;
mod father;
mod lookup;
mod range;
mod solve;
mod store;
mod teach;
mod teach_frame;
mod teach_tool;

use serde::Serialize;
use serde_json::{Map, Value};
use val3_lang::memory::Place;
use val3_lang::types::BaseType;
use val3_machine::controller::Controller;
use val3_machine::devices::SavedValues;
use val3_machine::event::EventKind;
use val3_machine::files::FileFault;
use val3_machine::script::ScriptAction;

use crate::positions::{self, GlobalValue};
use crate::wire::{
    Arguments as _, CommandError, Operate, PageChoice, PointName, Reach, Save, Saved, SetPoint, Solve, Teach,
    TeachFrame, TeachTool, UnsavedMessage, UserPage,
};
use edits::Edits;
pub(crate) use lookup::tool_of_last_move;
use lookup::{datum, frame_named, no_datum, tool_named};
use range::check_range;
pub(crate) use solve::out_of_reach;
use solve::{solve, unreachable};
use store::write;
use teach::teach;
use teach_frame::teach_frame;
use teach_tool::teach_tool;

/// State of operator commands in a run. All pages share the unsaved changes.
#[derive(Debug, Default)]
pub struct Operator {
    edits: Edits,
}

impl Operator {
    /// Executes a command between two cycles: `operate`, `setPoint`, `teach`, `teachFrame`, `teachTool`, `undo`,
    /// `solve`, `reach`, `save`, `userPage`. Returns the keys of its response.
    ///
    /// # Errors
    /// The command is unknown, its arguments are invalid, or the controller rejects it.
    pub fn execute(
        &mut self,
        name: &str,
        arguments: &Map<String, Value>,
        controller: &mut Controller,
    ) -> Result<Map<String, Value>, CommandError> {
        let mut done = Map::new();
        match name {
            "operate" => operate(Operate::read(arguments)?, controller)?,
            "setPoint" => {
                let point_set = SetPoint::read(arguments)?;
                let local = point_set.local;
                let point = datum(&point_set.name, point_set.key, controller)?;
                self.edits.change(point, controller, |point, controller| set_point(point, &local, controller))?;
            }
            "teach" => {
                let Teach { name, key, tool, frame } = Teach::read(arguments)?;
                let datum = datum(&name, key, controller)?;
                let frame = frame.map(|frame| father::of_command(frame, &datum, controller)).transpose()?;
                self.edits.change(datum, controller, |datum, controller| teach(datum, tool, frame, controller))?;
            }
            "teachFrame" => {
                let TeachFrame { name, key, tool, joints } = TeachFrame::read(arguments)?;
                let frame = frame_named(&name, key, controller)?;
                self.edits
                    .change(frame, controller, |frame, controller| teach_frame(frame, tool, &joints, controller))?;
            }
            "teachTool" => {
                let TeachTool { name, key, joints } = TeachTool::read(arguments)?;
                let tool = tool_named(&name, key, controller)?;
                let taught =
                    self.edits.change(tool, controller, |tool, controller| teach_tool(tool, &joints, controller))?;
                done = response(&taught);
            }
            "undo" => self.edits.undo(controller)?,
            "solve" => {
                let Solve { name, key, tool } = Solve::read(arguments)?;
                let datum = datum(&name, key, controller)?;
                return Ok(response(&solve(&datum, tool, controller)?));
            }
            "reach" => return Ok(response(&unreachable(Reach::read(arguments)?.tool, controller)?)),
            "save" => return Ok(response(&self.save(&Save::read(arguments)?, controller)?)),
            "userPage" => user_page(&UserPage::read(arguments)?, controller),
            _ => return Err(CommandError(format!("`{name}` is not a command"))),
        }
        // Scripted `operate` commands are recorded by another component.
        if name != "operate" {
            let keys = Map::from_iter([(name.to_owned(), Value::Object(arguments.clone()))]);
            controller.devices.record_outside(controller.now(), EventKind::Act { keys });
        }
        Ok(done)
    }

    /// Message `unsaved`: the positions with unsaved changes.
    #[must_use]
    pub fn unsaved(&self) -> UnsavedMessage {
        self.edits.message()
    }

    /// Writes the changed values to copies next to the files, for example `main.dtx.unsaved`. Returns the names of the
    /// copies.
    ///
    /// # Errors
    /// A file cannot be read or written, or belongs to an encrypted library.
    pub fn save_copies(&self, controller: &mut Controller) -> Result<Vec<String>, CommandError> {
        let places = self.changed_places(controller);
        controller.devices.save_copies(&controller.vm.space, &places).map_err(not_saved)
    }

    /// Copies the unsaved values to a controller that has reloaded the application. Values that no longer exist are
    /// discarded, and their names are returned.
    pub fn carry(&mut self, from: &Controller, to: &mut Controller) -> Vec<PointName> {
        self.edits.carry(from, to)
    }

    /// Memory addresses of the changed values, without values that the program has removed meanwhile.
    fn changed_places(&self, controller: &Controller) -> Vec<Place> {
        let data = positions::data(controller).into_iter();
        data.filter(|datum| self.edits.has_changed(datum)).map(|datum| datum.place).collect()
    }

    /// Writes the changed values to their files.
    fn save(&mut self, save: &Save, controller: &mut Controller) -> Result<Saved, CommandError> {
        let places = self.changed_places(controller);
        let saved = controller.devices.save_values(&controller.vm.space, &places, save.overwrite);
        Ok(match saved.map_err(not_saved)? {
            SavedValues::Conflict(files) => Saved::Conflict(files),
            SavedValues::Written(files) => {
                self.edits.mark_saved();
                Saved::Files(files)
            }
        })
    }
}

fn not_saved(fault: FileFault) -> CommandError {
    CommandError(match fault {
        FileFault::ReadOnly => "the file is write-protected, or belongs to an encrypted library".to_owned(),
        FileFault::WriteProtected => "the medium is write-protected".to_owned(),
        FileFault::DiskFull => "no room is left on the medium".to_owned(),
        FileFault::NotFound => "the application has no files".to_owned(),
        FileFault::Unwritable => {
            "a data file cannot contain one of the values: a number that is infinite or undefined, a \
                                  control character, or in s5 and s6 different fathers in one variable"
                .to_owned()
        }
        fault => format!("the files cannot be written (error {} of `libSave`)", fault.code()),
    })
}

/// Shows the next or previous user page, like the keys User-Up and User-Down (4.2).
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

/// Sets the coordinates of a point in its frame, in the length unit of the application. The configuration is unchanged.
fn set_point(point: &GlobalValue, local: &[f64; 6], controller: &mut Controller) -> Result<(), CommandError> {
    if point.base != BaseType::Point {
        return Err(no_datum("point", &point.name, point.key.as_deref()));
    }
    let present = positions::nums(&controller.vm.space.memory, point.place, 6).unwrap_or_default();
    check_range(local, &present, controller.length_unit())?;
    write(point, (0..).zip(*local), controller)
}

#[cfg(test)]
mod tests;
