//! `$exec`: executes a line of code that the program has composed.

use crate::declare::instruction;

instruction! {
    /// Executes a line of code that the program has composed.
    ///
    /// - `sCode`: the line.
    /// - Result: a string that describes the outcome.
    ///
    /// ## Example
    /// ```val3
    /// num nCount
    /// string sFault
    ///   sFault=$exec("nCount=nCount+1")
    ///   putln(sFault)
    ///   putln(nCount)
    /// ```
    "$exec": AddOns, with_add_on "Expansion";
    modifier (string sCode) -> string;
}
