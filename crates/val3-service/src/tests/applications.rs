//! Loading, starting, stopping and unloading.

use val3_session::ProfileRights;
use val3_soap::v1::{GetApplicationDatas, GetApplications};
use val3_soap::v2::{
    ExecVal3, ExecutionResult, LoadProjectAsync, ProgramLine, StartApplication, StopAndUnloadAll, StopApplication,
    TaskState,
};
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::{Client, profile};
use super::debugging::{PROJECT, execute, line, set, some, task, tasks};

const STOP: SoapRequest = SoapRequest::StopApplication(StopApplication);

const UNLOAD: SoapRequest = SoapRequest::StopAndUnloadAll(StopAndUnloadAll);

fn load(name: &str) -> SoapRequest {
    SoapRequest::LoadProjectAsync(LoadProjectAsync { path: some(name) })
}

fn start(name: &str) -> SoapRequest {
    SoapRequest::StartApplication(StartApplication { path: some(name) })
}

/// Names of the projects in memory.
fn loaded(client: &mut Client) -> Vec<String> {
    match client.ask(SoapRequest::GetApplications(GetApplications)) {
        SoapAnswer::GetApplications(answer) => {
            answer.applications.into_iter().filter(|found| found.loaded).filter_map(|found| found.name).collect()
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_stopped_application_starts_with_its_values() {
    let mut client = Client::logged_in();
    client.run(2);
    execute(&mut client, "", "nTimes[3]=5");
    client.ask(STOP);
    client.run(1);
    assert_eq!(tasks(&mut client), []);
    client.ask(STOP);
    assert_eq!(execute(&mut client, "", "nTimes[3]").1, "5");
    client.ask(start(PROJECT));
    client.run(1);
    assert_eq!(task(&mut client, "supervisor").0, TaskState::Running);
    assert_eq!(execute(&mut client, "", "nTimes[3]").1, "5");
}

#[test]
fn an_unloaded_application_loses_its_values() {
    let mut client = Client::logged_in();
    client.run(2);
    let before = loaded(&mut client);
    execute(&mut client, "", "nTimes[3]=5");
    client.ask(UNLOAD);
    client.run(1);
    assert_eq!(loaded(&mut client), Vec::<String>::new());
    assert_eq!(client.code(start(PROJECT)), ExceptionCode::ApplicationNotFound);
    client.ask(load(PROJECT));
    client.run(1);
    assert_eq!(loaded(&mut client), before);
    assert_eq!(tasks(&mut client), []);
    assert_eq!(execute(&mut client, "", "nTimes[3]").1, "0");
    client.ask(start(PROJECT));
    client.run(1);
    assert_eq!(task(&mut client, "supervisor").0, TaskState::Running);
}

#[test]
fn requests_wait_until_the_application_has_stopped() {
    let mut client = Client::logged_in();
    client.run(1);
    let first = tasks(&mut client);
    execute(&mut client, "", "nTimes[3]=5");
    for request in [UNLOAD, load(PROJECT), load(PROJECT), start(PROJECT)] {
        client.ask(request);
    }
    assert_eq!(client.code(start(PROJECT)), ExceptionCode::Unknown);
    client.run(1);
    assert_eq!(tasks(&mut client).len(), first.len());
    assert_eq!(execute(&mut client, "", "nTimes[3]"), (ExecutionResult::NoError, "0".to_owned()));
}

#[test]
fn a_restored_controller_repeats_the_restart() {
    assert_repeated_after_a_restore(&mut Client::logged_in(), PROJECT, "unload");
}

/// Asserts that a restored controller repeats the replacement of the present application, with an event that contains
/// `text`.
fn assert_repeated_after_a_restore(client: &mut Client, application: &str, text: &str) {
    client.run(1);
    let snapshot = client.controller().snapshot();
    for request in [UNLOAD, load(application), start(application)] {
        client.ask(request);
    }
    client.controller().devices.take_events();
    client.run(2);
    let first = client.controller().devices.take_events();
    client.controller().restore(&snapshot);
    client.controller().devices.take_events();
    client.run(2);
    assert!(first.iter().any(|event| format!("{event:?}").contains(text)), "{first:?}");
    assert_eq!(client.controller().devices.take_events(), first);
}

#[test]
fn breakpoints_remain_for_the_next_start() {
    let mut client = Client::logged_in();
    client.run(1);
    set(&mut client, &[line("start", 3, "")]);
    for request in [UNLOAD, load(PROJECT), start(PROJECT)] {
        client.ask(request);
    }
    client.run(1);
    let (state, number, _) = task(&mut client, "palletiser~");
    assert_eq!((state, number), (TaskState::Stopped, 3));
}

/// Two applications, a project with an error, and a library.
const PROJECTS: &str = r#"
num nCount
program start()
begin
  while true
    nCount=nCount+1
    delay(0.1)
  endWhile
end
program stop()
begin
  nCount=-1
  delay(0.5)
end
--- other
num nOther
program start()
begin
  nOther=7
  while true
    delay(0.1)
    nOther=nOther+1
  endWhile
end
program stop()
begin
end
--- faulty
program start()
begin
  nUnknown=1
end
program stop()
begin
end
--- parts
public num nParts
"#;

const MAIN: &str = "Disk://main/main.pjx";
const OTHER: &str = "Disk://other/other.pjx";

fn evaluate(client: &mut Client, project: &str, code: &str) -> String {
    let request = ExecVal3 { project: some(project), task: None, created_by: None, frame: 0, command: some(code) };
    match client.ask(SoapRequest::ExecVal3(request)) {
        SoapAnswer::ExecVal3(answer) => answer.output.unwrap(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn another_application_of_the_disk_is_loaded_and_started() {
    let mut client = Client::of_listing(PROJECTS);
    client.run(1);
    assert_eq!(loaded(&mut client), [MAIN]);
    assert!(client.fault(load(OTHER)).reason.contains("Disk://main/main.pjx is in memory: unload it first"));
    assert_eq!(client.code(start(OTHER)), ExceptionCode::ApplicationNotFound);
    // All requests are accepted while `stop` still runs.
    for request in [UNLOAD, load("disk://OTHER/other.pjx"), start(OTHER)] {
        client.ask(request);
    }
    client.run(2);
    assert_eq!(loaded(&mut client), [OTHER]);
    let found = tasks(&mut client);
    let [only] = found.as_slice() else { panic!("{found:?}") };
    assert_eq!((only.name.as_deref(), only.created_by.as_deref()), (Some("other~"), Some(OTHER)));
    assert!([4, 5].contains(&only.line.number), "{only:?}");
    assert!(evaluate(&mut client, "other", "nOther").parse::<f64>().unwrap() > 7.0);
    let data = SoapRequest::GetApplicationDatas(GetApplicationDatas { name: some(OTHER) });
    assert!(matches!(client.ask(data), SoapAnswer::GetApplicationDatas(answer) if !answer.data.0.is_empty()));
    assert_eq!(
        set(&mut client, &[ProgramLine { project: some(OTHER), ..line("start", 5, "") }]),
        [ExceptionCode::Unknown]
    );
    client.run(1);
    assert_eq!(tasks(&mut client)[0].state, TaskState::Stopped);
    for request in [UNLOAD, load(MAIN), start(MAIN)] {
        client.ask(request);
    }
    client.run(1);
    assert_eq!(loaded(&mut client), [MAIN]);
    assert!(evaluate(&mut client, "main", "nCount").parse::<f64>().unwrap() >= 1.0);
}

#[test]
fn a_restored_controller_repeats_the_change_of_applications() {
    assert_repeated_after_a_restore(&mut Client::of_listing(PROJECTS), OTHER, "Disk://other");
}

#[test]
fn loading_reads_the_files_and_reports_their_errors() {
    let mut client = Client::of_listing(PROJECTS);
    client.ask(UNLOAD);
    client.run(2);
    let fault = client.fault(load("Disk://faulty/faulty.pjx"));
    assert!(fault.reason.contains("the project cannot be loaded: start.pgx:"), "{}", fault.reason);
    assert!(fault.reason.contains("nUnknown"), "{}", fault.reason);
    for name in ["Disk://nothing/nothing.pjx", "main", ""] {
        assert_eq!(client.code(load(name)), ExceptionCode::ApplicationNotFound, "{name}");
    }
    client.ask(load("Disk://parts/parts.pjx"));
    client.run(1);
    let fault = client.fault(start("Disk://parts/parts.pjx"));
    assert!(fault.reason.contains("it has no program `start`"), "{}", fault.reason);
    client.ask(UNLOAD);
    client.run(1);
    let file = client.disk().join("main/start.pgx");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replace("nCount=nCount+1", "nCount=nCount+1000")).unwrap();
    for request in [load(MAIN), start(MAIN)] {
        client.ask(request);
    }
    client.run(1);
    assert!(evaluate(&mut client, "main", "nCount").parse::<f64>().unwrap() >= 1000.0);
    let changed = tasks(&mut client)[0].line.clone();
    assert!(changed.content.is_some(), "{changed:?}");
}

#[test]
fn a_reader_changes_no_application() {
    let reader = ProfileRights { read: true, write: false, write_io: false };
    let mut client = Client::with(vec![profile("reader", reader)]);
    client.login("reader", "");
    for request in [STOP, UNLOAD, load(PROJECT), start(PROJECT)] {
        assert_eq!(client.code(request), ExceptionCode::WriteAccess);
    }
}
