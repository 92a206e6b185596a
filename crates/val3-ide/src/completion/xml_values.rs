//! Completions in the XML of a file.

use val3_analysis::items::project::items;
use val3_analysis::ty::Base;
use val3_lang::builtins;
use val3_lang::enumerations;
use val3_lang::types::{AttributeValue, BaseType, attribute};

use super::context::AttributePlace;
use super::{CompletionKind as Kind, Found};

/// What can stand in an attribute.
pub(super) fn values(found: &mut Found<'_>, place: &AttributePlace) {
    match (place.element.as_str(), place.attribute.as_str()) {
        ("Parameter" | "Local" | "Data" | "Field" | "param" | "local", "type") => types(found),
        (_, "access") => words(found, &["public", "private"]),
        (_, "xsi:type") => words(found, &["element", "array", "collection"]),
        (_, "use") => words(found, &["value", "reference"]),
        (_, "autoload" | "byVal" | "public") => words(found, &["true", "false"]),
        (_, "fatherId") => fathers(found, place),
        _ => value_attribute(found, place),
    }
}

fn words(found: &mut Found<'_>, words: &[&str]) {
    for word in words {
        found.add(*word, Kind::Keyword, "");
    }
}

fn types(found: &mut Found<'_>) {
    let items = items(found.db, found.project);
    for ty in BaseType::DECLARABLE {
        let name = match items.arm {
            Some(arm) if ty.depends_on_arm() => ty.file_name(arm),
            _ => ty.name().to_owned(),
        };
        found.add(name, Kind::Type, "");
    }
    for name in items.types.keys() {
        found.add(name.as_str(), Kind::Type, "user type");
    }
}

/// Frames for points and frames, tools for tools.
fn fathers(found: &mut Found<'_>, place: &AttributePlace) {
    let ty = place.data_type.as_deref().and_then(BaseType::from_file_name).map(|(ty, _)| ty);
    let Some(father) = ty.and_then(BaseType::father) else { return };
    for (name, item) in &items(found.db, found.project).data {
        if item.base == Base::of(father) {
            found.add(format!("{name}[0]"), Kind::Data, father.name());
        }
    }
    for builtin in builtins::BUILTINS.iter().filter(|builtin| builtin.ty == father && builtin.is_variable) {
        found.add(format!("{}[0]", builtin.name), Kind::Constant, father.name());
    }
}

/// Words that the attribute of a value takes.
fn value_attribute(found: &mut Found<'_>, place: &AttributePlace) {
    let ty = place.data_type.as_deref().and_then(BaseType::from_file_name);
    let Some((ty, arm)) = ty.filter(|_| place.element == "Value") else { return };
    match attribute(ty, arm, &place.attribute).map(|attribute| attribute.value) {
        Some(AttributeValue::Truth) => words(found, &["true", "false"]),
        Some(AttributeValue::Choice(choice)) => {
            let names: Vec<&str> = enumerations::values(choice).map(|value| value.file_name).collect();
            words(found, &names);
        }
        _ => {}
    }
}
