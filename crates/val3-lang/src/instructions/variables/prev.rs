//! `prev` (2.5.6): returns the key before a key in a collection, in alphabetical order.

use std::ops::Bound;

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::{Fault, Result};
use crate::memory::{Slot, Subscript};
use crate::values::Text;

instruction! {
    /// Returns the key that precedes another key in a collection, in alphabetical order.
    ///
    /// - `variable`: the collection with the key at which to start.
    /// - Result: the preceding key; `""` before the first one.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sKey
    ///   sKey=last(nCount)
    ///   if sKey!=""
    ///     putln(prev(nCount[sKey]))
    ///   endIf
    /// ```
    "prev": Variables "2.5.6";
    function (Slot variable) -> string = prev;
}

/// The argument need not exist in the collection: the result is the last key before it in alphabetical order.
fn prev(call: &mut Call<'_>, variable: Slot) -> Result<Text> {
    let Subscript::Key(key) = variable.at else { return Err(Fault::INVALID_PARAMETER) };
    let store = variable.container()?.store;
    Ok(call.memory.key_up_to(store, Bound::Excluded(call.memory.text(key)?))?.unwrap_or_default())
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
        let mut keys = vec![bench.run("last(nCount)")];
        while keys[keys.len() - 1] != r#""""# {
            keys.push(bench.run(&format!("prev(nCount[{}])", keys[keys.len() - 1])));
        }
        assert_eq!(keys.join(" "), r#""é" "nut" "bolt" "Nut" "9" "10" """#);
    }

    #[test]
    fn a_key_that_is_not_there_has_neighbours() {
        let mut bench = collection();
        assert_eq!(bench.run(r#"prev(nCount["c"])"#), r#""bolt""#);
        bench.run(r#"delete(nCount["9"])"#);
        assert_eq!(bench.run(r#"prev(nCount["9"])"#), r#""10""#);
    }
}
