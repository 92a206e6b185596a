//! Names in strings that instructions resolve: `getData("part:pTrack[0]", …)`, `part:libExist("pick()")`, tasks,
//! elements of user pages.

use val3_lang::instructions::{GET_DATA, LIB_EXIST, USER_PAGE_SET};
use val3_syntax::{TextRange, TextSize, TextSlice, text_at};

use super::occurrence::{Occurrence, Symbol, Usage};
use super::tasks::task_names;
use crate::body::{Body, Expr, ExprId};
use crate::db::{Db, File, Project};
use crate::items::project::{Items, items};
use crate::pages;

pub(super) fn names(db: &dyn Db, project: Project, file: File, body: &Body) -> Vec<Occurrence> {
    let texts = Texts { db, project, items: items(db, project), source: file.text(db), body };
    let calls = body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Call(callee, arguments) => Some((*callee, *arguments.first()?)),
        _ => None,
    });
    let data = calls.flat_map(|(callee, argument)| texts.argument(callee, argument));
    let elements = elements(body).into_iter().filter_map(|(page, id)| texts.element(page, id));
    data.chain(elements)
        .chain(task_names(body).into_iter().filter_map(|(name, usage)| texts.task(name, usage)))
        .collect()
}

/// Returns page and element id from every `userPageSet` in a program.
pub fn elements(body: &Body) -> Vec<(ExprId, ExprId)> {
    let calls = body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Call(callee, arguments) if matches!(body.expr(*callee), Expr::Name(name) if name == USER_PAGE_SET) => {
            Some((*arguments.first()?, *arguments.get(1)?))
        }
        _ => None,
    });
    calls.collect()
}

struct Texts<'db> {
    db: &'db dyn Db,
    project: Project,
    items: &'db Items,
    source: &'db str,
    body: &'db Body,
}

impl Texts<'_> {
    fn argument(&self, callee: ExprId, argument: ExprId) -> Vec<Occurrence> {
        if !matches!(self.body.expr(argument), Expr::String(_)) {
            return Vec::new();
        }
        let (start, text) = self.inside(argument);
        match self.body.expr(callee) {
            Expr::Name(name) if name == GET_DATA => self.data(start, text),
            Expr::Path { library, item } if item == LIB_EXIST => {
                let interface = self.items.libraries.get(library).and_then(|library| library.interface);
                interface.and_then(|interface| self.item(interface, start, text)).into_iter().collect()
            }
            _ => Vec::new(),
        }
    }

    /// Returns the occurrence of a task whose entire name is a literal.
    fn task(&self, name: ExprId, usage: Usage) -> Option<Occurrence> {
        let Expr::String(whole) = self.body.expr(name) else { return None };
        let (start, text) = self.inside(name);
        let found = identifier(text);
        let symbol = Symbol::Task(self.project, whole.clone());
        let range = TextRange::at(start, TextSize::of(found));
        (found == whole && !found.is_empty()).then_some(Occurrence { range, symbol, usage })
    }

    /// Returns the occurrence of a page element if page and id are literals.
    fn element(&self, page: ExprId, id: ExprId) -> Option<Occurrence> {
        let (Expr::String(page), Expr::String(whole)) = (self.body.expr(page), self.body.expr(id)) else { return None };
        let (start, text) = self.inside(id);
        let symbol = pages::element(self.db, self.project, page, whole)?;
        let range = TextRange::at(start, TextSize::of(whole.as_str()));
        text.starts_with(whole.as_str()).then_some(Occurrence { range, symbol, usage: Usage::Write })
    }

    /// Returns the offset and the source of a string between its quotes.
    fn inside(&self, string: ExprId) -> (TextSize, &str) {
        let range = self.body.range(string);
        let raw = text_at(self.source, range);
        let inner = raw.strip_prefix("&quot;").or_else(|| raw.strip_prefix('"')).unwrap_or(raw);
        (range.end() - TextSize::of(inner), inner)
    }

    /// Returns the occurrences in `name` or `library:name`, with or without an index.
    fn data(&self, start: TextSize, text: &str) -> Vec<Occurrence> {
        let first = identifier(text);
        let Some(behind) = text.get(first.len()..).and_then(|behind| behind.strip_prefix(':')) else {
            return self.item(self.project, start, text).into_iter().collect();
        };
        let Some(library) = self.items.libraries.get(first) else { return Vec::new() };
        let range = TextRange::at(start, TextSize::of(first));
        let identifier = Occurrence { range, symbol: Symbol::Library(self.project, first.into()), usage: Usage::Read };
        let item_start = range.end() + TextSize::of(':');
        let item = library.interface.and_then(|interface| self.item(interface, item_start, behind));
        std::iter::once(identifier).chain(item).collect()
    }

    /// Returns the occurrence of a data or program name at the start of a string.
    fn item(&self, project: Project, start: TextSize, text: &str) -> Option<Occurrence> {
        let name = identifier(text);
        let offered = items(self.db, project);
        let is_program = text.get(name.len()..).is_some_and(|behind| behind.starts_with("()"));
        let symbol = if is_program {
            offered.programs.contains_key(name).then(|| Symbol::Program(project, name.into()))
        } else {
            offered.data.contains_key(name).then(|| Symbol::Data(project, name.into()))
        };
        let range = TextRange::at(start, TextSize::of(name));
        symbol.map(|symbol| Occurrence { range, symbol, usage: Usage::Read })
    }
}

/// Returns the letters, digits and underscores at the start of a string.
fn identifier(text: &str) -> &str {
    let end = text.find(|letter: char| !(letter.is_ascii_alphanumeric() || letter == '_')).unwrap_or(text.len());
    text.part(..end)
}
