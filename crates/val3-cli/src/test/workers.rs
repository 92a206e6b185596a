//! The execution of tests on several threads.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use camino::Utf8Path;
use val3_analysis::resizing::is_resized;
use val3_machine::controller::{Controller, Snapshot};
use val3_session::Tape;
use val3_suite::{Scenario, TestCase, TestKind, execute};

use super::discovery::{Suite, TestFile, open};
use super::golden;
use super::order::shuffled;
use super::tested::Tested;
use crate::args::TestArgs;
use crate::run::{check_script, read_script};
use crate::user_error::UserError;

/// Executes tests; the results have their order. With `--fail-fast` they end at the first failure.
///
/// # Errors
/// An application or a script cannot be used.
pub(super) fn executed(args: &TestArgs, tests: &[TestFile<'_>]) -> Result<Vec<Tested>, UserError> {
    let order = args.seed.map_or_else(|| (0..tests.len()).collect(), |seed| shuffled(tests.len(), seed));
    let (next, is_over) = (AtomicUsize::new(0), AtomicBool::new(false));
    let work = || -> Result<Vec<(usize, Tested)>, UserError> {
        let mut worker = Worker { args, bench: None };
        let mut done = Vec::new();
        while !is_over.load(Ordering::Relaxed) {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(test) = order.get(place).and_then(|number| tests.get(*number)) else { break };
            let tested = worker.execute(test)?;
            // All tests before this one have begun, and will be completed.
            is_over.fetch_or(args.fail_fast && !tested.result.has_passed(), Ordering::Relaxed);
            done.push((place, tested));
        }
        Ok(done)
    };
    let mut done = Vec::new();
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads(args)).map(|_| scope.spawn(work)).collect();
        workers.into_iter().try_for_each(|worker| {
            let results = worker.join().map_err(|_| UserError::new("a thread has failed"))?;
            done.extend(results?);
            Ok::<(), UserError>(())
        })
    })?;
    done.sort_by_key(|(place, _)| *place);
    let failure = done.iter().position(|(_, tested)| !tested.result.has_passed());
    done.truncate(failure.filter(|_| args.fail_fast).map_or(done.len(), |at| at + 1));
    // Results are shown in the order of the names, whatever the order of execution is.
    done.sort_by_key(|(place, _)| order.get(*place).copied());
    Ok(done.into_iter().map(|(_, tested)| tested).collect())
}

fn threads(args: &TestArgs) -> usize {
    let cores = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    args.jobs.map_or(cores, |jobs| usize::try_from(jobs).unwrap_or(cores))
}

/// A thread with the application whose tests it executes. A database is used by one thread.
struct Worker<'a> {
    args: &'a TestArgs,
    bench: Option<Bench>,
}

/// An application on a controller that returns to its initial state before each test.
///
/// With a new controller for each test, 1,000 tests of one application took 19 s instead of 0.1.
struct Bench {
    suite: Suite,
    controller: Controller,
    initial: Snapshot,
}

impl Bench {
    fn open(args: &TestArgs, suite: Suite) -> Result<Self, UserError> {
        let Suite { application, image, .. } = &suite;
        let mut controller = application.controller(&args.controller.settings(), Tape::default(), image.clone())?;
        let initial = controller.snapshot();
        Ok(Self { suite, controller, initial })
    }

    /// Whether a test has used a line to the outside, or was the other end of a line itself.
    fn has_connections(&self) -> bool {
        let lines = &self.controller.devices.lines;
        lines.reach_outside() || lines.are_scripted()
    }

    /// Puts the controller into its initial state, with the script of the test, and returns its file. A test program need
    /// not have one.
    fn prepare(&mut self, case: &TestCase) -> Result<Scenario, UserError> {
        self.controller.begin_again(&self.initial);
        let path = match case.kind {
            TestKind::Program => Utf8Path::new(&case.file).with_extension("toml"),
            TestKind::Scenario => case.file.clone().into(),
        };
        if case.kind == TestKind::Program && !path.is_file() {
            return Ok(Scenario::default());
        }
        let scenario = read_script(&path)?;
        let unusable = |error| UserError::new(format!("the script `{path}` cannot be used\n{error}"));
        scenario.check_kind(case.kind).map_err(unusable)?;
        let application = &self.suite.application;
        let resized = |data: &str| is_resized(application.db(), application.project(), data);
        check_script(&path, &scenario.faults(&self.controller, &resized))?;
        scenario.prepare(&mut self.controller);
        Ok(scenario)
    }
}

impl Worker<'_> {
    fn execute(&mut self, test: &TestFile<'_>) -> Result<Tested, UserError> {
        let known = self.bench.take().filter(|bench| bench.suite.manifest == test.manifest);
        let mut bench = match known {
            // Connections would keep what the test before has left.
            Some(bench) if bench.has_connections() => Bench::open(self.args, bench.suite)?,
            Some(bench) => bench,
            None => Bench::open(self.args, open(self.args, test.manifest)?)?,
        };
        let scenario = bench.prepare(test.case)?;
        let mut result = execute(&mut bench.controller, test.case, &scenario, bench.suite.settings);
        self.bench = Some(bench);
        let recorded = golden::judge(test.case, &mut result, self.args.update)?;
        Ok(Tested { case: test.case.clone(), result, recorded })
    }
}
