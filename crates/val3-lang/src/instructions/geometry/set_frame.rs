use crate::declare::instruction;

instruction! {
    /// Computes a frame from three points.
    ///
    /// - `pOrigin`: its origin.
    /// - `pAxisOx`: a point on its x axis, on the positive side.
    /// - `pPlaneOxy`: a point of its xy plane, on the positive side of y.
    /// - `fResult`: gets the position, relative to its own reference frame.
    /// - Result: 0 done, -1 `pAxisOx` is too close to the origin, -2 `pPlaneOxy` is too close to the x axis.
    /// - Errors: 161 `world` was changed, 162 a point has no reference frame, 163 the frame has none.
    ///
    /// ## Example
    /// ```val3
    /// point pTaught[3]
    /// frame fTable
    ///   if setFrame(pTaught[0],pTaught[1],pTaught[2],fTable)!=0
    ///     popUpMsg("Teach the three points farther apart")
    ///   endIf
    /// ```
    "setFrame": Geometry "9.4.4", errors [161, 162, 163];
    modifier (point pOrigin, point pAxisOx, point pPlaneOxy, frame& fResult) -> num;
}
