//! `$ddel`: removes a value from a one-dimensional array.

use crate::call::{Any, Arr, Call};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Removes a value from a one-dimensional array.
    ///
    /// - `variable`: the array.
    /// - `nIndex`: the index of the value.
    /// - Errors: as for `delete`.
    ///
    /// It is older than `delete`, which needs no add-on.
    ///
    /// ## Example
    /// ```val3
    /// num nPath[4]
    ///   $ddel(nPath,0)
    /// ```
    "$ddel": AddOns, with_add_on "Expansion", errors [20, 21, 70];
    modifier (any& variable[], num nIndex) = delete;
}

fn delete(call: &mut Call<'_>, variable: Arr<Any>, index: f64) -> Result<()> {
    call.memory.delete_at(variable.view, index)
}
