//! Known findings, which are not reported: findings that existed when the check was introduced.
//!
//! A finding is identified by its [`Fingerprint`] and the number of equal findings. It therefore remains known when
//! lines move, and becomes new when its line is edited, because an edited line should be corrected.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;
use serde::{Deserialize, Serialize};

use crate::fingerprint::Fingerprint;

/// Version of the file format.
const VERSION: u32 = 1;

/// Known findings with their numbers.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "Stored", into = "Stored")]
pub struct Baseline(BTreeMap<Fingerprint, usize>);

/// Result of comparing a check with a baseline.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Verdict {
    /// Whether each finding is new, in order.
    pub new: Vec<bool>,
    /// Known findings that were not found again.
    pub gone: Baseline,
}

impl Baseline {
    /// Number of known findings.
    pub fn count(&self) -> usize {
        self.0.values().sum()
    }

    /// Compares `found` with the known findings. Equal findings in all parts are matched first, then findings on the
    /// same line with a different message, because the tool or other code has changed. If `is_gone` reports that a
    /// known file no longer exists, it was renamed: then a finding in any other file matches if the message is equal,
    /// and a finding in the same folder also matches if only the line is equal, because the message may contain the
    /// name of the program.
    pub fn compare(&self, found: &[Fingerprint], is_gone: impl Fn(&str) -> bool) -> Verdict {
        let mut gone = self.clone();
        let mut new = vec![true; found.len()];
        let any = |_: &Fingerprint| true;
        let renamed = |known: &Fingerprint| is_gone(&known.file);
        gone.take(found, &mut new, any, Fingerprint::clone);
        gone.take(found, &mut new, any, |it| Fingerprint { message: String::new(), ..it.clone() });
        gone.take(found, &mut new, renamed, |it| Fingerprint { file: String::new(), ..it.clone() });
        gone.take(found, &mut new, renamed, |it| {
            let folder = it.file.rsplit_once('/').map_or("", |(folder, _)| folder).to_owned();
            Fingerprint { file: folder, message: String::new(), ..it.clone() }
        });
        Verdict { new, gone }
    }

    /// For each new finding, removes a known finding with the same `key` that `may_be` accepts. The new finding then
    /// counts as known.
    fn take(
        &mut self,
        found: &[Fingerprint],
        new: &mut [bool],
        may_be: impl Fn(&Fingerprint) -> bool,
        key: impl Fn(&Fingerprint) -> Fingerprint,
    ) {
        let mut known: FxHashMap<Fingerprint, Vec<Fingerprint>> = FxHashMap::default();
        for (fingerprint, count) in self.0.iter().rev().filter(|(fingerprint, _)| may_be(fingerprint)) {
            known.entry(key(fingerprint)).or_default().extend(std::iter::repeat_n(fingerprint.clone(), *count));
        }
        for (found, new) in found.iter().zip(new).filter(|(_, new)| **new) {
            if let Some(known) = known.get_mut(&key(found)).and_then(Vec::pop) {
                self.remove(&known);
                *new = false;
            }
        }
    }

    fn remove(&mut self, known: &Fingerprint) {
        if let Some(count) = self.0.get_mut(known) {
            *count = count.saturating_sub(1);
            if *count == 0 {
                self.0.remove(known);
            }
        }
    }

    /// Removes the entries for which `keep` is false.
    pub fn retain(&mut self, mut keep: impl FnMut(&Fingerprint) -> bool) {
        self.0.retain(|fingerprint, _| keep(fingerprint));
    }
}

impl Extend<Fingerprint> for Baseline {
    fn extend<I: IntoIterator<Item = Fingerprint>>(&mut self, found: I) {
        found.into_iter().for_each(|fingerprint| *self.0.entry(fingerprint).or_default() += 1);
    }
}

/// A baseline in its file format.
#[derive(Debug, Clone, Serialize, Deserialize)]
struct Stored {
    version: u32,
    findings: Vec<StoredFinding>,
}

#[derive(Debug, Clone, Serialize, Deserialize)]
struct StoredFinding {
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
        let known = |(fingerprint, count)| StoredFinding { fingerprint, count };
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
        for StoredFinding { fingerprint, count } in stored.findings {
            *baseline.0.entry(fingerprint).or_default() += count;
        }
        Ok(baseline)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Parses `file: line: message`, of which the last two parts are optional.
    fn found(written: &str) -> Fingerprint {
        let mut parts = written.split(": ").map(str::to_owned);
        let mut part = || parts.next().unwrap_or_default();
        Fingerprint { rule: "V0101".to_owned(), file: part(), line: part(), message: part() }
    }

    fn baseline(known: &[&str]) -> Baseline {
        let mut baseline = Baseline::default();
        baseline.extend(known.iter().map(|known| found(known)));
        baseline
    }

    fn new(known: &[&str], now: &[&str]) -> Vec<bool> {
        let now: Vec<_> = now.iter().map(|now| found(now)).collect();
        baseline(known).compare(&now, |file| file == "old/p").new
    }

    #[test]
    fn a_known_finding_stays_known_on_another_line() {
        assert_eq!(new(&["f: a", "f: b"], &["f: b", "f: a"]), [false, false]);
        assert_eq!(new(&["f: a"], &["f: a", "f: b"]), [false, true]);
        assert_eq!(new(&["f: a"], &["g: a"]), [true]);
    }

    #[test]
    fn an_additional_equal_finding_is_new() {
        assert_eq!(new(&["f: a", "f: a"], &["f: a", "f: a", "f: a"]), [false, false, true]);
    }

    #[test]
    fn findings_with_the_same_message_are_matched_first() {
        assert_eq!(new(&["f: a: z is there"], &["f: a: y is there", "f: a: z is there"]), [true, false]);
        assert_eq!(new(&["f: a: 14 branches"], &["f: a: 15 branches"]), [false]);
    }

    #[test]
    fn a_renamed_file_keeps_its_known_findings() {
        assert_eq!(new(&["old/p: a: in p", "old/p: b"], &["old/q: a: in q", "old/q: c"]), [false, true]);
        assert_eq!(new(&["old/p: a", "f: a"], &["f: a", "old/q: a", "old/r: a"]), [false, false, true]);
    }

    #[test]
    fn a_renamed_folder_keeps_its_known_findings() {
        assert_eq!(new(&["old/p: a: it"], &["f: a: that", "new/p: a: it"]), [true, false]);
        assert_eq!(new(&["old/p: a: it"], &["new/p: a: that"]), [true]);
    }

    #[test]
    fn fixed_findings_are_returned() {
        let known = baseline(&["f: a", "f: a", "f: b"]);
        assert_eq!(known.compare(&[found("f: a")], |_| false).gone, baseline(&["f: a", "f: b"]));
    }
}
