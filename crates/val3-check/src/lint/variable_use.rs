//! How a program uses its own variables.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::application::Use;
use val3_analysis::effects::Root;
use val3_analysis::ty::Base;
use val3_lang::types::BaseType;

use super::Program;

/// A program's accesses to its own variables, by name. Unused variables are missing.
#[derive(Debug, Default)]
pub(crate) struct VariableUse {
    pub(crate) locals: FxHashMap<SmolStr, Use>,
    pub(crate) params: FxHashMap<SmolStr, Use>,
}

impl VariableUse {
    pub(super) fn new(program: &Program<'_>) -> Self {
        let mut used = Self::default();
        for access in program.effects.all() {
            let (uses, name) = match &access.root {
                Root::Local(name) => (&mut used.locals, name),
                Root::Param(name) => (&mut used.params, name),
                _ => continue,
            };
            uses.entry(name.clone()).or_default().add(access.kind);
        }
        used
    }
}

/// The local or parameter is an input, an output or a line, for which a write is a use.
pub(crate) fn is_linkable(program: &Program<'_>, name: &str) -> bool {
    let locals = program.header.locals.iter().map(|local| (&local.name, &local.type_name));
    let mut variables = locals.chain(program.header.params.iter().map(|param| (&param.name, &param.type_name)));
    let ty = variables.find(|(known, _)| *known == name).map(|(_, ty)| ty);
    let base = ty.and_then(|ty| val3_analysis::items::project::resolve_type(&program.items.types, ty));
    base.and_then(Base::builtin).is_some_and(BaseType::is_linkable)
}
