//! Execution of single tests, with the original programs or with a mistake.

use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use camino::{Utf8Path, Utf8PathBuf};
use val3_coverage::Coverage;
use val3_lang::ports::Time;
use val3_machine::sio::SocketGuard;
use val3_suite::{
    ControllerKeys, FinalState, Supervision, TestKind, TestResult, TestSettings, counted, execute, executed,
};

use super::used_names::{self, UsedNames};
use crate::args::TestArgs;
use crate::test::discovery::{Opening, TestFile};
use crate::test::script_file::ScriptFile;
use crate::test::workers::{Bench, Surroundings};
use crate::test::{golden, golden_texts};
use crate::user_error::UserError;
use val3_session::CodeForm;

/// Default seed for the choice of mistakes.
pub(super) const SEED: u64 = 1;

/// Context shared by all test executions.
#[derive(Clone, Copy)]
pub(super) struct Conditions<'c> {
    pub(super) args: &'c TestArgs,
    pub(super) surroundings: &'c Surroundings<'c>,
    /// Flag that a signal sets.
    pub(super) is_interrupted: &'c AtomicBool,
}

/// Executor of tests, one at a time.
pub(super) struct Executor<'c> {
    conditions: Conditions<'c>,
    /// Program texts that replace the files on the disk, by path.
    edited: Vec<(Utf8PathBuf, Arc<str>)>,
    is_counted: bool,
    bench: Option<Bench>,
}

/// Execution of a test.
pub(super) struct Execution {
    pub(super) result: TestResult,
    /// State at the end.
    pub(super) state: FinalState,
    pub(super) coverage: Coverage,
    /// Variables that the test uses; empty if lines are not counted.
    pub(super) used: UsedNames,
    /// Timeout for each program of the test, on the controller's clock in nanoseconds.
    pub(super) limit: Time,
}

impl<'c> Executor<'c> {
    /// Creates an executor for the original programs, which counts their lines.
    pub(super) fn counting(conditions: Conditions<'c>) -> Self {
        Self { conditions, edited: Vec::new(), is_counted: true, bench: None }
    }

    /// Creates an executor that replaces the text of one program.
    pub(super) fn edited(conditions: Conditions<'c>, path: Utf8PathBuf, text: Arc<str>) -> Self {
        Self { conditions, edited: vec![(path, text)], is_counted: false, bench: None }
    }

    /// Executes a test. `limit` replaces the timeout of the test. `None` if a signal has ended the execution.
    ///
    /// # Errors
    /// The test file or the application cannot be used.
    pub(super) fn execute(&mut self, test: &TestFile<'_>, limit: Option<Time>) -> Result<Option<Execution>, UserError> {
        let args = self.conditions.args;
        let file = ScriptFile::of(test.case)?;
        let mut bench = self.bench(test.manifest, file.scenario.controller_keys())?;
        bench.prepare(&file)?;
        let of_test = file.scenario.limit().filter(|_| args.limit.is_none());
        let limit = limit.or(of_test).unwrap_or(bench.suite.settings.limit);
        let is_interrupted = self.conditions.is_interrupted;
        let supervision = Supervision {
            settings: TestSettings { limit },
            may_go_on: &|| !is_interrupted.load(Ordering::Relaxed),
            conditions: &mut |_, _| Vec::new(),
        };
        let skipped = file.scenario.skip().map(TestResult::skipped);
        let executed = skipped.or_else(|| execute(&mut bench.controller, test.case, &file.scenario, supervision));
        let Some(mut result) = executed else { return Ok(None) };
        let coverage = counted(&bench.controller, &bench.suite.application);
        let used = self.used(&bench, test);
        let state = FinalState::of(&bench.controller, &result);
        self.bench = Some(bench);
        golden_texts::judge_only(test.case, &mut result)?;
        golden::judge_only(test.case, &mut result)?;
        result.judge_known_failure();
        result.keep_last_events(args.events as usize);
        Ok(Some(Execution { result, state, coverage, used, limit }))
    }

    fn used(&self, bench: &Bench, test: &TestFile<'_>) -> UsedNames {
        if !self.is_counted {
            return UsedNames::default();
        }
        let is_scenario = test.case.kind == TestKind::Scenario;
        let scenario = is_scenario.then(|| used_names::text(&test.case.file)).flatten();
        UsedNames::of(&bench.suite.application, &executed(&bench.controller), scenario.as_deref())
    }

    /// Application on a controller. The controller of the previous test is used again if it suits the test.
    fn bench(&mut self, manifest: &Utf8Path, keys: &ControllerKeys) -> Result<Bench, UserError> {
        let is_same = |bench: &Bench| bench.suite.manifest == manifest && bench.keys == *keys;
        if let Some(bench) = self.bench.take().filter(|bench| is_same(bench) && !bench.has_connections()) {
            return Ok(bench);
        }
        let guard: Rc<dyn SocketGuard> = Rc::new(self.conditions.surroundings.sockets.clone());
        let form = if self.is_counted { CodeForm::Counted } else { CodeForm::Plain };
        let opening = Opening { form, edited: &self.edited, ..Opening::of(self.conditions.args) };
        Bench::open(opening, manifest, keys, guard)
    }
}
