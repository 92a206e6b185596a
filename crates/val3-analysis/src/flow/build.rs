//! Construction of the control-flow graph from statements.

use rowan::TextRange;
use smallvec::{SmallVec, smallvec};

use super::{FlowGraph, FlowNode, FlowNodeId, PointKind};
use crate::body::{Body, ExprId, Stmt, StmtKind};

/// A node with an edge whose end does not exist yet.
type OpenEdge = FlowNodeId;
/// Several open edges.
type OpenEdges = SmallVec<[OpenEdge; 4]>;

/// Typical number of expressions for each flow node, in programs with short lines.
const EXPRESSIONS_A_POINT: usize = 4;

struct Builder<'b> {
    body: &'b Body,
    flow: FlowGraph,
    /// Nodes whose open edge will lead to the next node.
    loose: OpenEdges,
}

pub(super) fn build(body: &Body) -> FlowGraph {
    let points = Vec::with_capacity(body.len() / EXPRESSIONS_A_POINT + 2);
    let mut builder = Builder { body, flow: FlowGraph { points }, loose: OpenEdges::new() };
    let nowhere = TextRange::default();
    builder.add(PointKind::Start, nowhere);
    builder.add(PointKind::End, nowhere);
    builder.loose = smallvec![FlowGraph::START];
    builder.block(&body.block);
    builder.join(FlowGraph::END);
    builder.flow.points.shrink_to_fit();
    builder.flow
}

impl Builder<'_> {
    fn add(&mut self, kind: PointKind, range: TextRange) -> FlowNodeId {
        let id = FlowNodeId(u32::try_from(self.flow.points.len()).unwrap_or(u32::MAX));
        self.flow.points.push(FlowNode { kind, range, next: SmallVec::new() });
        id
    }

    /// Connects all open edges to `target`.
    fn join(&mut self, target: FlowNodeId) {
        for from in std::mem::take(&mut self.loose) {
            if let Some(point) = self.flow.points.get_mut(from.index()) {
                point.next.push(target);
            }
        }
    }

    /// Adds the next node and connects all open edges to it. The edge from the new node becomes the open edge.
    fn then(&mut self, kind: PointKind, range: TextRange) -> FlowNodeId {
        let id = self.add(kind, range);
        self.join(id);
        self.loose = smallvec![id];
        id
    }

    fn block(&mut self, block: &[Stmt]) {
        for stmt in block {
            self.stmt(stmt);
        }
    }

    fn stmt(&mut self, stmt: &Stmt) {
        let range = stmt.range;
        match &stmt.kind {
            StmtKind::If { arms, otherwise } => self.if_stmt(arms, otherwise.as_deref(), range),
            StmtKind::While { condition, block } => {
                let test = self.test(*condition, true, range);
                self.block(block);
                self.join(test);
                self.loose = smallvec![test];
            }
            StmtKind::Do { block, condition } => self.do_stmt(block, *condition, range),
            StmtKind::For { counter, start, stop, step, block } => {
                let kind = PointKind::ForStart { counter: *counter, start: *start, stop: *stop, step: *step };
                self.then(kind, range);
                let test = self.then(PointKind::ForTest { counter: *counter }, range);
                self.block(block);
                self.join(test);
                self.loose = smallvec![test];
            }
            StmtKind::Switch { selector, cases } => self.switch(*selector, cases, range),
            StmtKind::Return => {
                self.then(PointKind::Return, range);
                self.join(FlowGraph::END);
            }
            StmtKind::Call(id) => {
                self.then(PointKind::Call(*id), range);
            }
            StmtKind::TaskCreate { arguments, .. } => {
                self.then(PointKind::TaskCreate(arguments.clone()), range);
            }
            StmtKind::Print(id) => {
                self.then(PointKind::Print(*id), range);
            }
            StmtKind::Assign { target, value } => {
                self.then(PointKind::Assign { target: *target, value: *value }, range);
            }
            StmtKind::Expr(id) => {
                self.then(PointKind::Expr(*id), range);
            }
            StmtKind::Error => {
                self.then(PointKind::Unknown, range);
            }
        }
    }

    fn test(&mut self, condition: Option<ExprId>, is_loop: bool, stmt: TextRange) -> FlowNodeId {
        let range = condition.map_or(stmt, |id| self.body.range(id));
        self.then(PointKind::Test { condition, is_loop }, range)
    }

    fn if_stmt(&mut self, arms: &[(Option<ExprId>, Vec<Stmt>)], otherwise: Option<&[Stmt]>, range: TextRange) {
        let mut ends = OpenEdges::new();
        for (condition, block) in arms {
            let test = self.test(*condition, false, range);
            self.block(block);
            ends.append(&mut self.loose);
            // After an empty block, the test itself is the open end of its first branch; the first edge must be added
            // before the second.
            self.resolve_empty_block(&mut ends, test, range);
            self.loose = smallvec![test];
        }
        self.block(otherwise.unwrap_or(&[]));
        self.loose.append(&mut ends);
    }

    /// Adds a separate node for an empty block, so that the two edges of a test are in order.
    fn resolve_empty_block(&mut self, ends: &mut [OpenEdge], test: FlowNodeId, range: TextRange) {
        for end in ends.iter_mut().filter(|end| **end == test) {
            let empty = self.add(PointKind::Empty, TextRange::empty(range.end()));
            if let Some(point) = self.flow.points.get_mut(test.index()) {
                point.next.push(empty);
            }
            *end = empty;
        }
    }

    fn do_stmt(&mut self, block: &[Stmt], condition: Option<ExprId>, range: TextRange) {
        let first = FlowNodeId(u32::try_from(self.flow.points.len()).unwrap_or(u32::MAX));
        self.block(block);
        let test = self.test(condition, true, range);
        // `until` ends the loop if the condition is true. With an empty block, the test itself is the first node.
        let after = self.add(PointKind::Empty, TextRange::empty(range.end()));
        if let Some(point) = self.flow.points.get_mut(test.index()) {
            point.next.extend([after, first]);
        }
        self.loose = smallvec![after];
    }

    fn switch(&mut self, selector: Option<ExprId>, cases: &[(Vec<ExprId>, Vec<Stmt>)], range: TextRange) {
        let values = cases.iter().flat_map(|(values, _)| values).copied().collect();
        let switch = self.then(PointKind::Switch { selector, values }, range);
        let mut ends = OpenEdges::new();
        let mut has_default = false;
        for (values, block) in cases {
            has_default |= values.is_empty();
            self.loose = smallvec![switch];
            self.block(block);
            ends.append(&mut self.loose);
            self.resolve_empty_block(&mut ends, switch, range);
        }
        if !has_default {
            ends.push(switch);
        }
        self.loose = ends;
    }
}
