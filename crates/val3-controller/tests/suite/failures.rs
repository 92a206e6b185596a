//! Failures of the server during a transfer: the controller keeps the old application, and the message has the cause.

use expect_test::{Expect, expect};
use val3_controller::{ControllerError, FailureOutcome, RecoveryOutcome};

use crate::bench::{Bench, NOW, path, shown, tree};
use crate::server::Behaviour;

/// Pushes to a misbehaving server. The controller must have its old files, and no trace of the push.
fn failed(behaviour: Behaviour) -> (String, FailureOutcome) {
    let bench = Bench::pulled(Behaviour::default());
    bench.edit();
    let plan = bench.plan().unwrap();
    bench.server.behave(behaviour);
    let failure = bench.push_plan(&plan).unwrap_err();
    assert_eq!(shown(&bench.server.state().tree), shown(&tree()), "{failure:?}");
    assert_eq!(bench.server.state().tree.folders, tree().folders);
    let place = bench.server.address().server.port.to_string();
    (failure.error.to_string().replace(&place, "PORT"), failure.outcome)
}

fn check_unchanged(behaviour: Behaviour, message: &Expect) {
    let (error, outcome) = failed(behaviour);
    message.assert_eq(&error);
    assert_eq!(outcome, FailureOutcome::Unchanged);
}

#[test]
fn a_failed_upload_leaves_no_trace() {
    let base = Behaviour::default;
    check_unchanged(
        Behaviour { rejections: vec![("STOR", "550 no rights")], ..base() },
        &expect!["cannot write `usr/usrapp/val3.lock` at 127.0.0.1:PORT: 550 no rights"],
    );
    check_unchanged(
        Behaviour { rejections: vec![("STOR /usr/usrapp/demo/start.pgx", "553 no")], ..base() },
        &expect!["cannot write `usr/usrapp/demo/start.pgx.val3tmp` at 127.0.0.1:PORT: 553 no"],
    );
    check_unchanged(
        Behaviour { rejections: vec![("RETR /usr/usrapp/demo/demo.dtx", "550 no")], ..base() },
        &expect!["cannot read `usr/usrapp/demo/demo.dtx` at 127.0.0.1:PORT: 550 no"],
    );
    check_unchanged(
        Behaviour { space: Some(70), ..base() },
        &expect!["cannot write `usr/usrapp/demo/demo.pjx.val3tmp` at 127.0.0.1:PORT: 452 Insufficient storage space"],
    );
    check_unchanged(
        Behaviour { breaks: Some("STOR /usr/usrapp/demo/start"), ..base() },
        &expect!["cannot write `usr/usrapp/demo/start.pgx.val3tmp` at 127.0.0.1:PORT: 426 data connection lost"],
    );
    check_unchanged(
        Behaviour { breaks: Some("RETR /usr/usrapp/demo/demo.dtx.val3tmp"), ..base() },
        &expect!["cannot read `usr/usrapp/demo/demo.dtx.val3tmp` at 127.0.0.1:PORT: 426 data connection lost"],
    );
    check_unchanged(
        Behaviour { rejections: vec![("MKD", "550 no")], ..base() },
        &expect!["cannot create the folder `usr/usrapp/new` at 127.0.0.1:PORT: 550 no"],
    );
}

#[test]
fn a_failed_rename_is_undone() {
    for start in ["RNFR /usr/usrapp/demo/start.pgx.val3tmp", "RNFR /usr/usrapp/demo/demo.pjx.val3tmp"] {
        let bench = Bench::pulled(Behaviour::default());
        bench.edit();
        let plan = bench.plan().unwrap();
        bench.server.behave(Behaviour { rejections: vec![(start, "450 busy")], ..Behaviour::default() });
        let failure = bench.push_plan(&plan).unwrap_err();
        assert!(failure.error.to_string().contains("450 busy"), "{}", failure.error);
        assert!(matches!(failure.outcome, FailureOutcome::Restored(RecoveryOutcome::Restored { .. })), "{failure:?}");
        assert_eq!(shown(&bench.server.state().tree), shown(&tree()));
    }
}

#[test]
fn a_rejected_removal_is_undone() {
    let (error, outcome) =
        failed(Behaviour { rejections: vec![("DELE /usr/usrapp/tools", "550 no")], ..Behaviour::default() });
    expect!["cannot remove `usr/usrapp/tools/grip.pgx` at 127.0.0.1:PORT: 550 no"].assert_eq(&error);
    assert_eq!(outcome, FailureOutcome::Restored(RecoveryOutcome::Restored { count: 4, kept: Vec::new() }));
}

#[test]
fn a_silent_server_ends_the_push_after_the_timeout() {
    let bench = Bench::pulled(Behaviour::default());
    bench.edit();
    let plan = bench.plan().unwrap();
    bench.server.behave(Behaviour { silence: Some("STOR /usr/usrapp/demo"), ..Behaviour::default() });
    let failure = bench.push_plan(&plan).unwrap_err();
    assert!(failure.error.to_string().ends_with("the controller does not respond in time"), "{}", failure.error);
    // The second connection has removed the lock and the new folder.
    assert_eq!(failure.outcome, FailureOutcome::Unchanged);
    assert_eq!(shown(&bench.server.state().tree), shown(&tree()));
}

#[test]
fn a_file_that_changes_during_the_push_is_kept() {
    for command in ["RETR /usr/usrapp/demo/demo.dtx", "STOR /usr/usrapp/demo/start.pgx", "RETR /usr/usrapp/val3.lock"] {
        let bench = Bench::pulled(Behaviour::default());
        bench.edit();
        let plan = bench.plan().unwrap();
        let change = Some((command, "/usr/usrapp/demo/demo.dtx", &b"operator"[..]));
        bench.server.behave(Behaviour { change, ..Behaviour::default() });
        let failure = bench.push_plan(&plan).unwrap_err();
        assert_eq!(failure.error, ControllerError::ChangedMeanwhile(path("usr/usrapp/demo/demo.dtx")), "{command}");
        let mut expected = tree();
        expected.files.insert("/usr/usrapp/demo/demo.dtx".into(), b"operator".to_vec());
        assert_eq!(shown(&bench.server.state().tree), shown(&expected));
    }
}

#[test]
fn a_second_push_waits_for_the_lock() {
    let lock = |time: u64| format!("val3 push by you at shop\ntime {time}\n").into_bytes();
    let bench = Bench::pulled(Behaviour::default());
    bench.edit();
    bench.server.state().tree.files.insert("/usr/usrapp/val3.lock".into(), lock(NOW - 60));
    let failure = bench.push().unwrap_err();
    assert_eq!(failure.error, ControllerError::Locked { owner: "val3 push by you at shop".into(), ahead: 0 });
    assert_eq!(failure.outcome, FailureOutcome::Unchanged);
    assert!(bench.recover().unwrap().is_empty());
    bench.server.state().tree.files.insert("/usr/usrapp/val3.lock".into(), lock(NOW - 700));
    bench.push().unwrap();
}

/// A clock that is ahead would hold the lock until its time has come.
#[test]
fn a_lock_from_the_future_has_a_remedy() {
    let bench = Bench::pulled(Behaviour::default());
    bench.edit();
    let lock = |ahead: u64| format!("val3 push by you at shop\ntime {}\n", NOW + ahead).into_bytes();
    for (ahead, expected) in [(590, 0), (70_000, 70_000)] {
        bench.server.state().tree.files.insert("/usr/usrapp/val3.lock".into(), lock(ahead));
        let failure = bench.push().unwrap_err();
        assert_eq!(failure.outcome, FailureOutcome::Unchanged);
        let locked = ControllerError::Locked { owner: "val3 push by you at shop".into(), ahead: expected };
        assert_eq!(failure.error, locked);
    }
    let error = bench.push().unwrap_err().error;
    expect![
        "another push may be running: val3 push by you at shop, whose clock is 1166 minutes ahead of the clock here"
    ]
    .assert_eq(&error.to_string());
    assert!(error.help().contains("remove `usr/usrapp/val3.lock`"));
    bench.server.state().tree.files.remove("/usr/usrapp/val3.lock");
    bench.push().unwrap();
}

#[test]
fn a_pull_that_fails_changes_no_local_file() {
    for behaviour in [
        Behaviour { breaks: Some("RETR /usr/usrapp/tools"), ..Behaviour::default() },
        Behaviour { breaks: Some("MLSD"), ..Behaviour::default() },
        Behaviour { rejections: vec![("RETR /usr/usrapp/tools/grip.pgx", "550 no")], ..Behaviour::default() },
    ] {
        let bench = Bench::empty(behaviour);
        bench.pull().unwrap_err();
        assert!(!bench.folder.join("usr").exists() && !bench.folder.join(".val3/controller.toml").exists());
    }
}

#[test]
fn a_wrong_password_has_a_help() {
    let bench = Bench::empty(Behaviour { password: "secret", ..Behaviour::default() });
    let error = bench.server.try_connect("wrong").unwrap_err();
    let message = error.to_string().replace(&bench.server.address().server.port.to_string(), "PORT");
    expect!["cannot log in at 127.0.0.1:PORT: 530 Login incorrect"].assert_eq(&message);
    let help = ControllerError::from(error).help();
    assert!(help.contains("connectionPassword"));
    let files = bench.server.try_connect("secret").unwrap();
    assert!(!format!("{files:?}").contains("secret"));
}
