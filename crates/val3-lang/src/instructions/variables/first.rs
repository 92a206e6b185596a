//! `first` (2.5.6): returns the first key of a collection, in alphabetical order.

use std::ops::Bound;

use crate::call::Call;
use crate::declare::instruction;
use crate::fault::Result;
use crate::memory::View;
use crate::values::Text;

instruction! {
    /// Returns the first key of a collection, in alphabetical order.
    ///
    /// - `variable`: the collection, without key.
    /// - Result: the key; `""` if the collection is empty.
    ///
    /// `next` returns the following keys.
    ///
    /// ## Example
    /// ```val3
    /// num nCount[""]
    /// string sKey
    ///   sKey=first(nCount)
    ///   while sKey!=""
    ///     putln(sKey)
    ///     sKey=next(nCount[sKey])
    ///   endWhile
    /// ```
    "first": Variables "2.5.6";
    function (any& variable[""]) -> string = first;
}

fn first(call: &mut Call<'_>, variable: View) -> Result<Text> {
    Ok(call.memory.key_from(variable.store, Bound::Unbounded)?.unwrap_or_default())
}

#[cfg(test)]
mod tests {
    use crate::testing::Bench;

    #[test]
    fn keys_are_in_the_order_of_their_characters() {
        let mut bench = Bench::default().global(r#"num nCount[""]"#);
        assert_eq!(bench.run("first(nCount)"), r#""""#);
        let mut bench = bench.with_keys("nCount", &["bolt", "nut", "Nut", "10", "9", "é"]);
        assert_eq!(bench.run("first(nCount)"), r#""10""#);
    }
}
