//! The validator finds the definition of a message and its mismatches.

use serde_json::{Value, json};
use val3_dap::protocol::{Capabilities, StoppedEvent, StoppedEventReason};
use val3_dap::validate::SchemaValidator;
use val3_dap::{MessageContent, ProtocolMessage, Response, StandardEvent};

fn check(message: &Value, expected: &str) {
    let result = SchemaValidator::new().unwrap().validate(message);
    assert_eq!(result.err().map(|error| error.to_string()).unwrap_or_default(), expected);
}

fn check_valid(content: MessageContent) {
    check(&serde_json::to_value(ProtocolMessage { seq: 1, content }).unwrap(), "");
}

#[test]
fn typed_messages_are_valid() {
    let capabilities = Capabilities { supports_step_back: Some(true), ..Capabilities::default() };
    check_valid(MessageContent::success(1, &Response::Initialize(capabilities)).unwrap());
    check_valid(MessageContent::success(1, &Response::Next).unwrap());
    check_valid(MessageContent::event(&StandardEvent::Initialized).unwrap());
    let stopped = StoppedEvent {
        reason: StoppedEventReason::FunctionBreakpoint,
        all_threads_stopped: Some(true),
        description: None,
        hit_breakpoint_ids: None,
        preserve_focus_hint: None,
        text: None,
        thread_id: Some(1),
    };
    check_valid(MessageContent::event(&StandardEvent::Stopped(stopped)).unwrap());
}

#[test]
fn mismatches_are_listed() {
    check(
        &json!({ "seq": 0, "type": "event", "event": "stopped", "body": { "reason": 1 } }),
        "StoppedEvent/seq: 0 is less than the minimum of 1\nStoppedEvent/body/reason: 1 is not of type \"string\"",
    );
    check(
        &json!({ "seq": 1, "type": "request", "command": "scopes", "arguments": {} }),
        "ScopesRequest/arguments: \"frameId\" is a required property",
    );
    check(
        &json!({ "seq": 1, "type": "response", "request_seq": 1, "success": false, "command": "scopes" }),
        "ErrorResponse: \"body\" is a required property",
    );
}

#[test]
fn unknown_messages_are_mismatches() {
    check(&json!({ "seq": 1, "type": "request", "command": "fly" }), "the specification has no FlyRequest");
    check(&json!({ "seq": 1 }), "a message of the type None");
}

#[test]
fn custom_messages_have_a_valid_envelope() {
    check(&json!({ "seq": 1, "type": "event", "event": "val3/motion", "body": [1] }), "");
    check(
        &json!({ "seq": "1", "type": "event", "event": "val3/motion" }),
        "Event/seq: \"1\" is not of type \"integer\"",
    );
}
