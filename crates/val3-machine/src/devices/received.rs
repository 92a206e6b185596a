//! Values that other machines write to inputs, such as the clients of a field bus.

use val3_lang::ports::Time;

use super::Devices;
use crate::event::EventKind;
use crate::inputs::Answer;
use crate::io::{IoChange, IoTable, SignalKind};

impl Answer for Vec<IoChange> {
    fn held_bytes(&self) -> usize {
        self.len() * size_of::<IoChange>()
    }
}

impl Devices {
    /// Adds values that signals receive from the outside at the beginning of the next cycle. Of several values for a
    /// signal, the last one remains.
    pub fn receive(&mut self, values: Vec<IoChange>) {
        self.received.extend(values);
    }

    /// Begins a cycle: sets signals to the received values, and records the values that differ as an action, which a
    /// scenario can repeat.
    pub(crate) fn apply_received(&mut self, now: Time) {
        let received = self.lines.inputs().ask_usual(&Vec::new(), || std::mem::take(&mut self.received));
        let io = &mut self.state.io;
        let changed = received.into_iter().filter(|change| io.hardware(change.signal) != Some(change.value));
        let changed: Vec<IoChange> = changed.collect();
        if changed.is_empty() {
            return;
        }
        changed.iter().for_each(|change| io.set(change.signal, change.value));
        let entries = changed.iter().filter_map(|change| entry(io, change)).collect();
        let keys = serde_json::Map::from_iter([("io".to_owned(), serde_json::Value::Object(entries))]);
        self.record_outside(now, EventKind::Act { keys });
    }
}

/// Entry of a script's key `io`.
fn entry(io: &IoTable, change: &IoChange) -> Option<(String, serde_json::Value)> {
    let signal = io.signal(change.signal)?;
    let value = match signal.kind {
        SignalKind::Digital => (change.value != 0.0).into(),
        SignalKind::Analog(_) => change.value.into(),
    };
    Some((signal.path.clone(), value))
}
