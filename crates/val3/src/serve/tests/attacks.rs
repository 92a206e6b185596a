//! Untrusted requests and viewers.

use std::io::{Read as _, Write as _};
use std::time::{Duration, Instant};

use serde_json::Value;

use super::super::limits::ServerLimits;
use super::super::quota::RateLimits;
use super::client::{exchange, get, next, next_json, open, open_from, parts, send, server, stream, text};

/// Whether a response is the 404 for requests without a secret.
fn is_plain_404(answer: &str) -> bool {
    answer.starts_with("HTTP/1.1 404 Not Found\r\n") && answer.ends_with("\r\n\r\n")
}

#[test]
fn a_stranger_learns_nothing() {
    let server = server(ServerLimits::default());
    let (address, secret) = parts(server.operator_page());
    let host = format!("Host: {address}\r\n");
    let wrong = "0".repeat(32);
    let paths = [
        "/".to_owned(),
        "/favicon.ico".to_owned(),
        format!("/{wrong}/"),
        format!("/{wrong}/socket"),
        format!("/{secret}"),
        format!("/{secret}/../../etc/passwd"),
        format!("/{secret}/..%2f..%2fetc/passwd"),
        format!("/{secret}/view.html"),
        format!("//{secret}/"),
        format!("/{}/", &secret[..31]),
    ];
    for path in paths {
        let answer = get(address, &path, &host);
        assert!(is_plain_404(&answer), "{path}: {answer}");
    }
    // A socket request without an upgrade, another method, and another target.
    assert!(is_plain_404(&get(address, &format!("/{secret}/socket"), &format!("{host}Origin: http://{address}\r\n"))));
    let post = format!("POST /{secret}/ HTTP/1.1\r\n{host}Content-Length: 0\r\n\r\n");
    assert!(is_plain_404(&exchange(address, post.as_bytes())));
    let absolute = format!("GET http://{address}/{secret}/ HTTP/1.1\r\n{host}\r\n");
    assert!(is_plain_404(&exchange(address, absolute.as_bytes())));
}

#[test]
fn the_page_is_protected() {
    let server = server(ServerLimits::default());
    let (address, secret) = parts(server.guest_page());
    let answer = get(address, &format!("/{secret}/"), &format!("Host: {address}\r\n")).to_lowercase();
    assert!(answer.starts_with("http/1.1 200 ok\r\n"), "{answer}");
    let (header, body) = answer.split_once("\r\n\r\n").unwrap();
    assert!(body.starts_with("<!doctype html>"));
    for line in [
        "cache-control: no-store",
        "x-content-type-options: nosniff",
        "x-frame-options: deny",
        "referrer-policy: no-referrer",
        "default-src 'none'; script-src 'sha256-",
        "frame-ancestors 'none'",
        &format!("connect-src 'self' ws://{address}\r"),
    ] {
        assert!(header.contains(line), "{line} in {header}");
    }
    for weakness in ["unsafe", "*", "script-src 'self'", "access-control"] {
        assert!(!header.contains(weakness), "{weakness} in {header}");
    }
}

/// Another page in the same browser, and a host name that an attacker resolves to this machine.
#[test]
fn foreign_pages_and_hosts_are_refused() {
    let server = server(ServerLimits::default());
    let (address, secret) = parts(server.operator_page());
    let port = address.rsplit(':').next().unwrap();
    let rebound = format!("evil.example:{port}");
    assert!(is_plain_404(&get(address, &format!("/{secret}/"), &format!("Host: {rebound}\r\n"))));
    assert!(is_plain_404(&get(address, &format!("/{secret}/"), "")));
    let opened = |host: &str, origin: &str| open_from(address, secret, host, origin).err();
    assert_eq!(opened(address, &format!("http://{address}")), None);
    assert_eq!(opened(&format!("localhost:{port}"), &format!("http://localhost:{port}")), None);
    assert_eq!(opened(address, "http://evil.example"), Some(404));
    assert_eq!(opened(address, "null"), Some(404));
    assert_eq!(opened(&rebound, &format!("http://{rebound}")), Some(404));
    assert_eq!(opened(address, &format!("https://{address}")), Some(404));
}

#[test]
fn guests_cannot_operate() {
    let server = server(ServerLimits::default());
    let mut guest = open(server.guest_page()).unwrap();
    send(&mut guest, r#"{"id": 1, "command": "pace", "isPaused": true}"#);
    let answer = next_json(&mut guest);
    assert_eq!((&answer["kind"], &answer["id"]), (&Value::from("answer"), &Value::from(1)));
    assert!(answer["error"].as_str().unwrap().contains("guests"), "{answer}");
    assert!(server.next_command().is_none());
}

#[test]
fn a_flood_of_commands_is_refused_and_then_ended() {
    let limits =
        ServerLimits { commands: RateLimits { per_second: 1, at_once: 20, refused: 50 }, ..ServerLimits::default() };
    let server = server(limits);
    let mut viewer = open(server.operator_page()).unwrap();
    for id in 0..200 {
        send(&mut viewer, &format!(r#"{{"id": {id}, "command": "operate"}}"#));
    }
    let mut refused = 0;
    while let Some(answer) = next(&mut viewer) {
        assert!(String::from_utf8(answer).unwrap().contains("too many commands"));
        refused += 1;
    }
    assert!((45..=50).contains(&refused), "{refused}");
    let passed = std::iter::from_fn(|| server.next_command()).count();
    assert!((20..=25).contains(&passed), "{passed}");
}

/// The slot for the response is reserved before a command is passed to the run.
#[test]
fn commands_that_are_not_answered_are_bounded() {
    let limits = ServerLimits {
        commands: RateLimits { per_second: 100, at_once: 1000, refused: 1000 },
        ..ServerLimits::default()
    };
    let server = server(limits);
    let mut viewer = open(server.operator_page()).unwrap();
    for id in 0..100 {
        send(&mut viewer, &format!(r#"{{"id": {id}, "command": "operate"}}"#));
    }
    let answer = next_json(&mut viewer);
    assert!(answer["error"].as_str().unwrap().contains("not answered yet"), "{answer}");
    let waiting: Vec<_> = std::iter::from_fn(|| server.next_command()).collect();
    assert!(waiting.len() <= 64, "{}", waiting.len());
}

#[test]
fn malformed_commands_are_refused_with_a_sentence() {
    let server = server(ServerLimits::default());
    let mut viewer = open(server.operator_page()).unwrap();
    for command in ["", "{", "[1]", "{}", r#"{"id": {}, "command": "x"}"#, r#"{"id": 1}"#] {
        send(&mut viewer, command);
        let answer = next_json(&mut viewer);
        assert!(answer["error"].as_str().unwrap().len() > 10, "{answer}");
    }
    assert!(server.next_command().is_none());
    // Deep nesting is an error and not a crash.
    send(&mut viewer, &"[".repeat(60_000));
    assert!(next_json(&mut viewer)["error"].is_string());
}

#[test]
fn an_oversized_frame_ends_the_connection() {
    let server = server(ServerLimits::default());
    let mut viewer = open(server.operator_page()).unwrap();
    let text = format!(r#"{{"id": 1, "command": "operate", "x": "{}"}}"#, "x".repeat(64 << 10));
    send(&mut viewer, &text);
    assert_eq!(next(&mut viewer), None);
    // No memory is allocated for a frame that only announces its size.
    let mut viewer = open(server.operator_page()).unwrap();
    let header = [0x81, 0xff, 0, 0, 0x7f, 0xff, 0xff, 0xff, 0xff, 0xff, 1, 2, 3, 4];
    viewer.get_mut().write_all(&header).unwrap();
    assert_eq!(next(&mut viewer), None);
    let mut viewer = open(server.operator_page()).unwrap();
    viewer.send(tungstenite::Message::binary(vec![1, 2, 3])).unwrap();
    assert_eq!(next(&mut viewer), None);
    assert!(server.next_command().is_none());
}

#[test]
fn half_open_connections_are_closed() {
    let header_time = Duration::from_millis(200);
    let (ping_time, silence) = (Duration::from_millis(50), Duration::from_millis(200));
    let server = server(ServerLimits { header_time, ping_time, silence, ..ServerLimits::default() });
    let (address, secret) = parts(server.operator_page());
    let start = Instant::now();
    // No data, half a header, and a header that does not end.
    for begin in ["", "GET / HT", &format!("GET /{secret}/ HTTP/1.1\r\nHost: {address}\r\nX: ")] {
        let (mut stream, mut answer) = (stream(address), String::new());
        stream.write_all(begin.as_bytes()).unwrap();
        let _ = stream.read_to_string(&mut answer);
        assert!(!answer.contains("200"), "{answer}");
    }
    // A viewer that never responds to pings. The socket is read without the library, which would respond.
    let mut viewer = open(server.operator_page()).unwrap();
    let mut bytes = Vec::new();
    let _ = viewer.get_mut().read_to_end(&mut bytes);
    assert!(start.elapsed() < Duration::from_secs(10));
    // A viewer that responds stays connected.
    let mut viewer = open(server.operator_page()).unwrap();
    let reader = std::thread::spawn(move || next(&mut viewer));
    std::thread::sleep(silence * 3);
    server.publish([text("{}")]);
    assert_eq!(reader.join().unwrap().unwrap(), b"{}");
}

#[test]
fn large_headers_are_refused() {
    let server = server(ServerLimits::default());
    let (address, secret) = parts(server.operator_page());
    let headers = format!("Host: {address}\r\nX: {}\r\n", "x".repeat(100_000));
    assert!(!get(address, &format!("/{secret}/"), &headers).contains("200 OK"));
    let headers = format!("Host: {address}\r\n{}", "X: y\r\n".repeat(1000));
    assert!(!get(address, &format!("/{secret}/"), &headers).contains("200 OK"));
}

#[test]
fn connections_and_viewers_are_bounded() {
    let server = server(ServerLimits { viewers: 2, connections: 4, ..ServerLimits::default() });
    let (address, _) = parts(server.operator_page());
    let viewers: Vec<_> = (0..2).map(|_| open(server.operator_page()).unwrap()).collect();
    assert_eq!(open(server.guest_page()).err(), Some(503));
    drop(viewers);
    let deadline = Instant::now() + Duration::from_secs(10);
    while open(server.guest_page()).is_err() {
        assert!(Instant::now() < deadline, "the places are free again");
    }
    let idle: Vec<_> = (0..4).map(|_| stream(address)).collect();
    assert_eq!(exchange(address, b""), "", "it is closed at once");
    drop(idle);
}
