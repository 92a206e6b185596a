//! `val3/workspaceTree`: the projects of the workspace and their contents, for a tree view.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use tower_lsp::lsp_types::request::Request;
use tower_lsp::lsp_types::{Location, Range, Url};
use val3_analysis::db::Project;
use val3_ide::{ProjectKind, TreeData, TreeItem, TreeProgram, TreeReference, project_content, project_kinds};
use val3_lang::types::Container;

use crate::schema::protocol;
use crate::snapshot::{Refusal, Snapshot};

/// The request, without parameters.
pub(crate) enum WorkspaceTree {}

impl Request for WorkspaceTree {
    type Params = Option<Value>;
    type Result = Vec<TreeProject>;
    const METHOD: &'static str = "val3/workspaceTree";
}

/// A project: an application, a library or a user type.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
pub(crate) struct TreeProject {
    name: String,
    /// URI of the `.pjx`.
    #[schemars(with = "String")]
    uri: Url,
    kind: WireProjectKind,
    /// Whether the project's dialect has user types.
    has_types: bool,
    programs: Vec<Item<ProgramNode>>,
    data: Vec<Item<DataNode>>,
    libraries: Vec<Item<ReferenceNode>>,
    types: Vec<Item<ReferenceNode>>,
}

/// Project kind, by its use in the workspace.
#[derive(Debug, Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
#[schemars(rename = "ProjectKind")]
pub(super) enum WireProjectKind {
    Application,
    Tests,
    Library,
    Type,
}

/// An item of a project.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "Tree{T}")]
pub(crate) struct Item<T> {
    name: String,
    /// Type, signature or path; may be empty.
    detail: String,
    /// Location of the name.
    #[schemars(with = "protocol::LocationSchema")]
    location: Location,
    /// Range of the entire declaration.
    #[schemars(with = "protocol::RangeSchema")]
    range: Range,
    #[serde(flatten)]
    what: T,
}

/// A program.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "Program")]
pub(crate) struct ProgramNode {
    public: bool,
    /// Whether the program can be started without a caller.
    runs: bool,
}

/// Global data.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase")]
#[schemars(rename = "Data")]
pub(crate) struct DataNode {
    public: bool,
    /// Type name as spelled in the file, for example `pointRx`.
    #[serde(rename = "type")]
    type_name: String,
    /// Array size, by dimension; empty for a collection.
    sizes: Vec<u32>,
    is_collection: bool,
    /// Initial value of a single `num`, `bool` or `string`.
    value: Option<String>,
}

/// A library identifier or a user type.
#[derive(Debug, Serialize, Deserialize, JsonSchema)]
#[schemars(rename = "Reference")]
pub(crate) struct ReferenceNode {
    /// The `.pjx` to which it resolves; `null` if unresolved.
    #[schemars(with = "Option<String>")]
    project: Option<Url>,
    /// The `.pjx` files of the libraries that programs load under this identifier.
    #[schemars(with = "Vec<String>")]
    loaded: Vec<Url>,
}

pub(crate) fn workspace_tree(snapshot: &Snapshot, _: &Option<Value>) -> Result<Vec<TreeProject>, Refusal> {
    let kinds = project_kinds(snapshot.db());
    let kind = |project| kinds.get(&project).copied().unwrap_or(ProjectKind::Library);
    let real = snapshot.projects.iter().filter(|project| snapshot.is_shown(project.manifest(snapshot.db())));
    Ok(real.map(|project| tree(snapshot, *project, kind(*project))).collect())
}

fn tree(snapshot: &Snapshot, project: Project, kind: ProjectKind) -> TreeProject {
    let content = project_content(snapshot.db(), project);
    TreeProject {
        name: content.name.to_string(),
        uri: snapshot.uri(project.manifest(snapshot.db())),
        kind: kind.into(),
        has_types: content.has_types,
        programs: items(snapshot, content.programs, |TreeProgram { public, runs }| ProgramNode { public, runs }),
        data: items(snapshot, content.data, data),
        libraries: items(snapshot, content.libraries, |found| reference(snapshot, found)),
        types: items(snapshot, content.types, |found| reference(snapshot, found)),
    }
}

impl From<ProjectKind> for WireProjectKind {
    fn from(kind: ProjectKind) -> Self {
        match kind {
            ProjectKind::Application => Self::Application,
            ProjectKind::Tests => Self::Tests,
            ProjectKind::Library => Self::Library,
            ProjectKind::Type => Self::Type,
        }
    }
}

fn items<F, T>(snapshot: &Snapshot, found: Vec<TreeItem<F>>, what: impl Fn(F) -> T) -> Vec<Item<T>> {
    let mut items = Vec::with_capacity(found.len());
    // Items in the same file are consecutive, so the file's lines are looked up once.
    let mut last = None;
    for found in found {
        let lines = match last.take() {
            Some((file, lines)) if file == found.file => lines,
            _ => snapshot.lines(found.file),
        };
        items.push(Item {
            name: found.name.to_string(),
            detail: found.detail,
            location: Location { uri: snapshot.uri(found.file), range: lines.range(found.name_range) },
            range: lines.range(found.range),
            what: what(found.what),
        });
        last = Some((found.file, lines));
    }
    items
}

fn data(TreeData { decl, value }: TreeData) -> DataNode {
    DataNode {
        public: decl.public,
        type_name: decl.type_name.to_string(),
        is_collection: decl.container == Container::Collection,
        sizes: decl.sizes,
        value,
    }
}

fn reference(snapshot: &Snapshot, found: TreeReference) -> ReferenceNode {
    let uri = |project: Project| snapshot.uri(project.manifest(snapshot.db()));
    ReferenceNode { project: found.project.map(uri), loaded: found.loaded.into_iter().map(uri).collect() }
}
