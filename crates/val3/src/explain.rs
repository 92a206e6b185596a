//! `val3 explain`: the page of a finding, a statement, an instruction or a run-time error.

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use val3_check::topics::{self, Kind, Topic};
use val3_lang::suggest::{proposals, question};

use crate::args::ExplainArgs;
use crate::color::Color;
use crate::markdown::{code_style, heading_style, render, styled};
use crate::output::to_stdout;
use crate::user_error::UserError;

/// Runs the command.
pub(crate) fn run(args: &ExplainArgs, color: Color) -> Result<(), UserError> {
    let topics = topics::all();
    match &args.topic {
        None => to_stdout(color, |out| list(&topics, out)),
        Some(word) => {
            let found = find(&topics, word)?;
            to_stdout(color, |out| pages(&found, out))
        }
    }
}

/// The topics of a word. Several errors may share a number.
fn find<'a>(topics: &'a [Topic], word: &str) -> Result<Vec<&'a Topic>, UserError> {
    let word = word.trim();
    let exact: Vec<_> = topics.iter().filter(|topic| topic.names.iter().any(|name| name == word)).collect();
    if !exact.is_empty() {
        return Ok(exact);
    }
    let same = |topic: &&Topic| topic.names.iter().any(|name| name.eq_ignore_ascii_case(word));
    let found: Vec<_> = topics.iter().filter(same).collect();
    if found.is_empty() { Err(unknown(topics, word)) } else { Ok(found) }
}

fn unknown(topics: &[Topic], word: &str) -> UserError {
    let names = topics.iter().flat_map(|topic| topic.names.iter().map(String::as_str));
    let help =
        question(proposals(word, names)).unwrap_or_else(|| "`val3 explain` without a word lists all pages".to_owned());
    UserError::new(format!("there is no page for `{word}`")).with_help(help)
}

fn pages(topics: &[&Topic], out: &mut dyn WriteColor) -> io::Result<()> {
    for (place, topic) in topics.iter().enumerate() {
        if place > 0 {
            writeln!(out)?;
        }
        render(&topic.page, out)?;
    }
    Ok(())
}

fn list(topics: &[Topic], out: &mut dyn WriteColor) -> io::Result<()> {
    let mut listed: Option<Kind> = None;
    for topic in topics {
        if listed != Some(topic.kind) {
            heading(topic.kind, listed.is_some(), out)?;
            listed = Some(topic.kind);
        }
        entry(topic, out)?;
    }
    Ok(())
}

fn heading(kind: Kind, follows: bool, out: &mut dyn WriteColor) -> io::Result<()> {
    if follows {
        writeln!(out)?;
    }
    styled(&heading_style(), kind.heading(), out)?;
    writeln!(out)
}

fn entry(topic: &Topic, out: &mut dyn WriteColor) -> io::Result<()> {
    let name = topic.names.first().map_or("", String::as_str);
    write!(out, "  ")?;
    styled(&code_style(), &format!("{name:<16}"), out)?;
    writeln!(out, " {}", topic.summary)
}

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::NoColor;

    use super::*;

    fn topic(kind: Kind, names: &[&str], summary: &str) -> Topic {
        Topic {
            kind,
            names: names.iter().map(|&name| name.to_owned()).collect(),
            summary: summary.to_owned(),
            page: format!("# {}\n\n{summary}.\n", names.join(" ")),
        }
    }

    fn topics() -> Vec<Topic> {
        vec![
            topic(Kind::Finding, &["V0203", "argument-type"], "argument-type"),
            topic(Kind::Instruction, &["movej"], "Moves in joint space"),
            topic(Kind::RuntimeError, &["11"], "Numerical value"),
            topic(Kind::LibraryError, &["11"], "Library not found"),
        ]
    }

    fn written(write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>) -> String {
        let mut out = NoColor::new(Vec::new());
        write(&mut out).unwrap();
        String::from_utf8(out.into_inner()).unwrap()
    }

    #[test]
    fn the_list_has_a_line_for_each_topic() {
        insta::assert_snapshot!(written(|out| list(&topics(), out)));
    }

    #[test]
    fn a_word_finds_its_pages_in_any_letter_case() {
        let topics = topics();
        assert_eq!(find(&topics, "v0203").unwrap(), find(&topics, "Argument-Type").unwrap());
        let found = find(&topics, "11").unwrap();
        insta::assert_snapshot!(written(|out| pages(&found, out)));
    }

    #[test]
    fn an_unknown_word_gets_a_proposal() {
        let error = find(&topics(), "movje").unwrap_err().to_string();
        assert!(error.contains("no page for `movje`") && error.contains("did you mean `movej`?"), "{error}");
        let error = find(&topics(), "pneumatics").unwrap_err().to_string();
        assert!(error.contains("lists all pages"), "{error}");
    }
}
