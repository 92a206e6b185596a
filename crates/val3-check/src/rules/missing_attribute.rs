//! V0505: an element without a required attribute.

use crate::{
    diagnostic::{Fix, Wording},
    fix::{Site, rename},
    rule::rule,
};

rule! {
    /// A required attribute of an element is missing.
    ///
    /// ## Why
    /// The attributes are the content of a declaration: without `name` a variable has no name, without `file` an entry
    /// of the project names no file. The controller reports the file as faulty and does not load the application.
    ///
    /// Without `size`, `access` or the kind of container a variable differs from its use in the code. This is a
    /// warning: the controller and all known tools write these attributes, and no source describes how a controller
    /// treats a file without them. No other finding about such a variable is reported.
    ///
    /// ## Bad
    /// ```val3
    /// putln("ready")
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="nCount" access="private" xsi:type="array" size="1" />
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
    ///     <Data name="nCount" access="private" xsi:type="array" type="num" size="1" />
    ///   </Datas>
    /// </Database>
    /// ```
    V0505 "missing-attribute" Error
}

/// Returns the wording of the finding. `written` is the unknown attribute that is probably a misspelling.
pub(crate) fn word(element: &str, attribute: &str, default: Option<&str>, written: Option<&str>) -> Wording {
    let label = match default {
        Some(default) => format!("`{attribute}` is missing: `{default}` is assumed"),
        None => format!("`{attribute}` is missing"),
    };
    let help = written.map(|written| format!("did you mean `{attribute}` where `{written}` is written?"));
    Wording::new(format!("the element `{element}` needs the attribute `{attribute}`"), label, help.unwrap_or_default())
}

/// Renames the unknown attribute that is probably a misspelling.
pub(crate) fn fix(site: &Site<'_>, attribute: &str, written: Option<&str>) -> Option<Fix> {
    rename(site, written?, Some(attribute))
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_attribute_is_named() {
        expect![[r#"
            the element `Data` needs the attribute `type`
            | `type` is missing
        "#]]
        .assert_eq(&word("Data", "type", None, None).to_string());
    }

    #[test]
    fn the_default_is_shown() {
        expect![[r#"
            the element `Data` needs the attribute `size`
            | `size` is missing: `1` is assumed
            ? did you mean `size` where `szie` is written?
        "#]]
        .assert_eq(&word("Data", "size", Some("1"), Some("szie")).to_string());
    }
}
