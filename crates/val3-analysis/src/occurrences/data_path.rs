//! Names in data paths: `tSlot["a"].fFrame[0]` as a father, `part:nWeight[0]` in page bindings.

use val3_lang::builtins;
use val3_lang::data_path::{DataPath, DataPathStep};
use val3_syntax::{TextRange, TextSize};

use super::occurrence::Symbol;
use crate::db::{Db, Project};
use crate::items::project::{fields, items};
use crate::ty::Base;

/// Returns the resolved names of a data path in `project`, with their ranges in the path.
pub(crate) fn path_names(db: &dyn Db, project: Project, path: &str) -> Vec<(TextRange, Symbol)> {
    let Some((alias, behind)) = DataPath::new(path).split_library() else { return item_names(db, project, path) };
    let Some(library) = items(db, project).libraries.get(alias) else { return Vec::new() };
    let identifier = (TextRange::up_to(TextSize::of(alias)), Symbol::Library(project, alias.into()));
    let start = TextSize::of(path) - TextSize::of(behind.text());
    let names = library.interface.map(|interface| item_names(db, interface, behind.text())).unwrap_or_default();
    let names = names.into_iter().map(|(range, symbol)| (range + start, symbol));
    std::iter::once(identifier).chain(names).collect()
}

fn item_names(db: &dyn Db, project: Project, path: &str) -> Vec<(TextRange, Symbol)> {
    let mut names = Vec::new();
    let mut owner: Option<Project> = None;
    for DataPathStep { offset, name } in DataPath::new(path).steps() {
        let at = TextSize::try_from(offset).unwrap_or_default();
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
