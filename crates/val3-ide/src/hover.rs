//! Hover information for the name at the cursor: type, initial value, father, comment, page.

mod attributes;
mod data;
mod literal_fields;
mod numbers;
mod position;
mod program;
mod text;
mod units;
mod xml;

pub(crate) use data::keys_of;
pub(crate) use program::{comment as program_comment, line as program_line};
pub use text::Hover;
pub(crate) use text::shape;
pub(crate) use units::sign as unit_sign;
pub(crate) use xml::value_attribute;

use val3_analysis::application::application;
use val3_analysis::body::{Constant, Expr, body};
use val3_analysis::db::{Db, File, Project};
use val3_analysis::infer::infer;
use val3_analysis::items::parse;
use val3_analysis::items::program::header;
use val3_analysis::items::project::items;
use val3_analysis::occurrences::Symbol;
use val3_analysis::ty::brackets;
use val3_lang::glossary::{self, EntryKind};
use val3_lang::types::{BaseType, Field, field, fields};
use val3_lang::{builtins, enumerations, instructions, page, statements};
use val3_syntax::{SyntaxKind, TextRange};

use crate::FilePosition;
use crate::markdown::{fenced, plain};
use crate::navigate::name_at;
use crate::owner::owner;
use text::place_of;

/// Hover information at a position.
pub fn hover(db: &dyn Db, at: FilePosition) -> Option<Hover> {
    if let Some((project, found)) = name_at(db, at) {
        let mut markdown = symbol(db, project, &found.symbol)?;
        markdown.extend(position::named(db, project, at, &found.symbol, found.range));
        return Some(Hover { range: found.range, markdown });
    }
    let project = owner(db, at.file)?;
    let found =
        attributes::hover(db, project, at).or_else(|| word(db, project, at)).or_else(|| xml::hover(db, project, at));
    let position = found.is_some().then(|| position::around(db, project, at)).flatten();
    let position = position.map(|text| format!("\n{text}")).unwrap_or_default();
    found.map(|hover| Hover { markdown: hover.markdown + &position, ..hover })
}

/// Hover information for a word or literal in the code that is no name.
fn word(db: &dyn Db, project: Project, at: FilePosition) -> Option<Hover> {
    keyword(db, at)
        .or_else(|| numbers::hover(db, project, at))
        .or_else(|| xml::loaded(db, project, at))
        .or_else(|| constant(db, at))
        .or_else(|| literal_fields::hover(db, project, at))
}

/// Hover information for a symbol as used in `project`.
pub(crate) fn symbol(db: &dyn Db, project: Project, symbol: &Symbol) -> Option<String> {
    match symbol {
        Symbol::Local(file, name) => {
            let header = header(db, *file);
            let local = header.locals.iter().find(|local| local.name == *name)?;
            Some(
                fenced(&format!("{} {name}{}", local.type_name, shape(&local.sizes, local.container)))
                    + "\nlocal variable",
            )
        }
        Symbol::Param(file, name) => {
            let header = header(db, *file);
            let param = header.params.iter().find(|param| param.name == *name)?;
            let reference = if param.by_reference { "&" } else { "" };
            let line = format!("{}{reference} {name}{}", param.type_name, brackets(param.container));
            let passing = if param.by_reference { "by reference" } else { "by value" };
            let about =
                program::parameter(db, *file, name).map(|about| format!("\n\n{}", plain(&about))).unwrap_or_default();
            Some(fenced(&line) + &format!("\nparameter, {passing}{about}"))
        }
        Symbol::Data(owner, name) => data::hover(db, *owner, name),
        Symbol::Program(owner, name) => program::hover(db, *owner, name),
        Symbol::Library(owner, name) => library(db, *owner, name),
        Symbol::Type(owner, name) => user_type(db, *owner, name),
        Symbol::Task(owner, name) => task(db, *owner, name),
        Symbol::Element(page, id) => {
            page.path(db).file_name().map(|page| format!("element `{}` of the page `{}`", plain(id), plain(page)))
        }
        Symbol::Instruction(name) => instruction(name),
        Symbol::Builtin(name) => {
            builtins::find(name).map(|found| fenced(&format!("{} {name}", found.ty.name())) + "\n" + found.doc)
        }
        Symbol::Enumerator(name) => {
            enumerations::find(name).map(|found| fenced(&format!("{} {name}", found.ty.name())) + "\n" + found.doc)
        }
        Symbol::Field(ty, name) => builtin_field(db, project, *ty, name),
        Symbol::BuiltinType(name) => builtin_type(db, project, name),
    }
}

/// Programs that tasks of this name execute.
fn task(db: &dyn Db, owner: Project, name: &str) -> Option<String> {
    let tasks = application(db, owner).created_tasks().filter(|start| start.name.as_deref() == Some(name));
    let lines = tasks.map(|start| {
        let library = start.program.library.as_ref().map(|library| format!("{library}:")).unwrap_or_default();
        format!("task \"{name}\" runs {library}{}", start.program.program)
    });
    let mut lines: Vec<String> = lines.collect();
    lines.dedup();
    (!lines.is_empty()).then(|| fenced(&lines.join("\n")))
}

fn library(db: &dyn Db, owner: Project, name: &str) -> Option<String> {
    let library = items(db, owner).libraries.get(name)?;
    let loading = if library.autoload { "loaded with the application" } else { "loaded by `libLoad`" };
    let interface = library.interface.map_or_else(|| "an unknown library".to_owned(), |project| place_of(db, project));
    Some(fenced(&format!("library {name}")) + &format!("\ninterface of {interface}, {loading}"))
}

fn user_type(db: &dyn Db, owner: Project, name: &str) -> Option<String> {
    let project = items(db, owner).types.get(name).copied().flatten()?;
    let mut fields: Vec<_> = items(db, project).data.iter().filter(|(_, item)| item.decl.public).collect();
    fields.sort_unstable_by_key(|(name, _)| *name);
    let lines: String = fields
        .iter()
        .map(|(name, item)| {
            format!("  {} {name}{}\n", item.decl.type_name, shape(&item.decl.sizes, item.decl.container))
        })
        .collect();
    Some(fenced(&format!("type {name}\n{}", lines.trim_end())) + &format!("\nuser type of {}", place_of(db, project)))
}

/// An instruction's forms and page.
fn instruction(name: &str) -> Option<String> {
    let found = instructions::find(name)?;
    Some(fenced(&found.signatures().join("\n")) + "\n" + &page::text(found.page))
}

fn builtin_field(db: &dyn Db, project: Project, ty: BaseType, name: &str) -> Option<String> {
    let found = field(ty, items(db, project).arm, name)?;
    let unit = units::word(db, project, found.unit).map(|unit| format!(" ({unit})")).unwrap_or_default();
    Some(fenced(&format!("{} {}.{name}", found.ty.name(), ty.name())) + &format!("\n{}{unit}", found.doc))
}

/// A built-in type with its fields.
fn builtin_type(db: &dyn Db, project: Project, name: &str) -> Option<String> {
    let (ty, arm) = BaseType::from_file_name(name)?;
    let line = |field: &Field| format!("- `{}`: {}", field.name, field_line(db, project, field));
    let lines: Vec<String> = fields(ty, arm.or(items(db, project).arm)).iter().map(line).collect();
    let about = if lines.is_empty() { String::new() } else { format!("\n\n{}", lines.join("\n")) };
    let page = glossary::find(EntryKind::Type, ty.name()).map(|entry| page::summary(entry.page)).unwrap_or_default();
    Some(format!("{}\n{page}{about}", fenced(name)))
}

/// Description of a field, for example `num, in mm. Translation along x.`
pub(crate) fn field_line(db: &dyn Db, project: Project, field: &Field) -> String {
    let unit = units::word(db, project, field.unit).map(|unit| format!(", in {unit}")).unwrap_or_default();
    format!("{}{unit}. {}", field.ty.name(), field.doc)
}

/// Page of a keyword.
fn keyword(db: &dyn Db, at: FilePosition) -> Option<Hover> {
    let root = parse(db, at.file).root();
    let tokens = root.text_range().contains_inclusive(at.offset).then(|| root.token_at_offset(at.offset))?;
    let token = tokens.into_iter().find(|token| token.kind().is_keyword() || token.kind() == SyntaxKind::QUESTION)?;
    let found = statements::find(token.text())?;
    Some(Hover { range: token.text_range(), markdown: page::text(found.page) })
}

/// Value of a literal expression.
fn constant(db: &dyn Db, at: FilePosition) -> Option<Hover> {
    let body = body(db, at.file);
    let around = body.exprs().filter(|(_, expr, range)| {
        range.contains_inclusive(at.offset) && matches!(expr, Expr::Binary(..) | Expr::Unary(..) | Expr::Paren(_))
    });
    let (id, _, range) = around.max_by_key(|(_, _, range)| range.len())?;
    let value = match body.constant(id)? {
        Constant::Number(value) => value.to_string(),
        Constant::String(text) => format!("\"{text}\""),
        Constant::Bool(value) => value.to_string(),
    };
    Some(Hover { range, markdown: fenced(&value) })
}

/// Type of the selected expression, or of the innermost expression that contains the range.
pub fn type_at(db: &dyn Db, file: File, range: TextRange) -> Option<(TextRange, String)> {
    let project = owner(db, file)?;
    let body = body(db, file);
    let around = body.exprs().filter(|(_, _, found)| found.contains_range(range));
    let (id, _, found) = around.min_by_key(|(_, _, found)| found.len())?;
    let ty = infer(db, project, file).ty(id);
    (!ty.is_unknown()).then(|| (found, ty.display(db).to_string()))
}

#[cfg(test)]
mod tests;
