//! `logMsg` (4.3): writes a message to the event log of the controller.

use crate::call::Call;
use crate::declare::instruction;
use crate::values::Text;

instruction! {
    /// Writes a message to the event log of the controller.
    ///
    /// - `sText`: the message; date, time and the mark `USR` are written before it.
    /// - `nLevel`: (s8) its kind: 1 information, 2 warning, 3 error.
    /// - Result: `false` if the message was lost because there are too many messages.
    ///
    /// ## Example
    /// ```val3
    /// string sMessage = "gripper lost a part"
    ///   while logMsg(sMessage)==false
    ///     delay(0)
    ///   endWhile
    /// ```
    "logMsg": Screen "4.3";
    modifier (string sText) -> bool = log;
    modifier (string sText, num nLevel) -> bool since 8 = log_of;
}

fn log(call: &mut Call<'_>, text: Text) -> bool {
    call.ports.log(&text, 1.0)
}

fn log_of(call: &mut Call<'_>, text: Text, level: f64) -> bool {
    call.ports.log(&text, level)
}
