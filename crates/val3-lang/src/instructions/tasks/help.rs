use crate::call::Call;
use crate::declare::instruction;
use crate::runtime_errors;
use crate::values::Text;
use crate::values::numbers;

instruction! {
    /// Explains a run-time error in the language of the controller.
    ///
    /// - `nErrorCode`: the number, as `taskStatus` gives it.
    /// - Result: the explanation.
    ///
    /// ## Example
    /// ```val3
    /// num nStatus
    ///   nStatus=taskStatus("robot")
    ///   if nStatus>1
    ///     popUpMsg(help(nStatus))
    ///   endIf
    /// ```
    "help": Tasks "5.10";
    function (num nErrorCode) -> string = help;
}

/// In English, the only language that the virtual controller explains errors in; empty for a number that is no error.
fn help(_: &mut Call<'_>, number: f64) -> Text {
    let number = u16::try_from(numbers::round(number) as i64).ok();
    number.and_then(runtime_errors::find).map(|error| Text::from(error.short)).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use crate::testing::check;

    #[test]
    fn explains_errors_and_nothing_else() {
        check("help(10)", "\"division by zero\"");
        check("help(250)", "\"licence missing or trial over\"");
        for state in ["help(-1)", "help(0)", "help(1)", "help(12)", "help(1e300)"] {
            check(state, "\"\"");
        }
    }

    #[test]
    fn every_explanation_fits_a_string() {
        use crate::{runtime_errors::RUNTIME_ERRORS, values::Text};
        assert!(RUNTIME_ERRORS.iter().all(|error| error.short.len() <= Text::CAPACITY));
    }
}
