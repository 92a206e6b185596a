//! Ends of the controller and of the client at every operation of a push.
//!
//! The law: the controller has the old application or the new application, or the next command restores one and reports
//! it. A killed client causes the same state as a controller that has died, because the journal is written first.
//! `tests/python/controller_cases.py` kills the real process.

use val3_controller::{
    ControllerError, ControllerPath, FailureOutcome, PushFailure, RecoveredPush, RecoveryOutcome, TransferObserver,
    TransferStep,
};

use crate::bench::{Bench, shown, tree};
use crate::memory::MemoryFiles;
use crate::server::{Behaviour, Death, Tree};

/// Tree after a complete push.
fn new_tree() -> Tree {
    let bench = Bench::with(MemoryFiles::new(tree(), false));
    bench.pull().unwrap();
    bench.edit();
    bench.push().unwrap();
    bench.server.state().tree.clone()
}

/// A project with changes, and a controller that has died during the push.
fn crashed(number: usize, death: Death, keeps_targets: bool) -> (Bench<MemoryFiles>, Result<(), PushFailure>) {
    let bench = Bench::with(MemoryFiles::new(tree(), keeps_targets));
    bench.pull().unwrap();
    bench.edit();
    let plan = bench.plan().unwrap();
    bench.server.revive(Some((number, death)));
    let pushed = bench.push_plan(&plan);
    (bench, pushed)
}

#[test]
fn after_a_crash_at_any_operation_the_application_is_old_or_new() {
    let (old, new) = (tree(), new_tree());
    for (death, keeps_targets) in
        [Death::Before, Death::Half, Death::After].into_iter().flat_map(|death| [(death, false), (death, true)])
    {
        let mut outcomes = Vec::new();
        for number in 0.. {
            let (bench, pushed) = crashed(number, death, keeps_targets);
            let has_died = bench.server.state().is_dead;
            bench.server.revive(None);
            let recovered = bench.recover().unwrap();
            let tree = bench.server.state().tree.clone();
            assert!(tree == old || tree == new, "{death:?} at {number}: {}", shown(&tree));
            match pushed.map_err(|failure| failure.outcome) {
                Ok(()) => assert!(tree == new && recovered.is_empty()),
                // Before the journal was written.
                Err(FailureOutcome::Unchanged) => assert!(tree == old && recovered.is_empty()),
                Err(FailureOutcome::Unfinished { .. }) => {
                    let [one] = &recovered[..] else { panic!("{death:?} at {number}: nothing is recovered") };
                    assert_eq!(one.outcome == RecoveryOutcome::Completed, tree == new);
                    outcomes.push(one.outcome.clone());
                }
                Err(other) => panic!("{death:?} at {number}: {other:?}"),
            }
            check_second_push(&bench, &new, tree == old);
            if !has_died {
                break;
            }
        }
        let count = |wanted: fn(&RecoveryOutcome) -> bool| outcomes.iter().filter(|one| wanted(one)).count();
        assert!(count(|one| matches!(one, RecoveryOutcome::Restored { .. })) > 2);
        assert!(count(|one| *one == RecoveryOutcome::Cancelled) > 20);
        assert!(count(|one| *one == RecoveryOutcome::Completed) > 0);
    }
}

/// The project has the state of the controller, so that a second push does the rest.
fn check_second_push(bench: &Bench<MemoryFiles>, new: &Tree, is_old: bool) {
    assert!(bench.recover().unwrap().is_empty());
    if is_old {
        bench.push().unwrap();
    }
    assert_eq!(shown(&bench.server.state().tree), shown(new));
    assert!(bench.status().unwrap().differences.is_empty());
}

#[test]
fn a_crash_of_the_recovery_is_recovered() {
    // The last operation at which a push is undone.
    let is_undone = |number: &usize| {
        let (bench, _) = crashed(*number, Death::After, false);
        bench.server.revive(None);
        let recovered = bench.recover().unwrap();
        matches!(recovered.first().map(|one| &one.outcome), Some(RecoveryOutcome::Restored { .. }))
    };
    let last = (0..200).rev().find(is_undone).unwrap();
    for number in 0.. {
        let (bench, _) = crashed(last, Death::After, false);
        bench.server.revive(Some((number, Death::After)));
        let is_complete = bench.recover().is_ok();
        bench.server.revive(None);
        bench.recover().unwrap();
        assert_eq!(shown(&bench.server.state().tree), shown(&tree()), "{number}");
        if is_complete {
            assert!(number > 20);
            break;
        }
    }
}

/// Executes another command of the project as soon as a step of a push begins.
struct OtherCommand<'b> {
    bench: &'b Bench<MemoryFiles>,
    at: TransferStep,
    recovered: Option<Result<Vec<RecoveredPush>, ControllerError>>,
    pulled: Option<ControllerError>,
}

impl TransferObserver for OtherCommand<'_> {
    fn step(&mut self, step: TransferStep, _: usize) {
        if step == self.at {
            self.recovered = Some(self.bench.recover());
            self.pulled = self.bench.pull().err();
        }
    }

    fn file(&mut self, _: &ControllerPath, _: u64) {}

    fn is_interrupted(&self) -> bool {
        false
    }
}

#[test]
fn another_command_does_not_change_a_push_that_is_running() {
    for at in [TransferStep::BackUp, TransferStep::Upload, TransferStep::Rename, TransferStep::Verify] {
        let bench = Bench::with(MemoryFiles::new(tree(), false));
        bench.pull().unwrap();
        bench.edit();
        let plan = bench.plan().unwrap();
        let mut other = OtherCommand { bench: &bench, at, recovered: None, pulled: None };
        bench.push_observed(&plan, &mut other).unwrap();
        assert_eq!(other.recovered, Some(Err(ControllerError::Running)), "{at:?}");
        assert_eq!(other.pulled, Some(ControllerError::Running), "{at:?}");
        assert_eq!(shown(&bench.server.state().tree), shown(&new_tree()), "{at:?}");
        assert_eq!(bench.recover(), Ok(Vec::new()), "{at:?}");
    }
}

/// The same by FTP, for some commands.
#[test]
fn a_server_that_dies_leaves_a_push_that_the_next_command_undoes() {
    for (number, death) in [(20, Death::Before), (70, Death::Half), (100, Death::After), (130, Death::After)] {
        let bench = Bench::pulled(Behaviour::default());
        bench.edit();
        let plan = bench.plan().unwrap();
        bench.server.behave(Behaviour { death: Some((number, death)), ..Behaviour::default() });
        bench.push_plan(&plan).unwrap_err();
        assert!(bench.server.state().is_dead);
        bench.server.behave(Behaviour::default());
        bench.recover().unwrap();
        let tree = bench.server.state().tree.clone();
        assert!(tree == crate::bench::tree() || tree == new_tree(), "{number}: {}", shown(&tree));
    }
}

/// The journal may belong to a push that has changed the controller.
#[cfg(unix)]
#[test]
fn a_journal_that_cannot_be_accessed_is_an_error() {
    let bench = Bench::with(MemoryFiles::new(tree(), false));
    bench.pull().unwrap();
    let backup = bench.folder.join(".val3/backup/push");
    std::fs::create_dir_all(&backup).unwrap();
    std::os::unix::fs::symlink("journal.json", backup.join("journal.json")).unwrap();
    let error = bench.recover().unwrap_err().to_string();
    assert!(error.contains("journal.json"), "{error}");
}
