//! Events that repeat in a run: candidates for the beginning of a cycle.

use std::collections::{BTreeMap, BTreeSet};

use val3_machine::event::{Event, EventKind};

/// Maximum number of events in the list.
const SHOWN: usize = 12;

/// Maximum number of different events that are counted, so that a long run needs little memory.
const MAX_EVENTS: usize = 10_000;

/// Events of a run.
#[derive(Debug, Default)]
pub(super) struct RepeatedEvents {
    /// Occurrences by the text for `--cycles`.
    by_text: BTreeMap<String, Occurrences>,
    /// Texts of signals that are not digital, because they have had another value than 0 and 1.
    not_digital: BTreeSet<String>,
}

/// Occurrences of an event, in seconds.
#[derive(Debug, Clone, Copy)]
struct Occurrences {
    count: u32,
    first: f64,
    last: f64,
    /// Shortest and longest period.
    min: f64,
    max: f64,
}

impl RepeatedEvents {
    /// Counts the start of a move, and the rising edge of a signal.
    pub(super) fn see(&mut self, event: &Event) {
        let text = match &event.kind {
            // A move of a client has no program.
            EventKind::Move { phase: "started", program, line, .. } if !program.is_empty() => {
                format!("move = '{program}:{line}'")
            }
            EventKind::Io { link, value } if *value != 0.0 => {
                let text = format!("io = {{ {} = true }}", key(link));
                if (*value - 1.0).abs() > f64::EPSILON {
                    self.not_digital.insert(text);
                    return;
                }
                text
            }
            _ => return,
        };
        let t = event.t;
        if let Some(known) = self.by_text.get_mut(&text) {
            let period = t - known.last;
            (known.count, known.last) = (known.count + 1, t);
            (known.min, known.max) = (known.min.min(period), known.max.max(period));
        } else if self.by_text.len() < MAX_EVENTS {
            self.by_text.insert(text, Occurrences { count: 1, first: t, last: t, min: f64::INFINITY, max: 0.0 });
        }
    }

    /// List for users, in the order of the first occurrences.
    pub(super) fn table(&self) -> String {
        let is_listed = |text: &String, found: &Occurrences| found.count > 1 && !self.not_digital.contains(text);
        let mut repeated: Vec<_> = self.by_text.iter().filter(|(text, found)| is_listed(text, found)).collect();
        repeated.sort_by(|(_, one), (_, other)| one.first.total_cmp(&other.first));
        if repeated.is_empty() {
            return "no move and no signal repeats in this run\n".to_owned();
        }
        let mut table = "events that repeat; --cycles=EVENT measures the cycles of one of them\n".to_owned();
        table += "     count        min       mean        max\n";
        for (text, Occurrences { count, first, last, min, max }) in repeated.iter().take(SHOWN) {
            let mean = (last - first) / f64::from(count - 1);
            table += &format!("  {count:>8} {min:>8.3} s {mean:>8.3} s {max:>8.3} s  {text}\n");
        }
        if repeated.len() > SHOWN {
            table += &format!("  and {} more\n", repeated.len() - SHOWN);
        }
        table
    }
}

/// Writes a link as a key of TOML, without quotes that a shell would interpret.
fn key(link: &str) -> String {
    let is_bare = |character: char| character.is_ascii_alphanumeric() || matches!(character, '_' | '-');
    if !link.is_empty() && link.chars().all(is_bare) { link.to_owned() } else { format!("'{link}'") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_quoted_if_necessary() {
        assert_eq!(key("valve1"), "valve1");
        assert_eq!(key(r"BasicIO-1\%Q0"), r"'BasicIO-1\%Q0'");
    }
}
