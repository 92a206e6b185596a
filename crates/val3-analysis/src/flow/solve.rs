//! Data-flow analysis by iteration to a fixed point.
//!
//! Nodes are numbered in source order, so one pass in this order propagates facts from the start to the end. Only the
//! back edges of loops require further passes.

use smallvec::SmallVec;

use super::{FlowGraph, FlowNode, FlowNodeId};

/// Facts before each flow node; after each node for a backward problem.
#[derive(Debug, Clone, PartialEq)]
pub struct Facts<S>(Vec<Option<S>>);

impl<S> Facts<S> {
    /// Returns the facts before the node; `None` if it is unreachable.
    pub fn before(&self, point: FlowNodeId) -> Option<&S> {
        self.0.get(point.index())?.as_ref()
    }

    /// Returns the facts after the node, for a backward problem; `None` if no path from the node reaches the end.
    pub fn after(&self, point: FlowNodeId) -> Option<&S> {
        self.before(point)
    }
}

/// Solves a forward problem. `start` is the facts at the beginning, `step` computes the facts after a node from the
/// facts before it, and `join` merges the facts of another path and returns whether this changed the facts.
///
/// The iteration terminates if `join` is monotone over a lattice of finite height.
pub fn forward<S: Clone>(
    flow: &FlowGraph,
    start: S,
    step: impl FnMut(FlowNodeId, &FlowNode, &S) -> S,
    join: impl FnMut(&mut S, &S) -> bool,
) -> Facts<S> {
    let order: Vec<FlowNodeId> = flow.points().map(|(id, _)| id).collect();
    let next = |id: FlowNodeId| flow.point(id).map_or(&[][..], |point| point.next.as_slice());
    solve(flow, &order, next, FlowGraph::START, start, step, join)
}

/// Solves a backward problem. `end` is the facts at the end of the program, and `step` computes the facts before a node
/// from the facts after it. `join` is as in [`forward`].
pub fn backward<S: Clone>(
    flow: &FlowGraph,
    end: S,
    step: impl FnMut(FlowNodeId, &FlowNode, &S) -> S,
    join: impl FnMut(&mut S, &S) -> bool,
) -> Facts<S> {
    let mut order: Vec<FlowNodeId> = flow.points().map(|(id, _)| id).collect();
    // The end node is the second node: it is moved to the front, followed by the nodes from the last line upwards.
    order.reverse();
    order.sort_by_key(|id| *id != FlowGraph::END);
    let mut previous: Vec<SmallVec<[FlowNodeId; 2]>> = vec![SmallVec::new(); flow.len()];
    for (id, point) in flow.points() {
        for next in &point.next {
            previous.get_mut(next.index()).into_iter().for_each(|list| list.push(id));
        }
    }
    let next = |id: FlowNodeId| previous.get(id.index()).map_or(&[][..], SmallVec::as_slice);
    solve(flow, &order, next, FlowGraph::END, end, step, join)
}

fn solve<'f, S: Clone>(
    flow: &FlowGraph,
    order: &[FlowNodeId],
    next: impl Fn(FlowNodeId) -> &'f [FlowNodeId],
    first: FlowNodeId,
    holds: S,
    mut step: impl FnMut(FlowNodeId, &FlowNode, &S) -> S,
    mut join: impl FnMut(&mut S, &S) -> bool,
) -> Facts<S> {
    let mut facts: Vec<Option<S>> = vec![None; flow.len()];
    let mut is_open = vec![false; flow.len()];
    if let (Some(fact), Some(open)) = (facts.get_mut(first.index()), is_open.get_mut(first.index())) {
        (*fact, *open) = (Some(holds), true);
    }
    while is_open.contains(&true) {
        for id in order {
            let Some(open) = is_open.get_mut(id.index()).filter(|open| **open) else { continue };
            *open = false;
            let (Some(point), Some(Some(fact))) = (flow.point(*id), facts.get(id.index())) else { continue };
            let after = step(*id, point, fact);
            for to in next(*id) {
                let (Some(fact), Some(open)) = (facts.get_mut(to.index()), is_open.get_mut(to.index())) else {
                    continue;
                };
                *open |= match fact {
                    Some(known) => join(known, &after),
                    None => {
                        *fact = Some(after.clone());
                        true
                    }
                };
            }
        }
    }
    Facts(facts)
}
