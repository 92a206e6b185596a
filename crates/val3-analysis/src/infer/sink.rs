//! Collection of the problems in one body.

use rowan::TextRange;
use smol_str::SmolStr;

use crate::body::{Body, ExprId};
use crate::db::{Db, File, FileRange, Project};
use crate::problem::{Problem, ProblemKind, Related, RelatedRole};
use crate::resizing::is_resized;

/// Collects the problems in a body during inference.
pub(super) struct Sink<'db> {
    file: File,
    body: &'db Body,
    faults: BodyProblems,
}

/// Problems in a body.
#[derive(Debug, Clone, PartialEq, Default)]
pub(super) struct BodyProblems {
    problems: Vec<Problem>,
    overflows: Vec<Overflow>,
}

/// A constant index above an array's initial size. It is a fault only if no program of the project changes that size,
/// which is checked later: reading the other programs during inference would make every body depend on all programs.
#[derive(Debug, Clone, PartialEq)]
struct Overflow {
    data: SmolStr,
    problem: Problem,
}

impl<'db> Sink<'db> {
    pub(super) fn new(file: File, body: &'db Body) -> Self {
        Self { file, body, faults: BodyProblems::default() }
    }

    /// Reports a fault at an expression, with a related declaration.
    pub(super) fn report_with(
        &mut self,
        id: ExprId,
        kind: ProblemKind,
        role: RelatedRole,
        declared: Option<FileRange>,
    ) {
        self.report(self.body.range(id), kind, declared.map(|place| Related { place, role }));
    }

    pub(super) fn report(&mut self, range: TextRange, kind: ProblemKind, related: Option<Related>) {
        // A missing name is reported once for a program, at its first use.
        if kind.is_about_missing_name() && self.faults.problems.iter().any(|problem| problem.kind == kind) {
            return;
        }
        let problem = self.problem(range, kind, related);
        self.faults.problems.push(problem);
    }

    /// Reports an index above the initial size of `data`, unless the project resizes the array.
    pub(super) fn report_unless_resized(&mut self, id: ExprId, data: SmolStr, kind: ProblemKind) {
        let problem = self.problem(self.body.range(id), kind, None);
        self.faults.overflows.push(Overflow { data, problem });
    }

    fn problem(&self, range: TextRange, kind: ProblemKind, related: Option<Related>) -> Problem {
        Problem { kind, place: FileRange { file: self.file, range }, related: related.into_iter().collect() }
    }

    /// Returns the number of problems so far.
    pub(super) fn len(&self) -> usize {
        self.faults.problems.len()
    }

    /// Whether a problem within `range` was reported.
    pub(super) fn has_any_in(&self, range: TextRange) -> bool {
        self.faults.problems.iter().any(|problem| range.contains_range(problem.place.range))
    }

    pub(super) fn finish(self) -> BodyProblems {
        self.faults
    }
}

impl BodyProblems {
    /// Returns the problems sorted by position, without index problems of arrays that the project resizes.
    pub(super) fn lasting(&self, db: &dyn Db, project: Project) -> Vec<Problem> {
        let overflows = self.overflows.iter().filter(|overflow| !is_resized(db, project, &overflow.data));
        let overflows = overflows.map(|overflow| &overflow.problem);
        let mut problems: Vec<Problem> = self.problems.iter().chain(overflows).cloned().collect();
        problems.sort_by_key(|problem| problem.place.range.start());
        problems
    }
}
