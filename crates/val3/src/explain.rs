//! `val3 explain`: shows the page of a word, or searches all pages.

mod json;
mod list;
mod results;

use std::io;

use codespan_reporting::term::termcolor::WriteColor;
use val3_check::topics::{self, Hit, Topic};
use val3_lang::suggest::{proposals, question};

use crate::args::{ExplainArgs, ExplainFormat};
use crate::color::Color;
use crate::markdown::render;
use crate::output::{OutputContent, to_stdout, to_stdout_as};
use crate::user_error::UserError;

/// Runs the command.
pub(crate) fn run(args: &ExplainArgs, color: Color) -> Result<(), UserError> {
    let topics = topics::all();
    let words: Vec<&str> = args.words.iter().flat_map(|words| words.split_whitespace()).collect();
    let answer = match (words.is_empty(), args.format) {
        (true, ExplainFormat::Human) => return to_stdout(color, |out| list::write(&topics, out)),
        (true, ExplainFormat::Json) => Answer::Pages(topics.iter().collect()),
        (false, _) => answer(&topics, &words)?,
    };
    if args.format == ExplainFormat::Json {
        return to_stdout_as(OutputContent::Json, color, |out| writeln!(out, "{}", json::document(&answer)));
    }
    to_stdout(color, |out| match &answer {
        Answer::Pages(found) => pages(found, out),
        Answer::Hits(hits) => results::write(&words, hits, out),
    })
}

/// Result of the command.
#[derive(Debug, PartialEq)]
enum Answer<'a> {
    /// Pages with this name. Several errors may share a number.
    Pages(Vec<&'a Topic>),
    /// Pages that contain the words.
    Hits(Vec<Hit<'a>>),
}

/// Returns the pages whose name consists of all words, such as `tool centre point`, otherwise the pages that contain
/// the words.
fn answer<'a>(topics: &'a [Topic], words: &[&str]) -> Result<Answer<'a>, UserError> {
    let name = words.join(" ");
    let named = topics::find(topics, number_of_error(words).unwrap_or(&name));
    if !named.is_empty() {
        return Ok(Answer::Pages(named));
    }
    let hits = topics::search(topics, words);
    if hits.is_empty() { Err(unknown(topics, &name)) } else { Ok(Answer::Hits(hits)) }
}

/// Number in `error 123`, as in the log of a run or a controller.
fn number_of_error<'w>(words: &[&'w str]) -> Option<&'w str> {
    let (number, before) = words.split_last()?;
    let digits = number.trim_matches(['[', ']', ':']);
    let is_number = !digits.is_empty() && digits.bytes().all(|byte| byte.is_ascii_digit());
    (is_number && !before.is_empty() && before.iter().all(|word| is_error(word))).then_some(digits)
}

/// Whether the word precedes the number of a run-time error.
fn is_error(word: &str) -> bool {
    ["error", "err", "run-time"].contains(&word.to_lowercase().as_str())
}

fn unknown(topics: &[Topic], name: &str) -> UserError {
    let names = topics.iter().flat_map(|topic| topic.names.iter().map(String::as_str));
    let help =
        question(proposals(name, names)).unwrap_or_else(|| "`val3 explain` without a word lists all pages".to_owned());
    UserError::new(format!("there is no page for `{name}`, and none that contains it")).with_help(help)
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

#[cfg(test)]
mod tests {
    use codespan_reporting::term::termcolor::NoColor;
    use val3_check::topics::TopicKind;

    use super::*;

    fn topic(kind: TopicKind, group: &'static str, names: &[&str], summary: &str) -> Topic {
        let names: Vec<String> = names.iter().map(|&name| name.to_owned()).collect();
        let title = names.join(" ");
        let page = format!("# {title}\n\n{summary}.\n");
        Topic { kind, group, stem: title.clone(), title, names, summary: summary.to_owned(), page }
    }

    fn topics() -> Vec<Topic> {
        vec![
            topic(TopicKind::Finding, "Types", &["V0203", "argument-type"], "The type is not accepted"),
            topic(TopicKind::Instruction, "Numbers", &["abs"], "The absolute value"),
            topic(TopicKind::Instruction, "Motion", &["movej"], "Moves in joint space"),
            topic(TopicKind::Word, "", &["tool centre point", "TCP"], "The point that moves"),
            topic(TopicKind::RuntimeError, "", &["11"], "Numerical value"),
            topic(TopicKind::LibraryError, "", &["11"], "Library not found"),
        ]
    }

    fn written(write: impl FnOnce(&mut dyn WriteColor) -> io::Result<()>) -> String {
        let mut out = NoColor::new(Vec::new());
        write(&mut out).unwrap();
        String::from_utf8(out.into_inner()).unwrap()
    }

    #[test]
    fn the_list_has_a_line_for_each_topic() {
        insta::assert_snapshot!(written(|out| list::write(&topics(), out)));
    }

    #[test]
    fn a_word_finds_its_pages_in_any_letter_case() {
        let topics = topics();
        assert_eq!(answer(&topics, &["v0203"]).unwrap(), answer(&topics, &["Argument-Type"]).unwrap());
        let Answer::Pages(found) = answer(&topics, &["11"]).unwrap() else { panic!() };
        insta::assert_snapshot!(written(|out| pages(&found, out)));
    }

    #[test]
    fn a_name_can_have_several_words() {
        let topics = topics();
        assert_eq!(answer(&topics, &["tool", "centre", "point"]).unwrap(), answer(&topics, &["tcp"]).unwrap());
    }

    #[test]
    fn other_words_are_searched() {
        let topics = topics();
        for words in [["joint", "space"].as_slice(), &["accepted"]] {
            let Answer::Hits(hits) = answer(&topics, words).unwrap() else { panic!() };
            insta::assert_snapshot!(words.join(" "), written(|out| results::write(words, &hits, out)));
        }
    }

    #[test]
    fn an_unknown_word_gets_a_proposal() {
        let error = answer(&topics(), &["movje"]).unwrap_err().to_string();
        assert!(error.contains("no page for `movje`") && error.contains("did you mean `movej`?"), "{error}");
        let error = answer(&topics(), &["pneumatics"]).unwrap_err().to_string();
        assert!(error.contains("lists all pages"), "{error}");
    }
}
