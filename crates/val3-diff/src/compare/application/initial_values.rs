//! Values of user type fields that a data file omits: the initial values in the type's own project.

use std::collections::{BTreeMap, BTreeSet};

use camino::Utf8PathBuf;
use rustc_hash::FxHashSet;
use smol_str::{SmolStr, format_smolstr};
use val3_analysis::items::data::DataDecl;
use val3_analysis::paths::path_key;
use val3_lang::types::Container;

use super::sides::{DataSides, read};
use crate::applications::{Application, Matched, target};
use crate::read::code::Renames;
use crate::read::data::DataVersion;
use crate::read::value::FileValue;

/// Maximum nesting of user types, because types of a broken application may contain each other.
const NESTING: usize = 16;

/// User types of a tree.
struct UserTypes<'a, 't> {
    applications: &'a [Application<'t>],
    /// Data of the types that have been read, by the path of the project file.
    data: BTreeMap<Utf8PathBuf, Vec<DataVersion>>,
}

/// Fields of an application's data as the user types declare them.
pub(crate) struct DeclaredFields<'a, 't> {
    user: &'a Application<'t>,
    types: UserTypes<'a, 't>,
    /// Types of the data, by name.
    type_names: BTreeMap<SmolStr, SmolStr>,
    /// Entries of declared fields that the data file omits.
    omitted: BTreeSet<String>,
}

/// Adds the values that only one version of the data contains to the other version, if its user type has them. Returns
/// the declared fields of both versions; `None` if the project is in one tree only.
pub(super) fn add<'a, 't>(
    sides: &mut DataSides,
    pair: &Matched<'a, 't>,
    trees: [&'a [Application<'t>]; 2],
    renames: &Renames,
) -> Option<[DeclaredFields<'a, 't>; 2]> {
    let [old_tree, new_tree] = trees;
    let mut old_fields = DeclaredFields::new(pair.old?, old_tree, &sides.old);
    let mut new_fields = DeclaredFields::new(pair.new?, new_tree, &sides.new);
    for old in sides.old.iter_mut().filter(|data| data.base.is_none()) {
        let name = renames.get(old.decl.name.as_str()).map_or(old.decl.name.as_str(), String::as_str);
        let Some(new) = sides.new.iter_mut().find(|data| data.decl.name == name) else { continue };
        let (old_values, new_values) = (old_fields.missing(old, new), new_fields.missing(new, old));
        old.values.extend(old_values);
        new.values.extend(new_values);
    }
    Some([old_fields, new_fields])
}

impl<'a, 't> DeclaredFields<'a, 't> {
    fn new(user: &'a Application<'t>, applications: &'a [Application<'t>], data: &[DataVersion]) -> Self {
        let types = UserTypes { applications, data: BTreeMap::new() };
        let type_names = data.iter().map(|data| (data.decl.name.clone(), data.decl.type_name.clone())).collect();
        Self { user, types, type_names, omitted: BTreeSet::new() }
    }

    fn missing(&mut self, data: &DataVersion, other: &DataVersion) -> Vec<(SmolStr, FileValue)> {
        self.types.missing(self.user, data, other)
    }

    /// Whether an entry that the data file omits is a field, or the type or size of an omitted field, as the user type
    /// declares it. The entry of the field comes before its attributes.
    pub(crate) fn declare(&mut self, entry: &str, value: &str) -> bool {
        let Some(FieldEntry { data, field, attribute }) = FieldEntry::parse(entry) else { return false };
        let Some(type_name) = self.type_names.get(data) else { return false };
        let Some(decl) = self.types.declaration(self.user, type_name, &field, NESTING) else { return false };
        let Some(attribute) = attribute else {
            self.omitted.insert(entry.to_owned());
            return true;
        };
        let is_omitted = entry.rsplit_once(' ').is_some_and(|(element, _)| self.omitted.contains(element));
        is_omitted
            && match attribute {
                "type" => value == decl.type_name,
                "size" => value.split_whitespace().eq(decl.sizes.iter().map(u32::to_string)),
                "xsi:type" => (value == "collection") == (decl.container == Container::Collection),
                _ => false,
            }
    }
}

/// Entry of a field: `Datas Data[tSlot] Value[1] Field[rPart] Value[0] Field[nHoles] size`.
struct FieldEntry<'e> {
    data: &'e str,
    /// Field as in a data path: `rPart[0].nHoles`.
    field: String,
    /// `None` for the element itself.
    attribute: Option<&'e str>,
}

impl<'e> FieldEntry<'e> {
    fn parse(entry: &'e str) -> Option<Self> {
        let (_, rest) = entry.split_once("Data[")?;
        let (data, rest) = rest.split_once("] Value[")?;
        let (_, mut rest) = rest.split_once("] Field[")?;
        let mut field = String::new();
        loop {
            let (name, after) = rest.split_once(']')?;
            field.push_str(name);
            let Some(inner) = after.strip_prefix(" Value[") else {
                let attribute = after.strip_prefix(' ').filter(|attribute| !attribute.contains(['[', ' ']));
                return (after.is_empty() || attribute.is_some()).then_some(Self { data, field, attribute });
            };
            let (key, after) = inner.split_once("] Field[")?;
            field.push_str(&format!("[{key}]."));
            rest = after;
        }
    }
}

impl<'a, 't> UserTypes<'a, 't> {
    /// Returns the initial values that `data` omits and `other` contains.
    fn missing(
        &mut self,
        user: &Application<'_>,
        data: &DataVersion,
        other: &DataVersion,
    ) -> Vec<(SmolStr, FileValue)> {
        let known: FxHashSet<&SmolStr> = data.values.iter().map(|(path, _)| path).collect();
        let mut missing = Vec::new();
        for (path, _) in &other.values {
            let Some((key, field)) = element_and_field(path, &other.decl.name) else { continue };
            let path = format_smolstr!("{}[{key}].{field}", data.decl.name);
            if known.contains(&path) || !(data.has_element(key) || data.keys.contains(key)) {
                continue;
            }
            missing.extend(self.initial(user, data.type_name(), field, NESTING).map(|value| (path, value)));
        }
        missing
    }

    /// Returns the initial value of a field such as `rPart[0].nWeight[2]`.
    fn initial(&mut self, user: &Application<'_>, type_name: &str, field: &str, nesting: usize) -> Option<FileValue> {
        let project = self.project(user, type_name)?;
        let (name, _) = field.split_once('[')?;
        let data = self.data_of(project).iter().find(|data| data.decl.name == name)?;
        if let Some((_, value)) = data.values.iter().find(|(path, _)| path == field) {
            return Some(value.clone());
        }
        if let Some((ty, arm)) = data.base {
            let (key, _) = field.strip_prefix(name)?.strip_prefix('[')?.split_once(']')?;
            return data.has_element(key).then(|| FileValue::default_of(ty, arm));
        }
        let (key, inner) = element_and_field(field, name)?;
        let type_name = data.type_name().to_owned();
        if nesting == 0 || !data.has_element(key) {
            return None;
        }
        self.initial(project, &type_name, inner, nesting - 1)
    }

    /// Returns the declaration of a field such as `rPart[0].nWeight`.
    fn declaration(
        &mut self,
        user: &Application<'_>,
        type_name: &str,
        field: &str,
        nesting: usize,
    ) -> Option<DataDecl> {
        let project = self.project(user, type_name)?;
        let name = field.split_once('[').map_or(field, |(name, _)| name);
        let decl = self.data_of(project).iter().find(|data| data.decl.name == name)?.decl.clone();
        if name == field {
            return Some(decl);
        }
        let (_, inner) = element_and_field(field, name)?;
        if nesting == 0 { None } else { self.declaration(project, &decl.type_name, inner, nesting - 1) }
    }

    /// Returns the project of a user type. In a tree without `usrapp`, the end of the path is compared.
    fn project(&self, user: &Application<'_>, type_name: &str) -> Option<&'a Application<'t>> {
        let types = &user.project.as_ref()?.manifest.types;
        let entry = types.iter().find(|entry| entry.name == type_name)?;
        let target = target(user.folder(), &entry.path)?;
        let applications = self.applications;
        applications.iter().find(|project| Utf8PathBuf::from(path_key(project.path.as_str())).ends_with(&target))
    }

    fn data_of(&mut self, project: &Application<'_>) -> &[DataVersion] {
        self.data.entry(project.path.clone()).or_insert_with(|| {
            project.data_files().into_iter().filter_map(|(_, file)| read(file.bytes)).flatten().collect()
        })
    }
}

/// Splits `tSlot[a b].pPick[1]` into the key `a b` and the field `pPick[1]`.
fn element_and_field<'p>(path: &'p str, name: &str) -> Option<(&'p str, &'p str)> {
    path.strip_prefix(name)?.strip_prefix('[')?.split_once("].")
}
