use crate::call::{Call, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::references;

instruction! {
    /// Gives the speed of a tool centre point.
    ///
    /// - `tTool`: the tool.
    /// - Result: millimetres (inches) per second, computed from the commanded speed of the axes.
    /// - Error 164: the tool has no reference tool.
    ///
    /// ## Example
    /// ```val3
    /// tool tTorch
    /// aio aiWire
    ///   aioSet(aiWire,getSpeed(tTorch)/100)
    /// ```
    "getSpeed": Motion "10.6", errors [164];
    function (tool tTool) -> num = speed;
}

fn speed(call: &mut Call<'_>, tool: ToolRef) -> Result<f64> {
    let way = references::of_tool(call.memory, tool)?;
    Ok(call.ports.speed(&way))
}
