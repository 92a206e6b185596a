//! `val3/workspaceTree`: the projects of the workspace with what they hold, for a tree view.

use serde::{Deserialize, Serialize};
use serde_json::Value;
use tower_lsp::lsp_types::request::Request;
use tower_lsp::lsp_types::{Location, Range, Url};
use val3_analysis::db::Project;
use val3_analysis::occurrences::project_files;
use val3_ide::{OutlineItem, SymbolKind};

use crate::snapshot::{Refusal, Snapshot};

/// The request. It takes no parameters.
pub(crate) enum WorkspaceTree {}

impl Request for WorkspaceTree {
    type Params = Option<Value>;
    type Result = Vec<TreeProject>;
    const METHOD: &'static str = "val3/workspaceTree";
}

/// A project: an application, a library or a user type.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct TreeProject {
    name: String,
    uri: Url,
    programs: Vec<TreeItem>,
    data: Vec<TreeItem>,
    libraries: Vec<TreeItem>,
    types: Vec<TreeItem>,
}

/// Something that a project holds.
#[derive(Debug, Serialize, Deserialize)]
pub(crate) struct TreeItem {
    name: String,
    /// Its type or signature; may be empty.
    detail: String,
    location: Location,
}

pub(crate) fn workspace_tree(snapshot: &Snapshot, _: &Option<Value>) -> Result<Vec<TreeProject>, Refusal> {
    let real = snapshot.projects.iter().filter(|project| snapshot.is_shown(project.manifest(snapshot.db())));
    Ok(real.map(|project| tree(snapshot, *project)).collect())
}

fn tree(snapshot: &Snapshot, project: Project) -> TreeProject {
    let manifest = project.manifest(snapshot.db());
    let mut tree = TreeProject {
        name: manifest.path(snapshot.db()).file_stem().unwrap_or("").to_owned(),
        uri: snapshot.uri(manifest),
        programs: Vec::new(),
        data: Vec::new(),
        libraries: Vec::new(),
        types: Vec::new(),
    };
    for file in project_files(snapshot.db(), project) {
        let uri = snapshot.uri(file);
        let lines = snapshot.lines(file);
        for found in val3_ide::outline(snapshot.db(), file) {
            add(&mut tree, &found, &uri, &|range| lines.range(range));
        }
    }
    tree
}

fn add(tree: &mut TreeProject, found: &OutlineItem, uri: &Url, range: &dyn Fn(val3_syntax::TextRange) -> Range) {
    let item = TreeItem {
        name: found.name.to_string(),
        detail: found.detail.clone(),
        location: Location { uri: uri.clone(), range: range(found.name_range) },
    };
    let is_manifest = uri.path().to_ascii_lowercase().ends_with(".pjx");
    match found.kind {
        // The entry of a program in the project file is not the program.
        SymbolKind::Program if !is_manifest => tree.programs.push(item),
        SymbolKind::Data if !is_manifest => tree.data.push(item),
        SymbolKind::Library => tree.libraries.push(item),
        SymbolKind::Type => tree.types.push(item),
        _ => found.children.iter().for_each(|child| add(tree, child, uri, range)),
    }
}
