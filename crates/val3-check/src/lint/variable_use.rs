//! How a program uses its own variables.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::application::Use;
use val3_analysis::effects::Root;
use val3_analysis::ty::Base;
use val3_lang::types::BaseType;

use super::Program;

/// What the program does to each of the locals that it uses.
pub(crate) fn of_locals(program: &Program<'_>) -> FxHashMap<SmolStr, Use> {
    gather(program, |root| match root {
        Root::Local(name) => Some(name),
        _ => None,
    })
}

/// What the program does to each of the parameters that it uses.
pub(crate) fn of_params(program: &Program<'_>) -> FxHashMap<SmolStr, Use> {
    gather(program, |root| match root {
        Root::Param(name) => Some(name),
        _ => None,
    })
}

fn gather(program: &Program<'_>, name: impl Fn(&Root) -> Option<&SmolStr>) -> FxHashMap<SmolStr, Use> {
    let mut uses: FxHashMap<SmolStr, Use> = FxHashMap::default();
    for access in program.effects.all() {
        if let Some(name) = name(&access.root) {
            uses.entry(name.clone()).or_default().add(access.kind);
        }
    }
    uses
}

/// The local or parameter stands for an input, an output or a line: writing it is its use.
pub(crate) fn is_linkable(program: &Program<'_>, name: &str) -> bool {
    let locals = program.header.locals.iter().map(|local| (&local.name, &local.type_name));
    let mut variables = locals.chain(program.header.params.iter().map(|param| (&param.name, &param.type_name)));
    let ty = variables.find(|(known, _)| *known == name).map(|(_, ty)| ty);
    let base = ty.and_then(|ty| val3_analysis::items::project::resolve_type(&program.items.types, ty));
    base.and_then(Base::builtin).is_some_and(BaseType::is_linkable)
}
