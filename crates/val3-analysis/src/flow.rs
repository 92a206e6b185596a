//! The order in which the lines of a program run: a control-flow graph.
//!
//! VAL 3 has no jump but `return`, so every loop is entered at one point and left at one. Evaluation within a line is
//! not split: a point is what the scheduler counts as a line, plus the tests that branch.

mod build;
mod per_point;
mod solve;

pub use per_point::PerPoint;
pub use solve::{Facts, backward, forward};

use rowan::TextRange;
use smallvec::SmallVec;

use crate::body::{ExprId, body};
use crate::db::{Db, File};

/// The number of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PointId(u32);

/// The points of one program and the ways between them. The first is the start, the second the end.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Flow {
    points: Vec<Point>,
}

/// A point of the control flow: its operation, its place and its successors.
#[derive(Debug, Clone, PartialEq)]
pub struct Point {
    /// The operation.
    pub kind: PointKind,
    /// Its place: for the test of a block the condition, or the keyword's statement if there is none.
    pub range: TextRange,
    /// The points that may follow. Of a test: where it is true, then where it is false.
    pub next: SmallVec<[PointId; 2]>,
}

/// The operation at a point.
#[derive(Debug, Clone, PartialEq)]
pub enum PointKind {
    /// Before the first line.
    Start,
    /// After the last line, and where every `return` leads.
    End,
    /// `if`, `elseIf`, `while`, `until`: continues at the branch that the condition selects.
    Test {
        /// The condition; `None` where it could not be read.
        condition: Option<ExprId>,
        /// The condition repeats a block.
        is_loop: bool,
    },
    /// `for`: the counter gets its first value, the bounds are computed.
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
    /// `for` before each round: the block, or what follows `endFor`.
    ForTest {
        /// The counter, which grows.
        counter: Option<ExprId>,
    },
    /// `switch`: each `case` in turn, then `default` or what follows.
    Switch {
        /// The value that is compared.
        selector: Option<ExprId>,
        /// The values of every `case`, which are compared in turn.
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
    /// An expression alone.
    Expr(ExprId),
    /// Nothing: the way through an empty block, or past the end of a loop.
    Empty,
    /// A line that could not be read.
    Unknown,
}

impl PointKind {
    /// The outermost expressions of the point, in the order in which they are evaluated.
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

/// The control-flow graph of the program in `file`.
#[salsa::tracked(lru = 256, no_eq)]
pub fn flow(db: &dyn Db, file: File) -> Flow {
    build::build(body(db, file))
}

impl Flow {
    /// Before the first line.
    pub const START: PointId = PointId(0);
    /// After the last line.
    pub const END: PointId = PointId(1);

    /// A point.
    pub fn point(&self, id: PointId) -> Option<&Point> {
        self.points.get(id.index())
    }

    /// Every point in the order of the text; start and end come first.
    pub fn points(&self) -> impl Iterator<Item = (PointId, &Point)> {
        (0u32..).map(PointId).zip(&self.points)
    }

    /// The number of points.
    pub fn len(&self) -> usize {
        self.points.len()
    }

    /// There is no point, which is so only of a graph that was not built.
    pub fn is_empty(&self) -> bool {
        self.points.is_empty()
    }

    /// For every point, whether some way leads there from the start. A way that the test `is_taken` rules out (point,
    /// index of the branch) leads nowhere.
    pub fn reachable(&self, is_taken: impl Fn(&Point, usize) -> bool) -> Vec<bool> {
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

impl PointId {
    /// The place of the point among all.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}
