//! Initial fathers and blends of positions and motion descriptors in data files.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::db::{Db, File, Project};
use val3_analysis::items::project::items;
use val3_analysis::items::{data, parse};
use val3_analysis::xml::XmlElement;
use val3_lang::enumerations::{Enumerator, find_in_file, values};
use val3_lang::motion::is_blend;
use val3_lang::types::{AttributeValue, BaseType, DefaultValue, NumberUnit, attributes, field};

/// Father and blend in a value.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct FatherAndBlend {
    /// Father frame or tool as spelled in the file, for example `fTable[0]`.
    pub(crate) father: Option<SmolStr>,
    /// Blend of a motion descriptor, for example `joint, leave 50, reach 50`.
    pub(crate) blend: Option<SmolStr>,
}

/// Initial value of global data with this key.
pub(crate) fn placement<'db>(db: &'db dyn Db, project: Project, name: &str, key: &str) -> Option<&'db FatherAndBlend> {
    let file = items(db, project).data.get(name)?.file;
    placements(db, file).get(name)?.get(key)
}

/// Values by name and key.
#[salsa::tracked(lru = 64)]
fn placements(db: &dyn Db, file: File) -> FxHashMap<SmolStr, FxHashMap<SmolStr, FatherAndBlend>> {
    let parse = parse(db, file);
    data::elements(parse.view()).filter_map(of_data).collect()
}

fn of_data(element: XmlElement<'_>) -> Option<(SmolStr, FxHashMap<SmolStr, FatherAndBlend>)> {
    let decl = data::declaration(element)?;
    let (ty, _) = BaseType::from_file_name(&decl.type_name)?;
    if !ty.has_father() && ty != BaseType::Mdesc {
        return None;
    }
    let mut placements: FxHashMap<SmolStr, FatherAndBlend> =
        element.elements().filter_map(|value| of_value(element, value, ty)).collect();
    if ty == BaseType::Mdesc && decl.sizes == [1] {
        // A value that consists only of defaults is omitted from the file.
        placements.entry("0".into()).or_insert_with(|| FatherAndBlend { father: None, blend: blend(|_| None) });
    }
    Some((decl.name, placements))
}

fn of_value(element: XmlElement<'_>, value: XmlElement<'_>, ty: BaseType) -> Option<(SmolStr, FatherAndBlend)> {
    let key = value.value("key").or_else(|| value.value("index"))?;
    let father = attribute(value, "fatherId").filter(|father| !father.is_empty()).or_else(|| old_father(element));
    let blend = if ty == BaseType::Mdesc { blend(|name| attribute(value, name)) } else { None };
    Some((key.into(), FatherAndBlend { father, blend }))
}

/// Attribute of a value, or of an element in it as in s5 and s6.
fn attribute(value: XmlElement<'_>, name: &str) -> Option<SmolStr> {
    let text = value.value(name).or_else(|| value.elements().find_map(|part| part.value(name)))?;
    Some(SmolStr::from(text))
}

/// Father of all values in s5 and s6.
fn old_father(element: XmlElement<'_>) -> Option<SmolStr> {
    let father = element.elements().find(|inner| inner.name().ends_with("Father"))?;
    let name = father.value("name").filter(|name| !name.is_empty())?;
    Some(format!("{name}[{}]", father.value("fatherIndex").unwrap_or("0".into())).into())
}

/// Kind of the blend, and its distances if it has any. `written` returns the attribute with a name.
fn blend(written: impl Fn(&str) -> Option<SmolStr>) -> Option<SmolStr> {
    let mut kind: Option<&Enumerator> = None;
    let mut distances = String::new();
    for known in attributes(BaseType::Mdesc, None) {
        match known.value {
            AttributeValue::Choice(ty) => {
                let named = written(known.name);
                kind = named.map_or_else(|| values(ty).next(), |name| find_in_file(ty, &name));
            }
            AttributeValue::Number if is_distance(known.field) => {
                let number = written(known.name).or_else(|| default(known.default))?;
                distances.push_str(&format!(", {} {number}", known.field));
            }
            _ => {}
        }
    }
    let kind = kind?;
    Some(if is_blend(kind) { format!("{}{distances}", kind.name).into() } else { kind.name.into() })
}

fn is_distance(name: &str) -> bool {
    field(BaseType::Mdesc, None, name).is_some_and(|field| field.unit == NumberUnit::Length)
}

fn default(value: DefaultValue) -> Option<SmolStr> {
    if let DefaultValue::Number(number) = value { Some(number.to_string().into()) } else { None }
}
