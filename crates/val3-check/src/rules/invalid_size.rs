//! V0517: a size that is not a list of one to three numbers.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// The `size` of an array is not a list of one to three whole numbers.
    ///
    /// ## Why
    /// An array has one, two or three dimensions (2.3.4). In a file their sizes are separated by blanks, while the
    /// indexes of a key are separated by commas. If the size cannot be read, the variable cannot be created, and the
    /// application does not load.
    ///
    /// ## Bad
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nGrid" access="private" xsi:type="array" type="num" size="3,4" />
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nGrid" access="private" xsi:type="array" type="num" size="3 4" />
    ///   </Datas>
    /// </Database>
    /// ```
    V0517 "invalid-size" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(size: &str) -> Wording {
    let dims: Vec<&str> = size.split_whitespace().collect();
    if !dims.is_empty() && dims.len() <= 3 && dims.iter().all(|dim| is_whole(dim)) {
        return out_of_range(size, &dims);
    }
    Wording::new(
        format!("the size `{size}` is not a list of one to three whole numbers separated by blanks"),
        "one number for each dimension",
        proposal(size),
    )
}

fn is_whole(dim: &str) -> bool {
    dim.bytes().all(|byte| byte.is_ascii_digit())
}

/// Wording for a readable size with a number that no dimension can have.
fn out_of_range(size: &str, dims: &[&str]) -> Wording {
    if dims.iter().any(|dim| dim.parse::<u32>() == Ok(0)) {
        return Wording::new(
            format!("an array cannot have the size `{size}`: it always has an element"),
            "at least 1 in each dimension",
            "write the number of elements, or use a collection, which may be empty",
        );
    }
    Wording::new(
        format!("the size `{size}` is larger than an array can be"),
        "too large",
        "write the number of elements",
    )
}

/// Size that was probably intended.
fn proposal(size: &str) -> String {
    let with_blanks = size.replace([',', ';', 'x', '*'], " ");
    let dims: Vec<&str> = with_blanks.split_whitespace().collect();
    let readable = (1..=3).contains(&dims.len()) && dims.iter().all(|dim| dim.parse::<u32>().is_ok_and(|dim| dim > 0));
    if readable { format!("write `size=\"{}\"`", dims.join(" ")) } else { String::new() }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn commas_are_reported_with_a_proposal() {
        expect![[r#"
            the size `3,4` is not a list of one to three whole numbers separated by blanks
            | one number for each dimension
            ? write `size="3 4"`
        "#]]
        .assert_eq(&word("3,4").to_string());
    }

    #[test]
    fn an_empty_array_is_reported() {
        expect![[r#"
            an array cannot have the size `3 0`: it always has an element
            | at least 1 in each dimension
            ? write the number of elements, or use a collection, which may be empty
        "#]]
        .assert_eq(&word("3 0").to_string());
        assert_eq!(word("3,0").help, "");
    }

    #[test]
    fn a_size_beyond_every_array_is_reported() {
        expect![[r#"
            the size `99999999999` is larger than an array can be
            | too large
            ? write the number of elements
        "#]]
        .assert_eq(&word("99999999999").to_string());
    }

    #[test]
    fn a_size_that_is_no_number_is_reported() {
        expect![[r#"
            the size `many` is not a list of one to three whole numbers separated by blanks
            | one number for each dimension
        "#]]
        .assert_eq(&word("many").to_string());
    }
}
