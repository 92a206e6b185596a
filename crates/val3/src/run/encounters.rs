//! Contacts and near misses of a run, collected from its events and reported at its end.

use std::collections::BTreeSet;

use val3_cell::TOUCHING;
use val3_machine::event::{ClearanceMove, Event, EventKind};

/// Smallest overlap depth that is shown as a number, in mm.
const DEPTH: f64 = 0.05;

/// Encounters of a run: contacts, and near misses without a contact.
#[derive(Debug, Default)]
pub(super) struct Encounters {
    /// Pairs that touch at present.
    touching: BTreeSet<[String; 2]>,
    contacts: Vec<Encounter>,
    near: Vec<Encounter>,
}

/// An encounter of two things, at its smallest distance.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Encounter {
    names: [String; 2],
    /// Smallest distance in mm; negative if the things overlap.
    distance: f64,
    /// Time of the smallest distance, in seconds.
    at: f64,
    /// Whether the things were already too near when the run began.
    at_start: bool,
    pub(super) of: Option<ClearanceMove>,
    /// Number of times that this pair has met at this line.
    count: usize,
}

impl Encounters {
    /// Tracks the encounters in events.
    pub(super) fn follow(&mut self, event: &Event) {
        let EventKind::Clearance { state, a, b, distance, at, start, of, .. } = &event.kind else { return };
        let names = [a.clone(), b.clone()];
        match *state {
            "contact" => drop(self.touching.insert(names)),
            "clear" => {
                let list = if self.touching.remove(&names) { &mut self.contacts } else { &mut self.near };
                let (distance, at, at_start, of) = (*distance, *at, *start, of.clone());
                add(list, Encounter { names, distance, at, at_start, of, count: 1 });
            }
            _ => {}
        }
    }

    /// Whether there was a contact.
    pub(super) fn has_contacts(&self) -> bool {
        !self.touching.is_empty() || !self.contacts.is_empty()
    }

    /// Finished contacts: one for each pair and line, at its greatest depth.
    pub(super) fn contacts(&self) -> &[Encounter] {
        &self.contacts
    }

    /// Describes the near misses; `None` without any.
    pub(super) fn near_misses(&self) -> Option<String> {
        let nearest = self.near.iter().min_by(|one, other| one.distance.total_cmp(&other.distance))?;
        let count = self.near.iter().map(|near| near.count).sum::<usize>();
        let misses = if count == 1 { "1 near miss".to_owned() } else { format!("{count} near misses, the nearest") };
        Some(format!("{misses}: {}", nearest.sentence()))
    }
}

/// Adds an encounter, or counts it if the pair has already met at this line.
fn add(list: &mut Vec<Encounter>, new: Encounter) {
    let is_same = |known: &&mut Encounter| known.names == new.names && known.line() == new.line();
    match list.iter_mut().find(is_same) {
        Some(known) => {
            let count = known.count + 1;
            if new.distance < known.distance {
                *known = new;
            }
            known.count = count;
        }
        None => list.push(new),
    }
}

impl Encounter {
    fn line(&self) -> Option<(&str, u32)> {
        self.of.as_ref().map(|of| (of.file.as_str(), of.line))
    }

    /// Describes the encounter in a sentence.
    pub(super) fn sentence(&self) -> String {
        let Self { names: [a, b], distance, at, at_start, of, count } = self;
        let how = match *distance {
            distance if distance > TOUCHING => format!("`{a}` is {distance:.1} mm from `{b}`"),
            distance if distance < -DEPTH => format!("`{a}` overlaps `{b}` by {:.1} mm", -distance),
            _ => format!("`{a}` touches `{b}`"),
        };
        let when = if *at_start { " at the start of the run".to_owned() } else { format!(" at {at:.3} s") };
        let what = of.as_ref().map(|ClearanceMove { id, instruction, program, line, .. }| {
            format!(", in move {id} ({instruction}, {program}:{line})")
        });
        let often = if *count > 1 { format!(", {count} times") } else { String::new() };
        format!("{how}{when}{}{often}", what.unwrap_or_default())
    }

    /// Remedy for the user.
    pub(super) fn help(&self) -> String {
        let [a, b] = &self.names;
        format!("move one of them, or allow the pair in cell.toml: allow = [[\"{a}\", \"{b}\", \"the reason\"]]")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn event(state: &'static str, distance: f64, line: u32) -> Event {
        let of = ClearanceMove { id: 2.0, instruction: "movel", program: "work".into(), line, file: "work.pgx".into() };
        let kind = EventKind::Clearance {
            state,
            a: "gripper".into(),
            b: "rack".into(),
            distance,
            points: [[0.0; 3]; 2],
            at: 1.5,
            joints: Vec::new(),
            start: false,
            of: Some(of),
        };
        Event { t: 1.6, task: None, at: None, kind }
    }

    #[test]
    fn contacts_of_a_pair_and_a_line_are_one() {
        let mut encounters = Encounters::default();
        for (state, distance, line) in
            [("contact", -0.1, 3), ("clear", -2.0, 3), ("contact", 0.0, 3), ("clear", -3.44, 3), ("contact", 0.0, 4)]
        {
            encounters.follow(&event(state, distance, line));
        }
        assert!(encounters.has_contacts());
        let sentences: Vec<String> = encounters.contacts().iter().map(Encounter::sentence).collect();
        assert_eq!(sentences, ["`gripper` overlaps `rack` by 3.4 mm at 1.500 s, in move 2 (movel, work:3), 2 times"]);
    }

    #[test]
    fn near_misses_are_counted() {
        let mut encounters = Encounters::default();
        for (state, distance, line) in [("near", 9.0, 3), ("clear", 4.0, 3), ("near", 9.0, 5), ("clear", 2.0, 5)] {
            encounters.follow(&event(state, distance, line));
        }
        assert!(!encounters.has_contacts());
        let near = "2 near misses, the nearest: `gripper` is 2.0 mm from `rack` at 1.500 s, in move 2 (movel, work:5)";
        assert_eq!(encounters.near_misses().as_deref(), Some(near));
    }
}
