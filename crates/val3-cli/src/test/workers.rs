//! The execution of tests on several threads.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::thread;

use camino::Utf8Path;
use val3_analysis::resizing::is_resized;
use val3_coverage::Coverage;
use val3_lang::ports::nanoseconds;
use val3_machine::controller::{Controller, Snapshot};
use val3_session::{ControllerSettings, Tape};
use val3_suite::{TestCase, TestSettings, counted, execute};

use super::discovery::{Suite, TestFile, open};
use super::order::shuffled;
use super::tested::Tested;
use crate::args::TestArgs;
use crate::run::follow_script;
use crate::user_error::UserError;

/// Executes tests; the results have their order. With `--fail-fast` they end at the first failure. The coverage is that of
/// all tests.
///
/// # Errors
/// An application or a script cannot be used.
pub(super) fn executed(args: &TestArgs, tests: &[TestFile<'_>]) -> Result<(Vec<Tested>, Coverage), UserError> {
    let order = args.seed.map_or_else(|| (0..tests.len()).collect(), |seed| shuffled(tests.len(), seed));
    let (next, is_over) = (AtomicUsize::new(0), AtomicBool::new(false));
    let work = || -> Result<(Vec<(usize, Tested)>, Coverage), UserError> {
        let mut worker = Worker { args, bench: None, coverage: Coverage::default() };
        let mut done = Vec::new();
        while !is_over.load(Ordering::Relaxed) {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(test) = order.get(place).and_then(|number| tests.get(*number)) else { break };
            let tested = worker.execute(test)?;
            // All tests before this one have begun, and will be completed.
            is_over.fetch_or(args.fail_fast && tested.result.failure.is_some(), Ordering::Relaxed);
            done.push((place, tested));
        }
        Ok((done, worker.coverage))
    };
    let (mut done, mut coverage) = (Vec::new(), Coverage::default());
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads(args)).map(|_| scope.spawn(work)).collect();
        workers.into_iter().try_for_each(|worker| {
            let results = worker.join().map_err(|_| UserError::new("a thread has failed"))?;
            let (results, counted) = results?;
            done.extend(results);
            coverage.merge(counted);
            Ok::<(), UserError>(())
        })
    })?;
    done.sort_by_key(|(place, _)| *place);
    let failure = done.iter().position(|(_, tested)| tested.result.failure.is_some());
    done.truncate(failure.filter(|_| args.fail_fast).map_or(done.len(), |at| at + 1));
    // Results are shown in the order of the names, whatever the order of execution is.
    done.sort_by_key(|(place, _)| order.get(*place).copied());
    Ok((done.into_iter().map(|(_, tested)| tested).collect(), coverage))
}

fn threads(args: &TestArgs) -> usize {
    let cores = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    args.jobs.map_or(cores, |jobs| usize::try_from(jobs).unwrap_or(cores))
}

/// A thread with the application whose tests it executes. A database is used by one thread.
struct Worker<'a> {
    args: &'a TestArgs,
    bench: Option<Bench>,
    coverage: Coverage,
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
        let settings = ControllerSettings { is_counted: args.coverage.is_wanted(), ..args.controller.settings() };
        let mut controller = application.controller(&settings, Tape::default(), image.clone())?;
        let initial = controller.snapshot();
        Ok(Self { suite, controller, initial })
    }

    /// Puts the controller into its initial state, with the script beside the program of the test if there is one.
    fn prepare(&mut self, case: &TestCase) -> Result<(), UserError> {
        self.controller.begin_again(&self.initial);
        let script = Utf8Path::new(&case.file).with_extension("toml");
        if !script.is_file() {
            return Ok(());
        }
        let application = &self.suite.application;
        let resized = |data: &str| is_resized(application.db(), application.project(), data);
        follow_script(&mut self.controller, &script, &resized)
    }
}

impl Worker<'_> {
    fn execute(&mut self, test: &TestFile<'_>) -> Result<Tested, UserError> {
        let known = self.bench.take().filter(|bench| bench.suite.manifest == test.manifest);
        let mut bench = match known {
            // Connections would keep what the test before has left.
            Some(bench) if bench.controller.devices.lines.reach_outside() => Bench::open(self.args, bench.suite)?,
            Some(bench) => bench,
            None => Bench::open(self.args, open(self.args, test.manifest)?)?,
        };
        bench.prepare(test.case)?;
        let settings = TestSettings { limit: nanoseconds(self.args.limit) };
        let result = execute(&mut bench.controller, test.case, settings);
        self.coverage.merge(counted(&bench.controller));
        self.bench = Some(bench);
        Ok(Tested { case: test.case.clone(), result })
    }
}
