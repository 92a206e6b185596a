use crate::declare::instruction;

instruction! {
    /// Inserts a value into a one-dimensional array.
    ///
    /// - `variable`: the array.
    /// - `nIndex`: before which value.
    ///
    /// It is older than `insert`, which needs no add-on.
    ///
    /// ## Example
    /// ```val3
    /// num nPath[4]
    ///   $dins(nPath,size(nPath)-1)
    /// ```
    "$dins": AddOns, with_add_on "Expansion";
    modifier (any& variable[], num nIndex);
}
