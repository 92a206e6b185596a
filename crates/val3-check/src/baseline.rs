//! Findings that are known and not reported: those of the day when the check was introduced.
//!
//! A finding is known by its [`Fingerprint`] and by how many such findings there are. So it stays known when lines
//! move, and becomes new when its line is edited: who touches a line, mends it.

use std::collections::BTreeMap;

use rustc_hash::FxHashMap;
use serde::{Deserialize, Serialize};

use crate::fingerprint::Fingerprint;

/// The form of the file that this version reads and writes.
const VERSION: u32 = 1;

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

    /// Holds `found` against what is known: first what is the same in every part; then what says something else about
    /// the same line, because the tool or code elsewhere changed. Where `is_gone` says that a known file is no longer
    /// there, it was renamed: the same may be said in any other file, and something else about the same line (as that
    /// names the program) in a file of the same folder.
    pub fn judge(&self, found: &[Fingerprint], is_gone: impl Fn(&str) -> bool) -> Verdict {
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

    /// Takes out, of what `may_be` allows, one for each new finding of the same `key`, which is then not new.
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

    /// Drops the entries for which `keep` does not hold.
    pub fn retain(&mut self, mut keep: impl FnMut(&Fingerprint) -> bool) {
        self.0.retain(|fingerprint, _| keep(fingerprint));
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

    /// `file: line: message`, of which the last two may be left out.
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
        baseline(known).judge(&now, |file| file == "old/p").new
    }

    #[test]
    fn what_is_known_is_not_new_wherever_it_stands() {
        assert_eq!(new(&["f: a", "f: b"], &["f: b", "f: a"]), [false, false]);
        assert_eq!(new(&["f: a"], &["f: a", "f: b"]), [false, true]);
        assert_eq!(new(&["f: a"], &["g: a"]), [true]);
    }

    #[test]
    fn one_more_of_the_same_is_new() {
        assert_eq!(new(&["f: a", "f: a"], &["f: a", "f: a", "f: a"]), [false, false, true]);
    }

    #[test]
    fn what_says_the_same_is_known_first() {
        assert_eq!(new(&["f: a: z is there"], &["f: a: y is there", "f: a: z is there"]), [true, false]);
        assert_eq!(new(&["f: a: 14 branches"], &["f: a: 15 branches"]), [false]);
    }

    #[test]
    fn a_file_may_get_another_name() {
        assert_eq!(new(&["old/p: a: in p", "old/p: b"], &["old/q: a: in q", "old/q: c"]), [false, true]);
        assert_eq!(new(&["old/p: a", "f: a"], &["f: a", "old/q: a", "old/r: a"]), [false, false, true]);
    }

    #[test]
    fn a_folder_may_get_another_name() {
        assert_eq!(new(&["old/p: a: it"], &["f: a: that", "new/p: a: it"]), [true, false]);
        assert_eq!(new(&["old/p: a: it"], &["new/p: a: that"]), [true]);
    }

    #[test]
    fn what_is_gone() {
        let known = baseline(&["f: a", "f: a", "f: b"]);
        assert_eq!(known.judge(&[found("f: a")], |_| false).gone, baseline(&["f: a", "f: b"]));
    }
}
