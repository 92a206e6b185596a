//! Frames and tools to which a value can be relative.

use val3_analysis::items::project::items;
use val3_analysis::ty::Base;
use val3_lang::builtins;
use val3_syntax::xml::escaped;

use crate::completion::list::{CompletionKind as Kind, CompletionList};
use crate::completion::names::data_detail;
use crate::father_paths::father_paths;
use crate::xml_context::XmlContext;

/// Frames for points and frames, tools for tools; with an index in s7 and s8.
pub(super) fn fathers(found: &mut CompletionList<'_>, context: &XmlContext<'_>, is_old: bool) {
    let Some((ty, _)) = context.builtin(found.db, found.project) else { return };
    let Some(father) = ty.father() else { return };
    let own = context.declarations().last().and_then(|(data, _)| data.value("name"));
    let mut data: Vec<_> = items(found.db, found.project).data.iter().collect();
    data.sort_unstable_by_key(|(name, _)| *name);
    for (name, item) in data {
        // A single frame or tool cannot be relative to itself.
        if own == Some(name.as_str()) && item.decl.sizes == [1] {
            continue;
        }
        if is_old {
            if item.base == Base::of(father) {
                found.add(name, Kind::Data).detail(|| data_detail(item));
            }
            continue;
        }
        for (place, reference) in (0..).zip(father_paths(found.db, found.project, name, item, father)) {
            found.add(&escaped(&reference), Kind::Data).detail(|| data_detail(item)).scored(-place);
        }
    }
    let index = if is_old { "" } else { "[0]" };
    for builtin in builtins::BUILTINS.iter().filter(|builtin| builtin.ty == father && builtin.is_variable) {
        found.add(&format!("{}{index}", builtin.name), Kind::Constant).detail(|| father.name().to_owned());
    }
}
