//! Names that are not declared yet: taking one declares it.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::declarations::is_old;
use val3_analysis::items::project::items;
use val3_config::Options;
use val3_lang::keywords;
use val3_lang::types::{Arm, BaseType};

use super::reach::{Reachable, reachable};
use super::{CompletionKind as Kind, Found};
use crate::declare::{self, Variable};
use crate::line::Expected;

/// What is not there yet comes last.
const MISSING: i32 = -120;

/// New global data with the name that was typed.
pub(super) fn global(found: &mut Found<'_>, expected: &Expected) {
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
    // Data files name the arm of positions.
    let type_name = ty.file_name(names.items.arm.unwrap_or(Arm::SixAxis));
    let Some(edit) = declare::data(db, project, &Variable::single(name, &type_name), None) else { return };
    let added = found.add(name, Kind::Data).scored(MISSING).adding(|| vec![edit]);
    added.detail(|| format!("new global {}", ty.name()));
}

/// The type whose names begin as this one does: `nCount` is a `num`.
fn type_by_prefix(options: &Options, name: &str) -> Option<BaseType> {
    let prefix = name.find(|letter: char| !letter.is_ascii_lowercase()).and_then(|end| name.get(..end))?;
    let (ty, _) = options.prefixes.iter().find(|(_, known)| known.as_str() == prefix)?;
    BaseType::from_name(ty)
}

/// Projects of the cell that are not among the libraries yet.
pub(super) fn libraries(found: &mut Found<'_>) {
    if found.query.is_empty() {
        return;
    }
    let (db, project) = (found.db, found.project);
    let declared = items(db, project);
    let is_used = |other: Project| {
        declared.libraries.values().any(|library| library.interface == Some(other))
            || declared.types.values().any(|ty| *ty == Some(other))
    };
    for other in reachable(db, project) {
        let (alias, path) = (other.name(db), entry(db, project, &other));
        if is_used(other.project) || !keywords::is_identifier(alias) || found.names().is_declared(alias) {
            continue;
        }
        let added = found.add(alias, Kind::Library).scored(MISSING).detail(|| format!("new library, {path}"));
        added.adding(|| declare::library(db, project, alias, &path).into_iter().collect()).with(|item| {
            item.insert = format!("{alias}:");
            item.plain = format!("{alias}:");
        });
    }
}

/// The path of a project as the project file writes it.
pub(super) fn entry(db: &dyn Db, project: Project, other: &Reachable) -> String {
    if is_old(db, project) { other.old().to_owned() } else { other.long.clone() }
}

/// The project in reach that has the name of an identifier that is not declared.
pub(super) fn library_called(found: &Found<'_>, alias: &str) -> Option<Reachable> {
    reachable(found.db, found.project).into_iter().find(|other| other.name(found.db) == alias)
}

/// The completions from `start` on need a library identifier that is not declared.
pub(super) fn declare_library(found: &mut Found<'_>, start: usize, alias: &str, interface: &Reachable) {
    let path = entry(found.db, found.project, interface);
    let edit = declare::library(found.db, found.project, alias, &path);
    for item in found.items.iter_mut().skip(start) {
        item.additional.extend(edit.clone());
    }
}
