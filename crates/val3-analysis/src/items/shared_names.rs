//! Names that a project uses for program variables and also for a program or library identifier.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;

use super::program::header;
use super::project::{items, program_files};
use crate::db::{Db, File, Project};

/// Returns for each such name the program files with a local or parameter of this name, in the order of the project
/// file.
#[salsa::tracked]
pub fn shared_names(db: &dyn Db, project: Project) -> FxHashMap<SmolStr, Vec<File>> {
    let items = items(db, project);
    let mut shared: FxHashMap<SmolStr, Vec<File>> = FxHashMap::default();
    for &file in program_files(db, project) {
        let header = header(db, file);
        let locals = header.locals.iter().map(|local| &local.name);
        let names = locals.chain(header.params.iter().map(|param| &param.name));
        for name in names.filter(|name| items.programs.contains_key(*name) || items.libraries.contains_key(*name)) {
            let files = shared.entry(name.clone()).or_default();
            if files.last() != Some(&file) {
                files.push(file);
            }
        }
    }
    shared
}
