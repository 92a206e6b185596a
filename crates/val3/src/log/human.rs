//! Messages for people.

use std::collections::BTreeSet;
use std::io;

use codespan_reporting::term::termcolor::{Color, ColorSpec, WriteColor};

use super::record::{MessageRecord, SourceRecord};
use crate::markdown::styled;
use crate::printable::one_line;

/// Writes messages, and explains each kind of message once.
#[derive(Debug, Default)]
pub(super) struct HumanLog {
    /// Words for `val3 explain` of the explained messages.
    explained: BTreeSet<String>,
}

impl HumanLog {
    /// Writes a message with the lines below it.
    pub(super) fn write(&mut self, record: &MessageRecord, out: &mut dyn WriteColor) -> io::Result<()> {
        headline(record, out)?;
        if let Some(place) = place(record) {
            writeln!(out, "    = {place}")?;
        }
        record.sources.iter().try_for_each(|source| write_source(source, out))?;
        self.explain(record, out)
    }

    /// Explains a message with a remedy if no message of its kind was explained before.
    fn explain(&mut self, record: &MessageRecord, out: &mut dyn WriteColor) -> io::Result<()> {
        let (Some(topic), Some(remedy)) = (&record.topic, record.remedy) else { return Ok(()) };
        if !self.explained.insert(topic.clone()) {
            return Ok(());
        }
        let meaning = record.meaning.unwrap_or_default();
        match (record.error, record.cause) {
            (Some(error), _) => writeln!(out, "    = run-time error {error}, {meaning}: {remedy}"),
            (None, cause) => {
                writeln!(out, "    = {meaning}: {}", cause.unwrap_or_default())?;
                writeln!(out, "    = what to do: {remedy}")
            }
        }
    }
}

/// Writes time, level, code and text. A line in no known form is written unchanged.
fn headline(record: &MessageRecord, out: &mut dyn WriteColor) -> io::Result<()> {
    if let Some(time) = &record.time {
        write!(out, "{time} ")?;
    }
    if let Some(level) = record.level {
        styled(&style(level), level, out)?;
        write!(out, " ")?;
    }
    if let Some(code) = &record.code {
        write!(out, "{} ", one_line(code))?;
    }
    writeln!(out, "{}", one_line(record.text.trim_end()))
}

/// Application, task and program, as far as the text does not name them.
fn place(record: &MessageRecord) -> Option<String> {
    let parts = [("application", &record.application), ("program", &record.program)];
    // Usual messages of a program remain in one line.
    let has_remedy = record.remedy.is_some();
    let is_new = |name: &str| has_remedy && !record.text.contains(name) && record.sources.is_empty();
    let known = parts.into_iter().filter_map(|(kind, name)| Some((kind, name.as_deref().filter(|name| is_new(name))?)));
    let known: Vec<String> = known.map(|(kind, name)| format!("{kind} `{}`", one_line(name))).collect();
    (!known.is_empty()).then(|| known.join(", "))
}

fn write_source(source: &SourceRecord, out: &mut dyn WriteColor) -> io::Result<()> {
    let SourceRecord { file, line, text, changed, .. } = source;
    write!(out, "    {}:{line}: {}", one_line(file), one_line(text))?;
    writeln!(out, "{}", if *changed { " (the program was changed since)" } else { "" })
}

fn style(level: &str) -> ColorSpec {
    let mut style = ColorSpec::new();
    let color = match level {
        "CRITICAL" | "ERROR" => Some(Color::Red),
        "WARN" => Some(Color::Yellow),
        _ => None,
    };
    style.set_fg(color).set_bold(color.is_some());
    style
}
