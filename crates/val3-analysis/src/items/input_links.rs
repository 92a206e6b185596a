//! Global data whose links in the data file name inputs.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::io_paths::is_input;
use val3_lang::types::{AttributeValue, BaseType, attribute};
use val3_syntax::TextRange;

use super::{data, parse};
use crate::db::{Db, File};
use crate::xml::Element;

/// Digital and numerical data of which every value is linked to an input, and tools whose output is an input in every
/// value, with the first link. Only files of s7 and s8 are read.
#[salsa::tracked]
pub fn input_links(db: &dyn Db, file: File) -> FxHashMap<SmolStr, SmolStr> {
    let parse = parse(db, file);
    data::elements(parse.view()).filter_map(linked).collect()
}

fn linked(element: Element<'_>) -> Option<(SmolStr, SmolStr)> {
    let (ty, _) = BaseType::from_file_name(element.value("type")?.as_ref())?;
    if !matches!(ty, BaseType::Dio | BaseType::Aio | BaseType::Tool) {
        return None;
    }
    let links: Option<Vec<SmolStr>> = element.elements().map(|value| link(value, ty)).collect();
    let first = links.filter(|links| links.iter().all(|link| is_input(link)))?.into_iter().next()?;
    Some((element.value("name")?.as_ref().into(), first))
}

/// The link of a value.
fn link(value: Element<'_>, ty: BaseType) -> Option<SmolStr> {
    let is_link = |name: &str| attribute(ty, None, name).is_some_and(|known| known.value == AttributeValue::Link);
    let link = value.attributes().find(|attribute| is_link(attribute.name))?;
    Some(link.text().trim().into())
}

/// The links of the digital, numerical and serial data and of the tools of a file, with their ranges, without quotes.
pub fn links(db: &dyn Db, file: File) -> Vec<(SmolStr, TextRange)> {
    let parse = parse(db, file);
    let mut found = Vec::new();
    for element in data::elements(parse.view()) {
        let written = element.value("type").unwrap_or_else(|| element.name().into());
        let Some((ty, _)) = BaseType::from_file_name(&written) else { continue };
        let is_link = |name: &str| attribute(ty, None, name).is_some_and(|known| known.value == AttributeValue::Link);
        let attributes = element.elements().flat_map(Element::attributes).filter(|attribute| is_link(attribute.name));
        found.extend(attributes.map(|attribute| (SmolStr::from(attribute.text().trim()), attribute.range)));
    }
    found
}
