//! Hover text and its building blocks.

use val3_analysis::db::{Db, Project};
use val3_analysis::ty::brackets;
use val3_lang::types::Container;
use val3_syntax::TextRange;

use crate::markdown::code;

/// Hover information.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hover {
    /// Range that it describes.
    pub range: TextRange,
    /// Text in Markdown.
    pub markdown: String,
}

/// Brackets of a declaration: `[3,4]`, `[""]`, empty for a single value.
pub(crate) fn shape(sizes: &[u32], container: Container) -> String {
    match sizes {
        [1] => String::new(),
        [] => brackets(container).to_owned(),
        _ => format!("[{}]", sizes.iter().map(u32::to_string).collect::<Vec<_>>().join(",")),
    }
}

/// Path of a project's folder, relative to the disk root if it is known.
pub(super) fn place_of(db: &dyn Db, project: Project) -> String {
    let path = project.manifest(db).path(db);
    match project.disk(db).as_ref().and_then(|disk| path.strip_prefix(disk).ok()) {
        Some(relative) => code(&format!("Disk://{relative}")),
        None => code(path.as_str()),
    }
}
