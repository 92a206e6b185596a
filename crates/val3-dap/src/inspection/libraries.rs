//! Scope of all libraries, because clients show every scope in a line of its own.

use val3_debug::{Inside, ScopeKind};

use super::{Handles, InspectedItem};
use crate::protocol::{Scope, Variable, VariablePresentationHint, VariablePresentationHintAttributes};

/// Number of libraries up to which each library has its scope.
const FEW: usize = 4;

/// Data of a library.
#[derive(Debug, Clone)]
pub(crate) struct LibraryData {
    pub(super) alias: String,
    /// Number of variables.
    pub(super) size: usize,
    pub(super) inside: Inside,
}

/// Whether the libraries among these scopes are shown in one scope.
pub(super) fn are_grouped(scopes: &[val3_debug::Scope]) -> bool {
    scopes.iter().filter(|scope| matches!(scope.kind, ScopeKind::Library(_))).count() > FEW
}

impl Handles {
    /// Returns the scope of these libraries, sorted by alias.
    pub(super) fn libraries_scope(&mut self, mut libraries: Vec<LibraryData>) -> Scope {
        libraries.sort_by(|left, right| left.alias.cmp(&right.alias));
        Scope {
            name: "Libraries".to_owned(),
            named_variables: i32::try_from(libraries.len()).ok(),
            variables_reference: self.add(InspectedItem::Libraries(libraries)),
            ..Scope::default()
        }
    }

    /// Returns a library as a variable whose nested values are its data.
    pub(super) fn library(&mut self, LibraryData { alias, size, inside }: LibraryData) -> Variable {
        let unit = if size == 1 { "variable" } else { "variables" };
        Variable {
            name: alias,
            value: format!("{size} {unit}"),
            named_variables: i32::try_from(size).ok(),
            variables_reference: self.add(InspectedItem::Values(inside)),
            presentation_hint: Some(VariablePresentationHint {
                attributes: Some(vec![VariablePresentationHintAttributes::ReadOnly]),
                ..VariablePresentationHint::default()
            }),
            ..Variable::default()
        }
    }
}
