//! Checks of a program's header: names, types, attributes, and required elements.

use rustc_hash::{FxHashMap, FxHashSet};
use val3_lang::files::FileKind;
use val3_syntax::TextRange;

use crate::db::{Db, File, Project};
use crate::file_check::FileCheck;
use crate::items::project::items;
use crate::items::{parse, program};
use crate::problem::{FileRole, NameKind, Problem, ProblemKind};
use crate::xml::{self, Attribute, XmlElement};

/// Checks the file and the header of a program, and returns the problems.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project, file: File) -> Vec<Problem> {
    let mut check = FileCheck::new(db, project, file, items(db, project));
    let parse = parse(db, file);
    let view = parse.view();
    if let Some(root) = xml::root(view) {
        let stem = file.path(db).file_stem().unwrap_or("");
        self::root(&mut check, root, program::element(view), stem);
    }
    check.problems
}

fn root(check: &mut FileCheck<'_>, root: XmlElement<'_>, program: Option<XmlElement<'_>>, stem: &str) {
    if !matches!(root.name(), "Programs" | "programList") {
        let kind = ProblemKind::WrongRoot { expected: FileRole::Program, found: root.name().into() };
        return check.report(root.name_range(), kind);
    }
    check.elements(FileKind::Program, root);
    let Some(program) = program else { return missing_program(check, root) };
    if let Some(name) = program.attribute("name")
        && check.name(name, NameKind::Program)
    {
        file_name(check, name, stem);
    }
    check.one_of(program, "access", &["public", "private"]);
    check.one_of(program, "public", &["true", "false"]);
    let others = root.elements().filter(|element| element.name_range() != program.name_range());
    others.for_each(|element| check.unexpected(element, root));
    foreign_elements(check, program);
    missing_code(check, program);
    declarations(check, program);
}

/// Reports a missing program element. If the file has other elements, these are reported instead, because one may be
/// misspelt.
fn missing_program(check: &mut FileCheck<'_>, root: XmlElement<'_>) {
    let mut others = root.elements().peekable();
    if others.peek().is_none() {
        check.missing_element(root, if root.name() == "programList" { "program" } else { "Program" });
    }
    others.for_each(|element| check.unexpected(element, root));
}

/// Reports missing code, unless an unknown element may be a misspelt code element.
fn missing_code(check: &mut FileCheck<'_>, program: XmlElement<'_>) {
    let mut names = program.elements().map(XmlElement::name);
    if names.any(|name| matches!(name, "Code" | "source") || !program::LISTS.iter().any(|(list, _)| *list == name)) {
        if let Some(source) = program.child(&["source"]).filter(|source| source.elements().next().is_none()) {
            check.missing_element(source, "code");
        }
    } else {
        check.missing_element(program, if program.name() == "program" { "source" } else { "Code" });
    }
}

/// Checks that the program has its file's name, in any letter case.
fn file_name(check: &mut FileCheck<'_>, name: Attribute<'_>, stem: &str) {
    let program = name.text();
    if !program.eq_ignore_ascii_case(stem) {
        let kind = ProblemKind::ProgramNameMismatch { program: program.as_ref().into(), file: stem.into() };
        check.report(name.range, kind);
    }
}

fn foreign_elements(check: &mut FileCheck<'_>, program: XmlElement<'_>) {
    let mut seen = FxHashSet::default();
    for list in program.elements() {
        if !seen.insert(list.name()) {
            check.unexpected(list, program);
            continue;
        }
        match program::LISTS.iter().find(|(name, _)| *name == list.name()) {
            None => check.unexpected(list, program),
            Some((_, Some(item))) => {
                list.elements().filter(|inner| inner.name() != *item).for_each(|inner| check.unexpected(inner, list));
            }
            Some((_, None)) => {}
        }
    }
}

fn declarations(check: &mut FileCheck<'_>, program: XmlElement<'_>) {
    let mut seen = FxHashMap::default();
    for param in program::params(program) {
        declaration(check, param, NameKind::Parameter, &mut seen);
        check.one_of(param, "xsi:type", &["element", "array", "collection"]);
        // A container is never passed by value (2.6).
        let is_container =
            param.attribute("xsi:type").is_some_and(|kind| matches!(kind.text().trim(), "array" | "collection"));
        check.one_of(param, "use", if is_container { &["reference"] } else { &["value", "reference"] });
        check.one_of(param, "byVal", &["true", "false"]);
        check.one_of(param, "dimensions", &["1", "2", "3"]);
    }
    for local in program::locals(program) {
        declaration(check, local, NameKind::Local, &mut seen);
        check.one_of(local, "xsi:type", &["element", "array", "collection"]);
        check.size(local);
        check.memory(local);
    }
}

fn declaration(
    check: &mut FileCheck<'_>,
    element: XmlElement<'_>,
    what: NameKind,
    seen: &mut FxHashMap<String, TextRange>,
) {
    let Some(name) = element.attribute("name") else { return };
    check.name(name, what);
    check.once(name, what, seen);
    if let Some(ty) = element.attribute("type") {
        check.ty(ty);
    }
}
