//! One program of both trees.

use std::collections::BTreeSet;

use smol_str::SmolStr;

use super::text;
use crate::applications::SourceFile;
use crate::model::{Change, CodeChange, CodeKind, LineKind, Pair, ProgramChange, VariableChange};
use crate::read::code::Code;
use crate::read::program::{Program, access};

/// A program with its file.
pub(super) type Located<'a, 't> = (&'a SourceFile<'t>, &'a Program);

/// Compares a program; `None` if nothing differs or there is none. `lists` says of each side whether its project file can
/// be read, so that it counts whether a program is listed.
pub(super) fn compare([old, new]: [Option<Located<'_, '_>>; 2], lists: bool) -> Option<ProgramChange> {
    let (file, shown) = new.or(old)?;
    let change = Change::of(old.is_some(), new.is_some());
    let public = Pair { old: is_public(old), new: is_public(new) };
    let mut compared = ProgramChange {
        name: shown.header.name.to_string(),
        file: file.path.to_string(),
        change,
        signature: shown.signature(),
        signatures: None,
        access: None,
        listed: None,
        public,
        locals: Vec::new(),
        code: code(old.map(|(_, program)| program), new.map(|(_, program)| program)),
        description_changed: false,
    };
    let (Some((old_file, old)), Some((new_file, new))) = (old, new) else { return Some(compared) };
    compared.signatures = Pair::differing(old.signature(), new.signature());
    compared.access = Pair::differing(old.access(), new.access());
    compared.listed = Pair::differing(old_file.listed, new_file.listed).filter(|_| lists);
    compared.locals = locals(old, new);
    compared.description_changed = old.description != new.description;
    (!is_same(&compared)).then_some(compared)
}

fn is_public(located: Option<Located<'_, '_>>) -> bool {
    located.is_some_and(|(_, program)| program.access() == access(true))
}

fn is_same(change: &ProgramChange) -> bool {
    change.code.kind == CodeKind::Same
        && change.signatures.is_none()
        && change.access.is_none()
        && change.listed.is_none()
        && change.locals.is_empty()
        && !change.description_changed
}

fn code(old: Option<&Program>, new: Option<&Program>) -> CodeChange {
    let has_errors = |program: Option<&Program>| program.is_some_and(|program| program.has_errors);
    let syntax_errors = Pair { old: has_errors(old), new: has_errors(new) };
    let lines = |program: Option<&Program>| program.map_or(0, |program| program.code.text.lines().count());
    let (Some(old_program), Some(new_program)) = (old, new) else {
        return CodeChange {
            kind: CodeKind::Code,
            added: lines(new),
            removed: lines(old),
            hunks: Vec::new(),
            syntax_errors,
        };
    };
    let hunks = text::hunks(&old_program.code.text, &new_program.code.text);
    let kind = if hunks.is_empty() { CodeKind::Same } else { kind(&old_program.code, &new_program.code) };
    let (added, removed) = (text::count(&hunks, LineKind::Added), text::count(&hunks, LineKind::Removed));
    CodeChange { kind, added, removed, hunks, syntax_errors }
}

fn kind(old: &Code, new: &Code) -> CodeKind {
    match (old.same_statements(new), old.same_comments(new)) {
        (false, _) => CodeKind::Code,
        (true, false) => CodeKind::Comments,
        (true, true) => CodeKind::Layout,
    }
}

fn locals(old: &Program, new: &Program) -> Vec<VariableChange> {
    let named =
        |program: &Program, name: &SmolStr| program.locals().find(|(known, _)| *known == name).map(|(_, shown)| shown);
    let names: BTreeSet<&SmolStr> = old.locals().chain(new.locals()).map(|(name, _)| name).collect();
    let changes = names.into_iter().map(|name| (name, named(old, name), named(new, name)));
    let differing = changes.filter(|(_, old, new)| old != new);
    let change = |(name, old, new): (&SmolStr, Option<String>, Option<String>)| VariableChange {
        name: name.to_string(),
        change: Change::of(old.is_some(), new.is_some()),
        old,
        new,
    };
    differing.map(change).collect()
}
