//! Search results.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use val3_check::topics::{Hit, TopicKind};

use crate::markdown::{code_style, heading_style, render, styled};

/// Maximum number of shown results.
const MOST: usize = 10;

/// Writes the best results: the arguments for `val3 explain`, the title and an excerpt.
pub(super) fn write(words: &[&str], hits: &[Hit<'_>], out: &mut dyn WriteColor) -> io::Result<()> {
    match words {
        [word] => writeln!(out, "No page has the name `{word}`. It is searched in the text of all pages:")?,
        _ => writeln!(out, "Pages with the words {}:", words.join(", "))?,
    }
    for hit in hits.iter().take(MOST) {
        writeln!(out)?;
        styled(&code_style(), &hit.topic.title, out)?;
        write!(out, " ")?;
        styled(&heading_style(), &format!("({})", kind(hit.topic.kind)), out)?;
        writeln!(out)?;
        render(&hit.excerpt, out)?;
    }
    match hits.len().checked_sub(MOST) {
        Some(more @ 1..) => writeln!(out, "\n{more} more pages have them; add a word to narrow the search."),
        _ => Ok(()),
    }
}

/// Name of the page kind, in the singular.
pub(super) fn kind(kind: TopicKind) -> &'static str {
    match kind {
        TopicKind::Finding => "finding",
        TopicKind::Statement => "statement",
        TopicKind::Instruction => "instruction",
        TopicKind::Type => "type",
        TopicKind::Field => "field",
        TopicKind::Operator => "operator",
        TopicKind::Word => "word",
        TopicKind::RuntimeError => "run-time error",
        TopicKind::LibraryError => "library result",
        TopicKind::LogMessage => "log message",
    }
}
