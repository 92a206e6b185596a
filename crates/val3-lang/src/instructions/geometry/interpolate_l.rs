use crate::declare::instruction;

instruction! {
    /// Gives a position on the straight line between two positions.
    ///
    /// - `trStart`, `trEnd`: the ends, given in the same frame.
    /// - `nPosition`: 0 is the start, 1 the end, 0.5 the middle; above -1 and below 2, so that the line goes on beyond
    ///   its ends.
    /// - Result: the position; it turns between the two orientations as a `movel` does.
    /// - Error 70: `nPosition` is out of its range.
    ///
    /// ## Example
    /// ```val3
    /// trsf trMiddle
    /// point pFirst
    /// point pLast
    ///   trMiddle=interpolateL(pFirst.trsf,pLast.trsf,0.5)
    /// ```
    "interpolateL": Geometry "9.3.4", errors [70];
    function (trsf trStart, trsf trEnd, num nPosition) -> trsf;
}
