//! Event at which each production cycle begins, for reports of cycle times.

use std::fmt;

use serde::Deserialize;
use val3_lang::ports::Time;
use val3_machine::controller::Controller;
use val3_machine::event::Event;

use super::edge::Edge;
use super::fit::Fit;
use super::occurrence::{CycleState, Occurrence};

/// Event at which each cycle begins, in the form of `expect.within`: `move = "pick"`, `io = { valve1 = true }`.
#[derive(Debug)]
pub struct CycleEvent(Edge);

/// The event as a value, which may be a table in braces.
#[derive(Deserialize)]
struct Wrapped {
    event: Occurrence,
}

impl CycleEvent {
    /// Parses an event. Braces around it are optional.
    ///
    /// # Errors
    /// The reason why the text is no event, in a line.
    pub fn parse(text: &str) -> Result<Self, String> {
        let table = if text.trim_start().starts_with('{') { text.to_owned() } else { format!("{{ {text} }}") };
        let wrapped: Wrapped =
            toml::from_str(&format!("event = {table}")).map_err(|error| error.message().to_owned())?;
        Ok(Self(Edge::new(Some(wrapped.event))))
    }

    /// Names that do not exist in the application. `is_resized` returns whether a data item changes its size.
    pub fn faults(&self, controller: &Controller, is_resized: &dyn Fn(&str) -> bool) -> Vec<String> {
        let fit = Fit { controller, is_resized, until: None };
        let faults = self.0.occurrence().map(|occurrence| occurrence.faults(&fit, &(0..0))).unwrap_or_default();
        faults.into_iter().map(|(_, fault)| fault).collect()
    }

    /// Time at which a production cycle begins in a cycle of the controller that began at `start`, in seconds.
    pub fn begins(&mut self, start: Time, events: &[Event], controller: &Controller) -> Option<f64> {
        self.0.rises(CycleState { start, events, controller })
    }
}

/// Formats the event as a clause.
impl fmt::Display for CycleEvent {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.occurrence().map_or(Ok(()), |occurrence| occurrence.fmt(f))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn braces_around_an_event_are_optional() {
        let shown = |text: &str| CycleEvent::parse(text).unwrap().to_string();
        assert_eq!(shown("move = 'pick:12'"), "a move of `pick` in line 12 starts");
        assert_eq!(shown(r#"{ move = "pick" }"#), "a move of `pick` starts");
    }

    #[test]
    fn a_text_that_is_no_event_is_rejected() {
        for text in ["pick", "move = 3", "mve = 'pick'", "move = 'pick', io = { a = true }", "move = 'pick:x'", ""] {
            assert!(CycleEvent::parse(text).is_err(), "{text}");
        }
    }
}
