use crate::declare::instruction;

instruction! {
    /// Turns a position so that its z axis is parallel to an axis of a reference.
    ///
    /// - `trPosition`: the position; its x, y and z stay.
    /// - `trReference`: only its orientation counts.
    /// - Result: `trPosition`, turned so that its z axis points along the nearest of the axes of the reference.
    ///
    /// ## Example
    /// ```val3
    /// trsf trPick
    /// trsf trTable
    ///   trPick=align(trPick,trTable)
    /// ```
    "align": Geometry "9.3.4";
    function (trsf trPosition, trsf trReference) -> trsf;
}
