//! `alterEnd` (11.2.6): ends the deviation of the path.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Ends the deviation of the path.
    ///
    /// - Result: 1 ended, -1 it was not started, -3 a motion error: `resetMotion` is needed.
    ///
    /// If it is called before the end of the path, the rest of the path keeps the current deviation, and the next
    /// normal move can follow without a stop. If it is called at the end of the path, the next move starts then.
    ///
    /// ## Example
    /// ```val3
    ///   if alterEnd()==-3
    ///     resetMotion()
    ///   endIf
    /// ```
    "alterEnd": Options "11.2.6";
    modifier () -> num = end;
}

fn end(call: &mut Call<'_>) -> f64 {
    call.ports.end_alter().into()
}
