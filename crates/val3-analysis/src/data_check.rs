//! The initial values in a `.dtx`: names, types, sizes, keys, values, fathers and links.

mod fathers;
mod links;
mod values;

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_syntax::TextRange;
use val3_syntax::view::View;

use crate::db::{Db, File, FileStatus, Project};
use crate::declared_name::{self, NameCheck};
use crate::items::data::{self, DataDecl};
use crate::items::project::{DataItem, Items, items, resolve_type};
use crate::items::{parse, sizes};
use crate::problem::{FileRole, NameKind, Problem, ProblemKind};
use crate::ty::Base;
use crate::xml::{self, Element};

/// What is wrong in a data file.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project, file: File) -> Vec<Problem> {
    let parse = parse(db, file);
    let view = View::root(parse.green());
    if let FileStatus::Unreadable(reason) = file.status(db) {
        let kind = ProblemKind::FileUnreadable { reason: reason.as_str().into() };
        return vec![declared_name::problem(file, view.range(), kind)];
    }
    let items = items(db, project);
    let mut check = DataCheck { db, project, file, items, names: NameCheck::new(file, items) };
    check.names.problems.extend(declared_name::encoding(db, file));
    if let Some(root) = xml::root(view) {
        check.root(root, view);
    }
    check.names.problems
}

struct DataCheck<'db> {
    db: &'db dyn Db,
    project: Project,
    file: File,
    items: &'db Items,
    names: NameCheck<'db>,
}

impl DataCheck<'_> {
    fn report(&mut self, range: TextRange, kind: ProblemKind) {
        self.names.report(range, kind);
    }

    fn root(&mut self, root: Element<'_>, view: View<'_>) {
        if !matches!(root.name(), "Database" | "dataList") {
            let kind = ProblemKind::WrongRoot { expected: FileRole::Data, found: root.name().into() };
            return self.report(root.name_range(), kind);
        }
        self.foreign_elements(root);
        let mut seen = FxHashMap::default();
        for element in data::elements(view) {
            let Some(name) = element.attribute("name") else {
                self.missing(element, "name");
                continue;
            };
            self.names.name(name, NameKind::Data);
            self.names.once(name, NameKind::Data, &mut seen);
            if element.name() == "Data" {
                self.declaration(element);
            } else {
                self.old_fathers(element);
            }
        }
        self.father_circles(view);
    }

    /// `<Database>` holds `<Datas>`, which holds `<Data>`; the old dialect has a section a type.
    fn foreign_elements(&mut self, root: Element<'_>) {
        for list in root.elements() {
            if root.name() == "dataList" {
                if !list.name().ends_with("Section") {
                    self.unexpected(list, root);
                }
            } else if list.name() == "Datas" {
                for element in list.elements().filter(|element| element.name() != "Data") {
                    self.unexpected(element, list);
                }
            } else {
                self.unexpected(list, root);
            }
        }
    }

    fn unexpected(&mut self, element: Element<'_>, parent: Element<'_>) {
        let kind = ProblemKind::UnexpectedElement { name: element.name().into(), parent: parent.name().into() };
        self.report(element.name_range(), kind);
    }

    fn missing(&mut self, element: Element<'_>, attribute: &'static str) {
        let kind = ProblemKind::MissingAttribute {
            element: element.name().into(),
            attribute: SmolStr::new_static(attribute),
        };
        self.report(element.name_range(), kind);
    }

    fn one_of(&mut self, element: Element<'_>, attribute: &str, values: &[&str]) {
        if let Some(found) = element.attribute(attribute)
            && !values.contains(&found.text().trim())
        {
            self.names.problems.push(declared_name::invalid(self.file, element, found, values));
        }
    }

    fn declaration(&mut self, element: Element<'_>) {
        self.one_of(element, "access", &["public", "private"]);
        self.one_of(element, "xsi:type", &["array", "collection"]);
        let Some(ty) = element.attribute("type") else { return self.missing(element, "type") };
        self.names.ty(ty);
        let sound = self.size(element);
        let base = resolve_type(&self.items.types, &ty.text()).unwrap_or(Base::Unknown);
        let (container, sizes) = data::container(element);
        self.values(element, base, container, if sound { &sizes } else { &[] });
    }

    /// The `size` of an array; true if it can be relied on.
    fn size(&mut self, element: Element<'_>) -> bool {
        let Some(found) = element.attribute("size") else { return true };
        let sound = sizes(&found.text()).is_some_and(|sizes| !sizes.contains(&0));
        if !sound {
            self.report(found.range, ProblemKind::InvalidSize { size: found.text().as_ref().into() });
        }
        sound
    }

    fn item(&self, name: &str) -> Option<&DataItem> {
        self.items.data.get(name)
    }
}

/// `3 x 4`, as sizes are shown in messages.
fn show_sizes(sizes: &[u32]) -> SmolStr {
    let sizes: Vec<String> = sizes.iter().map(u32::to_string).collect();
    sizes.join(" x ").into()
}

/// The size of a declaration.
fn show_size_of(decl: &DataDecl) -> SmolStr {
    show_sizes(&decl.sizes)
}
