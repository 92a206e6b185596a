//! Pages of types, fields, operators and terms.

use val3_lang::glossary::{ENTRIES, EntryKind, GlossaryPage};
use val3_lang::page;
use val3_lang::types::{Arm, BaseType, fields};

use super::tables;
use super::topic::{Topic, TopicKind, sourced};

/// Pages of all glossary entries.
pub(super) fn topics() -> Vec<Topic> {
    ENTRIES.iter().map(topic).collect()
}

fn topic(entry: &GlossaryPage) -> Topic {
    let names: Vec<String> = entry.names.iter().map(|&name| name.to_owned()).collect();
    let (kind, what, title, tables) = match entry.kind {
        EntryKind::Type => {
            (TopicKind::Type, "type", names.first().cloned().unwrap_or_default(), tables::of_type(entry))
        }
        EntryKind::Field => (TopicKind::Field, "field", field_title(&names), tables::of_field(&names)),
        EntryKind::Operator => (TopicKind::Operator, "operator", names.join(" "), tables::of_operators(&names)),
        EntryKind::Word => (TopicKind::Word, "word", names.first().cloned().unwrap_or_default(), String::new()),
    };
    Topic {
        kind,
        group: "",
        stem: entry.stem.to_owned(),
        summary: page::summary(entry.page),
        page: format!("# {title} ({})\n\n{}{tables}", sourced(what, entry.section), page::text(entry.page)),
        names,
        title,
    }
}

/// Names of fields in code, or the first name if the page is about a file attribute.
fn field_title(names: &[String]) -> String {
    let all = || BaseType::DECLARABLE.into_iter().flat_map(|ty| [None, Some(Arm::Scara)].map(|arm| fields(ty, arm)));
    let names_of_fields = names.iter().filter(|name| all().flatten().any(|field| field.name == **name));
    let fields: Vec<&str> = names_of_fields.map(String::as_str).collect();
    if fields.is_empty() { names.first().cloned().unwrap_or_default() } else { fields.join(", ") }
}
