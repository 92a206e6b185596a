//! `appro` (9.6.3): returns a point near another point, along that point's axes.

use val3_geometry::Trsf;

use crate::call::{Call, PointRef, PointValue, StoredValue};
use crate::declare::instruction;
use crate::fault::Result;
use crate::references;

instruction! {
    /// Returns a point near another point, along that point's axes.
    ///
    /// - `pPosition`: the point.
    /// - `trTransformation`: the position of the result relative to the point: if the z axis of the tool points at the
    ///   part, a negative z is above the part.
    /// - Result: the new point, with frame and configuration of `pPosition`.
    /// - Error 162: the point has no reference frame.
    ///
    /// ## Example
    /// ```val3
    /// tool tGripper
    /// point pPick
    /// mdesc mFast
    /// mdesc mSlow
    ///   movej(appro(pPick,{0,0,-100,0,0,0}),tGripper,mFast)
    ///   movel(pPick,tGripper,mSlow)
    /// ```
    "appro": Geometry "9.6.3", errors [162];
    function (point pPosition, trsf trTransformation) -> point = appro;
}

fn appro(call: &mut Call<'_>, point: PointRef, transformation: Trsf) -> Result<PointValue> {
    references::frame_of(call.memory, point)?;
    let near = PointValue::read(call.memory, point.0)?;
    Ok(PointValue { trsf: near.trsf * transformation, ..near })
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    fn bench() -> Bench {
        let mut bench = Bench::default().global("frame fTable; point pPick; point pNear; point pFree");
        bench.set("pPick", &[400.0, 0.0, 300.0, 180.0, 0.0, 0.0, 2.0, 3.0, 1.0]);
        bench.set("fTable", &[0.0, 0.0, 50.0]);
        for line in ["link(fTable,world)", "link(pPick,fTable)"] {
            bench.run(line);
        }
        bench
    }

    /// Example of the manual: 100 mm above a point at which the tool points down.
    #[test]
    fn goes_along_the_axes_of_the_point() {
        let mut bench = bench();
        assert_eq!(bench.run("pNear=appro(pPick,{0,0,-100,0,0,0})"), "{400,0,400,180,0,0}");
        assert_eq!(bench.numbers("pNear")[6..], [2.0, 3.0, 1.0]);
        assert_eq!(bench.run("position(pNear,world)"), "{400,0,450,180,0,0}");
        assert_eq!(bench.run("appro(pPick,{0,0,0,0,0,90})"), "{400,0,300,180,0,90}");
    }

    #[test]
    fn a_point_needs_a_reference() {
        assert_eq!(bench().run("appro(pFree,{0,0,-100,0,0,0})"), "error 162");
    }
}
