//! `val3/libraries` and `val3/addLibrary`: projects that can be added as a library or type, and the edit that adds one.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tower_lsp::lsp_types::request::Request;
use tower_lsp::lsp_types::{Url, WorkspaceEdit};
use val3_analysis::db::Project;
use val3_ide::{
    ProjectKind, ReferenceCandidate, ReferenceKind, add_reference, owner, project_kinds, reference_candidates,
    takes_types,
};

use super::workspace_tree::WireProjectKind;
use crate::convert::workspace_edit;
use crate::snapshot::{Refusal, Snapshot};

/// Request for candidates.
pub(crate) enum Libraries {}

impl Request for Libraries {
    type Params = LibrariesParams;
    type Result = LibraryList;
    const METHOD: &'static str = "val3/libraries";
}

/// Project to which a library or type is added.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct LibrariesParams {
    /// The project's `.pjx`, or any other project file.
    #[schemars(with = "String")]
    uri: Url,
}

/// Libraries and types that can be added to a project.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct LibraryList {
    /// Whether the dialect of the project has user types.
    has_types: bool,
    candidates: Vec<LibraryCandidate>,
}

/// A project that can be added.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct LibraryCandidate {
    #[schemars(with = "String")]
    uri: Url,
    kind: WireProjectKind,
    /// An unused name.
    name: String,
    /// Path in the dialect of the project.
    path: String,
    /// Library identifiers that already refer to the candidate.
    libraries: Vec<String>,
    /// Type names that already refer to the candidate.
    types: Vec<String>,
    /// Number of public programs.
    public_programs: usize,
    /// Number of public data.
    public_data: usize,
    /// Library identifiers under which it can be loaded.
    fits: Vec<String>,
    /// Whether it would use itself as a library.
    library_circle: bool,
    /// Whether it would contain itself as a type.
    type_circle: bool,
}

/// Request for an edit.
pub(crate) enum AddLibrary {}

impl Request for AddLibrary {
    type Params = AddLibraryParams;
    type Result = WorkspaceEdit;
    const METHOD: &'static str = "val3/addLibrary";
}

/// A new element of a `.pjx`.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
pub(crate) struct AddLibraryParams {
    /// The `.pjx`, or another file of the project.
    #[schemars(with = "String")]
    uri: Url,
    kind: LibraryKind,
    name: String,
    path: String,
}

/// Kind of a new element.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
enum LibraryKind {
    Library,
    Type,
}

pub(crate) fn libraries(snapshot: &Snapshot, params: &LibrariesParams) -> Result<LibraryList, Refusal> {
    let project = project(snapshot, &params.uri)?;
    let kinds = project_kinds(snapshot.db());
    let kind = |project| kinds.get(&project).copied().unwrap_or(ProjectKind::Library);
    let candidates = reference_candidates(snapshot.db(), project).into_iter();
    Ok(LibraryList {
        has_types: takes_types(snapshot.db(), project),
        candidates: candidates.map(|found| candidate(snapshot, kind(found.project), found)).collect(),
    })
}

fn candidate(snapshot: &Snapshot, kind: ProjectKind, found: ReferenceCandidate) -> LibraryCandidate {
    LibraryCandidate {
        uri: snapshot.uri(found.project.manifest(snapshot.db())),
        kind: kind.into(),
        libraries: present(&found, ReferenceKind::Library),
        types: present(&found, ReferenceKind::Type),
        name: found.name,
        path: found.path,
        public_programs: found.programs,
        public_data: found.data,
        fits: found.fits,
        library_circle: found.library_circle,
        type_circle: found.type_circle,
    }
}

/// Names under which the project already refers to the candidate.
fn present(candidate: &ReferenceCandidate, kind: ReferenceKind) -> Vec<String> {
    candidate.present.iter().filter(|(of, _)| *of == kind).map(|(_, name)| name.clone()).collect()
}

pub(crate) fn add_library(snapshot: &Snapshot, params: &AddLibraryParams) -> Result<WorkspaceEdit, Refusal> {
    let project = project(snapshot, &params.uri)?;
    let kind = match params.kind {
        LibraryKind::Library => ReferenceKind::Library,
        LibraryKind::Type => ReferenceKind::Type,
    };
    let change = add_reference(snapshot.db(), project, kind, &params.name, &params.path)?;
    Ok(workspace_edit(snapshot, &change)?)
}

fn project(snapshot: &Snapshot, uri: &Url) -> Result<Project, Refusal> {
    let project = owner(snapshot.db(), snapshot.file(uri)?);
    project
        .filter(|project| snapshot.is_shown(project.manifest(snapshot.db())))
        .ok_or_else(|| Refusal::Because("no project lists this file".to_owned()))
}
