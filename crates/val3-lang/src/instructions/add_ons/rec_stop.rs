//! `$recStop`: stops a recorder.

use crate::declare::instruction;

instruction! {
    /// Stops a recorder.
    ///
    /// - `sRecorder`: the recorder, `"c"` or `"d"`.
    /// - Result: a number.
    ///
    /// ## Example
    /// ```val3
    ///   $recStop("c")
    /// ```
    "$recStop": AddOns, with_add_on "Recorder";
    modifier (string sRecorder) -> num;
}
