//! Changes by operators: the unsaved values, and the values before each change.

use std::collections::BTreeSet;

use val3_lang::types::BaseType;
use val3_machine::controller::Controller;

use super::father;
use super::store::write;
use crate::positions::{self, GlobalValue};
use crate::wire::{CommandError, PointName, UnsavedMessage};

/// Maximum number of changes that can be undone.
const MOST_EDITS: usize = 1000;

/// Changes of points, joint positions, frames and tools.
#[derive(Debug, Default)]
pub(super) struct Edits {
    /// Values that differ from their files.
    unsaved: BTreeSet<PointName>,
    /// Changes, oldest first.
    done: Vec<Edit>,
}

/// A change of a value.
#[derive(Debug)]
struct Edit {
    name: PointName,
    /// Numbers before the change.
    before: Vec<f64>,
    /// Father before the change.
    father: Option<PointName>,
    /// Whether the value before the change is not in its file.
    was_unsaved: bool,
}

impl Edits {
    /// Changes a value. Returns the result of `write`.
    ///
    /// # Errors
    /// The errors of `write`.
    pub(super) fn change<T>(
        &mut self,
        datum: GlobalValue,
        controller: &mut Controller,
        write: impl FnOnce(&GlobalValue, &mut Controller) -> Result<T, CommandError>,
    ) -> Result<T, CommandError> {
        let before = positions::all_nums(&controller.vm.space.memory, datum.place);
        let before = before.ok_or_else(|| CommandError(format!("`{}` does not exist any more", datum.name)))?;
        let father = father::name_of(&datum, controller);
        let written = write(&datum, controller)?;
        let name = PointName { name: datum.name, key: datum.key };
        let was_unsaved = !self.unsaved.insert(name.clone());
        if self.done.len() >= MOST_EDITS {
            self.done.remove(0);
        }
        self.done.push(Edit { name, before, father, was_unsaved });
        Ok(written)
    }

    /// Restores the value before the last change.
    ///
    /// # Errors
    ///
    /// There is no change to undo, or the program has removed the value.
    pub(super) fn undo(&mut self, controller: &mut Controller) -> Result<(), CommandError> {
        let Some(Edit { name, before, father, was_unsaved }) = self.done.pop() else {
            return Err("nothing was changed".into());
        };
        if !was_unsaved {
            self.unsaved.remove(&name);
        } else {
            self.unsaved.insert(name.clone());
        }
        let datum = positions::data(controller).into_iter().find(|datum| is_named(datum, &name));
        let datum = datum.ok_or_else(|| CommandError(format!("`{}` does not exist any more", name.name)))?;
        set_father(&datum, father.as_ref(), controller)?;
        write(&datum, (0..).zip(before), controller)
    }

    /// Whether a value has an unsaved change.
    pub(super) fn has_changed(&self, datum: &GlobalValue) -> bool {
        self.unsaved.iter().any(|name| is_named(datum, name))
    }

    /// Marks all values as saved. Undoing an earlier change makes its value unsaved again.
    pub(super) fn mark_saved(&mut self) {
        self.unsaved.clear();
        for edit in &mut self.done {
            edit.was_unsaved = true;
        }
    }

    /// Copies the unsaved values to a controller that has reloaded the application. Values that no longer exist are
    /// discarded, together with their changes, and their names are returned.
    pub(super) fn carry(&mut self, from: &Controller, to: &mut Controller) -> Vec<PointName> {
        let loaded = positions::data(to);
        let mut kept = BTreeSet::new();
        for old in positions::data(from).into_iter().filter(|datum| self.has_changed(datum)) {
            let new = loaded.iter().find(|new| (&new.name, &new.key, new.base) == (&old.name, &old.key, old.base));
            let Some(new) = new else { continue };
            let father = father::name_of(&old, from);
            if set_father(new, father.as_ref(), to).is_ok() && copy_numbers(&old, from, new, to).is_some() {
                kept.insert(PointName { name: old.name, key: old.key });
            }
        }
        let before = std::mem::replace(&mut self.unsaved, kept);
        let lost: Vec<PointName> = before.difference(&self.unsaved).cloned().collect();
        self.done.retain(|edit| !lost.contains(&edit.name));
        lost
    }

    /// Message `unsaved`.
    pub(super) fn message(&self) -> UnsavedMessage {
        let undo = self.done.last().map(|edit| edit.name.clone());
        UnsavedMessage { points: self.unsaved.iter().cloned().collect(), undo }
    }
}

/// Whether a value has this name and key.
fn is_named(datum: &GlobalValue, name: &PointName) -> bool {
    let is_position = matches!(datum.base, BaseType::Point | BaseType::Joint | BaseType::Frame | BaseType::Tool);
    is_position && datum.name == name.name && datum.key == name.key
}

/// Gives a value this father, unless it has this father already.
fn set_father(
    datum: &GlobalValue,
    father: Option<&PointName>,
    controller: &mut Controller,
) -> Result<(), CommandError> {
    match father {
        Some(father) if father::name_of(datum, controller).as_ref() != Some(father) => {
            father::set(datum, father, controller)
        }
        _ => Ok(()),
    }
}

/// Copies all numbers of a value, including its configuration; `None` if the counts differ.
fn copy_numbers(old: &GlobalValue, from: &Controller, new: &GlobalValue, to: &mut Controller) -> Option<()> {
    let (from, to) = (&from.vm.space.memory, &mut to.vm.space.memory);
    let count = from.store(old.place.store).ok()?.kind.size.num;
    if to.store(new.place.store).ok()?.kind.size.num != count {
        return None;
    }
    (0..count).try_for_each(|lane| to.set_num(new.place, lane, from.num(old.place, lane).ok()?).ok())
}
