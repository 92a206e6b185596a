//! The effects of one program, without ranges.

use rustc_hash::{FxHashMap, FxHashSet};
use smol_str::SmolStr;
use val3_lang::instructions::{GET_DATA, SET_MUTEX, TASK_KILL, TASK_STATUS, shows_named_page};
use val3_lang::motion::{MotionRole, role};

use super::task_starts::{TaskStart, never_ends};
use super::{Callee, locks};
use crate::body::{Body, Expr, ExprId, body};
use crate::db::{Db, File, Project};
use crate::effects::{AccessKind, Effects, Root};
use crate::flow::{PointKind, flow};
use crate::infer::{self, InstructionCall};
use crate::items::faults::text_faults;
use crate::items::program::header;
use crate::problem::ProblemKind;

/// The effects of a program.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Summary {
    /// The text could be read, and the analysis found no fault in its code.
    pub sound: bool,
    /// Programs that it calls.
    pub calls: FxHashSet<Callee>,
    /// Programs of the own project that it calls each time it runs, unless it returns before.
    pub certain_calls: FxHashSet<SmolStr>,
    /// Tasks that it creates, in the order of the text.
    pub tasks: Vec<TaskStart>,
    /// How the names begin of tasks that it ends, or whose state it asks for.
    pub managed_tasks: FxHashSet<SmolStr>,
    /// Once called it runs for good.
    pub never_ends: bool,
    /// Global data that it uses.
    pub data: FxHashMap<SmolStr, Use>,
    /// How the names begin of data that it reads by name, as a text.
    pub named_in_texts: FxHashSet<SmolStr>,
    /// Library identifiers that occur in its code.
    pub libraries: FxHashSet<SmolStr>,
    /// Flags that it tests on one line and sets on the next.
    pub locks: FxHashSet<SmolStr>,
    /// It takes a flag with `setMutex`.
    pub takes_mutex: bool,
    /// It calls `restartMove`: a stopped arm continues.
    pub restarts_arm: bool,
    /// It shows a user page (s8) by its name.
    pub shows_page: bool,
    /// One of its own lines may let the other tasks run: it waits, or reads or writes a serial line (5.4), or calls
    /// a program of a library, of which nothing is known.
    pub waits: bool,
}

/// How a program uses a variable.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Use {
    /// It reads the value.
    pub read: bool,
    /// It writes the value or a part of it.
    pub written: bool,
    /// It hands the variable over by reference.
    pub referenced: bool,
    /// It reads the value as a whole: all fields on one line.
    pub read_whole: bool,
    /// It writes fields of the value on several lines.
    pub written_in_parts: bool,
}

impl Use {
    /// Takes in one more use.
    pub fn add(&mut self, kind: AccessKind) {
        match kind {
            AccessKind::Read => self.read = true,
            AccessKind::Write | AccessKind::WritePart => self.written = true,
            AccessKind::Reference => self.referenced = true,
        }
    }

    /// It may change the value.
    pub fn may_write(self) -> bool {
        self.written || self.referenced
    }

    /// It may use the value.
    pub fn may_read(self) -> bool {
        self.read || self.referenced
    }
}

/// The effects of the program in `file` as a part of `project`.
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
        restarts_arm: calls.iter().any(|call| role(call.instruction) == Some(MotionRole::Restart)),
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
    // The effect of an instruction of an add-on is unknown.
    summary.waits = effects.may_wait() || !infer::problems(db, project, file).is_empty();
    for access in effects.all() {
        if let Root::Data(name) = &access.root {
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

/// The fault leaves no name in doubt: what an instruction of an add-on does to variables is taken to be anything.
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

/// How the text begins that is the first argument.
fn first_argument_text(body: &Body, call: &InstructionCall) -> Option<SmolStr> {
    let Expr::Call(_, arguments) = body.expr(call.id) else { return None };
    arguments.first().map(|text| body.beginning(*text))
}

/// Instructions that end a task, or that look whether it has ended.
const TENDING: [&str; 2] = [TASK_KILL, TASK_STATUS];

/// The program that a call names.
pub(super) fn callee(body: &Body, call: ExprId) -> Option<Callee> {
    let Expr::Call(callee, _) = body.expr(call) else { return None };
    match body.expr(*callee) {
        Expr::Name(name) => Some(Callee { library: None, program: name.clone() }),
        Expr::Path { library, item } => Some(Callee { library: Some(library.clone()), program: item.clone() }),
        _ => None,
    }
}
