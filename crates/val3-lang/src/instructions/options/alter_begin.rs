//! `alterBegin` (11.2.6): starts the deviation of the alterable path that the arm is on.

use crate::declare::instruction;

instruction! {
    /// Starts the deviation of the alterable path that the arm is on.
    ///
    /// - `fAlterReference`: the deviation is meant in this frame, fixed in space: for a part that moves.
    /// - `tAlterReference`: the deviation is meant in this tool: for a sensor on the tool.
    /// - `mMaxVelocity`: its `vel`, `tvel` and `rvel` bound the deviated motion; to exceed them is an error and stops
    ///   the arm. Its `accel` and `decel` bound the stop of the deviation.
    /// - Result: 1 started, 0 waits for the path to start, -1 started already, -2 no alter option, -3 a motion error:
    ///   `resetMotion` is needed.
    ///
    /// ## Example
    /// ```val3
    /// point pEnd
    /// tool tGripper
    /// mdesc mSlow
    ///   alterMovel(pEnd,tGripper,mSlow)
    ///   wait(alterBegin(world,mSlow)==1)
    /// ```
    "alterBegin": Options "11.2.6";
    modifier (frame fAlterReference, mdesc mMaxVelocity) -> num;
    modifier (tool tAlterReference, mdesc mMaxVelocity) -> num;
}
