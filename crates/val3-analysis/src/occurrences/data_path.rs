//! Names in data paths: `tSlot["a"].fFrame[0]` as a father, `part:nWeight[0]` in page bindings.

use val3_lang::builtins;
use val3_syntax::{TextRange, TextSize};

use super::occurrence::Symbol;
use crate::db::{Db, Project};
use crate::items::project::{fields, items};
use crate::ty::Base;

/// Returns the resolved names of a data path in `project`, with their ranges in the path.
pub(crate) fn path_names(db: &dyn Db, project: Project, path: &str) -> Vec<(TextRange, Symbol)> {
    let Some((alias, behind)) = library(path) else { return item_names(db, project, path) };
    let Some(library) = items(db, project).libraries.get(alias) else { return Vec::new() };
    let identifier = (TextRange::up_to(TextSize::of(alias)), Symbol::Library(project, alias.into()));
    let start = TextSize::of(path) - TextSize::of(behind);
    let names = library.interface.map(|interface| item_names(db, interface, behind)).unwrap_or_default();
    let names = names.into_iter().map(|(range, symbol)| (range + start, symbol));
    std::iter::once(identifier).chain(names).collect()
}

/// Splits a data path into the library identifier before the colon and the rest.
pub(crate) fn library(path: &str) -> Option<(&str, &str)> {
    path.split_once(':').filter(|(alias, _)| !alias.contains(['[', '.', '"', '&']))
}

fn item_names(db: &dyn Db, project: Project, path: &str) -> Vec<(TextRange, Symbol)> {
    let mut names = Vec::new();
    let mut owner: Option<Project> = None;
    for (at, name) in steps(path) {
        let range = TextRange::at(at, TextSize::of(name));
        let item = match owner {
            None => items(db, project).data.get(name),
            Some(owner) => fields(db, owner).get(name),
        };
        let Some(item) = item else {
            if owner.is_none() && builtins::find(name).is_some() {
                names.push((range, Symbol::Builtin(name.into())));
            }
            return names;
        };
        names.push((range, Symbol::Data(owner.unwrap_or(project), name.into())));
        let Base::User(next) = item.base else { return names };
        owner = Some(next);
    }
    names
}

/// Returns the names in a data path with their offsets. Indexes in brackets are no names.
fn steps(reference: &str) -> Vec<(TextSize, &str)> {
    let mut steps = Vec::new();
    let (mut at, mut rest) = (TextSize::new(0), reference);
    loop {
        let (name, behind) = rest.split_at(rest.find(['[', '.']).unwrap_or(rest.len()));
        steps.push((at, name));
        let next = match behind.chars().next() {
            Some('.') => behind.get(1..),
            _ => behind.find("].").and_then(|end| behind.get(end + 2..)),
        };
        let Some(next) = next else { return steps };
        at += TextSize::of(rest) - TextSize::of(next);
        rest = next;
    }
}

#[cfg(test)]
mod tests {
    use super::steps;

    #[test]
    fn references_to_fathers_are_found() {
        let shown = |reference| {
            let steps = steps(reference).into_iter();
            steps.map(|(at, name)| format!("{}{name}", u32::from(at))).collect::<Vec<_>>()
        };
        assert_eq!(shown("fTable"), ["0fTable"]);
        assert_eq!(shown("tSlot[&quot;a.b&quot;].fFrame[0]"), ["0tSlot", "23fFrame"]);
        assert_eq!(shown("a.b[0].c"), ["0a", "2b", "7c"]);
    }
}
