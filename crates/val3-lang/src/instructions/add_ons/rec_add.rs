//! `$recAdd`: adds a value to the recorded values of a recorder.

use crate::declare::instruction;

instruction! {
    /// Adds a value to the recorded values of a recorder.
    ///
    /// - `sRecorder`: the recorder, `"c"` or `"d"`.
    /// - `sVariable`: the value to record.
    ///
    /// ## Example
    /// ```val3
    /// string sVariable
    ///   $recClean("c")
    ///   $recAdd("c",sVariable)
    /// ```
    "$recAdd": AddOns, with_add_on "Recorder";
    modifier (string sRecorder, string sVariable);
}
