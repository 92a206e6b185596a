//! Completions for undeclared names; accepting one declares the name.

use smol_str::SmolStr;
use val3_analysis::db::Project;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{Items, items};
use val3_analysis::occurrences::Symbol;
use val3_config::Options;
use val3_lang::keywords;
use val3_lang::types::{Arm, BaseType};

use super::list::{CompletionKind as Kind, CompletionList};
use super::names::{data_detail, fit};
use crate::declare::{self, NewVariable};
use crate::fuzzy::score;
use crate::hover::program_line;
use crate::line::Expected;
use crate::reachable_projects::{Reachable, reachable};

/// Score penalty of undeclared items.
const MISSING: i32 = -120;

/// New global data with the typed name.
pub(super) fn global(found: &mut CompletionList<'_>, expected: &Expected) {
    let (db, project) = (found.db, found.project);
    let name = found.query;
    let is_free = keywords::is_identifier(name) && keywords::reserved(name).is_none();
    let names = found.names();
    if !is_free || names.is_declared(name) {
        return;
    }
    let default = Options::default();
    let options = project.config(db).map_or(&default, |config| &config.lint);
    let Some(ty) = expected.bases.first().and_then(|base| base.builtin()).or_else(|| type_by_prefix(options, name))
    else {
        return;
    };
    // Position types in data files include the arm kind.
    let type_name = ty.file_name(names.items.arm.unwrap_or(Arm::SixAxis));
    let Some(edit) = declare::data(db, project, &NewVariable::single(name, &type_name), None) else { return };
    let added = found.add(name, Kind::Data).scored(MISSING).adding(|| vec![edit]);
    added.detail(|| format!("new global {}", ty.name()));
}

/// Type that the naming convention assigns to the prefix of the name; for example, `nCount` is a `num`.
fn type_by_prefix(options: &Options, name: &str) -> Option<BaseType> {
    let prefix = name.find(|letter: char| !letter.is_ascii_lowercase()).and_then(|end| name.get(..end))?;
    let (ty, _) = options.prefixes.iter().find(|(_, known)| known.as_str() == prefix)?;
    BaseType::from_name(ty)
}

/// A reachable project that can be added as a library under its own name.
struct NewLibrary {
    project: Project,
    alias: String,
    path: String,
}

/// Reachable projects that are neither a library nor a type of the project yet.
fn new_libraries(found: &CompletionList<'_>) -> Vec<NewLibrary> {
    let (db, project) = (found.db, found.project);
    let (names, declared) = (found.names(), items(db, project));
    let unused = reachable(db, project).into_iter().filter(|other| !references(declared, other.project));
    let new = unused.map(|other| NewLibrary {
        project: other.project,
        alias: other.name(db).to_owned(),
        path: other.entry(db, project),
    });
    new.filter(|new| keywords::is_identifier(&new.alias) && !names.is_declared(&new.alias)).collect()
}

/// Whether a library identifier or user type refers to the other project.
fn references(declared: &Items, other: Project) -> bool {
    declared.libraries.values().any(|library| library.interface == Some(other))
        || declared.types.values().any(|ty| *ty == Some(other))
}

/// Reachable projects that are not a library of the project yet.
pub(super) fn libraries(found: &mut CompletionList<'_>) {
    if found.query.is_empty() {
        return;
    }
    let (db, project) = (found.db, found.project);
    for NewLibrary { alias, path, .. } in new_libraries(found) {
        let added = found.add(&alias, Kind::Library).scored(MISSING).detail(|| format!("new library, {path}"));
        added.adding(|| declare::library(db, project, &alias, &path).into_iter().collect()).with(|item| {
            item.insert = format!("{alias}:");
            item.plain = format!("{alias}:");
        });
    }
}

/// Score penalty of a library item without its identifier, because most names are typed as intended.
const WITHOUT_IDENTIFIER: i32 = -80;

/// Whether the typed letters match the item name, not only the library identifier.
fn is_meant(query: &str, name: &str) -> bool {
    score(query, name).is_some()
}

/// Minimum number of typed letters for library items without their identifier.
const LEAST_LETTERS: usize = 2;

/// Public data of libraries, with the library identifier, which is declared if necessary.
pub(super) fn library_data(found: &mut CompletionList<'_>, expected: &Expected) {
    let db = found.db;
    library_items(found, &|found, alias, interface| {
        let data = items(db, interface).data.iter().filter(|(_, item)| item.decl.public);
        for (name, item) in data {
            if is_meant(found.query, name) {
                let added = found.add(&format!("{alias}:{name}"), Kind::Data).detail(|| data_detail(item));
                let added = added.scored(fit(&expected.bases, item.base) + WITHOUT_IDENTIFIER);
                added.of(|| Symbol::Data(interface, name.clone()));
            }
        }
    });
}

/// Public programs of libraries, with the library identifier.
pub(super) fn library_programs(found: &mut CompletionList<'_>) {
    let db = found.db;
    library_items(found, &|found, alias, interface| {
        let query = found.query;
        let programs = items(db, interface).programs.iter().filter(|(_, file)| header(db, **file).public);
        for (name, file) in programs.filter(|(name, _)| is_meant(query, name)) {
            let arguments = || header(db, *file).params.iter().map(|param| param.name.as_str()).collect();
            let added = found.add_call(&format!("{alias}:{name}"), Kind::Program, arguments);
            let added = added.detail(|| program_line(db, interface, *file)).scored(WITHOUT_IDENTIFIER);
            added.of(|| Symbol::Program(interface, name.clone()));
        }
    });
}

/// Offers the items of every reachable library; `offer` receives the identifier and the interface.
fn library_items<'db>(found: &mut CompletionList<'db>, offer: &dyn Fn(&mut CompletionList<'db>, &str, Project)) {
    if found.query.len() < LEAST_LETTERS {
        return;
    }
    let (db, project) = (found.db, found.project);
    let declared = items(db, project).libraries.iter();
    let declared: Vec<(SmolStr, Project)> =
        declared.filter_map(|(alias, library)| Some((alias.clone(), library.interface?))).collect();
    for (alias, interface) in declared {
        offer(found, &alias, interface);
    }
    for NewLibrary { alias, path, project: interface } in new_libraries(found) {
        let start = found.items.len();
        offer(found, &alias, interface);
        if found.items.len() == start {
            continue;
        }
        let edit = declare::library(db, project, &alias, &path);
        for item in found.items.iter_mut().skip(start) {
            item.score += MISSING;
            item.detail = format!("{}, new library {path}", item.detail);
            item.additional.extend(edit.clone());
        }
    }
}

/// Reachable project whose name is the undeclared identifier `alias`.
pub(super) fn library_called(found: &CompletionList<'_>, alias: &str) -> Option<Reachable> {
    reachable(found.db, found.project).into_iter().find(|other| other.name(found.db) == alias)
}

/// Adds the declaration of a library identifier to the completions from `start` on.
pub(super) fn declare_library(found: &mut CompletionList<'_>, start: usize, alias: &str, interface: &Reachable) {
    let path = interface.entry(found.db, found.project);
    let edit = declare::library(found.db, found.project, alias, &path);
    for item in found.items.iter_mut().skip(start) {
        item.additional.extend(edit.clone());
    }
}
