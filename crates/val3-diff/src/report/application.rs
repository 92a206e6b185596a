//! Report of an application's differences.

use super::block::{Block, ReportMark, entry, heading};
use super::changes::{arrow, optional_arrow};
use super::counts::counted;
use super::groups::groups;
use super::{code, contents, points, renumbering};
use crate::model::ReportClass;
use crate::model::{ApplicationChange, Change, DataChange, InterfaceChange, ItemKind, ReferenceChange, ValueChange};

/// Number of elements that are shown for added or removed data.
const SHOWN: usize = 4;

/// Adds the report of the differences in an application.
pub(super) fn add(change: &ApplicationChange, blocks: &mut Vec<Block>) {
    let name = if change.name.is_empty() { "(this folder)" } else { &change.name };
    blocks.push(heading(1, name, &note(change)));
    if change.change != Change::Changed {
        return whole(change, blocks);
    }
    project(change, blocks);
    references("Libraries", &change.libraries, blocks);
    references("User types", &change.types, blocks);
    interface(change, blocks);
    code::add(&change.programs, blocks);
    for (title, class) in [
        ("Points, frames and tools", ReportClass::Points),
        ("Data", ReportClass::Data),
        ("Inputs and outputs", ReportClass::Io),
    ] {
        data(title, class, &change.data, blocks);
    }
    code::texts(&change.texts, blocks);
    contents::add(&change.contents, blocks);
}

fn note(change: &ApplicationChange) -> String {
    match &change.moved_from {
        Some(from) => format!("{}, moved from {from}", change.path),
        None => change.path.clone(),
    }
}

/// Adds an application that exists in only one tree.
fn whole(change: &ApplicationChange, blocks: &mut Vec<Block>) {
    let parts = [
        (change.programs.len(), "program", "programs"),
        (change.data.len(), "global variable", "global variables"),
        (change.libraries.len(), "library", "libraries"),
        (change.types.len(), "user type", "user types"),
    ];
    let parts: Vec<String> =
        parts.iter().filter(|(count, ..)| *count > 0).map(|(count, one, many)| counted(*count, one, many)).collect();
    let word = if change.change == Change::Added { "new" } else { "removed" };
    let content = if parts.is_empty() { "empty".to_owned() } else { parts.join(", ") };
    blocks.push(entry(change.change.into(), "", format!("{word}: {content}")));
    if !change.used_by.is_empty() {
        blocks.push(entry(ReportMark::Note, "", format!("used by {}", change.used_by.join(", "))));
    }
    code::texts(&change.texts, blocks);
}

fn project(change: &ApplicationChange, blocks: &mut Vec<Block>) {
    if !change.project.is_empty() {
        blocks.push(heading(2, "Project", ""));
    }
    for parameter in &change.project {
        let text = optional_arrow(parameter.old.as_ref(), parameter.new.as_ref());
        blocks.push(entry(ReportMark::Changed, &parameter.name, text));
    }
}

fn references(title: &str, changes: &[ReferenceChange], blocks: &mut Vec<Block>) {
    if !changes.is_empty() {
        blocks.push(heading(2, title, ""));
    }
    for change in changes {
        let text = match (&change.old, &change.new) {
            (Some(old), Some(new)) => format!("{old} → {new}"),
            (old, new) => old.as_ref().or(new.as_ref()).cloned().unwrap_or_default(),
        };
        blocks.push(entry(change.change.into(), &change.name, text));
    }
}

fn interface(change: &ApplicationChange, blocks: &mut Vec<Block>) {
    if change.interface.is_empty() {
        return;
    }
    let users = match change.used_by.as_slice() {
        [] => "no project file here names it".to_owned(),
        users => format!("used by {}", users.join(", ")),
    };
    blocks.push(heading(2, "Interface", &users));
    change.interface.iter().for_each(|item| blocks.push(interface_item(item)));
}

fn interface_item(item: &InterfaceChange) -> Block {
    let kind = if item.kind == ItemKind::Program { "program" } else { "data" };
    let text = match (&item.old, &item.new) {
        (Some(old), Some(new)) => format!("was {old}, is now {new}"),
        (old, new) => old.as_ref().or(new.as_ref()).cloned().unwrap_or_default(),
    };
    entry(item.change.into(), &format!("{kind} {}", item.name), text)
}

fn data(title: &str, class: ReportClass, changes: &[DataChange], blocks: &mut Vec<Block>) {
    let before = blocks.len();
    blocks.push(heading(2, title, ""));
    for change in changes.iter().filter(|change| change.class == class) {
        declaration(change, blocks);
    }
    let values = changes.iter().filter(|change| change.change == Change::Changed).flat_map(listed_values);
    let values: Vec<&ValueChange> = values.filter(|value| value.class == class).collect();
    if class == ReportClass::Points {
        points::add(&values, blocks);
    } else {
        blocks.extend(groups(&values).iter().filter_map(|group| points::values_entry(group)));
    }
    if blocks.len() == before + 1 {
        blocks.pop();
    }
}

/// Returns the values, without removed and inserted elements that are reported as a renumbering.
fn listed_values(change: &DataChange) -> impl Iterator<Item = &ValueChange> {
    let is_renumbered = change.renumbering.is_some();
    change.values.iter().filter(move |value| !is_renumbered || value.change == Change::Changed)
}

/// Adds differences of the declaration, and renumbered elements.
fn declaration(change: &DataChange, blocks: &mut Vec<Block>) {
    if change.change != Change::Changed {
        let access = if change.public.old || change.public.new { "public " } else { "" };
        let name = format!("{access}{}", change.declaration);
        let name = change.value.as_ref().map_or(name.clone(), |value| format!("{name} = {value}"));
        return blocks.push(entry(change.change.into(), &name, elements(change)));
    }
    let parts = [("type", &change.types), ("size", &change.sizes), ("access", &change.access)];
    let parts: Vec<String> =
        parts.iter().filter_map(|(word, pair)| Some(format!("{word} {}", arrow(pair.as_ref()?)))).collect();
    let name = change.renamed_from.as_ref().map(|old| format!("{old} renamed to {}", change.name));
    if !parts.is_empty() || name.is_some() {
        blocks.push(entry(ReportMark::Changed, name.as_ref().unwrap_or(&change.name), parts.join(", ")));
    }
    if let Some(renumbering) = &change.renumbering {
        renumbering::add(change, renumbering, blocks);
    }
}

/// Formats the first elements of added or removed data: `0: "a", 1: "b" and 3 more`.
fn elements(change: &DataChange) -> String {
    let first: Vec<String> = change.values.iter().take(SHOWN).map(|value| element(&change.name, value)).collect();
    match change.values.len().saturating_sub(SHOWN) {
        0 => first.join("; "),
        more => format!("{} and {more} more", first.join("; ")),
    }
}

/// Formats an element of the data `name`: `1: "b"`, or `1` without a value.
fn element(name: &str, change: &ValueChange) -> String {
    let key = change.path.strip_prefix(name).map_or("", |rest| rest.trim_matches(['[', ']']));
    let key = if key.is_empty() { "0" } else { key };
    change.value.as_ref().map_or(key.to_owned(), |value| format!("{key}: {value}"))
}
