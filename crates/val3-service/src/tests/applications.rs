//! Loading, starting, stopping and unloading.

use val3_session::ProfileRights;
use val3_soap::v1::GetApplications;
use val3_soap::v2::{
    ExecutionResult, LoadProjectAsync, StartApplication, StopAndUnloadAll, StopApplication, TaskState,
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
    let mut client = Client::logged_in();
    client.run(1);
    let snapshot = client.controller().snapshot();
    for request in [UNLOAD, load(PROJECT), start(PROJECT)] {
        client.ask(request);
    }
    client.controller().devices.take_events();
    client.run(2);
    let first = client.controller().devices.take_events();
    client.controller().restore(&snapshot);
    client.controller().devices.take_events();
    client.run(2);
    assert!(first.iter().any(|event| format!("{event:?}").contains("unload")), "{first:?}");
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

#[test]
fn only_the_application_of_the_run_is_executed() {
    let mut client = Client::logged_in();
    client.run(1);
    let reason = "APPLICATION-NOT-FOUND: this controller executes only the application of the run, \
                  Disk://palletiser/palletiser.pjx";
    for request in [load("Disk://partBag/partBag.pjx"), start("Disk://other/other.pjx"), start("palletiser")] {
        assert_eq!(client.fault(request).reason, reason);
    }
    client.ask(load(PROJECT));
    assert_eq!(client.code(start(PROJECT)), ExceptionCode::Unknown);
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
