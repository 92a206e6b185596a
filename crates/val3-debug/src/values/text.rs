//! Values as text.

use val3_lang::fault::Result;
use val3_lang::memory::{ContainerShape, KindBase, LinkPlace, Memory, Place, ValueType, View, field_offset};
use val3_lang::types::{self, Arm, BaseType};
use val3_lang::values::printed;
use val3_machine::devices::Devices;

/// Number of fields in the text for a user-type value.
const SHOWN_FIELDS: usize = 4;

/// Format of numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct DisplayFormat {
    /// Whether whole numbers are hexadecimal: `0xFF`.
    pub hex: bool,
    /// Whether the angles of positions are in radians: `1.570796 rad`.
    pub radians: bool,
    /// Whether numbers have all digits that distinguish them: `0.3333333333333333`.
    pub exact: bool,
    /// Whether additional information is omitted, for example the link of an input.
    pub bare: bool,
}

impl DisplayFormat {
    /// Format in which the texts of different numbers differ.
    pub(crate) const EXACT: Self = Self { hex: false, radians: false, exact: true, bare: false };
}

/// Formats a value; of a user type only the first fields.
pub(super) fn shown(
    memory: &Memory,
    devices: &Devices,
    kind: &ValueType,
    place: Place,
    format: DisplayFormat,
) -> Result<String> {
    match &kind.base {
        KindBase::User(_) => user(memory, devices, kind, place, format),
        KindBase::Builtin(BaseType::String, _) => Ok(literal(memory.text(place)?)),
        KindBase::Builtin(BaseType::Num, _) if format.hex => {
            let value = memory.num(place, 0)?;
            Ok(hexadecimal(value).unwrap_or_else(|| number(value, format)))
        }
        KindBase::Builtin(BaseType::Num, _) => Ok(number(memory.num(place, 0)?, format)),
        KindBase::Builtin(base @ (BaseType::Dio | BaseType::Aio | BaseType::Sio), _) => {
            Ok(port(devices, *base, memory.link(place, 0)?, format))
        }
        KindBase::Builtin(..) if !format.exact => memory.shown(kind, place),
        KindBase::Builtin(base, arm) => match types::fields(*base, *arm) {
            [] => memory.shown(kind, place),
            _ => structure(memory, devices, *base, *arm, place),
        },
    }
}

/// Formats a structure such as a `trsf` from its fields. Its numbers have all digits.
fn structure(memory: &Memory, devices: &Devices, base: BaseType, arm: Option<Arm>, place: Place) -> Result<String> {
    let texts = types::fields(base, arm).iter().map(|field| {
        let offset = field_offset(base, arm, field.name).unwrap_or_default();
        let kind = ValueType::builtin(field.ty, arm);
        match field.ty {
            // The link of a tool's gripper is no part of the text.
            BaseType::Dio => memory.shown(&kind, place.after(offset)),
            _ => shown(memory, devices, &kind, place.after(offset), DisplayFormat::EXACT),
        }
    });
    Ok(printed::structure(&texts.collect::<Result<Vec<_>>>()?))
}

fn number(value: f64, format: DisplayFormat) -> String {
    let short = printed::num(value).to_string();
    if !format.exact || short.parse() == Ok(value) { short } else { format!("{value:?}") }
}

/// Formats degrees as radians.
pub(super) fn radians(degrees: f64) -> String {
    format!("{} rad", printed::num(degrees.to_radians()))
}

/// Formats a whole number within 53 bits; `None` for any other number.
fn hexadecimal(value: f64) -> Option<String> {
    const EXACT: f64 = 9_007_199_254_740_992.0;
    if value.fract() != 0.0 || value.abs() > EXACT {
        return None;
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a whole number of at most 53 bits")]
    let digits = value.abs() as u64;
    Some(format!("{}0x{digits:X}", if value < 0.0 { "-" } else { "" }))
}

/// Formats the state and link of inputs, outputs and channels.
fn port(devices: &Devices, base: BaseType, link: LinkPlace, format: DisplayFormat) -> String {
    let LinkPlace::Port(port) = link else { return "not linked".to_owned() };
    let name = devices.port_name(base, port).unwrap_or_default();
    let state = match base {
        BaseType::Dio => devices.digital(port).map(|value| printed::bool(value).to_owned()),
        BaseType::Aio => devices.analog(port).map(|value| printed::num(value).to_string()),
        _ => Ok(devices.line_state(port).to_owned()),
    };
    match state {
        Ok(state) if format.bare => state,
        Ok(state) => format!("{state} ({name})"),
        Err(fault) => format!("error {} ({name})", fault.0),
    }
}

fn user(memory: &Memory, devices: &Devices, kind: &ValueType, place: Place, format: DisplayFormat) -> Result<String> {
    let mut texts = Vec::new();
    for (lane, field) in (0..).zip(&kind.fields).take(SHOWN_FIELDS) {
        let view = View::whole(memory.part(place, lane)?);
        let text = match &field.init.kind.base {
            KindBase::Builtin(..) if memory.len(view)? == 1 => {
                shown(memory, devices, &field.init.kind, memory.element(view, 0)?, format)?
            }
            _ => "…".to_owned(),
        };
        texts.push(format!("{}={text}", field.name));
    }
    if kind.fields.len() > SHOWN_FIELDS {
        texts.push("…".to_owned());
    }
    Ok(format!("{{{}}}", texts.join(", ")))
}

pub(crate) fn type_name(kind: &ValueType) -> String {
    match &kind.base {
        KindBase::User(name) => name.clone(),
        KindBase::Builtin(base, _) => base.name().to_owned(),
    }
}

/// Formats the sizes of a container, of which `count` elements can be reached.
pub(super) fn sizes(shape: &ContainerShape, count: u32) -> String {
    match shape {
        ContainerShape::Collection(_) => "[\"\"]".to_owned(),
        ContainerShape::Array { dims: 1, .. } => format!("[{count}]"),
        ContainerShape::Array { dims, sizes } => {
            let sizes: Vec<String> = sizes.iter().take(usize::from(*dims)).map(ToString::to_string).collect();
            format!("[{}]", sizes.join(","))
        }
    }
}

/// Formats an element's index for an array with this shape: `[1,0]`.
pub(super) fn index(dims: u8, [_, rows, columns]: [u32; 3], number: u32) -> String {
    match dims {
        2 => format!("[{},{}]", number / rows.max(1), number % rows.max(1)),
        3 => {
            let (row, column) = (number / columns.max(1), number % columns.max(1));
            format!("[{},{},{column}]", row / rows.max(1), row % rows.max(1))
        }
        _ => format!("[{number}]"),
    }
}

/// Formats the key for a collection element.
pub(super) fn key(key: &str) -> String {
    format!("[{}]", literal(key))
}

/// Returns an expression for a string. Quotation marks, which a literal cannot contain, are written as `chr(34)`.
fn literal(text: &str) -> String {
    let parts: Vec<String> = text.split('"').map(printed::string).collect();
    parts.join("+chr(34)+")
}

#[cfg(test)]
mod tests {
    use super::{hexadecimal, index, key};

    #[test]
    fn whole_numbers_are_hexadecimal() {
        assert_eq!([255.0, -16.0, 0.0].map(hexadecimal), ["0xFF", "-0x10", "0x0"].map(|text| Some(text.to_owned())));
        assert_eq!([0.5, f64::NAN, f64::INFINITY, 1e300].map(hexadecimal), [const { None }; 4]);
    }

    #[test]
    fn subscripts_are_expressions() {
        assert_eq!(
            [index(1, [9, 1, 1], 7), index(2, [2, 3, 1], 5), index(3, [2, 3, 4], 23)],
            ["[7]", "[1,2]", "[1,2,3]"]
        );
        assert_eq!([key("left"), key("a\"b"), key("")], ["[\"left\"]", "[\"a\"+chr(34)+\"b\"]", "[\"\"]"]);
    }
}
