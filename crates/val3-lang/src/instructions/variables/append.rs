//! `append` (2.5.5): appends an element to a one-dimensional array.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::View;

instruction! {
    /// Adds one value at the end of a one-dimensional array.
    ///
    /// - `variable`: the array, without an index. Local variables and arrays of two or three dimensions are not
    ///   supported.
    /// - The new value has the default of its type; the size grows by one.
    /// - Errors: 40 without memory or above 9999 values (up to s7), 70 for a variable that is not supported.
    ///
    /// The time that allocating memory takes is not bounded, so do not append values in a loop that must be fast.
    ///
    /// ## Example
    /// ```val3
    /// string sNames[1]
    ///   append(sNames)
    ///   sNames[size(sNames)-1]="bolt"
    /// ```
    "append": Variables "2.5.5", errors [40, 70];
    modifier (Whole variable) = append;
}

fn append(call: &mut Call<'_>, variable: View) -> Result<()> {
    call.memory.append(variable.store, call.version.container_limit())
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;
    use crate::versions::Version;

    #[test]
    fn adds_a_default_at_the_end() {
        let mut bench = Bench::default().global("num nRow[2]").with("nRow", &[1.0, 2.0]).part("x_nRow", "nRow", 1);
        assert_eq!([bench.run("append(nRow)"), bench.show("nRow")], ["", "1, 2, 0"]);
        assert_eq!([bench.run("append(x_nRow)"), bench.show("x_nRow")], ["", "2, 0, 0"]);
    }

    #[test]
    fn neither_locals_nor_grids_nor_collections_take_it() {
        let mut bench = Bench::default().global(r#"num nGrid[2,2]; num nCount[""]"#).local("num l_nRow[2]");
        for line in ["append(nGrid)", "append(nCount)", "append(l_nRow)"] {
            assert_eq!(bench.run(line), "error 70", "{line}");
        }
    }

    #[test]
    fn version_7_holds_9999_values() {
        let mut bench = Bench::default().global("num nRow[9998]");
        assert_eq!(["append(nRow)", "append(nRow)"].map(|line| bench.run(line)), ["", "error 40"]);
        bench.version = Version::new(8, 10, 0);
        assert_eq!([bench.run("append(nRow)"), bench.run("size(nRow)")], ["", "10000"]);
    }
}
