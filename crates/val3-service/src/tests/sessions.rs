//! Sessions.

use std::time::Duration;

use val3_soap::v0::{GetRobots, Login, Logout, Ping};
use val3_soap::{ExceptionCode, SoapAnswer, SoapRequest};

use super::client::Client;

const ROBOTS: SoapRequest = SoapRequest::GetRobots(GetRobots);

fn login() -> SoapRequest {
    SoapRequest::Login(Login { user: Some("default".to_owned()), password: None })
}

#[test]
fn requests_need_a_session() {
    let mut client = Client::with(Vec::new());
    assert_eq!(client.code(ROBOTS), ExceptionCode::InvalidSessionId);
    let ping = SoapRequest::Ping(Ping { message: Some("hello".to_owned()) });
    let answer = client.send(ping);
    assert_eq!(answer.session, None);
    assert!(matches!(answer.result, Ok(SoapAnswer::Ping(ping)) if ping.message.as_deref() == Some("hello")));
    client.ask(login());
    client.ask(ROBOTS);
    client.ask(SoapRequest::Logout(Logout));
    assert_eq!(client.code(ROBOTS), ExceptionCode::InvalidSessionId);
}

#[test]
fn a_rejected_login_has_the_session_0() {
    let mut client = Client::with(Vec::new());
    for (user, password) in [("nobody", ""), ("default", "x"), ("", "")] {
        assert_eq!(client.login(user, password), 0, "{user}");
    }
    assert_eq!(client.code(ROBOTS), ExceptionCode::InvalidSessionId);
}

#[test]
fn a_request_without_header_belongs_to_the_only_session() {
    let mut client = Client::logged_in();
    client.session = None;
    assert_eq!(client.send(ROBOTS).session, Some(1));
    client.ask(login());
    assert_eq!(client.session, Some(2));
    client.session = None;
    assert_eq!(client.code(ROBOTS), ExceptionCode::InvalidSessionId);
}

#[test]
fn a_session_ends_without_requests() {
    let mut client = Client::logged_in();
    client.now = Duration::from_secs(3600);
    client.ask(ROBOTS);
    client.now = Duration::from_secs(7200);
    client.ask(ROBOTS);
    client.now = Duration::from_secs(10_801);
    assert_eq!(client.code(ROBOTS), ExceptionCode::InvalidSessionId);
}

#[test]
fn the_number_of_sessions_is_limited() {
    let mut client = Client::with(Vec::new());
    let sessions: Vec<i32> = (0..33).map(|_| client.login("default", "")).collect();
    assert_eq!(sessions[..32], (1..=32).collect::<Vec<_>>());
    assert_eq!(sessions[32], 0);
    client.session = Some(7);
    client.ask(SoapRequest::Logout(Logout));
    assert_eq!(client.login("default", ""), 33);
}
