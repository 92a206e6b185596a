//! Merges findings of several applications with the same cause.

use std::collections::hash_map::Entry;

use camino::Utf8Path;
use rustc_hash::FxHashMap;
use val3_analysis::db::{Db, FileRange, Project, Sources};
use val3_analysis::paths::path_key;

use crate::diagnostic::{Diagnostic, MOST_RELATED, RelatedNote};
use crate::rules::{ambiguous_name, file_unreadable, library_item_unknown, modbus_table};

/// A cause that several applications may share.
#[derive(PartialEq, Eq, Hash)]
enum SharedCause<'db> {
    /// A name that variables share with a program or library. Stand-in libraries have the same programs with the same
    /// parameters as the libraries that they replace.
    Name(&'db str),
    /// A library whose project does not list the used items: location of the list.
    Library(FileRange),
    /// An unreadable file of a cell: the folder of the cell's `Disk://`, and the file's path in the cell.
    CellFile(&'db Utf8Path, &'db str),
    /// A fault of a cell: the folder of the cell's `Disk://`, and the message.
    CellFault(&'db Utf8Path, String),
}

/// Keeps the first finding for each cause, and adds the locations of the other findings to it.
pub fn join_causes(db: &dyn Db, findings: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut kept: Vec<Diagnostic> = Vec::with_capacity(findings.len());
    let mut firsts: FxHashMap<SharedCause<'_>, usize> = FxHashMap::default();
    for finding in findings {
        let first = cause(db, &finding).map(|cause| firsts.entry(cause));
        match first {
            Some(Entry::Occupied(first)) => {
                let first = kept.get_mut(*first.get()).filter(|first| first.related.len() < MOST_RELATED);
                if let Some(first) = first {
                    let message = "the same cause in another application".to_owned();
                    first.related.push(RelatedNote { place: finding.place, message });
                }
                continue;
            }
            Some(Entry::Vacant(first)) => drop(first.insert(kept.len())),
            None => {}
        }
        kept.push(finding);
    }
    kept
}

/// Whether several applications can report the finding for the same cause.
pub fn has_shared_cause(db: &dyn Db, finding: &Diagnostic) -> bool {
    cause(db, finding).is_some()
}

fn cause<'db>(db: &'db dyn Db, finding: &Diagnostic) -> Option<SharedCause<'db>> {
    let FileRange { file, range } = finding.place;
    if finding.rule == &ambiguous_name::RULE {
        return file.text(db).get(std::ops::Range::<usize>::from(range)).map(SharedCause::Name);
    }
    if finding.rule == &file_unreadable::RULE {
        return cell_file(db, finding);
    }
    if finding.rule == &modbus_table::RULE {
        return Some(SharedCause::CellFault(project(db, finding)?.disk(db)?, finding.message.clone()));
    }
    // Outside of programs, this rule only reports projects with missing entries.
    let is_about_project = finding.rule == &library_item_unknown::RULE && finding.program.is_none();
    finding.related.first().filter(|_| is_about_project).map(|list| SharedCause::Library(list.place))
}

fn cell_file<'db>(db: &'db dyn Db, finding: &Diagnostic) -> Option<SharedCause<'db>> {
    let project = project(db, finding)?;
    let mut files = project.cell(db)?.config(db).unreadable_files.iter();
    let file = files.find(|file| file_unreadable::word_cell_file(file).message == finding.message)?;
    Some(SharedCause::CellFile(project.disk(db)?, &file.path))
}

/// Returns the project of the finding's application.
fn project(db: &dyn Db, finding: &Diagnostic) -> Option<Project> {
    let manifest = finding.application?.path(db);
    Sources::get(db).projects(db).get(&path_key(manifest.as_str())).copied()
}

#[cfg(test)]
mod tests {
    use crate::lint::testing::finished;

    #[test]
    fn a_program_of_several_applications_is_reported_once() {
        let program = "public program message(string message)\nbegin\nputln(message)\nend\n";
        let found = finished(&format!("{program}--- one\n{program}--- two\n{program}"), "V0123");
        assert_eq!(
            found,
            ["message.pgx: `message` is a parameter here, and also a program of the project (3 related)"]
        );
    }

    #[test]
    fn a_fault_of_a_shared_library_is_reported_once() {
        let application = |item: &str| format!("library part \"Disk://part/part.pjx\"\ncall part:{item}()\n");
        let project = "=== part/part.pjx\n<Project><Programs /></Project>\n=== part/grip.pgx\n<Programs><Program \
                       name=\"grip\" access=\"public\"><Code><![CDATA[begin\nend]]></Code></Program></Programs>\n";
        let listing = format!("{}--- one\n{}{project}", application("grip"), application("open"));
        let found = finished(&listing, "V0601");
        assert_eq!(found, ["main.pjx: the library `part` does not contain `grip`, used in 1 place (3 related)"]);
    }

    #[test]
    fn an_unreadable_file_of_the_cell_is_reported_once() {
        let found = finished("num nA\n--- one\nnum nA\n=== /app/val3.One.anthro.cfx\n<Table />", "V0502");
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(found[0].ends_with("(1 related)"), "{found:?}");
        let two = "=== /app/val3.One.anthro.cfx\n<Table />\n=== /app/val3.Two.anthro.cfx\n<Table />";
        assert_eq!(finished(&format!("num nA\n--- one\nnum nA\n{two}"), "V0502").len(), 2);
    }
}
