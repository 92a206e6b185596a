use crate::declare::instruction;

instruction! {
    /// Tells whether a joint position lies within the software limits of every axis.
    ///
    /// - `jPosition`: the position.
    /// - Result: `true` if the arm may go there.
    ///
    /// An arm that is outside its limits can only be jogged back.
    ///
    /// ## Example
    /// ```val3
    /// joint jTarget
    /// tool tGripper
    /// mdesc mSlow
    ///   if isInRange(jTarget)
    ///     movej(jTarget,tGripper,mSlow)
    ///   endIf
    /// ```
    "isInRange": Geometry "9.2.3";
    function (joint jPosition) -> bool;
}
