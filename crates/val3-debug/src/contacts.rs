//! Contacts of the arm with the things around it, which stop the run.

use std::fmt;

use val3_machine::event::{ClearanceMove, Event, EventKind};

/// Smallest overlap depth that is shown as a number, in mm.
const DEPTH: f64 = 0.05;

/// A contact that has begun.
#[derive(Debug, Clone, PartialEq)]
pub struct Contact {
    /// Names of both things.
    pub names: [String; 2],
    /// Overlap depth in mm; 0 if only the surfaces touch.
    pub depth: f64,
    /// Whether the things touched when the run began.
    pub at_start: bool,
    /// Move that the arm executes.
    pub of: Option<ClearanceMove>,
}

impl Contact {
    /// Returns the contacts whose beginning these events report.
    pub(crate) fn all(events: &[Event]) -> Vec<Self> {
        let contacts = events.iter().filter_map(|event| match &event.kind {
            EventKind::Clearance { state: "contact", a, b, distance, start, of, .. } => Some(Self {
                names: [a.clone(), b.clone()],
                depth: (-distance).max(0.0),
                at_start: *start,
                of: of.clone(),
            }),
            _ => None,
        });
        contacts.collect()
    }
}

impl fmt::Display for Contact {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { names: [a, b], depth, at_start, of } = self;
        match *depth {
            depth if depth > DEPTH => write!(f, "`{a}` overlaps `{b}` by {depth:.1} mm")?,
            _ => write!(f, "`{a}` touches `{b}`")?,
        }
        match of {
            _ if *at_start => write!(f, " at the start of the run"),
            Some(ClearanceMove { id, instruction, program, line, .. }) => {
                write!(f, " in move {id} ({instruction}, {program}() line {line})")
            }
            None => Ok(()),
        }
    }
}
