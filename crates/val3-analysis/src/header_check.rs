//! The header of a program: names, types, attributes, and whether the file holds what it should.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_syntax::view::View;

use crate::db::{Db, File, FileStatus, Project};
use crate::declared_name::{self, NameCheck};
use crate::items::project::{Items, items};
use crate::items::{parse, program, sizes};
use crate::problem::{FileRole, NameKind, Problem, ProblemKind};
use crate::xml::{self, Attribute, Element};

/// What is wrong with the file and the header of a program.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project, file: File) -> Vec<Problem> {
    let parse = parse(db, file);
    let mut check = Header { names: NameCheck::new(file, items(db, project)), items: items(db, project), file };
    if let FileStatus::Unreadable(reason) = file.status(db) {
        let kind = ProblemKind::FileUnreadable { reason: reason.as_str().into() };
        return vec![declared_name::problem(file, View::root(parse.green()).range(), kind)];
    }
    check.encoding(db);
    let root_view = View::root(parse.green());
    let Some(root) = xml::root(root_view) else { return check.names.problems };
    if !matches!(root.name(), "Programs" | "programList") {
        check.report(root.name_range(), ProblemKind::WrongRoot { expected: FileRole::Program, found: root.name().into() });
        return check.names.problems;
    }
    if let Some(program) = program::element(root_view) {
        check.program(db, program);
    } else {
        check.missing(root, "Program");
    }
    check.names.problems
}

struct Header<'db> {
    names: NameCheck<'db>,
    items: &'db Items,
    file: File,
}

impl Header<'_> {
    fn report(&mut self, range: val3_syntax::TextRange, kind: ProblemKind) {
        self.names.problems.push(declared_name::problem(self.file, range, kind));
    }

    fn encoding(&mut self, db: &dyn Db) {
        self.names.problems.extend(declared_name::encoding(db, self.file));
    }

    fn missing(&mut self, element: Element<'_>, what: &'static str) {
        let kind = ProblemKind::MissingAttribute { element: element.name().into(), attribute: SmolStr::new_static(what) };
        self.report(element.name_range(), kind);
    }

    fn program(&mut self, db: &dyn Db, element: Element<'_>) {
        match element.attribute("name") {
            None => self.missing(element, "name"),
            Some(name) => {
                self.names.name(name, NameKind::Program);
                self.file_name(db, name);
            }
        }
        self.one_of(element, "access", &["public", "private"]);
        self.one_of(element, "public", &["true", "false"]);
        let mut seen = FxHashMap::default();
        for param in program::params(element) {
            self.declaration(param, NameKind::Parameter, &mut seen);
            self.one_of(param, "xsi:type", &["element", "array", "collection"]);
            self.one_of(param, "use", &["value", "reference"]);
            self.one_of(param, "byVal", &["true", "false"]);
            self.one_of(param, "dimensions", &["1", "2", "3"]);
        }
        for local in program::locals(element) {
            self.declaration(local, NameKind::Local, &mut seen);
            self.one_of(local, "xsi:type", &["element", "array", "collection"]);
            self.size(local);
        }
    }

    /// The program is called as its file, but for letter case.
    fn file_name(&mut self, db: &dyn Db, name: Attribute<'_>) {
        let stem = self.file.path(db).file_stem().unwrap_or("").to_owned();
        let program = name.text();
        if !program.eq_ignore_ascii_case(&stem) {
            let kind = ProblemKind::ProgramNameMismatch { program: program.as_ref().into(), file: stem.into() };
            self.report(name.range, kind);
        }
    }

    fn declaration<'g>(
        &mut self,
        element: Element<'g>,
        what: NameKind,
        seen: &mut FxHashMap<String, Attribute<'g>>,
    ) {
        let Some(name) = element.attribute("name") else { return self.missing(element, "name") };
        self.names.name(name, what);
        self.names.once(name, what, seen);
        match element.attribute("type") {
            None => self.missing(element, "type"),
            Some(ty) => self.names.ty(ty),
        }
    }

    fn one_of(&mut self, element: Element<'_>, attribute: &str, values: &[&str]) {
        let Some(found) = element.attribute(attribute) else { return };
        if !values.contains(&found.text().trim()) {
            self.names.problems.push(declared_name::invalid(self.file, element, found, values));
        }
    }

    fn size(&mut self, element: Element<'_>) {
        let Some(found) = element.attribute("size") else { return };
        if sizes(&found.text()).is_none_or(|sizes| sizes.contains(&0)) {
            let size = found.text().as_ref().into();
            self.report(found.range, ProblemKind::InvalidSize { size });
        }
    }
}
