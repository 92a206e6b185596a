//! Access of instructions to serial lines and sockets (3.7).

use val3_lang::fault::{Fault, Result};
use val3_lang::ports::{LineValue, Outgoing, Reply, Serial, Time};
use val3_lang::runtime_errors::{NO_ANSWER, UNLINKED};
use val3_lang::values::Text;

use super::Devices;
use crate::event::seconds;
use crate::sio::{LineKind, Sending, SettingValue, SioFault, byte_of};

impl Serial for Devices {
    fn receive_text(&mut self, port: Option<u32>, waited: Time) -> Result<Reply<Text>> {
        let reply =
            self.lines.ask(port, self.state.record.origin().task, |channel| channel.read_text(seconds(waited)))?;
        let reply = done(reply)?;
        if let Reply::Done(text) = &reply {
            self.record_all(self.lines.exchange(port, "in", text.as_bytes()));
        }
        Ok(reply.map(|text| Text::from(text.as_str())))
    }

    fn receive_byte(&mut self, port: Option<u32>, waited: Time) -> Result<Reply<u8>> {
        let reply =
            done(self.lines.ask(port, self.state.record.origin().task, |channel| channel.read_byte(seconds(waited)))?)?;
        if let Reply::Done(byte) = &reply {
            self.record_all(self.lines.exchange(port, "in", &[*byte]));
        }
        Ok(reply)
    }

    fn receive(&mut self, port: Option<u32>, most: usize, waited: Time) -> Result<Reply<Option<Vec<u8>>>> {
        let reply = self
            .lines
            .ask(port, self.state.record.origin().task, |channel| channel.read_bytes(most, seconds(waited)))?;
        if let Reply::Done(Some(bytes)) = &reply {
            self.record_all(self.lines.exchange(port, "in", bytes));
        }
        Ok(reply)
    }

    fn send(
        &mut self,
        port: Option<u32>,
        what: Outgoing<'_>,
        first: bool,
        waited: Time,
    ) -> Result<Reply<Option<usize>>> {
        let task = self.state.record.origin().task;
        let begun = self.lines.take_sending(task).filter(|_| !first);
        let channel = self.lines.channel(port).ok_or(Fault(UNLINKED))?;
        let mut sending = begun.unwrap_or_else(|| match what {
            Outgoing::Text(text) => channel.text(text),
            Outgoing::Numbers(numbers) => Sending::bytes(numbers.iter().copied().map(byte_of).collect()),
        });
        if self.lines.pending() + sending.total() > self.limits.pending {
            return Err(Fault::NO_MEMORY);
        }
        let reply = self.lines.ask(port, task, |channel| channel.send(&mut sending, seconds(waited)))?;
        let reply = reply.map(|sent| sent.ok());
        match reply {
            Reply::Wait(_) => {
                self.lines.keep_sending(task, sending);
            }
            Reply::Done(_) => {
                self.lines.keep_output(port, sending.gone());
                self.record_all(self.lines.exchange(port, "out", sending.gone()));
            }
        }
        Ok(reply)
    }

    fn clear_line(&mut self, port: Option<u32>) -> Result<Option<usize>> {
        let channel = self.lines.channel(port).ok_or(Fault(UNLINKED))?;
        let (cleared, is_socket) = (channel.clear(), channel.kind() != LineKind::Serial);
        if is_socket {
            self.lines.end_use(port);
        }
        Ok(cleared)
    }

    fn control_line(&mut self, port: Option<u32>, parameter: &str, value: LineValue) -> Result<i8> {
        let channel = self.lines.channel(port).ok_or(Fault(UNLINKED))?;
        Ok(match &value {
            LineValue::Bool(value) => channel.control(parameter, SettingValue::Bool(*value)),
            LineValue::Num(value) => channel.control(parameter, SettingValue::Num(*value)),
            LineValue::Text(value) => channel.control(parameter, SettingValue::Text(value)),
            LineValue::Other => channel.control(parameter, SettingValue::Other),
        })
    }
}

/// Converts the timeout of `=` to a run-time error (3.7.2).
fn done<T>(reply: Reply<std::result::Result<T, SioFault>>) -> Result<Reply<T>> {
    match reply {
        Reply::Done(Ok(value)) => Ok(Reply::Done(value)),
        Reply::Done(Err(SioFault::TimedOut)) => Err(Fault(NO_ANSWER)),
        Reply::Wait(time) => Ok(Reply::Wait(time)),
    }
}
