//! The outline of a file.

use val3_analysis::db::{Db, File};
use val3_analysis::items::data::DataDecl;
use val3_analysis::items::manifest::{entries, spelling};
use val3_analysis::items::program::Header;
use val3_analysis::items::{data, parse, program};
use val3_analysis::ty::brackets;
use val3_analysis::xml::{self, Attribute, XmlElement};
use val3_lang::types::Container;

use super::{OutlineItem, SymbolKind};
use crate::hover::shape;

/// Declarations of a file, in the order of the text.
pub fn outline(db: &dyn Db, file: File) -> Vec<OutlineItem> {
    let parse = parse(db, file);
    let view = parse.view();
    let Some(root) = xml::root(view) else { return Vec::new() };
    match root.name() {
        "Project" | "project" => project(root),
        "Database" | "dataList" => data::elements(view).filter_map(datum).collect(),
        _ => program::element(view)
            .and_then(|element| program_item(element, program::header(db, file)))
            .into_iter()
            .collect(),
    }
}

fn item(element: XmlElement<'_>, name: Attribute<'_>, detail: String, kind: SymbolKind) -> OutlineItem {
    OutlineItem {
        name: name.text().into(),
        detail,
        kind,
        range: element.view().range(),
        name_range: name.range,
        children: Vec::new(),
    }
}

fn project(root: XmlElement<'_>) -> Vec<OutlineItem> {
    let spelling = spelling(root);
    let programs = list(entries(root, spelling.programs), "file", "", SymbolKind::Program);
    let data = list(entries(root, spelling.data), "file", "", SymbolKind::Data);
    let (name, path) = (spelling.library_name, spelling.library_path);
    let libraries = list(entries(root, spelling.libraries), name, path, SymbolKind::Library);
    let types = list(entries(root, spelling.types), "name", "path", SymbolKind::Type);
    let mut items: Vec<OutlineItem> = programs.chain(data).chain(libraries).chain(types).collect();
    items.sort_by_key(|item| item.range.start());
    items
}

/// Items of list entries; `name` and `detail` are attributes.
fn list<'g>(
    entries: impl Iterator<Item = XmlElement<'g>>,
    name: &'static str,
    detail: &'static str,
    kind: SymbolKind,
) -> impl Iterator<Item = OutlineItem> {
    entries.filter_map(move |element| {
        let detail = element.value(detail).unwrap_or_default().into_owned();
        Some(item(element, element.attribute(name)?, detail, kind))
    })
}

fn datum(element: XmlElement<'_>) -> Option<OutlineItem> {
    let decl = data::declaration(element)?;
    Some(item(element, element.attribute("name")?, datum_detail(&decl), SymbolKind::Data))
}

/// Description of data, for example `public num[3,4]`.
pub(crate) fn datum_detail(decl: &DataDecl) -> String {
    let access = if decl.public { "public " } else { "" };
    format!("{access}{}{}", decl.type_name, shape(&decl.sizes, decl.container))
}

fn program_item(element: XmlElement<'_>, header: &Header) -> Option<OutlineItem> {
    let params = program::params(element).filter_map(|param| {
        let name = param.attribute("name")?;
        let decl = header.params.iter().find(|decl| decl.name == *name.text())?;
        // Containers are always passed by reference.
        let reference = if decl.by_reference && decl.container == Container::Element { "&" } else { "" };
        let detail = format!("{}{reference}{}", decl.type_name, brackets(decl.container));
        Some(item(param, name, detail, SymbolKind::Parameter))
    });
    let params: Vec<OutlineItem> = params.collect();
    let locals = program::locals(element).filter_map(|local| {
        let name = local.attribute("name")?;
        let decl = header.locals.iter().find(|decl| decl.name == *name.text())?;
        let shape = shape(&decl.sizes, decl.container);
        Some(item(local, name, format!("{}{shape}", decl.type_name), SymbolKind::Local))
    });
    let signature: Vec<String> = params.iter().map(|param| format!("{} {}", param.detail, param.name)).collect();
    let access = if header.public { "public " } else { "" };
    let detail = format!("{access}({})", signature.join(", "));
    let mut found = item(element, element.attribute("name")?, detail, SymbolKind::Program);
    found.children = params;
    found.children.extend(locals);
    Some(found)
}

#[cfg(test)]
mod tests {
    use expect_test::{Expect, expect};

    use super::*;
    use crate::testing::MarkedListing;

    fn check(listing: &str, expected: Expect) {
        let marked = MarkedListing::new(listing);
        let file = marked.at().file;
        let mut shown = String::new();
        show(&outline(marked.db(), file), 0, file.text(marked.db()), &mut shown);
        expected.assert_eq(&shown);
    }

    fn show(items: &[OutlineItem], depth: usize, text: &str, shown: &mut String) {
        for item in items {
            let name = &text[std::ops::Range::<usize>::from(item.name_range)];
            assert!(item.range.contains_range(item.name_range));
            let line = format!("{}{:?} {name} {}", "  ".repeat(depth), item.kind, item.detail);
            shown.push_str(line.trim_end());
            shown.push('\n');
            show(&item.children, depth + 1, text, shown);
        }
    }

    #[test]
    fn a_program_lists_its_declarations() {
        check(
            "program pick(num& x_n, string x_s[])\n  num l_i\n  point l_p[3]\nbegin\n  cls()$0\nend",
            expect![[r#"
                Program pick (num& x_n, string[] x_s)
                  Parameter x_n num&
                  Parameter x_s string[]
                  Local l_i num
                  Local l_p point[3]
            "#]],
        );
    }

    #[test]
    fn a_data_file_lists_its_data() {
        check(
            "cls()\n=== main/main.dtx\n<Database><Datas><Data name=\"nA\" type=\"num\" size=\"3 4\" /><Data name=\"dIn$0\" access=\"public\" xsi:type=\"collection\" type=\"dio\" /></Datas></Database>",
            expect![[r#"
                Data nA num[3,4]
                Data dIn public dio[""]
            "#]],
        );
        check(
            "cls()\n=== main/main.dtx\n<dataList><numSection><num name=\"nA$0\" public=\"true\" size=\"2\" /></numSection></dataList>",
            expect![[r#"
                Data nA public num[2]
            "#]],
        );
    }

    #[test]
    fn a_project_file_lists_its_entries() {
        check(
            "cls()\n=== main/main.pjx\n<Project><Programs><Program file=\"start.pgx\" /></Programs><Database><Data file=\"main.dtx\" /></Database><Libraries><Library alias=\"part$0\" path=\"Disk://part/part.pjx\" /></Libraries><Types><Type name=\"Slot\" path=\"Disk://Slot/Slot.pjx\" /></Types></Project>",
            expect![[r#"
                Program start.pgx
                Data main.dtx
                Library part Disk://part/part.pjx
                Type Slot Disk://Slot/Slot.pjx
            "#]],
        );
    }
}
