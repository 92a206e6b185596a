//! `config` (9.7.6): returns the arm configuration at a joint position.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;
use crate::values::{ConfigValue, JointValue};

instruction! {
    /// Returns the configuration of the arm at a joint position.
    ///
    /// - `jPosition`: the position of each axis.
    /// - Result: shoulder, elbow and wrist (a SCARA arm: shoulder only), each with a definite side or sign.
    /// - Error 81: a position for another kind of arm.
    ///
    /// ## Example
    /// ```val3
    /// point pPick
    ///   pPick.config=config(herej())
    /// ```
    "config": Geometry "9.7.6", errors [81];
    function (joint jPosition) -> config = config;
}

fn config(call: &mut Call<'_>, joint: JointValue) -> Result<ConfigValue> {
    moves::check_arm(call)?;
    let joints = moves::to_arm(call, joint);
    Ok(ConfigValue::at(call.ports.arm(), &joints))
}
