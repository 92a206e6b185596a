//! New parameters and locals of a program.

use val3_analysis::items::program::{Header, LocalDecl, ParamDecl};
use val3_lang::types::Container;

/// A parameter after the change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NewParameter {
    /// Index of the old parameter; `None` for a new parameter.
    pub from: Option<usize>,
    /// Name.
    pub name: String,
    /// Type name as spelled in files.
    pub type_name: String,
    /// Element, array or collection.
    pub container: Container,
    /// Whether it is passed by reference, as containers always are.
    pub by_reference: bool,
    /// Expression that callers pass for a new parameter, unescaped.
    pub argument: String,
}

/// A local after the change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NewLocal {
    /// Index of the old local; `None` for a new local.
    pub from: Option<usize>,
    /// Name.
    pub name: String,
    /// Type name as spelled in files.
    pub type_name: String,
    /// Sizes of the dimensions.
    pub sizes: Vec<u32>,
}

/// All parameters and locals after the change, in order.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct NewVariables {
    /// Parameters.
    pub parameters: Vec<NewParameter>,
    /// Locals.
    pub locals: Vec<NewLocal>,
}

impl NewVariables {
    /// The program's current variables.
    pub fn of(header: &Header) -> Self {
        let parameters = (0..).zip(&header.params).map(|(index, param)| NewParameter::kept(index, param));
        let locals = (0..).zip(&header.locals).map(|(index, local)| NewLocal::kept(index, local));
        Self { parameters: parameters.collect(), locals: locals.collect() }
    }

    /// Whether the arguments of calls are unchanged: the parameters are the same, possibly renamed.
    pub(super) fn keeps_arguments(&self, header: &Header) -> bool {
        let mut pairs = (0..).zip(self.parameters.iter().zip(&header.params));
        self.parameters.len() == header.params.len()
            && pairs.all(|(index, (new, old))| new.from == Some(index) && !new.is_retyped(old))
    }

    /// Whether a variable is new, or has another type, size or passing than before.
    pub(crate) fn adds_or_retypes(&self, header: &Header) -> bool {
        self.parameters.iter().any(|new| new.old(header).is_none_or(|old| new.is_retyped(old)))
            || self.locals.iter().any(|new| new.old(header).is_none_or(|old| new.is_retyped(old)))
    }

    /// Whether each old parameter and local is kept at most once.
    pub(super) fn is_consistent(&self, header: &Header) -> bool {
        let parameters = self.parameters.iter().filter_map(|new| new.from);
        let locals = self.locals.iter().filter_map(|new| new.from);
        are_indexes(parameters, header.params.len()) && are_indexes(locals, header.locals.len())
    }

    /// Names, parameters first.
    pub(super) fn names(&self) -> impl Iterator<Item = &str> {
        let parameters = self.parameters.iter().map(|new| new.name.as_str());
        parameters.chain(self.locals.iter().map(|new| new.name.as_str()))
    }
}

fn are_indexes(mut indexes: impl Iterator<Item = usize>, len: usize) -> bool {
    let mut seen = vec![false; len];
    let once = |index: usize| seen.get_mut(index).is_some_and(|seen| !std::mem::replace(seen, true));
    indexes.all(once)
}

impl NewParameter {
    /// An existing parameter.
    pub(super) fn kept(index: usize, param: &ParamDecl) -> Self {
        Self {
            from: Some(index),
            name: param.name.to_string(),
            type_name: param.type_name.to_string(),
            container: param.container,
            by_reference: param.by_reference,
            argument: String::new(),
        }
    }

    /// The parameter before the change; `None` for a new parameter.
    pub(super) fn old<'h>(&self, header: &'h Header) -> Option<&'h ParamDecl> {
        header.params.get(self.from?)
    }

    /// Whether the parameter is new, or has another name than before.
    pub(super) fn is_renamed(&self, header: &Header) -> bool {
        self.old(header).is_none_or(|old| old.name != *self.name)
    }

    /// Whether its type, container or passing differs from `old`.
    pub(super) fn is_retyped(&self, old: &ParamDecl) -> bool {
        old.type_name != *self.type_name || self.is_passed_differently(old)
    }

    /// Whether its container or passing differs from `old`.
    pub(super) fn is_passed_differently(&self, old: &ParamDecl) -> bool {
        (self.container, self.by_reference) != (old.container, old.by_reference)
    }
}

impl NewLocal {
    /// An existing local.
    pub(super) fn kept(index: usize, local: &LocalDecl) -> Self {
        let (name, type_name) = (local.name.to_string(), local.type_name.to_string());
        Self { from: Some(index), name, type_name, sizes: local.sizes.clone() }
    }

    /// The local before the change; `None` for a new local.
    pub(super) fn old<'h>(&self, header: &'h Header) -> Option<&'h LocalDecl> {
        header.locals.get(self.from?)
    }

    /// Whether its type or size differs from `old`.
    pub(super) fn is_retyped(&self, old: &LocalDecl) -> bool {
        old.type_name != *self.type_name || old.sizes != self.sizes
    }
}

/// Whether the container of a local has sizes.
pub(super) fn has_sizes(local: &LocalDecl) -> bool {
    local.container != Container::Collection
}
