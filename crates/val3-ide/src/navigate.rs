//! Navigation from a name to its definition, type definition and implementations.

use val3_analysis::application::application;
use val3_analysis::db::{Db, File, FileRange, Project, Sources};
use val3_analysis::interfaces::replacements;
use val3_analysis::items::manifest::manifest;
use val3_analysis::items::project::{find_file, items, resolve_type};
use val3_analysis::items::{declarations, program};
use val3_analysis::occurrences::{Occurrence, Symbol, Usage, occurrence_at, occurrences};
use val3_analysis::pages::page_ids;
use val3_analysis::ty::Base;
use val3_syntax::{TextRange, TextSize};

use crate::FilePosition;
use crate::owner::{owner, surrounded};

/// Target of a navigation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct NavigationTarget {
    /// Range of the name at the cursor.
    pub from: TextRange,
    /// Target: the name in its declaration, or the start of a file.
    pub to: FileRange,
}

/// Definition of the name at a position.
pub fn definition(db: &dyn Db, at: FilePosition) -> Vec<NavigationTarget> {
    let Some((project, found)) = name_at(db, at) else { return Vec::new() };
    let place = match &found.symbol {
        // The target for a library identifier in its own declaration is the library.
        Symbol::Library(..) | Symbol::Type(..) if is_declaration(found, at.file, project, db) => {
            project_of(db, &found.symbol).map(|project| start_of(project.manifest(db)))
        }
        symbol => declaration(db, symbol),
    };
    place.into_iter().map(|to| NavigationTarget { from: found.range, to }).collect()
}

/// Declaration of the name at a position in the project file: the element of a program's file, or the library from
/// which an item comes. Otherwise like [`definition`].
pub fn declarations(db: &dyn Db, at: FilePosition) -> Vec<NavigationTarget> {
    let Some((project, found)) = name_at(db, at) else { return Vec::new() };
    let entry = match &found.symbol {
        Symbol::Program(owner, name) if *owner == project => program_entry(db, project, name),
        Symbol::Program(owner, _) | Symbol::Data(owner, _) if *owner != project => library_entry(db, project, *owner),
        _ => None,
    };
    match entry {
        Some(to) => vec![NavigationTarget { from: found.range, to }],
        None => definition(db, at),
    }
}

fn program_entry(db: &dyn Db, project: Project, name: &str) -> Option<FileRange> {
    let file = *items(db, project).programs.get(name)?;
    let references = &manifest(db, project.manifest(db)).programs;
    let reference = references.iter().find(|reference| find_file(db, project, reference) == Some(file))?;
    let range = declarations::program_file(db, project, reference)?;
    Some(FileRange { file: project.manifest(db), range })
}

/// First library identifier of the interface.
fn library_entry(db: &dyn Db, project: Project, interface: Project) -> Option<FileRange> {
    let libraries = items(db, project).libraries.iter().filter(|(_, library)| library.interface == Some(interface));
    let alias = libraries.map(|(alias, _)| alias).min()?;
    declaration(db, &Symbol::Library(project, alias.clone()))
}

fn is_declaration(found: &Occurrence, file: File, project: Project, db: &dyn Db) -> bool {
    let declared = declaration(db, &found.symbol);
    declared.is_some_and(|place| place.file == file && place.range == found.range) && file == project.manifest(db)
}

/// Name at a position, and the project in which it is resolved.
pub(crate) fn name_at(db: &dyn Db, at: FilePosition) -> Option<(Project, &Occurrence)> {
    // Several applications can share a `cell.toml`, and not every one has all its frames and tools.
    let sharing = surrounded(db, at.file);
    let mut projects = owner(db, at.file).into_iter().chain(sharing);
    projects.find_map(|project| Some((project, occurrence_at(db, project, at.file, at.offset)?)))
}

/// Location of a symbol's declaration; `None` for built-in symbols.
pub(crate) fn declaration(db: &dyn Db, symbol: &Symbol) -> Option<FileRange> {
    match symbol {
        Symbol::Local(file, name) => declarations::local(db, *file, name.clone()),
        Symbol::Param(file, name) => declarations::param(db, *file, name.clone()),
        Symbol::Data(project, name) => declarations::data(db, items(db, *project).data.get(name)?.file, name.clone()),
        Symbol::Program(project, name) => declarations::program(db, *items(db, *project).programs.get(name)?),
        Symbol::Library(project, name) => declarations::library(db, *project, name.clone()),
        Symbol::Type(project, name) => declarations::user_type(db, *project, name.clone()),
        Symbol::Task(project, name) => creation(db, *project, name),
        Symbol::Element(page, id) => {
            let (_, range) = page_ids(db, *page).declared.iter().find(|(known, _)| known == id)?;
            Some(FileRange { file: *page, range: *range })
        }
        _ => None,
    }
}

/// First `taskCreate` of a task, in alphabetical order of the programs.
fn creation(db: &dyn Db, project: Project, name: &str) -> Option<FileRange> {
    let tasks = application(db, project).tasks.iter();
    let mut creators = tasks.filter(|task| task.start.name.as_deref() == Some(name));
    let file = *items(db, project).programs.get(creators.next()?.created_by.as_ref()?)?;
    let mut declarations = occurrences(db, project, file).iter().filter(|found| found.usage == Usage::Declaration);
    let creation = declarations.find(|found| matches!(&found.symbol, Symbol::Task(_, task) if task == name))?;
    Some(FileRange { file, range: creation.range })
}

/// Project to which a library identifier or type name resolves.
fn project_of(db: &dyn Db, symbol: &Symbol) -> Option<Project> {
    match symbol {
        Symbol::Library(project, name) => items(db, *project).libraries.get(name)?.interface,
        Symbol::Type(project, name) => items(db, *project).types.get(name).copied().flatten(),
        _ => None,
    }
}

fn start_of(file: File) -> FileRange {
    FileRange { file, range: TextRange::empty(TextSize::new(0)) }
}

/// Project of the user type of the name at a position.
pub fn type_definition(db: &dyn Db, at: FilePosition) -> Vec<NavigationTarget> {
    let Some((project, found)) = name_at(db, at) else { return Vec::new() };
    let base = match &found.symbol {
        Symbol::Data(project, name) => items(db, *project).data.get(name).map(|item| item.base),
        Symbol::Local(file, name) => {
            let header = program::header(db, *file);
            let local = header.locals.iter().find(|local| local.name == *name);
            local.and_then(|local| resolve_type(&items(db, project).types, &local.type_name))
        }
        Symbol::Param(file, name) => {
            let header = program::header(db, *file);
            let param = header.params.iter().find(|param| param.name == *name);
            param.and_then(|param| resolve_type(&items(db, project).types, &param.type_name))
        }
        symbol => project_of(db, symbol).map(Base::User),
    };
    let Some(Base::User(of)) = base else { return Vec::new() };
    vec![NavigationTarget { from: found.range, to: start_of(of.manifest(db)) }]
}

/// From an item of a library's interface to the same item in all libraries that are loaded under an identifier with
/// this interface and that make the item public.
pub fn implementations(db: &dyn Db, at: FilePosition) -> Vec<NavigationTarget> {
    let Some((_, found)) = name_at(db, at) else { return Vec::new() };
    let (interface, name) = match &found.symbol {
        Symbol::Data(project, name) | Symbol::Program(project, name) => (*project, name),
        _ => return Vec::new(),
    };
    let items = implementing(db, interface).map(|project| match &found.symbol {
        Symbol::Data(..) => Symbol::Data(project, name.clone()),
        _ => Symbol::Program(project, name.clone()),
    });
    let declarations = items.filter_map(|item| declaration(db, &item));
    declarations.map(|to| NavigationTarget { from: found.range, to }).collect()
}

/// Libraries that programs load for an interface.
pub(crate) fn implementing(db: &dyn Db, interface: Project) -> impl Iterator<Item = Project> {
    let pairs = pairs(db).into_iter().filter(move |(of, _)| *of == interface);
    pairs.map(|(_, library)| library)
}

/// Interfaces for which programs load a library.
pub(crate) fn implemented(db: &dyn Db, library: Project) -> impl Iterator<Item = Project> {
    let pairs = pairs(db).into_iter().filter(move |(_, other)| *other == library);
    pairs.map(|(interface, _)| interface)
}

/// Interfaces, each with a library that is loaded for it, sorted by path.
fn pairs(db: &dyn Db) -> Vec<(Project, Project)> {
    let projects = Sources::get(db).projects(db).values();
    let mut pairs: Vec<(Project, Project)> = projects.flat_map(|project| replacements(db, *project)).copied().collect();
    pairs.sort_unstable_by_key(|pair| (pair.0.manifest(db).path(db), pair.1.manifest(db).path(db)));
    pairs.dedup();
    pairs
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::{MarkedListing, shown_all};

    fn check(listing: &str, expected: Expect) {
        let marked = MarkedListing::new(listing);
        let targets = definition(marked.db(), marked.at());
        expected.assert_eq(&shown_all(marked.db(), targets.into_iter().map(|target| target.to)));
    }

    const LIBRARY: &str = "\n--- part\npublic num nWeight\npublic program pick(num x_n)\nbegin\nend";

    #[test]
    fn variables_lead_to_their_declaration() {
        check(
            "num nCount\nn$0Count=1",
            expect![[r#"
            main/main.dtx:4 nCount
        "#]],
        );
        check(
            "program start()\n  num l_i\nbegin\n  l_i$0=1\nend",
            expect![[r#"
            main/start.pgx:5 l_i
        "#]],
        );
        check(
            "program start(num x_n)\nbegin\n  put(x_n$0)\nend",
            expect![[r#"
            main/start.pgx:5 x_n
        "#]],
        );
    }

    #[test]
    fn programs_and_libraries_lead_to_their_files() {
        let library = |line: &str| format!("library part \"Disk://part/part.pjx\"\n{line}{LIBRARY}");
        check(
            &library("call part:pi$0ck(1)"),
            expect![[r#"
            part/pick.pgx:3 pick
        "#]],
        );
        check(
            &library("put(part:nWei$0ght)"),
            expect![[r#"
            part/part.dtx:4 nWeight
        "#]],
        );
        check(
            &library("put(pa$0rt:nWeight)"),
            expect![[r#"
            main/main.pjx:11 part
        "#]],
        );
        check(
            "call oth$0er()\nprogram other()\nbegin\nend",
            expect![[r#"
            main/other.pgx:3 other
        "#]],
        );
    }

    #[test]
    fn tasks_lead_to_their_creation() {
        check(
            "taskCreate \"watch\",10,other()\nprogram other()\nbegin\n  taskKill(\"wa$0tch\")\nend",
            expect![[r#"
                main/start.pgx:5 watch
            "#]],
        );
    }

    #[test]
    fn fields_lead_to_their_user_type() {
        check(
            "type Slot \"Disk://Slot/Slot.pjx\"\nSlot sSlot\nsSlot.nHe$0ight=1\n--- Slot\npublic num nHeight",
            expect![[r#"
                Slot/Slot.dtx:4 nHeight
            "#]],
        );
    }

    #[test]
    fn entries_of_the_project_file_lead_to_files() {
        check_declarations(
            "call oth$0er()\nprogram other()\nbegin\nend",
            expect![[r#"
            main/main.pjx:5 other.pgx
        "#]],
        );
        check_declarations(
            &format!("library part \"Disk://part/part.pjx\"\nput(part:nWei$0ght){LIBRARY}"),
            expect![[r#"
            main/main.pjx:11 part
        "#]],
        );
        check_declarations(
            "num nA\nn$0A=1",
            expect![[r#"
            main/main.dtx:4 nA
        "#]],
        );
    }

    fn check_declarations(listing: &str, expected: Expect) {
        let marked = MarkedListing::new(listing);
        let targets = declarations(marked.db(), marked.at());
        expected.assert_eq(&shown_all(marked.db(), targets.into_iter().map(|target| target.to)));
    }

    #[test]
    fn built_in_names_have_no_declaration() {
        check("num nA\nnA=si$0n(1)", expect![[r#""#]]);
        check("point pA\npA.trsf.$0x=1", expect![[r#""#]]);
    }

    #[test]
    fn implementations_of_an_interface_are_found() {
        let marked = MarkedListing::new(&format!(
            "library part \"Disk://part/part.pjx\"\npart:libLoad(\"Disk://bag\")\ncall part:pi$0ck(1){LIBRARY}\n--- bag\npublic num nWeight\npublic program pick(num x_n)\nbegin\nend"
        ));
        let targets = implementations(marked.db(), marked.at());
        expect![[r#"
            bag/pick.pgx:3 pick
        "#]]
        .assert_eq(&shown_all(marked.db(), targets.into_iter().map(|target| target.to)));
    }
}
