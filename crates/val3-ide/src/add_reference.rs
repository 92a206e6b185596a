//! Adding libraries and user types to a project: the available projects, and their elements in the `.pjx`.

use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, Project};
use val3_analysis::interfaces::{Fit, fit};
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::parse;
use val3_analysis::items::program::header;
use val3_analysis::items::project::{find_project, items};
use val3_analysis::occurrences::Symbol;
use val3_analysis::xml;
use val3_lang::keywords;

use crate::RefactoringError;
use crate::declare::{free, library, user_type};
use crate::edit::SourceChange;
use crate::project_tree::has_types;
use crate::reachable_projects::{Reachable, reachable};
use crate::rename::{name_fault, other_item};

/// Kind of the reference to another project.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ReferenceKind {
    /// An element of `<Libraries>`.
    Library,
    /// An element of `<Types>`.
    Type,
}

/// A project that can be added to another project as a library or type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ReferenceCandidate {
    /// The project.
    pub project: Project,
    /// An unused name, similar to the project's name.
    pub name: String,
    /// Path as spelled in the `.pjx`.
    pub path: String,
    /// Names under which the project is already referenced, by kind.
    pub present: Vec<(ReferenceKind, String)>,
    /// Number of public programs.
    pub programs: usize,
    /// Number of public data, which are the fields of a type.
    pub data: usize,
    /// Library identifiers under which it can be loaded. It contains all public items in their interface, or all used
    /// items.
    pub fits: Vec<String>,
    /// Whether the project would use itself through it as a library.
    pub library_circle: bool,
    /// Whether the project would contain itself through it as a type.
    pub type_circle: bool,
}

/// Whether the project's dialect has user types.
pub fn takes_types(db: &dyn Db, project: Project) -> bool {
    let parse = parse(db, project.manifest(db));
    xml::root(parse.view()).is_some_and(has_types)
}

/// Projects that `project` can reference, sorted by path.
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
    ReferenceCandidate {
        project: other.project,
        name: free_name(db, project, other.name(db)),
        path: other.entry(db, project),
        present,
        programs: of_other.programs.values().filter(|file| header(db, **file).public).count(),
        data: of_other.data.values().filter(|item| item.decl.public).count(),
        fits: replaceable_aliases(db, project, other.project),
        library_circle: leads_to(db, other.project, project, ReferenceKind::Library),
        type_circle: leads_to(db, other.project, project, ReferenceKind::Type),
    }
}

/// Library identifiers of `project` with another interface that can also load `other`, in alphabetical order.
fn replaceable_aliases(db: &dyn Db, project: Project, other: Project) -> Vec<String> {
    let libraries = items(db, project).libraries.iter();
    let of_others = libraries.filter(|(_, library)| library.interface != Some(other)).map(|(alias, _)| alias);
    let fitting = of_others.filter(|alias| fit(db, project, alias, other) != Fit::Lacks);
    let mut fitting: Vec<String> = fitting.map(ToString::to_string).collect();
    fitting.sort_unstable();
    fitting
}

/// Reason why a new library identifier or user type cannot have this name; `None` if it can.
fn new_name_fault(db: &dyn Db, project: Project, name: &str) -> Option<String> {
    name_fault(name, Some(items(db, project).version)).or_else(|| {
        let what = other_item(db, project, &Symbol::Library(project, name.into()), name)?;
        Some(format!("there is already {what} called `{name}`"))
    })
}

/// Derives from `stem` a name that the project does not use yet.
fn free_name(db: &dyn Db, project: Project, stem: &str) -> String {
    let limit = items(db, project).version.identifier_limit().unwrap_or(usize::MAX);
    let allowed: String =
        stem.chars().map(|letter| if letter.is_ascii_alphanumeric() { letter } else { '_' }).collect();
    let stem = if keywords::is_identifier(&allowed) { allowed } else { format!("_{allowed}") };
    let beginning = |length: usize| -> String { stem.chars().take(length).collect() };
    let taken = |name: &str| name.len() <= limit && new_name_fault(db, project, name).is_some();
    let whole = beginning(limit);
    // Otherwise the name is shortened so that a two-digit number fits.
    if taken(&whole) { free(&beginning(limit.saturating_sub(2)), taken) } else { whole }
}

/// Whether `from` uses `to` as a library or type, directly or indirectly.
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

/// Adds the project at `path` to the `.pjx` of `project`, as a library identifier or a user type called `name`.
///
/// # Errors
/// If the project file cannot be parsed completely or has no suitable element, if the name is invalid or in use, if no
/// project exists at `path`, or if `project` would use itself.
pub fn add_reference(
    db: &dyn Db,
    project: Project,
    kind: ReferenceKind,
    name: &str,
    path: &str,
) -> Result<SourceChange, RefactoringError> {
    let refused = |reason: &str| Err(RefactoringError(reason.to_owned()));
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
        .ok_or_else(|| RefactoringError(format!("`{file}` has no place for the entry")))
}

#[cfg(test)]
mod tests;
