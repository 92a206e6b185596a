use crate::declare::instruction;

instruction! {
    /// Gives a point near another one, along the axes of that point.
    ///
    /// - `pPosition`: the point.
    /// - `trTransformation`: where the result lies, seen from the point: with the z axis of the tool pointing at the
    ///   part,
    ///   a negative z is above it.
    /// - Result: the new point, with frame and configuration of `pPosition`.
    /// - Error 162: the point has no reference frame.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// point pPick
    /// mdesc mFast
    /// mdesc mSlow
    ///   movej(appro(pPick,{0,0,-100,0,0,0}),tGripper,mFast)
    ///   movel(pPick,tGripper,mSlow)
    /// ```
    "appro": Geometry "9.6.3", errors [162];
    function (point pPosition, trsf trTransformation) -> point;
}
