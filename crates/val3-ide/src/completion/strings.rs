//! Strings with known contents in instructions: library paths, names, formats, keys.

use val3_analysis::application::application;
use val3_analysis::interfaces::{self, Fit};
use val3_analysis::items::project::items;
use val3_analysis::items::{parse, program};
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::Base;
use val3_lang::arguments::{BINARY_FORMATS, DATE_KEYS, SERIAL_PARAMETERS, SerialParameter, SerialValue, TextForm};
use val3_syntax::xml::escaped;
use val3_syntax::{SyntaxKind, TextRange, TextSize, TextSlice};

use super::list::{CompletionKind, CompletionList};
use super::names::{FITS, data_detail};
use super::text_place::{Collection, TextPlace};
use crate::hover::keys_of;
use crate::reachable_projects::reachable;
use crate::rename::spelt_keys;

/// Possible contents of a string.
pub(super) fn texts(found: &mut CompletionList<'_>, place: &TextPlace) {
    match place {
        TextPlace::LibraryPath(alias) => paths(found, alias.as_deref()),
        TextPlace::LibraryItem(library) => library_items(found, library),
        TextPlace::Task => tasks(found),
        TextPlace::DataName(base) => data_names(found, *base),
        TextPlace::Format(format) => formats(found, *format),
        TextPlace::SerialParameter => words(found, SERIAL_PARAMETERS.iter().map(|row| row.name), "parameter"),
        TextPlace::SerialValue(parameter) => {
            if let Some(SerialValue::OneOf(values)) = SerialParameter::find(parameter).map(|row| row.value) {
                words(found, values.iter().copied(), "value");
            }
        }
        TextPlace::Key(collection) => {
            for key in keys(found, collection) {
                found.add(&key, CompletionKind::Text).detail(|| "key".to_owned());
            }
        }
    }
}

fn words<'w>(found: &mut CompletionList<'_>, words: impl Iterator<Item = &'w str>, detail: &str) {
    for (place, word) in (0..).zip(words) {
        found.add(word, CompletionKind::Text).detail(|| detail.to_owned()).scored(-place);
    }
}

/// Libraries that the application can load. For an identifier, libraries that implement its interface come first.
fn paths(found: &mut CompletionList<'_>, alias: Option<&str>) {
    let (db, project) = (found.db, found.project);
    for library in reachable(db, project) {
        let fit = alias.map(|alias| interfaces::fit(db, project, alias, library.project));
        let (detail, score) = match fit {
            Some(Fit::Whole) => ("library, fits the interface", 2 * FITS),
            Some(Fit::Used) => ("library with all used items of the interface", FITS),
            Some(Fit::Lacks) | None => ("library", 0),
        };
        found.add(&library.short, CompletionKind::Path).detail(|| detail.to_owned()).scored(score);
    }
}

/// Data and programs of the library's interface.
fn library_items(found: &mut CompletionList<'_>, library: &str) {
    let Some(interface) = found.names().interface(library) else { return };
    let offered = items(found.db, interface);
    for (name, item) in offered.data.iter().filter(|(_, item)| item.decl.public) {
        let added = found.add(name, CompletionKind::Data).detail(|| data_detail(item));
        added.of(|| Symbol::Data(interface, name.clone()));
    }
    for name in offered.programs.keys() {
        let added = found.add(&format!("{name}()"), CompletionKind::Program).detail(|| "program".to_owned());
        added.of(|| Symbol::Program(interface, name.clone()));
    }
}

/// Tasks that the application creates.
fn tasks(found: &mut CompletionList<'_>) {
    let application = application(found.db, found.project);
    for task in &application.tasks {
        let Some(name) = &task.start.name else { continue };
        found.add(name, CompletionKind::Text).detail(|| format!("task, runs {}", task.start.program.program));
    }
}

/// Names of data, restricted to the type that receives the value, if it is known.
fn data_names(found: &mut CompletionList<'_>, base: Option<Base>) {
    let project = found.project;
    let suits = |found: Base| base.is_none_or(|base| base.same_as(found));
    for (name, item) in items(found.db, project).data.iter().filter(|(_, item)| suits(item.base)) {
        let added = found.add(name, CompletionKind::Data).detail(|| data_detail(item));
        added.of(|| Symbol::Data(project, name.clone()));
    }
}

fn formats(found: &mut CompletionList<'_>, format: TextForm) {
    match format {
        TextForm::Binary => words(found, BINARY_FORMATS.into_iter(), "binary format"),
        TextForm::Number => words(found, [".0", ".1", ".2", ".3", "8.3"].into_iter(), "size.precision"),
        TextForm::Date => {
            last_key_alone(found);
            words(found, DATE_KEYS.into_iter(), "part of the date");
        }
    }
}

/// Restricts the completion to the key at the cursor, because a string may contain several keys.
fn last_key_alone(found: &mut CompletionList<'_>) {
    let begun = found.query.rfind('%').filter(|at| found.query.len() - at <= 2).unwrap_or(found.query.len());
    let cursor = found.range.start() + TextSize::of(found.query);
    found.query = found.query.part(begun..);
    found.range = TextRange::new(cursor - TextSize::of(found.query), cursor);
}

/// Keys of a collection: first the keys in the data file, then further keys that programs use.
fn keys(found: &CompletionList<'_>, Collection { project, name }: &Collection) -> Vec<String> {
    let mut keys = keys_of(found.db, *project, name);
    // The key at the cursor is excluded.
    let mut spelt = spelt_keys(found.db, *project, name);
    spelt.retain(|key| !key.is_empty() && key != found.query && !keys.contains(key));
    keys.extend(spelt);
    keys
}

/// Keys of a collection, including the missing quotes.
pub(super) fn quoted_keys(found: &mut CompletionList<'_>, collection: &Collection) {
    let parse = parse(found.db, found.file);
    let is_plain = program::code(parse.view()).is_some_and(|code| code.token(SyntaxKind::CDATA_OPEN).is_some());
    for (place, key) in (0..).zip(keys(found, collection)) {
        let label = format!("\"{key}\"");
        let written = if is_plain { label.clone() } else { escaped(&label) };
        let added = found.add(&label, CompletionKind::Text).detail(|| "key".to_owned()).scored(2 * FITS - place);
        added.with(|item| {
            item.insert.clone_from(&written);
            item.plain = written;
        });
    }
}
