//! `$recClean`: removes all values from a recorder.

use crate::declare::instruction;

instruction! {
    /// Makes a recorder forget what it has to record.
    ///
    /// - `sRecorder`: the recorder, `"c"` or `"d"`.
    ///
    /// ## Example
    /// ```val3
    ///   $recClean("c")
    /// ```
    "$recClean": AddOns, with_add_on "Recorder";
    modifier (string sRecorder);
}
