//! Parses the `Param` elements of a table.

use quick_xml::events::BytesStart;

use super::{AddOnParam, TableErrorKind};
use crate::{instruction::ArgumentForm, types::BaseType};

/// Parses a `Param` element; `position` counts from 1.
pub(super) fn param(element: &BytesStart<'_>, position: usize) -> Result<AddOnParam, TableErrorKind> {
    let ty = BaseType::from_file_name(&attribute(element, "type")?).map(|(ty, _)| ty);
    let name = format!("{}{position}", ty.map_or("x", prefix));
    Ok(AddOnParam { name, ty, shape: shape(element)? })
}

fn shape(element: &BytesStart<'_>) -> Result<ArgumentForm, TableErrorKind> {
    let says = |name| attribute(element, name).map(|value| value == "true");
    let takes_any_container = says("collectionName")? && attribute(element, "arrayDim")? == "0";
    Ok(if says("array")? && !takes_any_container {
        ArgumentForm::Array { dims: dimensions(attribute(element, "arrayDim")?)? }
    } else if says("dictionary")? {
        ArgumentForm::Collection
    } else if says("collectionName")? || says("subCollection")? {
        ArgumentForm::Whole
    } else if says("dataRef")? {
        ArgumentForm::Reference
    } else {
        ArgumentForm::Value
    })
}

fn dimensions(text: String) -> Result<u8, TableErrorKind> {
    match text.parse() {
        Ok(dims @ 1..=3) => Ok(dims),
        _ => Err(TableErrorKind::Dimensions(text)),
    }
}

/// Attribute value; empty if it is missing.
fn attribute(element: &BytesStart<'_>, name: &str) -> Result<String, TableErrorKind> {
    let malformed = || TableErrorKind::Xml("an attribute is not well-formed".to_owned());
    let found = element.try_get_attribute(name).map_err(|_| malformed())?;
    Ok(found.map(|attribute| attribute.value.into_owned()).unwrap_or_default())
}

/// Usual name prefix for variables of this type.
fn prefix(ty: BaseType) -> &'static str {
    match ty {
        BaseType::Bool => "b",
        BaseType::Num => "n",
        BaseType::String => "s",
        BaseType::Dio => "di",
        BaseType::Aio => "ai",
        BaseType::Sio => "si",
        BaseType::Screen => "sc",
        BaseType::Trsf => "tr",
        BaseType::Frame => "f",
        BaseType::Tool => "t",
        BaseType::Point => "p",
        BaseType::Joint => "j",
        BaseType::Config => "c",
        BaseType::Mdesc => "m",
        BaseType::Blend | BaseType::Shoulder | BaseType::Elbow | BaseType::Wrist => "x",
    }
}
