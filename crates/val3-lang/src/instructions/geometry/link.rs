use crate::declare::instruction;

instruction! {
    /// Gives a frame, a tool or a point another reference.
    ///
    /// - `fFrame`, `tTool`, `pPoint`: what is linked. Its own coordinates stay, so it moves in space.
    /// - `fReference`, `tReference`: the new reference frame or tool.
    /// - Error 165: a global variable cannot refer to a local one.
    ///
    /// Local variables and fields of user types have no reference before they get one here, by `=`, or from an
    /// instruction that yields a point.
    ///
    /// ## Example
    /// ```val3
    /// program nearTable()
    ///   point l_pNear
    /// begin
    ///   link(l_pNear,world)
    ///   l_pNear.trsf={400,0,300,0,180,0}
    ///   putln(distance(l_pNear,here(flange,world)))
    /// end
    ///   call nearTable()
    /// ```
    "link": Geometry "9.4.4, 9.5.4, 9.6.3", errors [165];
    modifier (frame fFrame, frame fReference);
    modifier (tool tTool, tool tReference);
    modifier (point pPoint, frame fReference);
}
