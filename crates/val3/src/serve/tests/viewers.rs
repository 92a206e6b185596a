//! Viewers with the same messages, and viewers that do not read.

use std::time::{Duration, Instant};

use serde_json::json;

use super::super::StoredMessage;
use super::super::limits::ServerLimits;
use super::client::{next, next_json, open, send, server, text};

#[test]
fn a_late_viewer_begins_with_the_present() {
    let server = server(ServerLimits::default());
    server.publish([StoredMessage::Lasting(r#"{"kind":"scene","role":"operator"}"#.into()), text("{\"n\":1}")]);
    server.begin_part(60.0, vec![text("{\"n\":1}")]);
    server.publish([text("{\"n\":2}")]);
    let mut late = open(server.guest_page()).unwrap();
    assert_eq!(next_json(&mut late), json!({ "kind": "scene", "role": "guest" }));
    assert_eq!(next_json(&mut late), json!({ "kind": "past", "from": 0.0, "to": 60.0 }));
    let newest = next(&mut late).unwrap();
    assert!(newest.starts_with(&[2, 0, 0, 0, 1, 0, 0, 0]) && newest.ends_with(b"{\"n\":2}"));
    let oldest = next(&mut late).unwrap();
    assert!(oldest.starts_with(&[2, 0, 0, 0, 0, 0, 0, 0]) && oldest.ends_with(b"{\"n\":1}"));
    assert_eq!(next_json(&mut late), json!({ "kind": "past", "from": 0.0, "to": 0.0 }));
    server.publish([text("{\"n\":3}")]);
    assert_eq!(next_json(&mut late), json!({ "n": 3 }));
}

#[test]
fn all_viewers_see_the_same() {
    let server = server(ServerLimits::default());
    server.publish((0..100).map(|number| text(&format!("{{\"n\":{number}}}"))));
    let early: Vec<_> = (0..4).map(|_| open(server.operator_page()).unwrap()).collect();
    server.publish([StoredMessage::Binary(vec![1, 2, 3].into()), text("{}")]);
    let late = open(server.guest_page()).unwrap();
    let seen: Vec<Vec<_>> = early
        .into_iter()
        .chain([late])
        .map(|mut viewer| (0..102).map(|_| next(&mut viewer).unwrap()).collect())
        .collect();
    assert!(seen.windows(2).all(|pair| pair[0] == pair[1]));
    assert_eq!((seen[0][0].as_slice(), seen[0][100].as_slice()), (&b"{\"n\":0}"[..], &[1, 2, 3][..]));
}

/// The log is bounded. A viewer that does not read neither retains messages nor delays the run.
#[test]
fn a_viewer_that_never_reads_costs_nothing() {
    let send_time = Duration::from_millis(200);
    let server = server(ServerLimits { send_time, viewers: 1, log_bytes: 1 << 20, ..ServerLimits::default() });
    let _silent = open(server.operator_page()).unwrap();
    let message = text(&"x".repeat(100_000));
    let mut longest = Duration::ZERO;
    for _ in 0..1000 {
        let start = Instant::now();
        server.begin_part(0.0, vec![message.clone()]);
        server.publish([message.clone()]);
        longest = longest.max(start.elapsed());
        assert!(server.log_bytes() <= 1 << 20);
        std::thread::sleep(Duration::from_micros(500));
    }
    assert!(longest < Duration::from_millis(100), "{longest:?}");
    // The viewer's permit is available again.
    let deadline = Instant::now() + Duration::from_secs(10);
    while open(server.operator_page()).is_err() {
        assert!(Instant::now() < deadline);
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[test]
fn viewers_only_receive_the_current_run() {
    let server = server(ServerLimits::default());
    let mut early = open(server.operator_page()).unwrap();
    server.publish([
        StoredMessage::Lasting("{\"old\":1}".into()),
        text("{\"old\":2}"),
        text("{\"old\":3}"),
        text("{}"),
    ]);
    while next(&mut early).unwrap() != b"{}" {}
    server.begin_part(1.0, vec![text("{}")]);
    server.begin_run();
    server.publish([text("{\"new\":1}"), text("{\"new\":2}")]);
    let late = open(server.guest_page()).unwrap();
    for mut viewer in [early, late] {
        assert_eq!([(); 2].map(|()| next_json(&mut viewer)["new"].as_u64()), [Some(1), Some(2)]);
    }
}

#[test]
fn commands_are_answered_to_their_viewer() {
    let server = server(ServerLimits::default());
    let [mut first, mut second] = [0, 1].map(|_| open(server.operator_page()).unwrap());
    send(&mut first, r#"{"id": 5, "command": "pace", "speed": 2}"#);
    let command = server.wait_for_command(Duration::from_secs(10)).unwrap();
    assert_eq!((command.name.as_str(), &command.message["speed"]), ("pace", &serde_json::json!(2)));
    command.answer(Err("no".to_owned()));
    assert_eq!(next_json(&mut first), serde_json::json!({ "kind": "answer", "id": 5, "error": "no" }));
    server.publish([text("{\"kind\":\"x\"}")]);
    assert_eq!(next_json(&mut second)["kind"], "x");
}

/// The viewers receive the last messages before the server ends.
#[test]
fn viewers_see_the_end() {
    let server = server(ServerLimits::default());
    let mut viewer = open(server.operator_page()).unwrap();
    server.publish((0..1000).map(|_| text("{}")));
    let reader = std::thread::spawn(move || std::iter::from_fn(|| next(&mut viewer)).count());
    drop(server);
    assert_eq!(reader.join().unwrap(), 1000);
}
