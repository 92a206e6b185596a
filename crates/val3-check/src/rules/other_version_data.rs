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
    /// `val3 check --for s8.10` reports what has to change if the applications are moved to that version. A CS9 has other
    /// boards: the built-in inputs and outputs have other paths, and those of a `BasicIO` or `ModuleIO` board belong to a
    /// fieldbus. Each link that has to change is reported.
    ///
    /// ## Bad
    /// ```val3
    /// version s7.11
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

/// First number of the versions of a CS9.
const CS9: u8 = 8;

fn check(data: &DataFile<'_>, found: &mut Findings) {
    let Some(target) = data.view.options.target_version.filter(|target| target.language() >= CS9) else { return };
    if data.view.items.version.language() >= CS9 {
        return;
    }
    for (link, range) in links(data.view.db, data.file) {
        if let Some(path) = cs9_path(&link) {
            found.report(&RULE, range, word(&link, path.as_deref(), &target.to_string()));
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
