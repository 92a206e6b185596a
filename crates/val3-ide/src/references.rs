//! References to a name across files and projects.

use memchr::memmem;
use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, File, FileRange, Project, Sources};
use val3_analysis::items::project::items;
use val3_analysis::occurrences::{Symbol, places_of, project_files};
use val3_analysis::pages::is_bindings;
use val3_syntax::TextRange;

use crate::FilePosition;
use crate::navigate::name_at;

/// References to the name at a position, optionally with its declaration, sorted by path and offset.
pub fn references(db: &dyn Db, at: FilePosition, with_declaration: bool) -> Vec<FileRange> {
    let Some((_, found)) = name_at(db, at) else { return Vec::new() };
    places(db, &found.symbol, with_declaration)
}

/// Like [`references`], for a symbol. The element of a program in its `.pjx` belongs to the declaration.
pub(crate) fn places(db: &dyn Db, symbol: &Symbol, with_declaration: bool) -> Vec<FileRange> {
    let declaration = crate::navigate::declaration(db, symbol);
    let entries = match symbol {
        Symbol::Program(project, _) => Some(project.manifest(db)),
        _ => None,
    };
    let mut places: Vec<FileRange> = uses(db, symbol)
        .map(|(file, _, range)| FileRange { file, range })
        .filter(|place| with_declaration || Some(*place) != declaration && Some(place.file) != entries)
        .collect();
    places.sort_unstable_by_key(|place| (place.file.path(db), place.range.start()));
    places.dedup();
    places
}

/// Uses of a symbol: file, project in which it is resolved, and range.
pub(crate) fn uses(db: &dyn Db, symbol: &Symbol) -> impl Iterator<Item = (File, Project, TextRange)> {
    // Most files do not contain the name, and are skipped.
    let finder = memmem::Finder::new(text(symbol));
    let candidates = candidates(db, symbol).into_iter();
    let with_name = candidates.filter(|(project, file)| {
        let lists_programs = matches!(symbol, Symbol::Program(..)) && *file == project.manifest(db);
        // The element of a program may differ in letter case from its name, and JSON may escape any letter.
        lists_programs || is_bindings(db, *file) || finder.find(file.text(db).as_bytes()).is_some()
    });
    let places = with_name.flat_map(|(project, file)| {
        places_of(db, project, file, symbol).iter().map(move |range| (file, project, *range))
    });
    places.collect::<Vec<_>>().into_iter()
}

/// Name of a symbol.
pub(crate) fn text(symbol: &Symbol) -> &str {
    match symbol {
        Symbol::Local(_, name)
        | Symbol::Param(_, name)
        | Symbol::Data(_, name)
        | Symbol::Program(_, name)
        | Symbol::Library(_, name)
        | Symbol::Type(_, name)
        | Symbol::Task(_, name)
        | Symbol::Element(_, name)
        | Symbol::Instruction(name)
        | Symbol::Builtin(name)
        | Symbol::Enumerator(name)
        | Symbol::Field(_, name)
        | Symbol::BuiltinType(name) => name,
    }
}

/// Files in which a symbol may be used.
fn candidates(db: &dyn Db, symbol: &Symbol) -> Vec<(Project, File)> {
    match symbol {
        Symbol::Local(file, _) | Symbol::Param(file, _) => {
            crate::owner::owner(db, *file).map(|project| (project, *file)).into_iter().collect()
        }
        Symbol::Library(project, _) | Symbol::Type(project, _) | Symbol::Task(project, _) => files(db, *project),
        Symbol::Element(page, _) => {
            crate::owner::projects_of(db, *page).iter().flat_map(|project| files(db, *project)).collect()
        }
        Symbol::Data(project, _) | Symbol::Program(project, _) => {
            projects_using(db, *project).into_iter().flat_map(|project| files(db, project)).collect()
        }
        _ => all(db).into_iter().flat_map(|project| files(db, project)).collect(),
    }
}

/// All projects, sorted by path.
fn all(db: &dyn Db) -> Vec<Project> {
    let mut projects: Vec<Project> = Sources::get(db).projects(db).values().copied().collect();
    projects.sort_unstable_by_key(|project| project.manifest(db).path(db));
    projects
}

/// Projects that may use items of `used`: the project itself, and all projects that use it through libraries and user
/// types. Code can access a field without naming its type, for example `part:sSlot.nHeight`.
pub(crate) fn projects_using(db: &dyn Db, used: Project) -> Vec<Project> {
    let mut users = FxHashSet::from_iter([used]);
    let projects = all(db);
    loop {
        let before = users.len();
        let reaching = projects.iter().filter(|project| names(db, **project).any(|named| users.contains(&named)));
        let reaching: Vec<Project> = reaching.copied().collect();
        users.extend(reaching);
        if users.len() == before {
            return projects.into_iter().filter(|project| users.contains(project)).collect();
        }
    }
}

/// Projects that a project file references.
fn names(db: &dyn Db, project: Project) -> impl Iterator<Item = Project> {
    let items = items(db, project);
    let interfaces = items.libraries.values().filter_map(|library| library.interface);
    interfaces.chain(items.types.values().copied().flatten())
}

fn files(db: &dyn Db, project: Project) -> Vec<(Project, File)> {
    project_files(db, project).map(|file| (project, file)).collect()
}

#[cfg(test)]
mod tests {
    use std::sync::{Arc, Mutex};

    use expect_test::expect;
    use salsa::Setter as _;
    use val3_analysis::db::Database;
    use val3_analysis::load::load_into;
    use val3_analysis::system::Memory;
    use val3_syntax::TextSize;
    use val3_test::{Fixture, ROOT};

    use super::*;
    use crate::testing::{MarkedListing, shown_all};

    #[test]
    fn references_in_all_projects_are_found() {
        let marked = MarkedListing::new(
            "library part \"Disk://part/part.pjx\"\nnum nA\nnA=part:nWeight\npart:nWei$0ght=nA\n--- part\npublic num nWeight\nprogram pick()\nbegin\n  nWeight=2\nend",
        );
        expect![[r#"
            main/start.pgx:5 nWeight
            main/start.pgx:6 nWeight
            part/part.dtx:4 nWeight
            part/pick.pgx:5 nWeight
        "#]]
        .assert_eq(&shown_all(marked.db(), references(marked.db(), marked.at(), true)));
    }

    #[test]
    fn fields_are_found_where_their_type_is_not_named() {
        let marked = MarkedListing::new(
            "library part \"Disk://part/part.pjx\"\nput(part:sSlot.nHe$0ight)\n--- part\n\
             type Slot \"Disk://Slot/Slot.pjx\"\npublic Slot sSlot\n--- Slot\npublic num nHeight\n\
             --- stranger\nnum nHeight\nprogram start()\nbegin\n  nHeight=1\nend",
        );
        expect![[r#"
            Slot/Slot.dtx:4 nHeight
            main/start.pgx:5 nHeight
        "#]]
        .assert_eq(&shown_all(marked.db(), references(marked.db(), marked.at(), true)));
    }

    #[test]
    fn a_local_of_the_same_name_is_not_found() {
        let marked = MarkedListing::new(
            "num nCount\nprogram start()\nbegin\n  nCount$0=1\nend\nprogram other()\n  num nCount\nbegin\n  nCount=2\nend",
        );
        expect![[r#"
            main/start.pgx:5 nCount
        "#]]
        .assert_eq(&shown_all(marked.db(), references(marked.db(), marked.at(), false)));
    }

    #[test]
    fn the_entry_of_a_program_belongs_to_its_declaration() {
        let marked = MarkedListing::new("call oth$0er()\nprogram other()\nbegin\n  cls()\nend");
        let shown = |with_declaration| shown_all(marked.db(), references(marked.db(), marked.at(), with_declaration));
        expect![[r#"
            main/start.pgx:5 other
        "#]]
        .assert_eq(&shown(false));
        expect![[r#"
            main/main.pjx:5 other
            main/other.pgx:3 other
            main/start.pgx:5 other
        "#]]
        .assert_eq(&shown(true));
    }

    #[test]
    fn references_in_fathers_and_fields_are_found() {
        let marked = MarkedListing::new("frame fTable\npoint pA\npA=compose(pA,fTab$0le,pA.trsf)\nlink(pA,fTable)");
        expect![[r#"
            main/main.dtx:4 fTable
            main/start.pgx:5 fTable
            main/start.pgx:6 fTable
        "#]]
        .assert_eq(&shown_all(marked.db(), references(marked.db(), marked.at(), true)));
    }

    #[test]
    fn a_search_after_an_edit_reads_the_edited_file_alone() {
        let ran = Arc::new(Mutex::new(0));
        let log = Arc::clone(&ran);
        let db = Database::observed(move |event| {
            if let salsa::EventKind::WillExecute { database_key } = event.kind {
                *log.lock().unwrap() += usize::from(format!("{database_key:?}").starts_with("occurrences("));
            }
        });
        // More programs than the memoised name tables can hold.
        let programs: String = (0..300).map(|number| format!("program p{number}()\nbegin\n  nA=2\nend\n")).collect();
        let fixture = Fixture::parse(&format!("num nA\nnA=1\n{programs}"));
        let files = fixture.files.into_iter().map(|(path, text)| (format!("{ROOT}/{path}"), text));
        let mut db = load_into(db, &Memory::new(files), &[ROOT.into()]).unwrap().db;
        let find = |name: &str| *Sources::get(&db).files(&db).iter().find(|(path, _)| path.contains(name)).unwrap().1;
        let (start, other) = (find("start.pgx"), find("p7.pgx"));
        let offset = TextSize::try_from(start.text(&db).find("nA=").unwrap()).unwrap();
        let count = |db: &Database| references(db, FilePosition { file: start, offset }, true).len();
        assert_eq!(count(&db), 302);
        let text = other.text(&db).replace("nA=2", "nA=nA");
        other.set_text(&mut db).to(text.into());
        *ran.lock().unwrap() = 0;
        assert_eq!(count(&db), 303);
        assert_eq!(*ran.lock().unwrap(), 1);
    }
}
