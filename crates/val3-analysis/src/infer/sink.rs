//! The sink for problems found in one body.

use rowan::TextRange;
use smol_str::SmolStr;

use crate::body::{Body, ExprId};
use crate::db::{Db, File, FileRange, Project};
use crate::problem::{Problem, ProblemKind, Related, Role};
use crate::resizing::is_resized;

/// Collects the problems of one body while it is walked.
pub(super) struct Sink<'db> {
    file: File,
    body: &'db Body,
    faults: Faults,
}

/// The problems of one body.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct Faults {
    problems: Vec<Problem>,
    overflows: Vec<Overflow>,
}

/// A constant index beyond the initial size of an array. It is wrong only if no program of the project changes that size.
/// Reading the other programs here would make every body depend on all of them.
#[derive(Debug, Clone, PartialEq)]
struct Overflow {
    data: SmolStr,
    problem: Problem,
}

impl<'db> Sink<'db> {
    pub(super) fn new(file: File, body: &'db Body) -> Self {
        Self { file, body, faults: Faults::default() }
    }

    /// Reports a fault at an expression, with the declaration that it is about.
    pub(super) fn report_with(&mut self, id: ExprId, kind: ProblemKind, role: Role, declared: Option<FileRange>) {
        self.report(self.body.range(id), kind, declared.map(|place| Related { place, role }));
    }

    pub(super) fn report(&mut self, range: TextRange, kind: ProblemKind, related: Option<Related>) {
        // A missing name is one mistake, however often the program uses it.
        if kind.is_about_missing_name() && self.faults.problems.iter().any(|problem| problem.kind == kind) {
            return;
        }
        let problem = self.problem(range, kind, related);
        self.faults.problems.push(problem);
    }

    /// Reports an index beyond the initial size of `data`, unless the project resizes it.
    pub(super) fn report_unless_resized(&mut self, id: ExprId, data: SmolStr, kind: ProblemKind) {
        let problem = self.problem(self.body.range(id), kind, None);
        self.faults.overflows.push(Overflow { data, problem });
    }

    fn problem(&self, range: TextRange, kind: ProblemKind, related: Option<Related>) -> Problem {
        Problem { kind, place: FileRange { file: self.file, range }, related: related.into_iter().collect() }
    }

    /// The number of problems so far, for [`Sink::retract_to`].
    pub(super) fn len(&self) -> usize {
        self.faults.problems.len()
    }

    /// Forgets all but the first `len` problems.
    pub(super) fn retract_to(&mut self, len: usize) {
        self.faults.problems.truncate(len);
    }

    /// A problem within `range` was reported.
    pub(super) fn has_any_in(&self, range: TextRange) -> bool {
        self.faults.problems.iter().any(|problem| range.contains_range(problem.place.range))
    }

    pub(super) fn finish(self) -> Faults {
        self.faults
    }
}

impl Faults {
    /// The problems by position, without the indexes that a change of size makes valid.
    pub(super) fn lasting(&self, db: &dyn Db, project: Project) -> Vec<Problem> {
        let overflows = self.overflows.iter().filter(|overflow| !is_resized(db, project, &overflow.data));
        let overflows = overflows.map(|overflow| &overflow.problem);
        let mut problems: Vec<Problem> = self.problems.iter().chain(overflows).cloned().collect();
        problems.sort_by_key(|problem| problem.place.range.start());
        problems
    }
}
