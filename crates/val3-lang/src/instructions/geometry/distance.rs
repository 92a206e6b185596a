use crate::declare::instruction;

instruction! {
    /// Gives the distance between two positions.
    ///
    /// - `trPosition1`, `trPosition2`: two transformations, given in the same frame.
    /// - `pPosition1`, `pPosition2`: two points, in whatever frames.
    /// - Result: millimetres (inches), always 0 or more; orientation does not count.
    /// - Error 162: a point has no reference frame.
    ///
    /// ## Example
    /// ```val3
    /// point pTarget
    /// tool tGripper
    ///   wait(distance(here(tGripper,world),pTarget)<10)
    /// ```
    "distance": Geometry "9.3.4, 9.6.3", errors [162];
    function (trsf trPosition1, trsf trPosition2) -> num;
    function (point pPosition1, point pPosition2) -> num;
}
