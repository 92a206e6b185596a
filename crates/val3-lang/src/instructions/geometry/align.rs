//! `align` (9.3.4): rotates a position so that its z axis is parallel to an axis of a reference.

use val3_geometry::Trsf;

use crate::call::Call;
use crate::declare::instruction;

instruction! {
    /// Rotates a position so that its z axis is parallel to an axis of a reference.
    ///
    /// - `trPosition`: the position; its x, y and z do not change.
    /// - `trReference`: only its orientation is used.
    /// - Result: `trPosition`, rotated so that its z axis points along the nearest axis of the reference.
    ///
    /// ## Example
    /// ```val3
    /// trsf trPick
    /// trsf trTable
    ///   trPick=align(trPick,trTable)
    /// ```
    "align": Geometry "9.3.4";
    function (trsf trPosition, trsf trReference) -> trsf = align;
}

fn align(_: &mut Call<'_>, position: Trsf, reference: Trsf) -> Trsf {
    val3_geometry::align(&position, &reference)
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn results() {
        check("align({1,2,3,10,0,0},{7,8,9,0,0,0})", "{1,2,3,0,0,0}");
        check("align({1,2,3,80,0,25},{0,0,0,0,0,0})", "{1,2,3,90,0,25}");
        check("align({1,2,3,20,0,0},{0,0,0,30,0,0})", "{1,2,3,30,0,0}");
    }
}
