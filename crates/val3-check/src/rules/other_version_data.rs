//! V0541: links to inputs and outputs that another controller does not have.

use val3_analysis::items::input_links::links;
use val3_lang::io_paths::cs9_path;

use crate::diagnostic::Wording;
use crate::lint::{DataFile, Findings};
use crate::rule::rule;

rule! {
    /// A link names an input or output of a CS8, and the application is moved to a CS9.
    ///
    /// ## Why
    /// `val3 check --for s8.10` reports the changes that are required if the applications are moved to that version. A
    /// CS9 has other boards: the built-in inputs and outputs have other paths, and those of a `BasicIO` or `ModuleIO`
    /// board belong to a fieldbus. Each link that has to change is reported. Which fieldbus signal replaces it is
    /// decided by the wiring and the configuration of the new cell: no file of the old one contains it, so that `val3`
    /// does not propose one.
    ///
    /// ## Bad
    /// ```val3
    /// version s7.11
    /// dValve=true
    ///
    /// === val3.toml
    /// [lint]
    /// target-version = "s8.10"
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="dValve" access="private" xsi:type="array" type="dio" size="1">
    ///       <Value key="0" link="valve1" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// version s7.11
    /// dValve=true
    ///
    /// === val3.toml
    /// [lint]
    /// target-version = "s8.10"
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="dValve" access="private" xsi:type="array" type="dio" size="1">
    ///       <Value key="0" link="ValveIO\valve1" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0541 "other-version-data" Warning, Data: check
}

/// First number of CS9 versions.
const CS9: u8 = 8;

fn check(data: &DataFile<'_>, found: &mut Findings) {
    let Some(target) = data.view.options.target_version.filter(|target| target.language() >= CS9) else { return };
    if data.view.items.version.language() >= CS9 {
        return;
    }
    for link in links(data.view.db, data.file) {
        if let Some(path) = cs9_path(&link.text) {
            found.report(&RULE, link.range, word(&link.text, path.as_deref(), &target.to_string()));
        }
    }
}

fn word(link: &str, path: Option<&str>, target: &str) -> Wording {
    let advice = path.map_or_else(
        || "link it to a signal of the fieldbus of the new controller".to_owned(),
        |path| format!("on a CS9 this is `{path}`"),
    );
    Wording::new(format!("the link `{link}` is of a CS8, and {target} runs on a CS9"), "of a CS8", advice)
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn linked(version: &str, link: &str) -> String {
        let data = format!(
            "<Data name=\"dA\" access=\"private\" xsi:type=\"array\" type=\"dio\" size=\"1\"><Value key=\"0\" link=\"{link}\" /></Data>"
        );
        let settings = "=== val3.toml\n[lint]\ntarget-version = \"s8.10\"";
        check(
            &RULE,
            &format!(
                "version {version}\ndA=true\n=== main/main.dtx\n<Database><Datas>{data}</Datas></Database>\n{settings}"
            ),
        )
    }

    #[test]
    fn links_of_a_cs8_are_reported() {
        expect![[r#"
            main.dtx:1 `fOut0` the link `fOut0` is of a CS8, and s8.10 runs on a CS9
              | of a CS8
              ? on a CS9 this is `FastIO\fOut0`
        "#]]
        .assert_eq(&linked("s7.11", r"fOut0"));
        expect![[r#"
            main.dtx:1 `BasicIO-1\%Q0` the link `BasicIO-1\%Q0` is of a CS8, and s8.10 runs on a CS9
              | of a CS8
              ? link it to a signal of the fieldbus of the new controller
        "#]]
        .assert_eq(&linked("s7.11", r"BasicIO-1\%Q0"));
    }

    #[test]
    fn other_links_are_not_reported() {
        assert_eq!(linked("s7.11", r"FastIO\fOut0"), "");
        assert_eq!(linked("s7.11", r"Socket\host"), "");
        assert_eq!(linked("s8.3", r"fOut0"), "");
    }
}
