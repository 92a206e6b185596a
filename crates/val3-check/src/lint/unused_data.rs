//! Common parts of the rules about unused data.

use rustc_hash::FxHashSet;
use val3_analysis::application::{Use, unlisted_may_use};
use val3_analysis::items::data;
use val3_analysis::items::declarations::{Declared, all_data};
use val3_analysis::items::fathers::fathers;
use val3_lang::types::BaseType;
use val3_syntax::{TextRange, text_at};

use super::{DataFile, ProjectView};

/// Types of taught values.
const TAUGHT: [BaseType; 6] =
    [BaseType::Point, BaseType::Joint, BaseType::Frame, BaseType::Tool, BaseType::Trsf, BaseType::Config];

/// Whether all uses of the project's private data are known. A project without programs contains data for other
/// projects: the fields of a user type, inputs and outputs.
pub(crate) fn has_known_uses(view: &ProjectView<'_>) -> bool {
    view.application().closed && !view.items.programs.is_empty()
}

/// Uses of private data in programs; `None` if there may be other uses: public data, fathers of other data, data whose
/// name may be in a string, and data used by a program that the project does not list.
pub(crate) fn uses(view: &ProjectView<'_>, name: &str) -> Option<Use> {
    let item = view.items.data.get(name).filter(|item| !item.decl.public)?;
    let is_built_in = val3_lang::builtins::find(name).is_some();
    let is_father = is_built_in || fathers(view.db, view.project).contains(&item.decl.name);
    let may_be_used = || view.application().is_named_in_text(name) || unlisted_may_use(view.db, view.project, name);
    (!is_father && !may_be_used()).then(|| view.application().uses_of(name))
}

/// Whether the data is a position, frame, tool, transformation or configuration with values in the file. Such data may be
/// in use at the pendant, for example to jog the arm.
pub(crate) fn is_taught(data: &DataFile<'_>, name: &str, element: TextRange) -> bool {
    let item = data.view.items.data.get(name);
    let base = item.and_then(|item| BaseType::from_file_name(&item.decl.type_name));
    let text = text_at(data.file.text(data.view.db), element);
    base.is_some_and(|(base, _)| TAUGHT.contains(&base)) && text.matches('<').nth(1).is_some()
}

/// Declarations in a file whose names fulfil `guilty`.
pub(crate) fn declared(data: &DataFile<'_>, guilty: impl Fn(&str) -> bool) -> Vec<Declared> {
    // Items contain only names; their locations are read from the file.
    let items = data::data(data.view.db, data.file);
    let names: FxHashSet<&str> = items.iter().map(|item| item.name.as_str()).filter(|name| guilty(name)).collect();
    if names.is_empty() {
        return Vec::new();
    }
    let mut declared = all_data(data.view.db, data.file);
    declared.retain(|declared| names.contains(declared.name.as_str()));
    declared
}
