//! Completions in code.

use val3_analysis::items::program::header;
use val3_analysis::items::project::{Items, fields, items, resolve_type};
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::{Base, brackets};
use val3_lang::instruction::{Class, Instruction};
use val3_lang::types;
use val3_lang::{builtins, enumerations, instructions};

use super::{CompletionKind as Kind, Found, literals};
use crate::hover::program_line;

/// What a value of the expected type gains.
const FITS: i32 = 60;
/// What names of the program gain over those of the language.
const OWN: i32 = 20;

/// Blocks to fill in, as snippets; the editor indents what follows the first line.
const BLOCKS: [(&str, &str); 8] = [
    ("if", "if ${1:condition}\n  $0\nendIf"),
    ("while", "while ${1:condition}\n  $0\nendWhile"),
    ("for", "for ${1:l_i}=${2:0} to ${3:size}-1\n  $0\nendFor"),
    ("do", "do\n  $0\nuntil ${1:condition}"),
    ("switch", "switch ${1:value}\n  case ${2:0}\n    $0\n  break\nendSwitch"),
    ("case", "case ${1:value}\n  $0\nbreak"),
    ("taskCreate", "taskCreate \"${1:name}\",${2:10},${3:program}($4)"),
    ("taskCreateSync", "taskCreateSync \"${1:name}\",${2:0.004},${3:bOverrun},${4:program}($5)"),
];

const WORDS: [&str; 6] = ["call", "return", "else", "elseIf", "default", "?"];

/// The start of a line.
pub(super) fn statement(found: &mut Found<'_>, closing: Option<&'static str>) {
    if let Some(closing) = closing {
        found.add(closing, Kind::Keyword, "ends the block").scored(FITS);
    }
    for (word, block) in BLOCKS {
        found.add(word, Kind::Keyword, "").snippet(block).scored(OWN);
    }
    for word in WORDS {
        found.add(word, Kind::Keyword, "").scored(OWN);
    }
    variables(found, None);
    libraries(found);
    instructions_of(found, None, |instruction| {
        instruction.overloads.iter().any(|form| form.class == Class::Modifier && !form.on_library)
    });
}

/// A value.
pub(super) fn expression(found: &mut Found<'_>, expected: Option<Base>) {
    variables(found, expected);
    constants(found, expected);
    libraries(found);
    literals::literals(found, expected);
    instructions_of(found, expected, |instruction| {
        instruction.overloads.iter().any(|form| form.result.is_some() && !form.on_library)
    });
    for word in ["and", "or", "xor", "to", "step"] {
        found.add(word, Kind::Keyword, "").scored(-FITS);
    }
}

fn fit(expected: Option<Base>, base: Base) -> i32 {
    match expected {
        Some(expected) if expected != Base::Unknown && base.same_as(expected) => FITS,
        _ => 0,
    }
}

fn variables(found: &mut Found<'_>, expected: Option<Base>) {
    let (db, project, file) = (found.db, found.project, found.file);
    let (items, header) = (items(db, project), header(db, file));
    let base = |name: &str| resolve_type(&items.types, name).unwrap_or(Base::Unknown);
    for local in &header.locals {
        let detail = format!("{}{}", local.type_name, if local.sizes == [1] { "" } else { brackets(local.container) });
        let score = fit(expected, base(&local.type_name)) + OWN + 4;
        found.add(local.name.as_str(), Kind::Local, detail).scored(score).of(Symbol::Local(file, local.name.clone()));
    }
    for param in &header.params {
        let detail = format!("{}{}", param.type_name, brackets(param.container));
        let score = fit(expected, base(&param.type_name)) + OWN + 4;
        found
            .add(param.name.as_str(), Kind::Parameter, detail)
            .scored(score)
            .of(Symbol::Param(file, param.name.clone()));
    }
    data(found, items, expected);
}

fn data(found: &mut Found<'_>, items: &Items, expected: Option<Base>) {
    let project = found.project;
    for (name, item) in &items.data {
        let detail = format!(
            "{}{}",
            item.decl.type_name,
            if item.decl.sizes == [1] { "" } else { brackets(item.decl.container) }
        );
        let score = fit(expected, item.base) + OWN;
        found.add(name.as_str(), Kind::Data, detail).scored(score).of(Symbol::Data(project, name.clone()));
    }
}

fn constants(found: &mut Found<'_>, expected: Option<Base>) {
    for builtin in &builtins::BUILTINS {
        let score = fit(expected, Base::of(builtin.ty));
        found
            .add(builtin.name, Kind::Constant, builtin.ty.name())
            .scored(score)
            .of(Symbol::Builtin(builtin.name.into()));
    }
    for enumerator in &enumerations::ENUMERATORS {
        let score = fit(expected, Base::of(enumerator.ty));
        // Enumerators mean something only where their type is asked for.
        if score > 0 {
            let symbol = Symbol::Enumerator(enumerator.name.into());
            found.add(enumerator.name, Kind::Constant, enumerator.ty.name()).scored(score + OWN).of(symbol);
        }
    }
    let truth = fit(expected, Base::of(types::BaseType::Bool));
    for word in ["true", "false"] {
        found.add(word, Kind::Constant, "bool").scored(truth);
    }
}

fn libraries(found: &mut Found<'_>) {
    let project = found.project;
    for name in items(found.db, project).libraries.keys() {
        found.add(name.as_str(), Kind::Library, "library").scored(OWN).of(Symbol::Library(project, name.clone()));
    }
}

fn instructions_of(found: &mut Found<'_>, expected: Option<Base>, suits: impl Fn(&Instruction) -> bool) {
    for instruction in instructions::all().iter().filter(|instruction| suits(instruction)) {
        let results = instruction.overloads.iter().filter_map(|form| form.result);
        let score = results.map(|ty| fit(expected, Base::of(ty)) / 2).max().unwrap_or(0);
        let detail = instruction.signatures().into_iter().next().unwrap_or_default();
        let symbol = Symbol::Instruction(instruction.name.into());
        found.add(instruction.name, Kind::Instruction, detail).scored(score).snippet(call(instruction)).of(symbol);
    }
}

/// A call with its parameters to fill in.
fn call(instruction: &Instruction) -> String {
    let name = instruction.name.replace('$', "\\$");
    let Some(form) = instruction.overloads.first() else { return name };
    let params: Vec<String> =
        form.params.iter().enumerate().map(|(index, param)| format!("${{{}:{}}}", index + 1, param.name)).collect();
    format!("{name}({})$0", params.join(","))
}

/// Behind a dot.
pub(super) fn members(found: &mut Found<'_>, base: Base) {
    match base {
        Base::Builtin(ty, arm) => {
            let arm = arm.or(items(found.db, found.project).arm);
            for field in types::fields(ty, arm) {
                let symbol = Symbol::Field(ty, field.name.into());
                found.add(field.name, Kind::Field, field.ty.name()).of(symbol);
            }
        }
        Base::User(project) => {
            for (name, item) in fields(found.db, project) {
                found
                    .add(name.as_str(), Kind::Field, item.decl.type_name.as_str())
                    .of(Symbol::Data(project, name.clone()));
            }
        }
        Base::Unknown => {}
    }
}

/// Behind the colon of a library identifier.
pub(super) fn library_items(found: &mut Found<'_>, library: &str, programs_only: bool) {
    let db = found.db;
    let Some(library) = items(db, found.project).libraries.get(library) else { return };
    if let Some(interface) = library.interface {
        let offered = items(db, interface);
        if !programs_only {
            for (name, item) in offered.data.iter().filter(|(_, item)| item.decl.public) {
                let symbol = Symbol::Data(interface, name.clone());
                found.add(name.as_str(), Kind::Data, item.decl.type_name.as_str()).scored(OWN).of(symbol);
            }
        }
        for (name, file) in offered.programs.iter().filter(|(_, file)| programs_only && header(db, **file).public) {
            let symbol = Symbol::Program(interface, name.clone());
            let detail = program_line(db, interface, *file);
            found.add(name.as_str(), Kind::Program, detail).scored(OWN).of(symbol).snippet(format!("{name}($1)$0"));
        }
    }
    if !programs_only {
        instructions_on_library(found);
    }
}

fn instructions_on_library(found: &mut Found<'_>) {
    for instruction in instructions::all() {
        let Some(form) = instruction.overloads.iter().find(|form| form.on_library) else { continue };
        let symbol = Symbol::Instruction(instruction.name.into());
        let detail = form.signature(instruction.name);
        let name = instruction.name.replace('$', "\\$");
        found.add(instruction.name, Kind::Instruction, detail).of(symbol).snippet(format!("{name}($1)$0"));
    }
}

/// Behind `call`.
pub(super) fn programs(found: &mut Found<'_>) {
    let (db, project) = (found.db, found.project);
    for (name, file) in &items(db, project).programs {
        let symbol = Symbol::Program(project, name.clone());
        let detail = program_line(db, project, *file);
        found.add(name.as_str(), Kind::Program, detail).scored(OWN).of(symbol).snippet(format!("{name}($1)$0"));
    }
    libraries(found);
}
