//! Checks that every declaration shares: the name itself, its type, doubles, and how a file was read.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_lang::keywords;
use val3_lang::types::BaseType;
use val3_syntax::TextRange;

use crate::db::{Db, File, FileStatus};
use crate::items::project::{Items, resolve_type};
use crate::near::nearest;
use crate::problem::{NameKind, Place, Problem, ProblemKind, Related, Role};
use crate::xml::{Attribute, Element};

/// Collects what is wrong with the declarations of one file.
pub(crate) struct NameCheck<'db> {
    file: File,
    items: &'db Items,
    pub(crate) problems: Vec<Problem>,
}

impl<'db> NameCheck<'db> {
    pub(crate) fn new(file: File, items: &'db Items) -> Self {
        Self { file, items, problems: Vec::new() }
    }

    pub(crate) fn report(&mut self, range: TextRange, kind: ProblemKind) {
        self.problems.push(problem(self.file, range, kind));
    }

    /// A declared name: its characters, its length, and no word of the language.
    pub(crate) fn name(&mut self, attribute: Attribute<'_>, what: NameKind) {
        let name = SmolStr::from(attribute.text());
        let limit = self.items.version.identifier_limit();
        if !is_identifier(&name) {
            self.report(attribute.range, ProblemKind::InvalidName { name });
        } else if keywords::canonical(&name).is_some() && what != NameKind::Library {
            self.report(attribute.range, ProblemKind::ReservedName { name });
        } else if let Some(limit) = limit.filter(|limit| name.len() > *limit) {
            self.report(attribute.range, ProblemKind::NameTooLong { name, limit });
        }
    }

    /// No other declaration of this scope has the name.
    pub(crate) fn once<'g>(
        &mut self,
        attribute: Attribute<'g>,
        what: NameKind,
        seen: &mut FxHashMap<String, Attribute<'g>>,
    ) {
        let name = attribute.text().into_owned();
        let Some(first) = seen.get(&name) else {
            seen.insert(name, attribute);
            return;
        };
        let place = Place { file: self.file, range: first.range };
        self.problems.push(Problem {
            kind: ProblemKind::DuplicateName { name: name.into(), what },
            place: Place { file: self.file, range: attribute.range },
            related: vec![Related { place, role: Role::First }],
        });
    }

    /// The type is built in or a user type of the project.
    pub(crate) fn ty(&mut self, attribute: Attribute<'_>) {
        let name = attribute.text();
        if resolve_type(&self.items.types, &name).is_none() {
            let built_in = BaseType::DECLARABLE.iter().map(|base| base.name());
            let near = nearest(&name, self.items.types.keys().map(SmolStr::as_str).chain(built_in));
            self.report(attribute.range, ProblemKind::UnknownType { name: name.as_ref().into(), near });
        }
    }
}

/// Letters, digits and underscores, no digit first (2.5.1).
fn is_identifier(name: &str) -> bool {
    let starts_well = name.starts_with(|first: char| first.is_ascii_alphabetic() || first == '_');
    starts_well && name.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
}

pub(crate) fn problem(file: File, range: TextRange, kind: ProblemKind) -> Problem {
    Problem { kind, place: Place { file, range }, related: Vec::new() }
}

/// An attribute with a value that is none of `values`.
pub(crate) fn invalid(file: File, element: Element<'_>, found: Attribute<'_>, values: &[&str]) -> Problem {
    let quoted: Vec<String> = values.iter().map(|value| format!("`{value}`")).collect();
    let expected = match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => quoted.concat(),
    };
    let kind = ProblemKind::InvalidAttribute {
        element: element.name().into(),
        attribute: found.name.into(),
        value: found.text().as_ref().into(),
        expected: expected.into(),
    };
    problem(file, found.range, kind)
}

/// The bytes of a file are not in the encoding it declares.
pub(crate) fn encoding(db: &dyn Db, file: File) -> Option<Problem> {
    let undeclared = matches!(file.status(db), FileStatus::Read { undeclared: true, .. });
    undeclared.then(|| {
        let text: &str = file.text(db);
        let at = text.find(|character: char| !character.is_ascii()).unwrap_or(0);
        let len = text.get(at..).and_then(|rest| rest.chars().next()).map_or(0, char::len_utf8);
        let offset = |at: usize| u32::try_from(at).unwrap_or(u32::MAX).into();
        problem(file, TextRange::new(offset(at), offset(at + len)), ProblemKind::Encoding)
    })
}
