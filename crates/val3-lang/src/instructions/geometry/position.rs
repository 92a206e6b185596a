use crate::declare::instruction;

instruction! {
    /// Gives where a frame, a tool or a point lies, seen from another frame or tool.
    ///
    /// - `fFrame`, `tTool`, `pPosition`: what is looked at.
    /// - `fReference`, `tReference`: from where; `world` or `flange` for the absolute position.
    /// - Result: the transformation from the reference to it, millimetres (inches) and degrees.
    /// - Errors: 160 `flange` was changed, 161 `world` was changed, 162 the point, 163 a frame, 164 a tool has no
    ///   reference of its own.
    ///
    /// ## Example
    /// ```val3
    /// point pPick
    /// frame fTable
    /// trsf trPick
    ///   trPick=position(pPick,fTable)
    /// ```
    "position": Geometry "9.4.4, 9.5.4, 9.6.3", errors [160, 161, 162, 163, 164];
    function (frame fFrame, frame fReference) -> trsf;
    function (tool tTool, tool tReference) -> trsf;
    function (point pPosition, frame fReference) -> trsf;
}
