//! Literals of structured types, to fill in.

use val3_analysis::items::project::items;
use val3_analysis::ty::Base;
use val3_lang::types::{BaseType, fields};

use super::{CompletionKind, Found};

/// `{…}` of the expected type.
pub(super) fn literals(found: &mut Found<'_>, expected: Option<Base>) {
    let Some(Base::Builtin(ty, arm)) = expected else { return };
    if !ty.is_structured() {
        return;
    }
    let arm = arm.or(items(found.db, found.project).arm);
    let (mut label, mut text, mut place) = (String::new(), String::new(), 0);
    write(ty, arm, &mut label, &mut text, &mut place);
    found.add(label, CompletionKind::Literal, ty.name()).snippet(text).scored(30);
}

/// Writes a literal as it is shown, and as a snippet.
fn write(ty: BaseType, arm: Option<val3_lang::types::Arm>, label: &mut String, text: &mut String, place: &mut usize) {
    let fields = fields(ty, arm);
    if fields.is_empty() {
        *place += 1;
        let value = initial(ty);
        label.push_str(value);
        text.push_str(&format!("${{{place}:{value}}}"));
        return;
    }
    label.push('{');
    text.push('{');
    for (index, field) in fields.iter().enumerate() {
        if index > 0 {
            label.push(',');
            text.push(',');
        }
        write(field.ty, arm, label, text, place);
    }
    label.push('}');
    text.push('}');
}

fn initial(ty: BaseType) -> &'static str {
    match ty {
        BaseType::Bool => "false",
        BaseType::String => "\\\"\\\"",
        _ => val3_lang::enumerations::values(ty).next().map_or("0", |value| value.name),
    }
}
