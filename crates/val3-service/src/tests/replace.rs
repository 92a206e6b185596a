//! Replaced lines.

use serde_json::{Map, Value, json};
use val3_machine::event::EventKind;
use val3_machine::script::ScriptAction;
use val3_session::ProfileRights;
use val3_soap::v1::GetApplicationDatas;
use val3_soap::v2::{
    ExecVal3, GetTasks, ProgramLine, ReplaceLine, ReplacementResult, SetProjectAsModified, StopAndUnloadAll, TaskState,
};
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::{Client, profile};
use super::debugging::{PROJECT, execute, line, resume, set, some, suspend, task};

fn request(line: ProgramLine, code: &str) -> SoapRequest {
    SoapRequest::ReplaceLine(ReplaceLine { line, new_line: some(code) })
}

#[track_caller]
fn replace(client: &mut Client, line: ProgramLine, code: &str) -> (ReplacementResult, String) {
    match client.ask(request(line, code)) {
        SoapAnswer::ReplaceLine(answer) => (answer.code, answer.output.unwrap()),
        other => panic!("{other:?}"),
    }
}

#[track_caller]
fn done(client: &mut Client, line: ProgramLine, code: &str) {
    assert_eq!(replace(client, line, code), (ReplacementResult::NoError, String::new()), "{code}");
}

fn value(client: &mut Client, name: &str) -> f64 {
    execute(client, "", name).1.parse().unwrap()
}

/// Texts of the event log about clients, and the actions, since the last call.
fn log(client: &mut Client) -> (Vec<String>, Vec<Map<String, Value>>) {
    let (mut texts, mut actions) = (Vec::new(), Vec::new());
    for event in client.controller().devices.take_events() {
        match event.kind {
            EventKind::Log { text, .. } if text.contains("client") => texts.push(text),
            EventKind::Act { keys } => actions.push(keys),
            _ => {}
        }
    }
    (texts, actions)
}

#[test]
fn a_running_task_continues_with_the_new_line() {
    let mut client = Client::logged_in();
    client.run(2);
    set(&mut client, &[line("supervisor", 10, "")]);
    client.run(1);
    assert_eq!(task(&mut client, "supervisor"), (TaskState::Stopped, 10, "delay(0.2)".to_owned()));
    execute(&mut client, "", "nTimes[3]=0");
    done(&mut client, line("supervisor", 9, "call drawScreen()"), "nTimes[3]=nTimes[3]+2*(17-getKey()*0)");
    assert_eq!(task(&mut client, "supervisor"), (TaskState::Stopped, 10, "delay(0.2)".to_owned()));
    client.ask(resume("supervisor"));
    client.run(1);
    assert_eq!(task(&mut client, "supervisor"), (TaskState::Stopped, 10, "delay(0.2)".to_owned()));
    assert_eq!(value(&mut client, "nTimes[3]"), 34.0);
    // The new line has another text and can be replaced by a comment, and by an instruction again.
    let mismatch = client.code(request(line("supervisor", 9, "call drawScreen()"), ""));
    assert_eq!(mismatch, ExceptionCode::MismatchedCode);
    done(&mut client, line("supervisor", 9, "nTimes[3]=nTimes[3]+2*(17-getKey()*0)"), "// nothing");
    client.ask(resume("supervisor"));
    client.run(1);
    assert_eq!(value(&mut client, "nTimes[3]"), 34.0);
    done(&mut client, line("supervisor", 9, "// nothing"), "nTimes[3]=nTimes[3]+1000.5");
    client.ask(resume("supervisor"));
    client.run(1);
    assert_eq!(task(&mut client, "supervisor").1, 10);
    assert_eq!(value(&mut client, "nTimes[3]"), 1034.5);
}

/// `production` has called `home` with a variable by reference, whose place on the stack changes.
#[test]
fn references_to_variables_of_callers_remain() {
    let mut client = Client::logged_in();
    client.run(2);
    assert_eq!(task(&mut client, "production").1, 14, "it waits for the power in `home`");
    done(&mut client, line("production", 5, "nState=1"), "nState=11+nLayer*1013-nLayer*(1009+4)");
    done(&mut client, line("home", 3, ""), "x_bOk=isInRange(jHome) or nLayer==123457");
    done(&mut client, line("home", 2, ""), "// another note");
    assert_eq!(execute(&mut client, "production", "x_bOk").1, "true");
    execute(&mut client, "production", "x_bOk=false");
    assert_eq!(execute(&mut client, "production", "x_bOk").1, "false");
    execute(&mut client, "production", "x_bOk=true");
    client.controller().devices.state.robot.set_power(true);
    client.run(60);
    assert_eq!(value(&mut client, "nState"), 11.0);
    let (state, number, _) = task(&mut client, "production");
    assert_eq!((state, number), (TaskState::Running, 6));
}

#[test]
fn results_name_the_reason() {
    use ReplacementResult as R;
    let mut client = Client::logged_in();
    client.run(2);
    client.ask(suspend("host"));
    let busy = replace(&mut client, line("supervisor", 10, ""), "delay(0.3)");
    assert_eq!(busy, (R::InstructionBusy, "a task executes the line: wait until it has left it".to_owned()));
    let busy = replace(&mut client, line("production", 3, ""), "call home(l_bOk )");
    assert_eq!(busy.0, R::InstructionBusy, "in a call from the line");
    for (at, code, expected) in [
        (("supervisor", 9), "call nothing()", R::CompilationError),
        (("supervisor", 9), "x=", R::CompilationError),
        (("supervisor", 9), "if bRun", R::InstructionControl),
        (("supervisor", 6), "call drawScreen()", R::InstructionControl),
        (("supervisor", 1), "begin", R::InstructionControl),
        (("supervisor", 12), "end", R::InstructionControl),
    ] {
        let (program, number) = at;
        let (result, text) = replace(&mut client, line(program, number, ""), code);
        assert_eq!(result, expected, "{code}");
        assert!(!text.is_empty());
    }
    assert_eq!(client.code(request(line("supervisor", 99, ""), "")), ExceptionCode::ProgramLineNotFound);
    assert_eq!(client.code(request(line("nothing", 2, ""), "")), ExceptionCode::ProgramNotFound);
    // A program that no task executes can change its loops.
    done(&mut client, line("cycle", 3, ""), "// nothing");
}

#[test]
fn a_breakpoint_remains_at_its_line() {
    let mut client = Client::logged_in();
    client.run(2);
    set(&mut client, &[line("supervisor", 9, "")]);
    client.run(1);
    assert_eq!(task(&mut client, "supervisor").1, 9);
    done(&mut client, line("supervisor", 8, "call watchTasks()"), "nTimes[3]=4711");
    done(&mut client, line("supervisor", 9, ""), "nTimes[3]=nTimes[3]+1");
    client.ask(resume("supervisor"));
    client.run(1);
    assert_eq!(task(&mut client, "supervisor"), (TaskState::Stopped, 9, "nTimes[3]=nTimes[3]+1".to_owned()));
    assert_eq!(value(&mut client, "nTimes[3]"), 4711.0);
}

/// An application that calls a program of a library with a variable by reference.
const LIBRARY: &str = r#"
library part "Disk://part/part.pjx"
num nCount
program start()
begin
  while true
    call part:grow(nCount)
    delay(0.1)
  endWhile
end
program stop()
begin
end
--- part
public num nStep
public program grow(num& x_n)
begin
  x_n=x_n+1
  delay(0.02)
end
"#;

#[test]
fn a_line_of_a_library_is_replaced() {
    let mut client = Client::of_listing(LIBRARY);
    client.run(1);
    let project = some("Disk://part/part.pjx");
    let at = |number| ProgramLine { project: project.clone(), program: some("grow"), number, content: None };
    done(&mut client, at(2), "x_n=x_n+1000+nStep");
    client.run(1);
    let request = ExecVal3 { project: some("main"), task: None, created_by: None, frame: 0, command: some("nCount") };
    let SoapAnswer::ExecVal3(answer) = client.ask(SoapRequest::ExecVal3(request)) else { panic!("another answer") };
    assert!(answer.output.unwrap().parse::<f64>().unwrap() > 1000.0);
    let found = client.ask(SoapRequest::GetTasks(GetTasks));
    let SoapAnswer::GetTasks(found) = found else { panic!("{found:?}") };
    assert!(found.tasks.iter().all(|task| task.error == 0 && task.state == TaskState::Running), "{found:?}");
}

#[test]
fn changes_are_reported_and_end_with_the_project_in_memory() {
    let mut client = Client::logged_in();
    client.run(1);
    client.controller().devices.take_events();
    done(&mut client, line("cycle", 2, ""), "// changed");
    client.ask(SoapRequest::SetProjectAsModified(SetProjectAsModified { project: some("palletiser") }));
    let (texts, actions) = log(&mut client);
    assert_eq!(texts, ["Disk://palletiser/palletiser.pjx was changed in memory by a client; its files are unchanged"]);
    // The first line of the code is at row 14 of the file. A replay cannot repeat the action.
    let action = json!({ "project": "palletiser", "program": "cycle", "line": 15, "code": "// changed" });
    assert_eq!(json!(actions), json!([{ "replaceLine": action }]));
    assert!(actions.into_iter().all(|keys| ScriptAction::from_json(keys).is_err()));
    client.ask(SoapRequest::GetApplicationDatas(GetApplicationDatas { name: some(PROJECT) }));
    client.ask(SoapRequest::StopAndUnloadAll(StopAndUnloadAll));
    let (texts, _) = log(&mut client);
    assert!(texts.iter().any(|text| text.contains("leaves the memory with changes of a client")), "{texts:?}");
    let unknown = SetProjectAsModified { project: some("nothing") };
    assert_eq!(client.code(SoapRequest::SetProjectAsModified(unknown)), ExceptionCode::ApplicationNotFound);
}

#[test]
fn a_reader_replaces_no_line() {
    let reader = ProfileRights { read: true, write: false, write_io: false };
    let mut client = Client::with(vec![profile("reader", reader)]);
    client.login("reader", "");
    let mark = SoapRequest::SetProjectAsModified(SetProjectAsModified { project: some("palletiser") });
    for request in [request(line("cycle", 2, ""), ""), mark] {
        assert_eq!(client.code(request), ExceptionCode::WriteAccess);
    }
}
