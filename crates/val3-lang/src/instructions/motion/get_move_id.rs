//! `getMoveId` (10.6): returns the id of the move that the arm executes.

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Returns the id of the move that the arm executes.
    ///
    /// - Result: the id of the present move plus the part of it that is done: 17.572 is move 17, 57.2 % of it done.
    ///   When the last move is done, its id plus 1.
    ///
    /// Compare it with `>=`, never with `==`: the number steps over values.
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
