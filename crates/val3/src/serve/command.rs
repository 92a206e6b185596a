//! Commands from viewers, and the responses.

use axum::extract::ws::Utf8Bytes;
use serde_json::{Map, Value, json};
use tokio::sync::mpsc::OwnedPermit;
use val3_view::wire;

/// Command that waits for the run loop.
#[derive(Debug)]
pub(crate) struct PendingCommand {
    /// Command name.
    pub(crate) name: String,
    /// Entire message, with the arguments.
    pub(crate) message: Map<String, Value>,
    ticket: Ticket,
}

/// Reserved slot for the response in the queue to the viewer.
#[derive(Debug)]
struct Ticket {
    id: Value,
    permit: OwnedPermit<Utf8Bytes>,
}

/// Text message from a viewer.
#[derive(Debug, PartialEq)]
pub(super) struct Parsed {
    /// Number of the command; null if the message has none.
    pub(super) id: Value,
    /// Name and message, or the error.
    pub(super) command: Result<(String, Map<String, Value>), &'static str>,
}

impl Parsed {
    /// Parses a message.
    pub(super) fn of(text: &str) -> Self {
        let Ok(Value::Object(message)) = serde_json::from_str(text) else {
            return Self { id: Value::Null, command: Err("a command is a JSON object") };
        };
        let Some(id) = message.get("id").filter(|id| id.is_number()).cloned() else {
            return Self { id: Value::Null, command: Err("a command has an `id`, a number") };
        };
        match message.get("command").and_then(Value::as_str).map(str::to_owned) {
            Some(name) => Self { id, command: Ok((name, message)) },
            None => Self { id, command: Err("`command` is the name of a command") },
        }
    }
}

impl PendingCommand {
    /// Creates a command with a reserved slot for the response.
    pub(super) fn new(id: Value, name: String, message: Map<String, Value>, permit: OwnedPermit<Utf8Bytes>) -> Self {
        Self { name, message, ticket: Ticket { id, permit } }
    }

    /// Sends the response to the viewer: keys in addition to the confirmation, or the reason for a rejection.
    pub(crate) fn answer(self, result: Result<Map<String, Value>, String>) {
        let Ticket { id, permit } = self.ticket;
        permit.send(answer(&id, result));
    }
}

/// Creates the response message.
pub(super) fn answer(id: &Value, result: Result<Map<String, Value>, String>) -> Utf8Bytes {
    let (error, more) = match result {
        Ok(more) => (None, more),
        Err(reason) => (Some(reason), Map::new()),
    };
    json!(wire::Message::Answer(wire::Answer { id: id.clone(), error, more })).to_string().into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_has_a_number_and_a_name() {
        let parsed = Parsed::of(r#"{"id": 7, "command": "pace", "speed": 2}"#);
        assert_eq!(parsed.id, 7);
        let (name, message) = parsed.command.unwrap();
        assert_eq!((name.as_str(), &message["speed"]), ("pace", &json!(2)));
        for text in ["", "[]", "{", "{}", r#"{"id": "x", "command": "pace"}"#] {
            assert_eq!(Parsed::of(text).id, Value::Null, "{text}");
            assert!(Parsed::of(text).command.is_err(), "{text}");
        }
        assert_eq!(Parsed::of(r#"{"id": 1, "command": 2}"#).id, 1);
    }

    #[test]
    fn an_answer_has_the_number_of_its_command() {
        assert_eq!(&*answer(&json!(7), Ok(Map::new())), r#"{"error":null,"id":7,"kind":"answer"}"#);
        let text = answer(&json!(8), Err("<b>".to_owned()));
        assert_eq!(&*text, r#"{"error":"<b>","id":8,"kind":"answer"}"#);
    }
}
