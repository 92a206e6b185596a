//! The subscriptions of a client: samples of the arm, changes of inputs and outputs, the user page.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use serde_json::{Map, Value, json};
use val3_lang::ports::{Time, nanoseconds};
use val3_machine::controller::Controller;
use val3_machine::event::{Event, EventKind, seconds};
use val3_view::wire::{self, Role, UnsavedMessage};
use val3_view::{Feed, Message, Operator, user_page};
use val3_vm::CYCLE;

use crate::custom::sample;

/// The time of the samples of a batch.
const BATCH: Time = 25 * CYCLE;

/// The subscriptions of a client; none at first.
#[derive(Debug, Default)]
pub(crate) struct Subscriptions {
    /// The least time between two samples of the arm.
    motion: Option<Time>,
    has_io: bool,
    has_user_page: bool,
    /// The messages of a page that shows the run.
    view: Option<Feed>,
    /// The operator at that page.
    pub(crate) operator: Operator,
    /// Latest message `unsaved`.
    unsaved: Option<UnsavedMessage>,
    samples: Vec<Value>,
    /// When the first of these samples was taken.
    begun: Time,
    last: Option<Time>,
    /// The arm at the last sample.
    arm: Value,
}

impl Subscriptions {
    /// Changes the subscriptions. Properties that are left out keep theirs.
    pub(crate) fn subscribe(
        &mut self,
        arguments: &Map<String, Value>,
        controller: &Controller,
    ) -> Result<Value, String> {
        for (name, value) in arguments {
            let wanted = value.as_bool();
            match name.as_str() {
                "motion" => self.motion = interval(value).ok_or_else(|| refused(name, "true, false or seconds"))?,
                "io" => self.has_io = wanted.ok_or_else(|| refused(name, "true or false"))?,
                "userPage" => self.has_user_page = wanted.ok_or_else(|| refused(name, "true or false"))?,
                "view" => {
                    let is_wanted = wanted.ok_or_else(|| refused(name, "true or false"))?;
                    self.view = is_wanted.then(|| Feed::new(controller, Role::Debugger));
                    self.unsaved = None;
                }
                _ => return Err(format!("`{name}` cannot be subscribed to: name motion, io, userPage or view")),
            }
        }
        Ok(json!({}))
    }

    /// A cycle that began at `start` is over. Gives the samples of the arm when a batch is full. An arm that rests is
    /// sampled once.
    pub(crate) fn see(&mut self, start: Time, controller: &Controller) -> Option<Value> {
        let interval = self.motion?;
        if self.last.is_some_and(|last| start < last + interval) {
            return None;
        }
        self.last = Some(start);
        let arm = sample(0.0, controller);
        if arm != self.arm {
            self.arm = arm;
            if self.samples.is_empty() {
                self.begun = start;
            }
            self.samples.push(sample(seconds(start), controller));
        }
        if start + interval < self.begun + BATCH { None } else { self.flush() }
    }

    /// The samples that wait for a batch.
    pub(crate) fn flush(&mut self) -> Option<Value> {
        let samples = std::mem::take(&mut self.samples);
        (!samples.is_empty()).then(|| json!({ "samples": samples }))
    }

    /// A cycle that began at `start` is over: the messages for a page.
    pub(crate) fn view(&mut self, start: Time, controller: &Controller) -> Option<Value> {
        let feed = self.view.as_mut()?;
        feed.see(start, &[], controller);
        messages(feed)
    }

    /// The messages for a page after a request or at a stop.
    pub(crate) fn refreshed_view(&mut self, controller: &Controller) -> Option<Value> {
        let feed = self.view.as_mut()?;
        feed.refresh(controller);
        let unsaved = self.operator.unsaved();
        if self.unsaved.as_ref() != Some(&unsaved) {
            feed.tell(&wire::Message::Unsaved(unsaved.clone()));
            self.unsaved = Some(unsaved);
        }
        messages(feed)
    }

    /// Events for the page.
    pub(crate) fn note(&mut self, events: &[Event], controller: &Controller) {
        if let Some(feed) = &mut self.view {
            feed.see_events(events, controller);
        }
    }

    /// The events that follow from those of the run.
    pub(crate) fn changes(&self, events: &[Event], controller: &Controller) -> Vec<(&'static str, Value)> {
        let mut changes = Vec::new();
        let levels: Vec<Value> = events
            .iter()
            .filter_map(|event| match &event.kind {
                EventKind::Io { link, value } => Some(json!({ "t": event.t, "link": link, "value": value })),
                _ => None,
            })
            .collect();
        if self.has_io && !levels.is_empty() {
            changes.push(("val3/io", json!({ "changes": levels })));
        }
        let is_page = |event: &Event| {
            matches!(event.kind, EventKind::Put { .. } | EventKind::Title { .. } | EventKind::Cls { .. })
        };
        if self.has_user_page && events.iter().any(is_page) {
            changes.push(("val3/userPage", user_page(controller)));
        }
        changes
    }
}

/// The body of `val3/view`. Samples are bytes in base 64.
fn messages(feed: &mut Feed) -> Option<Value> {
    let object = |message| match message {
        Message::Object(object) => object,
        Message::Samples(bytes) => {
            json!(wire::Message::Samples(wire::Samples { base64: BASE64_STANDARD.encode(bytes) }))
        }
    };
    let messages: Vec<Value> = feed.take().into_iter().map(object).collect();
    (!messages.is_empty()).then(|| json!({ "messages": messages }))
}

/// The least time between two samples; `None` inside for no samples.
fn interval(value: &Value) -> Option<Option<Time>> {
    match value {
        Value::Bool(wanted) => Some(wanted.then_some(CYCLE)),
        Value::Number(number) => {
            let seconds = number.as_f64().filter(|seconds| (0.0..=3600.0).contains(seconds))?;
            Some(Some(nanoseconds(seconds).max(CYCLE)))
        }
        _ => None,
    }
}

fn refused(name: &str, values: &str) -> String {
    format!("`{name}` takes {values}")
}
