//! V0712: a point, frame or tool without a father.

use val3_analysis::items::fathers::without_father;

use crate::diagnostic::Wording;
use crate::lint::{DataFile, Findings};
use crate::rule::rule;

rule! {
    /// A value of a point, a frame or a tool names no father.
    ///
    /// ## Why
    /// Using it before a program links it raises run-time error 162, 163 or 164. `world` and `flange` are possible
    /// fathers. Programs may link it when they run, so the rule is off by default. A field of a user type cannot have a
    /// father and is not reported.
    ///
    /// ## Bad
    /// ```val3
    /// === main/main.pjx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Project xmlns="http://www.staubli.com/robotics/VAL3/Project/3">
    ///   <Parameters version="s7.11" stackSize="5000" millimeterUnit="true" />
    ///   <Programs />
    ///   <Database>
    ///     <Data file="main.dtx" />
    ///   </Database>
    /// </Project>
    /// === main/main.dtx
    /// <?xml version="1.0" encoding="utf-8"?>
    /// <Database xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns="http://www.staubli.com/robotics/VAL3/Data/2">
    ///   <Datas>
    ///     <Data name="pPick" access="public" xsi:type="array" type="pointRx" size="1">
    ///       <Value key="0" x="100" />
    ///     </Data>
    ///   </Datas>
    /// </Database>
    /// ```
    ///
    /// ## Good
    /// ```val3
    /// public point pPick
    /// ```
    V0712 "unlinked-data" Info off, Data: check
}

fn check(data: &DataFile<'_>, found: &mut Findings) {
    for (name, key, range) in without_father(data.view.db, data.file) {
        found.report(&RULE, range, word(&name, &key));
    }
}

fn word(name: &str, key: &str) -> Wording {
    Wording::new(
        format!("`{name}[{key}]` has no father"),
        "no father",
        "add a `fatherId` to its value, such as `world[0]` or `flange[0]`",
    )
}

#[cfg(test)]
mod tests {
    use expect_test::expect;

    use super::*;
    use crate::lint::testing::check;

    fn data(ty: &str, values: &str) -> String {
        let project = "<Project><Parameters version=\"s7.11\"/><Database><Data file=\"a.dtx\"/></Database></Project>";
        let value =
            format!("<Data name=\"xA\" access=\"public\" xsi:type=\"array\" type=\"{ty}\" size=\"2\">{values}</Data>");
        check(
            &RULE,
            &format!(
                "=== a/a.pjx\n{project}\n=== a/a.dtx\n<Database xmlns:xsi=\"y\"><Datas>\n{value}\n</Datas></Database>"
            ),
        )
    }

    #[test]
    fn the_first_value_without_father_is_reported() {
        let values = "<Value key=\"0\" fatherId=\"world[0]\"/><Value key=\"1\" fatherId=\"\"/>";
        expect![[r#"
            a.dtx:2 `xA` `xA[1]` has no father
              | no father
              ? add a `fatherId` to its value, such as `world[0]` or `flange[0]`
        "#]]
        .assert_eq(&data("pointRx", values));
        assert!(!data("tool", "<Value key=\"0\" x=\"1\"/>").is_empty());
        assert!(!data("frame", "").is_empty());
    }

    #[test]
    fn linked_values_and_other_types_are_not_reported() {
        assert_eq!(data("frame", "<Value key=\"0\" fatherId=\"world[0]\"/>"), "");
        assert_eq!(data("trsf", "<Value key=\"0\" x=\"1\"/>"), "");
    }
}
