//! List of all pages.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use val3_check::topics::{Topic, TopicKind};

use crate::markdown::{code_style, heading_style, styled};

/// Writes one line for each topic, grouped by kind and group.
pub(super) fn write(topics: &[Topic], out: &mut dyn WriteColor) -> io::Result<()> {
    let mut listed: Option<(TopicKind, &str)> = None;
    for topic in topics {
        let place = (topic.kind, topic.group);
        if listed != Some(place) {
            if listed.is_some() {
                writeln!(out)?;
            }
            heading(topic, out)?;
            listed = Some(place);
        }
        entry(topic, out)?;
    }
    Ok(())
}

/// Writes a group heading, for example `Instructions: Motion`.
fn heading(Topic { kind, group, .. }: &Topic, out: &mut dyn WriteColor) -> io::Result<()> {
    let title = if group.is_empty() { kind.heading().to_owned() } else { format!("{}: {group}", kind.heading()) };
    styled(&heading_style(), &title, out)?;
    writeln!(out)
}

fn entry(topic: &Topic, out: &mut dyn WriteColor) -> io::Result<()> {
    let name = if topic.kind == TopicKind::Finding { &topic.title } else { topic.name() };
    let width = if topic.kind == TopicKind::Finding { 30 } else { 18 };
    write!(out, "  ")?;
    styled(&code_style(), &format!("{name:<width$}"), out)?;
    writeln!(out, " {}", topic.summary)
}
