//! Header of a `.pgx`: program name, access, parameters and locals.

use smol_str::SmolStr;
use val3_lang::files::FileKind;
use val3_lang::types::Container;
use val3_syntax::SyntaxKind;
use val3_syntax::view::View;

use super::data::{DeclaredType, shape};
use super::{attributes, flag, parse};
use crate::db::{Db, File, FileStatus};
use crate::xml::{self, XmlElement};

/// Header of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Header {
    /// Program name.
    pub name: SmolStr,
    /// Whether other projects may call the program.
    pub public: bool,
    /// Parameters in order.
    pub params: Vec<ParamDecl>,
    /// Locals in order.
    pub locals: Vec<LocalDecl>,
    /// Whether every parameter and local is readable.
    pub complete: bool,
}

/// A parameter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParamDecl {
    /// Parameter name.
    pub name: SmolStr,
    /// Type as written.
    pub type_name: SmolStr,
    /// Element, array or collection.
    pub container: Container,
    /// Whether the parameter is passed by reference; containers always are.
    pub by_reference: bool,
    /// Whether it may be an element by reference or an array, which the old dialect does not distinguish.
    pub loose: bool,
}

/// A local variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct LocalDecl {
    /// Variable name.
    pub name: SmolStr,
    /// Type as written.
    pub type_name: SmolStr,
    /// Container; always an array in files, with size 1 for a single value.
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

/// Returns the program element of a file.
pub fn element(file: View<'_>) -> Option<XmlElement<'_>> {
    xml::root(file)?.child(&["Program", "program"])
}

/// Returns the program code in a file.
pub fn code(file: View<'_>) -> Option<View<'_>> {
    code_element(file)?.view().child(SyntaxKind::CODE)
}

/// Returns the element that contains the program code.
pub fn code_element(file: View<'_>) -> Option<XmlElement<'_>> {
    let program = element(file)?;
    program.child(&["Code"]).or_else(|| program.child(&["source"])?.child(&["code"]))
}

/// Elements that a program may contain, with the tag of the items; `None` for elements without items.
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

fn is_complete(program: XmlElement<'_>) -> bool {
    program.value("name").is_some() && program.elements().all(is_complete_list)
}

/// Whether the element has a known name, and its entries are declarations with a name, if it is a list.
fn is_complete_list(list: XmlElement<'_>) -> bool {
    let Some((_, item)) = LISTS.iter().find(|(name, _)| *name == list.name()) else { return false };
    let Some(item) = item else { return true };
    list.elements().all(|element| element.name() == *item && element.value("name").is_some())
}

/// Returns the elements that declare parameters.
pub fn params<'g>(program: XmlElement<'g>) -> impl Iterator<Item = XmlElement<'g>> {
    program.list("Parameters", "Parameter").chain(program.list("paramSection", "param"))
}

/// Returns the elements that declare locals.
pub fn locals<'g>(program: XmlElement<'g>) -> impl Iterator<Item = XmlElement<'g>> {
    program.list("Locals", "Local").chain(program.list("localSection", "local"))
}

/// Reads the tree of a `.pgx`.
pub fn read(file: View<'_>) -> Header {
    let Some(program) = element(file) else { return Header::default() };
    let value = |name: &str| program.value(name);
    Header {
        name: value("name").map(SmolStr::from).unwrap_or_default(),
        // An unknown access or a misspelt attribute counts as public, because its fault is reported separately.
        public: value("access").is_some_and(|text| text.trim() != "private")
            || attributes::has_unknown(FileKind::Program, program)
            || value("public").and_then(|text| flag(&text)).unwrap_or(false),
        params: params(program).filter_map(param).collect(),
        locals: locals(program).filter_map(local).collect(),
        complete: is_complete(program),
    }
}

fn param(element: XmlElement<'_>) -> Option<ParamDecl> {
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

fn local(element: XmlElement<'_>) -> Option<LocalDecl> {
    let name = SmolStr::from(element.value("name")?);
    let DeclaredType { type_name, container, sizes } = plain_shape(element);
    Some(LocalDecl { name, type_name, container, sizes })
}

/// Returns the shape without a type if an attribute may be misspelt, because the values are unknown then.
fn plain_shape(element: XmlElement<'_>) -> DeclaredType {
    let shape = shape(element);
    if attributes::is_plain(element) { shape } else { DeclaredType { type_name: SmolStr::default(), ..shape } }
}
