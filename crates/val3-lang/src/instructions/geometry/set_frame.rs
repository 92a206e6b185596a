//! `setFrame` (9.4.4): computes a frame from three points.

use val3_geometry::{FrameError, chain};

use crate::call::{Call, FrameRef, PointRef, StoredValue, Var};
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::{LinkPlace, Memory, Place};
use crate::references;

instruction! {
    /// Computes a frame from three points.
    ///
    /// - `pOrigin`: its origin.
    /// - `pAxisOx`: a point on its x axis, on the positive side.
    /// - `pPlaneOxy`: a point of its xy plane, on the positive side of y.
    /// - `fResult`: receives the position, relative to its own reference frame. A frame without a reference is linked
    ///   to `world`.
    /// - Result: 0 done, -1 `pAxisOx` is too close to the origin, -2 `pPlaneOxy` is too close to the x axis.
    /// - Errors: 161 `world` was changed, 162 a point, 163 a frame that they refer to has no reference frame.
    ///
    /// ## Example
    /// ```val3
    /// point pTaught[3]
    /// frame fTable
    ///   if setFrame(pTaught[0],pTaught[1],pTaught[2],fTable)!=0
    ///     popUpMsg("Teach the three points farther apart")
    ///   endIf
    /// ```
    "setFrame": Geometry "9.4.4", errors [161, 162, 163];
    modifier (point pOrigin, point pAxisOx, point pPlaneOxy, frame& fResult) -> num = set_frame;
}

/// A frame without a father gets the father `world`, because `setFrame` is one of the ways to initialize a frame
/// (9.4.1).
fn set_frame(
    call: &mut Call<'_>,
    origin: PointRef,
    on_x: PointRef,
    on_plane: PointRef,
    frame: Var<FrameRef>,
) -> Result<f64> {
    let father = references::reference(call.memory, frame.place)?.unwrap_or(Place::first(Memory::WORLD));
    let reference = references::of_frame(call.memory, FrameRef(father))?;
    let seen = |point| references::of_point(call.memory, point).map(|point| chain::position(&point, &reference));
    let found = val3_geometry::set_frame(&seen(origin)?, &seen(on_x)?, &seen(on_plane)?);
    match found {
        Ok(trsf) => {
            trsf.write(call.memory, frame.place)?;
            call.memory.set_link(frame.place, 0, LinkPlace::Data(father))?;
            Ok(0.0)
        }
        Err(FrameError::AxisPoint) => Ok(-1.0),
        Err(FrameError::PlanePoint) => Ok(-2.0),
    }
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    /// Three points in `world`, and an unlinked frame.
    fn bench() -> Bench {
        let mut bench = Bench::default().global("point pTaught[3]; frame fCell").local("frame l_fTable");
        let [origin, on_x, on_plane] = [[100.0, 50.0, 10.0], [100.0, 80.0, 10.0], [60.0, 500.0, 10.0]];
        let turned = [12.0, 34.0, 56.0, 0.0, 0.0, 0.0];
        bench.set("pTaught", &[&origin[..], &turned, &on_x, &turned, &on_plane, &turned].concat());
        bench.set("fCell", &[100.0, 0.0, 0.0, 0.0, 0.0, 90.0]);
        for line in ["link(pTaught[0],world)", "link(pTaught[1],world)", "link(pTaught[2],world)", "link(fCell,world)"]
        {
            bench.run(line);
        }
        bench
    }

    const LINE: &str = "setFrame(pTaught[0],pTaught[1],pTaught[2],l_fTable)";

    #[test]
    fn a_frame_is_given_in_its_reference() {
        let mut bench = bench();
        bench.run("link(l_fTable,fCell)");
        assert_eq!([bench.run(LINE), bench.show("l_fTable")], ["0", "{50,0,10,0,0,0}"]);
        assert_eq!(bench.run("position(l_fTable,world)"), "{100,50,10,0,0,90}");
    }

    #[test]
    fn a_frame_without_reference_is_given_in_world() {
        let mut bench = bench();
        assert_eq!(bench.run("position(l_fTable,world)"), "error 163");
        assert_eq!([bench.run(LINE), bench.show("l_fTable")], ["0", "{100,50,10,0,0,90}"]);
        assert_eq!(bench.run("position(l_fTable,fCell)"), "{50,0,10,0,0,0}");
    }

    #[test]
    fn nothing_changes_where_points_make_no_frame() {
        let mut bench = bench();
        assert_eq!(bench.run("setFrame(pTaught[0],pTaught[0],pTaught[2],l_fTable)"), "-1");
        assert_eq!(bench.run("setFrame(pTaught[0],pTaught[1],pTaught[1],l_fTable)"), "-2");
        assert_eq!([bench.show("l_fTable"), bench.run("position(l_fTable,world)")], ["{0,0,0,0,0,0}", "error 163"]);
    }

    #[test]
    fn points_need_a_reference_and_world_its_place() {
        let mut bench = bench().local("point l_pOther");
        assert_eq!(bench.run("setFrame(pTaught[0],pTaught[1],l_pOther,l_fTable)"), "error 162");
        bench.run("link(l_pOther,l_fTable)");
        assert_eq!(bench.run("setFrame(pTaught[0],pTaught[1],l_pOther,fCell)"), "error 163");
        bench.set("world", &[1.0]);
        assert_eq!(bench.run(LINE), "error 161");
    }
}
