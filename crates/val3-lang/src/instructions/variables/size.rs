//! `size`: returns the number of elements in a variable.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::View;

instruction! {
    /// Returns the number of values in a variable.
    ///
    /// - `variable`: a whole array or collection, without index or key. A one-dimensional array may have an index: then
    ///   the part from that index on is counted.
    /// - `nDimension`: 1, 2 or 3, the requested dimension of an array; 1 by default.
    /// - Result: the number of values; 1 for an element, 0 for a dimension that the array does not have.
    ///
    /// For a one-dimensional array that a program received by reference, only the passed part is counted.
    ///
    /// ## Example
    /// ```val3
    /// num nGrid[4,6]
    /// string sNames[3]
    ///   put(size(sNames))
    ///   putln(size(nGrid,2))
    /// ```
    "size": Variables "2.5.4, 2.5.5";
    function (Whole variable) -> num = size;
    function (Whole variable, num nDimension) -> num = size_of_dimension;
}

fn size(call: &mut Call<'_>, variable: View) -> Result<f64> {
    size_of_dimension(call, variable, 1.0)
}

/// A collection has one dimension, like a one-dimensional array. Numbers below 1 are no valid dimension.
fn size_of_dimension(call: &mut Call<'_>, variable: View, dimension: f64) -> Result<f64> {
    call.memory.dimension(variable, dimension).map(f64::from)
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    #[test]
    fn counts_values() {
        let mut bench = Bench::default().global("num nValue; string sNames[3]; num nGrid[4,6]; num nCube[2,3,5]");
        assert_eq!(["size(nValue)", "size(sNames)", "size(sNames,1)"].map(|line| bench.run(line)), ["1", "3", "3"]);
        assert_eq!(["size(nGrid)", "size(nGrid,1)", "size(nGrid,2)"].map(|line| bench.run(line)), ["4", "4", "6"]);
        assert_eq!(["size(nCube,2)", "size(nCube,3)"].map(|line| bench.run(line)), ["3", "5"]);
    }

    #[test]
    fn a_missing_dimension_has_no_size() {
        let mut bench = Bench::default().global("num nGrid[4,6]; string sNames[3]");
        for line in ["size(nGrid,3)", "size(nGrid,0)", "size(nGrid,-1)", "size(sNames,2)"] {
            assert_eq!(bench.run(line), "0", "{line}");
        }
    }

    #[test]
    fn counts_the_keys_of_a_collection() {
        let mut bench = Bench::default().global("num nCount[\"\"]");
        assert_eq!(bench.run("size(nCount)"), "0");
        bench.run("insert(nCount[\"bolt\"])");
        assert_eq!([bench.run("size(nCount)"), bench.run("size(nCount,2)")], ["1", "0"]);
    }

    #[test]
    fn from_an_index_on_less_can_be_reached() {
        let mut bench = Bench::default().global("num nValue[10]").part("x_nValue", "nValue", 4);
        assert_eq!(
            ["size(nValue[3])", "size(x_nValue)", "size(x_nValue[2])"].map(|line| bench.run(line)),
            ["7", "6", "4"]
        );
    }
}
