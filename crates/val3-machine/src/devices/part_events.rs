//! Events of the controller's parts, in the form of a run's record.

use crate::controller_state::{EventLog, Robot, RobotEvent};
use crate::event::EventKind;
use crate::io::{IoChange, IoTable};
use crate::screen::{Pendant, ScreenEvent};

/// New lines of the event log.
pub(super) fn logged(log: &mut EventLog) -> Vec<EventKind> {
    let entries = log.take_entries();
    entries.iter().map(|entry| EventKind::Log { level: entry.severity.name(), text: entry.line() }).collect()
}

/// Changes of power and mode.
pub(super) fn switched(robot: &mut Robot) -> Vec<EventKind> {
    let events = robot.take_events().into_iter().filter_map(|event| match event {
        RobotEvent::Power(on) => Some(EventKind::Power { on }),
        RobotEvent::Mode(mode) => Some(EventKind::Mode { mode: mode.number() }),
        RobotEvent::EmergencyStop(_) | RobotEvent::MonitorSpeed(_) => None,
    });
    events.collect()
}

/// Changes of inputs or outputs.
pub(super) fn changed(io: &IoTable, changes: Vec<IoChange>) -> Vec<EventKind> {
    let kind = |IoChange { signal, value }| Some(EventKind::Io { link: io.signal(signal)?.path.clone(), value });
    changes.into_iter().filter_map(kind).collect()
}

/// Changes of the pendant.
pub(super) fn seen(pendant: &mut Pendant) -> Vec<EventKind> {
    let events = pendant.take_events();
    events.into_iter().filter_map(|event| on_screen(pendant, event)).collect()
}

/// Converts an event to the form in the record. A question has the form of a message.
fn on_screen(pendant: &Pendant, event: ScreenEvent) -> Option<EventKind> {
    let screen = |page| pendant.name(page).to_owned();
    let cell = |number| u8::try_from(number).unwrap_or(u8::MAX);
    Some(match event {
        ScreenEvent::Put { page, at, text, ends_line } => {
            EventKind::Put { screen: screen(page), x: cell(at.column), y: cell(at.row), text, ends_line }
        }
        ScreenEvent::Title(page, text) => EventKind::Title { screen: screen(page), text },
        ScreenEvent::Cleared(page) => EventKind::Cls { screen: screen(page) },
        ScreenEvent::PopUp(pop_up) => EventKind::Popup { text: pop_up.text },
        ScreenEvent::Question(text) => EventKind::Popup { text },
        ScreenEvent::HtmlSet { page, id, attribute, value } => EventKind::Html { page, id, attribute, value },
        ScreenEvent::Shown(_) | ScreenEvent::PopUpConfirmed | ScreenEvent::HtmlShown(_) => return None,
    })
}
