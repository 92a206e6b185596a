//! `taskCreateSync` (5.10): starts a program as a synchronous task, which has its turns at fixed times.

use crate::declare::instruction;

instruction! {
    /// Starts a program as a synchronous task, which has its turn at fixed times.
    ///
    /// - `sName`: the name of the task: 1 to 15 letters, digits and `_`, not in use in this application or library.
    /// - `nPeriod`: time from turn to turn in seconds, above 0, rounded down to a multiple of 0.004. All synchronous
    ///   tasks together may have at most two different periods.
    /// - `bOverrun`: a global variable; it is set to `true` when a turn took longer than the period and the next turn
    ///   was skipped.
    /// - `program`: the call that the task executes. Local variables cannot be passed by reference.
    /// - Errors: 29 invalid name, 31 name in use, 32 a third period, 40 and 41 without memory, 70 invalid period.
    ///
    /// A turn ends at an instruction that waits, usually `delay(0)`, or after 3000 lines.
    ///
    /// ## Example
    /// ```val3
    /// bool bOverrun
    /// dio diGuard
    /// program watchGuard()
    /// begin
    ///   while diGuard==true
    ///     delay(0)
    ///   endWhile
    ///   stopMove()
    /// end
    ///   taskCreateSync "guard",0.02,bOverrun,watchGuard()
    /// ```
    "taskCreateSync": Tasks "5.10", errors [29, 31, 32, 40, 41, 70];
    modifier (string sName, num nPeriod, bool& bOverrun, program program);
}
