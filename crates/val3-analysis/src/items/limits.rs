//! Numbers of motion descriptors in a `.dtx`.

use val3_lang::enumerations::find_in_file;
use val3_lang::motion::is_blend;
use val3_lang::types::{AttributeValue, BaseType, attribute};
use val3_syntax::TextRange;

use super::{data, parse};
use crate::db::{Db, File};
use crate::xml::{Attribute, XmlElement};

/// A number in a motion descriptor.
#[derive(Debug, Clone, PartialEq)]
pub struct DescriptorValue {
    /// Attribute name, for example `tmax` for the field `tvel`.
    pub attribute: &'static str,
    /// Value.
    pub value: f64,
    /// Range of the value, without quotes.
    pub range: TextRange,
}

/// Returns the numbers of all motion descriptors in a data file of either dialect, including fields of user types.
pub fn limits(db: &dyn Db, file: File) -> Vec<DescriptorValue> {
    let parse = parse(db, file);
    let mut found = Vec::new();
    for element in data::elements(parse.view()) {
        declared(element, &mut found);
    }
    found
}

/// Blend distances of a motion descriptor that blends.
#[derive(Debug, Clone, PartialEq)]
pub struct BlendDistances {
    /// `leave` and `reach` in the length unit of the application.
    pub distances: [f64; 2],
    /// Range of `leave`, without quotes.
    pub range: TextRange,
}

/// Returns the blend distances of all motion descriptors in a data file that have both distances and a blend other than
/// `off`.
pub fn blends(db: &dyn Db, file: File) -> Vec<BlendDistances> {
    let parse = parse(db, file);
    let mut found = Vec::new();
    for element in data::elements(parse.view()) {
        let written = element.value("type").unwrap_or_else(|| element.name().into());
        if matches!(BaseType::from_file_name(&written), Some((BaseType::Mdesc, _))) {
            let parts = element.elements().flat_map(|value| std::iter::once(value).chain(value.elements()));
            found.extend(parts.filter_map(blend));
        }
    }
    found
}

fn blend(value: XmlElement<'_>) -> Option<BlendDistances> {
    let number = |name: &str| value.value(name)?.trim().parse::<f64>().ok();
    let choice = find_in_file(BaseType::Blend, value.value("blend")?.trim())?;
    let leave = value.attributes().find(|attribute| attribute.name == "leave")?;
    let distances = [number("leave")?, number("reach")?];
    is_blend(choice).then_some(BlendDistances { distances, range: leave.range })
}

/// Collects from `<Data type>` and `<Field type>` with `<Value>`, and from `<mdesc>` with `<valueMdesc>` and
/// `<mdescValue>`.
fn declared(element: XmlElement<'_>, found: &mut Vec<DescriptorValue>) {
    let written = element.value("type").unwrap_or_else(|| element.name().into());
    let is_descriptor = matches!(BaseType::from_file_name(&written), Some((BaseType::Mdesc, _)));
    for value in element.elements() {
        let parts = std::iter::once(value).chain(value.elements());
        found.extend(parts.filter(|_| is_descriptor).flat_map(XmlElement::attributes).filter_map(limit));
        for field in value.elements().filter(|part| part.name() == "Field") {
            declared(field, found);
        }
    }
}

fn limit(written: Attribute<'_>) -> Option<DescriptorValue> {
    let known = attribute(BaseType::Mdesc, None, written.name).filter(|known| known.value == AttributeValue::Number)?;
    Some(DescriptorValue { attribute: known.name, value: written.text().trim().parse().ok()?, range: written.range })
}
