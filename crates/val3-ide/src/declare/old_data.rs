//! Data in the dialect of s5 and s6, in which all values are explicit and the element names depend on the type.

use val3_analysis::xml::{self, XmlElement};
use val3_lang::types::{self, Arm, BaseType, Container, DefaultValue, ValueAttribute};

use super::{NewVariable, built_in_father};
use crate::xml_list::escaped;

/// Sections of a data file, in their order.
pub(crate) const SECTIONS: [&str; 19] = [
    "aioSection",
    "boolSection",
    "configRsSection",
    "configSection",
    "configVrbSection",
    "dioSection",
    "frameSection",
    "jointRsSection",
    "jointSection",
    "jointVrbSection",
    "mdescSection",
    "numSection",
    "pointRsSection",
    "pointSection",
    "pointVrbSection",
    "sioSection",
    "stringSection",
    "toolSection",
    "trsfSection",
];

/// Elements of a structured type's values.
struct ValueLayout {
    /// Element of the father.
    father: Option<&'static str>,
    /// Element around one value.
    value: &'static str,
    /// Elements inside it, each with the type whose fields it contains.
    parts: &'static [(&'static str, BaseType)],
    /// Further elements after these.
    rest: &'static [&'static str],
}

/// Default output that opens and closes a tool.
const VALVE: &str = "<io alias=\"io\" name=\"valve1\" ioIndex=\"0\" open=\"0\" close=\"0\" />";

/// Type name in this dialect, which omits the arm kind for six-axis arms.
pub(super) fn type_name(type_name: &str) -> &str {
    match BaseType::from_file_name(type_name) {
        Some((_, Some(Arm::SixAxis))) => type_name.trim_end_matches(Arm::SixAxis.suffix()),
        _ => type_name,
    }
}

/// Whether this dialect can represent data of the type.
pub(crate) fn can_declare(type_name: &str) -> bool {
    lines(&NewVariable::single("name", type_name), None, false).is_some()
}

/// Lines of a declaration; `None` if this dialect cannot represent it.
pub(super) fn lines(variable: &NewVariable, value: Option<&str>, public: bool) -> Option<Vec<String>> {
    let (name, ty) = (&variable.name, type_name(&variable.type_name));
    let [size] = variable.sizes.as_slice() else { return None };
    if variable.container == Container::Collection {
        return None;
    }
    let start = format!("<{ty} name=\"{name}\" public=\"{public}\"");
    if matches!(ty, "dio" | "aio" | "sio") {
        return Some(vec![format!("{start} size=\"{size}\" />")]);
    }
    let mut lines = vec![format!("{start} >")];
    lines.extend(simple(ty, *size, value).or_else(|| structured(ty, *size))?);
    lines.push(format!("</{ty}>"));
    Some(lines)
}

/// Calls `read` with a sample variable of this type: as a tree, and as text.
pub(crate) fn with_model<T>(ty: &str, read: impl FnOnce(XmlElement<'_>, &str) -> T) -> Option<T> {
    let text = lines(&NewVariable::single("name", ty), None, false)?.join("\n");
    let parse = val3_syntax::parse(&text);
    let root = xml::root(parse.view())?;
    Some(read(root, &text))
}

/// Elements in the part `name` of such a declaration, each with its text.
pub(crate) fn parts<'g, 't>(root: XmlElement<'g>, name: &str, text: &'t str) -> Vec<(&'g str, &'t str)> {
    let elements = part(root, name).into_iter().flat_map(XmlElement::elements);
    let parts = elements.filter_map(|element| {
        let range = std::ops::Range::<usize>::from(element.view().range());
        Some((element.name(), text.get(range)?))
    });
    parts.collect()
}

/// Attributes in the part `name` of such a declaration, with their defaults.
pub(crate) fn attributes(ty: &str, name: &str) -> Vec<(String, String)> {
    let attributes = with_model(ty, |root, _| {
        let attributes = part(root, name).into_iter().flat_map(XmlElement::attributes);
        attributes.map(|found| (found.name.to_owned(), found.text().into_owned())).collect()
    });
    attributes.unwrap_or_default()
}

fn part<'g>(element: XmlElement<'g>, name: &str) -> Option<XmlElement<'g>> {
    if element.name() == name {
        return Some(element);
    }
    element.elements().find_map(|inner| part(inner, name))
}

fn simple(ty: &str, size: u32, value: Option<&str>) -> Option<Vec<String>> {
    let (element, default) = match ty {
        "num" => ("valueNum", "0"),
        "bool" => ("valueBool", "false"),
        "string" => ("valueString", ""),
        _ => return None,
    };
    let lines = (0..size).map(|index| {
        let value = value.filter(|_| index == 0).unwrap_or(default);
        format!("  <{element} index=\"{index}\" value=\"{}\" />", escaped(value))
    });
    Some(lines.collect())
}

/// Lines of a structured type's values, with the defaults of all fields.
fn structured(type_name: &str, size: u32) -> Option<Vec<String>> {
    let ValueLayout { father, value, parts, rest } = layout(type_name)?;
    let (_, arm) = BaseType::from_file_name(type_name)?;
    let mut lines = Vec::new();
    if let Some((element, name)) = father.zip(built_in_father(type_name)) {
        lines.push(format!("  <{element} alias=\"\" name=\"{name}\" fatherIndex=\"0\" />"));
    }
    for index in 0..size {
        lines.push(format!("  <{value} index=\"{index}\" >"));
        lines.extend(parts.iter().map(|(element, ty)| format!("    <{element} {} />", defaults(*ty, arm))));
        lines.extend(rest.iter().map(|line| format!("    {line}")));
        lines.push(format!("  </{value}>"));
    }
    Some(lines)
}

fn defaults(ty: BaseType, arm: Option<Arm>) -> String {
    let written: Vec<String> = types::attributes(ty, arm).iter().filter_map(default).collect();
    written.join(" ")
}

/// An attribute with its default; `None` for links and fathers, which have other elements.
fn default(attribute: &ValueAttribute) -> Option<String> {
    let name = attribute.name;
    match attribute.default {
        DefaultValue::Number(number) => Some(format!("{name}=\"{number}\"")),
        DefaultValue::Enumerator(choice) => Some(format!("{name}=\"{choice}\"")),
        _ => None,
    }
}

fn layout(type_name: &str) -> Option<ValueLayout> {
    use BaseType::{Config, Joint, Mdesc, Trsf};
    let of = |value, parts| ValueLayout { father: None, value, parts, rest: &[] };
    Some(match type_name {
        "trsf" => of("valueTrsf", &[("trsfValue", Trsf)]),
        "frame" => ValueLayout { father: Some("fFather"), ..of("valueFrame", &[("tfValue", Trsf)]) },
        "tool" => ValueLayout { father: Some("tFather"), rest: &[VALVE], ..of("valueTool", &[("ttValue", Trsf)]) },
        "joint" => of("valueJoint", &[("jointValue", Joint)]),
        "jointRs" => of("valueJointRs", &[("jointRsValue", Joint)]),
        "point" => {
            ValueLayout { father: Some("pFather"), ..of("valuePoint", &[("tpValue", Trsf), ("cpValue", Config)]) }
        }
        "pointRs" => ValueLayout {
            father: Some("pRsFather"),
            ..of("valuePointRs", &[("tpRsValue", Trsf), ("cpRsValue", Config)])
        },
        "mdesc" => of("valueMdesc", &[("mdescValue", Mdesc)]),
        _ => return None,
    })
}
