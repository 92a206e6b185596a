//! Completions in code, by syntactic position.

use smol_str::SmolStr;
use val3_analysis::application::{ENTRY_POINTS, application};
use val3_analysis::db::{File, Project};
use val3_analysis::items::program::header;
use val3_analysis::items::project::{fields, items};
use val3_analysis::occurrences::Symbol;
use val3_analysis::test_applications::sees_private_items;
use val3_analysis::ty::Base;
use val3_lang::instruction::{ArgumentForm, CallClass, Family, Instruction, Overload};
use val3_lang::instructions;
use val3_lang::keywords::{KEYWORDS, is_task_creation};
use val3_lang::types::{self, BaseType, Container};

use super::context::{ExpectedItem, Operators};
use super::list::{AddedCompletion, CompletionKind as Kind, CompletionList};
use super::names::{FITS, OWN, constants, fit, libraries, variables};
use super::{literals, missing};
use crate::hover::program_line;
use crate::line::{Block, CodePart, Expected};

/// Score bonus of instructions that most programs use.
const COMMON: i32 = 8;
/// Score penalty of instructions that require an add-on or that the controller does not have.
const RARE: i32 = -40;

/// Snippets of blocks; the editor indents the lines after the first one.
const BLOCKS: [(&str, &str); 5] = [
    ("if", "if ${1:condition}\n  $0\nendIf"),
    ("while", "while ${1:condition}\n  $0\nendWhile"),
    ("for", "for ${1:l_nIndex}=${2:0} to ${3:nLast}\n  $0\nendFor"),
    ("do", "do\n  $0\nuntil ${1:condition}"),
    ("switch", "switch ${1:value}\n  case ${2:0}\n    $0\n  break\nendSwitch"),
];

const CASES: [(&str, &str); 2] = [("case", "case ${1:value}\n  $0\nbreak"), ("default", "default\n  $0\nbreak")];

/// Completions at the start of a line.
pub(super) fn statement(found: &mut CompletionList<'_>, blocks: &[Block], part: CodePart) {
    match (blocks.last(), part) {
        (_, CodePart::Empty { has_end }) => return begin(found, has_end),
        (Some(innermost), _) => continue_block(found, *innermost),
        (None, CodePart::Unended) => {
            found.add("end", Kind::Keyword).detail(|| "ends the program".to_owned()).scored(FITS);
        }
        (None, CodePart::Statements) => {}
    }
    for (word, block) in BLOCKS {
        found.add(word, Kind::Keyword).snippet(|| block.to_owned()).scored(OWN);
    }
    for keyword in KEYWORDS.into_iter().filter(|keyword| is_task_creation(keyword)) {
        found.add(keyword, Kind::Keyword).snippet(|| task_creation(keyword)).scored(OWN);
    }
    for word in ["call", "return"] {
        found.add(word, Kind::Keyword).scored(OWN);
    }
    variables(found, &Expected::anything());
    libraries(found);
    calls(found);
    instructions_of(found, &[], |form| form.class == CallClass::Modifier && !form.on_library);
    missing::global(found, &Expected::anything());
    missing::libraries(found);
    missing::library_data(found, &Expected::anything());
}

/// Completions at the start of a program. `begin` must come first; the snippet also adds a missing `end`.
fn begin(found: &mut CompletionList<'_>, has_end: bool) {
    let added = found.add("begin", Kind::Keyword).detail(|| "starts the program".to_owned());
    if !has_end {
        added.snippet(|| "begin\n  $0\nend".to_owned());
    }
}

/// Snippet that creates a task, with placeholders for the arguments, which have no parentheses.
fn task_creation(keyword: &str) -> String {
    let forms = instructions::find(keyword).map_or(&[][..], |instruction| instruction.overloads);
    let params = (1..).zip(forms.first().map_or(&[][..], |form| form.params));
    let places: Vec<String> = params
        .map(|(place, param)| match (param.shape, param.ty) {
            (ArgumentForm::ProgramCall, _) => format!("${{{place}:{}}}(${})", param.name, place + 1),
            (_, Some(BaseType::String)) => format!("\"${{{place}:{}}}\"", param.name),
            _ => format!("${{{place}:{}}}", param.name),
        })
        .collect();
    format!("{keyword} {}", places.join(","))
}

/// Keywords that end or continue the innermost block.
fn continue_block(found: &mut CompletionList<'_>, innermost: Block) {
    found.add(innermost.closing(), Kind::Keyword).detail(|| "ends the block".to_owned()).scored(FITS);
    match innermost {
        Block::If => {
            found.add("elseIf", Kind::Keyword).snippet(|| "elseIf ${1:condition}\n  $0".to_owned()).scored(OWN);
            found.add("else", Kind::Keyword).scored(OWN);
        }
        Block::Switch => {
            for (word, clause) in CASES {
                found.add(word, Kind::Keyword).snippet(|| clause.to_owned()).scored(FITS);
            }
        }
        _ => {}
    }
}

/// Completions where a value is expected.
pub(super) fn expression(found: &mut CompletionList<'_>, expected: &Expected) {
    variables(found, expected);
    libraries(found);
    if !expected.variable {
        constants(found, &expected.bases);
        literals::literals(found, &expected.bases);
        instructions_of(found, &expected.bases, |form| form.result.is_some() && !form.on_library);
    }
    missing::global(found, expected);
    missing::libraries(found);
    missing::library_data(found, expected);
}

/// Keywords that may follow a value.
pub(super) fn operators(found: &mut CompletionList<'_>, operators: Operators) {
    let words: &[&str] = match operators {
        Operators::To => &["to"],
        Operators::Step => &["step"],
        Operators::Logical => &["and", "or", "xor"],
    };
    for word in words {
        found.add(word, Kind::Keyword);
    }
}

fn instructions_of(found: &mut CompletionList<'_>, expected: &[Base], suits: impl Fn(&Overload) -> bool) {
    let version = items(found.db, found.project).version;
    let fit_of = |form: &&Overload| form.result.map_or(0, |ty| fit(expected, Base::of(ty)) / 2);
    // A Boolean value often results from comparing other values.
    let only_fitting = !expected.is_empty() && !expected.contains(&Base::of(BaseType::Bool)) && found.query.is_empty();
    for instruction in instructions::all().iter().filter(|instruction| !is_task_creation(instruction.name)) {
        let forms = instruction.overloads.iter().filter(|form| suits(form));
        // If several forms are equally suitable, the first one is used.
        let Some(form) = forms.rev().max_by_key(fit_of) else { continue };
        let prior = if !instruction.exists_in(version) {
            RARE
        } else if is_common(instruction.family) {
            COMMON
        } else {
            0
        };
        let score = fit_of(&form) + prior;
        if !only_fitting || fit_of(&form) > 0 {
            add_instruction(found, instruction, form).scored(score);
        }
    }
}

/// Whether programs of all kinds use the instructions, in contrast to those that configure a controller or an option.
fn is_common(family: Family) -> bool {
    !matches!(family, Family::Controller | Family::Options | Family::Additions | Family::AddOns)
}

fn add_instruction<'f>(
    found: &'f mut CompletionList<'_>,
    instruction: &'static Instruction,
    form: &Overload,
) -> AddedCompletion<'f> {
    let arguments = || form.params.iter().map(|param| param.name).collect();
    let added = found.add_call(instruction.name, Kind::Instruction, arguments);
    added.detail(|| form.signature(instruction.name)).of(|| Symbol::Instruction(instruction.name.into()))
}

/// Members after a dot, in declaration order.
pub(super) fn members(found: &mut CompletionList<'_>, base: Base) {
    match base {
        Base::Builtin(ty, arm) => {
            let arm = arm.or(items(found.db, found.project).arm);
            for (place, field) in (0..).zip(types::fields(ty, arm)) {
                let added = found.add(field.name, Kind::Field).detail(|| field.ty.name().to_owned());
                let added = added.variable(Base::of(field.ty), Container::Element, &[]);
                added.of(|| Symbol::Field(ty, field.name.into())).scored(-place);
            }
        }
        Base::User(project) => {
            for (name, item) in fields(found.db, project) {
                let added = found.add(name, Kind::Field).detail(|| super::names::data_detail(item)).data(item);
                added.of(|| Symbol::Data(project, name.clone()));
            }
        }
        Base::Unknown => {}
    }
}

/// Items after the colon of a library identifier.
pub(super) fn library_items(found: &mut CompletionList<'_>, library: &str, wanted: &ExpectedItem) {
    let db = found.db;
    let declared = items(db, found.project).libraries.get(library);
    let undeclared = if declared.is_none() { missing::library_called(found, library) } else { None };
    let interface = match (declared, &undeclared) {
        (Some(library), _) => library.interface,
        (None, called) => called.as_ref().map(|called| called.project),
    };
    let start = found.items.len();
    if let Some(interface) = interface {
        match wanted {
            ExpectedItem::Program => programs_of(found, interface),
            ExpectedItem::Statement => data_of(found, interface, &[]),
            ExpectedItem::Value(expected) => data_of(found, interface, &expected.bases),
        }
    }
    if let Some(called) = undeclared {
        missing::declare_library(found, start, library, &called);
    } else if declared.is_some() && *wanted != ExpectedItem::Program {
        on_library(found, wanted);
    }
}

fn data_of(found: &mut CompletionList<'_>, interface: Project, expected: &[Base]) {
    let private_too = sees_private_items(found.db, found.project);
    for (name, item) in items(found.db, interface).data.iter().filter(|(_, item)| item.decl.public || private_too) {
        let score = fit(expected, item.base) + OWN;
        let added = found.add(name, Kind::Data).detail(|| super::names::data_detail(item)).data(item);
        added.scored(score).of(|| Symbol::Data(interface, name.clone()));
    }
}

fn programs_of(found: &mut CompletionList<'_>, interface: Project) {
    let db = found.db;
    let private_too = sees_private_items(db, found.project);
    for (name, file) in
        items(db, interface).programs.iter().filter(|(_, file)| header(db, **file).public || private_too)
    {
        add_program(found, interface, name, *file);
    }
}

fn add_program<'f>(
    found: &'f mut CompletionList<'_>,
    project: Project,
    name: &SmolStr,
    file: File,
) -> AddedCompletion<'f> {
    let db = found.db;
    let arguments = || header(db, file).params.iter().map(|param| param.name.as_str()).collect();
    let added = found.add_call(name, Kind::Program, arguments).scored(OWN);
    added.detail(|| program_line(db, project, file)).of(|| Symbol::Program(project, name.clone()))
}

/// Instructions that are called on a library identifier.
fn on_library(found: &mut CompletionList<'_>, wanted: &ExpectedItem) {
    let expected: &[Base] = if let ExpectedItem::Value(expected) = wanted { &expected.bases } else { &[] };
    for instruction in instructions::all() {
        if let Some(form) = instruction.overloads.iter().find(|form| form.on_library && suits(form, wanted)) {
            let score = form.result.map_or(0, |ty| fit(expected, Base::of(ty)) / 2);
            add_instruction(found, instruction, form).scored(score);
        }
    }
}

/// Whether the form is a statement, or has a result where a value is expected.
fn suits(form: &Overload, wanted: &ExpectedItem) -> bool {
    match wanted {
        ExpectedItem::Statement => form.class == CallClass::Modifier,
        _ => form.result.is_some(),
    }
}

/// Programs after `call` and as the program of a task.
pub(super) fn programs(found: &mut CompletionList<'_>) {
    let (db, project, own) = (found.db, found.project, found.file);
    for (name, file) in &items(db, project).programs {
        let again = if *file == own { -OWN } else { 0 };
        add_program(found, project, name, *file).scored(again);
    }
    libraries(found);
    missing::libraries(found);
    missing::library_programs(found);
}

/// Programs for a new task: programs that run endlessly, or that nothing calls, come first.
pub(super) fn task_programs(found: &mut CompletionList<'_>) {
    let (db, project, own) = (found.db, found.project, found.file);
    let application = application(db, project);
    for (name, file) in &items(db, project).programs {
        let is_called = application.callers.get(name).is_some_and(|callers| !callers.is_empty());
        let score = if *file == own || ENTRY_POINTS.contains(&name.as_str()) {
            -FITS
        } else if application.endless.contains(name) {
            FITS
        } else if is_called {
            0
        } else {
            OWN
        };
        add_program(found, project, name, *file).scored(score);
    }
    libraries(found);
    missing::libraries(found);
}

/// Programs at the start of a line, where the completion also inserts `call`.
fn calls(found: &mut CompletionList<'_>) {
    let (db, project, own) = (found.db, found.project, found.file);
    for (name, file) in items(db, project).programs.iter().filter(|(_, file)| **file != own) {
        let added = add_program(found, project, name, *file).scored(-OWN);
        added.with(|item| {
            item.insert = format!("call {}", item.insert);
            item.plain = format!("call {}", item.plain);
        });
    }
}
