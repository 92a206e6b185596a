use crate::declare::instruction;

instruction! {
    /// Removes a value from a one-dimensional array.
    ///
    /// - `variable`: the array.
    /// - `nIndex`: which value.
    ///
    /// It is older than `delete`, which needs no add-on.
    ///
    /// ## Example
    /// ```val3
    /// num nPath[4]
    ///   $ddel(nPath,0)
    /// ```
    "$ddel": AddOns, with_add_on "Expansion";
    modifier (any& variable[], num nIndex);
}
