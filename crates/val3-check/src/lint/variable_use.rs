//! Uses of a program's own variables.

use rustc_hash::FxHashMap;
use smol_str::SmolStr;
use val3_analysis::application::Use;
use val3_analysis::effects::{Effects, RootVariable};

/// A program's accesses to its own variables, by name, without unused variables.
#[derive(Debug, Default)]
pub(crate) struct VariableUse {
    pub(crate) locals: FxHashMap<SmolStr, Use>,
    pub(crate) params: FxHashMap<SmolStr, Use>,
}

impl VariableUse {
    pub(super) fn new(effects: &Effects<'_>) -> Self {
        let mut used = Self::default();
        for access in effects.all() {
            let (uses, name) = match &access.root {
                RootVariable::Local(name) => (&mut used.locals, name),
                RootVariable::Param(name) => (&mut used.params, name),
                _ => continue,
            };
            uses.entry(name.clone()).or_default().add(access.kind);
        }
        used
    }
}
