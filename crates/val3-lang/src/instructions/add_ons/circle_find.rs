//! `$circleFind`: finds the circle that best fits measured positions.

use crate::declare::instruction;

instruction! {
    /// Finds the circle that best fits measured positions.
    ///
    /// - `trPositions`, `pPositions`: 3 to 10 positions; read only.
    /// - `trResult`, `fResult`: receives a position whose origin is the centre of the circle.
    /// - `nRadius`: receives the radius, millimetres (inches).
    /// - Result: the deviation of the positions from the circle.
    ///
    /// ## Example
    /// ```val3
    /// point pEdge[4]
    /// frame fHole
    /// num nRadius
    /// num nError
    ///   nError=$circleFind(pEdge,fHole,nRadius)
    ///   if nError<0.5
    ///     putln(nRadius)
    ///   endIf
    /// ```
    "$circleFind": AddOns, with_add_on "Expansion";
    modifier (trsf& trPositions[], trsf& trResult, num& nRadius) -> num;
    modifier (point& pPositions[], frame& fResult, num& nRadius) -> num;
}
