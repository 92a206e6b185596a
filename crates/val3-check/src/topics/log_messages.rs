//! Pages of messages in the controller's event log.

use val3_lang::log_messages::{LOG_MESSAGES, LogMessage};

use super::topic::{Topic, TopicKind};

/// Pages of all kinds of messages.
pub(super) fn topics() -> Vec<Topic> {
    LOG_MESSAGES.iter().map(topic).collect()
}

fn topic(message: &LogMessage) -> Topic {
    let names: Vec<String> = message.codes.iter().map(|&code| code.to_owned()).collect();
    let codes = names.join(", ");
    Topic {
        kind: TopicKind::LogMessage,
        group: "",
        stem: names.first().cloned().unwrap_or_default(),
        title: format!("{codes} {}", message.short),
        summary: message.short.to_owned(),
        page: format!("# {codes} {} (message of the controller's log)\n\n{}\n", message.short, message.long),
        names,
    }
}
