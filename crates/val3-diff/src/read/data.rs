//! Data of a `.dtx`, with all values in the file.

use std::collections::{BTreeMap, BTreeSet};

use smol_str::{SmolStr, format_smolstr};
use val3_analysis::items::data::{self, DataDecl};
use val3_analysis::items::positions::key_of;
use val3_analysis::xml::XmlElement;
use val3_lang::builtins;
use val3_lang::types::{Arm, BaseType, Container};
use val3_syntax::view::View;

use super::code::Renames;
use super::value::FileValue;

/// Maximum nesting of fields that are read, so that hostile files cannot overflow the stack.
const NESTING: usize = 16;

/// Global data.
#[derive(Debug, Clone)]
pub(crate) struct DataVersion {
    pub(crate) decl: DataDecl,
    /// Built-in type with its kind of arm; `None` for a user type.
    pub(crate) base: Option<(BaseType, Option<Arm>)>,
    /// Keys of the elements in the file.
    pub(crate) keys: BTreeSet<SmolStr>,
    /// Values by data path (`tSlot[a].pPick[0]`), in file order.
    pub(crate) values: Vec<(SmolStr, FileValue)>,
    /// Dimensions of user type fields in the file, by data path of the field (`tSlot[a].pPick`).
    pub(crate) field_sizes: BTreeMap<SmolStr, String>,
}

impl DataVersion {
    /// Whether the data have an element with this key: `3`, `1,2`, or the key of a collection.
    pub(crate) fn has_element(&self, key: &str) -> bool {
        if self.decl.container == Container::Collection {
            return self.keys.contains(key);
        }
        let indexes: Vec<Option<u32>> = key.split(',').map(|index| index.trim().parse().ok()).collect();
        let sizes = &self.decl.sizes;
        indexes.len() == sizes.len()
            && indexes.iter().zip(sizes).all(|(index, size)| index.is_some_and(|index| index < *size))
    }

    /// Returns the data with new names of the data and their fathers.
    pub(crate) fn renamed(&self, renames: &Renames) -> Self {
        let mut renamed = self.clone();
        if let Some(name) = renames.get(self.decl.name.as_str()) {
            renamed.decl.name = name.into();
        }
        let path = |path: &SmolStr| path_with_new_name(path, renames).unwrap_or_else(|| path.clone());
        renamed.values = self.values.iter().map(|(at, value)| (path(at), value.with_new_father(renames))).collect();
        renamed.field_sizes = self.field_sizes.iter().map(|(at, size)| (path(at), size.clone())).collect();
        renamed
    }

    /// Returns the type, with the suffix of the arm only if the file contains it.
    pub(crate) fn type_name(&self) -> &str {
        &self.decl.type_name
    }

    /// Returns the dimensions: `3`, `3 x 4`, `collection`.
    pub(crate) fn size(&self) -> String {
        match self.decl.container {
            Container::Collection => "collection".to_owned(),
            _ => self.decl.sizes.iter().map(u32::to_string).collect::<Vec<_>>().join(" x "),
        }
    }

    /// Returns the declaration without the access: `num nA[3]`.
    pub(crate) fn declaration(&self) -> String {
        declaration(&self.decl.type_name, &self.decl.name, self.decl.container, &self.decl.sizes)
    }

    /// Returns the value of data with one element; `None` for the default value and for several elements.
    pub(crate) fn single(&self) -> Option<String> {
        let is_single = self.base.is_some() && self.decl.sizes == [1];
        self.values.first().filter(|_| is_single).and_then(|(_, value)| value.shown())
    }
}

/// Renames data in a path: `fNew[3].pA` for `fOld[3].pA`; `None` if the data are not renamed.
pub(crate) fn path_with_new_name(path: &str, renames: &Renames) -> Option<SmolStr> {
    let end = path.find(['[', '.']).unwrap_or(path.len());
    let (name, rest) = path.split_at_checked(end)?;
    renames.get(name).map(|new| format_smolstr!("{new}{rest}"))
}

/// Formats a declaration: `num nA[3]`, `dio dIn[""]`.
pub(crate) fn declaration(type_name: &str, name: &str, container: Container, sizes: &[u32]) -> String {
    let ty = if type_name.is_empty() { "?" } else { type_name };
    match (container, sizes) {
        (Container::Collection, _) => format!("{ty} {name}[\"\"]"),
        (_, [] | [1]) => format!("{ty} {name}"),
        (_, sizes) => {
            let sizes: Vec<String> = sizes.iter().map(u32::to_string).collect();
            format!("{ty} {name}[{}]", sizes.join(","))
        }
    }
}

/// Reads the data of a file, without `world` and `flange`, which files of s5 and s6 declare.
pub(crate) fn read(file: View<'_>) -> Vec<DataVersion> {
    data::elements(file).filter_map(read_one).filter(|data| !is_built_in(data)).collect()
}

fn is_built_in(data: &DataVersion) -> bool {
    let builtin = builtins::find(&data.decl.name).filter(|builtin| builtin.is_variable);
    builtin.is_some_and(|builtin| data.base.is_some_and(|(ty, _)| ty == builtin.ty))
}

fn read_one(element: XmlElement<'_>) -> Option<DataVersion> {
    let decl = data::declaration(element)?;
    let mut data = DataVersion {
        base: BaseType::from_file_name(&decl.type_name),
        decl,
        keys: elements(element).map(|(key, _)| key).collect(),
        values: Vec::new(),
        field_sizes: BTreeMap::new(),
    };
    let (name, base) = (data.decl.name.clone(), data.base);
    values(&name, element, base, NESTING, &mut data);
    Some(data)
}

/// Returns the elements of data or a field in the file, with their keys.
fn elements<'g>(container: XmlElement<'g>) -> impl Iterator<Item = (SmolStr, XmlElement<'g>)> {
    let values = container.elements().filter(|element| element.name().to_ascii_lowercase().starts_with("value"));
    values.filter_map(|element| {
        let key = element.value("key").or_else(|| element.value("index"))?;
        Some((key_of(&key).into(), element))
    })
}

fn values(
    name: &str,
    container: XmlElement<'_>,
    base: Option<(BaseType, Option<Arm>)>,
    nesting: usize,
    data: &mut DataVersion,
) {
    for (key, element) in elements(container) {
        let path = format_smolstr!("{name}[{key}]");
        match base {
            Some((ty, arm)) => data.values.push((path, FileValue::read(element, container, ty, arm))),
            None if nesting == 0 => {}
            None => element.elements().filter(|field| field.name() == "Field").for_each(|field| {
                let Some(field_name) = field.value("name") else { return };
                let base = field.value("type").and_then(|ty| BaseType::from_file_name(&ty));
                let path = format!("{path}.{field_name}");
                if let Some(size) = field.value("size") {
                    let sizes: Vec<&str> = size.split_whitespace().collect();
                    data.field_sizes.insert(path.as_str().into(), sizes.join(" x "));
                }
                if let Some((ty, arm)) = base.filter(|_| is_unwritten_single(field)) {
                    return data.values.push((format_smolstr!("{path}[0]"), FileValue::default_of(ty, arm)));
                }
                values(&path, field, base, nesting - 1, data);
            }),
        }
    }
}

/// Whether the field has one element with the default value, which files may omit.
fn is_unwritten_single(field: XmlElement<'_>) -> bool {
    elements(field).next().is_none() && field.value("size").is_some_and(|size| size.trim() == "1")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(text: &str) -> Vec<String> {
        let parse = val3_syntax::parse(text);
        let data = read(parse.view());
        let value = |(path, value): &(SmolStr, FileValue)| format!("{path}={}", value.shown().unwrap_or_default());
        data.iter().flat_map(|data| std::iter::once(data.declaration()).chain(data.values.iter().map(value))).collect()
    }

    #[test]
    fn values_are_read_with_their_paths() {
        let text = "<Database><Datas><Data name=\"tSlot\" access=\"public\" xsi:type=\"collection\" type=\"Slot\">\
            <Value key=\"a b\"><Field name=\"pPick\" xsi:type=\"array\" type=\"pointRx\" size=\"2\">\
            <Value key=\"1\" x=\"10\" fatherId=\"world[0]\"/></Field></Value></Data>\
            <Data name=\"nGrid\" access=\"private\" xsi:type=\"array\" type=\"num\" size=\"3 4\"><Value key=\"2, 1\" value=\"7\"/></Data>\
            </Datas></Database>";
        assert_eq!(
            shown(text),
            ["Slot tSlot[\"\"]", "tSlot[a b].pPick[1]=x 10, father world", "num nGrid[3,4]", "nGrid[2,1]=7"]
        );
    }

    #[test]
    fn the_old_dialect_declares_world() {
        let text = "<dataList><frameSection><frame name=\"world\"><fFather name=\"\"/></frame></frameSection>\
            <numSection><num name=\"nA\" public=\"true\"><valueNum index=\"0\" value=\"3\"/></num></numSection></dataList>";
        assert_eq!(shown(text), ["num nA", "nA[0]=3"]);
    }
}
