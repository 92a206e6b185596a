//! The header of a `.pgx`: the program's name, access, parameters and locals.

use smol_str::SmolStr;
use val3_lang::files::FileKind;
use val3_lang::types::Container;
use val3_syntax::SyntaxKind;
use val3_syntax::view::View;

use super::data::{Shape, shape};
use super::{attributes, flag, parse};
use crate::db::{Db, File, FileStatus};
use crate::xml::{self, Element};

/// The header of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Header {
    /// The program's name.
    pub name: SmolStr,
    /// Other projects may call it.
    pub public: bool,
    /// Parameters in order.
    pub params: Vec<ParamDecl>,
    /// Locals in order.
    pub locals: Vec<LocalDecl>,
    /// Every parameter and local can be read.
    pub complete: bool,
}

/// A parameter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParamDecl {
    /// The name.
    pub name: SmolStr,
    /// The type as written.
    pub type_name: SmolStr,
    /// An element, array or collection.
    pub container: Container,
    /// Passed by reference; containers always are.
    pub by_reference: bool,
    /// The old dialect does not distinguish an element by reference from an array.
    pub loose: bool,
}

/// A local variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LocalDecl {
    /// The name.
    pub name: SmolStr,
    /// The type as written.
    pub type_name: SmolStr,
    /// Always an array in files; a single value has size 1.
    pub container: Container,
    /// Sizes of the dimensions.
    pub sizes: Vec<u32>,
}

/// Reads the header of a `.pgx` of either dialect.
#[salsa::tracked]
pub fn header(db: &dyn Db, file: File) -> Header {
    let parse = parse(db, file);
    let root = parse.view();
    let mut header = read(root);
    header.complete &= matches!(file.status(db), FileStatus::Read { .. })
        && parse
            .errors()
            .iter()
            .all(|error| code(root).is_some_and(|code| code.range().start() <= error.range.start()));
    header
}

/// The element of the program in a file.
pub fn element(file: View<'_>) -> Option<Element<'_>> {
    xml::root(file)?.child(&["Program", "program"])
}

/// The code of the program in a file.
pub fn code(file: View<'_>) -> Option<View<'_>> {
    code_element(file)?.view().child(SyntaxKind::CODE)
}

/// The element that holds the code of the program in a file.
pub fn code_element(file: View<'_>) -> Option<Element<'_>> {
    let program = element(file)?;
    program.child(&["Code"]).or_else(|| program.child(&["source"])?.child(&["code"]))
}

/// The lists that a program may hold, and what each lists; nothing for those that list no elements.
pub(crate) const LISTS: [(&str, Option<&str>); 8] = [
    ("Parameters", Some("Parameter")),
    ("paramSection", Some("param")),
    ("Locals", Some("Local")),
    ("localSection", Some("local")),
    ("Code", None),
    ("source", None),
    ("Description", None),
    ("description", None),
];

fn is_complete(program: Element<'_>) -> bool {
    program.value("name").is_some()
        && program.elements().all(|list| {
            let known = LISTS.iter().find(|(name, _)| *name == list.name());
            known.is_some_and(|(_, item)| {
                let declares =
                    |item: &&str, element: Element<'_>| element.name() == *item && element.value("name").is_some();
                item.is_none_or(|item| list.elements().all(|element| declares(&item, element)))
            })
        })
}

/// The elements that declare parameters.
pub fn params<'g>(program: Element<'g>) -> impl Iterator<Item = Element<'g>> {
    program.list("Parameters", "Parameter").chain(program.list("paramSection", "param"))
}

/// The elements that declare locals.
pub fn locals<'g>(program: Element<'g>) -> impl Iterator<Item = Element<'g>> {
    program.list("Locals", "Local").chain(program.list("localSection", "local"))
}

/// Reads the tree of a `.pgx`.
pub fn read(file: View<'_>) -> Header {
    let Some(program) = element(file) else { return Header::default() };
    let value = |name: &str| program.value(name);
    Header {
        name: value("name").map(SmolStr::from).unwrap_or_default(),
        // A word that is neither, and an attribute that may be meant as this one, is a fault of its own, reported once.
        public: value("access").is_some_and(|text| text.trim() != "private")
            || attributes::has_unknown(FileKind::Program, program)
            || value("public").and_then(|text| flag(&text)).unwrap_or(false),
        params: params(program).filter_map(param).collect(),
        locals: locals(program).filter_map(local).collect(),
        complete: is_complete(program),
    }
}

fn param(element: Element<'_>) -> Option<ParamDecl> {
    let name = SmolStr::from(element.value("name")?);
    let type_name = plain_shape(element).type_name;
    if let Some(by_value) = element.value("byVal") {
        let by_reference = by_value.trim() == "false";
        let container = if by_reference { Container::Array { dims: 1 } } else { Container::Element };
        return Some(ParamDecl { name, type_name, container, by_reference, loose: by_reference });
    }
    let dims = element.value("dimensions").and_then(|text| text.trim().parse().ok()).unwrap_or(1);
    let container = match element.value("xsi:type").as_deref().map(str::trim) {
        Some("array") => Container::Array { dims },
        Some("collection") => Container::Collection,
        _ => Container::Element,
    };
    let referenced = element.value("use").is_some_and(|text| text.trim() == "reference");
    let by_reference = referenced || container != Container::Element;
    Some(ParamDecl { name, type_name, container, by_reference, loose: false })
}

fn local(element: Element<'_>) -> Option<LocalDecl> {
    let name = SmolStr::from(element.value("name")?);
    let Shape { type_name, container, sizes } = plain_shape(element);
    Some(LocalDecl { name, type_name, container, sizes })
}

/// Nothing is known of the values of a variable whose attributes may be meant as others.
fn plain_shape(element: Element<'_>) -> Shape {
    let shape = shape(element);
    if attributes::is_plain(element) { shape } else { Shape { type_name: SmolStr::default(), ..shape } }
}
