//! `$recStart`: starts a recorder.

use crate::declare::instruction;

instruction! {
    /// Starts a recorder.
    ///
    /// - `sRecorder`: the recorder, `"c"` or `"d"`.
    /// - `nDuration`: the duration.
    /// - `nFrequency`: the sampling frequency.
    ///
    /// ## Example
    /// ```val3
    ///   $recStart("c",10,250)
    /// ```
    "$recStart": AddOns, with_add_on "Recorder";
    modifier (string sRecorder, num nDuration, num nFrequency);
}
