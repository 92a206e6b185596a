//! Names in the XML of a file: headers of programs, data, project files.

use camino::Utf8Path;
use smol_str::SmolStr;
use val3_lang::types::BaseType;
use val3_syntax::view::View;
use val3_syntax::{TextRange, TextSize, TextSlice};

use super::data_path::path_names;
use super::occurrence::{Occurrence, Symbol, Usage};
use crate::db::{Db, File, Project};
use crate::items::manifest::{entries, spelling};
use crate::items::project::{Items, fields, find_file, items, resolve_type};
use crate::items::{data, parse, program};
use crate::ty::Base;
use crate::xml::{self, Attribute, XmlElement};

struct XmlNames<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    items: &'db Items,
    found: Vec<Occurrence>,
}

pub(super) fn names(db: &dyn Db, project: Project, file: File) -> Vec<Occurrence> {
    let mut names = XmlNames { db, project, file, items: items(db, project), found: Vec::new() };
    let parse = parse(db, file);
    let view = parse.view();
    names.program(view);
    names.data(view);
    names.manifest(view);
    names.found
}

impl XmlNames<'_> {
    fn add(&mut self, range: TextRange, symbol: Symbol, usage: Usage) {
        self.found.push(Occurrence { range, symbol, usage });
    }

    fn declare(&mut self, name: Option<Attribute<'_>>, symbol: impl FnOnce(SmolStr) -> Symbol) {
        if let Some(name) = name.filter(|name| !name.raw.is_empty()) {
            self.add(name.range, symbol(name.text().into()), Usage::Declaration);
        }
    }

    /// Adds the element's type name.
    fn type_of(&mut self, element: XmlElement<'_>) {
        let Some(found) = element.attribute("type") else { return };
        let name = SmolStr::from(found.text());
        let symbol = if BaseType::from_file_name(&name).is_some() {
            Symbol::BuiltinType(name)
        } else if self.items.types.contains_key(&name) {
            Symbol::Type(self.project, name)
        } else {
            return;
        };
        self.add(found.range, symbol, Usage::Read);
    }

    fn program(&mut self, view: View<'_>) {
        let Some(element) = program::element(view) else { return };
        let (project, file) = (self.project, self.file);
        self.declare(element.attribute("name"), |name| Symbol::Program(project, name));
        for param in program::params(element) {
            self.declare(param.attribute("name"), |name| Symbol::Param(file, name));
            self.type_of(param);
        }
        for local in program::locals(element) {
            self.declare(local.attribute("name"), |name| Symbol::Local(file, name));
            self.type_of(local);
        }
    }

    fn data(&mut self, view: View<'_>) {
        let project = self.project;
        for element in data::elements(view) {
            self.declare(element.attribute("name"), |name| Symbol::Data(project, name));
            self.type_of(element);
            let base = data::declaration(element)
                .and_then(|decl| resolve_type(&self.items.types, &decl.type_name))
                .unwrap_or(Base::Unknown);
            self.values(element, base);
        }
    }

    /// Adds the names in the values of a variable or field: fathers, and fields of user types.
    fn values(&mut self, element: XmlElement<'_>, base: Base) {
        for value in element.elements() {
            if let Some(father) = value.attribute("fatherId") {
                self.father(father);
            }
            if value.name().ends_with("Father") {
                self.old_father(value);
            }
            if let Base::User(project) = base {
                value.elements().for_each(|field| self.field(field, project));
            }
        }
    }

    fn field(&mut self, element: XmlElement<'_>, project: Project) {
        self.type_of(element);
        let Some(name) = element.attribute("name") else { return };
        let Some(item) = fields(self.db, project).get(name.text().as_ref()) else { return };
        self.add(name.range, Symbol::Data(project, name.text().into()), Usage::Write);
        self.values(element, item.base);
    }

    /// Adds a father in s5 and s6, which may belong to a library: `<fFather alias="part" name="fTable" …/>`.
    fn old_father(&mut self, element: XmlElement<'_>) {
        let Some(name) = element.attribute("name").filter(|name| !name.raw.is_empty()) else { return };
        let Some(alias) = element.attribute("alias").filter(|alias| !alias.raw.is_empty()) else {
            return self.father(name);
        };
        let Some(library) = self.items.libraries.get(alias.raw) else { return };
        self.add(alias.range, Symbol::Library(self.project, alias.raw.into()), Usage::Read);
        let declares = |interface: &Project| items(self.db, *interface).data.contains_key(name.raw);
        if let Some(interface) = library.interface.filter(declares) {
            self.add(name.range, Symbol::Data(interface, name.raw.into()), Usage::Read);
        }
    }

    /// Adds the names in a father reference, for example `tSlot` and `fFrame` in `tSlot["a"].fFrame[0]`.
    fn father(&mut self, found: Attribute<'_>) {
        for (range, symbol) in path_names(self.db, self.project, found.raw) {
            self.add(range + found.range.start(), symbol, Usage::Read);
        }
    }

    fn manifest(&mut self, view: View<'_>) {
        let Some(root) = xml::root(view).filter(|_| self.file == self.project.manifest(self.db)) else { return };
        let spelling = spelling(root);
        let project = self.project;
        for entry in entries(root, spelling.libraries) {
            self.declare(entry.attribute(spelling.library_name), |name| Symbol::Library(project, name));
        }
        for entry in entries(root, spelling.types) {
            self.declare(entry.attribute("name"), |name| Symbol::Type(project, name));
        }
        for entry in entries(root, spelling.programs) {
            self.program_file(entry);
        }
    }

    /// Adds the program name in `file="pick.pgx"`. `file="PICK.pgx"` also names `pick`, because it is the same file on
    /// the controller.
    fn program_file(&mut self, entry: XmlElement<'_>) {
        let Some(reference) = entry.attribute("file") else { return };
        let Some(file) = find_file(self.db, self.project, &reference.text()) else { return };
        let name = &program::header(self.db, file).name;
        let start = reference.raw.rfind(['/', '\\']).map_or(0, |at| at + 1);
        let file_name = reference.raw.part(start..);
        let Some(stem) = Utf8Path::new(file_name).file_stem().filter(|stem| stem.eq_ignore_ascii_case(name)) else {
            return;
        };
        if self.items.programs.get(name) == Some(&file) {
            let from = reference.range.start() + TextSize::of(reference.raw) - TextSize::of(file_name);
            let range = TextRange::at(from, TextSize::of(stem));
            self.add(range, Symbol::Program(self.project, name.clone()), Usage::Read);
        }
    }
}
