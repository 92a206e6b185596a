//! Coordinates of positions, frames, tools and transformations in a `.dtx`.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::enumerations::{find_in_file, values};
use val3_lang::types::{Arm, AttributeValue, BaseType, ValueAttribute, attributes};
use val3_lang::values::ConfigValue;
use val3_syntax::TextRange;
use val3_syntax::view::View;

use super::{data, parse};
use crate::data_check::{ReferencePart, steps};
use crate::db::{Db, File};
use crate::xml::XmlElement;

/// Maximum nesting of fields in a file.
const NESTING: usize = 8;

/// Values of a file by data path.
pub type FilePositions = FxHashMap<SmolStr, TaughtPosition>;

/// A value in a file, in the length unit of the application.
#[derive(Debug, Clone, PartialEq)]
pub struct TaughtPosition {
    /// Point, joint, frame, tool or transformation.
    pub ty: BaseType,
    /// Kind of arm, if the type of a point or joint names one.
    pub arm: Option<Arm>,
    /// Translation and angles, or joint values.
    pub numbers: [f64; 6],
    /// Configuration of a point.
    pub configuration: ConfigValue,
    /// Data path of the father (frame or tool).
    pub father: Option<SmolStr>,
}

impl TaughtPosition {
    /// Whether all numbers are 0, so that the position was declared but never taught.
    pub fn is_zero(&self) -> bool {
        self.numbers.iter().all(|number| *number == 0.0)
    }
}

/// Reads the values of a file. Values with unreadable numbers are omitted.
#[salsa::tracked]
pub fn positions(db: &dyn Db, file: File) -> FilePositions {
    let parse = parse(db, file);
    let mut positions = FilePositions::default();
    each(parse.view(), &mut |value| {
        if let Some(position) = value.read() {
            positions.entry(value.path.into()).or_insert(position);
        }
    });
    positions
}

/// A value in a file.
pub struct PositionElement<'g> {
    /// Data path with every index: `tSlots[1,2].pPlace[0]`.
    pub path: String,
    /// Element of the value.
    pub element: XmlElement<'g>,
    /// Element of the data or field.
    pub container: XmlElement<'g>,
    ty: BaseType,
    arm: Option<Arm>,
}

/// Calls `take` for each value of a file, including fields of user types.
pub fn each<'g>(file: View<'g>, take: &mut dyn FnMut(PositionElement<'g>)) {
    for container in data::elements(file) {
        if let Some(name) = container.value("name") {
            values_of(&name, container, NESTING, take);
        }
    }
}

fn values_of<'g>(name: &str, container: XmlElement<'g>, nesting: usize, take: &mut dyn FnMut(PositionElement<'g>)) {
    let is_new = matches!(container.name(), "Data" | "Field");
    let Some(written) = (if is_new { container.value("type") } else { Some(container.name().into()) }) else { return };
    let found = BaseType::from_file_name(&written);
    if found.is_some_and(|(ty, _)| !is_position(ty)) || nesting == 0 {
        return;
    }
    for element in container.elements().filter(|value| value.name().to_ascii_lowercase().starts_with("value")) {
        let Some(key) = element.value("key").or_else(|| element.value("index")) else { continue };
        let path = format!("{name}[{}]", key_of(&key));
        match found {
            Some((ty, arm)) => take(PositionElement { path, element, container, ty, arm }),
            None => {
                for field in element.elements().filter(|field| field.name() == "Field") {
                    if let Some(field_name) = field.value("name") {
                        values_of(&format!("{path}.{field_name}"), field, nesting - 1, take);
                    }
                }
            }
        }
    }
}

fn is_position(ty: BaseType) -> bool {
    ty.has_father() || matches!(ty, BaseType::Joint | BaseType::Trsf)
}

/// Removes blanks around the numbers of an array index. A collection key without blanks is unchanged.
pub fn key_of(key: &str) -> String {
    key.split(',').map(str::trim).collect::<Vec<_>>().join(",")
}

/// Returns the data path of a father reference: `tSlot[a].fIn[0]` for `tSlot["a"].fIn`.
pub fn path_of_reference(reference: &str) -> Option<SmolStr> {
    Some(steps(reference)?.iter().map(part_with_index).collect::<Vec<_>>().join(".").into())
}

/// Formats `fIn[0]` for `fIn`.
fn part_with_index(part: &ReferencePart) -> String {
    let index = part.index.as_deref().unwrap_or("0");
    format!("{}[{}]", part.name, key_of(index.trim().trim_matches('"')))
}

impl PositionElement<'_> {
    /// Returns the range of the index, or of the element's tag if there is no index.
    pub fn range(&self) -> TextRange {
        let key = self.element.attribute("key").or_else(|| self.element.attribute("index"));
        key.map_or_else(|| self.element.name_range(), |key| key.range)
    }

    /// Reads the value; `None` if a number is unreadable.
    pub fn read(&self) -> Option<TaughtPosition> {
        let (mut numbers, mut places) = ([0.0; 6], [0.0; 3]);
        let (mut slots, mut choices) = (numbers.iter_mut(), places.iter_mut());
        for attribute in attributes(self.ty, self.arm) {
            match attribute.value {
                AttributeValue::Number => {
                    // The times of a tool follow its transformation and are ignored.
                    let Some(slot) = slots.next() else { continue };
                    *slot = self.number(attribute)?;
                }
                AttributeValue::Choice(ty) => {
                    let Some(slot) = choices.next() else { continue };
                    *slot = self.choice(attribute, ty)?;
                }
                _ => {}
            }
        }
        let (ty, arm) = (self.ty, self.arm);
        Some(TaughtPosition { ty, arm, numbers, configuration: ConfigValue(places), father: self.father() })
    }

    fn number(&self, attribute: &ValueAttribute) -> Option<f64> {
        let Some(text) = self.written(attribute) else { return Some(0.0) };
        text.trim().parse().ok().filter(|number: &f64| number.is_finite())
    }

    /// Returns the index in the list of enumerators.
    fn choice(&self, attribute: &ValueAttribute, ty: BaseType) -> Option<f64> {
        let Some(text) = self.written(attribute) else { return Some(0.0) };
        let found = find_in_file(ty, text.trim())?;
        values(ty).position(|value| value == found).and_then(|place| u8::try_from(place).ok()).map(f64::from)
    }

    /// Returns the text of an attribute in the value; in the old dialect, in an element of the value.
    fn written(&self, attribute: &ValueAttribute) -> Option<std::borrow::Cow<'_, str>> {
        let in_parts = || self.element.elements().find_map(|part| part.value(attribute.old_name()));
        self.element.value(attribute.name).or_else(in_parts)
    }

    /// Returns the father. In the old dialect, one father applies to all values of the data.
    fn father(&self) -> Option<SmolStr> {
        if let Some(text) = self.element.value("fatherId") {
            return path_of_reference(&text);
        }
        let father = self.container.elements().find(|element| element.name().ends_with("Father"))?;
        let written = |name: &str| father.value(name).filter(|text| !text.is_empty());
        let library = written("alias").map(|alias| format!("{alias}:")).unwrap_or_default();
        Some(format!("{library}{}[{}]", written("name")?, written("fatherIndex").unwrap_or("0".into())).into())
    }
}
