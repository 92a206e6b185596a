use crate::declare::instruction;

instruction! {
    /// Tells whether a file exists.
    ///
    /// - `sPath`: where it would be.
    /// - Result: `true` if it is there.
    ///
    /// ## Example
    /// ```val3
    ///   if $fileExists("Disk://data/order.txt")==false
    ///     popUpMsg("No order")
    ///   endIf
    /// ```
    "$fileExists": AddOns, with_add_on "Expansion";
    function (string sPath) -> bool;
}
