//! `setPayload`: describes the load that the arm carries on a tool.

use crate::declare::instruction;

instruction! {
    /// Describes the load that the arm carries on a tool.
    ///
    /// - `tTool`: the tool.
    /// - `nMass`: the mass of the load.
    /// - `trCentre`: the position of its centre of gravity.
    /// - `nInertia`: its moments of inertia; read only.
    ///
    /// On CS9 controllers.
    ///
    /// ## Example
    /// ```val3
    /// version s8.10
    /// tool tGripper
    /// num nInertia[6]
    ///   setPayload(tGripper,2.5,{0,0,80,0,0,0},nInertia)
    /// ```
    "setPayload": Additions, since 8;
    modifier (tool tTool, num nMass, trsf trCentre, num& nInertia[]);
}
