//! Stack frames, watches and projects.

use std::io::Read as _;

use expect_test::expect;
use val3_soap::v2::{ExecutionResult, GetProject, GetStackFrame, GetWatches, MimeData, WatchedData};
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::Client;
use super::debugging::{PROJECT, execute, line, set, some};

/// Lines of the data in a document, without the indentation of the list.
#[track_caller]
fn data_lines(MimeData { content_type, data }: MimeData) -> String {
    assert_eq!(content_type.as_deref(), Some("text/xml"));
    let text = String::from_utf8(data.0).unwrap();
    let data = text.split_once("<Datas>\n").and_then(|(_, rest)| rest.split_once("  </Datas>"));
    let lines = data.map(|(data, _)| data).unwrap_or_default().lines();
    lines.map(|line| format!("{}\n", line.strip_prefix("    ").unwrap())).collect()
}

fn frame(task: &str, frame: i32) -> SoapRequest {
    SoapRequest::GetStackFrame(GetStackFrame { task: some(task), created_by: some(PROJECT), frame })
}

#[track_caller]
fn frame_lines(client: &mut Client, task: &str, number: i32) -> String {
    match client.ask(frame(task, number)) {
        SoapAnswer::GetStackFrame(answer) => data_lines(answer.data),
        other => panic!("{other:?}"),
    }
}

fn watches(watches: &[(&str, &str)]) -> SoapRequest {
    let watched =
        |(name, index): &(&str, &str)| WatchedData { project: some(PROJECT), name: some(name), index: some(index) };
    SoapRequest::GetWatches(GetWatches { watches: watches.iter().map(watched).collect() })
}

#[track_caller]
fn watch_lines(client: &mut Client, data: &[(&str, &str)]) -> String {
    match client.ask(watches(data)) {
        SoapAnswer::GetWatches(answer) => data_lines(answer.data),
        other => panic!("{other:?}"),
    }
}

#[test]
fn parameters_and_locals_of_a_stack_frame_are_data() {
    let mut client = Client::logged_in();
    set(&mut client, &[line("home", 8, "")]);
    client.run(2);
    expect![[r#"
            <Data name="x_bOk" access="private" xsi:type="array" type="bool" size="1">
              <Value key="0" value="true" />
            </Data>
            <Data name="l_jAway" access="private" xsi:type="array" type="jointRx" size="1" />
            <Data name="l_pUp" access="private" xsi:type="array" type="pointRx" size="1" />
    "#]]
    .assert_eq(&frame_lines(&mut client, "production", 0));
    expect![[r#"
            <Data name="l_bOk" access="private" xsi:type="array" type="bool" size="1">
              <Value key="0" value="true" />
            </Data>
    "#]]
    .assert_eq(&frame_lines(&mut client, "production", 1));
    expect![[r#"
            <Data name="x_nPause" access="private" xsi:type="array" type="num" size="1">
              <Value key="0" value="0.5" />
            </Data>
            <Data name="l_sLine" access="private" xsi:type="array" type="string" size="1" />
    "#]]
    .assert_eq(&frame_lines(&mut client, "host", 0));
    assert_eq!(client.code(frame("production", 9)), ExceptionCode::StackFrameNotFound);
    assert_eq!(client.code(frame("production", -1)), ExceptionCode::StackFrameNotFound);
    assert_eq!(client.code(frame("nobody", 0)), ExceptionCode::TaskNotFound);
}

#[test]
fn arrays_by_reference_have_their_values() {
    let mut client = Client::logged_in();
    client.run(1);
    set(&mut client, &[line("average", 3, ""), line("nextSlot", 3, "")]);
    for code in [
        "nTimes[8]=7",
        "tSlots[1,2].bFull=true",
        "taskCreate \"times\",10,average(nTimes[7],nState)",
        "taskCreate \"slots\",10,nextSlot(tSlots,nTimes[0],nTimes[1],bReport)",
    ] {
        assert_eq!(execute(&mut client, "", code).0, ExecutionResult::NoError, "{code}");
    }
    client.run(1);
    expect![[r#"
            <Data name="x_nTimes" access="private" xsi:type="array" type="num" size="3">
              <Value key="1" value="7" />
            </Data>
            <Data name="x_nMean" access="private" xsi:type="array" type="num" size="1" />
            <Data name="l_i" access="private" xsi:type="array" type="num" size="1" />
            <Data name="l_nSum" access="private" xsi:type="array" type="num" size="1" />
    "#]]
    .assert_eq(&frame_lines(&mut client, "times", 0));
    expect![[r#"
            <Data name="x_tSlots" access="private" xsi:type="array" type="Slot" size="2 3">
              <Value key="0,0">
                <Field name="pPlace" xsi:type="array" type="pointRx" size="1">
                  <Value key="0" x="200" y="150" z="20" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="fPallet[0]" />
                </Field>
                <Field name="bFull" xsi:type="array" type="bool" size="1" />
                <Field name="nWeight" xsi:type="array" type="num" size="1" />
                <Field name="sContent" xsi:type="array" type="string" size="1" />
              </Value>
              <Value key="0,1">
                <Field name="pPlace" xsi:type="array" type="pointRx" size="1">
                  <Value key="0" x="600" y="150" z="20" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="fPallet[0]" />
                </Field>
                <Field name="bFull" xsi:type="array" type="bool" size="1" />
                <Field name="nWeight" xsi:type="array" type="num" size="1" />
                <Field name="sContent" xsi:type="array" type="string" size="1" />
              </Value>
              <Value key="0,2">
                <Field name="pPlace" xsi:type="array" type="pointRx" size="1">
                  <Value key="0" x="1000" y="150" z="20" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="fPallet[0]" />
                </Field>
                <Field name="bFull" xsi:type="array" type="bool" size="1" />
                <Field name="nWeight" xsi:type="array" type="num" size="1" />
                <Field name="sContent" xsi:type="array" type="string" size="1" />
              </Value>
              <Value key="1,0">
                <Field name="pPlace" xsi:type="array" type="pointRx" size="1">
                  <Value key="0" x="200" y="450" z="20" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="fPallet[0]" />
                </Field>
                <Field name="bFull" xsi:type="array" type="bool" size="1" />
                <Field name="nWeight" xsi:type="array" type="num" size="1" />
                <Field name="sContent" xsi:type="array" type="string" size="1" />
              </Value>
              <Value key="1,1">
                <Field name="pPlace" xsi:type="array" type="pointRx" size="1">
                  <Value key="0" x="600" y="450" z="20" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="fPallet[0]" />
                </Field>
                <Field name="bFull" xsi:type="array" type="bool" size="1" />
                <Field name="nWeight" xsi:type="array" type="num" size="1" />
                <Field name="sContent" xsi:type="array" type="string" size="1" />
              </Value>
              <Value key="1,2">
                <Field name="pPlace" xsi:type="array" type="pointRx" size="1">
                  <Value key="0" x="1000" y="450" z="20" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="fPallet[0]" />
                </Field>
                <Field name="bFull" xsi:type="array" type="bool" size="1">
                  <Value key="0" value="true" />
                </Field>
                <Field name="nWeight" xsi:type="array" type="num" size="1" />
                <Field name="sContent" xsi:type="array" type="string" size="1" />
              </Value>
            </Data>
            <Data name="x_nRow" access="private" xsi:type="array" type="num" size="1" />
            <Data name="x_nColumn" access="private" xsi:type="array" type="num" size="1" />
            <Data name="x_bFound" access="private" xsi:type="array" type="bool" size="1" />
            <Data name="l_nColumn" access="private" xsi:type="array" type="num" size="1" />
            <Data name="l_nRow" access="private" xsi:type="array" type="num" size="1" />
    "#]].assert_eq(&frame_lines(&mut client, "slots", 0));
}

#[test]
fn watches_are_data_in_the_order_of_the_request() {
    let mut client = Client::logged_in();
    client.run(1);
    execute(&mut client, "", "nTimes[2]=7");
    execute(&mut client, "", "tSlots[1,2].bFull=true");
    let data = [("nTimes", "2"), ("nTimes", ""), ("nTimes", "3"), ("pCorner", "1"), ("tSlots", "1,2"), ("sState", "")];
    expect![[r#"
            <Data name="nTimes" access="private" xsi:type="array" type="num" size="10">
              <Value key="2" value="7" />
            </Data>
            <Data name="nTimes" access="private" xsi:type="array" type="num" size="10">
              <Value key="2" value="7" />
            </Data>
            <Data name="nTimes" access="private" xsi:type="array" type="num" size="10" />
            <Data name="pCorner" access="private" xsi:type="array" type="pointRx" size="3">
              <Value key="1" y="1200" fatherId="fCell[0]" />
            </Data>
            <Data name="tSlots" access="public" xsi:type="array" type="Slot" size="2 3">
              <Value key="1,2">
                <Field name="pPlace" xsi:type="array" type="pointRx" size="1">
                  <Value key="0" x="1000" y="450" z="20" rx="180" shoulder="lefty" elbow="epositive" wrist="wpositive" fatherId="fPallet[0]" />
                </Field>
                <Field name="bFull" xsi:type="array" type="bool" size="1">
                  <Value key="0" value="true" />
                </Field>
                <Field name="nWeight" xsi:type="array" type="num" size="1" />
                <Field name="sContent" xsi:type="array" type="string" size="1" />
              </Value>
            </Data>
            <Data name="sState" access="private" xsi:type="array" type="string" size="4">
              <Value key="0" value="stopped" />
              <Value key="1" value="waiting" />
              <Value key="2" value="running" />
              <Value key="3" value="fault" />
            </Data>
    "#]].assert_eq(&watch_lines(&mut client, &data));
    assert_eq!(watch_lines(&mut client, &[]), "");
    for (name, index) in
        [("nOther", "0"), ("", ""), ("nTimes", "10"), ("nTimes", "-1"), ("nTimes", "x"), ("nDone", "0")]
    {
        assert_eq!(client.code(watches(&[(name, index)])), ExceptionCode::InvalidParameters, "{name} {index}");
    }
    let fault = client.fault(watches(&[("nTimes", "10")]));
    assert_eq!(fault.reason, "INVALID-PARAMETERS: `nTimes` has no value with the index `10`");
    let other = WatchedData { project: some("Disk://other/other.pjx"), name: some("nTimes"), index: None };
    let other = SoapRequest::GetWatches(GetWatches { watches: vec![other] });
    assert_eq!(client.code(other), ExceptionCode::ApplicationNotFound);
}

fn project(name: &str) -> SoapRequest {
    SoapRequest::GetProject(GetProject { name: some(name) })
}

/// File names in a project's archive, and the text of `file`.
fn files(client: &mut Client, name: &str, file: &str) -> (Vec<String>, String) {
    let SoapAnswer::GetProject(answer) = client.ask(project(name)) else { panic!("no project") };
    let mut archive = zip::ZipArchive::new(std::io::Cursor::new(answer.data.0)).unwrap();
    let names = archive.file_names().map(|name| name.unwrap().into_owned()).collect();
    let mut text = String::new();
    archive.by_name(file).unwrap().read_to_string(&mut text).unwrap();
    (names, text)
}

#[test]
fn a_project_is_an_archive_of_its_files() {
    let mut client = Client::logged_in();
    let before = files(&mut client, PROJECT, "palletiser.dtx");
    for name in ["palletiser.pjx", "palletiser.dtx", "start.pgx"] {
        assert!(before.0.iter().any(|known| known == name), "{:?}", before.0);
    }
    execute(&mut client, "", "nTimes[2]=7");
    let after = files(&mut client, PROJECT, "palletiser.dtx");
    assert!(after.1.contains(r#"<Value key="2" value="7" />"#), "{}", after.1);
    let stored = files(&mut client, "Disk://partBag/partBag.pjx", "partBag.pjx");
    assert!(stored.1.contains("<Project"), "{}", stored.1);
    assert_eq!(client.code(project("Disk://other/other.pjx")), ExceptionCode::ApplicationNotFound);
    assert_eq!(client.code(project("Disk://../../secret.pjx")), ExceptionCode::ApplicationNotFound);
}
