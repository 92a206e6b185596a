//! `last` (2.5.6): returns the last key of a collection, in alphabetical order.

use std::ops::Bound;

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::View;
use crate::values::Text;

instruction! {
    /// Returns the last key of a collection, in alphabetical order.
    ///
    /// - `variable`: the collection, without key.
    /// - Result: the key; `""` if the collection is empty.
    ///
    /// `prev` returns the preceding keys.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sKey
    ///   sKey=last(nCount)
    ///   while sKey!=""
    ///     putln(sKey)
    ///     sKey=prev(nCount[sKey])
    ///   endWhile
    /// ```
    "last": Variables "2.5.6";
    function (any& variable[""]) -> string = last;
}

fn last(call: &mut Call<'_>, variable: View) -> Result<Text> {
    Ok(call.memory.key_up_to(variable.store, Bound::Unbounded)?.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    #[test]
    fn keys_are_in_the_order_of_their_characters() {
        let mut bench = Bench::default().global(r#"num nCount[""]"#);
        assert_eq!(bench.run("last(nCount)"), r#""""#);
        let mut bench = bench.with_keys("nCount", &["bolt", "nut", "Nut", "10", "9", "é"]);
        assert_eq!(bench.run("last(nCount)"), r#""é""#);
    }
}
