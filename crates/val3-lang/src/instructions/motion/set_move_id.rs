//! `setMoveId` (10.6): sets the id of the next move.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Sets the id of the next move.
    ///
    /// - `nMoveId`: the id; it must differ from the ids of all moves that are not done yet.
    /// - Result: a number without a documented meaning.
    ///
    /// The ids of the following moves count up by 1. `resetMotion` sets the id back to 0.
    ///
    /// ## Example
    /// ```val3
    /// point pFirst
    /// tool tGripper
    /// mdesc mFast
    ///   resetMotion()
    ///   setMoveId(1000)
    ///   movel(pFirst,tGripper,mFast)
    /// ```
    "setMoveId": Motion "10.6";
    modifier (num nMoveId) -> num = set_id;
}

/// Returns the id, because the manual does not define the result.
fn set_id(call: &mut Call<'_>, id: f64) -> f64 {
    call.ports.set_move_id(id);
    id
}
