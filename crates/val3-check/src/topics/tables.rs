//! Page sections from the language's tables: fields, attributes, operators, values, instructions.

use std::fmt::Write as _;

use val3_lang::enumerations;
use val3_lang::glossary::GlossaryPage;
use val3_lang::instruction::Overload;
use val3_lang::instructions;
use val3_lang::operators::{BinaryOp, UnaryOp, assignment, binary, unary};
use val3_lang::types::{Arm, BaseType, DefaultValue, Field, NumberUnit, ValueAttribute, attributes, fields};

/// Fields, file attributes, operators and instructions of a type.
pub(super) fn of_type(entry: &GlossaryPage) -> String {
    let Some(ty) = entry.names.first().and_then(|name| BaseType::from_name(name)) else { return String::new() };
    let fields = section("Fields", &of_arms(|arm| fields(ty, arm).iter().map(field_line).collect()));
    let attributes = section("In data files", &of_arms(|arm| attributes(ty, arm).iter().map(attribute_line).collect()));
    fields + &attributes + &section("Operators", &operators_of(ty)) + &section("Instructions", &instructions_of(ty))
}

/// Types with these fields, and the enumerated field's values.
pub(super) fn of_field(names: &[String]) -> String {
    let mut lines: Vec<String> = Vec::new();
    let mut values: Vec<String> = Vec::new();
    for ty in BaseType::DECLARABLE {
        for field in fields(ty, None).iter().filter(|field| names.iter().any(|name| name == field.name)) {
            lines.push(format!("- `{}.{}`: {}", ty.name(), field.name, about(field)));
            if field.ty.is_enumeration() {
                values.extend(enumerations::values(field.ty).map(|value| format!("- `{}`: {}", value.name, value.doc)));
            }
        }
    }
    section("Fields", &lines) + &section("Values", &values)
}

/// Types for which operators are defined.
pub(super) fn of_operators(names: &[String]) -> String {
    let mut lines: Vec<String> = Vec::new();
    for op in names.iter().filter_map(|name| BinaryOp::from_symbol(name)) {
        for left in BaseType::DECLARABLE {
            lines.extend(BaseType::DECLARABLE.iter().filter_map(|right| binary_line(op, left, *right)));
        }
    }
    for op in [UnaryOp::Negate, UnaryOp::Not].into_iter().filter(|op| names.iter().any(|name| name == op.symbol())) {
        lines.extend(BaseType::DECLARABLE.iter().filter_map(|ty| unary_line(op, *ty)));
    }
    section("Types", &lines)
}

fn binary_line(op: BinaryOp, left: BaseType, right: BaseType) -> Option<String> {
    let result = binary(op, left, right)?;
    Some(format!("- `{} {} {}` of type `{}`", left.name(), op.symbol(), right.name(), result.name()))
}

fn unary_line(op: UnaryOp, ty: BaseType) -> Option<String> {
    unary(op, ty).map(|result| format!("- `{} {}` of type `{}`", op.symbol(), ty.name(), result.name()))
}

/// Lines for six axes. Lines for a SCARA arm follow if they differ.
fn of_arms(lines: impl Fn(Option<Arm>) -> Vec<String>) -> Vec<String> {
    let (usual, scara) = (lines(None), lines(Some(Arm::Scara)));
    if usual == scara {
        return usual;
    }
    let title = |title: &str| vec![format!("\n{title}:\n")];
    [title("Six axes"), usual, title("SCARA arm"), scara].concat()
}

fn field_line(field: &Field) -> String {
    format!("- `{}`: {}", field.name, about(field))
}

/// Describes type, unit, default and meaning of a field.
fn about(field: &Field) -> String {
    let unit = unit(field.unit);
    let comma = if unit.is_empty() { "" } else { ", " };
    format!("`{}`{comma}{unit}{}. {}", field.ty.name(), default(field.default, ", default "), field.doc)
}

fn unit(unit: NumberUnit) -> &'static str {
    match unit {
        NumberUnit::None => "",
        NumberUnit::Length => "mm or inches",
        NumberUnit::Degrees => "degrees",
        NumberUnit::Percent => "%",
        NumberUnit::LengthPerSecond => "mm/s or inches/s",
        NumberUnit::DegreesPerSecond => "degrees/s",
        NumberUnit::Seconds => "s",
    }
}

/// Formats the default after `words`; empty if the fields of the value have defaults.
fn default(value: DefaultValue, words: &str) -> String {
    match value {
        DefaultValue::False => format!("{words}`false`"),
        DefaultValue::Number(number) => format!("{words}{number}"),
        DefaultValue::EmptyText => format!("{words}`\"\"`"),
        DefaultValue::Enumerator(name) => format!("{words}`{name}`"),
        DefaultValue::Unlinked | DefaultValue::OfFields => String::new(),
    }
}

fn attribute_line(attribute: &ValueAttribute) -> String {
    let (name, old) = (attribute.name, attribute.old_name());
    let old = if old == name { String::new() } else { format!(" (s5, s6: `{old}`)") };
    let field = if attribute.field.is_empty() || attribute.field == name {
        String::new()
    } else {
        format!(", the field `{}`", attribute.field)
    };
    let absent = default(attribute.default, "");
    let absent = if absent.is_empty() { absent } else { format!(", {absent} if it is absent") };
    format!("- `{name}`{old}{field}{absent}")
}

/// Operators that accept the type, and assignments to it.
fn operators_of(ty: BaseType) -> Vec<String> {
    let assigned = BaseType::DECLARABLE.into_iter().filter(|value| assignment(ty, *value));
    let mut lines: Vec<String> = assigned.map(|value| format!("- `{} = {}`", ty.name(), value.name())).collect();
    for op in BinaryOp::ALL {
        lines.extend(BaseType::DECLARABLE.iter().filter_map(|right| binary_line(op, ty, *right)));
    }
    lines.extend([UnaryOp::Negate, UnaryOp::Not].into_iter().filter_map(|op| unary_line(op, ty)));
    lines
}

/// Line with the instructions that accept or return a value of the type. The basic types are not listed, because most
/// instructions use them.
fn instructions_of(ty: BaseType) -> Vec<String> {
    if matches!(ty, BaseType::Bool | BaseType::Num | BaseType::String) {
        return Vec::new();
    }
    let users = instructions::all().iter().filter(|row| row.overloads.iter().any(|form| uses_type(form, ty)));
    let names: Vec<String> = users.map(|row| format!("`{}`", row.name)).collect();
    if names.is_empty() { Vec::new() } else { vec![format!("{}.", names.join(", "))] }
}

/// Whether the instruction accepts or returns a value of the type.
fn uses_type(form: &Overload, ty: BaseType) -> bool {
    form.result == Some(ty) || form.params.iter().any(|param| param.ty == Some(ty))
}

/// Formats a section of a page; empty without lines.
fn section(heading: &str, lines: &[String]) -> String {
    let mut text = String::new();
    if !lines.is_empty() {
        let _ = writeln!(text, "\n## {heading}\n{}", lines.join("\n").trim_start());
    }
    text
}
