//! Global data that are linked to inputs in the data file.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::io_paths::is_input;
use val3_lang::types::{AttributeValue, BaseType, attribute};
use val3_syntax::TextRange;

use super::{data, parse};
use crate::db::{Db, File};
use crate::xml::XmlElement;

/// Returns the first link of digital and numerical data whose values are all linked to inputs, and of tools whose
/// outputs are all inputs. Only files of s7 and s8 are read.
#[salsa::tracked]
pub fn input_links(db: &dyn Db, file: File) -> FxHashMap<SmolStr, SmolStr> {
    let parse = parse(db, file);
    data::elements(parse.view()).filter_map(linked).collect()
}

fn linked(element: XmlElement<'_>) -> Option<(SmolStr, SmolStr)> {
    let (ty, _) = BaseType::from_file_name(element.value("type")?.as_ref())?;
    if !matches!(ty, BaseType::Dio | BaseType::Aio | BaseType::Tool) {
        return None;
    }
    let links: Option<Vec<SmolStr>> = element.elements().map(|value| link(value, ty)).collect();
    let first = links.filter(|links| links.iter().all(|link| is_input(link)))?.into_iter().next()?;
    Some((element.value("name")?.as_ref().into(), first))
}

/// Returns the link of a value.
fn link(value: XmlElement<'_>, ty: BaseType) -> Option<SmolStr> {
    let link = value.attributes().find(|attribute| is_link(ty, attribute.name))?;
    Some(link.text().trim().into())
}

/// Whether the attribute of a value of this type is a link.
fn is_link(ty: BaseType, name: &str) -> bool {
    attribute(ty, None, name).is_some_and(|attribute| attribute.value == AttributeValue::Link)
}

/// A link of data in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataLink {
    /// Type of the linked data.
    pub ty: BaseType,
    /// The link, for example `BasicIO-1\%I0`.
    pub text: SmolStr,
    /// Range without quotes.
    pub range: TextRange,
}

/// Returns the links of digital, numerical and serial data and of tools in a file.
pub fn links(db: &dyn Db, file: File) -> Vec<DataLink> {
    let parse = parse(db, file);
    let mut found = Vec::new();
    for element in data::elements(parse.view()) {
        let written = element.value("type").unwrap_or_else(|| element.name().into());
        let Some((ty, _)) = BaseType::from_file_name(&written) else { continue };
        let attributes = element.elements().flat_map(XmlElement::attributes);
        let links = attributes.filter(|attribute| is_link(ty, attribute.name));
        found.extend(links.map(|link| DataLink { ty, text: link.text().trim().into(), range: link.range }));
    }
    found
}
