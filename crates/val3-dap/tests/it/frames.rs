//! Frames in any chunks, and garbage.

use std::io::{BufReader, Read};

use proptest::collection::{btree_map, vec};
use proptest::prelude::*;
use proptest::sample::select;
use serde_json::Value;
use val3_dap::{
    BODY_LIMIT, HEADER_LIMIT, HeaderError, MessageContent, MessageReader, MessageWriter, ProtocolMessage, ReadError,
};

/// Input that returns a limited number of bytes in each call.
struct Chunks<'a> {
    bytes: &'a [u8],
    lengths: std::iter::Cycle<std::slice::Iter<'a, usize>>,
}

impl Read for Chunks<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
        let length = self.lengths.next().copied().unwrap_or(1).min(buffer.len());
        self.bytes.read(&mut buffer[..length])
    }
}

/// Any JSON without fractions, whose last digit may differ after printing.
pub(crate) fn json_value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        any::<i64>().prop_map(Value::from),
        any::<String>().prop_map(Value::from),
    ];
    leaf.prop_recursive(3, 16, 4, |inner| {
        prop_oneof![
            vec(inner.clone(), 0..4).prop_map(Value::from),
            btree_map(any::<String>(), inner, 0..4).prop_map(|map| Value::Object(map.into_iter().collect())),
        ]
    })
}

fn content() -> impl Strategy<Value = MessageContent> {
    // `null` is the same as a missing property.
    let value = || proptest::option::of(json_value().prop_filter("not null", |value| !value.is_null()));
    prop_oneof![
        (any::<String>(), value()).prop_map(|(command, arguments)| MessageContent::Request { command, arguments }),
        (any::<String>(), value()).prop_map(|(event, body)| MessageContent::Event { event, body }),
        (any::<i64>(), any::<bool>(), any::<String>(), any::<Option<String>>(), value()).prop_map(
            |(request_seq, success, command, message, body)| MessageContent::Response {
                request_seq,
                success,
                command,
                message,
                body
            }
        ),
    ]
}

/// Every result up to the end of the input, or up to an error after which reading cannot continue.
fn read_all(input: impl Read) -> Vec<Result<ProtocolMessage, ReadError>> {
    let mut reader = MessageReader::new(BufReader::new(input));
    let mut results = Vec::new();
    while let Some(result) = reader.read().transpose() {
        let is_last = result.as_ref().is_err_and(|error| !error.can_continue());
        results.push(result);
        if is_last {
            break;
        }
    }
    results
}

/// Returns an input's messages and errors as texts.
fn outcomes(input: &[u8]) -> Vec<String> {
    let outcomes = read_all(input).into_iter().map(|result| match result {
        Ok(ProtocolMessage { content: MessageContent::Event { event, .. }, .. }) => event,
        Ok(message) => format!("{message:?}"),
        Err(error) => format!("{error}"),
    });
    outcomes.collect()
}

#[test]
fn messages_are_found_after_garbage() {
    let message = r#"{"seq":1,"type":"event","event":"a"}"#;
    let frame = format!("Content-Length: {}\r\n\r\n{message}", message.len());
    assert_eq!(outcomes(frame.as_bytes()), ["a"]);
    let foreign = format!("\r\n\ncontent-type: x\r\nCONTENT-LENGTH:{}\n\n{message}\r\n", message.len());
    assert_eq!(outcomes(foreign.as_bytes()), ["a"]);
    let garbage = format!("hello\r\n{frame}\0\u{1}\n\n{frame}");
    assert_eq!(
        outcomes(garbage.as_bytes()),
        [r#""hello" is not a header of a message"#, "a", r#""\0\u{1}" is not a header of a message"#, "a",]
    );
    let short = format!("Content-Length: 3\r\n\r\n{message}{frame}");
    let [json, rest, last] = &outcomes(short.as_bytes())[..] else { panic!("three results") };
    assert!(json.starts_with("the message is not JSON"), "{json}");
    assert!(rest.ends_with("is not a header of a message"), "{rest}");
    assert_eq!(last, "a");
    assert_eq!(
        outcomes(format!("Content-Type: x\r\n\r\n{frame}").as_bytes()),
        ["the header of the message has no `Content-Length`", "a"]
    );
}

#[test]
fn a_message_of_another_kind_does_not_end_the_input() {
    let input = format!("Content-Length: 2\r\n\r\n{{}}{}", "Content-Length: 1\r\n\r\n[");
    let results = outcomes(input.as_bytes());
    assert_eq!(results[0], "the message has no envelope: missing field `seq`");
    assert!(results[1].starts_with("the message is not JSON"), "{results:?}");
}

#[track_caller]
fn check_end(input: &[u8], expected: &HeaderError) {
    let results = read_all(input);
    let Some(Err(ReadError::Frame(error))) = results.last() else { panic!("{results:?}") };
    assert_eq!(error, expected);
}

#[test]
fn an_unknown_length_ends_the_input() {
    for length in ["-1", "x", "", "1.5", "2 bytes"] {
        let input = format!("Content-Length: {length}\r\n\r\n{{}}");
        check_end(input.as_bytes(), &HeaderError::Length(length.to_owned()));
    }
}

#[test]
fn an_end_inside_a_frame_is_an_error() {
    assert!(read_all(&b""[..]).is_empty());
    assert!(read_all(&b"\r\n\n"[..]).is_empty());
    for input in ["Content-Len", "Content-Length: 5\r\n", "Content-Length: 5\r\n\r\n{}"] {
        check_end(input.as_bytes(), &HeaderError::Truncated);
    }
}

#[test]
fn sizes_are_limited() {
    let header = |length: usize| format!("a: {}\r\n", "x".repeat(length - 5));
    check_end(header(HEADER_LIMIT + 1).as_bytes(), &HeaderError::HeaderSize);
    check_end(header(HEADER_LIMIT).as_bytes(), &HeaderError::Truncated);
    check_end(&vec![b'x'; 2 * HEADER_LIMIT], &HeaderError::HeaderSize);
    let length = |length: u64| format!("Content-Length: {length}\r\n\r\n");
    check_end(length(BODY_LIMIT + 1).as_bytes(), &HeaderError::BodySize(BODY_LIMIT + 1));
    check_end(length(BODY_LIMIT).as_bytes(), &HeaderError::Truncated);
    let digits = format!("Content-Length: {}\r\n\r\n", "9".repeat(50));
    check_end(digits.as_bytes(), &HeaderError::BodySize(u64::MAX));
}

proptest! {
    #[test]
    fn messages_pass_in_any_chunks(contents in vec(content(), 0..6), lengths in vec(1..50_usize, 1..8)) {
        let mut bytes = Vec::new();
        let mut writer = MessageWriter::new(&mut bytes);
        for content in &contents {
            writer.write(content.clone()).unwrap();
        }
        let chunks = Chunks { bytes: &bytes, lengths: lengths.iter().cycle() };
        let read = read_all(chunks).into_iter().map(Result::unwrap).collect::<Vec<_>>();
        let sent = (1..).zip(contents).map(|(seq, content)| ProtocolMessage { seq, content });
        prop_assert_eq!(read, sent.collect::<Vec<_>>());
    }

    #[test]
    fn any_garbage_is_read_to_its_end(
        parts in vec(
            prop_oneof![
                select(&["Content-Length: ", "2", "17", "\r\n", "\n", "\r\n\r\n", "{}", "a: b", "\0", ":"][..])
                    .prop_map(|text| text.as_bytes().to_vec()),
                vec(any::<u8>(), 0..20),
            ],
            0..40,
        ),
        lengths in vec(1..50_usize, 1..8),
    ) {
        let bytes = parts.concat();
        let results = read_all(Chunks { bytes: &bytes, lengths: lengths.iter().cycle() });
        // Each frame has at least one byte and results in at most a message and an error.
        prop_assert!(results.len() <= 2 * bytes.len());
    }
}
