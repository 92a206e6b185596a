//! `alterMovej` (11.2.6): records a joint move that `alter` can deviate.

use crate::declare::instruction;

instruction! {
    /// Records a joint move that `alter` can deviate.
    ///
    /// - `jPosition`, `pPosition`: the target. A configuration cannot be asked for: the arm keeps its own.
    /// - `tTool`, `mDesc`: as for `movej`.
    /// - Result: the id of the move.
    /// - Errors: as for `movej`, and 250 without the alter licence.
    ///
    /// Such moves in a row make one alterable path. A move without any way is ignored.
    ///
    /// ## Example
    /// ```val3
    /// joint jEnd
    /// tool tGripper
    /// mdesc mSlow
    ///   alterMovej(jEnd,tGripper,mSlow)
    ///   alterBegin(world,mSlow)
    /// ```
    "alterMovej": Options "11.2.6", blocking, errors [81, 100, 101, 102, 103, 104, 105, 106, 150, 154, 250];
    modifier (joint jPosition, tool tTool, mdesc mDesc) -> num;
    modifier (point pPosition, tool tTool, mdesc mDesc) -> num;
}
