//! Hover for global data: the type, the initial value, and the chain of fathers.

use smol_str::SmolStr;
use val3_analysis::db::{Db, Project};
use val3_analysis::items::data;
use val3_analysis::items::parse;
use val3_analysis::items::project::{DataItem, items};
use val3_analysis::xml::{Attribute, XmlElement};
use val3_lang::types::{Arm, BaseType, attribute};

use super::attributes::field_at;
use super::text::shape;
use super::units::sign;
use crate::markdown::{code, fenced};
use crate::placement::placement;

/// Limit of displayed values of a container.
const SHOWN: usize = 5;
/// Limit of displayed fathers, which also ends a circular chain.
const LONGEST_CHAIN: usize = 20;

pub(super) fn hover(db: &dyn Db, project: Project, name: &str) -> Option<String> {
    let item = items(db, project).data.get(name)?;
    let access = if item.decl.public { "public " } else { "" };
    let head = format!("{access}{} {name}{}", item.decl.type_name, shape(&item.decl.sizes, item.decl.container));
    let mut text = fenced(&head);
    let values = values(db, project, item, name);
    if !values.is_empty() {
        text.push_str("\nstarts as\n");
        text.push_str(&fenced(&values.join("\n")));
    }
    let fathers = fathers(db, project, name);
    if fathers.len() > 1 {
        text.push_str(&format!(
            "\nfather: {}\n",
            fathers.iter().skip(1).map(|name| code(name)).collect::<Vec<_>>().join(", on ")
        ));
    }
    Some(text)
}

/// Calls `read` with the element that declares the data.
fn with_element<T>(db: &dyn Db, item: &DataItem, name: &str, read: impl FnOnce(XmlElement<'_>) -> T) -> Option<T> {
    let parse = parse(db, item.file);
    let mut elements = data::elements(parse.view());
    elements.find(|element| element.value("name").as_deref() == Some(name)).map(read)
}

/// Initial values, one line each: the key, then the attributes with their units.
fn values(db: &dyn Db, project: Project, item: &DataItem, name: &str) -> Vec<String> {
    let single = item.decl.sizes == [1];
    let text = ValueText { db, project, ty: item.base.builtin().map(|ty| (ty, items(db, project).arm)) };
    with_element(db, item, name, |element| text.values(element, single)).unwrap_or_default()
}

/// Keys of the values in a data file, in file order.
pub(crate) fn keys_of(db: &dyn Db, project: Project, name: &str) -> Vec<String> {
    let item = items(db, project).data.get(name);
    let keys = item.and_then(|item| {
        with_element(db, item, name, |element| {
            element.elements().filter_map(|value| value.value("key")).map(|key| key.into_owned()).collect()
        })
    });
    keys.unwrap_or_default()
}

/// Formatting of a value.
struct ValueText<'db> {
    db: &'db dyn Db,
    project: Project,
    ty: Option<(BaseType, Option<Arm>)>,
}

impl ValueText<'_> {
    /// Lines of the first values, and the number of further values.
    fn values(&self, element: XmlElement<'_>, single: bool) -> Vec<String> {
        let values = element.elements().filter(|value| !value.name().ends_with("Father"));
        let values: Vec<XmlElement<'_>> = values.collect();
        let mut lines: Vec<String> = values.iter().take(SHOWN).filter_map(|value| self.value(*value, single)).collect();
        if values.len() > SHOWN {
            lines.push(format!("… {} more", values.len() - SHOWN));
        }
        lines
    }

    fn value(&self, value: XmlElement<'_>, single: bool) -> Option<String> {
        let mut shown: Vec<String> = value.attributes().filter_map(|found| self.attribute(found)).collect();
        // In s5 and s6, the numbers and the fields of user types are one level deeper.
        for part in value.elements() {
            match part.value("name").filter(|_| part.name() == "Field") {
                Some(name) => shown.extend(part.elements().next().and_then(|inner| self.field(&name, inner))),
                None => shown.extend(part.attributes().filter_map(|found| self.attribute(found))),
            }
        }
        if shown.is_empty() {
            return None;
        }
        let key = value.value("key").or_else(|| value.value("index")).filter(|_| !single);
        Some(key.map(|key| format!("[{key}] ")).unwrap_or_default() + &shown.join(" "))
    }

    /// A field, for example `nHeight=4` or `pPick=(x=1 y=2)`.
    fn field(&self, name: &str, value: XmlElement<'_>) -> Option<String> {
        let attributes: Vec<String> = value.attributes().filter_map(|found| self.attribute(found)).collect();
        match attributes.as_slice() {
            [] => None,
            [only] if value.attribute("value").is_some() => Some(format!("{name}={only}")),
            several => Some(format!("{name}=({})", several.join(" "))),
        }
    }

    fn attribute(&self, found: Attribute<'_>) -> Option<String> {
        match found.name {
            // Fathers are displayed on a separate line.
            "key" | "index" | "fatherId" => None,
            "value" => Some(found.text().into_owned()),
            name => Some(format!("{name}={}{}", found.text(), self.unit(name).unwrap_or(""))),
        }
    }

    /// Unit of an attribute's number.
    fn unit(&self, attribute_name: &str) -> Option<&'static str> {
        let (ty, arm) = self.ty?;
        let path = attribute(ty, arm, attribute_name)?.field;
        field_at(ty, arm, path).map(|(_, unit)| sign(self.db, self.project, unit))
    }
}

/// Chain of fathers, as spelled in the file, up to `world`, `flange` or an unresolved reference.
fn fathers(db: &dyn Db, project: Project, name: &str) -> Vec<String> {
    let mut chain = vec![name.to_owned()];
    let mut next = first_father(db, project, name);
    while let Some(father) = next.filter(|_| chain.len() < LONGEST_CHAIN) {
        let shown = father.strip_suffix("[0]").unwrap_or(&father).to_owned();
        if chain.contains(&shown) {
            break;
        }
        next = father.split_once('[').and_then(|(name, index)| {
            let key = index.strip_suffix(']')?;
            placement(db, project, name, key.trim_matches('"'))?.father.clone()
        });
        chain.push(shown);
    }
    chain
}

/// Father of the first value; for a collection, of any value.
fn first_father(db: &dyn Db, project: Project, name: &str) -> Option<SmolStr> {
    let item = items(db, project).data.get(name)?;
    let key = keys_of(db, project, name).into_iter().next().unwrap_or_else(|| "0".to_owned());
    item.base.builtin().filter(|ty| ty.has_father())?;
    placement(db, project, name, &key)?.father.clone()
}
