//! `wakeUpRobot`: wakes up an arm in sleep mode.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Wakes up an arm in sleep mode.
    ///
    /// - Result: a status number, whose meaning depends on the controller.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    /// num nCode
    ///   nCode=wakeUpRobot()
    ///   putln(nCode)
    /// ```
    "wakeUpRobot": Additions, since 8;
    modifier () -> num = wake_up_robot;
}

fn wake_up_robot(call: &mut Call<'_>) -> f64 {
    call.ports.wake_up()
}
