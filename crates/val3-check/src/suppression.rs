//! Findings that a comment silences, and comments that silence nothing.

mod comments;
mod faults;

use rustc_hash::FxHashSet;
use val3_analysis::db::{Db, File, FileRange};
use val3_analysis::items::suppressions::{SuppressedRule, suppressions};

pub(crate) use comments::silencing;
pub(crate) use faults::{unknown, unused};

use crate::check::Checked;
use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use crate::rules::{self, unknown_suppression, unused_suppression};

/// Locations of the words in comments that silenced something.
pub(crate) type UsedComments = FxHashSet<FileRange>;

/// Whether comments can silence findings of a rule. They cannot for syntax errors, because of which the controller
/// rejects the whole application, and for findings about the comment itself.
pub fn can_be_silenced(rule: &Rule) -> bool {
    let of_comments = [unused_suppression::RULE.code, unknown_suppression::RULE.code];
    !rule.code.starts_with("V00") && !of_comments.contains(&rule.code)
}

/// Removes the findings that comments silence.
pub(crate) fn apply(db: &dyn Db, found: Vec<Diagnostic>) -> Checked {
    let mut checked = Checked::default();
    for diagnostic in found {
        let words = silencers(db, &diagnostic);
        if words.is_empty() {
            checked.findings.push(diagnostic);
        } else {
            checked.silenced += 1;
            checked.used.extend(words);
        }
    }
    checked
}

/// Words in comments that silence a finding.
fn silencers(db: &dyn Db, diagnostic: &Diagnostic) -> Vec<FileRange> {
    let FileRange { file, range } = diagnostic.place;
    if !may_have_code(db, file) || !can_be_silenced(diagnostic.rule) {
        return Vec::new();
    }
    let covering = suppressions(db, file).iter().filter(|suppression| suppression.covers(range.start()));
    let words = covering.flat_map(|suppression| &suppression.rules).filter(|word| means(word, diagnostic.rule));
    words.map(|word| FileRange { file, range: word.range }).collect()
}

/// Whether the file may contain code. Data and project files, which are few but large, are not searched.
fn may_have_code(db: &dyn Db, file: File) -> bool {
    file.path(db).extension().is_some_and(|extension| extension.eq_ignore_ascii_case("pgx"))
}

fn means(word: &SuppressedRule, rule: &Rule) -> bool {
    rules::find(&word.name).is_some_and(|meant| meant.code == rule.code)
}

#[cfg(test)]
mod tests;
