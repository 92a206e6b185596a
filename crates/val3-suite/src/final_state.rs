//! Final state of a test: outputs, variables, the screen, texts, the arm. The states of two runs can be compared.

use std::fmt;

use val3_bytecode::Image;
use val3_debug::subscript;
use val3_lang::memory::{StoreId, View};
use val3_machine::controller::Controller;
use val3_machine::event::{EventKind, shown_seconds};

use crate::expect::shown_page;
use crate::journal::RepeatedEvent;
use crate::library::NAME;
use crate::result::TestResult;

/// Observable values at the end of a test, in an order that does not depend on the values.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FinalState {
    /// Names and texts of the values.
    values: Vec<(String, String)>,
}

/// A value that differs between two runs of a test.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// Name of the variable, signal or output.
    pub name: String,
    /// Value in this run; `None` if it does not exist.
    pub value: Option<String>,
    /// Value in the other run; `None` if it does not exist.
    pub instead_of: Option<String>,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let shown = |value: &Option<String>| value.clone().unwrap_or_else(|| "missing".to_owned());
        write!(f, "{} is {} instead of {}", self.name, shown(&self.value), shown(&self.instead_of))
    }
}

impl FinalState {
    /// Reads the state of a controller after a test with this result.
    #[must_use]
    pub fn of(controller: &Controller, result: &TestResult) -> Self {
        let mut values = signals(controller);
        for (_, instance) in controller.vm.space.loaded().filter(|(_, instance)| instance.image.name != NAME) {
            variables(controller, &instance.image, &instance.data, &mut values);
        }
        if let Some(page) = shown_page(controller) {
            values.push(("the title of the screen".to_owned(), quoted(page.title())));
            // Counted as by `gotoxy`.
            let rows = page.lines().zip(0u32..);
            values.extend(rows.map(|(text, row)| (format!("row {row} of the screen"), quoted(&text))));
        }
        let prints = result.prints.iter().zip(1u32..);
        values.extend(prints.map(|(text, number)| (format!("printed line {number}"), quoted(text))));
        values.extend(texts(result));
        let sample = controller.arm().sample();
        let axes = controller.arm().model().axes();
        let joints = sample.joints.iter().take(axes).zip(1u32..);
        values.extend(joints.map(|(joint, axis)| (format!("joint {axis} of the arm"), format!("{joint:.3}"))));
        values.push(("the time of the test".to_owned(), format!("{} s", shown_seconds(result.duration))));
        Self { values }
    }

    /// State without an element such as `pal:nCount` or `pal:nList[1]`.
    #[must_use]
    pub fn without(&self, element: &str) -> Self {
        Self { values: self.values.iter().filter(|(name, _)| name != element).cloned().collect() }
    }

    /// First value that differs from another run.
    #[must_use]
    pub fn first_difference(&self, other: &Self) -> Option<Difference> {
        let same = self.values.iter().zip(&other.values).take_while(|(one, other)| one == other).count();
        let (mine, theirs) = (self.values.get(same), other.values.get(same));
        let name = mine.or(theirs).map(|(name, _)| name.clone())?;
        // A value that exists only in the other run comes first if the remaining values follow it under the same names.
        let name = match theirs {
            Some((known, _)) if self.value(known).is_none() => known.clone(),
            _ => name,
        };
        Some(Difference { value: self.value(&name), instead_of: other.value(&name), name })
    }

    fn value(&self, name: &str) -> Option<String> {
        self.values.iter().find(|(known, _)| known == name).map(|(_, value)| value.clone())
    }
}

/// Last lines of the event log, and last messages.
fn texts(result: &TestResult) -> impl Iterator<Item = (String, String)> {
    let (mut lines, mut messages) = (0, 0);
    result.events.iter().filter_map(move |RepeatedEvent { event, count, .. }| {
        let (what, number, text) = match &event.kind {
            EventKind::Log { text, .. } => ("log line", &mut lines, text),
            EventKind::Popup { text } => ("message", &mut messages, text),
            _ => return None,
        };
        *number += 1;
        let times = if *count > 1 { format!(", {count} times") } else { String::new() };
        Some((format!("{what} {number}"), format!("{}{times}", quoted(text))))
    })
}

/// Values of all inputs and outputs, as programs read them.
fn signals(controller: &Controller) -> Vec<(String, String)> {
    let io = &controller.devices.state.io;
    let of = |id| Some((io.signal(id)?.path.clone(), io.image(id)?.to_string()));
    io.signals().filter_map(of).collect()
}

/// Global variables in an application or library, without variables that have no value.
fn variables(controller: &Controller, image: &Image, data: &[StoreId], values: &mut Vec<(String, String)>) {
    let memory = &controller.vm.space.memory;
    for (data, id) in image.data.iter().zip(data) {
        let Ok(store) = memory.store(*id) else { continue };
        for number in store.shape.numbers() {
            let place = memory.element(View::whole(*id), number);
            let shown = place.and_then(|place| memory.shown(&store.kind, place));
            let (Some(subscript), Ok(shown)) = (subscript(&store.shape, number), shown) else { continue };
            if !shown.is_empty() {
                values.push((format!("{}:{}{subscript}", image.name, data.name), shown));
            }
        }
    }
}

fn quoted(text: &str) -> String {
    format!("\"{}\"", text.trim_end())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(values: &[(&str, &str)]) -> FinalState {
        let owned = |(name, value): &(&str, &str)| ((*name).to_owned(), (*value).to_owned());
        FinalState { values: values.iter().map(owned).collect() }
    }

    #[test]
    fn an_element_is_left_out() {
        let all = state(&[("a:n[0]", "1"), ("a:n[1]", "2"), ("b:n[0]", "4")]);
        assert_eq!(all.without("a:n[0]"), state(&[("a:n[1]", "2"), ("b:n[0]", "4")]));
    }

    #[test]
    fn the_first_difference_is_named() {
        let one = state(&[("a:n", "1"), ("a:s[0]", "2"), ("a:s[1]", "3"), ("t", "4")]);
        let of = |values: &[(&str, &str)]| state(values).first_difference(&one).map(|found| found.to_string());
        assert_eq!(one.first_difference(&one), None);
        let changed = of(&[("a:n", "1"), ("a:s[0]", "7"), ("a:s[1]", "8"), ("t", "4")]);
        assert_eq!(changed.as_deref(), Some("a:s[0] is 7 instead of 2"));
        let missing = of(&[("a:n", "1"), ("a:s[0]", "2"), ("t", "4")]);
        assert_eq!(missing.as_deref(), Some("a:s[1] is missing instead of 3"));
        let added = of(&[("a:n", "1"), ("a:s[0]", "2"), ("a:s[1]", "3"), ("a:s[2]", "5"), ("t", "4")]);
        assert_eq!(added.as_deref(), Some("a:s[2] is 5 instead of missing"));
    }
}
