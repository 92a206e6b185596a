//! Rights of profiles.

use val3_session::ProfileRights;
use val3_soap::v0::{GetRobots, SetRobotJointPos};
use val3_soap::{ExceptionCode, SoapRequest};

use super::client::{Client, profile};

#[test]
fn a_profile_of_the_cell_has_its_rights_and_any_password() {
    let reader = ProfileRights { read: true, write: false, write_io: false };
    let nothing = ProfileRights { read: false, write: false, write_io: false };
    let mut client = Client::with(vec![profile("reader", reader), profile("nobody", nothing)]);
    let unchecked: Vec<&str> = client.service.state.accounts.without_password_check().collect();
    assert_eq!(unchecked, ["reader", "nobody"]);
    let set = || SoapRequest::SetRobotJointPos(SetRobotJointPos { robot: 0, position: vec![0.0; 6] });
    assert_ne!(client.login("reader", "any"), 0);
    client.ask(SoapRequest::GetRobots(GetRobots));
    assert_eq!(client.code(set()), ExceptionCode::WriteAccess);
    assert_ne!(client.login("nobody", ""), 0);
    let fault = client.fault(SoapRequest::GetRobots(GetRobots));
    assert_eq!(fault.reason, "READ-ACCESS-ERROR-CODE: the profile may not read");
    assert_ne!(client.login("default", ""), 0);
    client.ask(set());
}
