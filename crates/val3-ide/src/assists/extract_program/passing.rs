//! Passing of variables between the original and the extracted program.

use std::collections::{BTreeMap, BTreeSet};

use smol_str::SmolStr;
use val3_analysis::effects::{Access, AccessKind, Effects, RootVariable};
use val3_analysis::flow::{Facts, FlowGraph, FlowNode, FlowNodeId, backward, flow};
use val3_lang::types::{BaseType, Container};
use val3_syntax::TextRange;

use super::super::context::Context;
use super::super::evaluation::is_loop;
use crate::declare::NewVariable;

/// Passing of a variable to the extracted program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Passing {
    Value,
    Reference,
    /// Not passed: only the extracted statements use it, so it becomes a local there.
    Inside,
    /// Not passed: its value is neither read before it is written nor used afterwards, so both programs have their own
    /// local.
    Apart,
}

impl Passing {
    /// Whether the variable becomes a local of the extracted program.
    pub(super) fn is_local(self) -> bool {
        matches!(self, Self::Inside | Self::Apart)
    }
}

/// A local or parameter that the extracted program uses.
pub(super) struct PassedVariable {
    pub(super) variable: NewVariable,
    pub(super) passing: Passing,
}

type VariableNames = BTreeSet<SmolStr>;

/// Locals and parameters that the statements in `range` use, by name.
pub(super) fn variables(context: &Context<'_>, range: TextRange) -> Vec<PassedVariable> {
    let effects = Effects::new(context.db, context.project, context.file);
    let mut uses: BTreeMap<SmolStr, Vec<&Access>> = BTreeMap::new();
    for access in effects.all() {
        if let Some(name) = own(access) {
            uses.entry(name.clone()).or_default().push(access);
        }
    }
    let living = LiveVariables::around(context, &effects, range);
    uses.into_iter().filter_map(|(name, uses)| passed(context, range, &living, &name, &uses)).collect()
}

/// The accessed local or parameter; `None` for other data.
fn own(access: &Access) -> Option<&SmolStr> {
    match &access.root {
        RootVariable::Local(name) | RootVariable::Param(name) => Some(name),
        _ => None,
    }
}

fn passed(
    context: &Context<'_>,
    range: TextRange,
    living: &LiveVariables,
    name: &SmolStr,
    uses: &[&Access],
) -> Option<PassedVariable> {
    let inside = uses.iter().filter(|access| range.contains_range(context.body().range(access.id)));
    let inside: Vec<&&Access> = inside.collect();
    if inside.is_empty() {
        return None;
    }
    let written = inside.iter().any(|access| access.kind != AccessKind::Read);
    let (goes_in, comes_out) = (living.before.contains(name), written && living.after.contains(name));
    let (variable, is_local) = declared(context, name)?;
    // Inside a loop, the next iteration would read the value.
    let alone = is_local && inside.len() == uses.len() && !(goes_in && is_in_loop(context, range));
    let passing = match (alone, goes_in, comes_out) {
        (true, ..) => Passing::Inside,
        (_, false, false) if is_local => Passing::Apart,
        (.., true) => Passing::Reference,
        _ if is_whole(&variable) => Passing::Reference,
        _ => Passing::Value,
    };
    Some(PassedVariable { variable, passing })
}

/// Declaration of a local or parameter; the second value is true for a local.
fn declared(context: &Context<'_>, name: &str) -> Option<(NewVariable, bool)> {
    let header = context.header();
    let name = name.to_owned();
    if let Some(local) = header.locals.iter().find(|local| local.name == name) {
        let (type_name, container, sizes) = (local.type_name.to_string(), local.container, local.sizes.clone());
        return Some((NewVariable { name, type_name, container, sizes }, true));
    }
    let param = header.params.iter().find(|param| param.name == name)?;
    // A parameter of the old dialect may be an array, so it is passed unchanged.
    let sizes = match param.container {
        Container::Array { dims } => vec![2; usize::from(dims)],
        _ => vec![1],
    };
    let (type_name, container) = (param.type_name.to_string(), param.container);
    Some((NewVariable { name, type_name, container, sizes }, false))
}

/// Whether the variable must be passed by reference. Arrays and collections always are, and inputs, outputs and serial
/// lines have no meaning without their link.
fn is_whole(variable: &NewVariable) -> bool {
    let is_array = variable.container == Container::Collection || !matches!(variable.sizes.as_slice(), [] | [1]);
    is_array || BaseType::from_name(&variable.type_name).is_some_and(BaseType::is_linkable)
}

/// Whether the statements are inside a loop of the program.
fn is_in_loop(context: &Context<'_>, range: TextRange) -> bool {
    let stmts = context.body().stmts();
    stmts.iter().any(|stmt| is_loop(stmt) && stmt.range.contains_range(range) && stmt.range != range)
}

/// Whether the node is code in the range.
fn is_inside(range: TextRange, point: &FlowNode) -> bool {
    range.contains_range(point.range) && !point.range.is_empty()
}

/// Adds the names of `other` to `names`. Returns whether a name was new.
fn add_names(names: &mut VariableNames, other: &VariableNames) -> bool {
    let len = names.len();
    names.extend(other.iter().cloned());
    names.len() > len
}

/// Live variables: their values are used later.
struct LiveVariables {
    /// Live where the statements start.
    before: VariableNames,
    /// Live where the statements end.
    after: VariableNames,
}

impl LiveVariables {
    fn around(context: &Context<'_>, effects: &Effects<'_>, range: TextRange) -> Self {
        let flow = flow(context.db, context.file);
        let referenced = context.header().params.iter().filter(|param| param.by_reference);
        let end: VariableNames = referenced.map(|param| param.name.clone()).collect();
        let step = |id: FlowNodeId, _: &FlowNode, after: &VariableNames| before(effects, id, after);
        let facts = backward(flow, end, step, add_names);
        let mut inside = flow.points().filter(|(_, point)| is_inside(range, point)).peekable();
        let entry = inside.peek().map(|(id, _)| *id);
        let exits = inside.flat_map(|(_, point)| &point.next);
        let exits = exits.filter(|next| flow.point(**next).is_some_and(|point| !is_inside(range, point)));
        Self {
            before: entry.map(|id| at(context, effects, &facts, id)).unwrap_or_default(),
            after: exits.flat_map(|id| at(context, effects, &facts, *id)).collect(),
        }
    }
}

/// Variables live at a flow node; all variables if no path leads from it to the end.
fn at(context: &Context<'_>, effects: &Effects<'_>, facts: &Facts<VariableNames>, id: FlowNodeId) -> VariableNames {
    let header = context.header();
    let all = || header.locals.iter().map(|it| &it.name).chain(header.params.iter().map(|it| &it.name));
    match facts.after(id) {
        Some(after) if id != FlowGraph::END => before(effects, id, after),
        Some(end) => end.clone(),
        None => all().cloned().collect(),
    }
}

/// Variables live before a flow node, computed from the variables live after it (backward analysis).
fn before(effects: &Effects<'_>, id: FlowNodeId, after: &VariableNames) -> VariableNames {
    let mut names = after.clone();
    for access in effects.at(id).iter().rev() {
        let Some(name) = own(access) else { continue };
        match access.kind {
            AccessKind::Write => drop(names.remove(name)),
            AccessKind::Read | AccessKind::Reference => drop(names.insert(name.clone())),
            AccessKind::WritePart => {}
        }
    }
    names
}
