//! V0522: a circle of fathers.

use smol_str::SmolStr;

use crate::{diagnostic::Wording, rule::rule};

rule! {
    /// A frame or tool is its own father, directly or through others.
    ///
    /// ## Why
    /// Each frame is given in its father, and the chain of fathers must end at `world`; the chain of a tool must end
    /// at `flange` (9.4, 9.5). In a circle no frame has a position, so no point in it can ever be reached.
    ///
    /// ## Bad
    /// ```val3
    /// fTray.trsf.z=50
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="fTray" access="private" xsi:type="array" type="frame" size="1">
    ///       <Value key="0" fatherId="fRow[0]" />
    ///     </Data>
    ///     <Data name="fRow" access="private" xsi:type="array" type="frame" size="1">
    ///       <Value key="0" fatherId="fTray[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// fTray.trsf.z=50
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="fTray" access="private" xsi:type="array" type="frame" size="1">
    ///       <Value key="0" fatherId="world[0]" />
    ///     </Data>
    ///     <Data name="fRow" access="private" xsi:type="array" type="frame" size="1">
    ///       <Value key="0" fatherId="fTray[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0522 "father-circle" Error
}

/// Returns the wording of the finding. The first name is repeated at the end of `chain`.
pub(crate) fn word(chain: &[SmolStr]) -> Wording {
    let names: Vec<String> = chain.iter().map(|name| format!("`{name}`")).collect();
    let message = match names.as_slice() {
        [only] | [only, _] => format!("{only} is its own father"),
        _ => format!("the fathers form a circle: {}", names.join(" -> ")),
    };
    Wording::new(message, "closes the circle", "set one of the fathers to `world[0]` (frames) or `flange[0]` (tools)")
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn a_circle_of_two_frames_is_reported() {
        expect![[r#"
            the fathers form a circle: `fTray` -> `fRow` -> `fTray`
            | closes the circle
            ? set one of the fathers to `world[0]` (frames) or `flange[0]` (tools)
        "#]]
        .assert_eq(&word(&["fTray".into(), "fRow".into(), "fTray".into()]).to_string());
    }

    #[test]
    fn a_frame_that_refers_to_itself_is_reported() {
        expect![[r#"
            `fTray` is its own father
            | closes the circle
            ? set one of the fathers to `world[0]` (frames) or `flange[0]` (tools)
        "#]]
        .assert_eq(&word(&["fTray".into(), "fTray".into()]).to_string());
    }
}
