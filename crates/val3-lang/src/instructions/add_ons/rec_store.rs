//! `$recStore`: saves the recorded values of a recorder.

use crate::declare::instruction;

instruction! {
    /// Saves the recorded values of a recorder.
    ///
    /// - `sRecorder`: the recorder, `"c"` or `"d"`.
    /// - `sPath`: the file to write, with the extension `.ctt` or `.txt`.
    /// - Result: `true` if it was saved.
    ///
    /// ## Example
    /// ```val3
    ///   if $recStore("c","Disk://record.txt")==false
    ///     logMsg("record not saved")
    ///   endIf
    /// ```
    "$recStore": AddOns, with_add_on "Recorder";
    modifier (string sRecorder, string sPath) -> bool;
}
