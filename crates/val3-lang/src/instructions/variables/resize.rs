//! `resize` (2.5.5): changes the size of one array dimension.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::View;

instruction! {
    /// Changes the size of one array dimension.
    ///
    /// The other dimensions keep their sizes, and each value that remains keeps its index. New values are added at the
    /// end of the dimension, with the default of their type. Values beyond the new size are lost.
    ///
    /// - `variable`: an array of one, two or three dimensions, written without an index. It must be data of the
    ///   application: local variables and collections cannot be resized.
    /// - `nDimension`: the dimension that changes, counted from 1.
    /// - `nSize`: the new size of this dimension, at least 1. An array always has at least one value.
    /// - Error 40: there is not enough memory, or the array would have more than 9999 values (up to s7).
    /// - Error 70: the array has no such dimension, `nSize` is below 1, or the variable cannot be resized.
    ///
    /// For arrays of one dimension, `append`, `insert` and `delete` change the size by one value. `size` returns the
    /// size. The time that allocating memory takes is not bounded, so do not resize in a loop that must be fast.
    ///
    /// ## Example
    /// ```val3
    /// num nGrid[4,6]
    ///   // 4 x 8 values: those with a second index of 6 and 7 are new, and 0
    ///   resize(nGrid,2,8)
    ///   putln(size(nGrid,2))
    /// ```
    "resize": Variables "2.5.5", errors [40, 70];
    modifier (Whole variable, num nDimension, num nSize) = resize;
}

/// If a program received the array from an index on, the new size counts from that index.
fn resize(call: &mut Call<'_>, variable: View, dimension: f64, size: f64) -> Result<()> {
    call.memory.resize(variable, dimension, size, call.version.container_limit())
}

#[cfg(test)]
mod tests {
    use crate::arguments::range;
    use crate::testing::Bench;
    use crate::versions::Version;

    #[test]
    fn values_keep_their_indexes() {
        let mut bench = Bench::default().global("num nGrid[2,3]").with("nGrid", &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
        assert_eq!([bench.run("resize(nGrid,2,4)"), bench.show("nGrid")], ["", "1, 2, 3, 0, 4, 5, 6, 0"]);
        assert_eq!([bench.run("resize(nGrid,1,1)"), bench.show("nGrid")], ["", "1, 2, 3, 0"]);
        assert_eq!([bench.run("resize(nGrid,2,2)"), bench.show("nGrid")], ["", "1, 2"]);
    }

    #[test]
    fn the_range_of_the_size_is_that_of_the_check() {
        let range = range("resize", "nSize").unwrap();
        for size in [-1.0, 0.0, 0.4, 0.5, 0.7, 1.0, 2.0] {
            let mut bench = Bench::default().global("num nRow[2]");
            assert_eq!(bench.run(&format!("resize(nRow,1,{size})")).is_empty(), range.takes(size), "{size}");
        }
    }

    #[test]
    fn arrays_of_three_dimensions_change_too() {
        let numbers: Vec<f64> = (1..=8).map(f64::from).collect();
        let mut bench = Bench::default().global("num nCube[2,2,2]").with("nCube", &numbers);
        assert_eq!([bench.run("resize(nCube,2,1)"), bench.show("nCube")], ["", "1, 2, 5, 6"]);
        assert_eq!([bench.run("resize(nCube,3,1)"), bench.show("nCube")], ["", "1, 5"]);
    }

    #[test]
    fn a_part_gets_the_size_that_it_shows() {
        let mut bench = Bench::default().global("num nRow[5]").part("x_nRow", "nRow", 2);
        bench.run("resize(x_nRow,1,2)");
        assert_eq!([bench.run("size(x_nRow)"), bench.run("size(nRow)")], ["2", "4"]);
    }

    #[test]
    fn impossible_sizes_are_errors() {
        let mut bench = Bench::default().global(r#"num nRow[2]; num nCount[""]"#).local("num l_nRow[2]");
        for line in ["resize(nRow,1,0)", "resize(nRow,1,-1)", "resize(nRow,2,3)", "resize(nRow,0,3)"] {
            assert_eq!(bench.run(line), "error 70", "{line}");
        }
        assert_eq!([bench.run("resize(nCount,1,3)"), bench.run("resize(l_nRow,1,3)")], ["error 70", "error 70"]);
        assert_eq!(bench.show("nRow"), "0, 0");
    }

    #[test]
    fn version_7_holds_9999_values() {
        let mut bench = Bench::default().global("num nGrid[1,1]; string sRow[1]");
        assert_eq!([bench.run("resize(nGrid,2,9999)"), bench.run("resize(nGrid,1,2)")], ["", "error 40"]);
        assert_eq!(bench.run("resize(sRow,1,1e300)"), "error 40");
        bench.version = Version::new(8, 10, 0);
        assert_eq!([bench.run("resize(nGrid,1,2)"), bench.run("resize(nGrid,1,1e300)")], ["", "error 40"]);
        assert_eq!(bench.run("resize(sRow,1,10000000)"), "error 40");
    }
}
