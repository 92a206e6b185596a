//! `compose` (9.6.3): moves a point by a transformation in any frame.

use val3_geometry::{Trsf, chain};

use crate::call::{Call, FrameRef, PointRef, PointValue, StoredValue};
use crate::declare::instruction;
use crate::fault::{Fault, Result};
use crate::references;

instruction! {
    /// Moves a point by a transformation that is given in any frame.
    ///
    /// - `pPosition`: the point.
    /// - `fReference`: the frame to which the transformation relates.
    /// - `trTransformation`: translation and rotation about the origin of that frame. A rotation therefore moves the
    ///   point as well, unless the point lies at the origin.
    /// - Result: the new point, with frame and configuration of `pPosition`.
    /// - Errors: 162 the point, 163 a frame has no reference frame.
    ///
    /// `appro` moves a point in its own orientation.
    ///
    /// ## Example
    /// ```val3
    /// point pPick
    /// point pNext
    /// frame fTable
    ///   pNext=compose(pPick,fTable,{0,60,0,0,0,0})
    /// ```
    "compose": Geometry "9.6.3", errors [162, 163];
    function (point pPosition, frame fReference, trsf trTransformation) -> point = compose;
}

fn compose(call: &mut Call<'_>, point: PointRef, reference: FrameRef, transformation: Trsf) -> Result<PointValue> {
    let place = references::of_point(call.memory, point)?;
    let reference = references::of_frame(call.memory, reference)?;
    let trsf = chain::compose(&place, &reference, &transformation).ok_or(Fault::INTERPRETER)?;
    Ok(PointValue { trsf, ..PointValue::read(call.memory, point.0)? })
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    fn bench() -> Bench {
        let mut bench = Bench::default().global("frame fTable; point pPick; point pNext").local("frame l_fOther");
        bench.set("pPick", &[100.0, 0.0, 5.0, 180.0, 0.0, 0.0, 2.0, 3.0, 1.0]);
        bench.set("fTable", &[100.0, 0.0, 0.0, 0.0, 0.0, 90.0]);
        for line in ["link(fTable,world)", "link(pPick,world)"] {
            bench.run(line);
        }
        bench
    }

    #[test]
    fn a_rotation_moves_a_point_about_the_frame() {
        let mut bench = bench();
        assert_eq!(bench.run("compose(pPick,world,{0,0,0,0,0,90})"), "{0,100,5,180,0,-90}");
        assert_eq!(bench.run("compose(pPick,fTable,{0,0,0,0,0,90})"), "{100,0,5,180,0,-90}");
    }

    #[test]
    fn a_translation_moves_a_point_along_the_frame() {
        assert_eq!(bench().run("compose(pPick,fTable,{10,0,0,0,0,0})"), "{100,10,5,180,0,0}");
    }

    #[test]
    fn frame_and_configuration_are_those_of_the_point() {
        let mut bench = bench();
        bench.run("link(pPick,fTable)");
        assert_eq!(bench.run("pNext=compose(pPick,world,{0,10,0,0,0,0})"), "{110,0,5,180,0,0}");
        assert_eq!(bench.numbers("pNext")[6..], [2.0, 3.0, 1.0]);
        assert_eq!(bench.run("position(pNext,world)"), "{100,110,5,180,0,-90}");
    }

    #[test]
    fn both_need_a_reference() {
        let mut bench = bench();
        assert_eq!(bench.run("compose(pNext,world,{0,0,0,0,0,0})"), "error 162");
        assert_eq!(bench.run("compose(pPick,l_fOther,{0,0,0,0,0,0})"), "error 163");
    }
}
