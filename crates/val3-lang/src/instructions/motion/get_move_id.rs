//! `getMoveId` (10.6): returns the id of the move that the arm executes.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the id of the move that the arm executes.
    ///
    /// - Result: the id of the current move plus its completed fraction: 17.572 means that 57.2 % of move 17 is done.
    ///   After the last move, its id plus 1.
    ///
    /// Compare it with `>=`, never with `==`: the number skips values.
    ///
    /// ## Example
    /// ```val3
    /// point pPlace
    /// tool tGripper
    /// mdesc mFast
    /// num nPlace
    /// dio doGlue
    ///   nPlace=movel(pPlace,tGripper,mFast)
    ///   wait(getMoveId()>=nPlace+0.5)
    ///   doGlue=true
    /// ```
    "getMoveId": Motion "10.6", role(Progress);
    function () -> num = move_id;
}

fn move_id(call: &mut Call<'_>) -> f64 {
    call.ports.move_id()
}
