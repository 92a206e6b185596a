//! Checks of `<Value>` and `<Field>`: keys, attributes and nested values.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::{SmolStr, format_smolstr};
use val3_lang::enumerations;
use val3_lang::files::{self, FileKind};
use val3_lang::suggest::nearest;
use val3_lang::types::{self, AttributeValue, BaseType, Container, attribute, attribute_named_elsewhere};

use super::{DataCheck, show_sizes};
use crate::file_check::{VALUE, alternatives};
use crate::items::attributes;
use crate::items::data::{DeclaredType, shape};
use crate::items::project::{DataItem, fields, items};
use crate::problem::{NameKind, ProblemKind};
use crate::ty::{Base, STRING_LIMIT, brackets};
use crate::xml::{Attribute, XmlElement};

impl DataCheck<'_> {
    /// Checks the values of a variable or field. `sizes` is empty if the size is unknown.
    pub(super) fn values(&mut self, element: XmlElement<'_>, base: Base, container: Container, sizes: &[u32]) {
        let mut seen = FxHashSet::default();
        for value in element.elements() {
            if value.name() != VALUE {
                self.found.unexpected(value, element);
                continue;
            }
            if let Some(key) = value.attribute("key") {
                self.key(key, container, sizes, &mut seen);
            }
            match base {
                Base::Builtin(ty, arm) => self.attributes(value, ty, arm),
                Base::User(_) => {
                    self.found.attributes(value, value_attributes());
                    self.fields(value, base);
                }
                Base::Unknown => {}
            }
        }
    }

    fn key(&mut self, key: Attribute<'_>, container: Container, sizes: &[u32], seen: &mut FxHashSet<String>) {
        let text = key.text().into_owned();
        let shown = SmolStr::from(text.as_str());
        match container {
            Container::Collection if text.is_empty() => {
                return self.report(key.range, ProblemKind::InvalidKey { key: shown, dims: 0 });
            }
            Container::Collection => {}
            Container::Array { .. } | Container::Element => {
                let indexes: Option<Vec<u32>> = text.split(',').map(|index| index.trim().parse().ok()).collect();
                let dims = sizes.len().max(1);
                match indexes {
                    Some(indexes) if sizes.is_empty() || indexes.len() == dims => {
                        if indexes.iter().zip(sizes).any(|(index, size)| index >= size) {
                            let size = show_sizes(sizes);
                            return self.report(key.range, ProblemKind::KeyOutOfRange { key: shown, size });
                        }
                    }
                    _ => return self.report(key.range, ProblemKind::InvalidKey { key: shown, dims }),
                }
            }
        }
        if !seen.insert(text) {
            self.report(key.range, ProblemKind::DuplicateKey { key: shown });
        }
    }

    /// Checks the attributes of a built-in type's value.
    fn attributes(&mut self, value: XmlElement<'_>, ty: BaseType, arm: Option<types::Arm>) {
        let arm = arm.or(self.items.arm);
        let names: Vec<&str> = types::attributes(ty, arm).iter().map(|attribute| attribute.name).collect();
        for (found, near) in self.found.unknown_attributes(value, value_attributes(), &names) {
            let intended = attribute_named_elsewhere(ty, arm, found.name).map(|attribute| attribute.name);
            let near = intended.filter(|name| value.attribute(name).is_none()).map(SmolStr::new_static).or(near);
            let (ty, attribute) = (ty.name().into(), found.name.into());
            self.report(found.name_range, ProblemKind::UnknownValueAttribute { ty, attribute, near });
        }
        for found in value.attributes() {
            if let Some(known) = attribute(ty, arm, found.name) {
                self.attribute_value(found, ty, known.value);
            }
        }
    }

    fn attribute_value(&mut self, found: Attribute<'_>, ty: BaseType, wanted: AttributeValue) {
        let text = found.text();
        let expected = match wanted {
            AttributeValue::Truth if !matches!(text.trim(), "true" | "false") => "`true` or `false`".into(),
            AttributeValue::Number if !is_number(&text) => "a number".into(),
            AttributeValue::Choice(choice) if enumerations::find_in_file(choice, text.trim()).is_none() => {
                choices(choice)
            }
            _ if ty == BaseType::String && text.len() > STRING_LIMIT => {
                return self.report(found.range, ProblemKind::StringTooLong(text.len()));
            }
            AttributeValue::Father(father) => return self.father(found, father),
            AttributeValue::Link => return self.link(found, ty),
            _ => return,
        };
        let value = SmolStr::from(text.as_ref());
        let kind = ProblemKind::InvalidValue { ty: ty.name().into(), attribute: found.name.into(), value, expected };
        self.report(found.range, kind);
    }

    /// Checks the `<Field>` elements of a user type's value.
    fn fields(&mut self, value: XmlElement<'_>, base: Base) {
        let Base::User(project) = base else { return };
        let known = fields(self.db, project);
        let mut seen = FxHashMap::default();
        for field in value.elements() {
            if field.name() != "Field" {
                self.found.unexpected(field, value);
                continue;
            }
            let Some(name) = field.attribute("name") else { continue };
            self.found.once(name, NameKind::Data, &mut seen);
            match known.get(name.text().as_ref()) {
                Some(item) => self.known_field(field, name, base, item),
                None if items(self.db, project).lacks_data => {}
                None => {
                    let near = nearest(&name.text(), known.keys().map(SmolStr::as_str)).map(SmolStr::from);
                    let kind = ProblemKind::UnknownUserField {
                        ty: base.display(self.db),
                        field: name.text().as_ref().into(),
                        near,
                    };
                    self.report(name.range, kind);
                }
            }
        }
    }

    fn known_field(&mut self, field: XmlElement<'_>, name: Attribute<'_>, owner: Base, item: &DataItem) {
        let DeclaredType { container: found, .. } = shape(field);
        let written = field.value("type").unwrap_or_default();
        let built_in = BaseType::from_file_name(&written).map(|(base, arm)| Base::Builtin(base, arm));
        let same_base = match (built_in, item.base) {
            (Some(written), Base::Builtin(..)) => written.same_as(item.base),
            _ => true,
        };
        let same_container = (found == Container::Collection) == (item.decl.container == Container::Collection);
        if (!same_base || !same_container) && attributes::is_plain(field) {
            let kind = ProblemKind::UserFieldType {
                ty: owner.display(self.db),
                field: name.text().as_ref().into(),
                expected: format_smolstr!("{}{}", item.decl.type_name, brackets_unless_single(item.decl.container)),
                found: format_smolstr!("{written}{}", brackets_unless_single(found)),
            };
            return self.report(name.range, kind);
        }
        let sound = self.found.size(field);
        let (container, sizes) = self.container(field, sound);
        self.values(field, item.base, container, &sizes);
    }
}

/// Returns the attributes that values of every type have.
fn value_attributes() -> &'static [files::AttributePage] {
    files::find(FileKind::Data, VALUE).map_or(&[], |value| value.attributes)
}

fn brackets_unless_single(container: Container) -> &'static str {
    match container {
        Container::Array { dims: 1 } => "",
        other => brackets(other),
    }
}

fn is_number(text: &str) -> bool {
    text.trim().parse::<f64>().is_ok_and(f64::is_finite)
}

/// Lists the enumeration's values as spelt in files.
fn choices(ty: BaseType) -> SmolStr {
    let names: Vec<SmolStr> = enumerations::values(ty).map(|value| format_smolstr!("`{}`", value.file_name)).collect();
    alternatives(&names)
}
