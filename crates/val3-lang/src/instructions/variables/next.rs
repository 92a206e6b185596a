//! `next` (2.5.6): returns the key after a key in a collection, in alphabetical order.

use std::ops::Bound;

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::{Fault, Result};
use crate::memory::{Slot, Subscript};
use crate::values::Text;

instruction! {
    /// Returns the key that follows another key in a collection, in alphabetical order.
    ///
    /// - `variable`: the collection with the key at which to start.
    /// - Result: the following key; `""` after the last one.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sKey
    ///   sKey=first(nCount)
    ///   if sKey!=""
    ///     putln(next(nCount[sKey]))
    ///   endIf
    /// ```
    "next": Variables "2.5.6";
    function (Slot variable) -> string = next;
}

/// The argument need not exist in the collection: the result is the first key after it in alphabetical order.
fn next(call: &mut Call<'_>, variable: Slot) -> Result<Text> {
    let Subscript::Key(key) = variable.at else { return Err(Fault::INVALID_PARAMETER) };
    let store = variable.container()?.store;
    Ok(call.memory.key_from(store, Bound::Excluded(call.memory.text(key)?))?.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    fn collection() -> Bench {
        let bench = Bench::default().global(r#"num nCount[""]"#);
        bench.with_keys("nCount", &["bolt", "nut", "Nut", "10", "9", "é"])
    }

    #[test]
    fn walks_from_key_to_key() {
        let mut bench = collection();
        let mut keys = vec![bench.run("first(nCount)")];
        while keys[keys.len() - 1] != r#""""# {
            keys.push(bench.run(&format!("next(nCount[{}])", keys[keys.len() - 1])));
        }
        assert_eq!(keys.join(" "), r#""10" "9" "Nut" "bolt" "nut" "é" """#);
    }

    #[test]
    fn a_key_that_is_not_there_has_neighbours() {
        let mut bench = collection();
        assert_eq!(bench.run(r#"next(nCount["c"])"#), r#""nut""#);
        bench.run(r#"delete(nCount["9"])"#);
        assert_eq!(bench.run(r#"next(nCount["9"])"#), r#""Nut""#);
    }
}
