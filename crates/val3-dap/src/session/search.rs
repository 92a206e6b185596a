//! Searches in the past. The client sees the progress of a long one, and can cancel it.

use std::ops::ControlFlow;

use val3_debug::Goal;

use super::{DebugSession, Refusal, Target, execution};
use crate::client::Client;
use crate::protocol::{Event, ProgressEndEvent, ProgressStartEvent, ProgressUpdateEvent};

/// Cycles of the controller that are executed again before the client sees a progress: some tenths of a second.
const LONG: u32 = 2_000;

/// Cycles between two looks at the messages of the client.
const LOOK: u32 = 50;

impl DebugSession {
    /// Goes back in the run.
    pub(super) fn go_back(&mut self, request: i64, goal: Goal, target: &mut Target<'_>) -> Result<(), Refusal> {
        self.check_stopped()?;
        let mut search = Search::new(request, self.conventions.knows_progress);
        let client = &mut self.client;
        let stop = target.debugger.search_back(goal, &mut |part| search.pass(part, client));
        search.end(client);
        // Clients know this word.
        let stop = stop.ok_or_else(|| "cancelled".to_owned())?;
        self.stopped_elsewhere(execution::stopped(&stop, &mut target.debugger.controller));
        Ok(())
    }
}

/// A search for a client.
struct Search {
    request: i64,
    /// The name of its progress.
    id: String,
    shows_progress: bool,
    cycles: u32,
    /// The per cent that the client has seen.
    seen: Option<f64>,
}

impl Search {
    fn new(request: i64, shows_progress: bool) -> Self {
        Self { request, id: format!("search {request}"), shows_progress, cycles: 0, seen: None }
    }

    /// A cycle was executed again.
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
            None => client.event(&Event::ProgressStart(ProgressStartEvent {
                progress_id: self.id.clone(),
                title: "Going back in the run".to_owned(),
                cancellable: Some(true),
                percentage: Some(percentage),
                request_id: i32::try_from(self.request).ok(),
                ..ProgressStartEvent::default()
            })),
            Some(seen) if percentage > seen => client.event(&Event::ProgressUpdate(ProgressUpdateEvent {
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
            client.event(&Event::ProgressEnd(ProgressEndEvent { progress_id, message }));
        }
    }
}
