//! The faults of user pages: names in their bindings that lead nowhere.

use smol_str::SmolStr;
use val3_lang::instruction::Instruction;
use val3_lang::instructions::{self, shows_named_page};
use val3_lang::suggest::nearest;
use val3_lang::types::Container;
use val3_syntax::TextRange;

use super::{BINDINGS, BoundName, HTML, binding_files, bindings, names, page_name};
use crate::body::{Expr, ExprId, body};
use crate::data_check::steps;
use crate::db::{Db, File, FileRange, FileStatus, Project};
use crate::items::project::{Items, items, program_files, signature};
use crate::problem::{PageFault, Problem, ProblemKind};
use crate::resizing::is_resized;

/// The problems of the bindings of a project's pages.
#[salsa::tracked]
pub fn problems(db: &dyn Db, project: Project) -> Vec<Problem> {
    let mut problems = Vec::new();
    for file in binding_files(db, project) {
        PageCheck { db, project, items: items(db, project), file, problems: &mut problems }.check();
    }
    let names = names(db, project);
    if !names.is_empty() {
        problems.extend(program_files(db, project).iter().flat_map(|file| unknown_pages(db, *file, &names)));
    }
    problems
}

/// The pages that a program shows by names that no page has.
fn unknown_pages(db: &dyn Db, file: File, names: &[SmolStr]) -> Vec<Problem> {
    let body = body(db, file);
    let shows_page = |callee: ExprId| {
        let Expr::Name(name) = body.expr(callee) else { return false };
        let shows = |found: &Instruction| found.overloads.iter().any(|form| shows_named_page(found, form));
        instructions::find(name).is_some_and(shows)
    };
    let shown = body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Call(callee, arguments) if shows_page(*callee) => arguments.first().copied(),
        _ => None,
    });
    let unknown = shown.filter_map(|argument| {
        let Expr::String(name) = body.expr(argument) else { return None };
        if names.iter().any(|known| known.eq_ignore_ascii_case(name)) {
            return None;
        }
        let near = nearest(name, names.iter().map(SmolStr::as_str)).map(SmolStr::from);
        let kind = ProblemKind::Page(PageFault::UnknownPage { name: name.clone(), near });
        Some(Problem { kind, place: FileRange { file, range: body.range(argument) }, related: Vec::new() })
    });
    unknown.collect()
}

struct PageCheck<'a> {
    db: &'a dyn Db,
    project: Project,
    items: &'a Items,
    file: File,
    problems: &'a mut Vec<Problem>,
}

impl PageCheck<'_> {
    fn check(&mut self) {
        let found = bindings(self.db, self.file);
        if !matches!(self.file.status(self.db), FileStatus::Read { .. }) {
            return;
        }
        if let Some(fault) = &found.fault {
            self.report(fault.range, PageFault::NoJson { expected: fault.expected });
        }
        found.data.iter().for_each(|bound| self.data(bound));
        found.programs.iter().for_each(|bound| self.program(bound));
        if let Some(ids) = self.ids() {
            found.elements.iter().for_each(|bound| self.element(bound, &ids));
        }
    }

    fn report(&mut self, range: TextRange, fault: PageFault) {
        let place = FileRange { file: self.file, range };
        self.problems.push(Problem { kind: ProblemKind::Page(fault), place, related: Vec::new() });
    }

    fn data(&mut self, bound: &BoundName) {
        let name = bound.root();
        let Some(item) = self.items.data.get(name) else {
            if !bound.text.contains(':') {
                let near = nearest(name, self.items.data.keys().map(SmolStr::as_str)).map(SmolStr::from);
                self.report(bound.range, PageFault::UnknownData { name: name.into(), near });
            }
            return;
        };
        let index = steps(&bound.text).and_then(|steps| steps.into_iter().next()?.index);
        let (Container::Array { .. }, Some(index)) = (item.decl.container, index) else { return };
        let indexes: Option<Vec<u32>> = index.split(',').map(|index| index.trim().parse().ok()).collect();
        let sizes = &item.decl.sizes;
        let is_inside = indexes.is_some_and(|indexes| {
            indexes.len() == sizes.len() && indexes.iter().zip(sizes).all(|(index, size)| index < size)
        });
        if !is_inside && !is_resized(self.db, self.project, name) {
            let size = sizes.iter().map(u32::to_string).collect::<Vec<_>>().join(",");
            self.report(bound.range, PageFault::Index { name: name.into(), index: index.into(), size: size.into() });
        }
    }

    fn program(&mut self, bound: &BoundName) {
        let name = bound.text.as_str();
        match self.items.programs.get(name) {
            None => {
                let near = nearest(name, self.items.programs.keys().map(SmolStr::as_str)).map(SmolStr::from);
                self.report(bound.range, PageFault::UnknownProgram { name: name.into(), near });
            }
            Some(file) if !signature(self.db, self.project, *file).params.is_empty() => {
                self.report(bound.range, PageFault::Parameters { name: name.into() });
            }
            Some(_) => {}
        }
    }

    fn element(&mut self, bound: &BoundName, ids: &[String]) {
        if !ids.iter().any(|id| *id == bound.text) {
            let near = nearest(&bound.text, ids.iter().map(String::as_str)).map(SmolStr::from);
            self.report(bound.range, PageFault::UnknownElement { id: bound.text.clone(), near });
        }
    }

    /// The ids of the elements of the page; `None` if its HTML cannot be read, or if a script may add elements.
    fn ids(&self) -> Option<Vec<String>> {
        let own = page_name(self.file.path(self.db).file_name()?, BINDINGS)?;
        let is_page = |file: &&File| {
            let name = file.path(self.db).file_name().and_then(|name| page_name(name, HTML));
            name.is_some_and(|name| name.eq_ignore_ascii_case(own))
        };
        let page = self.project.pages(self.db).iter().find(is_page)?;
        let text = page.text(self.db);
        let is_static = matches!(page.status(self.db), FileStatus::Read { .. }) && !text.contains("createElement");
        is_static.then(|| ids(text))
    }
}

/// The values of the attributes `id` of an HTML text.
fn ids(text: &str) -> Vec<String> {
    let mut ids = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find("id") {
        let is_attribute = rest.get(..at).is_some_and(|before| before.ends_with(char::is_whitespace));
        rest = rest.get(at + 2..).unwrap_or("");
        let value = rest.trim_start().strip_prefix('=').map(str::trim_start);
        let quoted = value.and_then(|value| {
            let quote = value.chars().next().filter(|quote| matches!(quote, '"' | '\''))?;
            value.get(1..)?.split_once(quote).map(|(id, _)| id)
        });
        ids.extend(quoted.filter(|_| is_attribute).map(|id| val3_syntax::decode_entities(id).into_owned()));
    }
    ids
}

#[cfg(test)]
mod tests {
    use super::ids;

    #[test]
    fn ids_are_attributes() {
        let text = r#"<div id="a" data-id="no"><p class="x" id = 'b &amp; c'>id="in text"</p><hr width="1"/></div>"#;
        assert_eq!(ids(text), ["a", "b & c"]);
    }
}
