//! Libraries and user types that come into a project: those that the cell has, and their entries in the `.pjx`.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;
use val3_analysis::db::{Db, Project};
use val3_analysis::interfaces::{Fit, fit};
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::parse;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{find_project, items};
use val3_analysis::occurrences::Symbol;
use val3_analysis::xml;
use val3_lang::keywords;

use crate::declare::{free, library, user_type};
use crate::edit::SourceChange;
use crate::project_tree::has_types;
use crate::reachable_projects::{Reachable, reachable};
use crate::rename::{name_fault, other_item};

/// What another project becomes for a project.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ReferenceKind {
    /// An entry of `<Libraries>`.
    Library,
    /// An entry of `<Types>`.
    Type,
}

/// A project that can become a library or a type of another one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReferenceCandidate {
    /// The project.
    pub project: Project,
    /// A name that is still free, similar to that of the project.
    pub name: String,
    /// The path as the `.pjx` writes it.
    pub path: String,
    /// The names by which it is a library or a type already, by kind.
    pub present: Vec<(ReferenceKind, String)>,
    /// Public programs.
    pub programs: usize,
    /// Public data: the fields of the type.
    pub data: usize,
    /// The library identifiers under which it can be loaded: it has everything public that their interface has, or
    /// that the programs use of it.
    pub fits: Vec<String>,
    /// The project would use itself through it as a library.
    pub library_circle: bool,
    /// The project would contain itself through it as a type.
    pub type_circle: bool,
}

/// Why a library or a type cannot be added, in a sentence for the user.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AddReferenceError(pub String);

/// The dialect of the project has user types.
pub fn takes_types(db: &dyn Db, project: Project) -> bool {
    let parse = parse(db, project.manifest(db));
    xml::root(parse.view()).is_some_and(has_types)
}

/// The projects that `project` can name, by path.
pub fn reference_candidates(db: &dyn Db, project: Project) -> Vec<ReferenceCandidate> {
    reachable(db, project).iter().map(|other| candidate(db, project, other)).collect()
}

fn candidate(db: &dyn Db, project: Project, other: &Reachable) -> ReferenceCandidate {
    let declared = items(db, project);
    let of_other = items(db, other.project);
    let libraries = declared.libraries.iter().filter(|(_, library)| library.interface == Some(other.project));
    let types = declared.types.iter().filter(|(_, ty)| **ty == Some(other.project));
    let libraries = libraries.map(|(alias, _)| (ReferenceKind::Library, alias.to_string()));
    let mut present: Vec<_> = libraries.chain(types.map(|(name, _)| (ReferenceKind::Type, name.to_string()))).collect();
    present.sort_by(|one, other| one.1.cmp(&other.1));
    let is_fitting = |alias: &&SmolStr| {
        let own = declared.libraries.get(*alias).is_some_and(|library| library.interface == Some(other.project));
        !own && fit(db, project, alias, other.project) != Fit::Lacks
    };
    let mut fits: Vec<String> = declared.libraries.keys().filter(is_fitting).map(ToString::to_string).collect();
    fits.sort_unstable();
    ReferenceCandidate {
        project: other.project,
        name: free_name(db, project, other.name(db)),
        path: other.entry(db, project),
        present,
        programs: of_other.programs.values().filter(|file| header(db, **file).public).count(),
        data: of_other.data.values().filter(|item| item.decl.public).count(),
        fits,
        library_circle: leads_to(db, other.project, project, ReferenceKind::Library),
        type_circle: leads_to(db, other.project, project, ReferenceKind::Type),
    }
}

/// Why a new library identifier or user type of the project cannot have the name.
fn new_name_fault(db: &dyn Db, project: Project, name: &str) -> Option<String> {
    let taken = || {
        let what = other_item(db, project, &Symbol::Library(project, name.into()), name)?;
        Some(format!("there is already {what} called `{name}`"))
    };
    name_fault(name, Some(items(db, project).version)).or_else(taken)
}

/// `stem` as a name that the project does not have yet.
fn free_name(db: &dyn Db, project: Project, stem: &str) -> String {
    let limit = items(db, project).version.identifier_limit().unwrap_or(usize::MAX);
    let allowed: String =
        stem.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect();
    let stem = if keywords::is_identifier(&allowed) { allowed } else { format!("_{allowed}") };
    let beginning = |length: usize| -> String { stem.chars().take(length).collect() };
    let is_taken = |name: &str| name.len() <= limit && new_name_fault(db, project, name).is_some();
    let whole = beginning(limit);
    // Otherwise with space for two digits that make it free.
    if is_taken(&whole) { free(&beginning(limit.saturating_sub(2)), is_taken) } else { whole }
}

/// A way of libraries, or of types, from one project to another.
fn leads_to(db: &dyn Db, from: Project, to: Project, kind: ReferenceKind) -> bool {
    let mut seen = FxHashSet::default();
    let mut next = vec![from];
    while let Some(project) = next.pop() {
        if project == to {
            return true;
        }
        if seen.insert(project) {
            next.extend(named(db, project, kind));
        }
    }
    false
}

fn named(db: &dyn Db, project: Project, kind: ReferenceKind) -> Vec<Project> {
    let items = items(db, project);
    match kind {
        ReferenceKind::Library => items.libraries.values().filter_map(|library| library.interface).collect(),
        ReferenceKind::Type => items.types.values().copied().flatten().collect(),
    }
}

/// The entry of the project at `path` in the `.pjx` of `project`, as a library identifier or a user type called `name`.
///
/// # Errors
/// If the project file cannot be read whole or has no place for the entry, if the name cannot be used, if there is no
/// project at `path`, or if `project` would use itself.
pub fn add_reference(
    db: &dyn Db,
    project: Project,
    kind: ReferenceKind,
    name: &str,
    path: &str,
) -> Result<SourceChange, AddReferenceError> {
    let refused = |reason: &str| Err(AddReferenceError(reason.to_owned()));
    let file = project.manifest(db).path(db).file_name().unwrap_or("").to_owned();
    if !manifest(db, project.manifest(db)).complete {
        return refused(&format!("`{file}` has errors. Correct them first, so that nothing else changes"));
    }
    if kind == ReferenceKind::Type && !takes_types(db, project) {
        return refused("projects of s5 and s6 have no user types");
    }
    if let Some(reason) = new_name_fault(db, project, name) {
        return refused(&reason);
    }
    let Some(target) = find_project(db, project, path) else {
        return refused(&format!("there is no project at `{path}`"));
    };
    if leads_to(db, target, project, kind) {
        return refused(&format!("the project would use itself: `{path}` uses it, directly or through others"));
    }
    let edit = match kind {
        ReferenceKind::Library => library(db, project, name, path),
        ReferenceKind::Type => user_type(db, project, name, path),
    };
    edit.map(|edit| SourceChange::of([edit]))
        .ok_or_else(|| AddReferenceError(format!("`{file}` has no place for the entry")))
}

#[cfg(test)]
mod tests;
