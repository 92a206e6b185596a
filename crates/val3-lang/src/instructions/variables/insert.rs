//! `insert`: inserts an element into an array or a collection, or a string into a string.

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::{Fault, Result};
use crate::memory::{Slot, Subscript};
use crate::values::{Text, strings};

instruction! {
    /// Adds a value to an array or a collection, or a text to a string.
    ///
    /// With one argument it adds a value to a container. The value has the default of its type:
    ///
    /// - `variable`: an array of one dimension with an index, or a collection with a key. It must be data of the
    ///   application: local variables are not supported, and arrays of two or three dimensions need `resize`.
    /// - Array: the new value gets this index, and the values from there on move up by one. An index equal to the size
    ///   adds at the end, like `append`.
    /// - Collection: the new value gets this key.
    /// - Result: `true`. If the collection has the key already, nothing changes and the result is `false`.
    /// - Error 20 or 21: the index is above the size of the array, or below 0.
    /// - Error 40: there is not enough memory, or there would be more than 9999 values (up to s7).
    /// - Error 70: the key is `""`, or the variable is not supported.
    ///
    /// With three arguments it returns a new string, and changes none of its arguments:
    ///
    /// - `sText`: the text.
    /// - `sInsertion`: the text that is put into it, without a blank before or after it.
    /// - `nPosition`: the character before which it is put, counted from 0. Beyond the end of `sText` it is appended.
    /// - Result: the string. Text beyond 128 bytes is cut off.
    /// - Error 70: `nPosition` is negative.
    ///
    /// The time that allocating memory takes is not bounded, so do not add values in a loop that must be fast.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// num nList[3]
    /// string sPart = "bolt"
    ///   if !isDefined(nCount[sPart])
    ///     insert(nCount[sPart])
    ///   endIf
    ///   // The new value is nList[1]; the former nList[1] is nList[2] now
    ///   insert(nList[1])
    ///   // sPart is "bolts"
    ///   sPart=insert(sPart,"s",4)
    /// ```
    "insert": Variables "2.5.4, 3.4.3", errors [20, 21, 40, 70];
    modifier (Slot variable) -> bool = into_container;
    function (string sText, string sInsertion, num nPosition) -> string = into_text;
}

/// A variable without an index means its first element, before which an element is inserted.
fn into_container(call: &mut Call<'_>, variable: Slot) -> Result<bool> {
    let (view, limit) = (variable.container()?, call.version.container_limit());
    let index = match variable.at {
        Subscript::Key(key) => {
            let key = *call.memory.text(key)?;
            return call.memory.insert_key(view.store, key, limit);
        }
        Subscript::One(index) => index,
        Subscript::Whole => 0.0,
        Subscript::Two(_) | Subscript::Three(_) => return Err(Fault::INVALID_PARAMETER),
    };
    call.memory.insert_at(view, index, limit)?;
    Ok(true)
}

fn into_text(_: &mut Call<'_>, text: Text, insertion: Text, position: f64) -> Result<Text> {
    strings::insert(&text, &insertion, position)
}

#[cfg(test)]
mod tests {
    use crate::testing::{Bench, check};
    use crate::versions::Version;

    #[test]
    fn texts() {
        check(r#"insert("hello world","wild",6)"#, r#""hello wildworld""#);
        check(r#"insert("hello","!",9)"#, r#""hello!""#);
        check(r#"insert("hello","!",-1)"#, "error 70");
    }

    #[test]
    fn arrays_grow_before_an_index() {
        let mut bench = Bench::default().global("num nRow[2]").with("nRow", &[1.0, 2.0]);
        assert_eq!([bench.run("insert(nRow[1])"), bench.show("nRow")], ["true", "1, 0, 2"]);
        assert_eq!([bench.run("insert(nRow[3])"), bench.show("nRow")], ["true", "1, 0, 2, 0"]);
        assert_eq!([bench.run("insert(nRow[0])"), bench.show("nRow")], ["true", "0, 1, 0, 2, 0"]);
    }

    #[test]
    fn an_index_is_at_most_the_size() {
        let mut bench = Bench::default().global("num nRow[2]");
        assert_eq!([bench.run("insert(nRow[2.5])"), bench.run("insert(nRow[-1])")], ["error 20", "error 21"]);
        assert_eq!(bench.show("nRow"), "0, 0");
    }

    #[test]
    fn new_values_have_the_default_of_their_type() {
        let mut bench = Bench::default().global("string sNames[1]; trsf trShift[1]").with("trShift", &[1.0; 6]);
        bench.run("insert(sNames[0])");
        bench.run("insert(trShift[0])");
        assert_eq!([bench.show("sNames"), bench.show("trShift")], [r#""", """#, "{0,0,0,0,0,0}, {1,1,1,1,1,1}"]);
    }

    #[test]
    fn collections_take_a_key_once() {
        let mut bench = Bench::default().global(r#"num nCount[""]"#);
        let line = r#"insert(nCount["bolt"])"#;
        assert_eq!([bench.run(line), bench.run(line), bench.show("nCount")], ["true", "false", "bolt: 0"]);
        assert_eq!(bench.run(r#"insert(nCount[""])"#), "error 70");
    }

    #[test]
    fn a_key_that_comes_back_has_the_default() {
        let mut bench = Bench::default().global(r#"num nCount[""]"#);
        let (insert, delete) = (r#"insert(nCount["bolt"])"#, r#"delete(nCount["bolt"])"#);
        bench.run(insert);
        bench.set("nCount", &[4.0]);
        assert_eq!([bench.run(delete), bench.run(insert), bench.show("nCount")], ["true", "true", "bolt: 0"]);
    }

    #[test]
    fn neither_locals_nor_grids_grow() {
        let mut bench = Bench::default().global("num nGrid[2,2]").local("num l_nRow[2]");
        assert_eq!([bench.run("insert(nGrid[0,0])"), bench.run("insert(l_nRow[0])")], ["error 70", "error 70"]);
    }

    #[test]
    fn version_7_holds_9999_values() {
        let mut bench = Bench::default().global("num nRow[9998]");
        assert_eq!(["insert(nRow[0])", "insert(nRow[0])"].map(|line| bench.run(line)), ["true", "error 40"]);
        assert_eq!(bench.run("size(nRow)"), "9999");
        bench.version = Version::new(8, 10, 0);
        assert_eq!([bench.run("insert(nRow[0])"), bench.run("size(nRow)")], ["true", "10000"]);
    }
}
