//! V0520: a father that does not exist.

use val3_lang::data_path::DataPath;

use crate::{
    diagnostic::{Fix, Wording},
    fix::{Site, rename},
    phrase::did_you_mean_or,
    rule::rule,
};

rule! {
    /// The father of a frame, point or tool does not exist in the application.
    ///
    /// ## Why
    /// `fatherId` names the reference frame of a frame or point (9.4, 9.6) or the base tool of a tool (9.5). The chain
    /// of fathers of every frame ends at `world`, that of every tool at `flange`. Without its father the position of
    /// the data is unknown, and the controller reports missing linked data when it loads the application.
    ///
    /// ## Bad
    /// ```val3
    /// pPick.trsf.z=50
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="fTray" access="private" xsi:type="array" type="frame" size="1">
    ///       <Value key="0" fatherId="world[0]" />
    ///     </Data>
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="100" fatherId="fTrya[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// pPick.trsf.z=50
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="fTray" access="private" xsi:type="array" type="frame" size="1">
    ///       <Value key="0" fatherId="world[0]" />
    ///     </Data>
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="100" fatherId="fTray[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0520 "father-missing" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(father: &str, near: Option<&str>) -> Wording {
    Wording::new(
        format!("the father `{father}` does not exist"),
        "no such frame or tool in this application",
        did_you_mean_or(near, "the father of a frame or point may be `world[0]`, that of a tool `flange[0]`"),
    )
}

/// Replaces the name by the similar name and keeps the index.
pub(crate) fn fix(site: &Site<'_>, father: &str, near: Option<&str>) -> Option<Fix> {
    let name = DataPath::new(father).before_index();
    // The similar name belongs to one part of a longer reference, and the fault does not include which one.
    let is_one_step = !father.contains('.');
    is_one_step.then(|| rename(site, name, near)).flatten()
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_help_proposes_a_similar_name() {
        expect![[r#"
            the father `fTrya[0]` does not exist
            | no such frame or tool in this application
            ? did you mean `fTray`?
        "#]]
        .assert_eq(&word("fTrya[0]", Some("fTray")).to_string());
    }

    #[test]
    fn the_help_is_empty_without_a_similar_name() {
        expect![[r#"
            the father `fOld[0]` does not exist
            | no such frame or tool in this application
            ? the father of a frame or point may be `world[0]`, that of a tool `flange[0]`
        "#]]
        .assert_eq(&word("fOld[0]", None).to_string());
    }
}
