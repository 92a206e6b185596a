//! The parameters and locals that a program is to have.

use val3_analysis::items::program::{Header, LocalDecl, ParamDecl};
use val3_lang::types::Container;

/// A parameter after a change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NewParameter {
    /// The index of the parameter that it was; `None` for one that is added.
    pub from: Option<usize>,
    /// The name.
    pub name: String,
    /// The type as files write it.
    pub type_name: String,
    /// An element, array or collection.
    pub container: Container,
    /// Passed by reference; containers always are.
    pub by_reference: bool,
    /// The expression that callers pass for one that is added, in plain characters.
    pub argument: String,
}

/// A local after a change.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NewLocal {
    /// The index of the local that it was; `None` for one that is added.
    pub from: Option<usize>,
    /// The name.
    pub name: String,
    /// The type as files write it.
    pub type_name: String,
    /// Sizes of the dimensions.
    pub sizes: Vec<u32>,
}

/// All parameters and locals after a change, in their order.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct NewVariables {
    /// The parameters.
    pub parameters: Vec<NewParameter>,
    /// The locals.
    pub locals: Vec<NewLocal>,
}

impl NewVariables {
    /// Those that a program has.
    pub fn of(header: &Header) -> Self {
        let parameters = (0..).zip(&header.params).map(|(index, param)| NewParameter::kept(index, param));
        let locals = (0..).zip(&header.locals).map(|(index, local)| NewLocal::kept(index, local));
        Self { parameters: parameters.collect(), locals: locals.collect() }
    }

    /// The parameters are those of the program, possibly under other names.
    pub(super) fn keeps_arguments(&self, header: &Header) -> bool {
        let is_same =
            |(index, (new, old)): (usize, (&NewParameter, &ParamDecl))| new.from == Some(index) && !new.is_retyped(old);
        self.parameters.len() == header.params.len()
            && self.parameters.iter().zip(&header.params).enumerate().all(is_same)
    }

    /// Some variable is new, or has another type, size or passing than before.
    pub(crate) fn adds_or_retypes(&self, header: &Header) -> bool {
        let param = |new: &NewParameter| {
            let old = new.from.and_then(|index| header.params.get(index));
            old.is_none_or(|old| new.is_retyped(old))
        };
        let local = |new: &NewLocal| {
            let old = new.from.and_then(|index| header.locals.get(index));
            old.is_none_or(|old| new.is_retyped(old))
        };
        self.parameters.iter().any(param) || self.locals.iter().any(local)
    }

    /// Every old parameter or local that is kept, is kept once.
    pub(super) fn is_consistent(&self, header: &Header) -> bool {
        let parameters = self.parameters.iter().filter_map(|new| new.from);
        let locals = self.locals.iter().filter_map(|new| new.from);
        are_indexes(parameters, header.params.len()) && are_indexes(locals, header.locals.len())
    }

    /// The names, parameters first.
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
    /// A parameter that the program has.
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

    /// It has another type, container or passing than `old`.
    pub(super) fn is_retyped(&self, old: &ParamDecl) -> bool {
        let shape = (self.container, self.by_reference);
        old.type_name != *self.type_name || shape != (old.container, old.by_reference)
    }
}

impl NewLocal {
    /// A local that the program has.
    pub(super) fn kept(index: usize, local: &LocalDecl) -> Self {
        let (name, type_name) = (local.name.to_string(), local.type_name.to_string());
        Self { from: Some(index), name, type_name, sizes: local.sizes.clone() }
    }

    /// It has another type or size than `old`.
    pub(super) fn is_retyped(&self, old: &LocalDecl) -> bool {
        old.type_name != *self.type_name || old.sizes != self.sizes
    }
}

/// Whether the container of a local can have sizes.
pub(super) fn has_sizes(local: &LocalDecl) -> bool {
    local.container != Container::Collection
}
