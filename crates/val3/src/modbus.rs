//! `--modbus`: the Modbus server of the cell, on the signals of a run.
//!
//! A thread serves the clients, who read and write an image of the values. Between two cycles, the run loop receives the
//! written values and publishes its own, so that a request reads the values of one cycle.

mod address;
mod configuration;
mod connections;
mod server;
mod shared;
#[cfg(test)]
mod tests;

use val3_machine::controller::Controller;
use val3_machine::io::{IoChange, SignalId};
use val3_modbus::{ModbusImage, ModbusMap, TableKind, Write, word};
use val3_session::Application;

use crate::args::{RunArgs, RunTime};
use crate::output::to_stderr;
use crate::printable::one_line;
use crate::user_error::UserError;
pub(crate) use address::ModbusAddress;
use server::Server;

/// Modbus server of a run. Dropping the value ends the server.
pub(crate) struct ModbusRun {
    server: Server,
    map: ModbusMap,
    /// Signals of the bits and words, by address.
    signals: [Vec<Option<SignalId>>; 2],
    /// Whether a discarded write was reported.
    has_reported: bool,
}

impl ModbusRun {
    /// Starts the server of an application's cell before the run begins; `None` without `--modbus`.
    ///
    /// # Errors
    /// The cell's file is missing or faulty, the address is in use, or the time is virtual.
    pub(crate) fn open(
        args: &RunArgs,
        application: &Application,
        controller: &Controller,
    ) -> Result<Option<Self>, UserError> {
        let Some(address) = args.modbus else { return Ok(None) };
        if args.time == Some(RunTime::Virtual) {
            return Err(UserError::new("Modbus clients act in real time, but the time of the run is virtual")
                .with_help("omit --time virtual"));
        }
        let io = &controller.devices.state.io;
        let map = configuration::map(application, io)?;
        let signals = TableKind::ALL.map(|table| {
            let links = map.table(table).iter().map(|element| io.find(&element.as_ref()?.link));
            links.collect()
        });
        let server = Server::start(address, ModbusImage::new(&map), map.clients)?;
        let at = server.address();
        to_stderr(|out| {
            let [bits, words] = TableKind::ALL.map(|table| map.table(table).len());
            let (topic, clients) = (one_line(&map.topic), map.clients);
            writeln!(
                out,
                "note: the Modbus server of `{topic}` is at {at}: {bits} bits, {words} words, at most {clients} clients"
            )?;
            if !at.ip().is_loopback() {
                writeln!(out, "note: Modbus has no password: every machine that reaches this port can set inputs")?;
            }
            Ok(())
        });
        let this = Self { server, map, signals, has_reported: false };
        this.publish(controller);
        Ok(Some(this))
    }

    /// Passes the values that clients have written to the next cycle.
    pub(crate) fn deliver(&mut self, controller: &mut Controller) {
        if controller.is_within_cycle() {
            return;
        }
        let (writes, discarded) = self.server.exchange(|image| (image.take_writes(), image.discarded()));
        let changes: Vec<IoChange> = writes.iter().filter_map(|write| self.change(write)).collect();
        if !changes.is_empty() {
            controller.devices.receive(changes);
        }
        if let Some((table, address)) = discarded.filter(|_| !self.has_reported) {
            self.has_reported = true;
            let link = self.map.element(table, address).map_or("", |element| element.link.as_str());
            to_stderr(|out| {
                writeln!(
                    out,
                    "note: a Modbus client writes `{}`, which only the robot writes; such values are discarded",
                    one_line(link)
                )
            });
        }
    }

    fn change(&self, write: &Write) -> Option<IoChange> {
        let signal = *self.signals_of(write.table).get(usize::from(write.address))?;
        Some(IoChange { signal: signal?, value: f64::from(write.value) })
    }

    /// Publishes the values at the end of a cycle.
    pub(crate) fn publish(&self, controller: &Controller) {
        let io = &controller.devices.state.io;
        self.server.exchange(|image| {
            for table in TableKind::ALL {
                for (signal, address) in self.signals_of(table).iter().zip(0..=u16::MAX) {
                    if let Some(value) = signal.and_then(|signal| io.hardware(signal)) {
                        image.publish(table, address, word(value));
                    }
                }
            }
        });
    }

    fn signals_of(&self, table: TableKind) -> &[Option<SignalId>] {
        let [bits, words] = &self.signals;
        match table {
            TableKind::Bits => bits,
            TableKind::Words => words,
        }
    }
}
