//! Pages about types, fields, operators and robot terms.
//!
//! A page is a Markdown file: a sentence, an explanation, and an example as a listing. It does not contain the
//! language's tables (fields, operators of a type, values), which `val3 explain` and the book append.

mod list;

pub use list::ENTRIES;

/// A page.
#[derive(Debug)]
pub struct GlossaryPage {
    /// Kind of the subject.
    pub kind: EntryKind,
    /// Words that find the page. The first word is the title.
    pub names: &'static [&'static str],
    /// File name without extension.
    pub stem: &'static str,
    /// Section of the manual; several are separated by commas.
    pub section: &'static str,
    /// Page in Markdown. [`crate::page`] splits it into parts.
    pub page: &'static str,
}

/// Kind of a subject.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EntryKind {
    /// A type that variables can have.
    Type,
    /// A field of a type, or an attribute of values in data files.
    Field,
    /// An operator, or several similar operators.
    Operator,
    /// A term of robots and controllers.
    Word,
}

/// Finds the page of this kind by name.
#[must_use]
pub fn find(kind: EntryKind, name: &str) -> Option<&'static GlossaryPage> {
    ENTRIES.iter().find(|entry| entry.kind == kind && entry.names.contains(&name))
}

#[cfg(test)]
mod tests {
    use super::{ENTRIES, EntryKind, find};
    use crate::operators::{BinaryOp, UnaryOp};
    use crate::types::{Arm, BaseType, attributes, fields};
    use crate::{builtins, page, statements};

    /// File attribute that is no field: the value of a `bool`, `num` or `string`.
    const VALUE: &str = "value";

    #[test]
    fn every_type_has_a_page() {
        for ty in BaseType::DECLARABLE {
            assert!(find(EntryKind::Type, ty.name()).is_some(), "{}", ty.name());
        }
        for arm in Arm::ALL {
            for ty in BaseType::DECLARABLE {
                assert!(find(EntryKind::Type, &ty.file_name(arm)).is_some(), "{}", ty.file_name(arm));
            }
        }
    }

    #[test]
    fn every_field_and_attribute_has_a_page() {
        for ty in BaseType::DECLARABLE {
            for arm in [None, Some(Arm::SixAxis), Some(Arm::Scara)] {
                let names = fields(ty, arm).iter().map(|field| field.name);
                let attributes =
                    attributes(ty, arm).iter().flat_map(|attribute| [attribute.name, attribute.old_name()]);
                for name in names.chain(attributes).filter(|&name| name != VALUE) {
                    assert!(find(EntryKind::Field, name).is_some(), "{}.{name}", ty.name());
                }
            }
        }
    }

    #[test]
    fn every_operator_has_a_page() {
        let symbols = BinaryOp::ALL.map(BinaryOp::symbol).into_iter();
        for symbol in symbols.chain([UnaryOp::Not, UnaryOp::Negate].map(UnaryOp::symbol)) {
            let found = find(EntryKind::Operator, symbol).is_some() || statements::find(symbol).is_some();
            assert!(found, "{symbol}");
        }
    }

    #[test]
    fn every_built_in_name_has_a_page() {
        for builtin in &builtins::BUILTINS {
            let found = find(EntryKind::Word, builtin.name).is_some() || statements::find(builtin.name).is_some();
            assert!(found, "{}", builtin.name);
        }
    }

    #[test]
    fn every_page_has_a_sentence_and_an_example() {
        for entry in ENTRIES {
            let summary = page::summary(entry.page);
            assert!(summary.ends_with('.') || summary.ends_with("`."), "{}: {summary}", entry.stem);
            assert!(!page::examples(entry.page).is_empty(), "{}", entry.stem);
            assert!(!entry.section.is_empty(), "{}", entry.stem);
        }
    }

    #[test]
    fn no_two_pages_of_a_kind_share_a_name() {
        for (place, entry) in ENTRIES.iter().enumerate() {
            for other in ENTRIES.iter().skip(place + 1).filter(|other| other.kind == entry.kind) {
                let shared = entry.names.iter().find(|name| other.names.contains(name));
                assert!(shared.is_none() && entry.stem != other.stem, "{shared:?} {} {}", entry.stem, other.stem);
            }
        }
    }
}
