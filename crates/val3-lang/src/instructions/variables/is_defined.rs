//! `isDefined` (2.5.4): returns whether an element exists in an array or a collection, or a variable in a library.

use crate::call::Call;
use crate::declare::instruction;
use crate::memory::{Slot, Subscript};

instruction! {
    /// Returns whether a value exists in an array or a collection, or a variable in a library.
    ///
    /// - `variable`: an index or key that need not exist, or a variable of a library interface. Each index or key of a path
    ///   such as `tSlot[2].nWeight[5]` may be missing.
    /// - Result: `true` if the value exists.
    ///
    /// Use it before a key is read, inserted or deleted. On a library it shows whether the loaded library has the items
    /// of its interface (compare `libExist`).
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sPart = "bolt"
    ///   if isDefined(nCount[sPart])
    ///     putln(nCount[sPart])
    ///   endIf
    /// ```
    "isDefined": Variables "2.5.4";
    function (Item variable) -> bool = is_defined;
}

/// Whether the element or variable exists. A variable without an index or key exists even as an empty collection.
fn is_defined(call: &mut Call<'_>, variable: Slot) -> bool {
    variable.view.is_some() && (variable.at == Subscript::Whole || call.memory.locate(&variable).is_ok())
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    #[track_caller]
    fn check(bench: &mut Bench, defined: &str, expected: bool) {
        assert_eq!(bench.run(&format!("isDefined({defined})")), expected.to_string(), "{defined}");
    }

    #[test]
    fn finds_keys() {
        let mut bench = Bench::default().global("num nCount[\"\"]");
        check(&mut bench, "nCount[\"bolt\"]", false);
        check(&mut bench, "nCount", true);
        bench.run("insert(nCount[\"bolt\"])");
        check(&mut bench, "nCount[\"bolt\"]", true);
        check(&mut bench, "nCount[\"Bolt\"]", false);
        check(&mut bench, "nCount[\"\"]", false);
    }

    #[test]
    fn finds_indexes() {
        let mut bench = Bench::default().global("num nRow[3]; num nGrid[4,6]; num nCube[2,3,4]");
        for (index, expected) in [("0", true), ("2", true), ("2.49", true), ("2.5", false), ("3", false), ("-1", false)]
        {
            check(&mut bench, &format!("nRow[{index}]"), expected);
        }
        check(&mut bench, "nGrid[3,5]", true);
        check(&mut bench, "nGrid[4,0]", false);
        check(&mut bench, "nGrid[0,6]", false);
        check(&mut bench, "nCube[1,2,3]", true);
        check(&mut bench, "nCube[1,2,4]", false);
    }

    #[test]
    fn counts_from_where_a_part_begins() {
        let mut bench = Bench::default().global("num nRow[5]").part("x_nRow", "nRow", 3);
        check(&mut bench, "x_nRow[1]", true);
        check(&mut bench, "x_nRow[2]", false);
    }

    #[test]
    fn finds_data_of_a_library() {
        let mut bench = Bench::default();
        check(&mut bench, "part:sVersion", false);
        check(&mut bench, "part:sVersion[0]", false);
    }
}
