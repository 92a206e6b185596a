//! `$recClean`: removes all values from a recorder.

use crate::declare::instruction;

instruction! {
    /// Removes all values from a recorder.
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
