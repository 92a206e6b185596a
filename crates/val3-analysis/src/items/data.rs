//! Declarations in a `.dtx`: global data, or the fields of a user type.

use smol_str::SmolStr;
use val3_lang::files::FileKind;
use val3_lang::types::{BaseType, Container};
use val3_syntax::TextRange;
use val3_syntax::view::View;

use super::{attributes, flag, is_sound, parse, sizes};
use crate::db::{Db, File};
use crate::xml::{self, XmlElement};

/// A global variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataDecl {
    /// Variable name.
    pub name: SmolStr,
    /// Type as written in the file (`jointRx`, `Slot`); empty if the type or size is unreadable.
    pub type_name: SmolStr,
    /// Container of the values. A single value is an array of size 1.
    pub container: Container,
    /// Initial sizes of the dimensions; empty for a collection.
    pub sizes: Vec<u32>,
    /// Whether other projects may use the variable.
    pub public: bool,
    /// Whether the file declares the access.
    pub has_access: bool,
    /// Whether all defining attributes are known. If not, the variable is usable in code as any type.
    pub plain: bool,
}

impl DataDecl {
    /// Whether other projects may use the variable, or its access is missing, which is reported only in the file
    /// itself.
    pub fn may_be_public(&self) -> bool {
        self.public || !self.has_access
    }
}

/// Reads a `.dtx` of either dialect. Elements without a name are omitted.
#[salsa::tracked]
pub fn data(db: &dyn Db, file: File) -> Vec<DataDecl> {
    let parse = parse(db, file);
    elements(parse.view()).filter_map(declaration).collect()
}

/// Whether every declaration of the file is readable, so that a missing name is certainly not declared in the file.
#[salsa::tracked(returns(copy))]
pub fn is_complete(db: &dyn Db, file: File) -> bool {
    let parse = parse(db, file);
    let root = xml::root(parse.view());
    is_sound(db, file) && root.is_some_and(|root| sections(root).all(|(section, item)| declares(section, item)))
}

/// Returns the sections of the root element with the tag of the items; `None` for the old dialect, where the type name
/// is the tag.
fn sections<'g>(root: XmlElement<'g>) -> impl Iterator<Item = (XmlElement<'g>, Option<&'static str>)> {
    let item = (root.name() == "Database").then_some("Data");
    root.elements().map(move |section| (section, item))
}

fn declares(section: XmlElement<'_>, item: Option<&str>) -> bool {
    let known = if item.is_some() { section.name() == "Datas" } else { section.name().ends_with("Section") };
    let mut items = section.elements();
    known && items.all(|element| item.is_none_or(|item| element.name() == item) && element.value("name").is_some())
}

/// Returns the elements that declare data in order, including elements without a name.
pub fn elements(file: View<'_>) -> impl Iterator<Item = XmlElement<'_>> {
    let root = xml::root(file);
    let new = root.into_iter().flat_map(|root| root.list("Datas", "Data"));
    let old = root.filter(|root| root.name() == "dataList").into_iter().flat_map(|root| {
        root.elements().filter(|section| section.name().ends_with("Section")).flat_map(XmlElement::elements)
    });
    new.chain(old)
}

/// Reads the declaration in an element.
pub fn declaration(element: XmlElement<'_>) -> Option<DataDecl> {
    let name = SmolStr::from(element.value("name")?);
    Some(if element.name() == "Data" { new_declaration(element, name) } else { old_declaration(element, name) })
}

fn new_declaration(element: XmlElement<'_>, name: SmolStr) -> DataDecl {
    let DeclaredType { type_name, container, sizes } = shape(element);
    let access = element.value("access");
    let public = access.as_ref().is_some_and(|access| access.trim() != "private");
    DataDecl {
        name,
        type_name,
        container,
        sizes,
        public,
        has_access: access.is_some(),
        plain: attributes::is_plain(element),
    }
}

/// Type, container and sizes of a `<Data>`, `<Field>`, `<Local>` or `<Parameter>`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DeclaredType {
    /// Type as written; empty if the type or container is unreadable, so that the values are unknown.
    pub type_name: SmolStr,
    /// Container of the values.
    pub container: Container,
    /// Sizes; an unreadable size counts as one value.
    pub sizes: Vec<u32>,
}

/// Reads the attributes that define a variable.
pub fn shape(element: XmlElement<'_>) -> DeclaredType {
    let (mut type_name, mut collection, mut size, mut readable) = (SmolStr::default(), false, Some(vec![1]), true);
    for attribute in element.attributes() {
        let text = attribute.text();
        match attribute.name {
            "type" => type_name = SmolStr::from(text),
            "xsi:type" => {
                collection = text.trim() == "collection";
                readable &= matches!(text.trim(), "element" | "array" | "collection");
            }
            "size" => size = sizes(&text),
            "dimensions" => readable &= matches!(text.trim(), "1" | "2" | "3"),
            _ => {}
        }
    }
    let type_name = if readable && size.is_some() { type_name } else { SmolStr::default() };
    let sizes = size.unwrap_or_else(|| vec![1]);
    let dims = u8::try_from(sizes.len()).unwrap_or(1);
    match collection {
        true => DeclaredType { type_name, container: Container::Collection, sizes: Vec::new() },
        false => DeclaredType { type_name, container: Container::Array { dims }, sizes },
    }
}

/// Returns the `num` variables of a `.dtx` with a single value: name, value and range of the name.
pub fn single_numbers(db: &dyn Db, file: File) -> Vec<(SmolStr, f64, TextRange)> {
    let parse = parse(db, file);
    elements(parse.view()).filter_map(single_number).collect()
}

fn single_number(element: XmlElement<'_>) -> Option<(SmolStr, f64, TextRange)> {
    let declared = declaration(element)?;
    let is_number = matches!(BaseType::from_file_name(&declared.type_name), Some((BaseType::Num, _)));
    let name = element.attribute("name").filter(|_| is_number && declared.sizes == [1])?;
    let value = element.elements().next().and_then(|value| value.value("value"));
    Some((declared.name, value.map_or(Some(0.0), |value| value.trim().parse().ok())?, name.range))
}

/// Reads `<num name public size>` in `<numSection>`: the type is the tag, and a missing size is the number of values.
fn old_declaration(element: XmlElement<'_>, name: SmolStr) -> DataDecl {
    let values = element.elements().filter(|value| value.name().starts_with("value")).count();
    let size = element.value("size").and_then(|text| text.trim().parse().ok());
    let size = size.unwrap_or_else(|| u32::try_from(values).unwrap_or(u32::MAX)).max(1);
    DataDecl {
        name,
        type_name: element.name().into(),
        container: Container::Array { dims: 1 },
        sizes: vec![size],
        public: element.value("public").and_then(|text| flag(&text)).unwrap_or(false)
            || attributes::has_unknown(FileKind::Data, element),
        has_access: true,
        plain: true,
    }
}
