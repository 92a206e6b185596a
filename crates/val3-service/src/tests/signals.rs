//! Signals.

use expect_test::expect;
use val3_session::ProfileRights;
use val3_soap::v2::{
    GetAllPhysicalIos, LockAllIos, LockIos, ReadIos, SignalResponse, SignalState, SignalStatus, UnlockAllIos,
    UnlockIos, WriteIos,
};
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::{Client, profile};

const INPUT: &str = r"BasicIO-1\%I0";
const OUTPUT: &str = r"BasicIO-1\%Q0";

fn texts(paths: &[&str]) -> Vec<String> {
    paths.iter().map(|path| (*path).to_owned()).collect()
}

fn read(client: &mut Client, paths: &[&str]) -> Vec<SignalState> {
    match client.ask(SoapRequest::ReadIos(ReadIos { paths: texts(paths), with_description: true })) {
        SoapAnswer::ReadIos(answer) => answer.states,
        other => panic!("{other:?}"),
    }
}

fn value(client: &mut Client, path: &str) -> (f64, bool) {
    let state = read(client, &[path]).remove(0);
    assert_eq!(state.status, SignalStatus::Defined);
    (state.value, state.locked)
}

fn outcome(response: &SignalResponse) -> (bool, bool) {
    (response.success, response.found)
}

fn write(client: &mut Client, paths: &[&str], values: &[f64]) -> Vec<(bool, bool)> {
    match client.ask(SoapRequest::WriteIos(WriteIos { paths: texts(paths), values: values.to_vec() })) {
        SoapAnswer::WriteIos(answer) => answer.responses.iter().map(outcome).collect(),
        other => panic!("{other:?}"),
    }
}

fn lock(client: &mut Client, path: &str, value: f64) {
    match client.ask(SoapRequest::LockIos(LockIos { paths: texts(&[path]), values: vec![value] })) {
        SoapAnswer::LockIos(answer) => assert_eq!(outcome(&answer.responses[0]), (true, true)),
        other => panic!("{other:?}"),
    }
}

#[test]
fn outputs_are_written_and_inputs_only_locked() {
    let mut client = Client::logged_in();
    assert_eq!(
        write(&mut client, &[OUTPUT, INPUT, "%Q0"], &[1.0, 1.0, 1.0]),
        [(true, true), (false, true), (false, false)]
    );
    assert_eq!(value(&mut client, OUTPUT), (1.0, false));
    assert_eq!(value(&mut client, INPUT), (0.0, false));
    lock(&mut client, INPUT, 1.0);
    client.run(1);
    assert_eq!(value(&mut client, INPUT), (1.0, true));
    lock(&mut client, OUTPUT, 0.0);
    assert_eq!(write(&mut client, &[OUTPUT], &[1.0]), [(false, true)]);
    let unlock = UnlockIos { paths: texts(&[INPUT, "x"]), with_description: false };
    match client.ask(SoapRequest::UnlockIos(unlock)) {
        SoapAnswer::UnlockIos(answer) => {
            let unlocked: Vec<_> =
                answer.responses.iter().map(|signal| (outcome(&signal.response), signal.state.locked)).collect();
            assert_eq!(unlocked, [((true, true), false), ((false, false), false)]);
        }
        other => panic!("{other:?}"),
    }
    client.run(1);
    assert_eq!(value(&mut client, INPUT), (0.0, false));
}

#[test]
fn an_unknown_signal_is_a_state() {
    let mut client = Client::logged_in();
    for path in ["%Q0", "BasicIO-1", "bOut0", ""] {
        assert_eq!(read(&mut client, &[path])[0].status, SignalStatus::Undefined, "{path}");
    }
    assert_eq!(read(&mut client, &[]), []);
}

#[test]
fn the_number_of_signals_is_limited() {
    let mut client = Client::logged_in();
    let eleven = ReadIos { paths: vec![INPUT.to_owned(); 11], with_description: false };
    assert_eq!(client.code(SoapRequest::ReadIos(eleven)), ExceptionCode::InvalidParameters);
    let without_value = WriteIos { paths: texts(&[OUTPUT]), values: Vec::new() };
    assert_eq!(client.code(SoapRequest::WriteIos(without_value)), ExceptionCode::InvalidParameters);
}

#[test]
fn all_signals_are_listed_and_locked() {
    let mut client = Client::logged_in();
    let list = match client.ask(SoapRequest::GetAllPhysicalIos(GetAllPhysicalIos)) {
        SoapAnswer::GetAllPhysicalIos(answer) => String::from_utf8(answer.data.data.0).unwrap(),
        other => panic!("{other:?}"),
    };
    let entries: Vec<&str> = list.split("<physicalIo ").skip(1).collect();
    let inputs: Vec<&&str> = entries.iter().filter(|entry| entry.contains("%I0\"")).collect();
    expect![[r#"
        [
            "name=\"BasicIO-1\\%I0\" desc=\"\" type=\"din\" lockable=\"true\"/>",
        ]
    "#]]
    .assert_debug_eq(&inputs);
    let successes = |answer: SoapAnswer| match answer {
        SoapAnswer::LockAllIos(answer) => answer.successes,
        SoapAnswer::UnlockAllIos(answer) => answer.successes,
        other => panic!("{other:?}"),
    };
    assert_eq!(successes(client.ask(SoapRequest::LockAllIos(LockAllIos))), entries.len() as i32);
    assert_eq!(value(&mut client, OUTPUT), (0.0, true));
    assert_eq!(successes(client.ask(SoapRequest::UnlockAllIos(UnlockAllIos))), entries.len() as i32);
    assert_eq!(value(&mut client, OUTPUT), (0.0, false));
}

#[test]
fn writing_needs_a_right() {
    let rights = ProfileRights { read: true, write: true, write_io: false };
    let mut client = Client::with(vec![profile("operator", rights)]);
    client.login("operator", "");
    read(&mut client, &[INPUT]);
    let request = WriteIos { paths: texts(&[OUTPUT]), values: vec![1.0] };
    assert_eq!(client.code(SoapRequest::WriteIos(request)), ExceptionCode::IoWriteAccess);
}
