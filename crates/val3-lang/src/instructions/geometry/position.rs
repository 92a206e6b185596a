//! `position`: returns the position of a frame, a tool or a point relative to another frame or tool.

use val3_geometry::{Trsf, chain};

use crate::call::{Call, FrameRef, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::references;

instruction! {
    /// Returns the position of a frame, a tool or a point relative to another frame or tool.
    ///
    /// - `fFrame`, `tTool`, `pPosition`: the frame, tool or point.
    /// - `fReference`, `tReference`: the reference; `world` or `flange` for the absolute position.
    /// - Result: the transformation from the reference to it, in millimetres (inches) and degrees.
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
    function (frame fFrame, frame fReference) -> trsf = of_frame;
    function (tool tTool, tool tReference) -> trsf = of_tool;
    function (point pPosition, frame fReference) -> trsf = of_point;
}

fn of_frame(call: &mut Call<'_>, frame: FrameRef, reference: FrameRef) -> Result<Trsf> {
    let place = references::of_frame(call.memory, frame)?;
    Ok(chain::position(&place, &references::of_frame(call.memory, reference)?))
}

fn of_tool(call: &mut Call<'_>, tool: ToolRef, reference: ToolRef) -> Result<Trsf> {
    let place = references::of_tool(call.memory, tool)?;
    Ok(chain::position(&place, &references::of_tool(call.memory, reference)?))
}

fn of_point(call: &mut Call<'_>, point: PointRef, reference: FrameRef) -> Result<Trsf> {
    let place = references::of_point(call.memory, point)?;
    Ok(chain::position(&place, &references::of_frame(call.memory, reference)?))
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    fn bench() -> Bench {
        let mut bench = Bench::default().global("frame fCell; frame fTable; point pPick; tool tHand; tool tTip");
        bench.set("fCell", &[500.0, 0.0, 100.0, 0.0, 0.0, 90.0]);
        bench.set("fTable", &[10.0, 20.0, 0.0, 0.0, 0.0, 90.0]);
        bench.set("pPick", &[0.1, 0.2, 0.3, 180.0, 0.0, 33.3]);
        bench.set("tHand", &[0.0, 0.0, 100.0, 0.0, 0.0, 90.0]);
        bench.set("tTip", &[10.0, 0.0, 50.0]);
        bench
    }

    fn linked() -> Bench {
        let mut bench = bench();
        for (place, reference) in
            [("fCell", "world"), ("fTable", "fCell"), ("pPick", "fTable"), ("tHand", "flange"), ("tTip", "tHand")]
        {
            bench.run(&format!("link({place},{reference})"));
        }
        bench
    }

    #[test]
    fn of_frames() {
        let mut bench = linked();
        assert_eq!(bench.run("position(fTable,world)"), "{480,10,100,0,0,180}");
        assert_eq!(bench.run("position(fTable,fCell)"), "{10,20,0,0,0,90}");
        assert_eq!(bench.run("position(fCell,fTable)"), "{-20,10,0,0,0,-90}");
        assert_eq!(bench.run("position(world,world)"), "{0,0,0,0,0,0}");
    }

    #[test]
    fn of_tools() {
        let mut bench = linked();
        assert_eq!(bench.run("position(tTip,flange)"), "{0,10,150,0,0,90}");
        assert_eq!(bench.run("position(tTip,tHand)"), "{10,0,50,0,0,0}");
        assert_eq!(bench.run("position(flange,tTip)"), "{-10,0,-150,0,0,-90}");
    }

    /// The position of a point relative to its father has the point's own values. The distance of two points is the
    /// distance of their positions.
    #[test]
    fn of_points() {
        let mut bench = linked();
        assert_eq!(bench.run("position(pPick,fTable)"), "{0.1,0.2,0.3,180,0,33.3}");
        assert_eq!(bench.run("position(pPick,world)"), "{479.9,9.8,100.3,180,0,-146.7}");
        let mut bench = bench.global("point pNext; trsf tr1; trsf tr2");
        bench.run("link(pNext,fCell)");
        bench.run("tr1=position(pPick,world)");
        bench.run("tr2=position(pNext,world)");
        assert_eq!(bench.run("distance(tr1,tr2)"), bench.run("distance(pPick,pNext)"));
    }

    #[test]
    fn everything_needs_its_reference() {
        let mut bench = bench();
        assert_eq!(bench.run("position(pPick,world)"), "error 162");
        assert_eq!(bench.run("position(fTable,world)"), "error 163");
        assert_eq!(bench.run("position(world,fTable)"), "error 163");
        assert_eq!(bench.run("position(tTip,flange)"), "error 164");
        bench.run("link(pPick,fTable)");
        assert_eq!(bench.run("position(pPick,fTable)"), "error 163");
    }

    #[test]
    fn world_and_flange_keep_their_place() {
        let mut bench = linked();
        bench.set("world", &[0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
        assert_eq!(
            [bench.run("position(pPick,fTable)"), bench.run("position(world,world)")],
            ["error 161", "error 161"]
        );
        bench.set("flange", &[1.0]);
        assert_eq!(bench.run("position(tTip,flange)"), "error 160");
    }
}
