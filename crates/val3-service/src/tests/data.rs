//! Applications, data and recordings.

use val3_machine::script::ScriptAction;
use val3_soap::v1::{GetApplicationDatas, GetApplications, GetRecord, GetRecords, ListedApplication};
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::Client;

fn applications(client: &mut Client) -> Vec<ListedApplication> {
    match client.ask(SoapRequest::GetApplications(GetApplications)) {
        SoapAnswer::GetApplications(answer) => answer.applications,
        other => panic!("{other:?}"),
    }
}

fn data(name: &str) -> SoapRequest {
    SoapRequest::GetApplicationDatas(GetApplicationDatas { name: Some(name.to_owned()) })
}

fn text(client: &mut Client, name: &str) -> String {
    match client.ask(data(name)) {
        SoapAnswer::GetApplicationDatas(answer) => String::from_utf8(answer.data.0).unwrap(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn all_projects_of_the_cell_are_listed() {
    let mut client = Client::logged_in();
    let applications = applications(&mut client);
    let is_loaded = |name: &str| {
        let application = applications.iter().find(|application| application.name.as_deref() == Some(name));
        application.map(|application| application.loaded)
    };
    assert_eq!(is_loaded("Disk://palletiser/palletiser.pjx"), Some(true));
    assert!(applications.iter().any(|application| !application.loaded), "{applications:?}");
}

#[test]
fn data_have_their_current_values() {
    let mut client = Client::logged_in();
    let name = "Disk://palletiser/palletiser.pjx";
    let before = text(&mut client, name);
    let keys = serde_json::json!({ "set": { "nLayer": 7 } });
    let action = ScriptAction::from_json(keys.as_object().unwrap().clone()).unwrap();
    client.controller().act(&action).unwrap();
    let after = text(&mut client, name);
    let changed: Vec<&str> = after.lines().filter(|line| !before.contains(line)).map(str::trim).collect();
    let element = r#"<Data name="nLayer" access="public" xsi:type="array" type="num" size="1">"#;
    assert_eq!(changed, [element, r#"<Value key="0" value="7" />"#]);
    assert_eq!(client.code(data("Disk://other/other.pjx")), ExceptionCode::ApplicationNotFound);
    assert_eq!(client.code(data("Disk://../../secret.pjx")), ExceptionCode::ApplicationNotFound);
}

#[test]
fn there_are_no_recordings() {
    let mut client = Client::logged_in();
    assert!(
        matches!(client.ask(SoapRequest::GetRecords(GetRecords)), SoapAnswer::GetRecords(answer) if answer.records.is_empty())
    );
    let record = SoapRequest::GetRecord(GetRecord { name: Some("run1".to_owned()) });
    assert_eq!(client.code(record), ExceptionCode::FileNotFound);
}
