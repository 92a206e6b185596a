//! Names in page files with their symbols: data, programs, element ids.

use smol_str::SmolStr;
use val3_syntax::TextRange;

use super::{BoundName, bindings, html_file, is_bindings, page_ids, page_of};
use crate::db::{Db, File, Project};
use crate::items::project::items;
use crate::occurrences::{Occurrence, Symbol, Usage, path_names};

/// Returns the names in a page file of a project, in source order.
pub(crate) fn occurrences(db: &dyn Db, project: Project, file: File) -> Vec<Occurrence> {
    let mut found = if is_bindings(db, file) { of_bindings(db, project, file) } else { of_html(db, file) };
    found.sort_by_key(|occurrence| occurrence.range.start());
    found
}

fn of_bindings(db: &dyn Db, project: Project, file: File) -> Vec<Occurrence> {
    let (found, source) = (bindings(db, file), file.text(db));
    let page = page_of(db, project, file);
    let ids = found.elements().filter_map(|bound| {
        let symbol = declared(db, page?, &bound.text)?;
        Some(Occurrence { range: bound.range, symbol, usage: Usage::Read })
    });
    let paths = found.data.iter().filter_map(|bound| Some((bound.path.as_ref()?, bound.is_written)));
    let data = paths.flat_map(|(path, is_written)| {
        let names = path_names(db, project, &path.text);
        let last = names.len();
        let usage = move |number| if is_written && number == last { Usage::Write } else { Usage::Read };
        (1..).zip(names).map(move |(number, (range, symbol))| {
            let range = in_source(path, source, range);
            Occurrence { range, symbol, usage: usage(number) }
        })
    });
    let programs = found.callbacks.iter().filter_map(|callback| {
        let bound = callback.program.as_ref()?;
        let name = bound.text.as_str();
        let symbol = items(db, project).programs.contains_key(name).then(|| Symbol::Program(project, name.into()))?;
        Some(Occurrence { range: bound.range, symbol, usage: Usage::Read })
    });
    ids.chain(data).chain(programs).collect()
}

fn in_source(bound: &BoundName, source: &str, range: TextRange) -> TextRange {
    bound.part(source, &std::ops::Range::<usize>::from(range))
}

fn of_html(db: &dyn Db, file: File) -> Vec<Occurrence> {
    let ids = page_ids(db, file);
    let declared = ids.declared.iter().map(|(id, range)| (*range, id, Usage::Declaration));
    let named = ids.named.iter().filter(|(id, _)| ids.declares(id)).map(|(id, range)| (*range, id, Usage::Read));
    let all = declared.chain(named);
    all.map(|(range, id, usage)| Occurrence { range, symbol: Symbol::Element(file, id.into()), usage }).collect()
}

/// Returns the symbol of the element `id` in the page called `page`.
pub(crate) fn element(db: &dyn Db, project: Project, page: &str, id: &str) -> Option<Symbol> {
    declared(db, html_file(db, project, page)?, id)
}

fn declared(db: &dyn Db, page: File, id: &str) -> Option<Symbol> {
    page_ids(db, page).declares(id).then(|| Symbol::Element(page, SmolStr::from(id)))
}
