//! `$compile`: checks a line of code that the program has composed, without executing it.

use crate::declare::instruction;

instruction! {
    /// Checks a line of code that the program has composed, without executing it.
    ///
    /// - `sCode`: the line.
    /// - Result: a string that describes the outcome.
    ///
    /// ## Example
    /// ```val3
    /// string sFault
    ///   sFault=$compile("putln(1)")
    ///   putln(sFault)
    /// ```
    "$compile": AddOns, with_add_on "Expansion";
    modifier (string sCode) -> string;
}
