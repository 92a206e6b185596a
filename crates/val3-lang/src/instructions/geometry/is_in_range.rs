//! `isInRange` (9.2.3): returns whether a joint position lies within the software limits of every axis.

use crate::call::Call;
use crate::declare::instruction;
use crate::moves;
use crate::values::JointValue;

instruction! {
    /// Returns whether a joint position lies within the software limits of every axis.
    ///
    /// - `jPosition`: the position.
    /// - Result: `true` if the arm may move there.
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
    function (joint jPosition) -> bool = is_in_range;
}

fn is_in_range(call: &mut Call<'_>, position: JointValue) -> bool {
    let joints = moves::to_arm(call, position);
    call.ports.arm().is_in_range(&joints)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn every_axis_counts() {
        check("isInRange({0,0,90,0,0,-270})", "true");
        check("isInRange({0,0,90,0,0,-270.5})", "false");
    }
}
