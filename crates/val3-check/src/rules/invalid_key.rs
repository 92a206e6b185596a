//! V0514: a key that is not an index of the array.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// The key of a value is not an index of the array: a word, a negative number, or too many or too few numbers.
    ///
    /// ## Why
    /// An array has one to three dimensions, and the key holds one whole number from 0 for each, separated by commas.
    /// Only collections have words as keys. With a key that names no element the data is faulty, and the application
    /// does not load.
    ///
    /// ## Bad
    /// ```val3
    /// nGrid[1,2]=0
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nGrid" access="private" xsi:type="array" type="num" size="3 4">
    ///       <Value key="2" value="7" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// nGrid[1,2]=0
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nGrid" access="private" xsi:type="array" type="num" size="3 4">
    ///       <Value key="2,0" value="7" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0514 "invalid-key" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(key: &str, dims: usize) -> Wording {
    let (form, example, dimensions) = match dims {
        0 => return empty_key(),
        1 => ("one whole number from 0", "0", "one dimension"),
        2 => ("two whole numbers from 0, separated by a comma", "0,0", "two dimensions"),
        _ => ("three whole numbers from 0, separated by commas", "0,0,0", "three dimensions"),
    };
    Wording::new(
        format!("the key `{key}` is not an index of this array: it must be {form}"),
        format!("the array has {dimensions}"),
        format!("the first element has the key `{example}`"),
    )
}

/// Returns the wording for an empty key, the only invalid collection key (2.3.4).
fn empty_key() -> Wording {
    Wording::new("the key of a collection cannot be empty", "", "")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_key_that_is_no_number_is_reported() {
        expect![[r#"
            the key `first` is not an index of this array: it must be one whole number from 0
            | the array has one dimension
            ? the first element has the key `0`
        "#]]
        .assert_eq(&word("first", 1).to_string());
    }

    #[test]
    fn a_key_with_too_few_numbers_is_reported() {
        expect![[r#"
            the key `2` is not an index of this array: it must be two whole numbers from 0, separated by a comma
            | the array has two dimensions
            ? the first element has the key `0,0`
        "#]]
        .assert_eq(&word("2", 2).to_string());
    }

    #[test]
    fn the_message_names_the_three_dimensions() {
        expect![[r#"
            the key `1,2` is not an index of this array: it must be three whole numbers from 0, separated by commas
            | the array has three dimensions
            ? the first element has the key `0,0,0`
        "#]]
        .assert_eq(&word("1,2", 3).to_string());
    }

    #[test]
    fn an_empty_key_is_reported() {
        expect![[r#"
            the key of a collection cannot be empty
        "#]]
        .assert_eq(&word("", 0).to_string());
    }
}
