//! Grippers of a cell file.

use crate::build::{CellMaker, Thing};
use crate::carriers::{Carried, CarriedKeys, Carrier};
use crate::error::CellError;
use crate::file::{GripperEntry, HoldingState};
use crate::gripper::{Gripper, GripperControl};
use crate::poses::distance;

impl CellMaker<'_> {
    /// Builds the grippers. `names` are the names of all objects in the file.
    pub(super) fn grippers(
        &mut self,
        entries: &[GripperEntry],
        things: &[Thing],
        names: &[&str],
    ) -> Result<Vec<Gripper>, CellError> {
        let mut grippers: Vec<Gripper> = Vec::new();
        for (index, entry) in entries.iter().enumerate() {
            let key = format!("gripper[{index}]");
            if let Some(gripper) = self.gripper(entry, index, things, names)? {
                if grippers.iter().any(|known| known.name == gripper.name) {
                    let message = format!("two grippers are controlled by the tool `{}`", gripper.name);
                    return Err(CellError::new(format!("{key}.tool"), message, "one tool moves one gripper"));
                }
                grippers.push(gripper);
            }
        }
        Ok(grippers)
    }

    /// Builds a gripper; `None` if the application does not have the tool or one of the signals.
    fn gripper(
        &mut self,
        entry: &GripperEntry,
        index: usize,
        things: &[Thing],
        names: &[&str],
    ) -> Result<Option<Gripper>, CellError> {
        let key = format!("gripper[{index}]");
        let name = entry.tool.clone().unwrap_or_else(|| format!("gripper {}", index + 1));
        let within = distance(entry.within, &format!("{key}.within"))?;
        let (Some(control), Some(Carried { carrier, pose }), Some(holding), Some(empty)) = (
            self.control(entry, &key)?,
            self.point(entry, &key)?,
            self.inputs(&entry.holding, &format!("{key}.holding"))?,
            self.inputs(&entry.empty, &format!("{key}.empty"))?,
        ) else {
            self.missing.push(format!("gripper {name}"));
            return Ok(None);
        };
        let pieces = pieces(entry, &carrier, &key, things, names)?;
        Ok(Some(Gripper { name, control, carrier, pose, within, holding, empty, pieces }))
    }

    /// Returns the output that controls a gripper; `None` if the application does not have the output.
    fn control(&self, entry: &GripperEntry, key: &str) -> Result<Option<GripperControl>, CellError> {
        let GripperEntry { tool, holds, when, carrier, at, .. } = entry;
        match (tool, when) {
            (Some(_), Some(_)) => {
                let help = "remove one of them: `tool` for the output of a tool, `when` for other signals";
                Err(CellError::new(format!("{key}.when"), "`tool` and `when` both control the gripper", help))
            }
            (None, None) => {
                let help = "add `tool = \"…\"`, or `when = { io = { \"…\" = true } }` with `in` and `at`";
                Err(CellError::new(key, "nothing controls this gripper", help))
            }
            (Some(_), None) if carrier.is_some() || !at.is_empty() => {
                let wrong = if carrier.is_some() { "in" } else { "at" };
                let message = "the point of this gripper is the tool centre point";
                Err(CellError::new(format!("{key}.{wrong}"), message, "remove `in` and `at`, or use `when`"))
            }
            (Some(tool), None) => {
                let holds_when_open = *holds == Some(HoldingState::Open);
                Ok(Some(GripperControl::Tool { tool: tool.clone(), holds_when_open }))
            }
            (None, Some(_)) if holds.is_some() => {
                let message = "`holds` is about the output of a tool";
                Err(CellError::new(format!("{key}.holds"), message, "state the values in `when`"))
            }
            (None, Some(when)) if when.io.is_empty() => {
                let help = "write `when = { io = { \"BasicIO-1\\\\%Q0\" = true } }`";
                Err(CellError::new(format!("{key}.when"), "`when` names no signal", help))
            }
            (None, Some(when)) => Ok(self.compared(&when.io, &format!("{key}.when.io"))?.map(GripperControl::Signals)),
        }
    }

    /// Returns the carrier and pose of a gripper's grip point; `None` if the application does not have the tool.
    fn point(&self, entry: &GripperEntry, key: &str) -> Result<Option<Carried>, CellError> {
        let (name, word) = match (&entry.tool, &entry.carrier) {
            (Some(tool), _) => (tool.as_str(), "tool"),
            (None, carrier) => (carrier.as_deref().unwrap_or("flange"), "in"),
        };
        let keys = CarriedKeys { carrier: name, at: &entry.at, key };
        let carried = self.carriers.of(keys, self.surroundings).map_err(|error| CellError {
            key: if error.key.ends_with(".in") { format!("{key}.{word}") } else { error.key.clone() },
            ..error
        })?;
        match carried {
            Some(Carried { carrier: Carrier::Flange | Carrier::Tool(_), .. }) | None => Ok(carried),
            Some(_) => {
                let message = format!("`{name}` is no tool, and the arm has to carry a gripper");
                let help = "name a tool of the application, or `flange`";
                Err(CellError::new(format!("{key}.{word}"), message, help))
            }
        }
    }
}

/// Returns the indexes of the things that belong to a gripper.
fn pieces(
    entry: &GripperEntry,
    carrier: &Carrier,
    key: &str,
    things: &[Thing],
    names: &[&str],
) -> Result<Vec<usize>, CellError> {
    if let Some(unknown) = entry.objects.iter().flatten().find(|name| !names.contains(&name.as_str())) {
        let known: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        let help = format!("the objects are {}", known.join(", "));
        return Err(CellError::new(format!("{key}.objects"), format!("there is no object `{unknown}`"), help));
    }
    let pieces = things.iter().enumerate().filter(|(_, thing)| is_piece(thing, entry, carrier));
    Ok(pieces.map(|(number, _)| number).collect())
}

/// Whether a thing belongs to the gripper with this entry and carrier: `objects` lists it, or in an entry without
/// `objects`, the flange or the gripper's carrier carries it.
fn is_piece(thing: &Thing, entry: &GripperEntry, carrier: &Carrier) -> bool {
    match &entry.objects {
        Some(objects) => objects.contains(&thing.name),
        None => thing.carrier == Carrier::Flange || thing.carrier == *carrier,
    }
}
