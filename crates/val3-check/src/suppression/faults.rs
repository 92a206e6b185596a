//! Faults of the comments themselves.

use val3_analysis::db::{Db, File, FileEdit, FileRange, Project};
use val3_analysis::items::faults::text_faults;
use val3_analysis::items::program;
use val3_analysis::items::suppressions::{SuppressedRule, Suppression, SuppressionExtent, suppressions};
use val3_lang::suggest::nearest;
use val3_syntax::{TextRange, TextSize};

use super::{UsedComments, can_be_silenced};
use crate::diagnostic::{Diagnostic, Fix, Wording};
use crate::rule::Rule;
use crate::rules::{self, unknown_suppression, unused_suppression};
use crate::settings::Settings;

/// Comments in a program that can never silence anything.
pub(crate) fn unknown(db: &dyn Db, project: Project, file: File) -> Vec<Diagnostic> {
    let rule = &unknown_suppression::RULE;
    let finding = |(range, wording)| finding(db, project, rule, FileRange { file, range }, wording);
    suppressions(db, file).iter().flat_map(faults).map(finding).collect()
}

fn faults(suppression: &Suppression) -> Vec<(TextRange, Wording)> {
    match suppression.scope {
        SuppressionExtent::Unreadable => vec![(suppression.comment, unknown_suppression::form())],
        SuppressionExtent::Misplaced => vec![(suppression.comment, unknown_suppression::misplaced())],
        SuppressionExtent::Line(_) | SuppressionExtent::Program => {
            suppression.rules.iter().filter_map(unknown_rule).collect()
        }
    }
}

fn unknown_rule(word: &SuppressedRule) -> Option<(TextRange, Wording)> {
    let wording = match rules::find(&word.name) {
        None => {
            let words = rules::all().iter().flat_map(|rule| [rule.code, rule.name]);
            unknown_suppression::rule(&word.name, nearest(&word.name, words))
        }
        Some(rule) if !can_be_silenced(rule) => unknown_suppression::never_silenced(&word.name),
        Some(_) => return None,
    };
    Some((word.range, wording))
}

/// Comments in a program that silenced nothing. If the text has faults, not every rule ran.
pub(crate) fn unused(
    db: &dyn Db,
    project: Project,
    file: File,
    settings: &Settings,
    used: &UsedComments,
) -> Vec<Diagnostic> {
    let found = suppressions(db, file);
    if found.is_empty() || !text_faults(db, file).errors.is_empty() || !settings.is_enabled(&unused_suppression::RULE) {
        return Vec::new();
    }
    let is_idle = |word: &SuppressedRule| !used.contains(&word_place(file, word)) && can_silence(word, settings);
    let mut idle = Vec::new();
    for suppression in found
        .iter()
        .filter(|found| !matches!(found.scope, SuppressionExtent::Misplaced | SuppressionExtent::Unreadable))
    {
        let whole = suppression.rules.iter().all(is_idle);
        for (place, word) in suppression.rules.iter().enumerate().filter(|(_, word)| is_idle(word)) {
            let edit = if whole { comment_line(file.text(db), suppression.comment) } else { entry(suppression, place) };
            let wording = unused_suppression::word(&word.name, suppression.scope == SuppressionExtent::Program);
            let place = word_place(file, word);
            let mut finding = finding(db, project, &unused_suppression::RULE, place, wording);
            finding.fix = Some(removal(file, edit));
            idle.push(finding);
        }
    }
    idle
}

fn word_place(file: File, word: &SuppressedRule) -> FileRange {
    FileRange { file, range: word.range }
}

/// Whether the named rule exists, runs, and can be silenced.
fn can_silence(word: &SuppressedRule, settings: &Settings) -> bool {
    rules::find(&word.name).is_some_and(|rule| can_be_silenced(rule) && settings.is_enabled(rule))
}

/// The comment with its whole line.
fn comment_line(text: &str, comment: TextRange) -> TextRange {
    let (start, end) = (usize::from(comment.start()), usize::from(comment.end()));
    let line_start = text.get(..start).and_then(|before| before.rfind('\n')).map_or(0, |at| at + 1);
    let line_end = text.get(end..).and_then(|rest| rest.find('\n')).map_or(end, |at| end + at + 1);
    let is_alone = text.get(line_start..start).is_some_and(|before| before.trim().is_empty());
    match (is_alone, TextSize::try_from(line_start), TextSize::try_from(line_end)) {
        (true, Ok(start), Ok(end)) => TextRange::new(start, end),
        _ => comment,
    }
}

/// Range of a word in a list, with the comma before or after it.
fn entry(suppression: &Suppression, place: usize) -> TextRange {
    let word = |place: usize| suppression.rules.get(place).map(|word| word.range);
    let own = word(place).unwrap_or(suppression.comment);
    match (place.checked_sub(1).and_then(word), word(place + 1)) {
        (Some(before), _) => TextRange::new(before.end(), own.end()),
        (None, Some(behind)) => TextRange::new(own.start(), behind.start()),
        (None, None) => own,
    }
}

fn removal(file: File, range: TextRange) -> Fix {
    let edit = FileEdit { file, range, text: String::new() };
    Fix { title: "remove what silences nothing".to_owned(), safe: true, edits: vec![edit] }
}

fn finding(db: &dyn Db, project: Project, rule: &'static Rule, place: FileRange, wording: Wording) -> Diagnostic {
    let program = Some(program::header(db, place.file).name.to_string());
    Diagnostic { program, application: Some(project.manifest(db)), ..Diagnostic::new(rule, wording, place) }
}
