//! V0510: an initial value that is invalid for its type.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A data file contains an initial value that is invalid for the variable's type.
    ///
    /// ## Why
    /// The initial values of a data file are read when the application is loaded. A `bool` is `true` or `false`, a
    /// number has a decimal point, and the attributes of a configuration or a blend have fixed words. With any other
    /// text the data is faulty and the application does not load.
    ///
    /// ## Bad
    /// ```val3
    /// nSpeed=nSpeed*2
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nSpeed" access="private" xsi:type="array" type="num" size="1">
    ///       <Value key="0" value="12,5" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// nSpeed=nSpeed*2
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nSpeed" access="private" xsi:type="array" type="num" size="1">
    ///       <Value key="0" value="12.5" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0510 "invalid-value" Error
}

/// Returns the wording of the finding. `expected` is read after "must be".
pub(crate) fn word(ty: &str, attribute: &str, value: &str, expected: &str) -> Wording {
    Wording::new(
        format!("`{attribute}` of type `{ty}` is `{value}`, but must be {expected}"),
        format!("must be {expected}"),
        decimal_comma(value),
    )
}

/// Suggests a decimal point for a number that is written with a comma.
fn decimal_comma(value: &str) -> String {
    let point = value.replacen(',', ".", 1);
    match point.parse::<f64>() {
        Ok(_) if point != value => format!("the decimal sign is a point: `{point}`"),
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_wrong_bool_is_reported() {
        expect![[r#"
            `value` of type `bool` is `yes`, but must be `true` or `false`
            | must be `true` or `false`
        "#]]
        .assert_eq(&word("bool", "value", "yes", "`true` or `false`").to_string());
    }

    #[test]
    fn a_decimal_comma_is_reported_with_a_proposal() {
        expect![[r#"
            `value` of type `num` is `12,5`, but must be a number
            | must be a number
            ? the decimal sign is a point: `12.5`
        "#]]
        .assert_eq(&word("num", "value", "12,5", "a number").to_string());
    }
}
