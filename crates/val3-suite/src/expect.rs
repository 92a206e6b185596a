//! `[expect]`: expectations of a test.
//!
//! ```toml
//! [expect]
//! screen = ["Palletiser", "2 boxes"]              # the page that is shown at the end contains these texts
//! io = { "BasicIO-1\\%Q0" = false }               # signals at the end
//! data = { nState = 0, nMean = { is = 2.5, within = 0.1 } }   # global data at the end
//! print = ["done"]                                # a printed line contains it; `log` and `popup` likewise
//! sent = { "Socket\\host" = "ready\n" }           # this went out over a line
//! errors = [{ code = 20, task = "production" }]   # run-time errors; any other is a failure
//!
//! held = { "carton[0]" = false }                  # no gripper of the cell holds the part; `seen` likewise for sensors
//! placed = { "carton[0]" = { in = "fPallet", is = [200, 150, 90], within = 2 } }  # where a part is at the end
//!
//! [[expect.at]]                                   # screen, io, data, seen, held and placed, at a time
//! t = 5
//! screen = ["1 box"]
//!
//! [[expect.within]]                               # something happens within a time
//! event = { io = { "BasicIO-1\\%Q1" = true } }
//! seconds = 2
//! after = { io = { "BasicIO-1\\%I0" = true } }    # else since the start
//!
//! [[expect.order]]                                # each event happens after the one before it
//! events = [{ move = "pick" }, { print = "picked" }, { data = { nState = 0 } }]
//! ```
//!
//! An expectation that compares nothing, such as an empty list, is an error.
//!
//! Expectations about motion are in `motion`, `cycle_time` and `clearance`.
//!
//! Each family of expectations has a file, which contains its keys as plain data and, if it depends on the run, an
//! observer type that receives each cycle and returns failures at the end.

mod clearance;
mod cycle_event;
mod cycle_time;
mod edge;
mod errors;
mod filled;
mod fit;
mod motion;
mod observer;
mod occurrence;
mod order;
mod output;
mod places;
mod screen;
mod sent;
mod state;
mod values;
mod within;

use serde::Deserialize;
use toml::Spanned;
use val3_machine::script::SentText;
use val3_trace::{Clear, Inside, Speed, TraceFile};

use clearance::Clearance;
pub use cycle_event::CycleEvent;
use cycle_time::CycleTime;
use errors::ExpectedError;
pub(crate) use errors::failure as error_failure;
pub(crate) use fit::{ExpectationFault, Fit};
pub(crate) use observer::Observer;
pub(crate) use occurrence::CycleState;
use occurrence::Occurrence;
use order::EventOrder;
use places::ExpectedPlaces;
pub(crate) use screen::{shown as shown_page, written_page};
use state::{ExpectedState, TimedState};
use values::ExpectedValues;
use within::Within;

/// Keys of `[expect]`.
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Expectations {
    #[serde(deserialize_with = "filled::page_texts")]
    screen: Vec<Spanned<String>>,
    screen_file: Option<Spanned<String>>,
    print_file: Option<Spanned<String>>,
    #[serde(deserialize_with = "values::signals")]
    io: ExpectedValues,
    #[serde(deserialize_with = "values::variables")]
    data: ExpectedValues,
    #[serde(deserialize_with = "filled::list")]
    print: Vec<Spanned<String>>,
    #[serde(deserialize_with = "filled::list")]
    log: Vec<Spanned<String>>,
    #[serde(deserialize_with = "filled::list")]
    popup: Vec<Spanned<String>>,
    #[serde(deserialize_with = "sent::texts")]
    sent: Vec<Spanned<SentText>>,
    /// Expected errors. The empty list states the default, that no error occurs.
    errors: Vec<Spanned<ExpectedError>>,
    #[serde(deserialize_with = "values::sensors")]
    seen: ExpectedValues,
    #[serde(deserialize_with = "values::parts")]
    held: ExpectedValues,
    #[serde(deserialize_with = "places::places")]
    placed: ExpectedPlaces,
    #[serde(deserialize_with = "state::timed")]
    at: Vec<TimedState>,
    #[serde(deserialize_with = "filled::list")]
    within: Vec<Spanned<Within>>,
    #[serde(deserialize_with = "filled::list")]
    order: Vec<EventOrder>,
    #[serde(deserialize_with = "filled::list")]
    time: Vec<Spanned<CycleTime>>,
    trace: Option<Spanned<TraceFile>>,
    #[serde(deserialize_with = "filled::list")]
    speed: Vec<Spanned<Speed>>,
    #[serde(deserialize_with = "filled::list")]
    inside: Vec<Spanned<Inside>>,
    #[serde(deserialize_with = "filled::list")]
    clear: Vec<Spanned<Clear>>,
    contact: Option<Spanned<bool>>,
    clearance: Option<Spanned<Clearance>>,
}

impl Expectations {
    /// Expected state at the end.
    fn last_state(&self) -> ExpectedState<'_> {
        let Self { screen, io, data, seen, held, placed, .. } = self;
        ExpectedState { table: "expect", screen, io, data, seen, held, placed }
    }

    /// Links of the lines with expected output.
    pub(crate) fn lines(&self) -> impl Iterator<Item = &str> {
        let deadlines = self.within.iter().flat_map(|within| within.get_ref().occurrences());
        let orders = self.order.iter().flat_map(EventOrder::occurrences);
        let times = self.time.iter().flat_map(|time| time.get_ref().occurrences());
        let occurrences = deadlines.chain(orders).chain(times).filter_map(Occurrence::line);
        self.sent.iter().map(|text| text.get_ref().link()).chain(occurrences)
    }

    /// Whether there are no expectations.
    pub(crate) fn is_empty(&self) -> bool {
        let Self { print, log, popup, sent, errors, at, within, order, time, trace, .. } = self;
        let texts = [print, log, popup].iter().all(|texts| texts.is_empty());
        let values = self.last_state().is_empty() && at.is_empty();
        let course = sent.is_empty() && errors.is_empty() && within.is_empty() && order.is_empty() && time.is_empty();
        let files = self.screen_file.is_none() && self.print_file.is_none();
        let motion = trace.is_none() && self.speed.is_empty() && self.inside.is_empty() && self.clear.is_empty();
        let distances = self.contact.is_none() && self.clearance.is_none();
        texts && values && course && files && motion && distances
    }

    /// Expectations that cannot be met in any run of the application, because of names or times.
    pub(crate) fn faults(&self, fit: &Fit<'_>) -> Vec<ExpectationFault> {
        let states =
            self.last_state().faults(fit).into_iter().chain(self.at.iter().flat_map(|state| state.faults(fit)));
        let errors = self.errors.iter().filter_map(|error| error.get_ref().fault(fit, &error.span()));
        let deadlines = self.within.iter().flat_map(|within| within.get_ref().faults(fit, &within.span()));
        let orders = self.order.iter().flat_map(|order| order.faults(fit));
        let times = self.time.iter().flat_map(|time| time.get_ref().faults(fit, &time.span()));
        let distances = clearance::faults(self.contact.as_ref(), self.clearance.as_ref(), fit.controller);
        let texts = sent::faults(&self.sent, fit);
        states.chain(texts).chain(errors).chain(deadlines).chain(orders).chain(times).chain(distances).collect()
    }
}
