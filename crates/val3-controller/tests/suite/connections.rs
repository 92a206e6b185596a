//! Data connections in active mode, and connections that the server closes.

use expect_test::expect;
use val3_controller::{AccessFault, ControllerError, ControllerFiles as _, FailureOutcome};

use crate::bench::{Bench, path, shown, tree};
use crate::server::{Behaviour, ListForm, Server};

/// Error message without the port.
fn message(server: &Server, error: &ControllerError) -> String {
    error.to_string().replace(&server.address().server.port.to_string(), "PORT")
}

fn is_active(server: &Server) -> bool {
    let log = &server.state().log;
    log.iter().any(|line| line.starts_with("PORT ")) && !log.iter().any(|line| line == "PASV")
}

#[test]
fn in_active_mode_the_controller_opens_the_data_connections() {
    for form in [ListForm::Mlsd, ListForm::Names] {
        let mut bench = Bench::empty(Behaviour { form, ..Behaviour::default() });
        bench.server.is_active = true;
        bench.pull().unwrap();
        bench.edit();
        bench.push().unwrap();
        assert!(bench.status().unwrap().differences.is_empty() && is_active(&bench.server));
    }
}

#[test]
fn a_controller_that_cannot_connect_to_this_computer_has_a_remedy() {
    let rejected = Behaviour { rejections: vec![("PORT", "425 Cannot connect")], ..Behaviour::default() };
    let mut bench = Bench::empty(rejected);
    bench.server.is_active = true;
    let error = bench.pull().unwrap_err();
    expect!["cannot list `/` at 127.0.0.1:PORT: the controller cannot open the data connection to this computer: 425 Cannot connect"]
        .assert_eq(&message(&bench.server, &error));
    assert!(error.help().contains("--passive"));
    for behaviour in [
        // It waits for its own connection before it replies, or replies and does not connect.
        Behaviour { silence: Some("MLSD"), ..Behaviour::default() },
        Behaviour { rejections: vec![("MLSD", "150 opening")], ..Behaviour::default() },
    ] {
        bench.server.behave(behaviour);
        let error = bench.pull().unwrap_err();
        expect![
            "cannot list `/` at 127.0.0.1:PORT: the controller has not opened the data connection to this computer"
        ]
        .assert_eq(&message(&bench.server, &error));
    }
}

#[test]
fn a_connection_that_was_idle_for_too_long_is_opened_again_for_reading() {
    for (closes, has_reply) in [("CWD", true), ("MLSD", false), ("PASV", true), ("RETR", false), ("RETR", true)] {
        let bench = Bench::empty(Behaviour { closes: Some((closes, has_reply)), ..Behaviour::default() });
        bench.pull().unwrap();
        assert_eq!(bench.server.state().behaviour.closes, None);
        assert!(bench.status().unwrap().differences.is_empty(), "{closes}");
    }
}

#[test]
fn a_change_is_not_repeated_after_the_connection_was_closed() {
    for (has_reply, cause) in [(true, "421 idle"), (false, "the controller has closed the connection")] {
        let bench = Bench::pulled(Behaviour::default());
        bench.edit();
        let plan = bench.plan().unwrap();
        bench.server.behave(Behaviour { closes: Some(("STOR /usr/usrapp/demo", has_reply)), ..Behaviour::default() });
        let failure = bench.push_plan(&plan).unwrap_err();
        assert!(failure.error.to_string().ends_with(cause), "{}", failure.error);
        assert!(failure.error.help().starts_with("repeat the command"));
        assert_eq!(failure.outcome, FailureOutcome::Unchanged);
        assert_eq!(shown(&bench.server.state().tree), shown(&tree()));
    }
}

#[test]
fn a_server_that_closes_each_connection_ends_the_command() {
    let bench = Bench::pulled(Behaviour::default());
    bench.server.behave(Behaviour { rejections: vec![("CWD", "421 too many users")], ..Behaviour::default() });
    let error = bench.status().unwrap_err();
    assert!(error.to_string().ends_with("421 too many users"), "{error}");
    let attempts = bench.server.state().log.iter().filter(|line| line.starts_with("CWD")).count();
    assert_eq!((attempts, bench.text(path("usr/usrapp/demo/start.pgx").as_str())), (2, "start".to_owned()));
}

#[test]
fn replies_to_an_interrupted_transfer_are_not_read_as_replies_to_the_next_command() {
    let file = path("usr/usrapp/demo/start.pgx");
    let second_reply = Some("RETR");
    let server = Server::start(tree(), Behaviour { second_reply, ..Behaviour::default() });
    let mut files = server.connect();
    let error = files.read(&file, 3).unwrap_err();
    assert!(matches!(error.reason, AccessFault::TooLarge(3)), "{error}");
    server.behave(Behaviour::default());
    assert_eq!(files.read(&file, 100).unwrap(), b"start");
    files.remove(&file).unwrap();
    assert!(!server.state().tree.files.contains_key("/usr/usrapp/demo/start.pgx"));
}
