//! `getSpeed` (10.6): returns the speed of a tool centre point.

use crate::call::{Call, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::moves;

instruction! {
    /// Returns the speed of a tool centre point.
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
    let tool = moves::pose_of_tool(call, tool)?;
    Ok(call.ports.speed(&tool) / call.unit.millimetres())
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;
    use crate::types::LengthUnit;

    #[test]
    fn lengths_are_the_application_s() {
        for (unit, expected) in [(LengthUnit::Millimetre, "75.4"), (LengthUnit::Inch, "51")] {
            let mut bench = Bench::default().global("tool tTorch");
            bench.unit = unit;
            bench.run("link(tTorch,flange)");
            bench.set("tTorch", &[50.0]);
            assert_eq!(bench.run("getSpeed(tTorch)"), expected);
        }
    }
}
