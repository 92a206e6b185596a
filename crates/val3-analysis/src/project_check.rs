//! Checks of a `.pjx`: its entries, the listed files, and cycles of libraries and types.

mod circles;

use camino::Utf8Path;
use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::files::FileKind;
use val3_lang::versions::Version;
use val3_modbus::{FileFault, ModbusFile};
use val3_syntax::TextRange;

use crate::cell::CellConfig;
use crate::db::{Db, File, FileRange, FileStatus, Project};
use crate::file_check::FileCheck;
use crate::items::manifest::{ListNames, Spelling, entries, spelling};
use crate::items::parse;
use crate::items::project::{find_file, find_project, folder, items, leads_outside};
use crate::paths::{self, ResolvedPath};
use crate::problem::{FileRole, ModbusTableFault, NameKind, Problem, ProblemKind};
use crate::xml::{self, Attribute, XmlElement};

/// Checks a project file and returns its problems.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project) -> Vec<Problem> {
    let file = project.manifest(db);
    let mut check = ProjectCheck { db, project, file, found: FileCheck::new(db, project, file, items(db, project)) };
    let parse = parse(db, file);
    if let Some(root) = xml::root(parse.view()) {
        check.root(root);
    }
    check.found.problems
}

struct ProjectCheck<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    found: FileCheck<'db>,
}

/// A list of libraries or user types in a project file.
struct ReferenceList {
    /// Names of the list and of an entry.
    list: ListNames,
    /// Attribute with the entry's name.
    name: &'static str,
    /// Attribute with the entry's path.
    path: &'static str,
    what: FileRole,
}

impl ProjectCheck<'_> {
    fn root(&mut self, root: XmlElement<'_>) {
        if !matches!(root.name(), "Project" | "project") {
            let kind = ProblemKind::WrongRoot { expected: FileRole::Project, found: root.name().into() };
            return self.found.report(root.name_range(), kind);
        }
        let spelling = spelling(root);
        self.found.elements(FileKind::Project, root);
        self.children(root, spelling);
        self.version(root, spelling);
        self.parameters(root, spelling);
        self.files(root, spelling.programs, FileRole::Program);
        self.files(root, spelling.data, FileRole::Data);
        let Spelling { libraries, library_name, library_path, types, .. } = *spelling;
        let libraries =
            ReferenceList { list: libraries, name: library_name, path: library_path, what: FileRole::Library };
        self.projects(root, libraries);
        self.projects(root, ReferenceList { list: types, name: "name", path: "path", what: FileRole::Type });
        self.circles(root, spelling);
        self.cell_files(root);
    }

    /// Reports unreadable files of the cell at the root element, because they are outside of the project.
    fn cell_files(&mut self, root: XmlElement<'_>) {
        let Some(cell) = self.project.cell(self.db) else { return };
        for file in &cell.config(self.db).unreadable_files {
            self.found.report(root.name_range(), ProblemKind::CellFileUnreadable(file.clone()));
        }
        self.modbus(cell.config(self.db), root);
    }

    /// Reports faults of the tables of the Modbus server.
    fn modbus(&mut self, cell: &CellConfig, root: XmlElement<'_>) {
        let Some(file) = &cell.io.modbus else { return };
        let usr = self.project.disk(self.db).and_then(Utf8Path::parent);
        let path = usr.and_then(|usr| file.path.strip_prefix(usr).ok()).unwrap_or(&file.path);
        for FileFault { offset, kind } in ModbusFile::read(&file.text).faults {
            let before = file.text.get(..offset).unwrap_or_default();
            let fault = ModbusTableFault {
                path: path.as_str().into(),
                line: 1 + before.matches('\n').count(),
                hides_items: kind.hides_items(),
                description: kind.to_string().into(),
            };
            self.found.report(root.name_range(), ProblemKind::ModbusTable(Box::new(fault)));
        }
    }

    fn children(&mut self, root: XmlElement<'_>, spelling: &Spelling) {
        let lists = [spelling.programs, spelling.data, spelling.libraries, spelling.types];
        for element in root.elements().filter(|element| element.name() != spelling.parameters) {
            match lists.iter().find(|names| names.list == element.name()) {
                Some(names) => {
                    let foreign = element.elements().filter(|inner| inner.name() != names.item);
                    foreign.for_each(|inner| self.found.unexpected(inner, element));
                }
                None => self.found.unexpected(element, root),
            }
        }
    }

    fn version(&mut self, root: XmlElement<'_>, spelling: &Spelling) {
        let Some(parameters) = root.child(&[spelling.parameters]) else { return };
        let version = parameters.attribute("version");
        if let Some(version) = version.filter(|version| Version::parse(&version.text()).is_none()) {
            self.found.invalid(parameters, version, SmolStr::new_static("a version such as `s7.11.3`"));
        }
    }

    fn parameters(&mut self, root: XmlElement<'_>, spelling: &Spelling) {
        let Some(parameters) = root.child(&[spelling.parameters]) else { return };
        self.found.one_of(parameters, "millimeterUnit", &["true", "false"]);
        let stack = parameters.attribute("stackSize").filter(|size| size.text().trim().parse::<u32>().is_err());
        if let Some(stack) = stack {
            self.found.invalid(parameters, stack, SmolStr::new_static("a number of bytes such as `5000`"));
        }
    }

    /// Checks the entries of program or data files.
    fn files(&mut self, root: XmlElement<'_>, list: ListNames, what: FileRole) {
        let mut seen: FxHashMap<String, TextRange> = FxHashMap::default();
        for element in entries(root, list) {
            let Some(file) = element.attribute("file") else { continue };
            if self.separators(file) {
                continue;
            }
            let path = file.text();
            if let Some(first) = seen.get(&path.to_lowercase()) {
                self.duplicate(file, *first, what);
                continue;
            }
            seen.insert(path.to_lowercase(), file.range);
            if leads_outside(self.db, self.project, &path) {
                self.found.report(file.range, ProblemKind::FileOutside(what, path.as_ref().into()));
            } else if find_file(self.db, self.project, &path).is_none() {
                self.found.report(file.range, ProblemKind::FileMissing { what, path: path.as_ref().into() });
            }
        }
    }

    /// Checks the entries of libraries or user types.
    fn projects(&mut self, root: XmlElement<'_>, ReferenceList { list, name, path, what }: ReferenceList) {
        let mut seen = FxHashMap::default();
        for element in entries(root, list) {
            let is_again = element.attribute(name).is_some_and(|found| self.project_name(found, what, &mut seen));
            // The second entry with the same name is ignored.
            if let Some(found) = element.attribute(path)
                && !is_again
                && !self.separators(found)
            {
                self.target(found, what);
            }
            self.found.one_of(element, "autoload", &["true", "false"]);
        }
    }

    /// Checks an entry's name. Returns whether an earlier entry has the same name.
    fn project_name(&mut self, found: Attribute<'_>, what: FileRole, seen: &mut FxHashMap<String, TextRange>) -> bool {
        let kind = if what == FileRole::Library { NameKind::Library } else { NameKind::Type };
        self.found.name(found, kind);
        let name = found.text().into_owned();
        if let Some(first) = seen.get(&name) {
            self.duplicate(found, *first, what);
            return true;
        }
        seen.insert(name, found.range);
        false
    }

    fn duplicate(&mut self, found: Attribute<'_>, first: TextRange, what: FileRole) {
        let kind = ProblemKind::DuplicateEntry { what, name: found.text().as_ref().into() };
        self.found.report_again(found.range, kind, Some(FileRange { file: self.file, range: first }));
    }

    /// Reports a path with backslashes. Returns whether it has any.
    fn separators(&mut self, path: Attribute<'_>) -> bool {
        let found = path.text().contains('\\');
        if found {
            self.found.report(path.range, ProblemKind::PathSeparator { path: path.text().as_ref().into() });
        }
        found
    }

    fn target(&mut self, path: Attribute<'_>, what: FileRole) {
        let db = self.db;
        let reference = path.text();
        if let Some(found) = find_project(db, self.project, &reference) {
            if let FileStatus::Unreadable(reason) = found.manifest(db).status(db) {
                let (path, reason, range) = (reference.as_ref().into(), reason.as_str().into(), path.range);
                self.found.report(range, ProblemKind::FileUnreadable { path, reason });
            }
            return;
        }
        let kind = match paths::project(folder(db, self.project), self.project.roots(db), &reference) {
            _ if leads_outside(db, self.project, &reference) => {
                ProblemKind::FileOutside(what, reference.as_ref().into())
            }
            ResolvedPath::Path(_) => ProblemKind::FileMissing { what, path: reference.as_ref().into() },
            ResolvedPath::Elsewhere => self.unresolved(&reference, what),
        };
        self.found.report(path.range, kind);
    }

    fn unresolved(&self, reference: &str, what: FileRole) -> ProblemKind {
        let root = paths::root(reference);
        let near = paths::near_root(root, self.project.roots(self.db));
        ProblemKind::UnresolvedPath { what, path: reference.into(), root: root.into(), near }
    }
}
