//! Reactions of the cell: the tables `[[when]]` of a script.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::Deserialize;
use val3_lang::ports::Time;

use super::comparison::{Comparison, LevelComparison};
use super::condition::{Condition, ConditionTable, NamedStates};
use super::entry::{Pending, ScriptEntry, ScriptPlace};
use super::sent::SentText;
use super::values::OccurrenceLimit;

/// A `[[when]]`.
#[derive(Debug, PartialEq, Deserialize)]
#[serde(try_from = "ReactionTable")]
pub struct ReactionRule {
    /// Without parts if the reaction depends only on the sent text.
    condition: Condition,
    sent: Option<SentText>,
    then: Vec<DelayedEntry>,
    times: Option<OccurrenceLimit>,
}

/// Content of a rule in a file.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ReactionTable {
    #[serde(default)]
    io: BTreeMap<String, LevelComparison>,
    #[serde(default)]
    data: BTreeMap<String, Comparison>,
    #[serde(default)]
    seen: NamedStates,
    #[serde(default)]
    held: NamedStates,
    sent: Option<SentText>,
    then: Vec<DelayedEntry>,
    times: Option<OccurrenceLimit>,
}

impl TryFrom<ReactionTable> for ReactionRule {
    type Error = String;

    fn try_from(ReactionTable { io, data, seen, held, sent, then, times }: ReactionTable) -> Result<Self, String> {
        if then.is_empty() {
            return Err(
                "`then` is empty: write the entries that happen, such as { after = 0.5, key = \"F1\" }".to_owned()
            );
        }
        let is_of_cell_alone = seen.is_empty() && held.is_empty();
        let is_sent_alone = sent.is_some() && io.is_empty() && data.is_empty() && is_of_cell_alone;
        let table = ConditionTable { io, data, seen, held };
        let condition = if is_sent_alone { Condition::default() } else { table.try_into()? };
        Ok(Self { condition, sent, then, times })
    }
}

/// An entry of `then`.
#[derive(Debug, PartialEq, Deserialize)]
#[serde(try_from = "ScriptEntry")]
struct DelayedEntry {
    delay: Time,
    entry: Arc<ScriptEntry>,
}

impl TryFrom<ScriptEntry> for DelayedEntry {
    type Error = &'static str;

    fn try_from(entry: ScriptEntry) -> Result<Self, Self::Error> {
        match (entry.t, entry.after) {
            (None, after) => Ok(Self { delay: after.map_or(0, |after| after.time()), entry: Arc::new(entry) }),
            (Some(_), _) => {
                Err("a reaction has no time of its own: write `after`, in seconds since its condition holds")
            }
        }
    }
}

/// A rule and its state.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reaction {
    rule: Arc<ReactionRule>,
    /// Line in the file.
    line: usize,
    /// Whether the condition was true at the last evaluation.
    held: bool,
    /// Number of occurrences.
    count: u64,
}

impl Reaction {
    pub(super) fn new(line: usize, rule: ReactionRule) -> Self {
        Self { rule: Arc::new(rule), line, held: false, count: 0 }
    }

    pub(super) fn place(&self) -> ScriptPlace {
        ScriptPlace::When(self.line)
    }

    pub(super) fn condition(&self) -> &Condition {
        &self.rule.condition
    }

    /// The text that a task has to send.
    pub(super) fn sent(&self) -> Option<&SentText> {
        self.rule.sent.as_ref()
    }

    pub(super) fn entries(&self) -> impl Iterator<Item = &ScriptEntry> {
        self.rule.then.iter().map(|delayed| delayed.entry.as_ref())
    }

    /// Entries, if the reaction occurs now.
    pub(super) fn pending(&self, now: Time) -> impl Iterator<Item = Pending> {
        self.rule.then.iter().map(move |DelayedEntry { delay, entry }| Pending {
            time: now.saturating_add(*delay),
            place: self.place(),
            entry: Arc::clone(entry),
        })
    }

    /// Updates the current value of the condition. Returns whether the reaction occurs now.
    pub(super) fn happens(&mut self, holds: bool) -> bool {
        let held = std::mem::replace(&mut self.held, holds);
        // Each text is a separate event.
        let begins = !held || self.rule.sent.is_some();
        let happens = holds && begins && self.rule.times.is_none_or(|times| self.count < times.number());
        self.count += u64::from(happens);
        happens
    }
}
