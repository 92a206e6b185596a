//! Control-flow graph: the order in which the lines of a program are executed.
//!
//! VAL 3 has no jump except `return`, so every loop has one entry and one exit. Evaluation within a line is not split:
//! a flow node is a line as the scheduler counts it, or a test that branches.

mod build;
mod per_point;
mod solve;

pub use per_point::PerPoint;
pub use solve::{Facts, backward, forward};

use rowan::TextRange;
use smallvec::SmallVec;

use crate::body::{ExprId, body};
use crate::db::{Db, File};

/// Index of a flow node.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct FlowNodeId(u32);

/// Flow nodes of a program with their edges. The first node is the start, the second the end.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FlowGraph {
    points: Vec<FlowNode>,
}

/// A flow node: its operation, source range and successors.
#[derive(Debug, Clone, PartialEq)]
pub struct FlowNode {
    /// Operation of the node.
    pub kind: PointKind,
    /// Source range: for the test of a block the range of the condition, or of the statement if the condition is
    /// missing.
    pub range: TextRange,
    /// Successors. A test has two: first the successor if true, then the successor if false.
    pub next: SmallVec<[FlowNodeId; 2]>,
}

/// Operation of a flow node.
#[derive(Debug, Clone, PartialEq)]
pub enum PointKind {
    /// Before the first line.
    Start,
    /// After the last line; the target of every `return`.
    End,
    /// `if`, `elseIf`, `while`, `until`: branches by the condition.
    Test {
        /// Condition; `None` if it could not be parsed.
        condition: Option<ExprId>,
        /// Whether the condition repeats a block.
        is_loop: bool,
    },
    /// `for`: sets the counter to its first value and computes the bounds.
    ForStart {
        /// The counter.
        counter: Option<ExprId>,
        /// The value after `=`.
        start: Option<ExprId>,
        /// The value after `to`.
        stop: Option<ExprId>,
        /// The value after `step`.
        step: Option<ExprId>,
    },
    /// `for` before each iteration: continues with the block, or after `endFor`.
    ForTest {
        /// Counter, which is incremented.
        counter: Option<ExprId>,
    },
    /// `switch`: compares with each `case` in turn, then continues with `default` or after `endSwitch`.
    Switch {
        /// The value that is compared.
        selector: Option<ExprId>,
        /// Values of all `case` lines, in the order of comparison.
        values: Vec<ExprId>,
    },
    /// `return`
    Return,
    /// `call program(…)`
    Call(ExprId),
    /// `taskCreate` or `taskCreateSync`
    TaskCreate(Vec<ExprId>),
    /// `? expression`
    Print(ExprId),
    /// `target = value`
    Assign {
        /// The left side.
        target: ExprId,
        /// The right side.
        value: ExprId,
    },
    /// An expression as a statement.
    Expr(ExprId),
    /// No operation: an empty block, or the exit of a loop.
    Empty,
    /// A line with a syntax error.
    Unknown,
}

impl PointKind {
    /// Returns the outermost expressions of the node in the order of evaluation.
    pub fn exprs(&self) -> impl Iterator<Item = ExprId> {
        let (few, many): ([Option<ExprId>; 4], &[ExprId]) = match self {
            Self::Test { condition: one, .. } | Self::ForTest { counter: one } => ([*one, None, None, None], &[]),
            Self::ForStart { counter, start, stop, step } => ([*start, *stop, *step, *counter], &[]),
            Self::Switch { selector, values } => ([*selector, None, None, None], values),
            Self::Call(id) | Self::Print(id) | Self::Expr(id) => ([Some(*id), None, None, None], &[]),
            Self::TaskCreate(arguments) => ([None; 4], arguments),
            Self::Assign { target, value } => ([Some(*value), Some(*target), None, None], &[]),
            Self::Start | Self::End | Self::Return | Self::Empty | Self::Unknown => ([None; 4], &[]),
        };
        few.into_iter().flatten().chain(many.iter().copied())
    }
}

/// Returns the control-flow graph of the program in `file`.
#[salsa::tracked(lru = 256, no_eq)]
pub fn flow(db: &dyn Db, file: File) -> FlowGraph {
    build::build(body(db, file))
}

impl FlowGraph {
    /// Node before the first line.
    pub const START: FlowNodeId = FlowNodeId(0);
    /// Node after the last line.
    pub const END: FlowNodeId = FlowNodeId(1);

    /// Returns a flow node.
    pub fn point(&self, id: FlowNodeId) -> Option<&FlowNode> {
        self.points.get(id.index())
    }

    /// Returns all flow nodes: start, end, then the rest in source order.
    pub fn points(&self) -> impl Iterator<Item = (FlowNodeId, &FlowNode)> {
        (0u32..).map(FlowNodeId).zip(&self.points)
    }

    /// Returns the number of flow nodes.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// Whether the graph has no node, which is the case only for a default graph.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// Returns for each flow node whether it is reachable from the start. Edges for which `is_taken` (node, branch
    /// index) is false are ignored.
    pub fn reachable(&self, is_taken: impl Fn(&FlowNode, usize) -> bool) -> Vec<bool> {
        let mut reached = vec![false; self.points.len()];
        let mut open = vec![Self::START];
        while let Some(id) = open.pop() {
            let Some(slot) = reached.get_mut(id.index()).filter(|slot| !**slot) else { continue };
            *slot = true;
            let Some(point) = self.point(id) else { continue };
            open.extend(
                point.next.iter().enumerate().filter(|(branch, _)| is_taken(point, *branch)).map(|(_, to)| *to),
            );
        }
        reached
    }
}

impl FlowNodeId {
    /// Returns the index of the node in [`FlowGraph::points`].
    pub fn index(self) -> usize {
        self.0 as usize
    }
}
