//! Wording of faults in JSON files that a command has written.

use serde_json::error::Category;

/// Formats what is wrong with a line of a JSON file, which the user did not write and therefore cannot repair.
pub fn json_fault(error: &serde_json::Error, line: usize) -> String {
    // An error without a place is of the command's own form, such as an unknown version number.
    if error.line() == 0 {
        return error.to_string();
    }
    let fault = match error.classify() {
        Category::Eof => "is cut off",
        Category::Io | Category::Syntax => "is not JSON",
        Category::Data => "is JSON with other content",
    };
    format!("line {line} {fault}")
}

#[cfg(test)]
mod tests {
    use super::json_fault;

    #[test]
    fn the_fault_is_named_without_the_words_of_the_parser() {
        for (text, fault) in [
            ("[1,", "line 7 is cut off"),
            ("[1,,2]", "line 7 is not JSON"),
            ("[1,\"a\"]", "line 7 is JSON with other content"),
        ] {
            let error = serde_json::from_str::<Vec<f64>>(text).unwrap_err();
            assert_eq!(json_fault(&error, 7), fault);
        }
        let own = serde_json::from_value::<f64>(serde_json::Value::Null).unwrap_err();
        assert_eq!(json_fault(&own, 7), own.to_string(), "without a place");
    }
}
