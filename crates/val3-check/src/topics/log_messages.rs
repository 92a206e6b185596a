//! Pages of messages in the controller's event log, and of the faults that its compiler reports there.

use val3_lang::log_messages::{COMPILE_ERROR, CompileFault, Explanation, LogMessage, compile_faults, log_messages};

use super::topic::{Topic, TopicKind};

/// Heading of the messages with a code.
const CODES: &str = "By code";

/// Heading of the compiler's faults.
const COMPILER: &str = "Compiler";

/// Pages of all messages.
pub(super) fn topics() -> Vec<Topic> {
    log_messages().iter().map(message).chain(compile_faults().iter().map(fault)).collect()
}

fn message(message: &LogMessage) -> Topic {
    let title = format!("{} {}", message.code, message.explanation.meaning);
    let level = message.level.map_or_else(String::new, |level| format!(", {}", level.name()));
    let heading = format!("{title} (message of the controller's log{level})");
    let page = page(&heading, &message.explanation);
    topic(CODES, message.code, title, &message.explanation, page)
}

fn fault(fault: &CompileFault) -> Topic {
    let heading = format!("{} (message of the controller's compiler, {COMPILE_ERROR})", fault.text);
    let page = page(&heading, &fault.explanation);
    topic(COMPILER, fault.text, fault.text.to_owned(), &fault.explanation, page)
}

fn topic(group: &'static str, name: &str, title: String, explanation: &Explanation, page: String) -> Topic {
    Topic {
        kind: TopicKind::LogMessage,
        group,
        names: vec![name.to_owned()],
        stem: name.replace(' ', "-"),
        title,
        summary: explanation.meaning.to_owned(),
        page,
    }
}

fn page(heading: &str, explanation: &Explanation) -> String {
    let Explanation { cause, remedy, .. } = explanation;
    let remedy = if remedy.is_empty() { String::new() } else { format!("\nWhat to do: {remedy}\n") };
    format!("# {heading}\n\n{cause}\n{remedy}")
}
