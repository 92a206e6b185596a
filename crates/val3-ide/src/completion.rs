//! Completions at the cursor.

mod cell_file;
mod code;
mod comments;
mod context;
mod list;
mod literals;
mod missing;
mod names;
mod postfix;
mod strings;
mod text_place;
mod xml;

use val3_analysis::db::{Db, Project};
use val3_analysis::occurrences::Symbol;
use val3_lang::{page, statements};

use crate::FilePosition;
use crate::hover;
use crate::owner::{is_cell_file, is_page, owner};
use crate::xml_context::XmlContext;
use crate::xml_cursor::XmlPlace;
use context::{Context, context};
use list::CompletionList;

pub use cell_file::mesh_completions;
pub use list::{Completion, CompletionKind};

/// Completions at a position, the most probable first.
pub fn completions(db: &dyn Db, at: FilePosition) -> Vec<Completion> {
    owner(db, at.file).map(|project| completions_in(db, project, at)).unwrap_or_default()
}

/// Completions at a position in a file as part of a project, the most probable first.
pub fn completions_in(db: &dyn Db, project: Project, at: FilePosition) -> Vec<Completion> {
    if is_page(db, at.file) {
        return Vec::new();
    }
    if is_cell_file(db, at.file) {
        return cell_file::complete(db, at);
    }
    let (context, range) = context(db, project, at);
    let mut found = CompletionList::new(db, project, at, range);
    match context {
        Context::Nothing => {}
        Context::Statement(blocks, part) => code::statement(&mut found, &blocks, part),
        Context::Expression(expected) => code::expression(&mut found, &expected),
        Context::Operator(operators) => code::operators(&mut found, operators),
        Context::Members(base, receiver) => {
            code::members(&mut found, base);
            receiver.iter().for_each(|receiver| postfix::statements(&mut found, receiver));
        }
        Context::Comment => comments::complete(&mut found),
        Context::LibraryItem { library, wanted } => code::library_items(&mut found, &library, &wanted),
        Context::Key(collection, expected) => {
            strings::quoted_keys(&mut found, &collection);
            code::expression(&mut found, &expected);
        }
        Context::Program => code::programs(&mut found),
        Context::TaskProgram => code::task_programs(&mut found),
        Context::Text(place) => strings::texts(&mut found, &place),
        Context::Xml(context) => xml::complete(&mut found, &context),
    }
    found.prefer_used();
    found.ranked()
}

/// Whether a space typed at the position starts an attribute, which can be completed. Elsewhere a space usually ends a
/// word.
pub fn completes_after_blank(db: &dyn Db, at: FilePosition) -> bool {
    let found = XmlContext::at(db, at.file, at.offset);
    found.is_some_and(|(context, _)| matches!(context.cursor.place, XmlPlace::AttributeName(_)))
}

/// Documentation of a symbol, in Markdown.
pub fn documentation(db: &dyn Db, project: Project, symbol: &Symbol) -> Option<String> {
    hover::symbol(db, project, symbol)
}

/// Documentation for a completion, in Markdown: from its symbol, or the keyword's page.
pub fn completion_documentation(db: &dyn Db, project: Project, completion: &Completion) -> Option<String> {
    if let Some(page) = &completion.documentation {
        return Some(page.clone());
    }
    match (&completion.symbol, completion.kind) {
        (Some(symbol), _) => documentation(db, project, symbol),
        (None, CompletionKind::Keyword) => statements::find(&completion.label).map(|found| page::text(found.page)),
        (None, _) => None,
    }
}

#[cfg(test)]
mod tests;
