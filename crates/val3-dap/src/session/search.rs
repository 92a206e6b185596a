//! Searches in the history, which report progress and can be cancelled.

use std::ops::ControlFlow;

use val3_debug::{DataWrites, Goal, WatchedData, WriteLimits};

use super::DebugSession;
use crate::client::Client;
use crate::debugged_run::DebuggedRun;
use crate::failure::RequestFailure;
use crate::protocol::{ProgressEndEvent, ProgressStartEvent, ProgressUpdateEvent, StandardEvent};
use crate::stop_event;

/// Number of replayed cycles before progress is reported: some tenths of a second.
const LONG: u32 = 2_000;

/// Number of replayed cycles between two checks for a cancellation.
const LOOK: u32 = 50;

impl DebugSession {
    /// Searches the history backwards, and restores the found moment. The response was already sent, because a search
    /// may take longer than the timeout of clients.
    pub(crate) fn go_back(&mut self, goal: Goal, run: &mut DebuggedRun<'_>) {
        let mut search = ReverseSearch::new("Going back in the run", self);
        let client = &mut self.client;
        let stop = run.debugger.search_back(goal, &mut |part| search.pass(part, client));
        search.end(client);
        let controller = &mut run.debugger.controller;
        let event = match stop {
            Some(stop) => stop_event::stopped(&stop, controller),
            None => stop_event::cancelled(controller),
        };
        self.report_hits(run);
        self.stopped_elsewhere(event);
    }

    /// Searches the history for the last writes of data, at most `count`. The run stays at its moment.
    ///
    /// # Errors
    /// The run is not recorded, or the client cancels the request.
    pub(crate) fn search_writes(
        &mut self,
        data: &WatchedData,
        count: usize,
        run: &mut DebuggedRun<'_>,
    ) -> Result<DataWrites, RequestFailure> {
        run.debugger.reach().ok_or(RequestFailure::NotRecorded)?;
        let mut search = ReverseSearch::new("Searching the history of the value", self);
        let client = &mut self.client;
        let writes = run.debugger.writes(data, WriteLimits::writes(count), &mut |part| search.pass(part, client));
        search.end(client);
        writes.ok_or(RequestFailure::Cancelled)
    }

    /// Searches the history for the last writes of data, without a report of progress. Returns `None` if the run is not
    /// recorded, or if the client cancels the request.
    pub(crate) fn quick_writes(
        &mut self,
        data: &WatchedData,
        limits: WriteLimits,
        run: &mut DebuggedRun<'_>,
    ) -> Option<DataWrites> {
        let (client, request, mut lines) = (&mut self.client, self.request, 0);
        run.debugger.writes(data, limits, &mut |_| {
            lines += 1;
            let is_cancelled = u32::is_multiple_of(lines, LOOK) && client.has_cancelled(request, "");
            if is_cancelled { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        })
    }
}

/// A search in the history that a client has requested.
struct ReverseSearch {
    /// Title of the progress.
    title: &'static str,
    request: i64,
    /// Progress id.
    id: String,
    shows_progress: bool,
    cycles: u32,
    /// Last reported progress, in %.
    seen: Option<f64>,
}

impl ReverseSearch {
    fn new(title: &'static str, session: &DebugSession) -> Self {
        let (request, shows_progress) = (session.request, session.conventions.knows_progress);
        Self { title, request, id: format!("search {request}"), shows_progress, cycles: 0, seen: None }
    }

    /// Counts a replayed cycle, reports progress, and breaks if the client has cancelled. `part` is the searched part
    /// of the history, from 0 to 1.
    fn pass(&mut self, part: f64, client: &mut Client) -> ControlFlow<()> {
        self.cycles += 1;
        if self.cycles.is_multiple_of(LOOK) && client.has_cancelled(self.request, &self.id) {
            return ControlFlow::Break(());
        }
        if self.shows_progress && self.cycles >= LONG {
            self.show((part * 100.0).floor(), client);
        }
        ControlFlow::Continue(())
    }

    fn show(&mut self, percentage: f64, client: &mut Client) {
        match self.seen {
            None => client.event(&StandardEvent::ProgressStart(ProgressStartEvent {
                progress_id: self.id.clone(),
                title: self.title.to_owned(),
                cancellable: Some(true),
                percentage: Some(percentage),
                request_id: i32::try_from(self.request).ok(),
                ..ProgressStartEvent::default()
            })),
            Some(seen) if percentage > seen => client.event(&StandardEvent::ProgressUpdate(ProgressUpdateEvent {
                progress_id: self.id.clone(),
                percentage: Some(percentage),
                ..ProgressUpdateEvent::default()
            })),
            Some(_) => return,
        }
        self.seen = Some(percentage);
    }

    fn end(self, client: &mut Client) {
        if self.seen.is_some() {
            let (progress_id, message) = (self.id, None);
            client.event(&StandardEvent::ProgressEnd(ProgressEndEvent { progress_id, message }));
        }
    }
}
