//! The tasks that a program creates, and what it does each time it runs.

use smol_str::SmolStr;
use val3_lang::tasks::period_steps;

use super::Callee;
use super::program::{Summary, callee};
use crate::body::{Body, Constant, ExprId, Stmt, StmtKind};
use crate::flow::{Flow, Point, PointKind};

/// A `taskCreate` or `taskCreateSync`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TaskStart {
    /// The name, where the code gives it.
    pub name: Option<SmolStr>,
    /// The known start of the name: all of it where `name` is known.
    pub beginning: SmolStr,
    /// The program.
    pub program: Callee,
    /// It is `taskCreateSync`.
    pub synchronous: bool,
    /// The period of a synchronous task in steps of [`PERIOD_STEP`](val3_lang::tasks::PERIOD_STEP), if it is constant.
    pub period: Option<u32>,
    /// The statement lies in a loop, so that it may create several tasks.
    pub repeated: bool,
    /// The program creates it each time it runs, unless it returns before.
    pub certain: bool,
}

/// The position of a statement among those around it.
#[derive(Clone, Copy)]
struct Nesting {
    repeated: bool,
    certain: bool,
}

impl TaskStart {
    /// The task in which the controller runs `program`.
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
    /// Adds the tasks that the program creates, and the calls it makes each time it runs.
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

/// No path reaches the end, judged by constant conditions alone.
pub(super) fn never_ends(body: &Body, flow: &Flow) -> bool {
    let is_taken = |point: &Point, branch: usize| match point.kind {
        PointKind::Test { condition: Some(condition), .. } => match body.constant(condition) {
            Some(Constant::Bool(value)) => branch == usize::from(!value),
            _ => true,
        },
        _ => true,
    };
    flow.reachable(is_taken).get(Flow::END.index()) == Some(&false)
}

fn is_true(body: &Body, condition: ExprId) -> bool {
    body.constant(condition) == Some(Constant::Bool(true))
}
