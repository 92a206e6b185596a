//! Types that a data file may declare, with their value columns.

use std::collections::BTreeSet;

use smol_str::SmolStr;
use val3_analysis::db::{Db, Project};
use val3_analysis::items::project::{DataItem, Items, fields, items, resolve_type};
use val3_analysis::ty::Base;
use val3_data::default_of;
use val3_lang::types::{Arm, AttributeValue, BaseType, Container, NumberUnit, ValueAttribute, attributes, field};
use val3_lang::{builtins, enumerations};

use super::Dialect;
use crate::declare::old_data;
use crate::father_paths::father_paths;
use crate::hover::unit_sign;
use crate::io_links::io_links;

/// A type and its table columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataType {
    /// Type name as spelled in files: `pointRx`, `num`, or a user type.
    pub name: String,
    /// Columns of a value; empty for a user type, and for types whose values are not stored in the file.
    pub columns: Vec<DataColumn>,
    /// Fields of a user type.
    pub fields: Vec<TypeField>,
    /// Whether new data of this type may be an array.
    pub has_arrays: bool,
    /// Whether new data of this type may be a collection.
    pub has_collections: bool,
}

/// A field of a user type.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TypeField {
    /// Name.
    pub name: String,
    /// Type name as spelled in files.
    pub type_name: String,
    /// Array or collection.
    pub container: Container,
    /// Array sizes.
    pub sizes: Vec<u32>,
}

/// A column of a value.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DataColumn {
    /// Attribute name in files of s7 and s8, for example `x`, `fatherId`, `value`.
    pub id: &'static str,
    /// Name in code, for example `x`, `father`, `tvel`.
    pub title: &'static str,
    /// Unit symbol.
    pub unit: Option<&'static str>,
    /// Kind of the texts.
    pub kind: ColumnKind,
    /// Possible texts of a choice, or suggestions from the project.
    pub choices: Vec<String>,
    /// Default, which omitted values have; empty without a default.
    pub default: String,
}

/// Kind of a column's texts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ColumnKind {
    /// A decimal number.
    Number,
    /// Any text.
    Text,
    /// `true` or `false`.
    Truth,
    /// One of the choices.
    Choice,
    /// A frame or tool, with an index or key.
    Father,
    /// A physical input, output or serial line.
    Link,
}

/// Types that the file may declare, and types that it does declare.
pub(super) fn types(
    db: &dyn Db,
    project: Project,
    dialect: Dialect,
    of_data: impl Iterator<Item = SmolStr>,
) -> Vec<DataType> {
    let found = TypeFinder { db, project, items: items(db, project), dialect };
    let mut names = found.built_in();
    if dialect == Dialect::New {
        let mut user: Vec<String> = found.items.types.keys().map(ToString::to_string).collect();
        user.sort_unstable();
        names.extend(user);
    }
    let mut known: BTreeSet<String> = names.iter().cloned().collect();
    let mut types: Vec<DataType> = Vec::new();
    let mut open = names;
    open.extend(of_data.map(|name| name.to_string()).filter(|name| known.insert(name.clone())));
    // The fields of user types may have types that the project does not list.
    while !open.is_empty() {
        let added: Vec<DataType> = open.drain(..).map(|name| found.describe(&name)).collect();
        let inner = added.iter().flat_map(|ty| &ty.fields).map(|field| field.type_name.clone());
        open = inner.filter(|name| known.insert(name.clone())).collect();
        types.extend(added);
    }
    types
}

struct TypeFinder<'db> {
    db: &'db dyn Db,
    project: Project,
    items: &'db Items,
    dialect: Dialect,
}

impl TypeFinder<'_> {
    /// Built-in types of the dialect, only for the arm kind of the project if it is known.
    fn built_in(&self) -> Vec<String> {
        match self.dialect {
            Dialect::New => {
                let arms = self.items.arm.map_or_else(|| vec![Arm::SixAxis, Arm::Scara], |arm| vec![arm]);
                let names = BaseType::DECLARABLE.into_iter().flat_map(|ty| {
                    let shown = if ty.depends_on_arm() { arms.len() } else { 1 };
                    arms.iter().take(shown).map(move |arm| ty.file_name(*arm)).collect::<Vec<_>>()
                });
                names.collect()
            }
            Dialect::Old => {
                let names = old_data::SECTIONS.iter().filter_map(|section| section.strip_suffix("Section"));
                names.filter(|name| old_data::can_declare(name)).map(str::to_owned).collect()
            }
        }
    }

    fn describe(&self, name: &str) -> DataType {
        let known = self.items.types.contains_key(name) || self.built_in().iter().any(|known| known == name);
        let new = self.dialect == Dialect::New;
        let base = resolve_type(&self.items.types, name);
        DataType {
            name: name.to_owned(),
            columns: BaseType::from_file_name(name).map_or_else(Vec::new, |(ty, arm)| self.columns(ty, arm)),
            fields: match base {
                Some(Base::User(owner)) => type_fields(self.db, owner),
                _ => Vec::new(),
            },
            has_arrays: known,
            has_collections: known && new && self.items.version.has_collections(),
        }
    }

    fn columns(&self, ty: BaseType, arm: Option<Arm>) -> Vec<DataColumn> {
        // In s5 and s6, inputs and outputs are linked in code.
        if self.dialect == Dialect::Old && ty.is_linkable() {
            return Vec::new();
        }
        let arm = arm.or(self.items.arm.filter(|_| self.dialect == Dialect::New));
        attributes(ty, arm).iter().map(|attribute| self.column(ty, arm, attribute)).collect()
    }

    fn column(&self, ty: BaseType, arm: Option<Arm>, attribute: &ValueAttribute) -> DataColumn {
        let (kind, choices) = match attribute.value {
            AttributeValue::Truth => (ColumnKind::Truth, Vec::new()),
            AttributeValue::Number => (ColumnKind::Number, Vec::new()),
            AttributeValue::Text => (ColumnKind::Text, Vec::new()),
            AttributeValue::Choice(choice) => (ColumnKind::Choice, file_names(choice)),
            AttributeValue::Father(father) => (ColumnKind::Father, self.fathers(father)),
            AttributeValue::Link => (ColumnKind::Link, self.links(ty)),
        };
        let sign = unit_sign(self.db, self.project, unit(ty, arm, attribute.field)).trim();
        DataColumn {
            id: attribute.name,
            title: title(attribute),
            unit: Some(sign).filter(|sign| !sign.is_empty()),
            kind,
            choices,
            default: default_of(attribute).into_owned(),
        }
    }

    /// Frames or tools to which a value can be relative.
    fn fathers(&self, father: BaseType) -> Vec<String> {
        let built_in = builtins::BUILTINS.iter().filter(|builtin| builtin.is_variable && builtin.ty == father);
        let built_in: Vec<String> = built_in.map(|builtin| format!("{}[0]", builtin.name)).collect();
        let mut data: Vec<(&str, &DataItem)> =
            self.items.data.iter().map(|(name, item)| (name.as_str(), item)).collect();
        data.sort_unstable_by_key(|(name, _)| *name);
        let own = data.into_iter().flat_map(|(name, item)| father_paths(self.db, self.project, name, item, father));
        let own: Vec<String> = own.filter(|path| !built_in.contains(path)).collect();
        [built_in, own].concat()
    }

    /// Inputs and outputs of the cell; in s5 and s6, outputs that are data.
    fn links(&self, ty: BaseType) -> Vec<String> {
        if self.dialect == Dialect::New {
            return io_links(self.db, self.project, ty).into_iter().map(|link| link.path).collect();
        }
        let outputs = self.items.data.iter().filter(|(_, item)| item.base == Base::of(BaseType::Dio));
        let mut names: Vec<String> = outputs.map(|(name, _)| format!("{name}[0]")).collect();
        names.sort_unstable();
        names
    }
}

fn file_names(choice: BaseType) -> Vec<String> {
    enumerations::values(choice).map(|value| value.file_name.to_owned()).collect()
}

/// Name in code: the last part of the field path, or the attribute name for the value itself.
fn title(attribute: &ValueAttribute) -> &'static str {
    match (attribute.value, attribute.field.rsplit('.').next()) {
        (AttributeValue::Father(_), _) => "father",
        (_, None | Some("")) => attribute.name,
        (_, Some(field)) => field,
    }
}

fn unit(ty: BaseType, arm: Option<Arm>, path: &str) -> NumberUnit {
    let (mut ty, mut unit) = (ty, NumberUnit::None);
    for name in path.split('.').filter(|name| !name.is_empty()) {
        let Some(found) = field(ty, arm, name) else { return NumberUnit::None };
        (ty, unit) = (found.ty, found.unit);
    }
    unit
}

/// Fields of a user type, sorted by name.
fn type_fields(db: &dyn Db, owner: Project) -> Vec<TypeField> {
    let fields = fields(db, owner).iter().map(|(name, item)| TypeField {
        name: name.to_string(),
        type_name: item.decl.type_name.to_string(),
        container: item.decl.container,
        sizes: item.decl.sizes.clone(),
    });
    let mut fields: Vec<TypeField> = fields.collect();
    fields.sort_unstable_by(|one, other| one.name.cmp(&other.name));
    fields
}
