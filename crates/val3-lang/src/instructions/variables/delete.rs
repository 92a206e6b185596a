//! `delete`: removes an element from an array or a collection, or characters from a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::{Fault, Result};
use crate::memory::{Slot, Subscript};
use crate::values::{Text, strings};

instruction! {
    /// Removes a value from an array or a collection, or characters from a string.
    ///
    /// With one argument it removes a value from a container:
    ///
    /// - `variable`: the index or key to remove. The following values of an array move up. Local variables and arrays
    ///   of two or three dimensions are not supported.
    /// - Result: `true` if the value was removed.
    /// - Errors: 20 and 21 for an index or key that does not exist, 70 for the last value of an array, which has at
    ///   least one value (a collection may become empty), and for a variable that is not supported.
    ///
    /// With three arguments it returns a new string; as a statement it has no effect:
    ///
    /// - `sText`, `nSize`, `nPosition`: the string, the number of characters to remove, and the first of them, counted
    ///   from 0; beyond the end nothing is removed.
    /// - Error 70: `nSize` or `nPosition` is negative.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sPart = "bolts"
    ///   if isDefined(nCount[sPart])
    ///     delete(nCount[sPart])
    ///   endIf
    ///   sPart=delete(sPart,1,4)
    /// ```
    "delete": Variables "2.5.4, 3.4.3", errors [20, 21, 70];
    modifier (Slot variable) -> bool = from_container;
    function (string sText, num nSize, num nPosition) -> string = from_text;
}

/// A variable without an index means its first element.
fn from_container(call: &mut Call<'_>, variable: Slot) -> Result<bool> {
    let view = variable.container()?;
    match variable.at {
        Subscript::Key(key) => {
            let key = *call.memory.text(key)?;
            call.memory.delete_key(view.store, &key)?;
        }
        Subscript::One(index) => call.memory.delete_at(view, index)?,
        Subscript::Whole => call.memory.delete_at(view, 0.0)?,
        Subscript::Two(_) | Subscript::Three(_) => return Err(Fault::INVALID_PARAMETER),
    }
    Ok(true)
}

fn from_text(_: &mut Call<'_>, text: Text, size: f64, position: f64) -> Result<Text> {
    strings::delete(&text, size, position)
}

#[cfg(test)]
mod tests {
    use crate::testing::{Bench, check};

    #[test]
    fn texts() {
        check(r#"delete("hello wild world",5,6)"#, r#""hello world""#);
        check(r#"delete("hello",2,9)"#, r#""hello""#);
        check(r#"delete("hello",-1,0)"#, "error 70");
        check(r#"delete("hello",1,-1)"#, "error 70");
    }

    #[test]
    fn arrays_close_up() {
        let mut bench = Bench::default().global("num nRow[3]").with("nRow", &[1.0, 2.0, 3.0]);
        assert_eq!([bench.run("delete(nRow[1])"), bench.show("nRow")], ["true", "1, 3"]);
        assert_eq!([bench.run("delete(nRow[2])"), bench.run("delete(nRow[-1])")], ["error 20", "error 21"]);
        assert_eq!([bench.run("delete(nRow[0])"), bench.show("nRow")], ["true", "3"]);
    }

    #[test]
    fn an_array_keeps_one_value_and_a_collection_none() {
        let mut bench = Bench::default().global(r#"num nRow[1]; num nCount[""]"#);
        bench.run(r#"insert(nCount["bolt"])"#);
        assert_eq!([bench.run("delete(nRow[0])"), bench.run("size(nRow)")], ["error 70", "1"]);
        assert_eq!([bench.run(r#"delete(nCount["bolt"])"#), bench.run("size(nCount)")], ["true", "0"]);
        assert_eq!(bench.run(r#"delete(nCount["bolt"])"#), "error 20");
    }

    #[test]
    fn the_other_keys_keep_their_values() {
        let bench = Bench::default().global(r#"num nCount[""]"#).with_keys("nCount", &["a", "b", "c"]);
        let mut bench = bench.with("nCount", &[1.0, 2.0, 3.0]);
        bench.run(r#"delete(nCount["a"])"#);
        assert_eq!(bench.show("nCount"), "b: 2, c: 3");
        bench.run(r#"insert(nCount["d"])"#);
        assert_eq!(bench.show("nCount"), "b: 2, c: 3, d: 0");
    }

    #[test]
    fn neither_locals_nor_grids_shrink() {
        let mut bench = Bench::default().global("num nGrid[2,2]").local("num l_nRow[2]");
        assert_eq!([bench.run("delete(nGrid[0,0])"), bench.run("delete(l_nRow[0])")], ["error 70", "error 70"]);
    }
}
