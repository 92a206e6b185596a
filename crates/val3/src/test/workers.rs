//! Executes tests on several threads.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;
use std::time::Instant;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::resizing::is_resized;
use val3_analysis::system::Disk;
use val3_coverage::Coverage;
use val3_machine::controller::{Controller, Snapshot};
use val3_machine::sio::SocketGuard;
use val3_session::{Application, ControllerSettings, FrameEvaluator, Tape};
use val3_suite::{ControllerKeys, Supervision, TestCase, TestResult, TestSettings, counted, execute};

use super::discovery::{Opening, Suite, TestFile, open};
use super::identifiers;
use super::judged::judged;
use super::order::shuffled;
use super::results::{EarlyEnd, Results};
use super::script_file::ScriptFile;
use super::tested::FinishedTest;
use crate::args::TestArgs;
use crate::run::check_script;
use crate::signals::Signals;
use crate::sockets::ClosedSockets;
use crate::user_error::UserError;

/// An event of the execution.
pub(super) enum TestEvent<'t> {
    /// A thread has started a test.
    Started(&'t TestCase),
    /// A test has finished.
    Finished(&'t FinishedTest),
    /// A test has finished, and so have all its predecessors in the order of the results.
    Next(&'t FinishedTest),
}

/// Receives each event when it happens. It can end the execution after the tests that have already started.
pub(super) type Observer<'o> = &'o mut dyn FnMut(&TestEvent<'_>) -> Result<ControlFlow<()>, UserError>;

/// Shared resources of the execution.
pub(super) struct Surroundings<'s> {
    /// Sockets, which stay closed.
    pub(super) sockets: &'s ClosedSockets,
    /// Signals, which end all tests.
    pub(super) signals: &'s Signals,
}

/// Executes tests, and returns the results in order. With `--fail-fast`, the execution ends at the first failure. The
/// coverage covers all tests. A test whose application or files cannot be used fails, and all other tests are executed.
///
/// # Errors
/// A thread or the observer has failed.
pub(super) fn executed(
    args: &TestArgs,
    tests: &[TestFile<'_>],
    surroundings: &Surroundings<'_>,
    observer: Observer<'_>,
) -> Result<(Results, Coverage), UserError> {
    let start = Instant::now();
    let order = args.seed.map_or_else(|| (0..tests.len()).collect(), |seed| shuffled(tests.len(), seed));
    let first_tests = order.iter().filter_map(|number| tests.get(*number)).collect();
    let queue = &Queue::new(first_tests, surroundings.signals.flag());
    let mut done = Done { order: &order, tests: BTreeMap::new(), shown: 0, fail_fast: args.fail_fast };
    let (coverage, is_read) = thread::scope(|scope| {
        let (sender, messages) = channel();
        let mut workers = Vec::new();
        for _ in 0..threads(args) {
            let (sender, sockets) = (sender.clone(), surroundings.sockets.clone());
            workers.push(scope.spawn(move || Worker::new(args, sockets).work(queue, &sender)));
        }
        drop(sender);
        let observed = observed(messages, queue, &mut done, observer);
        workers.into_iter().try_for_each(|worker| worker.join().map_err(|_| UserError::new("a thread has failed")))?;
        observed
    })?;
    done.end();
    done.show(observer)?;
    let not_run = tests.iter().enumerate().filter(|(number, _)| !done.tests.contains_key(number));
    let not_run: Vec<TestCase> = not_run.map(|(_, test)| test.case.clone()).collect();
    let early_end = match surroundings.signals.exit_code() {
        Some(code) => EarlyEnd::Signal(code),
        None if is_read => EarlyEnd::FirstFailure,
        None => EarlyEnd::UnreadOutput,
    };
    let early_end = Some(early_end).filter(|end| !not_run.is_empty() || matches!(end, EarlyEnd::Signal(_)));
    let tested = done.tests.into_values().map(|(_, tested)| tested).collect();
    Ok((Results { tested, not_run, early_end, wall: start.elapsed() }, coverage))
}

/// Finished tests.
struct Done<'o> {
    /// Test numbers in the order of execution.
    order: &'o [usize],
    /// Index in the order of execution and result, by test number. Results are sorted by number, regardless of the
    /// order of execution.
    tests: BTreeMap<usize, (usize, FinishedTest)>,
    /// Number of the next test to show.
    shown: usize,
    fail_fast: bool,
}

impl Done<'_> {
    fn add(&mut self, place: usize, tested: FinishedTest) {
        if let Some(number) = self.order.get(place) {
            self.tests.insert(*number, (place, tested));
        }
    }

    /// Shows tests whose predecessors have finished. With `--fail-fast`, they are shown at the end, because a failed
    /// test removes the tests that other threads have executed after it.
    fn show_next(&mut self, observer: Observer<'_>) -> Result<ControlFlow<()>, UserError> {
        while let Some((_, tested)) = self.tests.get(&self.shown).filter(|_| !self.fail_fast) {
            self.shown += 1;
            if observer(&TestEvent::Next(tested))?.is_break() {
                return Ok(ControlFlow::Break(()));
            }
        }
        Ok(ControlFlow::Continue(()))
    }

    /// Removes the tests after the first failure with `--fail-fast`.
    fn end(&mut self) {
        let failed = self.tests.values().filter(|(_, tested)| !tested.result.has_passed()).map(|(place, _)| *place);
        if let Some(first) = failed.min().filter(|_| self.fail_fast) {
            self.tests.retain(|_, (place, _)| *place <= first);
        }
    }

    /// Shows the remaining tests.
    fn show(&self, observer: Observer<'_>) -> Result<(), UserError> {
        let mut open = self.tests.range(self.shown..);
        open.try_for_each(|(_, (_, tested))| observer(&TestEvent::Next(tested)).map(drop))
    }
}

/// Collects the results of all threads. Returns the coverage, and whether the output is still read.
fn observed(
    messages: Receiver<WorkerMessage>,
    queue: &Queue<'_>,
    done: &mut Done<'_>,
    observer: Observer<'_>,
) -> Result<(Coverage, bool), UserError> {
    let mut coverage = Coverage::default();
    for message in messages {
        let flow = match message {
            WorkerMessage::Started(place) => {
                queue.test(place).map_or(Ok(ControlFlow::Continue(())), |test| observer(&TestEvent::Started(test.case)))
            }
            WorkerMessage::Finished(place, tested) => {
                let flow = observer(&TestEvent::Finished(&tested))?;
                done.add(place, *tested);
                if flow.is_break() { Ok(flow) } else { done.show_next(observer) }
            }
            WorkerMessage::Counted(counted) => {
                coverage.merge(counted);
                Ok(ControlFlow::Continue(()))
            }
        };
        // The threads end when their messages have no receiver.
        if flow?.is_break() {
            return Ok((coverage, false));
        }
    }
    Ok((coverage, true))
}

/// Message of a thread. The number is the index of the test in the order of execution.
enum WorkerMessage {
    Started(usize),
    Finished(usize, Box<FinishedTest>),
    /// Coverage of the thread's tests.
    Counted(Coverage),
}

/// Tests in the order of execution, from which all threads take the next test.
struct Queue<'t> {
    tests: Vec<&'t TestFile<'t>>,
    next: AtomicUsize,
    is_over: AtomicBool,
    /// Whether a signal was caught.
    is_interrupted: Arc<AtomicBool>,
}

impl<'t> Queue<'t> {
    fn new(tests: Vec<&'t TestFile<'t>>, is_interrupted: Arc<AtomicBool>) -> Self {
        Self { tests, next: AtomicUsize::new(0), is_over: AtomicBool::new(false), is_interrupted }
    }

    fn is_interrupted(&self) -> bool {
        self.is_interrupted.load(Ordering::Relaxed)
    }

    fn test(&self, place: usize) -> Option<&'t TestFile<'t>> {
        self.tests.get(place).copied()
    }

    /// Next test, with its index in the order of execution.
    fn take(&self) -> Option<(usize, &'t TestFile<'t>)> {
        if self.is_over.load(Ordering::Relaxed) || self.is_interrupted() {
            return None;
        }
        let place = self.next.fetch_add(1, Ordering::Relaxed);
        self.test(place).map(|test| (place, test))
    }

    /// Prevents the start of further tests. All tests before the current one have started, and will be completed.
    fn end(&self) {
        self.is_over.store(true, Ordering::Relaxed);
    }
}

pub(super) fn threads(args: &TestArgs) -> usize {
    let cores = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    args.jobs.map_or(cores, |jobs| usize::try_from(jobs).unwrap_or(cores))
}

/// A thread and its current application. Each thread has its own database.
struct Worker<'a> {
    args: &'a TestArgs,
    sockets: ClosedSockets,
    bench: Option<Bench>,
    /// Evaluator for an application's conditions, created after the first test that has not ended.
    evaluator: Option<(Utf8PathBuf, FrameEvaluator)>,
    coverage: Coverage,
}

/// An application on a controller that returns to its initial state before each test.
///
/// With a new controller for each test, 1,000 tests of one application took 19 s instead of 0.1 s.
pub(super) struct Bench {
    pub(super) suite: Suite,
    pub(super) controller: Controller,
    initial: Snapshot,
    /// Requested controller properties.
    pub(super) keys: ControllerKeys,
}

impl Bench {
    /// Opens an application on a controller with the properties of a test.
    ///
    /// # Errors
    /// The application cannot be loaded, the compiler rejects it, or the properties are invalid.
    pub(super) fn open(
        opening: Opening<'_>,
        manifest: &Utf8Path,
        keys: &ControllerKeys,
        guard: Rc<dyn SocketGuard>,
    ) -> Result<Self, UserError> {
        let arguments = opening.controller.with(keys);
        let opening = Opening { controller: &arguments, replace: Some(&keys.replace), ..opening };
        let suite = open(opening, manifest)?;
        identifiers::check_file(suite.application.db(), &keys.replace)?;
        Self::of(opening, suite, keys.clone(), guard)
    }

    /// Creates a new controller for an opened application.
    fn of(
        opening: Opening<'_>,
        suite: Suite,
        keys: ControllerKeys,
        guard: Rc<dyn SocketGuard>,
    ) -> Result<Self, UserError> {
        let Suite { application, image, .. } = &suite;
        let settings = opening.controller.with(&keys).settings(guard);
        let settings = ControllerSettings { form: opening.form, edited: opening.edited.to_vec(), ..settings };
        let mut controller = application.controller(&settings, Tape::default(), image.clone())?;
        let initial = controller.snapshot();
        Ok(Self { suite, controller, initial, keys })
    }

    /// Whether a test has used an external line, or was itself the peer of a line.
    pub(super) fn has_connections(&self) -> bool {
        let lines = &self.controller.devices.lines;
        lines.reach_outside() || lines.are_scripted()
    }

    /// Resets the controller to its initial state, with the script of a test.
    ///
    /// # Errors
    /// The script is invalid for the application.
    pub(super) fn prepare(&mut self, ScriptFile { path, scenario, .. }: &ScriptFile) -> Result<(), UserError> {
        self.controller.begin_again(&self.initial);
        let application = &self.suite.application;
        let resized = |data: &str| is_resized(application.db(), application.project(), data);
        check_script(path, &scenario.faults(&self.controller, &resized))?;
        scenario.prepare(&mut self.controller);
        Ok(())
    }
}

/// Creates an application's evaluator. It has its own database, because it adds texts to it. `None` if the
/// application can no longer be loaded.
fn evaluator_of<'e>(
    manifest: &Utf8Path,
    known: &'e mut Option<(Utf8PathBuf, FrameEvaluator)>,
) -> Option<&'e mut FrameEvaluator> {
    if known.as_ref().is_none_or(|(of, _)| of != manifest) {
        let application = Application::open_with_stand_ins(&Disk, manifest, &BTreeMap::new()).ok()?;
        *known = Some((manifest.to_owned(), FrameEvaluator::new(application)));
    }
    known.as_mut().map(|(_, evaluator)| evaluator)
}

impl<'a> Worker<'a> {
    fn new(args: &'a TestArgs, sockets: ClosedSockets) -> Self {
        Self { args, sockets, bench: None, evaluator: None, coverage: Coverage::default() }
    }

    fn guard(&self) -> Rc<dyn SocketGuard> {
        Rc::new(self.sockets.clone())
    }

    /// Executes tests of the queue until it is empty, or the messages have no receiver.
    fn work(mut self, queue: &Queue<'_>, messages: &Sender<WorkerMessage>) {
        while let Some((place, test)) = queue.take() {
            if messages.send(WorkerMessage::Started(place)).is_err() {
                break;
            }
            let Some(tested) = self.attempts(test, queue) else { break };
            if self.args.fail_fast && !tested.result.has_passed() {
                queue.end();
            }
            if messages.send(WorkerMessage::Finished(place, Box::new(tested))).is_err() {
                break;
            }
        }
        // Fails without a receiver, if the output was closed.
        let _ = messages.send(WorkerMessage::Counted(self.coverage));
    }

    /// Executes a test, and repeats it after a failure within the retry limit. `None` if the run was interrupted.
    fn attempts(&mut self, test: &TestFile<'_>, queue: &Queue<'_>) -> Option<FinishedTest> {
        let mut earlier = Vec::new();
        loop {
            let tested = self.execute(test, queue)?;
            let is_last = earlier.len() >= self.args.retries as usize;
            if tested.result.has_passed() || !tested.is_executed || is_last {
                return Some(FinishedTest { earlier, ..tested });
            }
            earlier.push(tested.result);
        }
    }

    /// Executes a test. `None` if the run was interrupted.
    fn execute(&mut self, test: &TestFile<'_>, queue: &Queue<'_>) -> Option<FinishedTest> {
        let start = Instant::now();
        let file = match ScriptFile::of(test.case) {
            Ok(file) => file,
            Err(error) => return Some(FinishedTest::unusable(test.case, &error)),
        };
        if let Some(reason) = file.scenario.skip() {
            return Some(FinishedTest::of(test.case, TestResult::skipped(reason)));
        }
        let mut bench = match self.bench(test.manifest, &file.keys) {
            Ok(bench) => bench,
            Err(error) => return Some(FinishedTest::unusable(test.case, &error)),
        };
        if let Err(error) = bench.prepare(&file) {
            self.bench = Some(bench);
            return Some(FinishedTest::unusable(test.case, &error));
        }
        let evaluator = &mut self.evaluator;
        let limit = file.scenario.limit().filter(|_| self.args.limit.is_none());
        let supervision = Supervision {
            settings: limit.map_or(bench.suite.settings, |limit| TestSettings { limit }),
            may_go_on: &|| !queue.is_interrupted(),
            conditions: &mut |controller, task| {
                evaluator_of(test.manifest, evaluator).map_or_else(Vec::new, |found| found.conditions(controller, task))
            },
        };
        let result = execute(&mut bench.controller, test.case, &file.scenario, supervision)?;
        self.coverage.merge(counted(&bench.controller, &bench.suite.application));
        self.bench = Some(bench);
        let tested = judged(test.case, result, self.args.update, self.args.events);
        Some(FinishedTest { wall: start.elapsed(), ..tested })
    }

    /// Application on a controller; reused from the previous test if the properties are equal.
    fn bench(&mut self, manifest: &Utf8Path, keys: &ControllerKeys) -> Result<Bench, UserError> {
        let opening = Opening::of(self.args);
        let known = self.bench.take().filter(|bench| bench.suite.manifest == manifest && bench.keys == *keys);
        match known {
            // Connections would keep data of the previous test.
            Some(bench) if bench.has_connections() => Bench::of(opening, bench.suite, bench.keys, self.guard()),
            Some(bench) => Ok(bench),
            None => Bench::open(opening, manifest, keys, self.guard()),
        }
    }
}
