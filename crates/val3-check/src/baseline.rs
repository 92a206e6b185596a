//! Findings that are known and not reported: those of the day when the check was introduced.
//!
//! A finding is known by its rule, its file, its program and the text of its line, and by how many such findings there
//! are. So it stays known when lines move, and becomes new when its line is edited: who touches a line, mends it.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use val3_analysis::db::Db;

use crate::diagnostic::Diagnostic;

/// The form of the file that this version reads and writes.
const VERSION: u32 = 1;

/// The most characters of a line that are kept.
const LINE_LIMIT: usize = 200;

/// What makes a finding the same after an edit elsewhere.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Fingerprint {
    /// The file, seen from the folder of the baseline, with `/`.
    pub file: String,
    /// The program, for findings in programs.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub program: Option<String>,
    /// The code of the rule.
    pub rule: String,
    /// The text of the line without the blanks around it.
    pub line: String,
}

impl Fingerprint {
    /// The fingerprint of a finding in `file`, as the baseline names it.
    pub fn new(db: &dyn Db, diagnostic: &Diagnostic, file: String) -> Self {
        let text = diagnostic.place.file.text(db);
        let line = line_around(text, diagnostic.place.range.start().into());
        let rule = diagnostic.rule.code.to_owned();
        Self { file, program: diagnostic.program.clone(), rule, line: line.chars().take(LINE_LIMIT).collect() }
    }
}

fn line_around(text: &str, at: usize) -> &str {
    let (before, behind) = text.split_at_checked(at).unwrap_or((text, ""));
    let start = before.rfind('\n').map_or(0, |end| end + 1);
    let end = before.len() + behind.find('\n').unwrap_or(behind.len());
    text.get(start..end).unwrap_or("").trim()
}

/// Known findings, each with how often it is there.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Stored", into = "Stored")]
pub struct Baseline(BTreeMap<Fingerprint, usize>);

/// What a baseline says about the findings of a check.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Verdict {
    /// For each finding whether it is new, in their order.
    pub new: Vec<bool>,
    /// What is known and was not found again.
    pub gone: Baseline,
}

impl Baseline {
    /// How many findings are known.
    pub fn count(&self) -> usize {
        self.0.values().sum()
    }

    /// Holds `found` against what is known.
    pub fn judge(&self, found: &[Fingerprint]) -> Verdict {
        let mut left = self.0.clone();
        let mut is_new = |fingerprint: &Fingerprint| match left.get_mut(fingerprint) {
            Some(count) if *count > 0 => {
                *count -= 1;
                false
            }
            _ => true,
        };
        let new = found.iter().map(&mut is_new).collect();
        left.retain(|_, count| *count > 0);
        Verdict { new, gone: Self(left) }
    }

    /// Drops the entries for which `keep` does not hold.
    pub fn retain(&mut self, mut keep: impl FnMut(&Fingerprint) -> bool) {
        self.0.retain(|fingerprint, _| keep(fingerprint));
    }

    /// Takes out findings, as many of each as `gone` has.
    pub fn remove(&mut self, gone: &Self) {
        for (fingerprint, count) in &gone.0 {
            if let Some(known) = self.0.get_mut(fingerprint) {
                *known = known.saturating_sub(*count);
            }
        }
        self.0.retain(|_, count| *count > 0);
    }
}

impl Extend<Fingerprint> for Baseline {
    fn extend<I: IntoIterator<Item = Fingerprint>>(&mut self, found: I) {
        found.into_iter().for_each(|fingerprint| *self.0.entry(fingerprint).or_default() += 1);
    }
}

/// A baseline as it stands in a file.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Stored {
    version: u32,
    findings: Vec<Known>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
struct Known {
    #[serde(flatten)]
    fingerprint: Fingerprint,
    #[serde(default = "once", skip_serializing_if = "is_once")]
    count: usize,
}

fn once() -> usize {
    1
}

#[expect(clippy::trivially_copy_pass_by_ref, reason = "the shape that serde asks for")]
fn is_once(count: &usize) -> bool {
    *count == 1
}

impl From<Baseline> for Stored {
    fn from(baseline: Baseline) -> Self {
        let known = |(fingerprint, count)| Known { fingerprint, count };
        Self { version: VERSION, findings: baseline.0.into_iter().map(known).collect() }
    }
}

impl TryFrom<Stored> for Baseline {
    type Error = String;

    fn try_from(stored: Stored) -> Result<Self, String> {
        if stored.version != VERSION {
            return Err(format!("its form has the number {}, and this version reads {VERSION}", stored.version));
        }
        let mut baseline = Self::default();
        for Known { fingerprint, count } in stored.findings {
            *baseline.0.entry(fingerprint).or_default() += count;
        }
        Ok(baseline)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(line: &str) -> Fingerprint {
        Fingerprint { file: "a.pgx".to_owned(), program: None, rule: "V0101".to_owned(), line: line.to_owned() }
    }

    fn baseline(lines: &[&str]) -> Baseline {
        let mut baseline = Baseline::default();
        baseline.extend(lines.iter().map(|line| found(line)));
        baseline
    }

    fn new(known: &[&str], now: &[&str]) -> Vec<bool> {
        baseline(known).judge(&now.iter().map(|line| found(line)).collect::<Vec<_>>()).new
    }

    #[test]
    fn what_is_known_is_not_new_wherever_it_stands() {
        assert_eq!(new(&["a", "b"], &["b", "a"]), [false, false]);
        assert_eq!(new(&["a"], &["a", "b"]), [false, true]);
    }

    #[test]
    fn one_more_of_the_same_is_new() {
        assert_eq!(new(&["a", "a"], &["a", "a", "a"]), [false, false, true]);
    }

    #[test]
    fn what_is_gone_can_be_removed() {
        let mut known = baseline(&["a", "a", "b"]);
        let verdict = known.judge(&[found("a")]);
        assert_eq!(verdict.gone, baseline(&["a", "b"]));
        known.remove(&verdict.gone);
        assert_eq!(known, baseline(&["a"]));
    }

    #[test]
    fn the_line_around_a_place() {
        let text = "one\n  two \nthree";
        assert_eq!(["one", "two", "three"], [0, 4, 11].map(|at| line_around(text, at)));
        assert_eq!((line_around(text, 3), line_around(text, text.len())), ("one", "three"));
    }
}
