//! Checks that all file kinds share: encoding, elements, attributes, and declared names.

mod memory;

use rustc_hash::FxHashMap;
use smol_str::{SmolStr, format_smolstr};
use val3_lang::files::{self, FileKind, Presence};
use val3_lang::keywords;
use val3_lang::suggest::nearest;
use val3_lang::types::BaseType;
use val3_syntax::encoding::{Encoding, Mismatch, REPLACEMENT};
use val3_syntax::{TextRange, TextSize, text_size};

use crate::db::{Db, File, FileRange, FileStatus, Project};
use crate::items::attributes;
use crate::items::file_entry::file_entry;
use crate::items::project::{Items, resolve_type};
use crate::items::sizes;
use crate::problem::{EncodingFault, NameKind, Problem, ProblemKind, Related, RelatedRole};
use crate::xml::{Attribute, XmlElement};

/// Name of the value element in a data file.
pub(crate) const VALUE: &str = "Value";

/// Collects a file's problems.
pub(crate) struct FileCheck<'db> {
    file: File,
    items: &'db Items,
    /// Memory of the declared variables so far, in bytes.
    bytes: u64,
    pub(crate) problems: Vec<Problem>,
}

impl<'db> FileCheck<'db> {
    /// Creates the check of a file in `project`, with the problems of reading the file.
    pub(crate) fn new(db: &'db dyn Db, project: Project, file: File, items: &'db Items) -> Self {
        let mut check = Self { file, items, bytes: 0, problems: Vec::new() };
        match file.status(db) {
            FileStatus::Unreadable(reason) => check.problems.push(unreadable(db, project, file, reason)),
            FileStatus::Read { encoding, mismatch } => {
                if let Some((fault, range)) = encoding_fault(file.text(db), *encoding, *mismatch) {
                    check.report(range, ProblemKind::Encoding(fault));
                }
            }
        }
        check
    }

    pub(crate) fn report(&mut self, range: TextRange, kind: ProblemKind) {
        self.problems.push(Problem { kind, place: FileRange { file: self.file, range }, related: Vec::new() });
    }

    /// Reports the repetition of an equal declaration.
    pub(crate) fn report_again(&mut self, range: TextRange, kind: ProblemKind, first: Option<FileRange>) {
        let related = first.into_iter().map(|place| Related { place, role: RelatedRole::First }).collect();
        self.problems.push(Problem { kind, place: FileRange { file: self.file, range }, related });
    }

    /// Reports an element that must not appear in `parent`.
    pub(crate) fn unexpected(&mut self, element: XmlElement<'_>, parent: XmlElement<'_>) {
        let kind = ProblemKind::UnexpectedElement { name: element.name().into(), parent: parent.name().into() };
        self.report(element.name_range(), kind);
    }

    /// Reports an element that is missing in `parent`.
    pub(crate) fn missing_element(&mut self, parent: XmlElement<'_>, element: &'static str) {
        let kind = ProblemKind::MissingElement { parent: parent.name().into(), element: SmolStr::new_static(element) };
        self.report(parent.name_range(), kind);
    }

    /// Checks the namespaces and attributes of `root` and all elements in it.
    pub(crate) fn elements(&mut self, file: FileKind, root: XmlElement<'_>) {
        let mut rest = vec![root];
        while let Some(element) = rest.pop() {
            let known = files::find(file, element.name());
            if let Some(known) = known {
                self.namespace(element, known);
                // The attributes of a value depend on its type.
                if element.name() != VALUE {
                    self.attributes(element, known.attributes);
                }
            }
            // Misplaced elements are reported by other checks.
            let children = known.map_or(&[][..], |known| known.children);
            let inner = element.elements().filter(|inner| children.is_empty() || children.contains(&inner.name()));
            let inner: Vec<XmlElement<'_>> = inner.collect();
            rest.extend(inner.into_iter().rev());
        }
    }

    fn namespace(&mut self, element: XmlElement<'_>, known: &files::ElementPage) {
        let (Some(expected), Some(found)) = (known.namespace, element.attribute("xmlns")) else { return };
        if found.text().trim() != expected {
            let kind = ProblemKind::Namespace {
                element: element.name().into(),
                found: found.text().as_ref().into(),
                expected: SmolStr::new_static(expected),
            };
            self.report(found.range, kind);
        }
    }

    /// Checks that the attributes of `element` are `known`, and that no required attribute is missing.
    pub(crate) fn attributes(&mut self, element: XmlElement<'_>, known: &[files::AttributePage]) {
        for (found, near) in self.unknown_attributes(element, known, &[]) {
            let kind =
                ProblemKind::UnknownAttribute { element: element.name().into(), attribute: found.name.into(), near };
            self.report(found.name_range, kind);
        }
    }

    /// Reports missing `known` attributes. Returns the attributes that are neither in `known` nor in `others`, each
    /// with the most similar attribute that the element does not have.
    pub(crate) fn unknown_attributes<'g>(
        &mut self,
        element: XmlElement<'g>,
        known: &[files::AttributePage],
        others: &[&'static str],
    ) -> Vec<(Attribute<'g>, Option<SmolStr>)> {
        let names = || known.iter().map(|attribute| attribute.name).chain(others.iter().copied());
        let mut unknown: Vec<Attribute<'g>> =
            attributes::unknown(element, |name| names().any(|known| known == name)).collect();
        for attribute in attributes::left_out(element, known) {
            let resembles = |found: &Attribute<'_>| nearest(found.name, std::iter::once(attribute.name)).is_some();
            let written = unknown.iter().position(resembles).map(|place| unknown.remove(place));
            self.missing(element, attribute, written);
        }
        let unknown = unknown.into_iter().map(|found| {
            let absent = names().filter(|name| element.attribute(name).is_none());
            (found, nearest(found.name, absent).map(SmolStr::from))
        });
        unknown.collect()
    }

    fn missing(&mut self, element: XmlElement<'_>, attribute: &files::AttributePage, written: Option<Attribute<'_>>) {
        let default = match attribute.presence {
            Presence::Required => None,
            Presence::Expected(default) | Presence::Optional(default) => Some(SmolStr::new_static(default)),
        };
        let kind = ProblemKind::MissingAttribute {
            element: element.name().into(),
            attribute: SmolStr::new_static(attribute.name),
            default,
            written: written.map(|found| found.name.into()),
        };
        self.report(written.map_or(element.name_range(), |found| found.name_range), kind);
    }

    /// Checks that the value of the attribute, if present, is one of `values`.
    pub(crate) fn one_of(&mut self, element: XmlElement<'_>, attribute: &str, values: &[&str]) {
        if let Some(found) = element.attribute(attribute)
            && !values.contains(&found.text().trim())
        {
            let quoted: Vec<SmolStr> = values.iter().map(|value| format_smolstr!("`{value}`")).collect();
            self.invalid(element, found, alternatives(&quoted));
        }
    }

    /// Reports an attribute whose value is not `expected`.
    pub(crate) fn invalid(&mut self, element: XmlElement<'_>, found: Attribute<'_>, expected: SmolStr) {
        let kind = ProblemKind::InvalidAttribute {
            element: element.name().into(),
            attribute: found.name.into(),
            value: found.text().as_ref().into(),
            expected,
        };
        self.report(found.range, kind);
    }

    /// Checks an array's `size`. Returns whether it is valid.
    pub(crate) fn size(&mut self, element: XmlElement<'_>) -> bool {
        let Some(found) = element.attribute("size") else { return true };
        let sound = sizes(&found.text()).is_some_and(|sizes| !sizes.contains(&0));
        if !sound {
            self.report(found.range, ProblemKind::InvalidSize { size: found.text().as_ref().into() });
        }
        sound
    }

    /// Checks a declared name: its characters, its length, and that it is no keyword or built-in type. Returns whether
    /// it is valid.
    pub(crate) fn name(&mut self, attribute: Attribute<'_>, what: NameKind) -> bool {
        let before = self.problems.len();
        let name = SmolStr::from(attribute.text());
        let limit = self.items.version.identifier_limit();
        if !keywords::is_identifier(&name) {
            self.report(attribute.range, ProblemKind::InvalidName { name });
        } else if keywords::canonical(&name).is_some()
            || what == NameKind::Type && BaseType::from_file_name(&name).is_some()
        {
            self.report(attribute.range, ProblemKind::ReservedName { name });
        } else if let Some(limit) = limit.filter(|limit| name.len() > *limit) {
            self.report(attribute.range, ProblemKind::NameTooLong { name, limit });
        }
        self.problems.len() == before
    }

    /// Checks that no other declaration in this scope has the name.
    pub(crate) fn once(&mut self, found: Attribute<'_>, what: NameKind, seen: &mut FxHashMap<String, TextRange>) {
        let name = found.text().into_owned();
        let kind = ProblemKind::DuplicateName { name: name.as_str().into(), what };
        match seen.get(&name) {
            Some(first) => self.report_again(found.range, kind, Some(FileRange { file: self.file, range: *first })),
            None => {
                seen.insert(name, found.range);
            }
        }
    }

    /// Checks that the type is built in or a user type of the project.
    pub(crate) fn ty(&mut self, attribute: Attribute<'_>) {
        let name = attribute.text();
        if resolve_type(&self.items.types, &name).is_none() && !self.items.incomplete {
            let built_in = BaseType::DECLARABLE.iter().map(|base| base.name());
            let near = nearest(&name, self.items.types.keys().map(SmolStr::as_str).chain(built_in)).map(SmolStr::from);
            self.report(attribute.range, ProblemKind::UnknownType { name: name.as_ref().into(), near });
        }
    }
}

/// Creates the problem of an unreadable file, at the file's entry in the project file, or else at the beginning of the
/// file.
fn unreadable(db: &dyn Db, project: Project, file: File, reason: &str) -> Problem {
    let entry = file_entry(db, project, file);
    let path =
        entry.as_ref().map_or_else(|| file.path(db).file_name().unwrap_or_default().into(), |entry| entry.path.clone());
    let place = match entry {
        Some(entry) => FileRange { file: project.manifest(db), range: entry.range },
        None => FileRange { file, range: TextRange::default() },
    };
    Problem { kind: ProblemKind::FileUnreadable { path, reason: reason.into() }, place, related: Vec::new() }
}

/// `a, b or c`
pub(crate) fn alternatives(names: &[SmolStr]) -> SmolStr {
    match names.split_last() {
        Some((last, rest)) if !rest.is_empty() => format_smolstr!("{} or {last}", rest.join(", ")),
        _ => names.concat().into(),
    }
}

/// Returns the encoding fault of a file, and the first range that shows it.
fn encoding_fault(text: &str, encoding: Encoding, mismatch: Option<Mismatch>) -> Option<(EncodingFault, TextRange)> {
    if let Some(at) = text.find(REPLACEMENT) {
        let start = text_size(at);
        // No byte of ISO-8859-1 or Windows-1252 decodes to this character, so an editor has written it.
        let is_misread = encoding != Encoding::Utf8 && mismatch != Some(Mismatch::StoredAsUtf8);
        let fault = if is_misread { EncodingFault::Misread(encoding) } else { EncodingFault::Lost };
        return Some((fault, TextRange::at(start, TextSize::of(REPLACEMENT))));
    }
    let fault = match mismatch? {
        Mismatch::NotUtf8 => EncodingFault::NotUtf8,
        Mismatch::StoredAsUtf8 => EncodingFault::StoredAsUtf8(encoding),
        Mismatch::Unsupported => EncodingFault::Unsupported(encoding),
    };
    Some((fault, first_foreign(text)))
}

/// Returns the range of the first non-ASCII character; an empty range if all characters are ASCII.
fn first_foreign(text: &str) -> TextRange {
    let found = text.char_indices().find(|(_, character)| !character.is_ascii());
    found.map_or_else(TextRange::default, |(at, character)| {
        TextRange::at(u32::try_from(at).unwrap_or(u32::MAX).into(), TextSize::of(character))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_are_written_as_a_sentence() {
        assert_eq!(alternatives(&[]), "");
        assert_eq!(alternatives(&["a".into()]), "a");
        assert_eq!(alternatives(&["a".into(), "b".into(), "c".into()]), "a, b or c");
    }

    #[test]
    fn encoding_faults_are_found() {
        let fault = |text: &str, encoding, mismatch| encoding_fault(text, encoding, mismatch).map(|(fault, _)| fault);
        assert_eq!(fault("café", Encoding::Utf8, None), None);
        assert_eq!(fault("caf\u{fffd}", Encoding::Utf8, None), Some(EncodingFault::Lost));
        assert_eq!(fault("caf\u{fffd}", Encoding::Latin1, None), Some(EncodingFault::Misread(Encoding::Latin1)));
        assert_eq!(
            fault("caf\u{fffd}", Encoding::Latin1, Some(Mismatch::NotUtf8)),
            Some(EncodingFault::Misread(Encoding::Latin1))
        );
        assert_eq!(fault("caf\u{fffd}", Encoding::Latin1, Some(Mismatch::StoredAsUtf8)), Some(EncodingFault::Lost));
        assert_eq!(fault("café", Encoding::Latin1, None), None);
        assert_eq!(
            fault("café", Encoding::Utf8, Some(Mismatch::Unsupported)),
            Some(EncodingFault::Unsupported(Encoding::Utf8))
        );
        assert_eq!(fault("café", Encoding::Latin1, Some(Mismatch::NotUtf8)), Some(EncodingFault::NotUtf8));
        assert_eq!(
            fault("cafÃ©", Encoding::Latin1, Some(Mismatch::StoredAsUtf8)),
            Some(EncodingFault::StoredAsUtf8(Encoding::Latin1))
        );
    }

    #[test]
    fn the_first_character_beyond_ascii_is_reported() {
        assert_eq!(first_foreign("abé"), TextRange::new(2.into(), 4.into()));
        assert!(first_foreign("ab").is_empty());
    }
}
