//! What the rules on unused data share.

use rustc_hash::FxHashSet;
use val3_analysis::application::{Use, unlisted_may_use};
use val3_analysis::items::data;
use val3_analysis::items::declarations::{Declared, all_data};
use val3_analysis::items::fathers::fathers;

use super::{DataFile, ProjectView};

/// Every use of the project's private data is known. A project without programs holds the data of others: the fields
/// of a user type, inputs and outputs.
pub(crate) fn is_judged(view: &ProjectView<'_>) -> bool {
    view.application().closed && !view.items.programs.is_empty()
}

/// What the programs do to private data; `None` where others may use it too: public data, fathers of other data, data
/// whose name a text may hold, and data that a program uses which the project does not list.
pub(crate) fn uses(view: &ProjectView<'_>, name: &str) -> Option<Use> {
    let item = view.items.data.get(name).filter(|item| !item.decl.public)?;
    let is_built_in = val3_lang::builtins::find(name).is_some();
    let is_father = is_built_in || fathers(view.db, view.project).contains(&item.decl.name);
    let may_be_used = || view.application().is_named_in_text(name) || unlisted_may_use(view.db, view.project, name);
    (!is_father && !may_be_used()).then(|| view.application().uses_of(name))
}

/// The declarations in a file whose names are `guilty`.
pub(crate) fn declared(data: &DataFile<'_>, guilty: impl Fn(&str) -> bool) -> Vec<Declared> {
    // The names alone are at hand; where they stand is read from the file.
    let items = data::data(data.view.db, data.file);
    let names: FxHashSet<&str> = items.iter().map(|item| item.name.as_str()).filter(|name| guilty(name)).collect();
    if names.is_empty() {
        return Vec::new();
    }
    let mut declared = all_data(data.view.db, data.file);
    declared.retain(|declared| names.contains(declared.name.as_str()));
    declared
}
