//! Unusual requests of clients: accepted, or rejected with an error.

use proptest::prelude::*;
use serde_json::{Value, json};
use val3_dap::protocol::{EvaluateContext, LaunchRequestArguments, SetBreakpointsArguments};
use val3_dap::validate::SchemaValidator;
use val3_dap::{MessageContent, MessageError, ProtocolMessage, StandardRequest};

use crate::frames::json_value;

/// Returns the failed response to a request that cannot be decoded.
fn refusal(command: &str, arguments: Value) -> Value {
    let error = StandardRequest::parse(command, Some(arguments)).unwrap_err();
    let message = ProtocolMessage { seq: 1, content: error.response(7).unwrap() };
    serde_json::to_value(message).unwrap()
}

#[test]
fn unknown_properties_are_ignored() {
    let arguments = json!({ "source": { "path": "a.pgx", "origin2": 1 }, "lines": [1], "colour": {} });
    let StandardRequest::SetBreakpoints(SetBreakpointsArguments { source, lines, breakpoints, source_modified }) =
        StandardRequest::parse("setBreakpoints", Some(arguments)).unwrap()
    else {
        panic!("another request");
    };
    assert_eq!(
        (source.path.as_deref(), lines, breakpoints, source_modified),
        (Some("a.pgx"), Some(vec![1]), None, None)
    );
}

#[test]
fn launch_keeps_the_properties_of_the_adapter() {
    let arguments = json!({ "noDebug": true, "program": "cell", "__restart": 5 });
    let StandardRequest::Launch(LaunchRequestArguments { no_debug, restart, additional }) =
        StandardRequest::parse("launch", Some(arguments)).unwrap()
    else {
        panic!("another request");
    };
    assert_eq!((no_debug, restart), (Some(true), Some(json!(5))));
    assert_eq!(Value::Object(additional), json!({ "program": "cell" }));
}

#[test]
fn open_enumerations_keep_unknown_values() {
    let context: EvaluateContext = serde_json::from_value(json!("panel")).unwrap();
    assert_eq!(context, EvaluateContext::Other("panel".to_owned()));
    assert_eq!(serde_json::to_value(context).unwrap(), json!("panel"));
}

#[test]
fn requests_without_arguments_accept_any_form_of_none() {
    for arguments in [None, Some(Value::Null), Some(json!({}))] {
        assert_eq!(StandardRequest::parse("threads", arguments.clone()).unwrap(), StandardRequest::Threads);
        assert!(matches!(StandardRequest::parse("disconnect", arguments), Ok(StandardRequest::Disconnect(_))));
    }
}

#[test]
fn an_unknown_request_is_answered() {
    assert_eq!(
        refusal("val3/{x}", json!({})),
        json!({
            "seq": 1,
            "type": "response",
            "request_seq": 7,
            "success": false,
            "command": "val3/{x}",
            "message": "the request `val3/{x}` is unknown",
            "body": { "error": {
                "id": 1,
                "format": "the request `{command}` is unknown",
                "variables": { "command": "val3/{x}" },
            } },
        })
    );
}

#[test]
fn wrong_arguments_are_answered() {
    let message = |command, arguments| refusal(command, arguments)["message"].clone();
    assert_eq!(
        message("scopes", json!({ "frameId": "1" })),
        "the arguments of `scopes` are wrong: invalid type: string \"1\", expected i32"
    );
    assert_eq!(message("scopes", json!({})), "the arguments of `scopes` are wrong: missing field `frameId`");
    assert_eq!(
        message("scopes", json!([1])),
        "the arguments of `scopes` are wrong: invalid type: sequence, expected a map"
    );
}

#[test]
fn a_message_without_an_envelope_keeps_its_number() {
    for (text, seq) in [
        (r#"{"seq":4,"type":"request"}"#, Some(4)),
        (r#"{"seq":4,"type":"question"}"#, Some(4)),
        (r#"{"type":"request","command":"a"}"#, None),
        ("[]", None),
    ] {
        let Err(MessageError::Envelope { seq: found, .. }) = ProtocolMessage::parse(text.as_bytes()) else {
            panic!("{text}");
        };
        assert_eq!(found, seq, "{text}");
    }
    assert!(matches!(ProtocolMessage::parse(b"{"), Err(MessageError::Json(_))));
}

#[test]
fn deep_nesting_is_an_error() {
    let text = "[".repeat(1 << 20);
    assert!(matches!(ProtocolMessage::parse(text.as_bytes()), Err(MessageError::Json(_))));
}

proptest! {
    #[test]
    fn any_arguments_are_decoded_or_refused(
        command in prop_oneof!["(setBreakpoints|evaluate|launch|restart|threads|variables)", any::<String>()],
        arguments in json_value(),
    ) {
        let content = match StandardRequest::parse(&command, Some(arguments)) {
            Ok(request) => MessageContent::request(&request).unwrap(),
            Err(error) => error.response(1).unwrap(),
        };
        let message = serde_json::to_value(ProtocolMessage { seq: 1, content }).unwrap();
        prop_assert_eq!(SchemaValidator::new().unwrap().validate(&message), Ok(()));
    }
}
