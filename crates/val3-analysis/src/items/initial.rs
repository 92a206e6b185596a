//! Initial positions and motion descriptors in a `.dtx`: fathers and enumerated fields, without coordinates.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::enumerations::{self, Enumerator, find_in_file};
use val3_lang::motion::rounds_corner;
use val3_lang::types::{Arm, AttributeValue, BaseType, DefaultValue, ValueAttribute, attributes};

use super::{data, parse};
use crate::db::{Db, File};
use crate::xml::XmlElement;

/// Initial values of global data, by name and key (`0`, `1,2`, `home`).
pub type InitialValues = FxHashMap<SmolStr, FxHashMap<SmolStr, Initial>>;

/// Initial value of a frame, tool, point, configuration or motion descriptor.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Initial {
    /// Whether the value is relative to a frame or tool.
    pub has_father: bool,
    /// Enumerated fields by their path after the variable (`config.shoulder`, `blend`).
    pub choices: Vec<(&'static str, &'static Enumerator)>,
    /// Whether the blend or a blend distance differs from the default (10.5.1).
    pub needs_corner: bool,
    /// `leave` and `reach` in the length unit of the application; `None` for other types, or if a text is no number.
    pub corner: Option<[f64; 2]>,
}

/// Reads the initial values in a file. An array without values in the file has an entry without keys.
#[salsa::tracked]
pub fn initial(db: &dyn Db, file: File) -> InitialValues {
    let parse = parse(db, file);
    data::elements(parse.view()).filter_map(values).collect()
}

fn values(element: XmlElement<'_>) -> Option<(SmolStr, FxHashMap<SmolStr, Initial>)> {
    let is_new = element.name() == "Data";
    let written = if is_new { element.value("type")? } else { element.name().into() };
    let (ty, arm) = BaseType::from_file_name(&written).filter(|(ty, _)| has_values(*ty))?;
    let mut values = FxHashMap::default();
    if is_new {
        for value in element.elements() {
            let Some(key) = value.value("key") else { continue };
            values.insert(key.as_ref().into(), new_value(value, ty, arm));
        }
    } else {
        let has_father = element.elements().any(is_father);
        for value in element.elements().filter(|value| value.name().starts_with("value")) {
            let Some(index) = value.value("index") else { continue };
            values.insert(index.as_ref().into(), old_value(value, ty, arm, has_father));
        }
    }
    Some((element.value("name")?.as_ref().into(), values))
}

fn has_values(ty: BaseType) -> bool {
    ty.has_father() || matches!(ty, BaseType::Config | BaseType::Mdesc)
}

/// Reads `<Value key x … shoulder … fatherId>`.
fn new_value(value: XmlElement<'_>, ty: BaseType, arm: Option<Arm>) -> Initial {
    let has_father = value.value("fatherId").is_some_and(|father| !father.trim().is_empty());
    let written = |name: &str| value.value(name).map(SmolStr::from);
    of_attributes(&written, ty, arm, has_father)
}

/// Reads `<valuePoint index>` and its elements, for example `<cpValue shoulder …>`.
fn old_value(value: XmlElement<'_>, ty: BaseType, arm: Option<Arm>, has_father: bool) -> Initial {
    let written = |name: &str| value.elements().find_map(|part| part.value(name)).map(SmolStr::from);
    of_attributes(&written, ty, arm, has_father)
}

fn of_attributes(
    written: &dyn Fn(&str) -> Option<SmolStr>,
    ty: BaseType,
    arm: Option<Arm>,
    has_father: bool,
) -> Initial {
    Initial {
        has_father,
        choices: choices(written, ty, arm),
        needs_corner: needs_corner(written, ty, arm),
        corner: corner(written, ty, arm),
    }
}

/// Returns the blend distances `leave` and `reach`.
fn corner(written: &dyn Fn(&str) -> Option<SmolStr>, ty: BaseType, arm: Option<Arm>) -> Option<[f64; 2]> {
    let attributes = attributes(ty, arm).iter().filter(|attribute| rounds_corner(attribute));
    let numbers = attributes.filter(|attribute| attribute.value == AttributeValue::Number);
    let distances: Vec<_> = numbers.map(|attribute| distance(attribute, written(attribute.name))).collect();
    let &[leave, reach] = distances.as_slice() else { return None };
    Some([leave?, reach?])
}

/// Returns the distance in `text`, or the default distance without a text; `None` for text that is no number.
fn distance(attribute: &ValueAttribute, text: Option<SmolStr>) -> Option<f64> {
    let DefaultValue::Number(usual) = attribute.default else { return None };
    text.map_or(Some(usual), |text| text.trim().parse().ok())
}

/// Whether the element is `<pFather alias name fatherIndex>` with a name; an empty name means no father.
fn is_father(element: XmlElement<'_>) -> bool {
    element.name().ends_with("Father") && element.value("name").is_some_and(|name| !name.is_empty())
}

fn needs_corner(written: &dyn Fn(&str) -> Option<SmolStr>, ty: BaseType, arm: Option<Arm>) -> bool {
    attributes(ty, arm)
        .iter()
        .filter(|attribute| rounds_corner(attribute))
        .any(|attribute| written(attribute.name).is_some_and(|text| differs_from_default(attribute, text.trim())))
}

fn differs_from_default(attribute: &ValueAttribute, text: &str) -> bool {
    match (attribute.value, attribute.default) {
        (AttributeValue::Choice(choice), _) => find_in_file(choice, text) != enumerations::values(choice).next(),
        (_, DefaultValue::Number(usual)) => text.parse() != Ok(usual),
        _ => false,
    }
}

fn choices(
    written: &dyn Fn(&str) -> Option<SmolStr>,
    ty: BaseType,
    arm: Option<Arm>,
) -> Vec<(&'static str, &'static Enumerator)> {
    let attributes = attributes(ty, arm).iter();
    let choices = attributes.map(|attribute| (attribute.field, choice(attribute, written(attribute.name))));
    choices.filter_map(|(field, choice)| Some((field, choice?))).collect()
}

/// Returns the enumerator in `text`, or the default enumerator without a text.
fn choice(attribute: &ValueAttribute, text: Option<SmolStr>) -> Option<&'static Enumerator> {
    let AttributeValue::Choice(choice) = attribute.value else { return None };
    match text {
        Some(text) => find_in_file(choice, text.trim()),
        None => enumerations::values(choice).next(),
    }
}
