//! V0523: a father that belongs to a library.

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// The father of a frame, point or tool in a data file is data of a library.
    ///
    /// ## Why
    /// `fatherId` can only name data of the same project. The library of an identifier is chosen when the application
    /// runs and may change (6.3), so a data file cannot refer to it. Program code can: `link` sets a father in a
    /// library after the library is loaded.
    ///
    /// ## Bad
    /// ```val3
    /// library cell "Disk://cell/cell.pjx"
    /// pPick.trsf.z=50
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="100" fatherId="cell:fTray[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// --- cell
    /// public frame fTray
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// library cell "Disk://cell/cell.pjx"
    /// link(pPick, cell:fTray)
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="100" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    ///
    /// --- cell
    /// public frame fTray
    /// ```
    V0523 "father-in-library" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(father: &str) -> Wording {
    Wording::new(
        format!("the father `{father}` belongs to a library"),
        "must be data of this application",
        "choose a frame or tool of this application here, and call `link` once the library is loaded",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn the_father_is_named() {
        expect![[r#"
            the father `cell:fTray[0]` belongs to a library
            | must be data of this application
            ? choose a frame or tool of this application here, and call `link` once the library is loaded
        "#]]
        .assert_eq(&word("cell:fTray[0]").to_string());
    }
}
