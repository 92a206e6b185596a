//! The next line of a task.

use val3_soap::v2::{ProgramLine, SetCurrentInstruction, TaskState};
use val3_soap::{ExceptionCode, SoapRequest};

use super::client::Client;
use super::debugging::{PROJECT, execute, line, resume, set, some, suspend, task};

const LEAD: &str = "palletiser~";

fn go(task: &str, line: ProgramLine, reset_motion: bool) -> SoapRequest {
    let (task, created_by) = (some(task), some(PROJECT));
    SoapRequest::SetCurrentInstruction(SetCurrentInstruction { task, created_by, reset_motion, line })
}

#[test]
fn a_held_task_continues_at_another_line() {
    let mut client = Client::logged_in();
    set(&mut client, &[line("start", 3, "")]);
    client.run(1);
    assert_eq!(task(&mut client, LEAD).1, 3);
    client.ask(go(LEAD, line("start", 5, "taskCreate \"host\",10,host(0.5)"), false));
    let (state, number, _) = task(&mut client, LEAD);
    assert_eq!((state, number), (TaskState::Stopped, 5));
    client.run(1);
    assert_eq!(task(&mut client, LEAD).1, 5, "the task stays held");
    client.ask(resume(LEAD));
    client.run(1);
    assert_eq!(task(&mut client, "host").0, TaskState::Running);
    let fault = client.fault(suspend("supervisor"));
    assert_eq!(fault.exception.unwrap().code, ExceptionCode::TaskNotFound, "its line was skipped");
}

#[test]
fn a_task_that_the_application_has_suspended_can_continue() {
    let mut client = Client::logged_in();
    set(&mut client, &[line("start", 2, "")]);
    client.run(1);
    execute(&mut client, "", "taskSuspend(\"palletiser~\")");
    client.ask(go(LEAD, line("start", 6, ""), false));
    client.ask(resume(LEAD));
    client.run(1);
    assert_eq!(task(&mut client, "production").0, TaskState::Running);
}

#[test]
fn moves_are_discarded_on_request() {
    let mut client = Client::logged_in();
    client.run(1);
    while client.controller().arm().is_empty() {
        client.run(1);
    }
    let (_, number, _) = task(&mut client, "production");
    client.ask(suspend("production"));
    client.ask(go("production", line("home", number, ""), false));
    assert!(!client.controller().arm().is_empty());
    client.ask(go("production", line("home", number, ""), true));
    assert!(client.controller().arm().is_empty());
}

#[test]
fn the_line_must_be_an_instruction_of_the_innermost_program() {
    let mut client = Client::logged_in();
    client.run(2);
    assert_eq!(client.code(go("production", line("home", 14, ""), false)), ExceptionCode::Unknown);
    client.ask(suspend("production"));
    for (line, code) in [
        (line("home", 2, ""), ExceptionCode::ProgramLineNotFound),
        (line("home", 99, ""), ExceptionCode::ProgramLineNotFound),
        (line("home", 14, "x=1"), ExceptionCode::MismatchedCode),
        (line("production", 3, ""), ExceptionCode::ProgramNotFound),
    ] {
        assert_eq!(client.code(go("production", line.clone(), false)), code, "{line:?}");
    }
    assert_eq!(client.code(go("nobody", line("home", 14, ""), false)), ExceptionCode::TaskNotFound);
}
