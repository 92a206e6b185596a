//! Tasks that a program creates, and its unconditional calls.

use smol_str::SmolStr;
use val3_lang::tasks::period_steps;

use super::Callee;
use super::program::{Summary, callee};
use crate::body::{Body, Constant, ExprId, Stmt, StmtKind};
use crate::flow::{FlowGraph, FlowNode, PointKind};

/// A `taskCreate` or `taskCreateSync`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TaskStart {
    /// Task name, if it is constant.
    pub name: Option<SmolStr>,
    /// Constant prefix of the name: the entire name if `name` is known.
    pub beginning: SmolStr,
    /// Program of the task.
    pub program: Callee,
    /// Whether the instruction is `taskCreateSync`.
    pub synchronous: bool,
    /// Period of a synchronous task in steps of [`PERIOD_STEP`](val3_lang::tasks::PERIOD_STEP), if it is constant.
    pub period: Option<u32>,
    /// Whether the statement is in a loop, so that it may create several tasks.
    pub repeated: bool,
    /// Whether every execution of the program without an early `return` creates the task.
    pub certain: bool,
}

/// The loops and conditions around a statement.
#[derive(Clone, Copy)]
struct Nesting {
    repeated: bool,
    certain: bool,
}

impl TaskStart {
    /// Returns the task in which the controller runs `program`.
    pub(super) fn of_controller(program: &'static str) -> Self {
        let program = Callee { library: None, program: SmolStr::new_static(program) };
        Self {
            name: None,
            beginning: SmolStr::default(),
            program,
            synchronous: false,
            period: None,
            repeated: false,
            certain: true,
        }
    }
}

impl Nesting {
    const OUTSIDE: Self = Self { repeated: false, certain: true };

    fn within(self, body: &Body, stmt: &Stmt) -> Self {
        let repeats = matches!(stmt.kind, StmtKind::While { .. } | StmtKind::Do { .. } | StmtKind::For { .. });
        let runs = match stmt.kind {
            StmtKind::Do { .. } => true,
            StmtKind::While { condition: Some(condition), .. } => is_true(body, condition),
            _ => false,
        };
        Self { repeated: self.repeated || repeats, certain: self.certain && runs }
    }
}

impl Summary {
    /// Adds the created tasks and the unconditional calls.
    pub(super) fn add_tasks(&mut self, body: &Body) {
        self.add_block(body, &body.block, Nesting::OUTSIDE);
    }

    fn add_block(&mut self, body: &Body, block: &[Stmt], nesting: Nesting) {
        for stmt in block {
            match &stmt.kind {
                StmtKind::TaskCreate { synchronous, arguments } => {
                    self.tasks.extend(task_start(body, *synchronous, arguments, nesting));
                }
                StmtKind::Call(call) if nesting.certain => {
                    let own = callee(body, *call).filter(|callee| callee.library.is_none());
                    self.certain_calls.extend(own.map(|callee| callee.program));
                }
                _ => {}
            }
            let inside = nesting.within(body, stmt);
            stmt.blocks().for_each(|block| self.add_block(body, block, inside));
        }
    }
}

fn task_start(body: &Body, synchronous: bool, arguments: &[ExprId], nesting: Nesting) -> Option<TaskStart> {
    let program = callee(body, *arguments.last()?)?;
    let name = arguments.first()?;
    let (beginning, name) = (body.beginning(*name), body.string(*name));
    let seconds = arguments.get(1).filter(|_| synchronous).and_then(|pace| body.number(*pace));
    let period = seconds.and_then(period_steps);
    let Nesting { repeated, certain } = nesting;
    Some(TaskStart { name, beginning, program, synchronous, period, repeated, certain })
}

/// Whether no path reaches the end; only constant conditions are evaluated.
pub(super) fn never_ends(body: &Body, flow: &FlowGraph) -> bool {
    flow.reachable(|point, branch| may_take(body, point, branch)).get(FlowGraph::END.index()) == Some(&false)
}

/// Whether the condition of `point`, if it is constant, leads to `branch`.
fn may_take(body: &Body, point: &FlowNode, branch: usize) -> bool {
    let PointKind::Test { condition: Some(condition), .. } = point.kind else { return true };
    match body.constant(condition) {
        Some(Constant::Bool(value)) => branch == usize::from(!value),
        _ => true,
    }
}

fn is_true(body: &Body, condition: ExprId) -> bool {
    body.constant(condition) == Some(Constant::Bool(true))
}
