//! Names used by unlisted files: files in a project's folder that the project file does not list.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;

use super::program::summary;
use crate::db::{Db, File, Project, Sources};
use crate::items::data::data;
use crate::items::fathers::fathers_in;
use crate::items::project::folder;
use crate::items::unlisted::{is_program, unlisted_names};
use crate::paths::path_key;

/// Whether an unlisted program may use the item `name`: it contains the word, or accesses data by a string that may be
/// this name.
pub fn unlisted_may_use(db: &dyn Db, project: Project, name: &str) -> bool {
    let uses = unlisted_uses(db, project);
    uses.words.contains(name) || uses.beginnings.iter().any(|beginning| name.starts_with(beginning.as_str()))
}

/// Names that the unlisted files of a project use.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct UnlistedUses {
    /// All words of the programs; fathers and user types of the data.
    words: FxHashSet<SmolStr>,
    /// Name prefixes of data that the programs access by a name in a string.
    beginnings: FxHashSet<SmolStr>,
}

#[salsa::tracked]
fn unlisted_uses(db: &dyn Db, project: Project) -> UnlistedUses {
    let sources = Sources::get(db);
    let mut uses = UnlistedUses::default();
    for name in unlisted_names(db, project) {
        let key = path_key(folder(db, project).join(name.as_str()).as_str());
        let Some(file) = sources.unlisted(db).get(&key).or_else(|| sources.files(db).get(&key)) else { continue };
        if is_program(name) {
            uses.words.extend(words(db, *file).iter().cloned());
            uses.beginnings.extend(summary(db, project, *file).named_in_texts.iter().cloned());
        } else {
            uses.words.extend(fathers_in(db, *file).iter().cloned());
            uses.words.extend(data(db, *file).iter().map(|decl| decl.type_name.clone()));
        }
    }
    uses
}

/// Returns every word of a file. The file is not parsed, because a file that belongs to no project may be malformed.
#[salsa::tracked]
fn words(db: &dyn Db, file: File) -> FxHashSet<SmolStr> {
    let words = file.text(db).split(|letter: char| !letter.is_ascii_alphanumeric() && letter != '_');
    words.filter(|word| !word.is_empty()).map(SmolStr::from).collect()
}
