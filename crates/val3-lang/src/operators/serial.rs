//! Assignments between a value and a serial line (3.7.2).

use crate::call::{Call, Flow, FromArgument, HandlerResult, InstructionFn, IoRef};
use crate::fault::{Fault, Result};
use crate::ports::Outgoing;
use crate::runtime_errors::NO_ANSWER;
use crate::types::BaseType;
use crate::values::Text;

/// Handler of `to = from` if one side is a `sio`; `None` for other types.
///
/// For a line as target, the arguments are the line and the value, and the result is the sent value. For a line as
/// source, the argument is the line, and the result is the received value. The task waits inside of the handler.
pub(super) fn assignment(to: BaseType, from: BaseType) -> Option<InstructionFn> {
    match (to, from) {
        (BaseType::Sio, BaseType::String) => Some(send_text),
        (BaseType::Sio, BaseType::Num) => Some(send_number),
        (BaseType::String, BaseType::Sio) => Some(receive_text),
        (BaseType::Num, BaseType::Sio) => Some(receive_number),
        _ => None,
    }
}

fn send_text(call: &mut Call<'_>) -> Result<Flow> {
    let (line, text) = (IoRef::take(call)?, Text::take(call)?);
    match send(call, line, Outgoing::Text(&text))? {
        Flow::Done(()) => text.settle(call),
        Flow::Wait(wait) => Ok(Flow::Wait(wait)),
    }
}

/// Sends a number as one byte. The result is this byte.
fn send_number(call: &mut Call<'_>) -> Result<Flow> {
    let (line, number) = (IoRef::take(call)?, f64::take(call)?);
    match send(call, line, Outgoing::Numbers(&[number]))? {
        Flow::Done(()) => crate::values::numbers::round(number).rem_euclid(256.0).settle(call),
        Flow::Wait(wait) => Ok(Flow::Wait(wait)),
    }
}

/// Sends data. A connection that is closed during the transfer is no error; only the timeout is (3.7.2).
fn send(call: &mut Call<'_>, line: IoRef, what: Outgoing<'_>) -> Result<Flow> {
    let (first, waited) = (call.is_first(), call.waited());
    match call.ports.send(line.port, what, first, waited)?.flow(call) {
        Flow::Done(Some(_)) => Ok(Flow::Done(())),
        Flow::Done(None) => Err(Fault(NO_ANSWER)),
        Flow::Wait(wait) => Ok(Flow::Wait(wait)),
    }
}

fn receive_text(call: &mut Call<'_>) -> Result<Flow> {
    let (line, waited) = (IoRef::take(call)?, call.waited());
    call.ports.receive_text(line.port, waited)?.flow(call).settle(call)
}

fn receive_number(call: &mut Call<'_>) -> Result<Flow> {
    let (line, waited) = (IoRef::take(call)?, call.waited());
    match call.ports.receive_byte(line.port, waited)?.flow(call) {
        Flow::Done(byte) => f64::from(byte).settle(call),
        Flow::Wait(wait) => Ok(Flow::Wait(wait)),
    }
}
