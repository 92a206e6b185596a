//! A value of a built-in type.

use std::borrow::Cow;

use smol_str::SmolStr;
use val3_analysis::items::positions::path_of_reference;
use val3_analysis::placement;
use val3_analysis::xml::XmlElement;
use val3_geometry::Trsf;
use val3_lang::enumerations::{find, find_in_file};
use val3_lang::types::{Arm, AttributeValue, BaseType, DefaultValue, ValueAttribute, attributes};

use super::code::Renames;
use super::data::path_with_new_name;
use super::number;

/// A value of a built-in type, with a part for each attribute of the type in the file format.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct FileValue {
    pub(crate) ty: BaseType,
    pub(crate) arm: Option<Arm>,
    parts: Vec<ValuePart>,
}

/// Kind of axis. The third axis of a SCARA arm is linear.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum AxisKind {
    Linear,
    Rotary,
}

/// Attribute content.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum ValuePart {
    /// A number.
    Number(f64),
    /// Any other content, normalised so that equal contents have equal texts. An unreadable number is a text.
    Text(SmolStr),
}

impl FileValue {
    /// Returns the value of elements that are not in the file.
    pub(crate) fn default_of(ty: BaseType, arm: Option<Arm>) -> Self {
        Self { ty, arm, parts: attributes(ty, arm).iter().map(default_part).collect() }
    }

    /// Reads the value of `element`. `container` is the element that declares the data.
    pub(crate) fn read(element: XmlElement<'_>, container: XmlElement<'_>, ty: BaseType, arm: Option<Arm>) -> Self {
        let parts = attributes(ty, arm).iter().map(|attribute| match written(element, container, attribute) {
            Some(text) => part(attribute, &text),
            None => default_part(attribute),
        });
        Self { ty, arm, parts: parts.collect() }
    }

    /// Returns each attribute with its content.
    pub(crate) fn parts(&self) -> impl Iterator<Item = (&'static ValueAttribute, &ValuePart)> {
        attributes(self.ty, self.arm).iter().zip(&self.parts)
    }

    /// Returns the transformation of a position; `None` for values without one or with an unreadable number.
    pub(crate) fn transformation(&self) -> Option<Trsf> {
        if !self.ty.has_father() && self.ty != BaseType::Trsf {
            return None;
        }
        let mut numbers = self.parts.iter().take(6).map(|part| match part {
            ValuePart::Number(number) if number.is_finite() => Some(*number),
            _ => None,
        });
        let mut next = || numbers.next().flatten();
        Some(Trsf::new([next()?, next()?, next()?], [next()?, next()?, next()?]))
    }

    /// Returns the value with the father's new name.
    pub(crate) fn with_new_father(&self, renames: &Renames) -> Self {
        let mut renamed = self.clone();
        for (attribute, part) in attributes(self.ty, self.arm).iter().zip(&mut renamed.parts) {
            if let (AttributeValue::Father(_), ValuePart::Text(father)) = (attribute.value, &mut *part) {
                *father = path_with_new_name(father, renames).unwrap_or_else(|| father.clone());
            }
        }
        renamed
    }

    /// Returns the number of parts that differ from the default.
    pub(crate) fn differing_parts(&self) -> usize {
        let default = Self::default_of(self.ty, self.arm);
        self.parts.iter().zip(&default.parts).filter(|(part, default)| part != default).count()
    }

    /// Returns the axes of a joint position; `None` for other values or with an unreadable number. Angles are in
    /// degrees, linear axes in the length unit of the application.
    pub(crate) fn axes(&self) -> Option<Vec<(AxisKind, f64)>> {
        if self.ty != BaseType::Joint {
            return None;
        }
        let axes = self.parts.iter().enumerate().map(|(index, part)| {
            let ValuePart::Number(value) = part else { return None };
            let is_linear = index == 2 && self.arm == Some(Arm::Scara);
            Some((if is_linear { AxisKind::Linear } else { AxisKind::Rotary }, *value))
        });
        axes.collect()
    }

    /// Returns the data path of the value's father; empty if the value has none.
    pub(crate) fn father(&self) -> Option<&SmolStr> {
        self.parts().find_map(|(attribute, part)| match (attribute.value, part) {
            (AttributeValue::Father(_), ValuePart::Text(father)) => Some(father),
            _ => None,
        })
    }

    /// Formats the value in one line; `None` for the default.
    pub(crate) fn shown(&self) -> Option<String> {
        let is_structure = self.parts.len() > 1;
        let default = Self::default_of(self.ty, self.arm);
        if *self == default {
            return None;
        }
        let differing = self.parts().zip(&default.parts).filter(|((_, part), default)| part != default);
        let shown = differing.map(|((attribute, part), _)| match is_structure {
            true => format!("{} {}", field_name(attribute), shown_part(attribute, part)),
            false => shown_part(attribute, part),
        });
        Some(shown.collect::<Vec<_>>().join(", "))
    }
}

/// Returns the field name in a report: `x` for the `trsf.x` of a position.
pub(crate) fn field_name(attribute: &ValueAttribute) -> &'static str {
    match attribute.value {
        AttributeValue::Father(_) => "father",
        _ => attribute.field.strip_prefix("trsf.").unwrap_or(attribute.field),
    }
}

/// Formats attribute content for a report.
pub(crate) fn shown_part(attribute: &ValueAttribute, part: &ValuePart) -> String {
    match (part, attribute.value) {
        (ValuePart::Number(number), _) => number::shown(*number),
        (ValuePart::Text(text), AttributeValue::Text) => format!("\"{text}\""),
        (ValuePart::Text(text), _) if text.is_empty() => "(none)".to_owned(),
        (ValuePart::Text(text), AttributeValue::Father(_)) => placement::shown(text),
        (ValuePart::Text(text), _) => text.to_string(),
    }
}

fn part(attribute: &ValueAttribute, text: &str) -> ValuePart {
    let trimmed = text.trim();
    match attribute.value {
        AttributeValue::Number => {
            trimmed.parse().map_or_else(|_| ValuePart::Text(text.into()), |number: f64| ValuePart::Number(number + 0.0))
        }
        AttributeValue::Choice(ty) => {
            ValuePart::Text(find_in_file(ty, trimmed).map_or(trimmed, |found| found.name).into())
        }
        AttributeValue::Father(_) => ValuePart::Text(path_of_reference(trimmed).unwrap_or_else(|| trimmed.into())),
        AttributeValue::Truth => ValuePart::Text(trimmed.into()),
        AttributeValue::Text | AttributeValue::Link => ValuePart::Text(text.into()),
    }
}

fn default_part(attribute: &ValueAttribute) -> ValuePart {
    match attribute.default {
        DefaultValue::Number(number) => ValuePart::Number(number),
        DefaultValue::Enumerator(name) => ValuePart::Text(find(name).map_or(name, |found| found.name).into()),
        DefaultValue::False => ValuePart::Text("false".into()),
        _ => ValuePart::Text(SmolStr::default()),
    }
}

/// Returns the attribute's text: in the value, or in the old dialect in an element of the value or its container.
fn written<'g>(element: XmlElement<'g>, container: XmlElement<'g>, attribute: &ValueAttribute) -> Option<Cow<'g, str>> {
    let in_parts = || element.elements().find_map(|part| part.value(attribute.old_name()));
    let old_reference = || old_reference(element, container, attribute).map(Cow::Owned);
    element.value(attribute.name).or_else(in_parts).or_else(old_reference)
}

/// Returns the father or link in the old dialect.
fn old_reference(element: XmlElement<'_>, container: XmlElement<'_>, attribute: &ValueAttribute) -> Option<String> {
    match attribute.value {
        AttributeValue::Father(_) => named(container, |name| name.ends_with("Father"), "fatherIndex"),
        AttributeValue::Link => named(element, |name| name == "io", "ioIndex"),
        _ => None,
    }
}

/// Returns the reference in an element of the old dialect: `<pFather alias="" name="world" fatherIndex="0" />`.
fn named(around: XmlElement<'_>, is_wanted: impl Fn(&str) -> bool, index: &str) -> Option<String> {
    let element = around.elements().find(|element| is_wanted(element.name()))?;
    let text = |name: &str| element.value(name).filter(|text| !text.is_empty());
    let library = text("alias").map(|alias| format!("{alias}:")).unwrap_or_default();
    Some(format!("{library}{}[{}]", text("name")?, text(index).unwrap_or(Cow::Borrowed("0"))))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str, ty: BaseType) -> FileValue {
        let parse = val3_syntax::parse(text);
        let container = val3_analysis::xml::root(parse.view()).unwrap();
        let value = container.elements().find(|element| element.name().to_lowercase().starts_with("value")).unwrap();
        FileValue::read(value, container, ty, None)
    }

    #[test]
    fn both_dialects_give_the_same_value() {
        let new =
            read("<Data><Value key=\"0\" x=\"1.50\" wrist=\"wpositive\" fatherId=\"fTray\"/></Data>", BaseType::Point);
        let old = read(
            "<point><pFather alias=\"\" name=\"fTray\" fatherIndex=\"0\"/><valuePoint index=\"0\">\
             <tpValue x=\"1.5\" y=\"0\" z=\"0\" rx=\"0\" ry=\"0\" rz=\"-0\"/>\
             <cpValue shoulder=\"ssame\" elbow=\"esame\" wrist=\"wpositive\"/></valuePoint></point>",
            BaseType::Point,
        );
        assert_eq!(new, old);
        assert_eq!(new.shown().as_deref(), Some("x 1.5, config.wrist wpositive, father fTray"));
        assert_eq!(new.father().map(SmolStr::as_str), Some("fTray[0]"));
    }

    #[test]
    fn a_gripper_of_the_old_dialect_is_named() {
        let tool = read(
            "<tool><tFather name=\"flange\" fatherIndex=\"0\"/><valueTool index=\"0\"><ttValue z=\"5\"/>\
             <io alias=\"io\" name=\"dGrip\" ioIndex=\"1\" open=\"0.5\" close=\"0\"/></valueTool></tool>",
            BaseType::Tool,
        );
        assert_eq!(tool.shown().as_deref(), Some("z 5, father flange, gripper io:dGrip[1], otime 0.5"));
    }

    #[test]
    fn a_number_that_cannot_be_read_is_a_text() {
        let value = read("<Data><Value key=\"0\" value=\"1,5\"/></Data>", BaseType::Num);
        assert_eq!(value.shown().as_deref(), Some("1,5"));
        assert!(read("<Data><Value x=\"a\"/></Data>", BaseType::Trsf).transformation().is_none());
    }
}
