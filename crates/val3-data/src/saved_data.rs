//! Values of a project's global data as `libSave` writes them: plain texts as spelled in files.

use std::borrow::Cow;

use smol_str::SmolStr;
use val3_lang::types::{AttributeValue, BaseType, DefaultValue, ValueAttribute, attribute};

/// A global variable, or a field of a user type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SavedData {
    /// Declared name.
    pub name: SmolStr,
    /// Type name as spelled in the file: `num`, `pointRx`, `Slot`.
    pub type_name: SmolStr,
    /// Container.
    pub shape: SavedContainer,
    /// Values. For an array, at least the values that differ from the default, by index; for a collection, all values.
    pub values: Vec<SavedValue>,
    /// Whether `values` contains only some of the values, so that all others and the sizes are unchanged in the file.
    pub is_part: bool,
}

/// Container of a variable.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SavedContainer {
    /// An array with one to three sizes. A single value is an array of size 1.
    Sizes(Vec<u32>),
    /// A collection.
    Keys,
}

/// A value of a container.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SavedValue {
    /// Key, or index such as `7` or `2,1`.
    pub key: String,
    /// Content.
    pub content: SavedContent,
}

/// Content of a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SavedContent {
    /// Value of a built-in type: its attributes (`val3_lang::types::attributes`) with their texts. An omitted attribute
    /// has its default.
    Attributes(Vec<(SmolStr, String)>),
    /// Value of a user type.
    Fields(Vec<SavedField>),
}

/// A field in a user type's value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SavedField {
    /// Whether the field has its initial value from the type, so that a file may omit it.
    pub initial: bool,
    /// Name, type and values.
    pub data: SavedData,
}

/// Number as spelled in files: the fewest digits that identify it, with an exponent if that is shorter.
#[must_use]
pub fn number_text(number: f64) -> String {
    let size = number.abs();
    if size != 0.0 && !(1e-5..1e15).contains(&size) { format!("{number:e}") } else { format!("{number}") }
}

/// Factor that shifts six decimals before the point.
const SIX_DECIMALS: f64 = 1e6;

/// Number from which a double has no room for six decimals.
const WITHOUT_DECIMALS: f64 = 1e9;

/// Number as [`number_text`] spells it, rounded to six decimals: a millionth of a mm or degree has no meaning for an
/// arm, and further digits only differ from file to file.
#[must_use]
pub fn rounded_number_text(number: f64) -> String {
    let is_small = number.abs() < WITHOUT_DECIMALS;
    number_text(if is_small { (number * SIX_DECIMALS).round() / SIX_DECIMALS + 0.0 } else { number })
}

impl SavedValue {
    /// Attribute text; `None` for the default.
    #[must_use]
    pub fn text(&self, name: &str) -> Option<&str> {
        let SavedContent::Attributes(attributes) = &self.content else { return None };
        attributes.iter().find(|(known, _)| known == name).map(|(_, text)| text.as_str())
    }

    /// Whether the value has a text for an attribute, even if it is the default.
    pub(crate) fn has_texts(&self) -> bool {
        matches!(&self.content, SavedContent::Attributes(attributes) if !attributes.is_empty())
    }

    /// Whether the value equals a new value, so that an array may omit it.
    pub(crate) fn is_default(&self, type_name: &str) -> bool {
        match &self.content {
            SavedContent::Attributes(attributes) => {
                attributes.iter().all(|(name, text)| same_text(type_name, name, Some(text), None))
            }
            SavedContent::Fields(fields) => fields.iter().all(|field| field.initial),
        }
    }
}

/// Whether both values of a built-in type are equivalent; `None` is the default.
#[must_use]
pub fn is_same(type_name: &str, one: Option<&SavedValue>, other: Option<&SavedValue>) -> bool {
    let text = |value: Option<&SavedValue>, name: &str| value.and_then(|value| value.text(name)).map(str::to_owned);
    let names = [one, other].into_iter().flatten().filter_map(|value| match &value.content {
        SavedContent::Attributes(attributes) => Some(attributes),
        SavedContent::Fields(_) => None,
    });
    let mut names = names.flatten().map(|(name, _)| name);
    names.all(|name| same_text(type_name, name, text(one, name).as_deref(), text(other, name).as_deref()))
}

/// Whether both texts of the attribute are equivalent; `None` is the default.
#[must_use]
pub fn same_text(type_name: &str, name: &str, one: Option<&str>, other: Option<&str>) -> bool {
    let attribute = BaseType::from_file_name(type_name).and_then(|(ty, arm)| attribute(ty, arm, name));
    let Some(attribute) = attribute else { return one == other };
    let (one, other) = (meant(attribute, one), meant(attribute, other));
    match attribute.value {
        AttributeValue::Number => match (one.trim().parse::<f64>(), other.trim().parse::<f64>()) {
            (Ok(one), Ok(other)) => one == other,
            _ => one == other,
        },
        AttributeValue::Truth | AttributeValue::Choice(_) => one.trim().eq_ignore_ascii_case(other.trim()),
        AttributeValue::Father(_) => indexed(&one) == indexed(&other),
        AttributeValue::Text | AttributeValue::Link => one == other,
    }
}

/// Attribute default, as spelled in files. The default of a link or father is empty.
#[must_use]
pub fn default_of(attribute: &ValueAttribute) -> Cow<'static, str> {
    match attribute.default {
        DefaultValue::Number(number) => number_text(number).into(),
        DefaultValue::Enumerator(name) => name.into(),
        DefaultValue::False => "false".into(),
        DefaultValue::EmptyText | DefaultValue::Unlinked | DefaultValue::OfFields => "".into(),
    }
}

/// Like [`default_of`], for the attribute `name` of a type.
pub(crate) fn default_text(type_name: &str, name: &str) -> Cow<'static, str> {
    let attribute = BaseType::from_file_name(type_name).and_then(|(ty, arm)| attribute(ty, arm, name));
    attribute.map_or("".into(), default_of)
}

fn meant<'t>(attribute: &ValueAttribute, text: Option<&'t str>) -> Cow<'t, str> {
    text.map_or_else(|| default_of(attribute), Cow::from)
}

/// Adds the index 0, which a variable without an index implies.
fn indexed(father: &str) -> Cow<'_, str> {
    if father.is_empty() || father.ends_with(']') { father.into() } else { format!("{father}[0]").into() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_all_their_digits() {
        for number in [0.0, -0.5, 0.1 + 0.2, 1e-7, 6.022e23, 123_456.789, 1e15, f64::MIN_POSITIVE, 99999.0] {
            assert_eq!(number_text(number).parse::<f64>(), Ok(number));
        }
        assert_eq!([1e15, 0.25, -3.0, 1e-16].map(number_text), ["1e15", "0.25", "-3", "1e-16"]);
    }

    #[test]
    fn rounded_numbers_have_six_decimals_at_most() {
        let numbers = [-521.010_071_662_834_3, 0.1 + 0.2, 1e-7, -1e-7, 0.000_001, 113.596_594, 6.022e23];
        let texts = ["-521.010072", "0.3", "0", "0", "1e-6", "113.596594", "6.022e23"];
        assert_eq!(numbers.map(rounded_number_text), texts);
    }

    #[test]
    fn texts_are_converted_by_type() {
        assert!(same_text("num", "value", Some("1.50"), Some("1.5")));
        assert!(same_text("num", "value", Some("0"), None));
        assert!(same_text("mdesc", "tmax", None, Some("99999.0")));
        assert!(same_text("pointRx", "elbow", None, Some("esame")));
        assert!(same_text("bool", "value", Some("True"), Some("true")));
        assert!(same_text("frame", "fatherId", Some("world"), Some("world[0]")));
        assert!(!same_text("string", "value", Some("a "), Some("a")));
        assert!(!same_text("frame", "fatherId", Some("world[0]"), None));
        assert!(!same_text("num", "value", Some("1"), None));
    }
}
