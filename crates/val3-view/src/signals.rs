//! Inputs, outputs and lines.

use rustc_hash::FxHashMap;
use val3_machine::controller::Controller;
use val3_machine::io::{Direction, IoTable, SignalId, SignalKind};

use crate::wire::{self, IoMessage, LineInfo, SignalInfo};

/// Word for a direction.
#[must_use]
pub fn direction(direction: Direction) -> &'static str {
    match direction {
        Direction::Input => "input",
        Direction::Output => "output",
    }
}

/// Signals of the cell. `names` contains the data linked to each signal.
pub(crate) fn described(io: &IoTable, names: &FxHashMap<SignalId, Vec<String>>) -> Vec<SignalInfo> {
    let signals = io.signals().filter_map(|id| {
        let signal = io.signal(id)?;
        let board = signal.path.rsplit_once('\\').map_or("", |(board, _)| board);
        Some(SignalInfo {
            link: signal.path.clone(),
            names: names.get(&id).cloned().unwrap_or_default(),
            board: board.to_owned(),
            direction: direction(signal.direction).to_owned(),
            is_digital: matches!(signal.kind, SignalKind::Digital),
            unit: io.unit(id).map(str::to_owned),
            description: signal.description.clone(),
        })
    });
    signals.collect()
}

/// Serial lines and sockets.
pub(crate) fn lines(controller: &Controller) -> Vec<LineInfo> {
    let kinds = controller.devices.lines.kinds();
    kinds.map(|(link, kind)| LineInfo { link: link.to_owned(), kind: format!("{kind:?}").to_lowercase() }).collect()
}

/// Latest states of all signals as sent to the pages.
#[derive(Debug, Default)]
pub(crate) struct SignalStates(Vec<SignalState>);

#[derive(Debug, Clone, Copy, PartialEq)]
struct SignalState {
    value: Option<f64>,
    is_locked: bool,
    is_simulated: bool,
    is_protected: bool,
    fault: Option<val3_machine::io::SignalFault>,
}

impl SignalStates {
    /// Message `io` with all changes; `None` without changes.
    pub(crate) fn changes(&mut self, t: f64, io: &IoTable) -> Option<IoMessage> {
        let mut changes = Vec::new();
        for (number, id) in io.signals().enumerate() {
            let Some((signal, forcing)) = io.signal(id).zip(io.forcing(id)) else { continue };
            let state = SignalState {
                value: io.next_image(id),
                is_locked: forcing.is_locked,
                is_simulated: forcing.is_simulated,
                is_protected: signal.protected,
                fault: forcing.fault,
            };
            match self.0.get_mut(number) {
                Some(known) if *known == state => continue,
                Some(known) => *known = state,
                None => self.0.push(state),
            }
            changes.push(wire::SignalState {
                link: signal.path.clone(),
                value: state.value,
                is_locked: state.is_locked,
                is_simulated: state.is_simulated,
                is_protected: state.is_protected,
                fault: state.fault.map(|fault| format!("{fault:?}")),
            });
        }
        (!changes.is_empty()).then_some(IoMessage { t, changes })
    }
}

#[cfg(test)]
mod tests {
    use val3_machine::io::Signal;

    use super::*;

    /// Value and lock in the last message about a signal.
    fn shown(states: &mut SignalStates, io: &IoTable) -> Option<(Option<f64>, bool)> {
        states.changes(0.0, io).and_then(|io| io.changes.last().map(|change| (change.value, change.is_locked)))
    }

    #[test]
    fn a_locked_input_has_the_value_that_programs_read() {
        let mut io = IoTable::default();
        let id = io.declare(Signal::from_path("B\\%I0", true));
        let mut states = SignalStates::default();
        assert_eq!(shown(&mut states, &io), Some((Some(0.0), false)));
        io.lock(id, Some(1.0));
        assert_eq!(shown(&mut states, &io), Some((Some(1.0), true)), "before the next cycle");
        io.refresh_inputs();
        io.set(id, 0.0);
        assert_eq!(shown(&mut states, &io), None, "the terminal has no effect");
        io.lock(id, Some(0.0));
        assert_eq!(shown(&mut states, &io), Some((Some(0.0), true)));
        io.set(id, 1.0);
        io.unlock(id);
        assert_eq!(shown(&mut states, &io), Some((Some(1.0), false)));
        io.simulate(id, true);
        io.set(id, 0.0);
        assert_eq!(shown(&mut states, &io), Some((Some(0.0), false)), "a simulated input is set like the terminal");
    }
}
