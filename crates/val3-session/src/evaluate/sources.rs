//! Files of the application that evaluates code: an existing or an empty application, with a program and a data file
//! for the code.

use std::ops::Range;

use camino::{Utf8Path, Utf8PathBuf};
use val3_analysis::db::{Database, Project};
use val3_analysis::items::declarations::listing;
use val3_lang::types::Arm;
use val3_syntax::error::SyntaxErrorKind;
use val3_syntax::xml::escaped;
use val3_syntax::{TextRange, decode_entities};

use super::variable::ScratchVariable;
use crate::error::SessionError;

/// Name of the program for evaluated code, and of the empty application.
pub(crate) const NAME: &str = "eval__";

const HEAD: &str = "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n";

/// Project file of the empty application, in a folder that need not exist.
pub(crate) fn empty(folder: &Utf8Path) -> (Utf8PathBuf, String) {
    let manifest = format!(
        "{HEAD}<Project xmlns=\"http://www.staubli.com/robotics/VAL3/Project/3\">\n  \
         <Parameters version=\"s7.11\" stackSize=\"100000\" millimeterUnit=\"true\" />\n  \
         <Programs>\n    <Program file=\"{NAME}.pgx\" />\n  </Programs>\n  \
         <Database>\n    <Data file=\"{NAME}.dtx\" />\n  </Database>\n</Project>\n"
    );
    (folder.join(format!("{NAME}.pjx")), manifest)
}

/// The application's project file, with the additional program and data file.
pub(crate) fn extended(db: &Database, project: Project) -> Result<(Utf8PathBuf, String), SessionError> {
    let file = project.manifest(db);
    let (path, mut text) = (file.path(db).clone(), file.text(db).to_string());
    let mut changes: Vec<(TextRange, String)> = Vec::new();
    for (of_programs, kind) in [(true, "pgx"), (false, "dtx")] {
        let change = listing(db, project, of_programs, &format!("{NAME}.{kind}"));
        changes.push(change.ok_or_else(|| incomplete(&path))?);
    }
    changes.sort_unstable_by_key(|(range, _)| std::cmp::Reverse(range.start()));
    changes.iter().for_each(|(range, entry)| text.replace_range(Range::<usize>::from(*range), entry));
    Ok((path, text))
}

fn incomplete(manifest: &Utf8Path) -> SessionError {
    SessionError::Variables {
        message: format!("`{manifest}` is not a complete project file"),
        help: "`val3 check` shows what is wrong with it".to_owned(),
    }
}

/// Whether a block of the code is unclosed. Other faults do not count: the lines of a faulty block belong together, too,
/// because they must not be executed without its condition.
pub fn has_open_block(code: &str) -> bool {
    let parse = val3_syntax::parse(&program(code));
    parse.errors().iter().any(|error| matches!(error.kind, SyntaxErrorKind::UnclosedBlock { .. }))
}

/// Splits pasted code into separately evaluated parts: single lines, and the lines of a block together. Empty lines
/// outside blocks are omitted.
pub fn texts(code: &str) -> Vec<String> {
    let (mut texts, mut open) = (Vec::new(), String::new());
    for line in code.lines() {
        texts.extend(next_text(&mut open, line));
    }
    texts.extend(Some(open).filter(|open| !open.trim().is_empty()));
    texts
}

/// Appends a line to the unfinished code in `open`. Returns the code if the line completes it.
pub fn next_text(open: &mut String, line: &str) -> Option<String> {
    if !open.is_empty() {
        open.push('\n');
    }
    open.push_str(line);
    if has_open_block(open) {
        return None;
    }
    let text = std::mem::take(open);
    (!text.trim().is_empty()).then_some(text)
}

/// Data file with the variables, whose positions are for this kind of arm.
pub(crate) fn data(variables: &[ScratchVariable], arm: Arm) -> String {
    let lines: Vec<String> = variables.iter().map(|variable| variable.data(arm)).collect();
    format!(
        "{HEAD}<Database xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
         xmlns=\"http://www.staubli.com/robotics/VAL3/Data/2\">\n  <Datas>\n{}\n  </Datas>\n</Database>\n",
        lines.join("\n")
    )
}

/// Program file before the code, which begins on the second line.
const BEFORE: &str = "<Programs xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" \
     xmlns=\"http://www.staubli.com/robotics/VAL3/Program/2\"><Program name=\"eval__\"><Code>begin\n";

/// Program that executes `code`. The code is escaped, because a CDATA section cannot contain `]]>`.
pub(crate) fn program(code: &str) -> String {
    format!("{BEFORE}{}\nend</Code></Program></Programs>\n", escaped(code))
}

/// Offset, in the program that executes the code, of the character after `before`, the start of the code.
pub(crate) fn offset_in_program(before: &str) -> usize {
    BEFORE.len() + escaped(before).len()
}

/// Offset in `code` of the byte `offset` in the program that executes it. Offsets outside the code are limited to its
/// range.
pub(crate) fn offset_in_code(code: &str, offset: usize) -> usize {
    let escaped = escaped(code);
    let before = escaped.get(..offset.saturating_sub(BEFORE.len())).unwrap_or(&escaped);
    decode_entities(before).len()
}

#[cfg(test)]
mod tests;
