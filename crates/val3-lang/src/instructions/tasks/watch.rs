//! `watch` (5.10): waits until a condition holds, but no longer than a given time.

use crate::declare::instruction;

instruction! {
    /// Waits until a condition holds, but no longer than a given time.
    ///
    /// - `bCondition`: any condition; it is evaluated again at every turn of the task.
    /// - `nSeconds`: the longest wait in seconds.
    /// - Result: `true` if the condition holds, `false` if the time ran out.
    ///
    /// ## Example
    /// ```val3
    /// dio diPart
    ///   if watch(diPart==true,20)==false
    ///     popUpMsg("No part for 20 s")
    ///     wait(diPart==true)
    ///   endIf
    /// ```
    "watch": Tasks "5.10", blocking;
    modifier (bool bCondition, num nSeconds) -> bool;
}
