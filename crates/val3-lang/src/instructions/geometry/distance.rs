//! `distance`: returns the distance between two positions.

use val3_geometry::{Trsf, chain};

use crate::call::{Call, PointRef};
use crate::declare::instruction;
use crate::fault::Result;
use crate::references;

instruction! {
    /// Returns the distance between two positions.
    ///
    /// - `trPosition1`, `trPosition2`: two transformations, given in the same frame.
    /// - `pPosition1`, `pPosition2`: two points, in any frames.
    /// - Result: millimetres (inches), always 0 or more; the orientation is ignored.
    /// - Error 162: a point has no reference frame.
    ///
    /// ## Example
    /// ```val3
    /// point pTarget
    /// tool tGripper
    ///   wait(distance(here(tGripper,world),pTarget)<10)
    /// ```
    "distance": Geometry "9.3.4, 9.6.3", errors [162];
    function (trsf trPosition1, trsf trPosition2) -> num = of_positions;
    function (point pPosition1, point pPosition2) -> num = of_points;
}

fn of_positions(_: &mut Call<'_>, left: Trsf, right: Trsf) -> f64 {
    left.distance(&right)
}

fn of_points(call: &mut Call<'_>, left: PointRef, right: PointRef) -> Result<f64> {
    let (left, right) = (references::of_point(call.memory, left)?, references::of_point(call.memory, right)?);
    Ok(chain::distance(&left, &right))
}

#[cfg(test)]
mod tests {
    use crate::testing::{Bench, check};

    #[test]
    fn of_positions() {
        check("distance({1,2,3,0,0,0},{4,6,15,10,20,30})", "13");
    }

    /// First example of the manual.
    #[test]
    fn of_two_tools() {
        let mut bench = Bench::default().global("tool tTool1; tool tTool2; trsf tr1; trsf tr2");
        bench.set("tTool1", &[0.0, 0.0, 100.0]);
        bench.set("tTool2", &[30.0, 40.0, 100.0]);
        for line in ["link(tTool1,flange)", "link(tTool2,tTool1)"] {
            bench.run(line);
        }
        bench.run("tr1=position(tTool1,flange)");
        bench.run("tr2=position(tTool2,flange)");
        assert_eq!(bench.run("distance(tr1,tr2)"), "111.80339887499");
    }

    /// Only positions are composed, so that an orientation with invalid numbers does not affect the distance.
    #[test]
    fn the_orientation_of_points_does_not_count() {
        let mut bench = Bench::default().global("frame fTable; point pA; point pB");
        for line in ["link(fTable,world)", "link(pA,fTable)", "link(pB,world)"] {
            bench.run(line);
        }
        bench.set("fTable", &[100.0, 0.0, 0.0, 0.0, 0.0, 90.0]);
        bench.set("pA", &[10.0, 0.0, 0.0, f64::INFINITY, 0.0, 45.0]);
        bench.set("pB", &[100.0, 10.0, 7.0, 0.0, f64::NAN, 0.0]);
        assert_eq!(bench.run("distance(pA,pB)"), "7");
    }

    #[test]
    fn of_points_in_two_frames() {
        let mut bench = Bench::default().global("frame fTable; point pA; point pB");
        bench.set("fTable", &[100.0, 0.0, 0.0, 0.0, 0.0, 90.0]);
        bench.set("pA", &[10.0, 0.0, 0.0]);
        assert_eq!(bench.run("distance(pA,pB)"), "error 162");
        for line in ["link(fTable,world)", "link(pA,fTable)"] {
            bench.run(line);
        }
        assert_eq!(bench.run("distance(pA,pB)"), "error 162");
        bench.run("link(pB,world)");
        bench.set("pB", &[100.0, 10.0, 7.0]);
        assert_eq!(bench.run("distance(pA,pB)"), "7");
    }
}
