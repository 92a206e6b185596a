//! Report of the controller's configuration files.

use super::block::{Block, entry, heading};
use super::changes::optional_arrow;
use super::code;
use crate::model::{Change, EntryChange, SettingsChange};

/// Adds the files that differ.
pub(super) fn add(files: &[SettingsChange], blocks: &mut Vec<Block>) {
    for file in files {
        let note = if file.is_io { "inputs and outputs" } else { "configuration of the controller" };
        blocks.push(heading(1, &file.path, note));
        match file.change {
            Change::Added => blocks.push(entry(file.change.into(), "", "new file")),
            Change::Removed => blocks.push(entry(file.change.into(), "", "the file was removed")),
            Change::Changed => {}
        }
        blocks.extend(file.entries.iter().map(setting));
        if let Some(text) = &file.text {
            code::text(text, blocks);
        }
    }
}

/// Formats `bioDin[3] name  door → gate`.
fn setting(change: &EntryChange) -> Block {
    let kind = Change::of(change.old.is_some(), change.new.is_some());
    let text = match (&change.old, &change.new) {
        (Some(old), Some(new)) => optional_arrow(Some(old), Some(new)),
        (old, new) => old.as_ref().or(new.as_ref()).cloned().unwrap_or_default(),
    };
    entry(kind.into(), &change.entry, text)
}
