//! `interpolateC` (9.3.4): returns a position on the arc through three positions.

use val3_geometry::Trsf;

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::{Fault, Result};

instruction! {
    /// Returns a position on the arc through three positions.
    ///
    /// - `trStart`, `trIntermediate`, `trEnd`: the arc, all given in the same frame.
    /// - `nPosition`: 0 is the start, 1 the end, 0.5 the middle of the arc; less than 0 lies before the start, more
    ///   than 1 after the end.
    /// - Result: the position; its orientation changes as during a `movec`.
    /// - Error 70: the positions are too close to each other for an arc, or the orientation between them is ambiguous.
    ///
    /// ## Example
    /// ```val3
    /// trsf trMiddle
    /// point pArc[3]
    ///   trMiddle=interpolateC(pArc[0].trsf,pArc[1].trsf,pArc[2].trsf,0.5)
    /// ```
    "interpolateC": Geometry "9.3.4", errors [70];
    function (trsf trStart, trsf trIntermediate, trsf trEnd, num nPosition) -> trsf = interpolate_c;
}

fn interpolate_c(_: &mut Call<'_>, start: Trsf, intermediate: Trsf, end: Trsf, position: f64) -> Result<Trsf> {
    val3_geometry::interpolate_c(&start, &intermediate, &end, position).map_err(|_| Fault::INVALID_PARAMETER)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("interpolateC({600,200,0,0,0,0},{500,300,0,0,0,0},{400,200,0,0,0,0},0)", "{600,200,0,0,0,0}");
        check("interpolateC({600,200,0,0,0,0},{500,300,0,0,0,0},{400,200,0,0,0,0},1)", "{400,200,0,0,0,0}");
        check("interpolateC({600,200,0,0,0,0},{500,300,0,0,0,0},{400,200,0,0,0,0},0.5)", "{500,300,0,0,0,0}");
        check("interpolateC({600,200,0,0,0,0},{500,300,0,0,0,0},{400,200,0,0,0,0},1.5)", "{500,100,0,0,0,0}");
        check("interpolateC({600,200,0,0,0,0},{500,300,0,0,0,0},{400,200,0,0,0,0},2)", "error 70");
        check("interpolateC({0,0,0,0,0,0},{1,0,0,0,0,0},{2,0,0,0,0,0},0.5)", "error 70");
        check("interpolateC({0,0,0,0,0,0},{0,0,0,0,0,0},{2,0,0,0,0,0},0)", "error 70");
        check("interpolateC({100,0,0,0,0,0},{0,100,0,180,0,0},{-100,0,0,0,0,0},0.5)", "error 70");
    }
}
