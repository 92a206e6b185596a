//! Values of built-in types.

use std::borrow::Cow;

use val3_analysis::ty::Base;
use val3_analysis::xml::XmlElement as Xml;
use val3_bytecode::{FatherLink, LinkTarget};
use val3_lang::enumerations::find_in_file;
use val3_lang::memory::{DetachedValue, Lanes, ValueType, enumerator, field_offset};
use val3_lang::types::{Arm, AttributeValue, BaseType, DefaultValue, ValueAttribute, attributes, field};
use val3_lang::values::Text;

use super::{LoadedLink, fathers};

/// Returns the value for an omitted element, if it differs from the default in programs (`mdesc`).
pub(super) fn unwritten(base: Base, kind: &ValueType) -> Option<DetachedValue> {
    let Base::Builtin(base, arm) = base else { return None };
    let value = default_of(base, arm, kind);
    (value != kind.default).then_some(value)
}

/// Reads a value. `common` is the father that the data declare for all values.
pub(super) fn read(
    value: Xml<'_>,
    common: Option<&FatherLink>,
    base: BaseType,
    arm: Option<Arm>,
    kind: &ValueType,
    number: u32,
    links: &mut Vec<LoadedLink>,
) -> DetachedValue {
    let mut read = default_of(base, arm, kind);
    for attribute in attributes(base, arm) {
        let Some(offset) = offset(base, arm, attribute.field) else { continue };
        let mut link = |target| links.push(LoadedLink { path: Vec::new(), value: number, link: offset.link, target });
        let Some(text) = written(value, attribute) else {
            if let (AttributeValue::Link, Some(gripper)) = (attribute.value, fathers::gripper(value)) {
                link(LinkTarget::Signal(gripper));
            }
            continue;
        };
        match attribute.value {
            AttributeValue::Text => put(&mut read.texts, offset.text, Text::from(text.as_ref())),
            AttributeValue::Link if !text.is_empty() => {
                let port = if base.is_linkable() { base } else { BaseType::Dio };
                link(LinkTarget::Port(port, text.into_owned()));
            }
            AttributeValue::Link | AttributeValue::Father(_) => {}
            _ => read_number(attribute, &text).into_iter().for_each(|found| put(&mut read.nums, offset.num, found)),
        }
    }
    let own = value.attribute("fatherId").map(|_| fathers::of(value));
    if let Some(father) = own.unwrap_or_else(|| common.cloned()) {
        fathers::attach_father(&mut read, father, number, links);
    }
    read
}

/// Returns the value for an element without attributes.
fn default_of(base: BaseType, arm: Option<Arm>, kind: &ValueType) -> DetachedValue {
    let mut value = kind.default.clone();
    for attribute in attributes(base, arm) {
        let Some(offset) = offset(base, arm, attribute.field) else { continue };
        match attribute.default {
            DefaultValue::Number(number) => put(&mut value.nums, offset.num, number),
            DefaultValue::Enumerator(name) => put(&mut value.nums, offset.num, enumerator(name)),
            _ => {}
        }
    }
    value
}

/// Returns an attribute's text: from the value, or in the old dialect from an element in it.
fn written<'g>(value: Xml<'g>, attribute: &ValueAttribute) -> Option<Cow<'g, str>> {
    let in_parts = || value.elements().find_map(|part| part.value(attribute.old_name()));
    value.value(attribute.name).or_else(in_parts)
}

fn read_number(attribute: &ValueAttribute, text: &str) -> Option<f64> {
    match attribute.value {
        AttributeValue::Truth => Some(f64::from(u8::from(text.trim() == "true"))),
        AttributeValue::Number => text.trim().parse().ok(),
        AttributeValue::Choice(ty) => find_in_file(ty, text.trim()).map(|found| enumerator(found.name)),
        _ => None,
    }
}

/// Returns the offset of a field: `trsf.x`.
fn offset(base: BaseType, arm: Option<Arm>, path: &str) -> Option<Lanes> {
    let names = path.split('.').filter(|name| !name.is_empty());
    let (_, offset) = names.into_iter().try_fold((base, Lanes::default()), |(base, offset), name| {
        Some((field(base, arm, name)?.ty, offset + field_offset(base, arm, name)?))
    })?;
    Some(offset)
}

fn put<T>(lanes: &mut [T], at: u32, value: T) {
    if let Some(slot) = lanes.get_mut(at as usize) {
        *slot = value;
    }
}
