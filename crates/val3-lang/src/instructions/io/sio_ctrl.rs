//! `sioCtrl` (3.7.3): changes a communication parameter of a serial channel.

use crate::call::{Any, Call, IoRef, StoredValue};
use crate::declare::instruction;
use crate::fault::Result;
use crate::ports::LineValue;
use crate::types::BaseType;
use crate::values::Text;

instruction! {
    /// Changes a communication parameter of a serial channel.
    ///
    /// - `siChannel`: the serial line or socket.
    /// - `sParameter`, `value`: for sockets `"port"` (num), `"target"` (string, address of the server to call),
    ///   `"clients"` (num, maximum number of clients of a server), `"nagle"` (bool); for all `"endOfString"` (num, 0 to
    ///   255, the character that ends a string) and `"timeout"` (num, seconds, 0 for no timeout); for lines
    ///   `"baudRate"` (num), `"parity"` (string: `"none"`, `"even"`, `"odd"`), `"bits"` (num, 5 to 8), `"stopBits"`
    ///   (num, 1 or 2), `"mode"` (string: `"rs232"`, `"rs422"`), `"flowControl"` (string: `"none"`, `"hardware"`).
    /// - Result: 0 done, -1 no such parameter, -2 value of a wrong type, -3 value not supported, -4 the channel is
    ///   busy, -5 not a parameter of this kind of channel.
    /// - Error 123: not linked.
    ///
    /// ## Example
    /// ```val3
    /// sio siHost
    ///   sioCtrl(siHost,"endOfString",13)
    ///   sioCtrl(siHost,"timeout",0.5)
    /// ```
    "sioCtrl": Io "3.7.3", errors [123];
    modifier (sio siChannel, string sParameter, any value) -> num = control;
}

fn control(call: &mut Call<'_>, line: IoRef, parameter: Text, value: Any) -> Result<f64> {
    let value = match value.base {
        Some(BaseType::Bool) => LineValue::Bool(bool::read(call.memory, value.place)?),
        Some(BaseType::Num) => LineValue::Num(f64::read(call.memory, value.place)?),
        Some(BaseType::String) => LineValue::Text(Text::read(call.memory, value.place)?),
        _ => LineValue::Other,
    };
    call.ports.control_line(line.port, &parameter, value).map(f64::from)
}
