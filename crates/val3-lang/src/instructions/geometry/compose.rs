use crate::declare::instruction;

instruction! {
    /// Moves a point by a transformation that is given in any frame.
    ///
    /// - `pPosition`: the point.
    /// - `fReference`: the frame in which the transformation is meant.
    /// - `trTransformation`: translation and rotation about the origin of that frame. A rotation therefore moves the
    ///   point as well, unless the point lies at the origin.
    /// - Result: the new point, with frame and configuration of `pPosition`.
    /// - Errors: 162 the point, 163 a frame has no reference frame.
    ///
    /// `appro` moves a point in its own orientation.
    ///
    /// ## Example
    /// ```val3
    /// point pPick
    /// point pNext
    /// frame fTable
    ///   pNext=compose(pPick,fTable,{0,60,0,0,0,0})
    /// ```
    "compose": Geometry "9.6.3", errors [162, 163];
    function (point pPosition, frame fReference, trsf trTransformation) -> point;
}
