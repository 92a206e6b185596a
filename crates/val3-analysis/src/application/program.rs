//! Summary of a program's effects, without ranges.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use val3_lang::instructions::{GET_DATA, SET_MUTEX, TASK_KILL, TASK_STATUS, shows_named_page};
use val3_lang::motion::MotionRole;

use super::task_starts::{TaskStart, never_ends};
use super::{Callee, locks};
use crate::body::{Body, Expr, ExprId, body};
use crate::db::{Db, File, Project};
use crate::effects::{AccessKind, Effects, RootVariable};
use crate::flow::{PointKind, flow};
use crate::infer::{self, InstructionCall};
use crate::items::faults::text_faults;
use crate::items::program::header;
use crate::problem::ProblemKind;

/// Effects of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Summary {
    /// Whether the file is readable and the analysis found no fault in the code.
    pub sound: bool,
    /// Called programs.
    pub calls: FxHashSet<Callee>,
    /// Programs of the same project that every execution without an early `return` calls.
    pub certain_calls: FxHashSet<SmolStr>,
    /// Created tasks in source order.
    pub tasks: Vec<TaskStart>,
    /// Name prefixes of tasks that the program kills or whose status it reads.
    pub managed_tasks: FxHashSet<SmolStr>,
    /// Whether the program never returns.
    pub never_ends: bool,
    /// Used global data.
    pub data: FxHashMap<SmolStr, Use>,
    /// Name prefixes of data that the program accesses by a name in a string.
    pub named_in_texts: FxHashSet<SmolStr>,
    /// Library identifiers that occur in the code.
    pub libraries: FxHashSet<SmolStr>,
    /// Flags that the program tests on one line and sets on the next.
    pub locks: FxHashSet<SmolStr>,
    /// Whether the program locks a flag with `setMutex`.
    pub takes_mutex: bool,
    /// Whether the program calls `restartMove`, so that a stopped arm continues.
    pub restarts_arm: bool,
    /// Whether the program shows a user page (s8) by name.
    pub shows_page: bool,
    /// Whether the program's own lines may let other tasks run: a line waits, accesses a serial line (5.4), or calls a
    /// library program, whose code is unknown.
    pub waits: bool,
}

impl Summary {
    /// Whether the program's own code may wait: it waits, has faults, or calls a program without a summary.
    pub(super) fn may_wait_directly(&self, summaries: &FxHashMap<&SmolStr, &Summary>) -> bool {
        let mut callees = self.calls.iter().filter(|callee| callee.library.is_none());
        self.waits || !self.sound || callees.any(|callee| !summaries.contains_key(&callee.program))
    }

    /// Whether the program calls a program with this name, in any project.
    pub(super) fn calls_program(&self, name: &SmolStr) -> bool {
        self.calls.iter().any(|callee| callee.program == *name)
    }
}

/// Uses of a variable by a program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Use {
    /// Whether the value is read.
    pub read: bool,
    /// Whether the value or a part of it is written.
    pub written: bool,
    /// Whether the variable is passed by reference.
    pub referenced: bool,
    /// Whether all fields of the value are read on one line.
    pub read_whole: bool,
    /// Whether fields of the value are written on several lines.
    pub written_in_parts: bool,
}

impl Use {
    /// Adds one use.
    pub fn add(&mut self, kind: AccessKind) {
        match kind {
            AccessKind::Read => self.read = true,
            AccessKind::Write | AccessKind::WritePart => self.written = true,
            AccessKind::Reference => self.referenced = true,
        }
    }

    /// Whether the use may change the value.
    pub fn may_write(self) -> bool {
        self.written || self.referenced
    }

    /// Whether the use may read the value.
    pub fn may_read(self) -> bool {
        self.read || self.referenced
    }
}

/// Returns the effects of the program in `file` as a part of `project`.
#[salsa::tracked]
pub fn summary(db: &dyn Db, project: Project, file: File) -> Summary {
    let body = body(db, file);
    let calls = infer::infer(db, project, file).calls();
    let calls_of = |name: &'static str| calls.iter().filter(move |call| call.instruction.name == name);
    let mut summary = Summary {
        sound: header(db, file).complete
            && text_faults(db, file).errors.is_empty()
            && infer::problems(db, project, file).iter().all(|problem| hides_nothing(&problem.kind)),
        libraries: libraries(body),
        restarts_arm: calls.iter().any(|call| call.instruction.role == Some(MotionRole::Restart)),
        takes_mutex: calls_of(SET_MUTEX).next().is_some(),
        shows_page: calls.iter().any(|call| call.form.is_some_and(|form| shows_named_page(call.instruction, form))),
        locks: locks(body).into_iter().map(|lock| lock.flag).collect(),
        managed_tasks: TENDING
            .into_iter()
            .flat_map(calls_of)
            .filter_map(|call| first_argument_text(body, call))
            .collect(),
        named_in_texts: calls_of(GET_DATA).filter_map(|call| first_argument_text(body, call)).collect(),
        ..Summary::default()
    };
    for (_, point) in flow(db, file).points() {
        if let PointKind::Call(id) = &point.kind {
            summary.calls.extend(callee(body, *id));
        }
    }
    summary.add_tasks(body);
    summary.never_ends = never_ends(body, flow(db, file));
    let effects = Effects::new(db, project, file);
    // The effects of add-on instructions are unknown.
    summary.waits = effects.may_wait() || !infer::problems(db, project, file).is_empty();
    for access in effects.all() {
        if let RootVariable::Data(name) = &access.root {
            let is_part = matches!(body.expr(access.id), Expr::Field { .. });
            let uses = summary.data.entry(name.clone()).or_default();
            uses.read_whole |= access.kind == AccessKind::Read && !is_part;
            let again = uses.written;
            uses.written_in_parts |= access.kind == AccessKind::WritePart && is_part && again;
            uses.add(access.kind);
        }
    }
    summary
}

/// Whether the names of a program are certain in spite of the fault: an add-on instruction is assumed to have any
/// effect on its variables.
fn hides_nothing(problem: &ProblemKind) -> bool {
    matches!(problem, ProblemKind::MissingAddOn { .. })
}

fn libraries(body: &Body) -> FxHashSet<SmolStr> {
    let named = body.exprs().filter_map(|(_, expr, _)| match expr {
        Expr::Path { library, .. } => Some(library.clone()),
        _ => None,
    });
    named.collect()
}

/// Returns the constant prefix of a call's first argument.
fn first_argument_text(body: &Body, call: &InstructionCall) -> Option<SmolStr> {
    let Expr::Call(_, arguments) = body.expr(call.id) else { return None };
    arguments.first().map(|text| body.beginning(*text))
}

/// Instructions that kill a task or read its status.
const TENDING: [&str; 2] = [TASK_KILL, TASK_STATUS];

/// Returns the program that a call names.
pub(super) fn callee(body: &Body, call: ExprId) -> Option<Callee> {
    let Expr::Call(callee, _) = body.expr(call) else { return None };
    match body.expr(*callee) {
        Expr::Name(name) => Some(Callee { library: None, program: name.clone() }),
        Expr::Path { library, item } => Some(Callee { library: Some(library.clone()), program: item.clone() }),
        _ => None,
    }
}
