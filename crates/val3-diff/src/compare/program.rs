//! Comparison of a program.

use std::collections::BTreeSet;

use smol_str::SmolStr;

use super::text;
use crate::applications::SourceFile;
use crate::exclusions::BlankComparison;
use crate::model::{Change, CodeChange, CodeKind, LineKind, ProgramChange, ValuePair, VariableChange};
use crate::read::code::{ProgramCode, Renames};
use crate::read::program::{ProgramVersion, access};

/// A program with its file.
pub(super) type Located<'a, 't> = (&'a SourceFile<'t>, &'a ProgramVersion);

/// Options for comparing programs.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rules<'r> {
    /// Whether both project files are readable, so that listing of programs is compared.
    pub(super) has_lists: bool,
    pub(super) layout: BlankComparison,
    /// New names of programs and data.
    pub(super) renames: &'r Renames,
}

/// Compares a program; `None` if there is no difference or no program.
pub(super) fn compare([old, new]: [Option<Located<'_, '_>>; 2], rules: Rules<'_>) -> Option<ProgramChange> {
    let (file, shown) = new.or(old)?;
    let change = Change::of(old.is_some(), new.is_some());
    let public = ValuePair { old: is_public(old), new: is_public(new) };
    let mut compared = ProgramChange {
        name: shown.header.name.to_string(),
        renamed_from: None,
        file: file.path.to_string(),
        change,
        signature: shown.signature(),
        signatures: None,
        access: None,
        listed: None,
        public,
        locals: Vec::new(),
        code: code(old.map(|(_, program)| program), new.map(|(_, program)| program), rules),
        description_changed: false,
    };
    let (Some((old_file, old)), Some((new_file, new))) = (old, new) else { return Some(compared) };
    let renamed = rules.renames.get(old.header.name.as_str()).is_some_and(|name| *name == new.header.name);
    compared.renamed_from = renamed.then(|| old.header.name.to_string());
    let is_same = old.parameters() == new.parameters() && (renamed || old.header.name == new.header.name);
    compared.signatures = (!is_same).then(|| ValuePair { old: old.signature(), new: new.signature() });
    compared.access = ValuePair::differing(old.access(), new.access());
    compared.listed = ValuePair::differing(old_file.listed, new_file.listed).filter(|_| rules.has_lists);
    compared.locals = locals(old, new);
    compared.description_changed = old.description != new.description;
    (!compared.is_same()).then_some(compared)
}

fn is_public(located: Option<Located<'_, '_>>) -> bool {
    located.is_some_and(|(_, program)| program.access() == access(true))
}

fn code(old: Option<&ProgramVersion>, new: Option<&ProgramVersion>, rules: Rules<'_>) -> CodeChange {
    let has_errors = |program: Option<&ProgramVersion>| program.is_some_and(|program| program.has_errors);
    let syntax_errors = ValuePair { old: has_errors(old), new: has_errors(new) };
    let lines = |program: Option<&ProgramVersion>| program.map_or(0, |program| program.code.lines().len());
    let (Some(old_program), Some(new_program)) = (old, new) else {
        return CodeChange {
            kind: CodeKind::Code,
            added: lines(new),
            removed: lines(old),
            hunks: Vec::new(),
            syntax_errors,
        };
    };
    let (old_code, new_code) = (&old_program.code, &new_program.code);
    let renames = names_of(old_program, new_program, rules.renames);
    let kind = kind(old_code, new_code, &renames);
    let none = Renames::new();
    let hunks = text::hunks_of(&lines_of(old_code, rules.layout, &renames), &lines_of(new_code, rules.layout, &none));
    let (added, removed) = (text::count(&hunks, LineKind::Added), text::count(&hunks, LineKind::Removed));
    CodeChange { kind, added, removed, hunks, syntax_errors }
}

/// Returns the renames without names of parameters and local variables.
fn names_of(old: &ProgramVersion, new: &ProgramVersion, renames: &Renames) -> Renames {
    let global = renames.iter().filter(|(before, after)| !old.has_local(before) && !new.has_local(after));
    global.map(|(before, after)| (before.clone(), after.clone())).collect()
}

/// Returns the lines of the code, without blank lines if layout is ignored.
fn lines_of(code: &ProgramCode, layout: BlankComparison, renames: &Renames) -> Vec<text::VersionLine> {
    let lines = (1..).zip(code.lines());
    let lines = lines.map(|(number, line)| text::VersionLine {
        number,
        text: line.text.clone(),
        key: line.key(layout, renames),
    });
    lines.filter(|line| layout == BlankComparison::Compared || !line.key.is_empty()).collect()
}

fn kind(old: &ProgramCode, new: &ProgramCode, renames: &Renames) -> CodeKind {
    if old.lines() == new.lines() {
        return CodeKind::Same;
    }
    match (old.same_statements(new, &Renames::new()), old.same_comments(new)) {
        (false, _) if old.same_statements(new, renames) => CodeKind::Renames,
        (false, _) => CodeKind::Code,
        (true, false) => CodeKind::Comments,
        (true, true) => CodeKind::Layout,
    }
}

fn locals(old: &ProgramVersion, new: &ProgramVersion) -> Vec<VariableChange> {
    let names: BTreeSet<&SmolStr> = old.locals().chain(new.locals()).map(|(name, _)| name).collect();
    let mut changes = Vec::new();
    for name in names {
        let [old, new] = [old, new].map(|program| declaration_of(program, name));
        if old != new {
            let change = Change::of(old.is_some(), new.is_some());
            changes.push(VariableChange { name: name.to_string(), change, old, new });
        }
    }
    changes
}

fn declaration_of(program: &ProgramVersion, local: &SmolStr) -> Option<String> {
    program.locals().find(|(name, _)| *name == local).map(|(_, declaration)| declaration)
}
