//! Hover for the attributes of a value in a data file: the corresponding fields.

use val3_analysis::db::{Db, Project};
use val3_analysis::items::project::items;
use val3_analysis::items::{data, parse};
use val3_analysis::xml::{Attribute, XmlElement};
use val3_lang::enumerations::find_in_file;
use val3_lang::types::{Arm, AttributeValue, BaseType, NumberUnit, attribute, field};
use val3_syntax::TextRange;

use super::text::Hover;
use super::units;
use crate::FilePosition;
use crate::markdown::fenced;

pub(super) fn hover(db: &dyn Db, project: Project, at: FilePosition) -> Option<Hover> {
    let parse = parse(db, at.file);
    let holds = |range: TextRange| range.contains_inclusive(at.offset);
    let mut element = data::elements(parse.view()).find(|found| holds(found.view().range()))?;
    // A field of a user type has its own type.
    let mut ty = type_of(element);
    while let Some(inner) = element.elements().find(|inner| holds(inner.view().range())) {
        element = inner;
        ty = type_of(element).or(ty);
    }
    let (ty, arm) = ty?;
    let found = element.attributes().find(|found| holds(found.name_range) || holds(found.range))?;
    let arm = arm.or(items(db, project).arm);
    let markdown = about(db, project, ty, arm, found)?;
    Some(Hover { range: found.name_range.cover(found.range), markdown })
}

fn type_of(element: XmlElement<'_>) -> Option<(BaseType, Option<Arm>)> {
    BaseType::from_file_name(&element.value("type")?)
}

fn about(db: &dyn Db, project: Project, ty: BaseType, arm: Option<Arm>, found: Attribute<'_>) -> Option<String> {
    let known = attribute(ty, arm, found.name).filter(|known| !known.field.is_empty())?;
    let choice = match known.value {
        AttributeValue::Choice(choice) => find_in_file(choice, &found.text()),
        _ => None,
    };
    let choice = choice.map(|choice| format!("\n\n`{}`: {}", choice.name, choice.doc)).unwrap_or_default();
    Some(field_page(db, project, ty, arm, known.field)? + &choice)
}

/// Description of a type's field such as `trsf.x`, with its unit.
pub(super) fn field_page(db: &dyn Db, project: Project, ty: BaseType, arm: Option<Arm>, path: &str) -> Option<String> {
    let (doc, unit) = field_at(ty, arm, path)?;
    let unit = units::word(db, project, unit).map(|unit| format!(" ({unit})")).unwrap_or_default();
    Some(fenced(&format!("{}.{path}", ty.name())) + &format!("\n{doc}{unit}"))
}

/// Documentation and unit of a type's field such as `trsf.x`.
pub(super) fn field_at(ty: BaseType, arm: Option<Arm>, path: &str) -> Option<(&'static str, NumberUnit)> {
    let (first, rest) = path.split_once('.').unwrap_or((path, ""));
    let found = field(ty, arm, first)?;
    if rest.is_empty() { Some((found.doc, found.unit)) } else { field_at(found.ty, arm, rest) }
}
