use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::View;

instruction! {
    /// Gives one dimension of an array another size.
    ///
    /// - `variable`: the array, without index. No local variable.
    /// - `nDimension`: 1, 2 or 3, the dimension that changes.
    /// - `nSize`: its new size. Values are added or dropped at the end; new ones have the default of their type.
    /// - Errors: 40 without memory or above 9999 values (up to s7), 70 for a dimension that the array does not have, a
    ///   size below 1 and what is not supported.
    ///
    /// Making room takes time that is not bounded: not for a loop that must be fast.
    ///
    /// ## Example
    /// ```val3
    /// num nGrid[4,6]
    ///   resize(nGrid,2,8)
    /// ```
    "resize": Variables "2.5.5", errors [40, 70];
    modifier (Whole variable, num nDimension, num nSize) = resize;
}

/// What a program got from an index on has the new size from there on.
fn resize(call: &mut Call<'_>, variable: View, dimension: f64, size: f64) -> Result<()> {
    call.memory.resize(variable, dimension, size, call.version.container_limit())
}

#[cfg(test)]
mod tests {
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
    fn what_is_not_possible() {
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
