//! Trial of mistakes on several threads, each mistake with the tests that execute its line.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::thread;

use val3_analysis::system::{Disk, OverlayFs};
use val3_session::Application;
use val3_suite::{Difference, FinalState};

use super::executor::{Conditions, Executor, SEED};
use super::mutant::Mutant;
use super::original::Originals;
use crate::args::TestFormat;
use crate::progress::DelayedProgress;
use crate::test::order::shuffled;
use crate::test::workers::{Surroundings, threads};
use crate::user_error::UserError;

/// Verdict on a mistake.
pub(super) enum Verdict {
    /// The test with this index has failed.
    Found(usize),
    /// No test has failed. The value is the first difference in a test's final state, with the index of the test.
    Survived(Option<(usize, Difference)>),
    /// The compiler rejects the program.
    NotCompiled,
}

/// Tried mistake with its verdict.
pub(super) struct MutantTrial<'m> {
    pub(super) mutant: &'m Mutant,
    pub(super) verdict: Verdict,
}

/// Tries the number of mistakes that the arguments request, not counting mistakes that do not compile. The seed in the
/// arguments determines the choice. Results are in the order of the mistakes; a signal ends the trial early.
///
/// # Errors
/// A thread has failed.
pub(super) fn all<'m>(
    conditions: Conditions<'_>,
    originals: &Originals<'_>,
    mutants: &'m [Mutant],
) -> Result<Vec<MutantTrial<'m>>, UserError> {
    let args = conditions.args;
    let wanted = (args.mutations as usize).min(mutants.len());
    let bar = DelayedProgress::new("mutating", wanted, args.format == TestFormat::Human);
    let mut order = shuffled(mutants.len(), args.seed.unwrap_or(SEED)).into_iter();
    let mut done: Vec<(usize, Verdict)> = Vec::new();
    loop {
        let compiled = done.iter().filter(|(_, verdict)| !matches!(verdict, Verdict::NotCompiled)).count();
        let next: Vec<(usize, &Mutant)> =
            order.by_ref().take(wanted - compiled).filter_map(|number| Some((number, mutants.get(number)?))).collect();
        if next.is_empty() || conditions.is_interrupted.load(Ordering::Relaxed) {
            break;
        }
        done.extend(tried(conditions, originals, &next, &bar)?);
    }
    done.sort_by_key(|(number, _)| *number);
    let trial = |(number, verdict)| Some(MutantTrial { mutant: mutants.get(number)?, verdict });
    Ok(done.into_iter().filter_map(trial).collect())
}

/// Tries numbered mistakes on several threads.
fn tried(
    conditions: Conditions<'_>,
    originals: &Originals<'_>,
    mutants: &[(usize, &Mutant)],
    bar: &DelayedProgress,
) -> Result<Vec<(usize, Verdict)>, UserError> {
    let queue = &MutantQueue { mutants, next: AtomicUsize::new(0) };
    let Surroundings { sockets, signals } = *conditions.surroundings;
    let (args, is_interrupted) = (conditions.args, conditions.is_interrupted);
    thread::scope(|scope| {
        let (sender, verdicts) = channel();
        let mut workers = Vec::new();
        for _ in 0..threads(args) {
            let (sender, sockets) = (sender.clone(), sockets.clone());
            workers.push(scope.spawn(move || {
                let surroundings = &Surroundings { sockets: &sockets, signals };
                queue.work(Conditions { args, surroundings, is_interrupted }, originals, &sender);
            }));
        }
        drop(sender);
        let found = verdicts.into_iter().inspect(|(_, verdict)| {
            if !matches!(verdict, Verdict::NotCompiled) {
                bar.advance();
            }
        });
        let found = found.collect();
        let joined = workers.into_iter().try_for_each(|worker| worker.join());
        joined.map_err(|_| UserError::new("a thread has failed"))?;
        Ok(found)
    })
}

/// Numbered mistakes, from which all threads take the next one.
struct MutantQueue<'m> {
    mutants: &'m [(usize, &'m Mutant)],
    next: AtomicUsize,
}

impl MutantQueue<'_> {
    /// Tries mistakes until the queue is empty, a signal ends the trial, or the verdicts have no receiver.
    fn work(&self, conditions: Conditions<'_>, originals: &Originals<'_>, verdicts: &Sender<(usize, Verdict)>) {
        while let Some((number, mutant)) = self.mutants.get(self.next.fetch_add(1, Ordering::Relaxed)) {
            let Some(verdict) = verdict(conditions, originals, mutant) else { break };
            if verdicts.send((*number, verdict)).is_err() {
                break;
            }
        }
    }
}

/// Tries a mistake. `None` if a signal has ended the trial.
fn verdict(conditions: Conditions<'_>, originals: &Originals<'_>, mutant: &Mutant) -> Option<Verdict> {
    let text = mutant.text();
    if !is_compiled(mutant, &text) {
        return Some(Verdict::NotCompiled);
    }
    let mut executor = Executor::edited(conditions, mutant.file.clone().into(), text);
    let mut difference = None;
    for number in &mutant.tests {
        let Some(original) = originals.tests.get(*number) else { continue };
        match executor.execute(&original.test, Some(original.limit)) {
            Ok(Some(execution)) if execution.result.has_passed() => {
                let of_test = || Some((*number, state_difference(&execution.state, &original.state, mutant)?));
                difference = difference.or_else(of_test);
            }
            Ok(Some(_)) => return Some(Verdict::Found(*number)),
            Ok(None) => return None,
            // With the mistake, the application exceeds a compiler limit.
            Err(_) => return Some(Verdict::NotCompiled),
        }
    }
    Some(Verdict::Survived(difference))
}

/// First difference between the final states with and without the mistake.
fn state_difference(state: &FinalState, original: &FinalState, mutant: &Mutant) -> Option<Difference> {
    match &mutant.element {
        // The changed value itself differs anyway, unless a program has written it.
        Some(element) => state.without(element).first_difference(&original.without(element)),
        None => state.first_difference(original),
    }
}

/// Whether the compiler accepts the application or library with a mistake.
fn is_compiled(mutant: &Mutant, text: &Arc<str>) -> bool {
    let mut system = OverlayFs::new(Disk);
    system.edit(mutant.file.as_str().into(), Arc::clone(text));
    let application = Application::open(&system, mutant.project_file.as_str().into(), None);
    application.is_ok_and(|application| application.refusals().is_empty())
}
