//! `resetTurn` (11.5.2): forgets the turns of a continuous axis, after the arm has stopped and its moves are cancelled.

use crate::declare::instruction;

instruction! {
    /// Forgets the turns of a continuous axis, after the arm has stopped and its moves are cancelled.
    ///
    /// - `jReference`: the axis gets the position nearest to this one: 720 degrees can become 0.
    /// - Result: the position of the arm then.
    /// - Error 250: no licence for continuous axes.
    ///
    /// It stops and cancels as `resetMotion` does, works with and without power and takes about 50 ms. Axis 6 of a
    /// six-axis arm, axis 4 of a SCARA arm.
    ///
    /// ## Example
    /// ```val3
    /// joint jStart
    ///   waitEndMove()
    ///   resetTurn(jStart)
    /// ```
    "resetTurn": Options "11.5.2", blocking, errors [250];
    modifier (joint jReference) -> joint;
}
