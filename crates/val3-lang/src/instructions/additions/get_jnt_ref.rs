//! `getJntRef`: returns a reference position of the arm by name.

use crate::call::Call;
use crate::declare::instruction;
use crate::moves;
use crate::values::{JointValue, Text};

instruction! {
    /// Returns a reference position of the arm by its name.
    ///
    /// - `sName`: the name of the reference position.
    /// - Result: the position of each axis.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    /// joint jSafe
    ///   jSafe=getJntRef("safeRef")
    /// ```
    "getJntRef": Additions, since 8;
    function (string sName) -> joint = reference;
}

fn reference(call: &mut Call<'_>, name: Text) -> JointValue {
    let reference = call.ports.reference_position(&name);
    moves::of_arm(call, reference)
}
