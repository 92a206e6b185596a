//! `isCompliant` (11.1.5): returns whether the arm yields to external forces.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns whether the arm yields to external forces.
    ///
    /// - Result: `true` during a compliant move.
    ///
    /// Moves are recorded before they are executed: call it before anything pushes the arm.
    ///
    /// ## Example
    /// ```val3
    /// point pEject
    /// tool tGripper
    /// mdesc mSlow
    /// dio doEject
    ///   movelf(pEject,tGripper,mSlow,0)
    ///   wait(isCompliant())
    ///   doEject=true
    /// ```
    "isCompliant": Options "11.1.5", role(Progress);
    function () -> bool = is_compliant;
}

fn is_compliant(call: &mut Call<'_>) -> bool {
    call.ports.is_compliant()
}
