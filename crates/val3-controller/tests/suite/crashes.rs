//! Ends of the server and of the client at every command of a push.
//!
//! The law: the controller has the old application, or the new one, or the next command restores one of them and says
//! so. A client that is killed leaves the same state as a client whose server has died, because the journal is written
//! first; `crates/val3` and `tests/python` kill the real process.

use crate::bench::{Bench, shown, tree};
use crate::server::{Behaviour, Death, Tree};
use val3_controller::{FailureOutcome, PushFailure, RecoveryOutcome};

/// Tree after a complete push.
fn new_tree() -> Tree {
    let bench = Bench::pulled(Behaviour::default());
    bench.edit();
    bench.push().unwrap();
    bench.server.state().tree.clone()
}

/// Commands of a connection before the first one of a transfer: `TYPE` and `FEAT`.
const FIRST: usize = 2;

/// A project with changes, and a server that has died during the push.
fn crashed(number: usize, death: Death, behaviour: &Behaviour) -> (Bench, Result<(), PushFailure>) {
    let bench = Bench::pulled(behaviour.clone());
    bench.edit();
    let plan = bench.plan().unwrap();
    bench.server.behave(Behaviour { death: Some((number, death)), ..behaviour.clone() });
    let pushed = bench.push_plan(&plan);
    (bench, pushed)
}

#[test]
fn after_a_crash_at_any_command_the_application_is_old_or_new() {
    let (old, new) = (tree(), new_tree());
    for death in [Death::Before, Death::Half, Death::After] {
        let behaviour = Behaviour { keeps_targets: death == Death::Before, ..Behaviour::default() };
        let mut outcomes = Vec::new();
        for number in FIRST.. {
            let (bench, pushed) = crashed(number, death, &behaviour);
            let has_died = bench.server.state().is_dead;
            bench.server.behave(behaviour.clone());
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
        assert!(count(|one| matches!(one, RecoveryOutcome::Restored { .. })) > 5);
        assert!(count(|one| *one == RecoveryOutcome::Cancelled) > 20);
        assert!(count(|one| *one == RecoveryOutcome::Completed) > 0);
    }
}

/// The project has the state of the controller, so that a second push does the rest.
fn check_second_push(bench: &Bench, new: &Tree, is_old: bool) {
    assert!(bench.recover().unwrap().is_empty());
    if is_old {
        bench.push().unwrap();
    }
    assert_eq!(shown(&bench.server.state().tree), shown(new));
    assert!(bench.status().unwrap().differences.is_empty());
}

#[test]
fn a_crash_of_the_recovery_is_recovered() {
    let bench = Bench::pulled(Behaviour::default());
    bench.edit();
    let plan = bench.plan().unwrap();
    bench.server.behave(Behaviour::default());
    bench.push_plan(&plan).unwrap();
    let is_last_rename = |line: &String| line.starts_with("RNTO /usr/usrapp/demo/demo.pjx");
    let last_rename = bench.server.state().log.iter().position(is_last_rename).unwrap();
    for number in FIRST.. {
        let (bench, _) = crashed(last_rename, Death::After, &Behaviour::default());
        bench.server.behave(Behaviour { death: Some((number, Death::After)), ..Behaviour::default() });
        let is_complete = bench.recover().is_ok();
        bench.server.behave(Behaviour::default());
        bench.recover().unwrap();
        assert_eq!(shown(&bench.server.state().tree), shown(&tree()), "{number}");
        if is_complete {
            assert!(number > 20);
            break;
        }
    }
}
