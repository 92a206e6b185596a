//! Programs and data files in the folder of a project that it does not list.

use rustc_hash::FxHashSet;
use smol_str::SmolStr;

use super::manifest::{Manifest, manifest};
use crate::db::{Db, Project};

/// Whether a file is called like a program.
pub fn is_program(name: &str) -> bool {
    has_extension(name, "pgx")
}

/// Whether a file is called like a data file.
pub fn is_data(name: &str) -> bool {
    has_extension(name, "dtx")
}

fn has_extension(name: &str, wanted: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(_, extension)| extension.eq_ignore_ascii_case(wanted))
}

/// The names of the programs and data files in the folder of a project that it does not list, sorted.
pub fn unlisted_names(db: &dyn Db, project: Project) -> Vec<&SmolStr> {
    let Manifest { programs, data, .. } = manifest(db, project.manifest(db));
    let listed = programs.iter().chain(data).map(|entry| file_name(entry).to_lowercase());
    let listed: FxHashSet<String> = listed.collect();
    let names = project.beside(db).iter().filter(|name| is_program(name) || is_data(name));
    names.filter(|name| !listed.contains(&name.to_lowercase())).collect()
}

/// The name of a listed file, without the folder that s8 allows before it.
fn file_name(entry: &str) -> &str {
    entry.trim().rsplit(['/', '\\']).next().unwrap_or(entry)
}
