//! The initial values in a `.dtx`: names, types, sizes, keys, values, fathers and links.

mod fathers;
mod links;
mod values;

pub use fathers::{ReferencePart, steps};

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::files::FileKind;
use val3_lang::types::Container;
use val3_syntax::TextRange;
use val3_syntax::view::View;

use crate::db::{Db, File, Project};
use crate::file_check::FileCheck;
use crate::items::attributes;
use crate::items::data::{self, DataDecl};
use crate::items::declarations;
use crate::items::parse;
use crate::items::project::{DataItem, Items, items, resolve_type};
use crate::problem::{FileRole, NameKind, Problem, ProblemKind};
use crate::ty::Base;
use crate::xml::{self, Attribute, XmlElement};

/// Checks a data file and returns its problems.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project, file: File) -> Vec<Problem> {
    let items = items(db, project);
    let mut check = DataCheck { db, project, file, items, found: FileCheck::new(db, project, file, items) };
    let parse = parse(db, file);
    let view = parse.view();
    if let Some(root) = xml::root(view) {
        check.root(root, view);
    }
    check.found.problems
}

struct DataCheck<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    items: &'db Items,
    found: FileCheck<'db>,
}

impl DataCheck<'_> {
    fn report(&mut self, range: TextRange, kind: ProblemKind) {
        self.found.report(range, kind);
    }

    fn root(&mut self, root: XmlElement<'_>, view: View<'_>) {
        if !matches!(root.name(), "Database" | "dataList") {
            let kind = ProblemKind::WrongRoot { expected: FileRole::Data, found: root.name().into() };
            return self.report(root.name_range(), kind);
        }
        self.foreign_elements(root);
        self.found.elements(FileKind::Data, root);
        let mut seen = FxHashMap::default();
        for element in data::elements(view) {
            let Some(name) = element.attribute("name") else { continue };
            self.name(name, &mut seen);
            self.hidden_father(name);
            self.found.memory(element);
            if element.name() == "Data" {
                self.declaration(element);
            } else {
                self.old_fathers(element);
            }
        }
        self.father_circles(view);
    }

    /// Reports unexpected elements: `<Database>` contains `<Datas>`, which contains `<Data>`; the old dialect has a
    /// section for each type.
    fn foreign_elements(&mut self, root: XmlElement<'_>) {
        let old = root.name() == "dataList";
        for list in root.elements() {
            let known = if old { list.name().ends_with("Section") } else { list.name() == "Datas" };
            if !known {
                self.found.unexpected(list, root);
            } else if !old {
                let foreign = list.elements().filter(|element| element.name() != "Data");
                foreign.for_each(|element| self.found.unexpected(element, list));
            }
        }
    }

    /// Checks that the name is valid and declared only once in the project.
    fn name(&mut self, name: Attribute<'_>, seen: &mut FxHashMap<String, TextRange>) {
        self.found.name(name, NameKind::Data);
        self.found.once(name, NameKind::Data, seen);
        let text = SmolStr::from(name.text());
        if let Some(first) = self.item(&text).filter(|first| first.file != self.file) {
            let place = declarations::data(self.db, first.file, text.clone());
            let kind = ProblemKind::DuplicateName { name: text, what: NameKind::Data };
            self.found.report_again(name.range, kind, place);
        }
    }

    fn declaration(&mut self, element: XmlElement<'_>) {
        self.found.one_of(element, "access", &["public", "private"]);
        self.found.one_of(element, "xsi:type", &["array", "collection"]);
        let Some(ty) = element.attribute("type") else { return };
        self.found.ty(ty);
        let sound = self.found.size(element);
        let base = resolve_type(&self.items.types, &ty.text()).unwrap_or(Base::Unknown);
        let (container, sizes) = self.container(element, sound);
        self.values(element, base, container, &sizes);
    }

    /// Returns the container that an element declares, and its sizes if they are reliable (`sound`). With misspelt or
    /// missing attributes, any key is accepted.
    fn container(&self, element: XmlElement<'_>, sound: bool) -> (Container, Vec<u32>) {
        let data::DeclaredType { container, sizes, .. } = data::shape(element);
        match (attributes::is_plain(element), sound) {
            (false, _) => (Container::Collection, Vec::new()),
            (true, false) => (container, Vec::new()),
            (true, true) => (container, sizes),
        }
    }

    fn item(&self, name: &str) -> Option<&DataItem> {
        self.items.data.get(name)
    }
}

/// Formats sizes for messages, for example `3 x 4`.
fn show_sizes(sizes: &[u32]) -> SmolStr {
    let sizes: Vec<String> = sizes.iter().map(u32::to_string).collect();
    sizes.join(" x ").into()
}

/// Formats the size of a declaration.
fn show_size_of(decl: &DataDecl) -> SmolStr {
    show_sizes(&decl.sizes)
}
