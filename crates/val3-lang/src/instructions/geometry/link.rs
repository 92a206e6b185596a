//! `link`: changes the father of a frame, a tool or a point.

use crate::call::{Call, FrameRef, PointRef, ToolRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::LinkPlace;

instruction! {
    /// Changes the reference of a frame, a tool or a point.
    ///
    /// - `fFrame`, `tTool`, `pPoint`: the linked variable. Its own coordinates do not change, so it moves in space.
    /// - `fReference`, `tReference`: the new reference frame or tool.
    /// - Error 165: a global variable cannot refer to a local one.
    ///
    /// Local variables and fields of user types have no reference until this instruction, `=`, or an instruction that
    /// returns a point sets one.
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
    modifier (frame fFrame, frame fReference) = frame;
    modifier (tool tTool, tool tReference) = tool;
    modifier (point pPoint, frame fReference) = point;
}

fn frame(call: &mut Call<'_>, FrameRef(frame): FrameRef, FrameRef(reference): FrameRef) -> Result<()> {
    call.memory.set_link(frame, 0, LinkPlace::Data(reference))
}

fn tool(call: &mut Call<'_>, ToolRef(tool): ToolRef, ToolRef(reference): ToolRef) -> Result<()> {
    call.memory.set_link(tool, 0, LinkPlace::Data(reference))
}

fn point(call: &mut Call<'_>, PointRef(point): PointRef, FrameRef(reference): FrameRef) -> Result<()> {
    call.memory.set_link(point, 0, LinkPlace::Data(reference))
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    #[test]
    fn coordinates_stay() {
        let mut bench = Bench::default().global("frame fTable[2]; point pPick[2]").with("pPick", &[1.0, 2.0, 3.0]);
        bench.set("fTable", &[0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 10.0]);
        for line in ["link(fTable[1],world)", "link(pPick[0],fTable[1])"] {
            assert_eq!(bench.run(line), "");
        }
        assert_eq!(bench.show("pPick"), "{1,2,3,0,0,0}, {0,0,0,0,0,0}");
        assert_eq!(bench.run("position(pPick[0],world)"), "{11,2,3,0,0,0}");
        bench.run("link(pPick[0],world)");
        assert_eq!(bench.run("position(pPick[0],world)"), "{1,2,3,0,0,0}");
    }

    #[test]
    fn a_place_follows_its_reference() {
        let mut bench = Bench::default().global("tool tHand; tool tTip");
        for line in ["link(tHand,flange)", "link(tTip,tHand)"] {
            bench.run(line);
        }
        bench.set("tHand", &[0.0, 0.0, 100.0]);
        assert_eq!(bench.run("position(tTip,flange)"), "{0,0,100,0,0,0}");
    }

    #[test]
    fn a_global_cannot_refer_to_a_local() {
        let globals = "frame fA; tool tA; point pA";
        let mut bench = Bench::default().global(globals).local("frame l_fA; tool l_tA; point l_pA");
        for line in ["link(fA,l_fA)", "link(tA,l_tA)", "link(pA,l_fA)"] {
            assert_eq!(bench.run(line), "error 165", "{line}");
        }
        for line in ["link(l_fA,fA)", "link(l_tA,tA)", "link(l_pA,fA)", "link(l_pA,l_fA)"] {
            assert_eq!(bench.run(line), "", "{line}");
        }
    }
}
