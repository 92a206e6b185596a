//! `interpolateL` (9.3.4): returns a position on the straight line between two positions.

use val3_geometry::Trsf;

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::{Fault, Result};

instruction! {
    /// Returns a position on the straight line between two positions.
    ///
    /// - `trStart`, `trEnd`: the ends, given in the same frame.
    /// - `nPosition`: 0 is the start, 1 the end, 0.5 the middle; above -1 and below 2, so that the line continues
    ///   beyond its ends.
    /// - Result: the position; its orientation changes between the two orientations as during a `movel`.
    /// - Error 70: `nPosition` is out of its range.
    ///
    /// ## Example
    /// ```val3
    /// trsf trMiddle
    /// point pFirst
    /// point pLast
    ///   trMiddle=interpolateL(pFirst.trsf,pLast.trsf,0.5)
    /// ```
    "interpolateL": Geometry "9.3.4", errors [70];
    function (trsf trStart, trsf trEnd, num nPosition) -> trsf = interpolate_l;
}

fn interpolate_l(_: &mut Call<'_>, start: Trsf, end: Trsf, position: f64) -> Result<Trsf> {
    val3_geometry::interpolate_l(&start, &end, position).map_err(|_| Fault::INVALID_PARAMETER)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("interpolateL({0,0,0,0,0,30},{100,20,0,0,0,90},0)", "{0,0,0,0,0,30}");
        check("interpolateL({0,0,0,0,0,30},{100,20,0,0,0,90},1)", "{100,20,0,0,0,90}");
        check("interpolateL({0,0,0,0,0,30},{100,20,0,0,0,90},0.5)", "{50,10,0,0,0,60}");
        check("interpolateL({0,0,0,0,0,30},{100,20,0,0,0,90},-0.5)", "{-50,-10,0,0,0,0}");
        check("interpolateL({0,0,0,0,0,30},{100,20,0,0,0,90},1.5)", "{150,30,0,0,0,120}");
        check("interpolateL({0,0,0,0,0,30},{100,20,0,0,0,90},-1)", "error 70");
        check("interpolateL({0,0,0,0,0,30},{100,20,0,0,0,90},2)", "error 70");
    }
}
