//! The text of information on a place.

use val3_analysis::db::{Db, Project};
use val3_analysis::ty::brackets;
use val3_lang::types::Container;
use val3_syntax::TextRange;

use crate::markdown::code;

/// A text about a place.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Hover {
    /// The range that it describes.
    pub range: TextRange,
    /// The text in Markdown.
    pub markdown: String,
}

/// The brackets of a declaration: `[3,4]`, `[""]`, nothing for a single value.
pub(crate) fn shape(sizes: &[u32], container: Container) -> String {
    match sizes {
        [1] => String::new(),
        [] => brackets(container).to_owned(),
        _ => format!("[{}]", sizes.iter().map(u32::to_string).collect::<Vec<_>>().join(",")),
    }
}

/// The path of a project's folder, from the disk's root on where that is known.
pub(super) fn place_of(db: &dyn Db, project: Project) -> String {
    let path = project.manifest(db).path(db);
    match project.disk(db).as_ref().and_then(|disk| path.strip_prefix(disk).ok()) {
        Some(relative) => code(&format!("Disk://{relative}")),
        None => code(path.as_str()),
    }
}
