//! `wait` (5.10): waits until a condition holds.

use crate::declare::instruction;

instruction! {
    /// Waits until a condition holds.
    ///
    /// - `bCondition`: any condition; it is evaluated again at every turn of the task. If it already holds, the task
    ///   continues without a pause.
    ///
    /// The waiting time is not limited; `watch` has a time limit.
    ///
    /// ## Example
    /// ```val3
    /// dio diPart
    ///   wait(diPart==true)
    /// ```
    "wait": Tasks "5.10", blocking;
    modifier (bool bCondition);
}
