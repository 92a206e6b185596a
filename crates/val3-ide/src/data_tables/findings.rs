//! Findings by table cell.

use val3_analysis::db::{Db, File};
use val3_analysis::items::{data, parse};
use val3_analysis::xml::XmlElement;
use val3_check::diagnostic::Diagnostic;
use val3_lang::types::{BaseType, attributes};
use val3_syntax::TextRange;

use super::place::{DataPlace, FieldStep};

/// A finding and its table cell.
#[derive(Debug, Clone, PartialEq)]
pub struct DataFinding {
    /// The value or variable.
    pub place: DataPlace,
    /// Column of the value, or attribute of the variable: `name`, `access`, `type`, `size`, `key`.
    pub column: Option<String>,
    /// The finding.
    pub diagnostic: Diagnostic,
}

/// Findings in a data file, each with its place in the tables.
pub fn data_findings(db: &dyn Db, file: File, findings: impl IntoIterator<Item = Diagnostic>) -> Vec<DataFinding> {
    let parse = parse(db, file);
    let elements: Vec<XmlElement<'_>> = data::elements(parse.view()).collect();
    let placed = findings.into_iter().filter(|found| found.place.file == file).map(|diagnostic| {
        let (place, column) = place_of(&elements, diagnostic.place.range);
        DataFinding { place, column, diagnostic }
    });
    placed.collect()
}

fn place_of(elements: &[XmlElement<'_>], range: TextRange) -> (DataPlace, Option<String>) {
    let next = elements.partition_point(|element| element.view().range().end() <= range.start());
    let found = elements.get(next).filter(|element| contains(**element, range));
    let Some((found, name)) = found.and_then(|found| Some((*found, found.value("name")?.into_owned()))) else {
        return (DataPlace::default(), None);
    };
    let mut place = DataPlace { name, ..DataPlace::default() };
    let mut at = found;
    while let Some(inner) = at.elements().find(|inner| contains(*inner, range)) {
        at = inner;
        if let Some(key) = inner.value("key").or_else(|| inner.value("index")) {
            match place.within.last_mut() {
                Some(step) => step.key = key.into_owned(),
                None => place.key = Some(key.into_owned()),
            }
        } else if inner.name() == "Field" {
            place
                .within
                .push(FieldStep { name: inner.value("name").unwrap_or_default().into_owned(), key: String::new() });
        }
    }
    (place, column(found, at, range))
}

fn contains(element: XmlElement<'_>, range: TextRange) -> bool {
    element.view().range().contains_range(range)
}

/// Column name of the attribute at `range` in an `element` of a variable.
fn column(variable: XmlElement<'_>, element: XmlElement<'_>, range: TextRange) -> Option<String> {
    let mut own = element.attributes();
    let found = own.find(|found| found.name_range.cover(found.range).contains_range(range))?.name;
    if element.attribute("fatherIndex").is_some() {
        return Some("fatherId".to_owned());
    }
    let ty = BaseType::from_file_name(variable.name()).filter(|_| variable.name() != "Data");
    let known = ty.and_then(|(ty, arm)| attributes(ty, arm).iter().find(|known| known.old_name() == found));
    let is_output = element.attribute("ioIndex").is_some();
    Some(
        match (found, known) {
            ("alias" | "name" | "ioIndex", _) if is_output => "ioLink",
            ("xsi:type", _) => "container",
            ("public", _) => "access",
            ("index", _) => "key",
            (name, known) => known.map_or(name, |known| known.name),
        }
        .to_owned(),
    )
}
