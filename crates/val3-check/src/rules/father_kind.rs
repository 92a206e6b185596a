//! V0521: a father of the wrong kind.

use crate::{diagnostic::Wording, english::count, rule::rule};

rule! {
    /// The father of a frame or point is not a frame, or the father of a tool is not a tool.
    ///
    /// ## Why
    /// A frame or a point is defined in a reference frame (9.4, 9.6), a tool relative to a base tool (9.5). The
    /// controller rejects a link to data of another type.
    ///
    /// ## Bad
    /// ```val3
    /// pPick.trsf.z=50
    ///
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="tGrip" access="private" xsi:type="array" type="tool" size="1">
    ///       <Value key="0" fatherId="flange[0]" />
    ///     </Data>
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="100" fatherId="tGrip[0]" />
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
    ///     <Data name="tGrip" access="private" xsi:type="array" type="tool" size="1">
    ///       <Value key="0" fatherId="flange[0]" />
    ///     </Data>
    ///     <Data name="pPick" access="private" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="100" fatherId="world[0]" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    V0521 "father-kind" Error
}

/// Returns the wording of the finding.
pub(crate) fn word(father: &str, expected: &str, found: &str) -> Wording {
    let help = match expected {
        "frame" => "the father at the root of all frames is `world[0]`",
        "tool" => "the father at the root of all tools is `flange[0]`",
        _ => "",
    };
    Wording::new(
        format!("the father must be of type `{expected}`, but `{father}` is of type `{found}`"),
        format!("of type `{found}`"),
        help,
    )
}

/// Returns the wording of the finding about data with the name of `world` or `flange`.
pub(crate) fn hidden(name: &str, expected: &str, found: &str, uses: usize) -> Wording {
    let uses = count(uses, "value");
    Wording::new(
        format!("`{name}` of type `{found}` replaces the built-in {expected} `{name}`, the father of {uses}"),
        format!("of type `{found}`"),
        "rename this data",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;

    #[test]
    fn data_called_world_hide_the_built_in_frame() {
        expect![[r#"
            `world` of type `num` replaces the built-in frame `world`, the father of 3 values
            | of type `num`
            ? rename this data
        "#]]
        .assert_eq(&hidden("world", "frame", "num", 3).to_string());
    }

    #[test]
    fn a_tool_as_father_of_a_frame_is_reported() {
        expect![[r#"
            the father must be of type `frame`, but `tGrip[0]` is of type `tool`
            | of type `tool`
            ? the father at the root of all frames is `world[0]`
        "#]]
        .assert_eq(&word("tGrip[0]", "frame", "tool").to_string());
    }

    #[test]
    fn a_frame_as_father_of_a_tool_is_reported() {
        expect![[r#"
            the father must be of type `tool`, but `world[0]` is of type `frame`
            | of type `frame`
            ? the father at the root of all tools is `flange[0]`
        "#]]
        .assert_eq(&word("world[0]", "tool", "frame").to_string());
    }
}
