//! `$dins`: inserts a value into a one-dimensional array.

use crate::call::{Any, Arr, Call};
use crate::declare::instruction;
use crate::fault::Result;

instruction! {
    /// Inserts a value into a one-dimensional array.
    ///
    /// - `variable`: the array.
    /// - `nIndex`: the index of the value before which the new value is inserted.
    /// - Errors: as for `insert`.
    ///
    /// It is older than `insert`, which needs no add-on.
    ///
    /// ## Example
    /// ```val3
    /// num nPath[4]
    ///   $dins(nPath,size(nPath)-1)
    /// ```
    "$dins": AddOns, with_add_on "Expansion", errors [20, 21, 40, 70];
    modifier (any& variable[], num nIndex) = insert;
}

fn insert(call: &mut Call<'_>, variable: Arr<Any>, index: f64) -> Result<()> {
    let limit = call.version.container_limit();
    call.memory.insert_at(variable.view, index, limit)
}
