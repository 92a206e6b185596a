//! Cycle times of a run (`--cycles`): the periods of an event, and the shares of moving and waiting in them.

mod comparison;
mod repeated;
mod report;

use val3_lang::ports::Time;
use val3_machine::controller::{Controller, WaitCause};
use val3_machine::event::{Event, EventKind};
use val3_motion::MotionPhase;
use val3_suite::CycleEvent;
use val3_vm::CYCLE;

use crate::args::RunArgs;
use crate::user_error::UserError;
use comparison::EarlierCycles;
use repeated::RepeatedEvents;
pub(super) use report::CyclesReport;
use report::{CycleRow, Parts};

/// Cycles of a run.
pub(super) struct Cycles {
    /// Event at which each cycle begins; `None` if the run only lists the events that repeat.
    event: Option<NamedEvent>,
    /// Cycles of an earlier run.
    earlier: Option<EarlierCycles>,
    repeated: RepeatedEvents,
    /// Beginning of the current cycle, in seconds.
    begun: Option<f64>,
    /// Times in the current cycle.
    parts: Parts,
    complete: Vec<CycleRow>,
    /// Name of the task that has recorded the last move.
    mover: Option<String>,
    last: Time,
    /// Activity at the end of the last observed cycle of the controller.
    before: Part,
}

/// Event as the user has written it.
struct NamedEvent {
    text: String,
    event: CycleEvent,
}

/// Part of a cycle time: what the arm does, or while it rests, the task that moves it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Part {
    Moving,
    Waiting(WaitCause),
    Other,
}

impl Cycles {
    /// Opens the report that `--cycles` or `--against` requests; `None` without them.
    ///
    /// # Errors
    /// The event or the earlier file is invalid.
    pub(super) fn open(args: &RunArgs, controller: &Controller) -> Result<Option<Self>, UserError> {
        if args.cycles.is_none() && args.against.is_none() {
            return Ok(None);
        }
        let earlier = args.against.as_deref().map(EarlierCycles::open).transpose()?;
        let named = args.cycles.clone().flatten();
        let text = named.or_else(|| earlier.as_ref().map(|earlier| earlier.event().to_owned()));
        let event = text.map(|text| NamedEvent::open(text, controller)).transpose()?;
        Ok(Some(Self {
            event,
            earlier,
            repeated: RepeatedEvents::default(),
            begun: None,
            parts: Parts::default(),
            complete: Vec::new(),
            mover: None,
            last: 0,
            before: Part::Other,
        }))
    }

    /// Adds the time since the last call. The part of the last cycle of the controller belongs to that cycle.
    pub(super) fn see(&mut self, start: Time, controller: &Controller) {
        let passed = start.saturating_sub(self.last);
        self.last = start;
        let part = self.part(controller);
        let own = passed.min(CYCLE);
        let before = std::mem::replace(&mut self.before, part);
        self.parts.add(part, own);
        self.parts.add(before, passed - own);
    }

    /// Follows the events of a cycle of the controller, which began at `start`.
    pub(super) fn follow(&mut self, start: Time, events: &[Event], controller: &Controller) {
        for event in events {
            if let EventKind::Move { phase: "recorded", .. } = event.kind {
                self.mover.clone_from(&event.task);
            }
            self.repeated.see(event);
        }
        let begins = self.event.as_mut().and_then(|named| named.event.begins(start, events, controller));
        let Some(begins) = begins else { return };
        let parts = std::mem::take(&mut self.parts);
        if let Some(from) = self.begun.replace(begins) {
            self.complete.push(CycleRow::new(from, begins, parts));
        }
    }

    fn part(&self, controller: &Controller) -> Part {
        if controller.arm().sample().phase != MotionPhase::Waiting {
            return Part::Moving;
        }
        let tasks = controller.task_positions();
        let mover = tasks.iter().find(|task| Some(&task.name) == self.mover.as_ref());
        mover.and_then(|task| task.activity.wait_cause()).map_or(Part::Other, Part::Waiting)
    }

    /// Report of the complete cycles; `None` without an event. Also returns the text for users.
    pub(super) fn close(self) -> (Option<CyclesReport>, String) {
        let Some(NamedEvent { text, event }) = self.event else { return (None, self.repeated.table()) };
        let report = CyclesReport::new(text, self.complete);
        if report.count() == 0 {
            let reason = match self.begun {
                None => format!("it never happens that {event}"),
                Some(begun) => format!("it happens only once, at {begun:.3} s, that {event}"),
            };
            let note = format!("note: there is no complete cycle, because {reason}\n");
            return (Some(report), note + &self.repeated.table());
        }
        let table = match &self.earlier {
            None => report.table(),
            Some(earlier) => comparison::table(&report, earlier),
        };
        (Some(report), table)
    }
}

impl NamedEvent {
    fn open(text: String, controller: &Controller) -> Result<Self, UserError> {
        let event = CycleEvent::parse(&text).map_err(|reason| no_event(&text, &reason))?;
        // A library may be loaded during the run, and a variable may change its size.
        let faults = event.faults(controller, &|_| true);
        match faults.first() {
            Some(fault) => Err(no_event(&text, fault)),
            None => Ok(Self { text, event }),
        }
    }
}

/// Error for a text that names no event of the controller.
fn no_event(text: &str, reason: &str) -> UserError {
    UserError::new(format!("`{text}` is no event of a cycle: {reason}"))
        .with_help("write an event as in `[[expect.within]]`: --cycles=\"move = 'pick:12'\"; --cycles lists the events that repeat")
}
