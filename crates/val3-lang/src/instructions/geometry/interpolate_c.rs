use crate::declare::instruction;

instruction! {
    /// Gives a position on the arc through three positions.
    ///
    /// - `trStart`, `trIntermediate`, `trEnd`: the arc, all given in the same frame.
    /// - `nPosition`: 0 is the start, 1 the end, 0.5 the middle of the arc; less than 0 lies before the start, more
    ///   than 1 behind the end.
    /// - Result: the position; it turns as a `movec` does.
    /// - Error 70: the positions are too close to each other for an arc, or the orientation between them is ambiguous.
    ///
    /// ## Example
    /// ```val3
    /// trsf trMiddle
    /// point pArc[3]
    ///   trMiddle=interpolateC(pArc[0].trsf,pArc[1].trsf,pArc[2].trsf,0.5)
    /// ```
    "interpolateC": Geometry "9.3.4", errors [70];
    function (trsf trStart, trsf trIntermediate, trsf trEnd, num nPosition) -> trsf;
}
