//! The subscriptions of a client: samples of the arm, changes of inputs and outputs, the user page.

use std::collections::VecDeque;

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::{Value, json};
use val3_lang::ports::{Time, nanoseconds};
use val3_machine::controller::Controller;
use val3_machine::event::{Event, EventKind, seconds};
use val3_view::wire::{self, Role, UnsavedMessage};
use val3_view::{Feed, Operator, ViewerMessage};
use val3_vm::CYCLE;

use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::moves::ArmSample;
use crate::user_page::ShownUserPage;

/// Largest number of faults that a page shows from the time before it was opened.
const FAULTS: usize = 100;

/// Duration of a batch.
const BATCH: Time = 25 * CYCLE;

/// Subscriptions of a client; initially none.
#[derive(Debug, Default)]
pub(crate) struct Subscriptions {
    /// Shortest time between two samples of the arm; `None` without a subscription.
    motion: Option<Time>,
    has_io: bool,
    has_user_page: bool,
    /// Messages for a page that shows the run.
    view: Option<Feed>,
    /// Latest faults, which a page shows that is opened after them.
    faults: VecDeque<Event>,
    /// Operator at this page.
    pub(crate) operator: Operator,
    /// Latest message `unsaved`.
    unsaved: Option<UnsavedMessage>,
    /// Whether the run is stopped, in the latest message `clock`.
    is_stopped: Option<bool>,
    samples: Vec<ArmSample>,
    /// Time of the first sample in the current batch.
    begun: Time,
    last: Option<Time>,
    /// Last sample of the arm.
    arm: Option<ArmSample>,
}

/// Changed subscriptions. Omitted properties are unchanged.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "camelCase", deny_unknown_fields)]
pub(crate) struct SubscribeArguments {
    /// Samples of the arm.
    motion: Option<MotionSampling>,
    /// Whether `val3/io` is sent.
    io: Option<bool>,
    /// Whether `val3/userPage` is sent.
    user_page: Option<bool>,
    /// Whether `val3/view` is sent.
    view: Option<bool>,
}

/// Whether the arm is sampled in each cycle, or the seconds between samples (0 to 3600).
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(untagged)]
enum MotionSampling {
    /// In each cycle, or never.
    Enabled(bool),
    /// Seconds between two samples.
    Interval(f64),
}

impl Subscriptions {
    /// Changes the subscriptions.
    ///
    /// # Errors
    /// The interval between samples is not in the range.
    pub(crate) fn subscribe(
        &mut self,
        arguments: &SubscribeArguments,
        run: &DebuggedRun<'_>,
    ) -> Result<(), RequestFailure> {
        let SubscribeArguments { motion, io, user_page, view } = *arguments;
        self.motion = motion.map_or(Ok(self.motion), MotionSampling::interval)?;
        self.has_io = io.unwrap_or(self.has_io);
        self.has_user_page = user_page.unwrap_or(self.has_user_page);
        if let Some(is_shown) = view {
            self.view = is_shown.then(|| self.new_feed(run));
            (self.unsaved, self.is_stopped) = (None, None);
        }
        Ok(())
    }

    /// Samples the arm at the end of a cycle that began at `start`. Returns the batch of samples when it is complete.
    /// An arm at rest is sampled once.
    pub(crate) fn see(&mut self, start: Time, controller: &Controller) -> Option<Value> {
        let interval = self.motion?;
        if self.last.is_some_and(|last| start < last + interval) {
            return None;
        }
        self.last = Some(start);
        let arm = ArmSample::new(seconds(start), controller);
        if !self.arm.as_ref().is_some_and(|last| arm.is_same_motion(last)) {
            self.arm = Some(arm.clone());
            if self.samples.is_empty() {
                self.begun = start;
            }
            self.samples.push(arm);
        }
        if start + interval < self.begun + BATCH { None } else { self.flush() }
    }

    /// Returns the samples of an incomplete batch.
    pub(crate) fn flush(&mut self) -> Option<Value> {
        let samples = std::mem::take(&mut self.samples);
        (!samples.is_empty()).then(|| json!({ "samples": samples }))
    }

    /// Returns the messages for a page after a cycle that began at `start`.
    pub(crate) fn view(&mut self, start: Time, controller: &Controller) -> Option<Value> {
        let feed = self.view.as_mut()?;
        feed.see(start, &[], controller);
        messages(feed)
    }

    /// Returns the messages for a page after a request or at a stop.
    pub(crate) fn refreshed_view(&mut self, is_stopped: bool, controller: &Controller) -> Option<Value> {
        let feed = self.view.as_mut()?;
        feed.refresh(controller);
        if self.is_stopped.replace(is_stopped) != Some(is_stopped) {
            // The debugger changes no speed, and pages of debugged runs show none.
            let (t, speed) = (seconds(controller.now()), wire::PaceSpeed::Times(1.0));
            feed.tell(&wire::Message::Clock(wire::Clock { t, speed, is_paused: false, is_stopped }));
        }
        let unsaved = self.operator.unsaved();
        if self.unsaved.as_ref() != Some(&unsaved) {
            feed.tell(&wire::Message::Unsaved(unsaved.clone()));
            self.unsaved = Some(unsaved);
        }
        messages(feed)
    }

    /// Returns the messages for a page that is opened now: the present state, and the faults so far.
    fn new_feed(&self, run: &DebuggedRun<'_>) -> Feed {
        let controller = &run.debugger.controller;
        let mut feed = Feed::new(controller, Role::Debugger, run.files);
        let now = seconds(controller.now());
        let faults: Vec<Event> = self.faults.iter().filter(|fault| fault.t <= now).cloned().collect();
        feed.see_events(&faults, controller);
        feed
    }

    /// Discards the faults after the present time, because the run continues in another way.
    pub(crate) fn begin_new_future(&mut self, controller: &Controller) {
        let now = seconds(controller.now());
        self.faults.retain(|fault| fault.t <= now);
    }

    /// Adds events of the run to the messages for the page.
    pub(crate) fn note(&mut self, events: &[Event], controller: &Controller) {
        for fault in events.iter().filter(|event| is_fault(&event.kind)) {
            if !self.faults.contains(fault) {
                self.faults.push_back(fault.clone());
            }
            if self.faults.len() > FAULTS {
                self.faults.pop_front();
            }
        }
        if let Some(feed) = &mut self.view {
            feed.see_events(events, controller);
        }
    }

    /// Returns the subscribed protocol events for these events of the run.
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
        if self.has_user_page && events.iter().any(changes_user_page) {
            changes.push(("val3/userPage", json!(ShownUserPage::new(controller))));
        }
        changes
    }
}

/// Returns the body of the event `val3/view`. Samples are bytes in base64.
fn messages(feed: &mut Feed) -> Option<Value> {
    let messages = feed.take().into_iter().map(|message| match message {
        ViewerMessage::Object(object) => object,
        ViewerMessage::Samples(bytes) => {
            json!(wire::Message::Samples(wire::Samples { base64: BASE64_STANDARD.encode(bytes) }))
        }
    });
    let messages: Vec<Value> = messages.collect();
    (!messages.is_empty()).then(|| json!({ "messages": messages }))
}

/// Whether the page shows an event as a fault.
fn is_fault(kind: &EventKind) -> bool {
    matches!(kind, EventKind::Error { .. } | EventKind::Fault { .. } | EventKind::Lacking { .. })
}

/// Whether an event changes the user page.
fn changes_user_page(event: &Event) -> bool {
    matches!(event.kind, EventKind::Put { .. } | EventKind::Title { .. } | EventKind::Cls { .. })
}

impl MotionSampling {
    /// Returns the shortest time between two samples; `None` if samples are disabled.
    fn interval(self) -> Result<Option<Time>, RequestFailure> {
        match self {
            Self::Enabled(is_enabled) => Ok(is_enabled.then_some(CYCLE)),
            Self::Interval(seconds) if (0.0..=3600.0).contains(&seconds) => Ok(Some(nanoseconds(seconds).max(CYCLE))),
            Self::Interval(_) => Err(RequestFailure::Rejected("`motion` takes true, false or seconds".to_owned())),
        }
    }
}
